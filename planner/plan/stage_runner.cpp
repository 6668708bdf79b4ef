#include "planner/plan/stage_runner.h"

#include "planner/field/small_obstacles.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/headland_passes.h"
#include "planner/path/blocking.h"
#include "planner/plan/chosen_turns.h"
#include "planner/plan/drive_stage.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/ground.h"
#include "planner/plan/mainland_parts.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/order_stage.h"
#include "planner/plan/round_stage.h"
#include "planner/plan/stopwatch.h"
#include "planner/plan/swath_stage.h"
#include "planner/swaths/methods.h"

#include <algorithm>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

// Of the progress where obstacles may have to be planned once more.
constexpr double kFirstTry = 0.95;
// Headlands of refused obstacles may refuse others. After so many times all obstacles get one.
constexpr int kMostRefusals = 5;

/// The obstacles that swaths get round. The refused ones get a headland.
std::vector<Ring> without(std::vector<Ring> obstacles, const std::vector<std::size_t>& refused) {
    for (const std::size_t index : refused | std::views::reverse) {
        obstacles.erase(obstacles.begin() + static_cast<std::ptrdiff_t>(index));
    }
    return obstacles;
}

}  // namespace

std::ptrdiff_t PlannedStages::blockingCount() const {
    return furrow::blockingCount(driven->findings);
}

void StageRunner::add(Duration StageTimings::* stage, Duration taken) {
    const std::scoped_lock lock{mutex_};
    timings_.*stage += taken;
}

/// Runs one stage and adds the time it took.
template <class Run>
auto StageRunner::timed(Duration StageTimings::* stage, const Run& run) {
    Stopwatch watch;
    auto result = run();
    add(stage, watch.lap());
    return result;
}

Result<std::shared_ptr<const Headland>> StageRunner::headland(const PlanRequest& request,
                                                              const std::shared_ptr<const Ground>& ground,
                                                              const std::vector<Ring>& filled,
                                                              const MultiPolygon& workable,
                                                              const JobContext& job) {
    // By its name the quickest kind of corner finds the headland that was made with the same.
    PlanRequest named = request;
    named.settings.set(kHeadlandCorner, plannedCorner(request.settings)).value();
    return cache_.headlands.get(named, {ground, filled}, [&](const PlanRequest& asking) {
        const Settings& settings = asking.settings;
        return timed(&StageTimings::headland, [&] {
            return headlandMethod(settings).run(
                {.field = *asking.field,
                 .drivable = ground->drivable,
                 .machine = asking.machine,
                 .turn = turnMethod(settings).run,
                 .settings = settings,
                 .margin = ground->margin,
                 .overhang = settings.length(kOverhang).value_or(Length{}),
                 .drawsOutEnds = drawsOutEnds(settings),
                 .swathEnds = [&](const MultiPolygon& mainland) { return swathEnds(asking, mainland, job); },
                 .along = &workable},
                job);
        });
    });
}

/// The headland is laid without the obstacles that swaths go round; one that swaths do not get round gets a
/// headland after all.
Result<LaidOut> StageRunner::laidOut(const PlanRequest& request, const std::shared_ptr<const Ground>& ground,
                                     std::vector<Ring> round, const JobContext& job) {
    JobContext part = job;
    for (int refusals = 0;; part = job.withoutProgress()) {
        const MultiPolygon workable = filled(request.field->drivable(), round);
        const auto headland = this->headland(request, ground, round, workable, part.part(0.0, 0.12));
        if (!headland) {
            return std::unexpected(headland.error());
        }
        std::vector<Ring> inside =
            insideMainland(round, (*headland)->mainland, ground->margin, request.machine);
        if (inside.size() < round.size()) {
            round = ++refusals < kMostRefusals ? std::move(inside) : std::vector<Ring>{};
            continue;
        }
        const JobContext searching = part.part(0.12, 0.9);
        const MultiPolygon& mainland = (*headland)->mainland;
        const auto found = cache_.searches.get(request, mainland, [&](const PlanRequest& asking) {
            return timed(&StageTimings::swaths, [&] { return swathsByMethod(asking, mainland, searching); });
        });
        if (!found) {
            return std::unexpected(found.error());
        }
        const auto swaths = cache_.swaths.get(
            request, {ground, round, mainland, *found, (*headland)->passes}, [&](const PlanRequest& asking) {
                const LayTask task{.request = asking,
                                   .ground = *ground,
                                   .workable = workable,
                                   .mainland = mainland,
                                   .passes = (*headland)->passes,
                                   .found = **found};
                return timed(&StageTimings::swaths, [&] {
                    return layStage(task, part.part(0.9, 0.95)).and_then([&](LaidSwaths&& laid) {
                        return roundStage(std::move(laid), round, task, part.part(0.95, 1.0));
                    });
                });
            });
        if (!swaths) {
            return std::unexpected(swaths.error());
        }
        if ((*swaths)->refused.empty()) {
            return LaidOut{*headland, {*swaths, &(*swaths)->laid}};
        }
        round =
            ++refusals < kMostRefusals ? without(std::move(round), (*swaths)->refused) : std::vector<Ring>{};
    }
}

