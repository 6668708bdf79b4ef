#include "planner/headland/closed_rings.h"

#include "planner/headland/headland_passes.h"
#include "planner/headland/pass_tracks.h"
#include "planner/turns/trailer.h"
#include "planner/turns/turn_method.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// Largest share of the field that a rounded outermost pass may leave at its corners. If it would leave more,
// a machine that can reverse drives into the corners.
constexpr double kMostUncutShare = 0.004;
// Largest area left at a corner between two passes.
constexpr Area kMostUncutInside = squareMetres(50.0);

/// Rules for the corners of a ring.
struct CornerRules {
    CornerMethod method = CornerMethod::Rounded;
    std::vector<Point> driven;  ///< with CornerMethod::Searched: only these corners
    Length beside;              ///< distance kept from the edge
    bool followsEdges = true;   ///< otherwise its corners are the arcs of their rounding
    bool movesIn = true;        ///< where tail or nose would swing out
};

/// From the middle of a corner to its ends.
double cornerReachM(const Machine& machine) {
    return machine.minTurningRadius().si() + 0.5 * machine.workingFootprintWidth().si();
}

bool isAt(const RoundedCorner& corner, Point place, const Machine& machine) {
    return distance(corner.place, place) < cornerReachM(machine);
}

Result<ClosedRing> ringWith(const PassTask& task, Length inset, int ring, const CornerRules& corners,
                            CornerWays& ways, const JobContext& job) {
    const Machine& machine = task.machine;
    const auto tracks =
        passTracks(task.workable, inset + corners.beside, task.drivable, machine,
                   {.beside = corners.beside,
                    .driven = corners.driven,
                    .followsEdges = corners.followsEdges,
                    .movesIn = corners.movesIn,
                    .isSteered = corners.movesIn && (corners.method == CornerMethod::Rounded ||
                                                     corners.method == CornerMethod::Searched)},
                   job);
    if (!tracks) {
        return std::unexpected(tracks.error());
    }
    const auto wanted = [&](const RoundedCorner& corner) {
        return corners.method != CornerMethod::Searched ||
               std::ranges::any_of(corners.driven, [&](Point place) { return isAt(corner, place, machine); });
    };
    ClosedRing result{.passes = {},
                      .rounded = {},
                      .movedIn = tracks->movedIn,
                      .complete = tracks->givenUp == 0,
                      .inside = tracks->inside};
    result.lines = tracks->lines;
    for (const Curve& line : result.lines) {
        result.passes.push_back({.ring = ring,
                                 .width = machine.operatingWidth(),
                                 .closed = true,
                                 .stretches = withCorners(line, corners.method, task.drivable, machine,
                                                          wanted, ways, result.rounded, job)});
        for (const PassStretch& stretch : result.passes.back().stretches) {
            if (corners.method == CornerMethod::Searched && stretch.working) {
                std::ranges::move(placesOutside(stretch.line, task.drivable, machine, job),
                                  std::back_inserter(result.outside));
            }
        }
    }
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    return result;
}

/// Corners of the field, without those of obstacles and those that point into the field.
std::vector<RoundedCorner> outwardCorners(const ClosedRing& ring) {
    std::vector<RoundedCorner> outward;
    std::ranges::copy_if(ring.rounded, std::back_inserter(outward),
                         [](const RoundedCorner& corner) { return corner.turn > radians(0.0); });
    return outward;
}

/// The area uncut at rounded corners: the rounding itself, and a strip along both sides. The swing of tail or
/// nose keeps the machine away from that strip, which narrows to nothing within the overhang.
Area leftAt(const std::vector<RoundedCorner>& corners, const Machine& machine) {
    double overhangM = 0.0;
    for (const Point& corner : machine.workingFootprint()) {
        overhangM = std::max(overhangM, std::abs(corner.x));
    }
    const double besideM = cornerReachM(machine);
    const double swingM = std::hypot(besideM, overhangM) - besideM;
    Area sum;
    for (const RoundedCorner& corner : corners) {
        sum +=
            uncutCorner(corner, machine.operatingWidth()) +
            squareMetres(2.0 * swingM * (overhangM + besideM * std::tan(0.25 * std::abs(corner.turn.si()))));
    }
    return sum;
}

