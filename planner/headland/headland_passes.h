#pragma once

#include "planner/headland/headland.h"

#include <string>
#include <string_view>

namespace furrow {

extern const Parameter kHeadlandDriven;
extern const Parameter kHeadlandOrder;
extern const Parameter kHeadlandWhen;
/// Whether the innermost headland pass is driven first.
bool drivesInsideOut(const Settings& settings);
/// Whether the headland is driven before the swaths.
bool drivesHeadlandFirst(const Settings& settings);
extern const Parameter kHeadlandDirection;
extern const Parameter kHeadlandCorner;
/// Choice of this setting. Only whole plans show the quickest corner; until then corners are rounded.
inline constexpr std::string_view kQuickestCorner = "quickest";
inline constexpr std::string_view kRoundedCorner = "rounded";
inline constexpr std::string_view kLoopCorner = "loop";
inline constexpr std::string_view kReverseCorner = "reverse";
/// The kind of corner that one plan is made with.
std::string plannedCorner(const Settings& settings);

/// Adds the drivable passes to a headland with known width and number of passes. Adds none if the strip is
/// only for turning. The outermost pass runs half a footprint from the boundary. Each pass inside it is one
/// operating width farther in. Passes are rounded with the machine's radius, and moved inwards where the
/// swept footprint needs it. If edges have their own headlands, passes run along those that are wide enough.
/// The headland notes the uncut area. Cost: some GEOS buffers for each pass. Cancelled.
Result<void> addPasses(Headland& headland, const HeadlandTask& task, const JobContext& job);

/// The strip that the outermost pass leaves along the boundary because the tractor is wider than the
/// implement.
Length uncutEdge(const Machine& machine);

}  // namespace furrow
