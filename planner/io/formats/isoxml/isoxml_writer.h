#pragma once

#include "planner/io/content/export_job.h"

#include <span>
#include <string>

namespace furrow {

/// The two versions of ISO 11783-10 task data that terminals read.
enum class IsoxmlVersion { V3, V4 };

/// Fields as ISOXML task data (ISO 11783-10, versions 3.3 and 4.3): the content of TASKDATA.XML.
///
/// Of each field: a boundary per part, holes as inner rings (or as areas of their own, see ExportOptions),
/// obstacles as polygons of their own, gates as points, and every guidance line in a group of its own.
/// Version 4 also holds the mainland's outline as headland polygon, and AB, A+, curve and pivot as such;
/// version 3 knows lines only: A+ becomes 100 m of line, a pivot a curve. Terminals take lines and plan
/// turns themselves; driving order and turns have no place in the format. Longitudes and latitudes have nine
/// decimals (0.1 mm).
/// With `ExportOptions::task` each field is in a planned task, too, which names its lines.
/// Cost: linear in the points. Does not fail.
std::string isoxmlText(std::span<const FieldContent> fields, IsoxmlVersion version,
                       const ExportOptions& options = {});

/// The same of a plan, in version 4.
std::string isoxmlTaskData(const Plan& plan);

}  // namespace furrow
