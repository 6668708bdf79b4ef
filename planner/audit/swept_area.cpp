#include "planner/audit/swept_area.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/jobs/parallel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

// Neighbours that share an edge overlap by rounding only.
constexpr double kTouchingM = 1e-6;
constexpr double kReachToleranceM = 0.02;

struct WorkingLine {
    Point right;
    Point left;
};

WorkingLine workingLine(const MotionState& state, double widthM) {
    const Point left = 0.5 * widthM *
                       Point{-std::sin(state.implementHeadingRad), std::cos(state.implementHeadingRad)};
    return {.right = state.implement - left, .left = state.implement + left};
}

Ring counterClockwise(Ring ring) {
    if (signedAreaM2(ring) < 0.0) {
        std::ranges::reverse(ring);
    }
    return ring;
}

/// What a line sweeps on its way from one place to the next: a quadrilateral, or two triangles where it
/// turns about a point of its own.
void addSweep(const WorkingLine& a, const WorkingLine& b, MultiPolygon& swept) {
    constexpr double kNoAreaM2 = 1e-12;
    const auto add = [&](Ring ring) {
        if (std::abs(signedAreaM2(ring)) > kNoAreaM2) {
            swept.push_back({.outer = counterClockwise(std::move(ring)), .holes = {}});
        }
    };
    const Point across = a.left - a.right;
    const Point acrossNext = b.left - b.right;
    const double turn = cross(across, acrossNext);
    if (turn != 0.0) {
        const double t = cross(b.right - a.right, acrossNext) / turn;
        const double u = cross(b.right - a.right, across) / turn;
        if (t > 0.0 && t < 1.0 && u > 0.0 && u < 1.0) {
            const Point pivot = a.right + t * across;
            add({pivot, a.right, b.right});
            add({pivot, a.left, b.left});
            return;
        }
    }
    add({a.right, b.right, b.left, a.left});
}

/// One segment's sweep, as polygons that do not overlap.
Result<MultiPolygon> sweptBy(const SegmentMotion& motion, double widthM, const JobContext& job) {
    MultiPolygon pieces;
    for (std::size_t i = 1; i < motion.states.size(); ++i) {
        addSweep(workingLine(motion.states[i - 1], widthM), workingLine(motion.states[i], widthM), pieces);
    }
    return pieces.size() < 2 ? Result<MultiPolygon>{std::move(pieces)} : unionOf(pieces, job, kSnapGrid);
}

/// Chords of a turning line's ends: two thirds of the sagitta, on both sides.
double chordErrorM2(const SegmentMotion& motion, double widthM) {
    double sum = 0.0;
    for (std::size_t i = 1; i < motion.states.size(); ++i) {
        const MotionState& a = motion.states[i - 1];
        const MotionState& b = motion.states[i];
        const double turn =
            std::abs(std::remainder(b.implementHeadingRad - a.implementHeadingRad, 2.0 * std::numbers::pi));
        const WorkingLine from = workingLine(a, widthM);
        const WorkingLine to = workingLine(b, widthM);
        for (const double chord : {distance(from.left, to.left), distance(from.right, to.right)}) {
            sum += 2.0 / 3.0 * chord * std::min(chord * turn / 8.0, kChordErrorM);
        }
    }
    return sum;
}

Bounds boundsIn(const MultiPolygon& polygons, Point along) {
    Bounds box{.min = {1e300, 1e300}, .max = {-1e300, -1e300}};
    for (const Polygon& polygon : polygons) {
        for (const Point& point : polygon.outer) {
            const Point at{dot(point, along), cross(along, point)};
            box.min = {std::min(box.min.x, at.x), std::min(box.min.y, at.y)};
            box.max = {std::max(box.max.x, at.x), std::max(box.max.y, at.y)};
        }
    }
    return box;
}

bool overlap(const Bounds& a, const Bounds& b) {
    return a.min.x < b.max.x - kTouchingM && b.min.x < a.max.x - kTouchingM &&
           a.min.y < b.max.y - kTouchingM && b.min.y < a.max.y - kTouchingM;
}

/// Two single quadrilaterals may be told apart by the sides of either; anything else is for GEOS.
bool mayOverlap(const MultiPolygon& a, const MultiPolygon& b) {
    if (a.size() != 1 || b.size() != 1 || a.front().outer.size() != 4 || b.front().outer.size() != 4) {
        return true;
    }
    const auto apart = [](const Ring& sides, const Ring& other) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Point side = sides[(i + 1) % 4] - sides[i];
            const double length = norm(side);
            if (length > 0.0 && std::ranges::all_of(other, [&](Point point) {
                    return cross(side, point - sides[i]) < kTouchingM * length;
                })) {
                return true;
            }
        }
        return false;
    };
    return !apart(a.front().outer, b.front().outer) && !apart(b.front().outer, a.front().outer);
}

/// The heading in which most of the work is done: boxes along it hardly overlap.
Point mainDirection(const std::vector<SegmentMotion>& motions) {
    double longest = 0.0;
    Point along{1.0, 0.0};
    for (const SegmentMotion& motion : motions) {
        for (std::size_t i = 1; i < motion.states.size(); ++i) {
            const Point way = motion.states[i].implement - motion.states[i - 1].implement;
            if (norm(way) > longest) {
                longest = norm(way);
                along = (1.0 / longest) * way;
            }
        }
    }
    return along;
}

struct Overlap {
    Area all;
    Area headland;
};

