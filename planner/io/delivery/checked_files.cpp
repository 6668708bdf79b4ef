#include "planner/io/delivery/checked_files.h"

#include "planner/io/check/export_check.h"
#include "planner/io/content/finite_numbers.h"
#include "planner/io/formats/registry.h"

#include <utility>

namespace furrow {

Result<FormatFiles> checkedFiles(const Format& format, const ExportJob& job) {
    if (const auto checked = checkNumbers(job); !checked) {
        return std::unexpected(checked.error());
    }
    auto made = format.writing.write(job);
    if (!made) {
        return made;
    }
    for (FileToWrite& file : made->files) {
        // Made once for the check and the disk.
        file.text = [bytes = file.text()] { return bytes; };
    }
    if (job.job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    made->checks = checkExport(format, job, made->files);
    return made;
}

}  // namespace furrow
