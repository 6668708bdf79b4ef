#include "planner/plan/finish_stage.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"
#include "planner/geometry/tolerances.h"
#include "planner/headland/finishing_passes.h"
#include "planner/headland/headland_passes.h"
#include "planner/path/blocking.h"
#include "planner/path/pass_placing.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/swath_stage.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

// Short passes are added until no more than this is left: below the limits from which the audit blocks a
// plan.
constexpr double kMayStayShare = 0.009;
constexpr Area kMayStayInOnePiece = squareMetres(95.0);
constexpr int kFinishingRounds = 10;
// A driven line begins within this distance of its pass: steering moves it a little.
constexpr double kSteeredAsideM = 0.5;
// Passes that as driven work no more than this together are taken out again.
constexpr Area kWorksNothing = squareMetres(0.1);

/// Ways and passes that leave where the machine may be.
std::ptrdiff_t outsideIn(const Driven& driven) {
    return std::ranges::count(driven.path.segments, false, &PathSegment::drivable);
}

bool leavesTooMuch(const Driven& driven) {
    return std::ranges::contains(driven.findings, FindingKind::Missed, &Finding::kind);
}

/// Of these passes, those that leave where the machine may be, or whose ways in or out do.
std::vector<HeadlandPass> leadingOutside(const Path& path, const std::vector<HeadlandPass>& passes) {
    std::vector<HeadlandPass> outside;
    const auto begins = [](const PathSegment* segment, const HeadlandPass& pass) {
        const auto isFirst = [&](Point end) {
            return distance(segment->samples.front().position, end) < kSteeredAsideM;
        };
        // A pass may be driven either way.
        const Curve& line = pass.stretches.front().line;
        return segment != nullptr && (isFirst(line.start.position) || isFirst(line.end().position));
    };
    for (const HeadlandPass& pass : passes) {
        const auto isOutside = [&](std::size_t i) {
            const PathSegment& segment = path.segments[i];
            return !segment.drivable &&
                   (begins(&segment, pass) || (!segment.implementDown && (begins(path.workBefore(i), pass) ||
                                                                          begins(path.workAfter(i), pass))));
        };
        if (std::ranges::any_of(std::views::iota(std::size_t{0}, path.segments.size()), isOutside)) {
            outside.push_back(pass);
        }
    }
    return outside;
}

/// What blocks a plan, other than land that is left, and did not block it without some passes.
std::vector<Point> newlyBlockedPlaces(const Driven& with, const Driven& without) {
    std::vector<Point> places;
    for (const Finding& finding : with.findings) {
        const auto isSame = [&](const Finding& other) {
            return other.kind == finding.kind && distance(other.place, finding.place) < kSteeredAsideM;
        };
        if (isLasting(finding) && std::ranges::none_of(without.findings, isSame)) {
            places.push_back(finding.place);
        }
    }
    return places;
}

/// The pass nearest to each of these places.
std::vector<HeadlandPass> nearestTo(const std::vector<Point>& places,
                                    const std::vector<HeadlandPass>& passes) {
    std::vector<HeadlandPass> nearest;
    for (const Point place : places) {
        const auto fromPlaceM = [&](const HeadlandPass& pass) {
            const Curve& line = pass.stretches.front().line;
            return distanceToSegment(place, line.start.position, line.end().position);
        };
        nearest.push_back(*std::ranges::min_element(passes, {}, fromPlaceM));
    }
    return nearest;
}

/// Whether more is blocked with some passes than without.
bool isWorse(const Driven& with, const Driven& without) {
    return blockingCount(with.findings) > blockingCount(without.findings) ||
           lastingCount(with.findings) > lastingCount(without.findings) ||
           outsideIn(with) > outsideIn(without);
}

/// The passes because of which a plan is worse with all of them, if it can be told.
std::vector<HeadlandPass> blamedPasses(const Driven& with, const Driven& without,
                                       const std::vector<HeadlandPass>& passes) {
    std::vector<HeadlandPass> outside = leadingOutside(with.path, passes);
    return outside.empty() ? nearestTo(newlyBlockedPlaces(with, without), passes) : outside;
}

/// Beside obstacles that swaths stop short of, too, where there is no headland; and beside the boundary if
/// the machine turns on the spot at their ends.
bool mayFinish(const DriveTask& task) {
    const Settings& settings = task.request.settings;
    const Headland& headland = task.headland;
    if (!settings.flag(kStayInside)) {
        return settings.flag(kHeadlandFinish) && headland.passes == 0;
    }
    const bool turnsAtEnds = headland.width <= task.ground->margin && turnsOnTheSpotInside(task.request);
    return settings.flag(kHeadlandFinish) && (turnsAtEnds || !headland.drivenPasses.empty());
}

/// Whether ways lead to a pass and on, raised ones if there are such.
PassAccess accessByAnyWay(const Curve& line, const std::vector<Leg>& legs, const std::vector<Pose>& ends,
                          RememberedWays& ways, FoldingWays* folding, const JobContext& job) {
    const PassAccess access = accessTo(line, legs, ends, ways, job);
    return folding == nullptr || access == PassAccess::There
               ? access
               : accessTo(line, legs, ends, folding->either, job);
}

