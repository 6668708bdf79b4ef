#include "planner/io/import/field_reader.h"

#include "planner/core/file_error.h"
#include "planner/io/files/file_folder.h"
#include "planner/io/formats/agopengps/agopengps_reader.h"
#include "planner/io/formats/isoxml/isoxml_reader.h"
#include "planner/io/formats/raster/raster_mask.h"
#include "planner/io/formats/vector/vector_fields.h"
#include "planner/io/import/track_reader.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <system_error>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;

// A stick with its folders, a client's farms and fields.
constexpr int kDeepest = 6;

constexpr std::array<std::string_view, 9> kAgOpenGpsFiles = {
    "field.txt",   "boundary.txt", "headland.txt", "headlines.txt", "tracklines.txt",
    "ablines.txt", "curvelines.txt", "recpath.txt", "flags.txt"};

void add(ImportedFields& all, ImportedFields&& more) {
    std::ranges::move(more.fields, std::back_inserter(all.fields));
    std::ranges::move(more.looseLines, std::back_inserter(all.looseLines));
    std::ranges::move(more.notes, std::back_inserter(all.notes));
}

/// Of several sources each, as long as one of them can be read; the first error where none can.
class Gathered {
public:
    void take(Result<ImportedFields>&& read, const std::string& where) {
        if (read) {
            add(all_, *std::move(read));
            any_ = true;
        } else if (first_) {
            all_.notes.push_back({message("left out: {}", read.error().what), where});
        } else {
            first_ = read.error();
            all_.notes.push_back({message("left out: {}", first_->what), where});
        }
    }
    Result<ImportedFields> result() && {
        return any_ ? Result<ImportedFields>{std::move(all_)} : std::unexpected(*first_);
    }

private:
    ImportedFields all_;
    bool any_ = false;
    std::optional<Error> first_;
};

std::vector<const FileFolder::Entry*> entriesCalled(const FileFolder& folder, std::string_view name) {
    std::vector<const FileFolder::Entry*> found;
    for (const FileFolder::Entry& entry : folder.entries()) {
        if (inSmallLetters(entry.name) == name) {
            found.push_back(&entry);
        }
    }
    return found;
}

/// Other files are called Field.txt, too.
bool holdsAgOpenGps(const FileFolder& folder) {
    return std::ranges::any_of(entriesCalled(folder, "field.txt"), [&folder](const FileFolder::Entry* entry) {
        return folder.read(*entry).value_or("").contains("StartFix");
    });
}

/// A boundary of an AgGPS folder with the swaths beside it; the field is called like its folder.
Result<ImportedFields> readAgGps(const FileFolder& folder, const FileFolder::Entry& boundary, const JobContext& job) {
    auto read = vectorFields(boundary.systemPath, job);
    if (!read) {
        return read;
    }
    const fs::path inner = boundary.folder;
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
            read->notes.push_back({message("the swaths are left out: {}", lines.error().what), folder.placeOf(*swaths)});
        }
    }
    return read;
}

/// Nothing where the folder or zip holds no format that is told by its names.
std::optional<Result<ImportedFields>> readKnownFolder(const FileFolder& folder, const fs::path& path, bool isZip,
                                                      const JobContext& job) {
    // AgOpenGPS keeps exports to ISOXML in its field's folder: the field itself comes first.
    if (holdsAgOpenGps(folder)) {
        return readAgOpenGpsFolder(folder, path.stem().string(), job);
    }
    Gathered gathered;
    const auto taskData = entriesCalled(folder, "taskdata.xml");
    for (const FileFolder::Entry* entry : taskData) {
        gathered.take(readIsoxmlFolder(folder, *entry, job), folder.placeOf(*entry));
    }
    if (!taskData.empty()) {
        return std::move(gathered).result();
    }
    const auto boundaries = entriesCalled(folder, "boundary.shp");
    if (isZip || boundaries.empty()) {
        return std::nullopt;
    }
    for (const FileFolder::Entry* entry : boundaries) {
        gathered.take(readAgGps(folder, *entry, job), folder.placeOf(*entry));
    }
    return std::move(gathered).result();
}

Result<ImportedFields> readFile(const fs::path& path, const JobContext& job) {
    const auto start = fileStart(path, 4096);
    const std::string name = inSmallLetters(path.filename().string());
    const bool known = start.has_value();
    if (known && isZip(*start) && extensionInSmallLetters(path) != ".kmz") {
        const auto folder = FileFolder::open(path, kDeepest);
        if (!folder) {
            return std::unexpected(folder.error());
        }
        if (auto read = readKnownFolder(*folder, path, true, job)) {
            return *std::move(read);
        }
    }
    if (known && looksLikeIsoxml(*start)) {
        const auto folder = FileFolder::open(fs::absolute(path).parent_path(), 0);
        if (!folder) {
            return std::unexpected(folder.error());
        }
        if (const FileFolder::Entry* entry = folder->find("", path.filename().string())) {
            return readIsoxmlFolder(*folder, *entry, job);
        }
    }
    if (known && std::ranges::contains(kAgOpenGpsFiles, name)) {
        const fs::path parent = fs::absolute(path).parent_path();
        const auto folder = FileFolder::open(parent, 0);
        if (folder && holdsAgOpenGps(*folder)) {
            return readAgOpenGpsFolder(*folder, parent.filename().string(), job);
        }
    }
    if (known && looksLikeRaster(*start)) {
        return readRasterMask(path, job);
    }
    auto read = vectorFields(path, job);
    if (!read && read.error().code == ErrorCode::ReadFailed && known) {
        // Logs and recordings are known, too, as something else.
        if (const auto tracks = readTracks(path, job)) {
            return std::unexpected(inputRefused(path.filename().string(),
                                                message("this is the recording of a drive ({}), and no boundary", tracks->format),
                                                "give the field's boundary; furrow-cli compare lays a recording over a plan"));
        }
    }
    return read;
}

}  // namespace

Result<ImportedFields> readFields(const fs::path& path, const JobContext& job) {
    std::error_code failed;
    if (!fs::is_directory(path, failed) || extensionInSmallLetters(path) == ".gdb") {
        return readFile(path, job);
    }
    const auto folder = FileFolder::open(path, kDeepest);
    if (!folder) {
        return std::unexpected(folder.error());
    }
    if (auto read = readKnownFolder(*folder, fs::absolute(path).lexically_normal(), false, job)) {
        return *std::move(read);
    }
    return std::unexpected(readFailed(path.string(),
                                      "this folder holds no TASKDATA.XML, no field of AgOpenGPS and no AgGPS boundary",
                                      "give the folder of one of these, or a file in it"));
}

}  // namespace furrow
