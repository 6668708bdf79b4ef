#pragma once

#include "planner/core/result.h"
#include "planner/io/content/export_job.h"

namespace furrow {

/// No file can hold a number that is none (nan) or has no end (inf), and a machine that reads one does
/// anything. InputRefused: such a number is among the places, lines and motions that
/// are to be written; says where. (Figures of summary.json that are none are null there.) Cost: linear in the
/// points.
Result<void> checkNumbers(const ExportJob& job);

}  // namespace furrow
