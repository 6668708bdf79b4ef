#include "planner/plan/turn_options.h"

#include "planner/audit/clearance.h"
#include "planner/path/turn_shape.h"
#include "planner/plan/audit_input.h"
#include "planner/plan/ground.h"
#include "planner/plan/ways_room.h"
#include "planner/turns/methods.h"
#include "planner/turns/straight_turn.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <ranges>
#include <span>

namespace furrow {

namespace {

Pose poseOf(const PathSample& sample) {
    return {sample.position, Angle::fromSi(sample.headingRad)};
}

/// The way of tractor and implement from the pass before the turn on: a trailed one comes into the turn as it
/// was pulled. Only the turn itself is measured.
Result<Length> clearanceOf(const Plan& plan, const DrivenTurn& turn, const JobContext& job) {
    AuditInput input = auditInput(plan);
    const std::span<const PathSegment> all{plan.path.segments};
    const std::size_t before = turn.firstSegment > 0 ? 1 : 0;
    input.segments = all.subspan(turn.firstSegment - before, turn.segmentCount + before);
    auto motions = followPath(input, shapeOf(input), job);
    if (!motions) {
        return std::unexpected(motions.error());
    }
    motions->erase(motions->begin(), motions->begin() + static_cast<std::ptrdiff_t>(before));
    input.segments = all.subspan(turn.firstSegment, turn.segmentCount);
    return measureClearance(input, *motions, job).transform([](const ClearanceReport& report) {
        return report.smallest;
    });
}

Result<std::vector<TurnOption>> othersThan(const Plan& plan, const DrivenTurn& turn, const JobContext& job) {
    const PlanRequest& request = plan.request;
    const auto ground = groundOf(request, job);
    if (!ground) {
        return std::unexpected(ground.error());
    }
    DrivingRooms rooms;
    const auto ways =
        waysRoom(rooms, request, std::make_shared<const Ground>(*ground), plan.headland.mainland, job);
    if (!ways) {
        return std::unexpected(ways.error());
    }
    const auto& segments = plan.path.segments;
    const Pose from = poseOf(segments[turn.firstSegment].samples.front());
    const Pose to = poseOf(segments[turn.firstSegment + turn.segmentCount - 1].samples.back());
    std::vector<TurnOption> others;
    for (const Method<TurnPlanner>* const kind : kTurnMethods) {
        if (kind->traits.isAnyKind || kind->info.id == segments[turn.firstSegment].turnType) {
            continue;
        }
        const Curve free = kind->run(from, to, request.machine);
        // Another kind takes the place of one that the machine or the poses do not allow.
        if (free.type != kind->info.id) {
            continue;
        }
        others.push_back({.name = Message{kind->info.name},
                          .duration = roughDuration(free, from, to, request.machine),
                          .fits = ways->room->raised->byOne(*kind, from, to).has_value()});
    }
    std::ranges::stable_sort(
        others, {}, [](const TurnOption& option) { return std::pair{!option.fits, option.duration.si()}; });
    return others;
}

}  // namespace

Result<std::optional<TurnOptions>> turnOptions(const Plan& plan, std::size_t segment, const JobContext& job) {
    for (const DrivenTurn& turn : drivenTurns(plan.path)) {
        if (segment < turn.firstSegment || segment >= turn.firstSegment + turn.segmentCount) {
            continue;
        }
        TurnOptions options;
        const auto clearance = clearanceOf(plan, turn, job);
        if (!clearance) {
            return std::unexpected(clearance.error());
        }
        options.clearance = *clearance;
        auto others = othersThan(plan, turn, job);
        if (!others) {
            return std::unexpected(others.error());
        }
        options.others = *std::move(others);
        return options;
    }
    return std::nullopt;
}

}  // namespace furrow
