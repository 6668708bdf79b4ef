#pragma once

#include "planner/swaths/swath.h"

namespace furrow {

/// How far the ends of swaths may reach beyond the mainland.
struct EndRoom {
    const MultiPolygon& working;  ///< the implement stays in here: the field inside its outermost pass
    const MultiPolygon& driving;  ///< tractor and implement stay in here
    Length turning;               ///< ahead of the swath's end, for the turn into the next one
    /// Ends stop short where tractor and implement would be outside of `driving`: where there is no headland to turn in.
    bool drawsIn = false;
};

/// Draws both ends of every swath out until the full operating width has left the mainland, by
/// (w/2) |cot angle| at a straight edge, but no farther than the room at that end allows; back from there, where they are to be drawn in. Lines may move
/// beyond the mainland by that, curves straight on; coverage and overlap stay those of flat ends, the area worked beyond the
/// mainland is added up apart. Cost: O(n + swaths * edges near each) for n vertices.
void drawOutEnds(SwathSet& set, const MultiPolygon& mainland, const EndRoom& room, const Machine& machine);

}  // namespace furrow
