// Which files and folders are task data.

#include "planner/io/formats/isoxml/isoxml.h"
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
