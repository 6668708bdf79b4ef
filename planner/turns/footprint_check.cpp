#include "planner/turns/footprint_check.h"

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <cmath>

namespace furrow {

FootprintRoom roomAround(const Pose& pose, const Ring& footprint, double radiusM,
                         const BoundaryDistance& edges, double noLessM) {
    const double reachM = edges.reachM();
    FootprintRoom room{reachM, reachM};
    const Point ahead = direction(pose.heading.si());
    const Point left{-ahead.y, ahead.x};
    // Start from the corner with most room. Skip corners near it that cannot have less room than the least so
    // far.
    Point free;
    double freeM = -reachM;
    for (const Point& corner : footprint) {
        const double sureM = freeM - room.edgesM;
        const Point away = corner - free;
        if (sureM > 0.0 && dot(away, away) <= sureM * sureM) {
            continue;
        }
        const double insideM =
            edges.insideM(pose.position + corner.x * ahead + corner.y * left).value_or(reachM);
        room.edgesM = std::min(room.edgesM, insideM);
        if (room.edgesM < noLessM) {
            return room;
        }
        if (insideM > freeM) {
            free = corner;
            freeM = insideM;
        }
    }
    const Bounds box = bounds(footprint);
    const double farM = radiusM + reachM;
    for (const Point& corner : edges.inwardCorners(pose.position.x - farM, pose.position.x + farM)) {
        const Point way = corner - pose.position;
        // Skip corners that are farther away than the nearest so far plus the radius of the footprint.
        const double mostM = radiusM + room.cornersM;
        if (dot(way, way) >= mostM * mostM) {
            continue;
        }
        const Point here{dot(ahead, way), cross(ahead, way)};
        const double besideM =
            std::max({box.min.x - here.x, here.x - box.max.x, box.min.y - here.y, here.y - box.max.y});
        // Beside the box around the footprint by more than that, too.
        if (besideM <= 0.0 || besideM < room.cornersM) {
            room.cornersM = std::min(room.cornersM, awayFrom(footprint, here));
        }
    }
    return room;
}

double radiusOf(const Ring& footprint) {
    double radiusM = 0.0;
    for (const Point& corner : footprint) {
        radiusM = std::max(radiusM, norm(corner));
    }
    return radiusM;
}

double outsideM(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges) {
    return std::max(0.0, -roomAround(pose, footprint, radiusOf(footprint), edges).least());
}

bool isInside(const Pose& pose, const Ring& footprint, const BoundaryDistance& edges) {
    return outsideM(pose, footprint, edges) <= kContactM;
}

bool staysInside(const Curve& turn, const Ring& footprint, const BoundaryDistance& edges, Length step) {
    Pose pose = turn.start;
    for (const CurvePiece& piece : turn.pieces) {
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
