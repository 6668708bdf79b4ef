#pragma once

#include "planner/decomposition/decomposition.h"
#include "planner/plan/plan.h"

#include <vector>

namespace furrow {

/// A part of the mainland whose swaths were laid, and are decomposed, by themselves.
struct MainlandPart {
    MultiPolygon outline;
    std::size_t firstSwath = 0;  ///< of the set; a part's swaths follow on each other
    std::size_t swathCount = 0;
    std::optional<Angle> heading;  ///< where it is not that of the set
};

struct LaidSwaths {
    SwathSet swaths;
    std::vector<MainlandPart> parts;  ///< tile the mainland
};

/// The swaths of the chosen method with their tramlines and with ends as the settings want them, cut where
/// decomposition.split says, and in a heading of their own in cells in which that is quicker, if decomposition.heading
/// asks for it (see withOwnHeadings): parts are the pieces between split lines, and such cells. Short ones are left out.
///
/// @param plan      its request, margin and headland
/// @param workable  what the headland was laid along
/// @param drivable  where the machine may be
/// Errors: those of the method. Cancelled.
Result<LaidSwaths> layStage(const Plan& plan, const MultiPolygon& workable, const MultiPolygon& drivable,
                            const JobContext& job);

/// What of a set lies inside of a part of the mainland, in the same order and on the same tracks.
SwathSet cutTo(const SwathSet& set, const MultiPolygon& part);

/// Where the swaths of the chosen method end in a mainland, looking out of it. Errors: those of the method. Cancelled.
Result<std::vector<Pose>> swathEnds(const PlanRequest& request, const MultiPolygon& mainland, const JobContext& job);

/// The cells of all parts, as the chosen decomposition has them. Cancelled.
Result<Decomposition> cellStage(const PlanRequest& request, const LaidSwaths& laid, const JobContext& job);

}  // namespace furrow
