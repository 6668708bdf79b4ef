#include "planner/audit/clearance.h"

#include "planner/audit/boundary_index.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/jobs/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace furrow {

namespace {

// Long straight steps are looked at in pieces, so that each asks only for the edges around it.
constexpr double kPieceM = 25.0;
// An intrusion without any corner of the footprint outside: too small to measure, but there.
constexpr double kLeastIntrusionM = 1e-3;

/// A rectangle by its middle, heading and half sizes.
Ring rectangle(Point middle, double headingRad, double halfLengthM, double halfWidthM) {
    const Point along = halfLengthM * direction(headingRad);
    const Point left = halfWidthM * Point{-std::sin(headingRad), std::cos(headingRad)};
    return {middle - along - left, middle + along - left, middle + along + left, middle - along + left};
}

/// Counter-clockwise, by Andrew's monotone chain.
Ring convexHull(Ring points) {
    std::ranges::sort(points, [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    Ring hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t base = hull.size();
        for (const Point& point : points) {
            while (hull.size() >= base + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], point - hull.back()) <= 0.0) {
                hull.pop_back();
            }
            hull.push_back(point);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

Bounds grown(const Ring& ring, double by) {
    Bounds box{.min = ring.front(), .max = ring.front()};
    for (const Point& point : ring) {
        box.min = {std::min(box.min.x, point.x), std::min(box.min.y, point.y)};
        box.max = {std::max(box.max.x, point.x), std::max(box.max.y, point.y)};
    }
    return {.min = box.min - Point{by, by}, .max = box.max + Point{by, by}};
}

/// The part of a segment, from 0 to 1, inside a convex counter-clockwise ring.
std::optional<std::pair<double, double>> partInside(const Ring& hull, const Edge& edge) {
    double enter = 0.0;
    double leave = 1.0;
    const Point along = edge.to - edge.from;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Point side = hull[(i + 1) % hull.size()] - hull[i];
        const double start = cross(side, edge.from - hull[i]);
        const double slope = cross(side, along);
        if (slope == 0.0) {
            if (start <= 0.0) {
                return std::nullopt;
            }
        } else if (slope > 0.0) {
            enter = std::max(enter, -start / slope);
        } else {
            leave = std::min(leave, -start / slope);
        }
        if (enter >= leave) {
            return std::nullopt;
        }
    }
    return std::pair{enter, leave};
}

/// Of two segments that do not cross.
double distanceBetween(const Edge& a, const Edge& b) {
    return std::min({distanceToSegment(a.from, b), distanceToSegment(a.to, b), distanceToSegment(b.from, a),
                     distanceToSegment(b.to, a)});
}

class ClearanceMeter {
public:
    ClearanceMeter(const MultiPolygon& area, const MultiPolygon& land) : edges_{area}, land_{land} {}

    /// Lowers `found` to the clearance of this convex piece where that is less.
    void measure(const Ring& hull, SegmentClearance& found) const {
        const double limit = std::max(found.clearanceM, 0.0);
        double nearest = limit;
        Point nearestPlace;
        std::vector<Edge> intruding;
        edges_.visitNear(grown(hull, limit), [&](const Edge& edge) {
            if (partInside(hull, edge)) {
                intruding.push_back(edge);
                return;
            }
            for (std::size_t i = 0; i < hull.size(); ++i) {
                const Edge side{hull[i], hull[(i + 1) % hull.size()]};
                const double away = distanceBetween(side, edge);
                if (away < nearest) {
                    nearest = away;
                    nearestPlace = distanceToSegment(side.from, edge) < distanceToSegment(side.to, edge)
                                       ? side.from
                                       : side.to;
                }
            }
        });
        if (intruding.empty() && edges_.contains(hull.front())) {
            if (nearest < found.clearanceM) {
                found.clearanceM = nearest;
                found.place = nearestPlace;
            }
            return;
        }
        measureOutside(hull, intruding, found);
    }

private:
    void measureOutside(const Ring& hull, const std::vector<Edge>& intruding, SegmentClearance& found) const {
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
        // A side that runs through something is deepest in it between two crossings.
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
        // Something small between the wheels: its middle is in it, unless it is bent.
        Point sum;
        double inside = 0.0;
        for (const Edge& edge : intruding) {
            if (const auto part = partInside(hull, edge)) {
                sum = sum + (edge.from + 0.5 * (part->first + part->second) * (edge.to - edge.from));
                inside += 1.0;
            }
        }
        if (inside > 0.0) {
            consider((1.0 / inside) * sum);
            if (!anywhere) {
                place = (1.0 / inside) * sum;
            }
        }
        found.suspects.push_back({.outer = hull, .holes = {}});
        if (-depth < found.clearanceM) {
            found.clearanceM = -depth;
            found.place = place;
            found.beyondLand = !land_.contains(place);
        }
    }

    BoundaryIndex edges_;
    BoundaryIndex land_;
};

struct Part {
    double offsetM = 0.0;  ///< of its middle, ahead of what carries it
    double halfLengthM = 0.0;
    double halfWidthM = 0.0;
};

/// The tractor is carried by its own reference point, the implement by the middle of its working line.
struct Footprint {
    Part tractor;
    Part raised;
    Part lowered;
};

Footprint footprintOf(const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    const Implement& implement = machine.spec().implement;
    const double halfLength = 0.5 * implement.length.si();
    return {.tractor = {.offsetM = (0.5 * tractor.length - tractor.rearOverhang).si(),
                        .halfLengthM = 0.5 * tractor.length.si(),
                        .halfWidthM = 0.5 * tractor.width.si()},
            .raised = {.halfLengthM = halfLength,
                       .halfWidthM = 0.5 * implement.raisedWidth.value_or(implement.operatingWidth).si()},
            .lowered = {.halfLengthM = halfLength, .halfWidthM = 0.5 * implement.operatingWidth.si()}};
}

Ring placed(const Part& part, Point carrier, double headingRad) {
    return rectangle(carrier + part.offsetM * direction(headingRad), headingRad, part.halfLengthM,
                     part.halfWidthM);
}

MultiPolygon withoutHoles(const MultiPolygon& polygons) {
    MultiPolygon filled;
    for (const Polygon& polygon : polygons) {
        filled.push_back({.outer = polygon.outer, .holes = {}});
    }
    return filled;
}

MultiPolygon gateDiscs(const std::vector<AuditGate>& gates) {
    constexpr int kCorners = 64;
    MultiPolygon discs;
    for (const AuditGate& gate : gates) {
        Ring ring;
        for (int i = 0; i < kCorners && gate.width > metres(0.0); ++i) {
            ring.push_back(gate.position +
                           0.5 * gate.width.si() * direction(2.0 * std::numbers::pi * i / kCorners));
        }
        if (!ring.empty()) {
            discs.push_back({.outer = std::move(ring), .holes = {}});
        }
    }
    return discs;
}

SegmentClearance clearanceOf(const SegmentMotion& motion, bool down, const Footprint& footprint,
                             double farthestM, const ClearanceMeter& meter) {
    SegmentClearance found{.clearanceM = farthestM};
    const Part& implement = down ? footprint.lowered : footprint.raised;
    const auto sweep = [&](const MotionState& a, const MotionState& b) {
        const double way = std::max(distance(a.position, b.position), distance(a.implement, b.implement));
        const int pieces = std::max(1, static_cast<int>(std::ceil(way / kPieceM)));
        const auto between = [](Point from, Point to, double t) { return from + t * (to - from); };
        for (int k = 0; k < pieces; ++k) {
            const double t0 = static_cast<double>(k) / pieces;
            const double t1 = static_cast<double>(k + 1) / pieces;
            Ring tractor = placed(footprint.tractor, between(a.position, b.position, t0), a.headingRad);
            std::ranges::copy(placed(footprint.tractor, between(a.position, b.position, t1), b.headingRad),
                              std::back_inserter(tractor));
            meter.measure(convexHull(std::move(tractor)), found);
            Ring tool = placed(implement, between(a.implement, b.implement, t0), a.implementHeadingRad);
            std::ranges::copy(
                placed(implement, between(a.implement, b.implement, t1), b.implementHeadingRad),
                std::back_inserter(tool));
            meter.measure(convexHull(std::move(tool)), found);
        }
    };
    for (const auto* states : {&motion.turnOnTheSpot, &motion.states}) {
        for (std::size_t i = 1; i < states->size(); ++i) {
            sweep((*states)[i - 1], (*states)[i]);
        }
    }
    return found;
}

}  // namespace

Result<ClearanceReport> measureClearance(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                                         const JobContext& job) {
    MultiPolygon open = input.drivable;
    if (const MultiPolygon discs = gateDiscs(input.gates); !discs.empty()) {
        std::ranges::copy(discs, std::back_inserter(open));
        auto merged = unionOf(open, job, kSnapGrid);
        if (!merged) {
            return std::unexpected(merged.error());
        }
        open = std::move(*merged);
    }
    const ClearanceMeter meter{open, withoutHoles(open)};
    const Footprint footprint = footprintOf(*input.machine);
    ClearanceReport report;
    // Most plans come near the edge somewhere; only where none of it does is it worth looking farther.
    for (double farthest = 2.0; farthest < 1e6; farthest *= 16.0) {
        auto segments = parallelMap<SegmentClearance>(
            motions.size(),
            [&](std::size_t i) {
                return clearanceOf(motions[i], input.segments[i].implementDown, footprint, farthest, meter);
            },
            job);
        if (!segments) {
            return std::unexpected(segments.error());
        }
        report.segments = std::move(*segments);
        double smallest = farthest;
        for (const SegmentClearance& segment : report.segments) {
            smallest = std::min(smallest, segment.clearanceM);
        }
        report.smallest = metres(smallest);
        if (smallest < farthest) {
            break;
        }
    }
    // Each segment's own first, side by side; then all of them at once.
    std::vector<std::size_t> suspects;
    for (std::size_t i = 0; i < report.segments.size(); ++i) {
        if (!report.segments[i].suspects.empty()) {
            suspects.push_back(i);
        }
    }
    if (!suspects.empty()) {
        const auto unions = parallelMap<std::optional<Result<MultiPolygon>>>(
            suspects.size(),
            [&](std::size_t k) -> std::optional<Result<MultiPolygon>> {
                return unionOf(report.segments[suspects[k]].suspects, job, kSnapGrid);
            },
            job);
        if (!unions) {
            return std::unexpected(unions.error());
        }
        MultiPolygon all;
        for (const auto& each : *unions) {
            if (!*each) {
                return std::unexpected((*each).error());
            }
            std::ranges::copy(**each, std::back_inserter(all));
        }
        const auto swept = unionOf(all, job, kSnapGrid);
        const auto outside = swept ? difference(*swept, open, job, kSnapGrid) : swept;
        if (!outside) {
            return std::unexpected(outside.error());
        }
        report.outside = area(*outside);
    }
    return report;
}

}  // namespace furrow
