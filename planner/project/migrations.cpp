#include "planner/project/migrations.h"

#include "planner/core/file_error.h"

namespace furrow {

Result<OrderedJson> migrated(OrderedJson document, int version, std::span<const Migration> steps,
                             const std::string& origin) {
    const int newest = static_cast<int>(steps.size()) + 1;
    if (version > newest) {
        return std::unexpected(
            inputRefused(origin,
                         message("this project was saved by a newer Furrow (format {}, this one knows {})",
                                 version, newest),
                         "open it with a newer Furrow; the file was left as it is"));
    }
    if (version < 1) {
        return std::unexpected(inputRefused(origin, message("there is no project format {}", version),
                                            "restore a copy of the file"));
    }
    for (const Migration step : steps.subspan(static_cast<std::size_t>(version - 1))) {
        step(document);
    }
    return document;
}

std::span<const Migration> projectMigrations() {
    return {};
}

}  // namespace furrow