/// The union of what every two passes share is what is swept at least twice.
Result<Overlap> overlapOf(const AuditInput& input, const std::vector<MultiPolygon>& passes, Point along,
                          const JobContext& job) {
    struct Boxed {
        std::size_t pass;
        Bounds box;
    };
    std::vector<Boxed> boxes;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        if (!passes[i].empty()) {
            boxes.push_back({i, boundsIn(passes[i], along)});
        }
    }
    std::ranges::stable_sort(boxes, {}, [](const Boxed& boxed) { return boxed.box.min.y; });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < boxes.size(); ++a) {
        for (std::size_t b = a + 1; b < boxes.size() && boxes[b].box.min.y < boxes[a].box.max.y; ++b) {
            if (overlap(boxes[a].box, boxes[b].box) &&
                mayOverlap(passes[boxes[a].pass], passes[boxes[b].pass])) {
                pairs.emplace_back(boxes[a].pass, boxes[b].pass);
            }
        }
    }
    const auto shared = parallelMap<std::optional<Result<MultiPolygon>>>(
        pairs.size(),
        [&](std::size_t k) -> std::optional<Result<MultiPolygon>> {
            return intersection(passes[pairs[k].first], passes[pairs[k].second], job, kSnapGrid);
        },
        job);
    if (!shared) {
        return std::unexpected(shared.error());
    }
    MultiPolygon twice;
    MultiPolygon headland;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const Result<MultiPolygon>& common = *(*shared)[k];
        if (!common) {
            return std::unexpected(common.error());
        }
        std::ranges::copy(*common, std::back_inserter(twice));
        const auto isHeadland = [&](std::size_t i) {
            return input.segments[i].kind == SegmentKind::HeadlandPass;
        };
        if (isHeadland(pairs[k].first) != isHeadland(pairs[k].second)) {
            std::ranges::copy(*common, std::back_inserter(headland));
        }
    }
    Overlap result;
    for (auto [polygons, sum] : {std::pair{&twice, &result.all}, std::pair{&headland, &result.headland}}) {
        if (polygons->empty()) {
            continue;
        }
        const auto merged = unionOf(*polygons, job, kSnapGrid);
        const auto inside = merged ? intersection(*merged, input.workable, job, kSnapGrid) : merged;
        if (!inside) {
            return std::unexpected(inside.error());
        }
        *sum = area(*inside);
    }
    return result;
}

/// Where a disc of half the working footprint's width fits without leaving the drivable area.
Result<MultiPolygon> reachable(const AuditInput& input, const JobContext& job) {
    const Length half = 0.5 * input.machine->workingFootprintWidth();
    const auto middles = eroded(input.drivable, half, metres(kReachToleranceM), job);
    const auto opened = middles ? dilated(*middles, half, metres(kReachToleranceM), job) : middles;
    return opened ? intersection(*opened, input.workable, job, kSnapGrid) : opened;
}

}  // namespace

Result<SweptArea> measureSweptArea(const AuditInput& input, const MachineShape& shape,
                                   const std::vector<SegmentMotion>& motions, const JobContext& job) {
    const double widthM = shape.operatingWidthM;
    const auto swept = parallelMap<std::optional<Result<MultiPolygon>>>(
        motions.size(),
        [&](std::size_t i) -> std::optional<Result<MultiPolygon>> {
            return input.segments[i].implementDown ? sweptBy(motions[i], widthM, job) : MultiPolygon{};
        },
        job);
    if (!swept) {
        return std::unexpected(swept.error());
    }
    SweptArea result;
    MultiPolygon all;
    double errorM2 = 1e-9 * area(input.workable).si();
    double lengthM = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        const Result<MultiPolygon>& pass = *(*swept)[i];
        if (!pass) {
            return std::unexpected(pass.error());
        }
        std::ranges::copy(*pass, std::back_inserter(all));
        result.passes.push_back(*pass);
        if (input.segments[i].implementDown) {
            errorM2 += chordErrorM2(motions[i], widthM);
            for (std::size_t k = 1; k < motions[i].states.size(); ++k) {
                lengthM += distance(motions[i].states[k - 1].implement, motions[i].states[k].implement);
            }
        }
    }
    // A rounded coordinate moves both sides of a pass.
    result.error = squareMetres(errorM2 + 2.0 * lengthM * input.positionRounding.si());

    const auto merged = unionOf(all, job, kSnapGrid);
    if (!merged) {
        return std::unexpected(merged.error());
    }
    const auto covered = intersection(*merged, input.workable, job, kSnapGrid);
    auto missed = covered ? difference(input.workable, *merged, job, kSnapGrid) : covered;
    if (!missed) {
        return std::unexpected(missed.error());
    }
    result.covered = area(*covered);
    result.missedArea = area(*missed);
    const auto twice = overlapOf(input, result.passes, mainDirection(motions), job);
    if (!twice) {
        return std::unexpected(twice.error());
    }
    result.overlap = twice->all;
    result.overlapHeadland = twice->headland;
    result.missedWithinReach = *missed;
    if (input.machine) {
        const auto reach = reachable(input, job);
        auto within = reach ? intersection(*missed, *reach, job, kSnapGrid) : reach;
        if (!within) {
            return std::unexpected(within.error());
        }
        if (const Area whole = area(*reach); whole > squareMetres(0.0)) {
            result.coveredOfReachable = std::clamp(1.0 - area(*within) / whole, 0.0, 1.0);
        }
        result.missedWithinReach = std::move(*within);
    }
    result.missed = std::move(*missed);
    return result;
}

}  // namespace furrow