/// A ring that is driven into the corners from which the machine can leave. Empty if there are none.
Result<std::optional<ClosedRing>> withCornersDriven(const PassTask& task, Length inset, int ring,
                                                    const std::vector<RoundedCorner>& wanted, Length beside,
                                                    CornerWays& ways, const JobContext& job) {
    CornerRules corners{
        .method = CornerMethod::Searched, .driven = {}, .beside = beside, .followsEdges = ring == 0};
    std::ranges::transform(wanted, std::back_inserter(corners.driven), &RoundedCorner::place);
    while (!corners.driven.empty()) {
        auto sharp = ringWith(task, inset, ring, corners, ways, job);
        if (!sharp) {
            return std::unexpected(sharp.error());
        }
        const auto failed = std::erase_if(corners.driven, [&](Point place) {
            return std::ranges::any_of(sharp->rounded, [&](const RoundedCorner& corner) {
                return isAt(corner, place, task.machine);
            });
        });
        if (failed > 0) {
            continue;
        }
        if (sharp->outside.empty()) {
            return std::move(*sharp);
        }
        for (const Point place : sharp->outside) {
            if (!corners.driven.empty()) {
                corners.driven.erase(std::ranges::min_element(
                    corners.driven, {}, [place](Point corner) { return distance(corner, place); }));
            }
        }
    }
    return std::nullopt;
}

/// The outermost pass, rounded. If that leaves too much, a machine that can reverse drives into the corners
/// that it can leave.
Result<ClosedRing> outermostRing(const PassTask& task, Length inset, CornerWays& ways,
                                 const JobContext& job) {
    std::vector<RoundedCorner> arcCorners;
    // The corners and their uncut area are measured before the line follows the edges.
    if (!Trailer::of(task.machine)) {
        auto arcs = ringWith(task, inset, 0, {.followsEdges = false, .movesIn = false}, ways, job);
        if (!arcs) {
            return arcs;
        }
        const std::vector<RoundedCorner> outward = outwardCorners(*arcs);
        if (canReverse(task.machine) && arcs->complete &&
            leftAt(outward, task.machine) > kMostUncutShare * area(task.workable)) {
            auto driven = withCornersDriven(task, inset, 0, outward, kBesideEdge, ways, job);
            if (!driven) {
                return std::unexpected(driven.error());
            }
            if (*driven && (*driven)->complete) {
                return std::move(**driven);
            }
        }
        arcCorners = std::move(arcs->rounded);
    }
    auto rounded = ringWith(task, inset, 0, {}, ways, job);
    if (rounded && !rounded->complete) {
        rounded = ringWith(task, inset, 0, {.followsEdges = false}, ways, job);
    }
    if (rounded && rounded->complete && !Trailer::of(task.machine)) {
        rounded->rounded = std::move(arcCorners);
    }
    return rounded;
}

/// An inner pass of a machine that cannot reverse, rounded. At corners where that leaves too much between two
/// passes, the machine drives on and comes back in a loop, since there is room.
Result<ClosedRing> innerRing(const PassTask& task, Length inset, int ring, CornerWays& ways,
                             const JobContext& job) {
    auto rounded = ringWith(task, inset, ring, {.followsEdges = false}, ways, job);
    if (!rounded || !rounded->complete) {
        return rounded;
    }
    std::vector<RoundedCorner> wide = outwardCorners(*rounded);
    std::erase_if(wide, [&](const RoundedCorner& corner) {
        return uncutCorner(corner, task.machine.operatingWidth()) < kMostUncutInside;
    });
    if (wide.empty()) {
        return rounded;
    }
    auto driven = withCornersDriven(task, inset, ring, wide, {}, ways, job);
    if (!driven) {
        return std::unexpected(driven.error());
    }
    return *driven ? std::move(**driven) : std::move(rounded);
}

}  // namespace

Result<ClosedRing> closedRing(const PassTask& task, Length inset, int ring, CornerMethod method,
                              const JobContext& job) {
    CornerWays ways;
    if (method == CornerMethod::Rounded) {
        return ring == 0 ? outermostRing(task, inset, ways, job) : innerRing(task, inset, ring, ways, job);
    }
    return ringWith(task, inset, ring, {.method = method, .driven = {}, .beside = {}, .followsEdges = false},
                    ways, job);
}

}  // namespace furrow
