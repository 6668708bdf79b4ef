#include "planner/geometry/curve_sampling.h"

#include <algorithm>
#include <cmath>

namespace furrow {

std::vector<CurveSample> sampled(const Curve& turn, Length chordTolerance) {
    std::vector<CurveSample> samples;
    Pose pose = turn.start;
    Length way;
    Curvature arriving;
    for (const CurvePiece& piece : turn.pieces) {
        // The largest curvature holds for the whole clothoid, so its flat end gets more samples than needed.
        const double curvature = std::max(std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si()));
        // The distance between an arc and its chord over the angle phi is R (1 - cos(phi / 2)).
        const double cosine = std::clamp(1.0 - chordTolerance.si() * curvature, -1.0, 1.0);
        const double angle = piece.length.si() * curvature;
        const double chordAngle = 2.0 * std::acos(cosine);
        // Of a straight piece, or almost one, the chord is the line itself.
        const int count = chordAngle > 0.0 ? std::max(1, static_cast<int>(std::ceil(angle / chordAngle))) : 1;
        for (int i = 0; i < count; ++i) {
            const Length part = piece.length * (static_cast<double>(i) / count);
            const Curvature here = piece.curvatureAt(part);
            samples.push_back(
                {way + part, advanced(pose, piece, part), here, piece.gear, i == 0 ? arriving : here});
        }
        arriving = piece.endCurvature;
        pose = advanced(pose, piece, piece.length);
        way += piece.length;
    }
    if (samples.empty()) {
        // A turn to the present place has only its start and its end.
        samples.push_back({way, pose, {}, Gear::Forward, {}});
    }
    const CurvePiece last = turn.pieces.empty() ? CurvePiece{} : turn.pieces.back();
    samples.push_back({way, pose, last.endCurvature, last.gear, last.endCurvature});
    return samples;
}

Ring placed(const Ring& shape, const Pose& pose) {
    const Point ahead = direction(pose.heading.si());
    const Point left{-ahead.y, ahead.x};
    Ring moved;
    moved.reserve(shape.size());
    for (const Point& corner : shape) {
        moved.push_back(pose.position + corner.x * ahead + corner.y * left);
    }
    return moved;
}

}  // namespace furrow
