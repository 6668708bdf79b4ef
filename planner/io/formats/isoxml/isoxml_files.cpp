// Which files and folders are task data.

#include "planner/core/file_error.h"
#include "planner/io/formats/isoxml/isoxml.h"
#include "planner/io/formats/isoxml/isoxml_links.h"
#include "planner/io/formats/isoxml/isoxml_reader.h"

#include <string>
#include <vector>

namespace furrow {

namespace {

std::vector<const FileFolder::Entry*> taskDataIn(const ChosenFile& chosen) {
    const bool listed = chosen.holdsFiles() && chosen.inside();
    return listed ? chosen.inside()->called("taskdata.xml") : std::vector<const FileFolder::Entry*>{};
}

/// As it is spelt in its folder.
const FileFolder::Entry* entryOf(const ChosenFile& chosen) {
    return chosen.beside()->find("", chosen.path().filename().string());
}

}  // namespace

Result<ImportedFields> readIsoxmlFolder(const FileFolder& folder, const FileFolder::Entry& main,
                                        const JobContext& job) {
    const auto text = folder.readText(main, kLargestFieldXml);
    if (!text) {
        return std::unexpected(text.error());
    }
    // All parts are taken apart at once.
    std::size_t left = kLargestFieldXml - text->size();
    const auto part = [&](const std::string& name) -> Result<std::string> {
        const FileFolder::Entry* entry = folder.find(main.folder, name + ".xml");
        if (entry == nullptr) {
            return std::unexpected(readFailed(name, "its file is missing", "copy the whole folder"));
        }
        auto read = folder.readText(*entry, left);
        left -= read ? read->size() : 0;
        return read;
    };
    auto read = readIsoxml(*text, folder.placeOf(main), part, job);
    if (const FileFolder::Entry* list = read ? folder.find(main.folder, "linklist.xml") : nullptr) {
        // What a field is known by elsewhere, kept for the next export.
        const auto links = isoxmlLinks(folder.read(*list).value_or(""));
        for (FieldContent& content : read->fields) {
            const auto link = links.find(content.field.id);
            content.field.id = link == links.end() ? content.field.id : link->second;
        }
    }
    return read;
}

Recognition recogniseIsoxml(const ChosenFile& chosen) {
    if (!taskDataIn(chosen).empty()) {
        return Recognition::Likely;
    }
    const bool says = chosen.start() && looksLikeIsoxml(*chosen.start());
    return says && (!chosen.beside() || entryOf(chosen) != nullptr) ? Recognition::Likely : Recognition::No;
}

Result<ImportedFields> readIsoxmlFields(const ChosenFile& chosen, const JobContext& job) {
    const auto taskData = taskDataIn(chosen);
    if (taskData.empty()) {
        return chosen.beside() ? readIsoxmlFolder(*chosen.beside(), *entryOf(chosen), job)
                               : std::unexpected(chosen.beside().error());
    }
    GatheredFields gathered;
    for (const FileFolder::Entry* entry : taskData) {
        gathered.take(readIsoxmlFolder(*chosen.inside(), *entry, job), chosen.inside()->placeOf(*entry));
    }
    return std::move(gathered).result();
}

Recognition recogniseTimeLogs(const ChosenFile& chosen) {
    const std::string root = chosen.xmlRoot();
    const bool isTaskData = root == "ISO11783_TaskData" || root == "TIM";
    return chosen.isDirectory() || chosen.isZip() || isTaskData ? Recognition::Likely : Recognition::No;
}

Result<TrackFile> readTimeLogs(const ChosenFile& chosen, const JobContext& job) {
    // What is in folders below that of a file belongs to others.
    const bool isFile = !chosen.isDirectory() && !chosen.isZip();
    const auto& folder = isFile ? chosen.beside() : chosen.inside();
    const std::string where = (isFile ? chosen.folderAround() : chosen.path()).string();
    return folder ? isoxmlTracks(*folder, where, job) : std::unexpected(folder.error());
}

}  // namespace furrow
