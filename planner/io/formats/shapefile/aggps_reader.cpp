#include "planner/io/formats/shapefile/shapefile.h"

#include "planner/io/formats/vector/vector_fields.h"

#include <filesystem>
#include <utility>

namespace furrow {

namespace {

/// A boundary of an AgGPS folder with the swaths beside it; the field is called like its folder.
Result<ImportedFields> readBoundary(const FileFolder& folder, const FileFolder::Entry& boundary,
                                    const JobContext& job) {
    auto read = vectorFields(boundary.systemPath, job);
    if (!read) {
        return read;
    }
    const std::filesystem::path inner = boundary.folder;
    for (FieldContent& content : read->fields) {
        if (read->fields.size() == 1 && !inner.filename().empty()) {
            content.field.name = inner.filename().string();
        }
    }
    if (const FileFolder::Entry* swaths = folder.find(boundary.folder, "swaths.shp")) {
        auto lines = vectorLines(swaths->systemPath, job);
        if (lines) {
            read->fields.front().lines = *std::move(lines);
        } else {
            read->notes.push_back(
                {message("the swaths are left out: {}", lines.error().what), folder.placeOf(*swaths)});
        }
    }
    return read;
}

}  // namespace

Recognition recogniseAgGps(const ChosenFile& chosen) {
    const bool known =
        chosen.isFolder() && chosen.inside() && !chosen.inside()->called("boundary.shp").empty();
    return known ? Recognition::Likely : Recognition::No;
}

Result<ImportedFields> readAgGpsFields(const ChosenFile& chosen, const JobContext& job) {
    GatheredFields gathered;
    for (const FileFolder::Entry* entry : chosen.inside()->called("boundary.shp")) {
        gathered.take(readBoundary(*chosen.inside(), *entry, job), chosen.inside()->placeOf(*entry));
    }
    return std::move(gathered).result();
}

}  // namespace furrow
