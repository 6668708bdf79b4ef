#include "planner/audit/clearance.h"

#include "planner/audit/audited_land.h"
#include "planner/audit/clearance_meter.h"
#include "planner/audit/convex.h"
#include "planner/audit/depth_sweep.h"
#include "planner/audit/footprint.h"
#include "planner/audit/length.h"
#include "planner/audit/swept_area.h"
#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

namespace furrow {

namespace {

/// Straight steps that may come too near to an edge are halved down to this length.
constexpr double kPieceM = 6.0;
// Steps that turn are halved until their hulls reach at most this far beyond the swept area.
constexpr double kFinestM = 0.002;

/// A rectangle from its middle, its direction and half its sizes.
Ring rectangle(Point middle, Point nose, double halfLengthM, double halfWidthM) {
    const Point along = halfLengthM * nose;
    const Point left = halfWidthM * Point{-nose.y, nose.x};
    return {middle - along - left, middle + along - left, middle + along + left, middle - along + left};
}

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

/// The parts of the machine that are moved, and what each keeps clear of.
struct MovedPart {
    const FootprintPart& part;
    const ClearanceMeter& meter;
    bool isTractor = false;  ///< carried by it
    std::size_t group = 0;   ///< of its suspects
};

/// Moves the parts of the machine along one segment.
class SegmentSweep {
public:
    explicit SegmentSweep(SmallestClearance& smallest) : smallest_{smallest} {}

    /// Ends early, with a partial result, if the job is stopped.
    /// @param turning  the parts as they are while it turns on the spot at the beginning
    SegmentClearance run(const SegmentMotion& motion, std::span<const MovedPart> turning,
                         std::span<const MovedPart> parts, const JobContext& job) {
        moveAlong(motion.turnOnTheSpot, turning, job);
        moveAlong(motion.states, parts, job);
        return std::move(found_);
    }

private:
    void moveAlong(const std::vector<MotionState>& states, std::span<const MovedPart> parts,
                   const JobContext& job) {
        for (std::size_t i = 1; i < states.size() && !job.stopRequested(); ++i) {
            for (const MovedPart& part : parts) {
                move(part, placeOf(part, states[i - 1]), placeOf(part, states[i]));
            }
        }
    }

    /// A move from one place to the next. The part stays in a disc. If the disc is free by more than the
    /// least known clearance of the path, the move changes nothing. Moves outside always count.
    void move(const MovedPart& moved, const Placed& a, const Placed& b) {
        const FootprintPart& part = moved.part;
        const ClearanceMeter& meter = moved.meter;
        const double way = lengthOf(b.middle - a.middle);
        const Point middle = 0.5 * (a.middle + b.middle);
        // A half of a move may bulge out of its hull by the bridged distance. Nearer moves are always looked
        // at, so that the area outside does not depend on which thread found the least clearance first.
        const double bridged = bridgedBy(part, a, b);
        const double limit = std::max(bridged, std::min(found_.clearanceM, smallest_.get()));
        if (meter.isFree(middle, 0.5 * way + part.radius() + limit)) {
            return;
        }
        // A part of the path that is nowhere near the field stays one piece, however long.
        if (way > kPieceM && a.nose == b.nose && !meter.isBeyond(middle, 0.5 * way + part.radius())) {
            const Placed between{middle, a.nose};
            move(moved, a, between);
            move(moved, between, b);
            return;
        }
        Ring hull = hullOf(part, a, b);
        SegmentClearance step;
        const bool mayBeOutside = meter.measure(hull, limit, step);
        // In a turn, a hull also covers places that the side of the part goes round. This matters for the
        // decision between inside and outside, and for the least clearance. A part farther outside stays
        // outside.
        const bool decides = mayBeOutside ? -step.clearanceM < bridged : step.clearanceM < limit;
        if (decides && bridged > kFinestM) {
            const Placed between = halfWay(a, b);
            move(moved, a, between);
            move(moved, between, b);
            return;
        }
        if (step.clearanceM < found_.clearanceM) {
            found_.clearanceM = step.clearanceM;
            found_.place = step.place;
            found_.beyondLand = step.beyondLand;
        }
        if (mayBeOutside) {
            found_.suspects[moved.group].push_back(std::move(hull));
        }
        smallest_.lowerTo(found_.clearanceM);
    }

