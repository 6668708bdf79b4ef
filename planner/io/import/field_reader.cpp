#include "planner/io/import/field_reader.h"

#include "planner/core/file_error.h"
#include "planner/io/files/chosen_file.h"
#include "planner/io/formats/registry.h"
#include "planner/io/import/track_reader.h"

namespace furrow {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kFieldStartBytes = 4096;
// A stick with its folders, a client's farms and fields.
constexpr int kDeepestField = 6;

Error noFields(const fs::path& folder) {
    return readFailed(folder.string(),
                      "this folder holds no TASKDATA.XML, no field of AgOpenGPS and no AgGPS boundary",
                      "give the folder of one of these, or a file in it");
}

}  // namespace

Result<ImportedFields> readFields(const fs::path& path, const JobContext& job) {
    const ChosenFile chosen{path, kFieldStartBytes, kDeepestField};
    if (chosen.holdsFiles() && !chosen.inside()) {
        return std::unexpected(chosen.inside().error());
    }
    const auto [format, how] = recognisedAsFields(chosen);
    if (format == nullptr) {
        return std::unexpected(noFields(path));
    }
    auto read = format->fields.read(chosen, job);
    if (!read && read.error().code == ErrorCode::ReadFailed && how == Recognition::Perhaps &&
        chosen.start()) {
        // Logs and recordings are known, too, as something else.
        if (const auto tracks = readTracks(path, job)) {
            return std::unexpected(inputRefused(
                path.filename().string(),
                message("this is the recording of a drive ({}), and no boundary", tracks->format),
                "give the field's boundary; furrow-cli compare lays a recording over a plan"));
        }
    }
    return read;
}

}  // namespace furrow
