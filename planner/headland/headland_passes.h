#pragma once

#include "planner/headland/headland.h"

namespace furrow {

extern const Parameter kHeadlandDriven;
extern const Parameter kHeadlandOrder;
extern const Parameter kHeadlandWhen;
extern const Parameter kHeadlandDirection;
extern const Parameter kHeadlandCorner;
/// Its choices. Which is the quickest is seen on whole plans only; until then corners are rounded.
inline constexpr std::string_view kQuickestCorner = "quickest";
inline constexpr std::string_view kRoundedCorner = "rounded";
inline constexpr std::string_view kLoopCorner = "loop";
inline constexpr std::string_view kReverseCorner = "reverse";

/// Adds the drivable passes to a headland whose width and number of passes are known, unless the strip is kept
/// for turning only. Each runs half a footprint and one operating width more for every pass outside of it from
/// the boundary, rounded with the machine's radius, and is moved inwards where the swept footprint needs it.
/// Where edges have headlands of their own, passes go along those that are wide enough. What stays uncut is noted in the headland. Cost: some GEOS buffers for each pass.
/// Cancelled.
Result<void> addPasses(Headland& headland, const HeadlandTask& task, const JobContext& job);

/// The strip that the outermost pass leaves along the boundary because the tractor is wider than the implement.
Length uncutEdge(const Machine& machine);

}  // namespace furrow
