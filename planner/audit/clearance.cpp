#include "planner/audit/clearance.h"

#include "planner/audit/boundary_index.h"
#include "planner/audit/convex.h"
#include "planner/audit/depth_sweep.h"
#include "planner/audit/footprint.h"
#include "planner/audit/length.h"
#include "planner/audit/swept_area.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"
#include "planner/path/folded_stretches.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <optional>

namespace furrow {

namespace {

/// Straight steps that may come too near to an edge are halved down to this length.
constexpr double kPieceM = 6.0;
// Steps that turn are halved until their hulls reach at most this far beyond the swept area.
constexpr double kFinestM = 0.002;
// Longer than any machine.
constexpr double kFarM = 1000.0;
// An intrusion without any corner of the footprint outside. It is too small to measure, but exists.
constexpr double kLeastIntrusionM = 1e-3;

/// A rectangle from its middle, its direction and half its sizes.
Ring rectangle(Point middle, Point nose, double halfLengthM, double halfWidthM) {
    const Point along = halfLengthM * nose;
    const Point left = halfWidthM * Point{-nose.y, nose.x};
    return {middle - along - left, middle + along - left, middle + along + left, middle - along + left};
}

Bounds grown(const Ring& ring, double by) {
    Bounds box{.min = ring.front(), .max = ring.front()};
    for (const Point& point : ring) {
        box.min = {std::min(box.min.x, point.x), std::min(box.min.y, point.y)};
        box.max = {std::max(box.max.x, point.x), std::max(box.max.y, point.y)};
    }
    return {.min = box.min - Point{by, by}, .max = box.max + Point{by, by}};
}

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

class ClearanceMeter {
public:
    ClearanceMeter(const MultiPolygon& area, const MultiPolygon& land) : edges_{area}, land_{land} {}

    /// Whether everything within a distance of a place is inside.
    bool isFree(Point middle, double radius) const { return edges_.containsDisc(middle, radius); }

    /// Whether everything within a distance of a place is outside.
    bool isBeyond(Point middle, double radius) const {
        return !edges_.contains(middle) && edges_.distance(middle) > radius;
    }

