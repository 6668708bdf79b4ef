#pragma once

#include "planner/field/allowed_areas.h"
#include "planner/swaths/swath.h"

namespace furrow {

/// The room for swath ends beyond the mainland.
struct EndRoom {
    const MultiPolygon& working;  ///< area for the implement: the field inside its outermost pass
    const AllowedAreas& driving;
    Length turning;  ///< ahead of the swath's end, for the turn into the next one
    /// Ends stop short where tractor and implement would leave `driving`. Used if there is no headland to
    /// turn in.
    bool drawsIn = false;
    /// And where there is no room to turn on the spot, with a machine that does.
    bool turnsOnTheSpot = false;
    bool drawsOut = true;
};

/// Extends both ends of every swath until the full operating width has left the mainland, but no farther than
/// the room at that end allows. At a straight edge that is (w/2) |cot angle|. With `drawsIn`, ends may also
/// move back. Where a swath lies too near an edge for turning anywhere, its end stays. Lines, and curves
/// straight on, may reach beyond the mainland by that length. Coverage and overlap stay those of flat ends.
/// The area worked beyond the mainland is summed separately. Cost: O(n + swaths * edges near each) for n
/// vertices.
void drawOutEnds(SwathSet& set, const MultiPolygon& mainland, const EndRoom& room, const Machine& machine);

/// Straight swaths without the stretches on which the machine at work would reach over an edge of `driving`
/// beside it: swaths become pieces, some of them none at all. Curves stay as they are. Cost: O(n + swaths *
/// edges near each).
SwathSet withoutReachingOver(SwathSet set, const AllowedAreas& driving, const Machine& machine);

}  // namespace furrow
