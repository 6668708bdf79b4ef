#pragma once

#include "planner/io/content/export_job.h"

namespace furrow {

/// What a plan says about its field in the words of machines: boundary, mainland, a guidance line for each
/// direction that is driven (the longest swath of that direction's first track; A+ and curves as such), and
/// with `headlandLines` each headland pass as a curve.
/// Cost: linear in the points of plan and field.
FieldContent contentOf(const Plan& plan, const ExportOptions& options = {});

}  // namespace furrow
