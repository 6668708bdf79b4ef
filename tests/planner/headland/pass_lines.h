#pragma once

#include "planner/geometry/curve_sampling.h"
#include "tests/support/stages.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// What the tests of headland passes measure on a line, and the machine that they share.

namespace furrow::test {

// Tractor 3 m wide, implement 2.5 m: 0.25 m stays uncut on either side.
inline const Machine& wideTractor() {
    static const Machine machine = [] {
        MachineSpec spec = agbot().spec();
        spec.tractor.width = metres(3.0);
        spec.implement.operatingWidth = metres(2.5);
        return Machine::create(spec).value();
    }();
    return machine;
}

inline double totalTurning(const Curve& line) {
    double turned = 0.0;
    for (const CurvePiece& piece : line.pieces) {
        turned += 0.5 * (piece.curvature + piece.endCurvature).si() * piece.length.si();
    }
    return turned;
}

inline double sharpest(const Curve& line) {
    double most = 0.0;
    for (const CurvePiece& piece : line.pieces) {
        most = std::max({most, std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si())});
    }
    return most;
}

inline double apart(const Pose& a, const Pose& b) {
    return std::max(distance(a.position, b.position),
                    std::abs(std::remainder(a.heading.si() - b.heading.si(), 2.0 * std::numbers::pi)));
}

inline Pose poseAt(const Curve& line, double wayM) {
    Pose pose = line.start;
    for (const CurvePiece& piece : line.pieces) {
        if (wayM <= piece.length.si()) {
            return advanced(pose, piece, metres(wayM));
        }
        wayM -= piece.length.si();
        pose = advanced(pose, piece, piece.length);
    }
    return pose;
}

}  // namespace furrow::test
