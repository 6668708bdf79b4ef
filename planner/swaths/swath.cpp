#include "planner/swaths/swath.h"

#include "planner/geometry/curve_sampling.h"

#include <cmath>

namespace furrow {

Curve lineOf(const Swath& swath) {
    if (swath.isCurved()) {
        return swath.curve;
    }
    const Point way = swath.end - swath.start;
    return {.type = {},
            .start = {.position = swath.start, .heading = radians(std::atan2(way.y, way.x))},
            .pieces = {{.length = swath.length(), .curvature = {}}}};
}

Polyline middleLine(const Swath& swath, Length chordTolerance) {
    if (!swath.isCurved()) {
        return {swath.start, swath.end};
    }
    Polyline line;
    for (const CurveSample& sample : sampled(swath.curve, chordTolerance)) {
        line.push_back(sample.pose.position);
    }
    return line;
}

}  // namespace furrow
