#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/jobs/job.h"
#include "planner/settings/settings.h"
#include "planner/swaths/guide_data.h"

#include <filesystem>
#include <memory>

namespace furrow {

/// The files that the settings name for the chosen swath method: swaths.rows and swaths.elevation. Nothing
/// where the method reads none. Errors as readRows and readElevation.
Result<std::shared_ptr<const GuideData>> readGuides(const Settings& settings, const Field& field,
                                                    const JobContext& job);

/// The lines of a vector file in any coordinate system, in its order; of a plan's GeoJSON its tramlines, or
/// its swaths where it has none. ReadFailed, InputRefused: as readVectorFile; no line in it.
Result<std::vector<Polyline>> readRows(const std::filesystem::path& path, const Field& field,
                                       const JobContext& job);

}  // namespace furrow