    /// Lowers `found` to the clearance of this convex piece if that is less and under `limit`. Returns
    /// whether some of it may lie outside.
    bool measure(const Ring& hull, double limit, SegmentClearance& found) const {
        Nearest nearest{.distance = limit, .place = {}};
        std::vector<Edge> intruding;
        edges_.visitNear(grown(hull, limit), [&](const Edge& edge) {
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

    /// Half-way from a place in a convex piece in a direction: to the end of the piece, or to the first edge
    /// before it.
    static Point middleAcross(const Ring& hull, const std::vector<Edge>& edges, Point from, Point way) {
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

    BoundaryIndex edges_;
    BoundaryIndex land_;
};

/// The place of a part.
struct Placed {
    Point middle;
    Point nose;
};

Placed placed(const FootprintPart& part, Point carrier, Point nose) {
    return {carrier + part.offsetM * nose, nose};
}

/// The place in the middle of the arc that joins two places.
Placed halfWay(const Placed& a, const Placed& b) {
    const Point way = b.middle - a.middle;
    const Point sum = a.nose + b.nose;
    const double turn = std::atan2(cross(a.nose, b.nose), dot(a.nose, b.nose));
    // The arc bulges to the side that it turns away from.
    const double bulge = 0.5 * std::tan(0.25 * turn);
    return {0.5 * (a.middle + b.middle) + bulge * Point{way.y, -way.x}, (1.0 / lengthOf(sum)) * sum};
}

/// Upper bound of the distance by which the hull of both places exceeds the swept area between them. The
/// corners turn by half the angle to either side of the middle place, which lies on an arc.
double bridgedBy(const FootprintPart& part, const Placed& a, const Placed& b) {
    const double turn = std::abs(std::atan2(cross(a.nose, b.nose), dot(a.nose, b.nose)));
    return (0.5 * part.radius() + 0.125 * lengthOf(b.middle - a.middle)) * turn;
}

Ring hullOf(const FootprintPart& part, const Placed& a, const Placed& b) {
    Ring corners = rectangle(a.middle, a.nose, part.halfLengthM, part.halfWidthM);
    std::ranges::copy(rectangle(b.middle, b.nose, part.halfLengthM, part.halfWidthM),
                      std::back_inserter(corners));
    return hullAround(std::move(corners));
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

/// An upper bound of the least clearance of all segments. It only falls.
class SmallestClearance {
public:
    explicit SmallestClearance(double startM) : valueM_{startM} {}
    double get() const { return valueM_.load(std::memory_order_relaxed); }
    void lowerTo(double valueM) {
        double known = get();
        while (valueM < known && !valueM_.compare_exchange_weak(known, valueM, std::memory_order_relaxed)) {
        }
    }

private:
    std::atomic<double> valueM_;
};

/// Moves the parts of the machine along one segment.
class SegmentSweep {
public:
    SegmentSweep(const Footprint& footprint, const ClearanceMeter& meter, SmallestClearance& smallest)
        : footprint_{footprint}, meter_{meter}, smallest_{smallest} {}

    /// Ends early, with a partial result, if the job is stopped.
    SegmentClearance run(const SegmentMotion& motion, const FootprintPart& implement, const JobContext& job) {
        for (const auto* states : {&motion.turnOnTheSpot, &motion.states}) {
            for (std::size_t i = 1; i < states->size() && !job.stopRequested(); ++i) {
                const MotionState& a = (*states)[i - 1];
                const MotionState& b = (*states)[i];
                move(footprint_.tractor, placed(footprint_.tractor, a.position, a.nose),
                     placed(footprint_.tractor, b.position, b.nose));
                move(implement, placed(implement, a.implement, a.implementNose),
                     placed(implement, b.implement, b.implementNose));
            }
        }
        return std::move(found_);
    }

private:
    /// A move from one place to the next. The part stays in a disc. If the disc is free by more than the
    /// least known clearance of the path, the move changes nothing. Moves outside always count.
    void move(const FootprintPart& part, const Placed& a, const Placed& b) {
        const double way = lengthOf(b.middle - a.middle);
        const Point middle = 0.5 * (a.middle + b.middle);
        // A half of a move may bulge out of its hull by the bridged distance. Nearer moves are always looked
        // at, so that the area outside does not depend on which thread found the least clearance first.
        const double bridged = bridgedBy(part, a, b);
        const double limit = std::max(bridged, std::min(found_.clearanceM, smallest_.get()));
        if (meter_.isFree(middle, 0.5 * way + part.radius() + limit)) {
            return;
        }
        // A part of the path that is nowhere near the field stays one piece, however long.
        if (way > kPieceM && a.nose == b.nose && !meter_.isBeyond(middle, 0.5 * way + part.radius())) {
            const Placed between{middle, a.nose};
            move(part, a, between);
            move(part, between, b);
            return;
        }
        Ring hull = hullOf(part, a, b);
        SegmentClearance step;
        const bool mayBeOutside = meter_.measure(hull, limit, step);
        // In a turn, a hull also covers places that the side of the part goes round. This matters for the
        // decision between inside and outside, and for the least clearance. A part farther outside stays
        // outside.
        const bool decides = mayBeOutside ? -step.clearanceM < bridged : step.clearanceM < limit;
        if (decides && bridged > kFinestM) {
            const Placed between = halfWay(a, b);
            move(part, a, between);
            move(part, between, b);
            return;
        }
        if (step.clearanceM < found_.clearanceM) {
            found_.clearanceM = step.clearanceM;
            found_.place = step.place;
            found_.beyondLand = step.beyondLand;
        }
        if (mayBeOutside) {
            found_.suspects[&part == &footprint_.tractor ? 0 : 1].push_back(std::move(hull));
        }
        smallest_.lowerTo(found_.clearanceM);
    }

    const Footprint& footprint_;
    const ClearanceMeter& meter_;
    SmallestClearance& smallest_;
    SegmentClearance found_;
};

/// The drivable area with its gates open.
Result<MultiPolygon> withGates(const AuditInput& input, const JobContext& job) {
    MultiPolygon open = input.drivable;
    const MultiPolygon discs = gateDiscs(input.gates);
    if (discs.empty()) {
        return open;
    }
    std::ranges::copy(discs, std::back_inserter(open));
    return unionOf(open, job, kSnapGrid);
}

enum Layer : std::size_t { kOpen, kFootprint };

std::uint32_t isSwept(const Depths& depths) {
    return depths[kFootprint] > 0 ? 1 : 0;
}

std::uint32_t isSweptOutside(const Depths& depths) {
    return depths[kFootprint] > 0 && depths[kOpen] <= 0 ? 1 : 0;
}

Result<MultiPolygon> outlineOf(const LayeredPolygons& layers, Point along, const JobContext& job) {
    return measureRegions(layers, along, {.at = isSwept, .count = 1, .traced = 1}, job)
        .transform([](std::vector<MeasuredRegion>&& regions) { return std::move(regions.front().polygons); });
}

/// The outline of the area that the suspects of one segment sweep. Each suspect moves on by a few centimetres
/// only. Without the part that it shares with the one before, little overlap remains. A group of 16 soon
/// becomes a polygon with few corners.
Result<MultiPolygon> outlineOf(const SegmentClearance& segment, Point along, const JobContext& job) {
    constexpr std::size_t kAtATime = 16;
    LayeredPolygons outlines;
    for (const std::vector<Ring>& hulls : segment.suspects) {
        for (std::size_t first = 0; first < hulls.size(); first += kAtATime) {
            LayeredPolygons layers;
            layers.add(kFootprint, hulls[first]);
            for (std::size_t i = first + 1; i < std::min(first + kAtATime, hulls.size()); ++i) {
                for (const Ring& part : partsOutside(hulls[i], hulls[i - 1])) {
                    layers.add(kFootprint, part);
                }
            }
            const auto outline = outlineOf(layers, along, job);
            if (!outline) {
                return outline;
            }
            outlines.add(kFootprint, *outline);
        }
    }
    return outlineOf(outlines, along, job);
}

/// The part of the area swept by suspects that lies outside.
Result<Area> areaOutside(const std::vector<SegmentClearance>& segments, const MultiPolygon& open, Point along,
                         const JobContext& job) {
    std::vector<const SegmentClearance*> suspects;
    for (const SegmentClearance& segment : segments) {
        if (segment.isSuspect()) {
            suspects.push_back(&segment);
        }
    }
    if (suspects.empty()) {
        return Area{};
    }
    const auto outlines = parallelMap<std::optional<Result<MultiPolygon>>>(
        suspects.size(), [&](std::size_t i) { return outlineOf(*suspects[i], along, job); }, job);
    if (!outlines) {
        return std::unexpected(outlines.error());
    }
    LayeredPolygons layers;
    layers.add(kOpen, open);
    for (const auto& outline : *outlines) {
        if (!*outline) {
            return std::unexpected(outline->error());
        }
        layers.add(kFootprint, **outline);
    }
    return measureRegions(layers, along, {.at = isSweptOutside, .count = 1}, job)
        .transform([](const std::vector<MeasuredRegion>& regions) { return regions.front().area; });
}

}  // namespace

Result<ClearanceReport> measureClearance(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                                         const JobContext& job) {
    const auto open = withGates(input, job);
    if (!open) {
        return std::unexpected(open.error());
    }
    const ClearanceMeter meter{*open, withoutHoles(*open)};
    const Footprint footprint = footprintOf(*input.machine);
    ClearanceReport report;
    // Most plans come near the edge somewhere. Only if no part does, the search goes farther.
    double begun = 0.0;
    for (double farthest = 2.0; farthest < 1e6; farthest *= 16.0) {
        // Each round gets half of the remaining progress.
        const double done = 0.5 * (begun + 0.9);
        const JobContext look = job.part(begun, done);
        begun = done;
        SmallestClearance smallest{farthest};
        auto segments = parallelMap<SegmentClearance>(
            motions.size(),
            [&](std::size_t i) {
                const FootprintPart& implement = input.segments[i].implementDown     ? footprint.lowered
                                                 : isDrivenFolded(input.segments, i) ? footprint.folded
                                                                                     : footprint.raised;
                return SegmentSweep{footprint, meter, smallest}.run(motions[i], implement, look);
            },
            look);
        if (!segments) {
            return std::unexpected(segments.error());
        }
        report.segments = std::move(*segments);
        report.smallest = metres(smallest.get());
        if (smallest.get() < farthest) {
            break;
        }
    }
    const auto outside = areaOutside(report.segments, *open, mainDirection(motions), job.part(0.9, 1.0));
    if (!outside) {
        return std::unexpected(outside.error());
    }
    report.outside = *outside;
    return report;
}

}  // namespace furrow
