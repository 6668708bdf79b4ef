// Which files and folders are fields of AgOpenGPS.

#include "planner/io/formats/agopengps/agopengps.h"
#include "planner/io/formats/agopengps/agopengps_reader.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace furrow {

namespace {

constexpr std::array<std::string_view, 9> kFiles = {"field.txt",      "boundary.txt",   "headland.txt",
                                                    "headlines.txt",  "tracklines.txt", "ablines.txt",
                                                    "curvelines.txt", "recpath.txt",    "flags.txt"};

/// Other files are called Field.txt, too.
bool holdsField(const Result<FileFolder>& folder) {
    return folder &&
           std::ranges::any_of(folder->called("field.txt"), [&folder](const FileFolder::Entry* entry) {
               return folder->read(*entry).value_or("").contains("StartFix");
           });
}

}  // namespace

Recognition recogniseAgOpenGps(const ChosenFile& chosen) {
    if (chosen.holdsFiles() && holdsField(chosen.inside())) {
        return Recognition::Certain;
    }
    const bool isNamed = chosen.start() && std::ranges::contains(kFiles, chosen.name());
    return isNamed && holdsField(chosen.beside()) ? Recognition::Likely : Recognition::No;
}

Result<ImportedFields> readAgOpenGpsFields(const ChosenFile& chosen, const JobContext& job) {
    if (chosen.holdsFiles() && holdsField(chosen.inside())) {
        const auto path =
            chosen.isFolder() ? std::filesystem::absolute(chosen.path()).lexically_normal() : chosen.path();
        return readAgOpenGpsFolder(*chosen.inside(), path.stem().string(), job);
    }
    return readAgOpenGpsFolder(*chosen.beside(), chosen.folderAround().filename().string(), job);
}

}  // namespace furrow
