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

/// Passes over the land that a driven path leaves, round by round.
class FinishingRounds {
public:
    /// What stays the same in all rounds.
    struct Given {
        const DriveTask& task;
        const PathOverLegs& path;
        RememberedWays& ways;
        FoldingWays* folding = nullptr;
        const AllowedAreas& ground;
        const MultiPolygon& land;  ///< that may be worked
        const Rig& lowered;
        const std::optional<PlanToBeat>& toBeat;
    };

    /// @param legs  those of the driven path, before and after
    FinishingRounds(const Given& given, Driven driven, std::vector<Leg>& legs)
        : given_{given}, driven_{std::move(driven)}, legs_{legs}, ends_{endsOf(legs)} {}

    Result<Driven> run(const JobContext& job) && {
        auto bends = fullLockPasses(given_.task, given_.lowered, legs_, ends_, given_.ways, given_.folding,
                                    given_.ground, given_.path.room().bends, job);
        if (!bends) {
            return std::unexpected(bends.error());
        }
        bends_ = *std::move(bends);
        for (int round = 0; round < kFinishingRounds && leavesTooMuch(driven_); ++round) {
            const auto goesOn = runOne(
                job.part(static_cast<double>(round) / kFinishingRounds, (round + 1.0) / kFinishingRounds));
            if (!goesOn) {
                return std::unexpected(goesOn.error());
            }
            if (!*goesOn) {
                break;
            }
        }
        return std::move(driven_);
    }

private:
    /// False where another round would find nothing.
    Result<bool> runOne(const JobContext& job) {
        const auto passes = passesToTry(job.part(0.0, 0.2));
        if (!passes) {
            return std::unexpected(passes.error());
        }
        PlacedPasses more = placed(*passes, job);
        refuse(more.refused);
        if (more.put.empty()) {
            return !more.refused.empty() || !std::exchange(untilTheLeast_, true);
        }
        std::vector<HeadlandPass> finishing = driven_.finishing;
        finishing.insert(finishing.end(), more.put.begin(), more.put.end());
        auto finished = given_.path.drive(more.legs, std::move(finishing), given_.toBeat, job.part(0.2, 1.0));
        if (!finished) {
            return std::unexpected(finished.error());
        }
        finished->auditing += driven_.auditing;
        if (isWorse(*finished, driven_)) {
            const std::vector<HeadlandPass> blamed = blamedPasses(*finished, driven_, more.put);
            refuse(blamed);
            return !blamed.empty();
        }
        if (leavesTooMuch(*finished) && finished->audit.left > driven_.audit.left - kWorksNothing) {
            refuse(more.put);
            return true;
        }
        driven_ = *std::move(finished);
        legs_ = std::move(more.legs);
        ends_ = endsOf(legs_);
        untilTheLeast_ = true;
        return true;
    }

    Result<std::vector<HeadlandPass>> passesToTry(const JobContext& job) {
        const Area hairs = driven_.audit.left - area(driven_.audit.leftAreas);
        return finishingPasses({.workable = given_.land,
                                .left = driven_.audit.leftAreas,
                                .mayStay = kMayStayShare * driven_.audit.workable - hairs,
                                .mayStayInOnePiece = kMayStayInOnePiece,
                                .lowered = given_.lowered,
                                .bends = bends_ ? &*bends_ : nullptr,
                                .leftOnPurpose = driven_.leftOnPurpose,
                                .refused = refused_,
                                .most = kMostFinishingPasses - driven_.finishing.size(),
                                .untilTheLeast = untilTheLeast_},
                               job);
    }

    /// Those to which no way leads are tried by folded ways, too.
    PlacedPasses placed(const std::vector<HeadlandPass>& passes, const JobContext& job) const {
        const Machine& machine = given_.task.request.machine;
        PlacedPasses more = withPassesBetween(legs_, passes, given_.ways, machine, job);
        if (given_.folding != nullptr && !more.refused.empty()) {
            PlacedPasses folded =
                withPassesBetween(std::move(more.legs), more.refused, given_.folding->either, machine, job);
            more.legs = std::move(folded.legs);
            more.refused = std::move(folded.refused);
            std::ranges::move(folded.put, std::back_inserter(more.put));
        }
        return more;
    }

    void refuse(const std::vector<HeadlandPass>& passes) {
        std::ranges::transform(passes, std::back_inserter(refused_),
                               [](const HeadlandPass& pass) { return pass.stretches.front(); });
    }

    Given given_;
    Driven driven_;
    std::vector<Leg>& legs_;
    std::vector<Pose> ends_;
    std::optional<FullLockPasses> bends_;
    std::vector<PassStretch> refused_;
    bool untilTheLeast_ = false;  ///< once the passes that work much are there, or there are none
};

}  // namespace

Result<Driven> finishStage(const DriveTask& task, Driven driven, std::vector<Leg>& legs,
                           const PathOverLegs& path, RememberedWays& ways, FoldingWays* folding,
                           const AllowedAreas& ground, const std::optional<PlanToBeat>& toBeat,
                           const JobContext& job) {
    if (!mayFinish(task) || !leavesTooMuch(driven) || isBeyondMending(driven.findings)) {
        return driven;
    }
    const Machine& machine = task.request.machine;
    if (toBeat && !mayBeatFinished(*toBeat, machine, driven)) {
        return std::unexpected(noBetter(*task.request.field));
    }
    const auto timeOf = [&](const Driven& one) { return timeForAll(machine, one.path, one.audit); };
    const Duration before = timeOf(driven);
    const Area left = driven.audit.left;
    const MultiPolygon& workable = task.request.field->workable();
    const Length margin = task.ground->margin;
    const auto land =
        margin > Length{} ? eroded(workable, margin, kArcTolerance, job) : Result<MultiPolygon>{workable};
    if (!land) {
        return std::unexpected(land.error());
    }
    const Rig lowered{ground, machine, ImplementAt::Lowered};
    return FinishingRounds{{.task = task,
                            .path = path,
                            .ways = ways,
                            .folding = folding,
                            .ground = ground,
                            .land = *land,
                            .lowered = lowered,
                            .toBeat = toBeat},
                           std::move(driven),
                           legs}
        .run(job)
        .transform([&](Driven&& finished) {
            finished.leftBeforeFinishing = left;
            finished.finishingCost = timeOf(finished) - before;
            return std::move(finished);
        });
}

}  // namespace furrow
