#include "planner/io/import/boundary_import.h"

#include "planner/io/content/imported_fields.h"
#include "planner/io/import/field_reader.h"

namespace furrow {

Result<std::vector<FieldSource>> readBoundaries(const std::filesystem::path& path, const JobContext& job) {
    auto imported = readFields(path, job);
    return imported ? boundariesOf(*std::move(imported), path.filename().string())
                    : std::unexpected(imported.error());
}

}  // namespace furrow