/// Passes on full lock, for machines that cannot reverse.
Result<std::optional<FullLockPasses>> fullLockPasses(const DriveTask& task, const Rig& lowered,
                                                     const std::vector<Leg>& legs,
                                                     const std::vector<Pose>& ends, RememberedWays& ways,
                                                     FoldingWays* folding, const AllowedAreas& ground,
                                                     const std::shared_ptr<FullLockTrials>& trials,
                                                     const JobContext& job) {
    const Machine& machine = task.request.machine;
    if (canReverse(machine) || machine.spec().tractor.canTurnInPlace) {
        return std::optional<FullLockPasses>{};
    }
    return FullLockPasses::of(
               ground, lowered,
               [&legs, &ends, &ways, folding, job](const Curve& line) {
                   return accessByAnyWay(line, legs, ends, ways, folding, job);
               },
               job, trials)
        .transform([](FullLockPasses&& made) { return std::optional{std::move(made)}; });
}

}  // namespace

Result<Driven> finishStage(const DriveTask& task, Driven driven, std::vector<Leg>& legs,
                           const PathOverLegs& path, RememberedWays& ways, FoldingWays* folding,
                           const AllowedAreas& ground, std::optional<PlanToBeat> toBeat,
                           const JobContext& job) {
    if (!mayFinish(task) || !leavesTooMuch(driven) || isBeyondMending(driven.findings)) {
        return driven;
    }
    if (toBeat && !mayBeatFinished(*toBeat, task.request.machine, driven)) {
        return std::unexpected(noBetter(*task.request.field));
    }
    const Machine& machine = task.request.machine;
    const auto timeOf = [&](const Driven& one) { return timeForAll(machine, one.path, one.audit); };
    const Duration before = timeOf(driven);
    const Area left = driven.audit.left;
    const Rig lowered{ground, task.request.machine, ImplementAt::Lowered};
    std::vector<Pose> ends = endsOf(legs);
    auto bends = fullLockPasses(task, lowered, legs, ends, ways, folding, ground, path.room().bends, job);
    if (!bends) {
        return std::unexpected(bends.error());
    }
    const MultiPolygon& workable = task.request.field->workable();
    const Length margin = task.ground->margin;
    const auto land =
        margin > Length{} ? eroded(workable, margin, kArcTolerance, job) : Result<MultiPolygon>{workable};
    if (!land) {
        return std::unexpected(land.error());
    }
    std::vector<PassStretch> refused;
    const auto refuse = [&refused](const HeadlandPass& pass) { refused.push_back(pass.stretches.front()); };
    bool untilTheLeast = false;  // once the passes that work much are there, or there are none
    for (int round = 0; round < kFinishingRounds && leavesTooMuch(driven); ++round) {
        const JobContext part =
            job.part(static_cast<double>(round) / kFinishingRounds, (round + 1.0) / kFinishingRounds);
        const Area hairs = driven.audit.left - area(driven.audit.leftAreas);
        const auto passes = finishingPasses({.workable = *land,
                                             .left = driven.audit.leftAreas,
                                             .mayStay = kMayStayShare * driven.audit.workable - hairs,
                                             .mayStayInOnePiece = kMayStayInOnePiece,
                                             .lowered = lowered,
                                             .bends = *bends ? &**bends : nullptr,
                                             .leftOnPurpose = driven.leftOnPurpose,
                                             .refused = refused,
                                             .most = kMostFinishingPasses - driven.finishing.size(),
                                             .untilTheLeast = untilTheLeast},
                                            part.part(0.0, 0.2));
        if (!passes) {
            return std::unexpected(passes.error());
        }
        FinishedLegs more = withFinishingPasses(legs, *passes, ways, machine, part);
        if (folding != nullptr && !more.refused.empty()) {
            FinishedLegs folded =
                withFinishingPasses(std::move(more.legs), more.refused, folding->either, machine, part);
            more.legs = std::move(folded.legs);
            more.refused = std::move(folded.refused);
            std::ranges::move(folded.put, std::back_inserter(more.put));
        }
        std::ranges::for_each(more.refused, refuse);
        if (more.put.empty()) {
            if (more.refused.empty() && std::exchange(untilTheLeast, true)) {
                break;
            }
            continue;
        }
        std::vector<HeadlandPass> finishing = driven.finishing;
        finishing.insert(finishing.end(), more.put.begin(), more.put.end());
        auto finished = path.drive(more.legs, std::move(finishing), toBeat, part.part(0.2, 1.0));
        if (!finished) {
            return finished;
        }
        finished->auditing += driven.auditing;
        if (isWorse(*finished, driven)) {
            const std::vector<HeadlandPass> blamed = blamedPasses(*finished, driven, more.put);
            if (blamed.empty()) {
                break;
            }
            std::ranges::for_each(blamed, refuse);
            continue;
        }
        if (leavesTooMuch(*finished) && finished->audit.left > driven.audit.left - kWorksNothing) {
            std::ranges::for_each(more.put, refuse);
            continue;
        }
        driven = *std::move(finished);
        legs = std::move(more.legs);
        ends = endsOf(legs);
        untilTheLeast = true;
    }
    driven.leftBeforeFinishing = left;
    driven.finishingCost = timeOf(driven) - before;
    return driven;
}

}  // namespace furrow
