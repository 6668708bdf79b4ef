#include "planner/audit/clearance_meter.h"

#include "planner/audit/convex.h"
#include "planner/audit/length.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// Longer than any machine.
constexpr double kFarM = 1000.0;
// An intrusion without any corner of the footprint outside. It is too small to measure, but exists.
constexpr double kLeastIntrusionM = 1e-3;

struct Nearest {
    double distance;
    Point place;  ///< on the hull's side
};

/// Lowers `nearest` to the distance from a hull to an edge that it does not cross, if that is less.
void lower(Nearest& nearest, const Ring& hull, const Edge& edge) {
    double square = nearest.distance * nearest.distance;
    const double before = square;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        if (const double away = squaredDistanceToSegment(hull[i], edge); away < square) {
            square = away;
            nearest.place = hull[i];
        }
        const Edge side{hull[i], hull[(i + 1) % hull.size()]};
        for (const Point& end : {edge.from, edge.to}) {
            if (const double away = squaredDistanceToSegment(end, side); away < square) {
                square = away;
                nearest.place = end;
            }
        }
    }
    if (square < before) {
        nearest.distance = std::sqrt(square);
    }
}

/// Half-way from a place in a convex piece in a direction: to the end of the piece, or to the first edge
/// before it.
Point middleAcross(const Ring& hull, const std::vector<Edge>& edges, Point from, Point way) {
    const Edge ray{from, from + kFarM * way};
    const auto within = partInside(hull, ray);
    double endM = within ? kFarM * within->second : 0.0;
    for (const Edge& edge : edges) {
        const Point along = edge.to - edge.from;
        const double turn = cross(way, along);
        const double m = cross(edge.from - from, along) / turn;
        const double share = cross(edge.from - from, way) / turn;
        if (turn != 0.0 && m > kMeetM && share >= 0.0 && share <= 1.0) {
            endM = std::min(endM, m);
        }
    }
    return from + 0.5 * endM * way;
}

}  // namespace

bool ClearanceMeter::measure(const Ring& hull, double limit, SegmentClearance& found) const {
    Nearest nearest{.distance = limit, .place = {}};
    std::vector<Edge> intruding;
    edges_.visitNear(widened(bounds(hull), limit), [&](const Edge& edge) {
        if (partInside(hull, edge, kMeetM)) {
            intruding.push_back(edge);
        } else {
            lower(nearest, hull, edge);
        }
    });
    if (!intruding.empty() || !edges_.contains(hull.front())) {
        // A corner on the edge itself may count as outside, but is not.
        if (intruding.empty() && edges_.distance(hull.front()) < kMeetM) {
            nearest = {.distance = 0.0, .place = hull.front()};
        } else {
            measureOutside(hull, intruding, found);
            return true;
        }
    }
    if (nearest.distance < std::min(limit, found.clearanceM)) {
        found.clearanceM = nearest.distance;
        found.place = nearest.place;
    }
    return false;
}

void ClearanceMeter::measureOutside(const Ring& hull, const std::vector<Edge>& intruding,
                                    SegmentClearance& found) const {
    double depth = kLeastIntrusionM;
    Point place = hull.front();
    bool anywhere = false;
    const auto consider = [&](Point point) {
        if (edges_.contains(point)) {
            return;
        }
        const double away = edges_.distance(point);
        if (!anywhere || away > depth) {
            depth = std::max(away, anywhere ? depth : 0.0);
            place = point;
            anywhere = true;
        }
    };
    std::ranges::for_each(hull, consider);
    // A side that crosses an area outside is deepest in it between two crossings.
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Edge side{hull[i], hull[(i + 1) % hull.size()]};
        const Point along = side.to - side.from;
        std::vector<double> crossings;
        for (const Edge& edge : intruding) {
            const Point across = edge.to - edge.from;
            const double turn = cross(along, across);
            if (turn != 0.0) {
                crossings.push_back(std::clamp(cross(edge.from - side.from, across) / turn, 0.0, 1.0));
            }
        }
        std::ranges::sort(crossings);
        for (std::size_t k = 1; k < crossings.size(); ++k) {
            consider(side.from + 0.5 * (crossings[k - 1] + crossings[k]) * along);
        }
    }
    // A small thing between the wheels: its middle lies in it, unless it is bent. A thing that reaches in
    // from a side: the place between an edge and the next thing across it lies in it.
    Point sum;
    double inside = 0.0;
    for (const Edge& edge : intruding) {
        if (const auto part = partInside(hull, edge, kMeetM)) {
            const Point middle = edge.from + 0.5 * (part->first + part->second) * (edge.to - edge.from);
            sum = sum + middle;
            inside += 1.0;
            const Point along = (1.0 / lengthOf(edge.to - edge.from)) * (edge.to - edge.from);
            consider(middleAcross(hull, intruding, middle, {along.y, -along.x}));
            consider(middleAcross(hull, intruding, middle, {-along.y, along.x}));
        }
    }
    if (inside > 0.0) {
        consider((1.0 / inside) * sum);
        if (!anywhere) {
            place = (1.0 / inside) * sum;
        }
    }
    if (-depth < found.clearanceM) {
        found.clearanceM = -depth;
        found.place = place;
        found.beyondLand = !land_.contains(place);
    }
}

}  // namespace furrow