    static Placed placeOf(const MovedPart& moved, const MotionState& state) {
        return moved.isTractor ? placed(moved.part, state.position, state.nose)
                               : placed(moved.part, state.implement, state.implementNose);
    }

    SmallestClearance& smallest_;
    SegmentClearance found_;
};

// The implement has layers of its own where it may stand over more than the rest.
enum ClearanceLayer : std::size_t { kOpen, kFootprint, kOpenForImplement, kImplement };

std::uint32_t isSwept(const Depths& depths) {
    return depths[kFootprint] > 0 ? 1 : 0;
}

std::uint32_t isSweptOutside(const Depths& depths) {
    return (depths[kFootprint] > 0 && depths[kOpen] <= 0) ||
                   (depths[kImplement] > 0 && depths[kOpenForImplement] <= 0)
               ? 1
               : 0;
}

Result<MultiPolygon> outlineOf(const LayeredPolygons& layers, Point along, const JobContext& job) {
    return measureRegions(layers, along, {.at = isSwept, .count = 1, .traced = 1}, job)
        .transform([](std::vector<MeasuredRegion>&& regions) { return std::move(regions.front().polygons); });
}

/// The outline of the area that the suspects of one segment sweep. Each suspect moves on by a few centimetres
/// only. Without the part that it shares with the one before, little overlap remains. A group of 16 soon
/// becomes a polygon with few corners.
/// @param groups  of the suspects
Result<MultiPolygon> outlineOf(std::span<const std::vector<Ring>> groups, Point along,
                               const JobContext& job) {
    constexpr std::size_t kAtATime = 16;
    LayeredPolygons outlines;
    for (const std::vector<Ring>& hulls : groups) {
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
/// @param forImplement  its own area; null if it is the same
Result<Area> areaOutside(const std::vector<SegmentClearance>& segments, const MultiPolygon& open,
                         const MultiPolygon* forImplement, Point along, const JobContext& job) {
    using Groups = std::span<const std::vector<Ring>>;
    std::vector<std::pair<ClearanceLayer, Groups>> suspects;
    for (const SegmentClearance& segment : segments) {
        const Groups all{segment.suspects};
        if (forImplement == nullptr) {
            if (segment.isSuspect()) {
                suspects.emplace_back(kFootprint, all);
            }
            continue;
        }
        for (const auto& [layer, group] :
             {std::pair{kFootprint, all.first(1)}, std::pair{kImplement, all.last(1)}}) {
            if (!group.front().empty()) {
                suspects.emplace_back(layer, group);
            }
        }
    }
    if (suspects.empty()) {
        return Area{};
    }
    const auto outlines = parallelMap<std::optional<Result<MultiPolygon>>>(
        suspects.size(), [&](std::size_t i) { return outlineOf(suspects[i].second, along, job); }, job);
    if (!outlines) {
        return std::unexpected(outlines.error());
    }
    LayeredPolygons layers;
    layers.add(kOpen, open);
    if (forImplement != nullptr) {
        layers.add(kOpenForImplement, *forImplement);
    }
    for (std::size_t i = 0; i < suspects.size(); ++i) {
        const Result<MultiPolygon>& outline = *(*outlines)[i];
        if (!outline) {
            return std::unexpected(outline.error());
        }
        layers.add(suspects[i].first, *outline);
    }
    return measureRegions(layers, along, {.at = isSweptOutside, .count = 1}, job)
        .transform([](const std::vector<MeasuredRegion>& regions) { return regions.front().area; });
}

/// The parts that are moved along a segment.
using PartsOf = std::function<std::vector<MovedPart>(std::size_t segment)>;

SegmentClearance clearanceOf(const SegmentMotion& motion, std::size_t segment, std::size_t turnsAs,
                             const PartsOf& parts, SmallestClearance& smallest, const JobContext& job) {
    const std::vector<MovedPart> turning =
        motion.turnOnTheSpot.empty() ? std::vector<MovedPart>{} : parts(turnsAs);
    return SegmentSweep{smallest}.run(motion, turning, parts(segment), job);
}

/// Clearance and area outside of these parts.
Result<ClearanceReport> clearanceOf(std::span<const PathSegment> path,
                                    const std::vector<SegmentMotion>& motions, const PartsOf& parts,
                                    const MultiPolygon& open, const MultiPolygon* forImplement,
                                    const JobContext& job) {
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
                return clearanceOf(motions[i], i, turnsOnTheSpotAs(path, i), parts, smallest, look);
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
    const auto outside =
        areaOutside(report.segments, open, forImplement, mainDirection(motions), job.part(0.9, 1.0));
    if (!outside) {
        return std::unexpected(outside.error());
    }
    report.outside = *outside;
    return report;
}

/// What the implement sweeps outside of the drivable area, whether it may or not.
Result<void> addOverhang(std::span<const PathSegment> path, const std::vector<SegmentMotion>& motions,
                         const PartsOf& implement, const OpenLand& drivable, const JobContext& job,
                         ClearanceReport& report) {
    return clearanceOf(path, motions, implement, drivable.open, nullptr, job)
        .transform([&](const ClearanceReport& over) {
            report.overhangArea = over.outside;
            for (const SegmentClearance& segment : over.segments) {
                if (metres(-segment.clearanceM) > report.overhang) {
                    report.overhang = metres(-segment.clearanceM);
                    report.overhangPlace = segment.place;
                }
            }
        });
}

}  // namespace

Result<ClearanceReport> measureClearance(const AuditInput& input, const std::vector<SegmentMotion>& motions,
                                         const JobContext& job) {
    return clearanceLand(input, job).and_then([&](const ClearanceLand& land) {
        return measureClearance(input, land, motions, job);
    });
}

Result<ClearanceReport> measureClearance(const AuditInput& input, const ClearanceLand& against,
                                         const std::vector<SegmentMotion>& motions, const JobContext& job) {
    const OpenLand& drivable = against.drivable;
    const OpenLand* const overhung = against.overhung ? &*against.overhung : nullptr;
    const Footprint footprint = footprintOf(*input.machine);
    const bool isTrailed = input.machine->spec().implement.mounting == Mounting::Trailed;
    const auto implementAt = [&](std::size_t i, const OpenLand& land) -> MovedPart {
        const PathSegment& segment = input.segments[i];
        const bool isFolded = segment.folded || isWayInOrOut(input.segments, i);
        const FootprintPart& part = segment.implementDown ? footprint.lowered
                                    : isFolded            ? footprint.folded
                                                          : footprint.raised;
        return {.part = part, .meter = land.meter, .group = 1};
    };
    const auto all = [&](std::size_t i) {
        std::vector<MovedPart> parts{{.part = footprint.tractor, .meter = drivable.meter, .isTractor = true}};
        if (overhung != nullptr && isTrailed) {
            parts.push_back({.part = footprint.wheels, .meter = drivable.meter});
        }
        parts.push_back(implementAt(i, overhung != nullptr ? *overhung : drivable));
        return parts;
    };
    auto report = clearanceOf(input.segments, motions, all, drivable.open,
                              overhung != nullptr ? &overhung->open : nullptr,
                              overhung != nullptr ? job.part(0.0, 0.6) : job);
    if (report && overhung != nullptr) {
        const auto implement = [&](std::size_t i) { return std::vector{implementAt(i, drivable)}; };
        if (auto added =
                addOverhang(input.segments, motions, implement, drivable, job.part(0.6, 1.0), *report);
            !added) {
            return std::unexpected(added.error());
        }
    }
    return report;
}

}  // namespace furrow
