#pragma once

#include "planner/plan/stages.h"

#include <vector>

namespace furrow {

/// What the swaths of a plan are laid from.
struct LayTask {
    const PlanRequest& request;
    const Ground& ground;
    const MultiPolygon& workable;  ///< that the headland was laid along
    const MultiPolygon& mainland;
    int passes = 0;         ///< of the headland
    const SwathSet& found;  ///< of the chosen method in the mainland
};

/// Whether a machine without a headland turns on the spot, inside the field.
bool turnsOnTheSpotInside(const PlanRequest& request);

/// The swaths of the chosen method with their tramlines and with ends as the settings want them, cut where
/// decomposition.split says, and in a heading of their own in cells in which that is quicker, if
/// decomposition.heading asks for it (see withOwnHeadings): parts are the pieces between split lines, and
/// such cells. Short ones are left out. Errors: those of the method. Cancelled.
Result<LaidSwaths> layStage(const LayTask& task, const JobContext& job);

/// The swaths of a set that lie inside of a part of the mainland, in the same order and on the same tracks.
SwathSet cutTo(const SwathSet& set, const MultiPolygon& part);

/// Where the swaths of the chosen method end in a mainland, looking out of it. Errors: those of the method.
/// Cancelled.
Result<std::vector<Pose>> swathEnds(const PlanRequest& request, const MultiPolygon& mainland,
                                    const JobContext& job);

}  // namespace furrow
