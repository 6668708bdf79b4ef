#pragma once

#include "planner/headland/corner_manoeuvres.h"
#include "planner/headland/headland.h"
#include "planner/headland/pass_task.h"

#include <vector>

namespace furrow {

// Internal to the headland passes: passes that go all round.

/// A machine beside an edge can leave it only with this distance at the start.
inline constexpr Length kBesideEdge = metres(0.02);

/// One ring all around. Its corners are rounded or driven into.
struct ClosedRing {
    std::vector<HeadlandPass> passes;
    std::vector<Curve> lines;            ///< of the passes before corners are driven into and before cuts
    std::vector<RoundedCorner> rounded;  ///< corners that stayed rounded
    std::vector<Point> outside;          ///< places beside corners that are driven into
    Length movedIn;
    bool complete = true;  ///< every line could be rounded
    bool inside = false;   ///< known to be inside everywhere
};

/// The pass of a ring with its corners as asked. Rounded corners of the outermost pass (ring 0), and of inner
/// passes where the machine cannot reverse, are driven into where rounding leaves too much and the machine
/// can leave them again. Cancelled.
/// @param method  anything but Searched
Result<ClosedRing> closedRing(const PassTask& task, Length inset, int ring, CornerMethod method,
                              const JobContext& job);

}  // namespace furrow
