#pragma once

#include "planner/core/result.h"
#include "planner/io/content/export_job.h"

namespace furrow {

struct Format;

/// What a format makes of a job, checked (see checkExport). The files hold their bytes. Errors as
/// FormatWriter.
Result<FormatFiles> checkedFiles(const Format& format, const ExportJob& job);

}  // namespace furrow
