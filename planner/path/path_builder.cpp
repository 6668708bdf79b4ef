#include "planner/path/path_builder.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"
#include "planner/turns/connection.h"
#include "planner/turns/turn_method.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

constexpr double kSameHeadingRad = 1e-9;

bool isSamePose(const Pose& a, const Pose& b) {
    return distance(a.position, b.position) < kMeetM &&
           dot(direction(a.heading.si()), direction(b.heading.si())) > 1.0 - kSameHeadingRad;
}

/// A way as legs of one kind, one for each line between turns on the spot.
std::vector<Leg> legsOf(Curve way, Leg leg) {
    if (std::ranges::none_of(way.pieces,
                             [](const CurvePiece& piece) { return piece.onTheSpot != Angle{}; })) {
        leg.line = std::move(way);
        return {std::move(leg)};
    }
    std::vector<Leg> legs;
    for (Curve& line : betweenTurnsOnTheSpot(way)) {
        leg.line = std::move(line);
        legs.push_back(leg);
    }
    return legs;
}

}  // namespace

std::vector<Leg> swathLegs(const SwathSet& swaths, const Route& route, const Machine& machine) {
    std::vector<Leg> legs;
    legs.reserve(route.steps.size());
    for (const RouteStep& step : route.steps) {
        const Swath& swath = swaths.swaths[step.swath];
        legs.push_back(
            {.kind = SegmentKind::Swath, .number = swath.number, .line = drivenLine(step, swaths, machine)});
    }
    return legs;
}

WayFinder waysBy(TurnPlanner* turn, const Machine& machine) {
    return [turn, &machine](const Leg& leaving, const Leg& arriving, const JobContext&) {
        return WayBetween{.line = connection(leaving.line.end(), arriving.line.start, machine, turn)};
    };
}

Result<std::vector<Leg>> joinedLegs(std::span<const Leg> legs, const Machine& machine, const WayFinder& way,
                                    const JobContext& job) {
    const std::size_t gaps = legs.empty() ? 0 : legs.size() - 1;
    auto ways = parallelMap<std::vector<Leg>>(
        gaps,
        [&](std::size_t i) -> std::vector<Leg> {
            if (isSamePose(legs[i].line.end(), legs[i + 1].line.start)) {
                return {};
            }
            auto [turn, folded] = way(legs[i], legs[i + 1], job);
            const bool isTransfer = isDrivenAsTransfer(turn, machine) ||
                                    legs[i].kind == SegmentKind::Transfer ||
                                    legs[i + 1].kind == SegmentKind::Transfer;
            const bool isTrip =
                legs[i].kind == SegmentKind::Refill || legs[i + 1].kind == SegmentKind::Refill;
            return legsOf(std::move(turn), {.kind = isTrip       ? SegmentKind::Refill
                                                    : isTransfer ? SegmentKind::Transfer
                                                                 : SegmentKind::Turn,
                                            .number = 0,
                                            .line = {},
                                            .implementDown = false,
                                            .folded = folded});
        },
        job);
    if (!ways) {
        return std::unexpected(ways.error());
    }
    std::vector<Leg> all;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        all.push_back(legs[i]);
        if (i < gaps) {
            std::ranges::move((*ways)[i], std::back_inserter(all));
        }
    }
    return all;
}

}  // namespace furrow
