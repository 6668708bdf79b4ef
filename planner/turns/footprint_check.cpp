#include "planner/turns/footprint_check.h"

#include "planner/turns/turn_sampling.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// Outside by less than this is touching.
constexpr double kTouchingM = 1e-3;

}  // namespace

bool isInside(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges) {
    return std::ranges::all_of(placed(footprint, pose),
                               [&](Point corner) { return edges.insideM(corner).value_or(0.0) >= -kTouchingM; });
}

bool staysInside(const Turn& turn, const Ring& footprint, const BoundaryDistance& edges, Length step) {
    Pose pose = turn.start;
    for (const TurnPiece& piece : turn.pieces) {
        const auto steps = std::max(1, static_cast<int>(std::ceil(piece.length / step)));
        for (int i = 1; i <= steps; ++i) {
            const Length way = piece.length * (static_cast<double>(i) / steps);
            if (!isInside(advanced(pose, piece, way), footprint, edges)) {
                return false;
            }
        }
        pose = advanced(pose, piece, piece.length);
    }
    return true;
}

}  // namespace furrow
