#include "planner/swaths/swath.h"

#include "planner/turns/turn_sampling.h"

namespace furrow {

Polyline middleLine(const Swath& swath, Length chordTolerance) {
    if (!swath.isCurved()) {
        return {swath.start, swath.end};
    }
    Polyline line;
    for (const TurnSample& sample : sampled(swath.curve, chordTolerance)) {
        line.push_back(sample.pose.position);
    }
    return line;
}

}  // namespace furrow