Result<PlannedStages> StageRunner::plannedRound(const PlanRequest& request,
                                                const std::shared_ptr<const Ground>& ground,
                                                std::vector<Ring> round, std::optional<PlanToBeat> toBeat,
                                                const JobContext& job) {
    auto laid = laidOut(request, ground, std::move(round), job.part(0.0, 0.2));
    if (!laid) {
        return std::unexpected(laid.error());
    }
    auto ordered = cache_.orders.get(
        request, {ground, laid->laid, request.draft, request.earlier}, [&](const PlanRequest& asking) {
            const OrderTask task{
                .request = asking, .ground = ground, .laid = *laid->laid, .rooms = cache_.rooms};
            return timed(&StageTimings::route, [&] { return orderStage(task, job.part(0.2, 0.4)); });
        });
    if (!ordered) {
        return std::unexpected(ordered.error());
    }
    auto driven = cache_.drives.get(request,
                                    {ground, laid->headland, laid->laid, *ordered,
                                     turnCells(request.settings, (*ordered)->cells), request.draft},
                                    [&](const PlanRequest& asking) {
                                        const DriveTask task{.request = asking,
                                                             .ground = ground,
                                                             .headland = *laid->headland,
                                                             .laid = *laid->laid,
                                                             .ordered = **ordered,
                                                             .rooms = cache_.rooms,
                                                             .lands = cache_.lands};
                                        Stopwatch watch;
                                        auto made = driveStage(task, toBeat, job.part(0.4, 1.0));
                                        // What was given up before its end was driven, too.
                                        const Duration auditing = made ? made->auditing : Duration{};
                                        add(&StageTimings::audit, auditing);
                                        add(&StageTimings::path, watch.lap() - auditing);
                                        return made;
                                    });
    if (!driven) {
        return std::unexpected(driven.error());
    }
    return PlannedStages{request, ground, *std::move(laid), *std::move(ordered), *std::move(driven)};
}

Result<PlannedStages> StageRunner::run(const PlanRequest& request, std::optional<PlanToBeat> toBeat,
                                       const JobContext& job) {
    const auto ground =
        cache_.grounds.get(request, {}, [&](const PlanRequest& asking) { return groundOf(asking, job); });
    if (!ground) {
        return std::unexpected(ground.error());
    }
    const std::vector<Ring> small =
        smallObstacles(*request.field, roundUpTo(request.settings, request.machine));
    auto best = plannedRound(request, *ground, small, toBeat, job.part(0.0, small.empty() ? 1.0 : kFirstTry));
    if (!best || request.draft) {
        return best;
    }
    for (const bool isLast : {false, true}) {
        const SwathSet& swaths = best->laidOut.laid->swaths;
        if (best->drivable() || swaths.goneRound.empty()) {
            break;
        }
        std::vector<Ring> fewer =
            isLast ? std::vector<Ring>{} : awayFromBlocking(swaths, best->driven->findings, request.machine);
        if (fewer.size() == swaths.goneRound.size()) {
            continue;
        }
        auto other = plannedRound(request, *ground, std::move(fewer), toBeat, job.withoutProgress());
        if (!other && other.error().code == ErrorCode::Cancelled) {
            return other;
        }
        // Headlands may leave nothing to work.
        if (other && other->blockingCount() < best->blockingCount()) {
            best = std::move(other);
        }
    }
    return best;
}

}  // namespace furrow
