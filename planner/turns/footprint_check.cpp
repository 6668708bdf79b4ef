#include "planner/turns/footprint_check.h"

#include "planner/geometry/segment.h"
#include "planner/turns/turn_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow {

namespace {

// Outside by less than this is touching.
constexpr double kTouchingM = 1e-3;

/// How far a point is from a shape's sides, negative inside.
double awayFrom(const Ring& shape, Point point) {
    bool inside = false;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < shape.size(); ++i) {
        const Point a = shape[i];
        const Point b = shape[(i + 1) % shape.size()];
        if ((a.y > point.y) != (b.y > point.y) &&
            point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) {
            inside = !inside;
        }
        nearest = std::min(nearest, distanceToSegment(point, a, b));
    }
    return inside ? -nearest : nearest;
}

}  // namespace

FootprintRoom roomAround(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges) {
    const double reachM = edges.reachM();
    FootprintRoom room{reachM, reachM};
    double radius = 0.0;
    for (const Point& corner : placed(footprint, pose)) {
        room.edgesM = std::min(room.edgesM, edges.insideM(corner).value_or(reachM));
        radius = std::max(radius, distance(corner, pose.position));
    }
    const Point ahead = direction(pose.heading.si());
    const double farM = radius + reachM;
    for (const Point& corner : edges.inwardCorners(pose.position.x - farM, pose.position.x + farM)) {
        const Point way = corner - pose.position;
        if (std::abs(way.y) < farM) {
            room.cornersM = std::min(room.cornersM, awayFrom(footprint, {dot(ahead, way), cross(ahead, way)}));
        }
    }
    return room;
}

double outsideM(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges) {
    return std::max(0.0, -roomAround(pose, footprint, edges).least());
}

bool isInside(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges) {
    return outsideM(pose, footprint, edges) <= kTouchingM;
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
