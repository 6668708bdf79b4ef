#include "planner/path/path_builder.h"

#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"
#include "planner/turns/connection.h"
#include "planner/turns/manoeuvre_search.h"

#include <cmath>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr double kSameHeadingRad = 1e-9;

bool isSamePose(const Pose& a, const Pose& b) {
    return distance(a.position, b.position) < kMeetM &&
           dot(direction(a.heading.si()), direction(b.heading.si())) > 1.0 - kSameHeadingRad;
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
    const Length longest = longestTurn(machine);
    auto ways = parallelMap<std::optional<Leg>>(
        gaps,
        [&](std::size_t i) -> std::optional<Leg> {
            if (isSamePose(legs[i].line.end(), legs[i + 1].line.start)) {
                return std::nullopt;
            }
            auto [turn, folded] = way(legs[i], legs[i + 1], job);
            const bool isTransfer = (turn.type == kCombinedTurn && turn.length() > longest) ||
                                    legs[i].kind == SegmentKind::Transfer ||
                                    legs[i + 1].kind == SegmentKind::Transfer;
            const bool isTrip =
                legs[i].kind == SegmentKind::Refill || legs[i + 1].kind == SegmentKind::Refill;
            return Leg{.kind = isTrip       ? SegmentKind::Refill
                               : isTransfer ? SegmentKind::Transfer
                                            : SegmentKind::Turn,
                       .number = 0,
                       .line = std::move(turn),
                       .implementDown = false,
                       .folded = folded};
        },
        job);
    if (!ways) {
        return std::unexpected(ways.error());
    }
    std::vector<Leg> all;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        all.push_back(legs[i]);
        if (i < gaps && (*ways)[i]) {
            all.push_back(std::move(*(*ways)[i]));
        }
    }
    return all;
}

}  // namespace furrow
