#pragma once

#include "planner/io/content/export_job.h"

namespace furrow {

/// plan.geojson; of fields alone their features, mainland and guidance lines.
FormatWriter writeGeoJson;
/// path.csv with the path of a plan; of fields alone fields.csv with the columns id, name and WKT.
FormatWriter writeCsv;

}  // namespace furrow
