#include "planner/plan/order_stage.h"

#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/plan/cell_stage.h"
#include "planner/plan/chosen_turns.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/round_stage.h"
#include "planner/plan/ways_room.h"

#include <utility>

namespace furrow {

namespace {

// Searches for ways that may fail. After that, only single curves are tried.
constexpr int kMostFailures = 10;

/// The ways that the path takes between the swaths of one plan, as the path finds them.
class WaysOfPath {
public:
    WaysOfPath(const PlanRequest& request, const SwathSet& swaths, const Decomposition& cells,
               std::shared_ptr<WaySearches> searches, const JobContext& job)
        : searches_{std::move(searches)},
          fitting_{searches_},
          chosen_{request.settings, swaths, cells, fitting_},
          job_{job.withoutProgress()} {
        Route both;
        for (std::size_t swath = 0; swath < swaths.swaths.size(); ++swath) {
            both.steps.push_back({.swath = swath, .reversed = false});
            both.steps.push_back({.swath = swath, .reversed = true});
        }
        legs_ = swathLegs(swaths, both, request.machine);
    }

    std::optional<Curve> between(const RouteStep& from, const RouteStep& to, SearchEffort effort) {
        const Leg& leaving = legs_[2 * from.swath + (from.reversed ? 1 : 0)];
        const Leg& arriving = legs_[2 * to.swath + (to.reversed ? 1 : 0)];
        auto way = chosen_.between(leaving, arriving);
        if (!way) {
            const bool mayFail = effort != SearchEffort::None && failures_ < kMostFailures;
            way = searches_->between(leaving.line.end(), arriving.line.start, job_,
                                     mayFail ? effort : SearchEffort::None);
            failures_ += mayFail && !way ? 1 : 0;
        }
        return way;
    }

private:
    std::shared_ptr<WaySearches> searches_;
    FittingWays fitting_;
    ChosenTurns chosen_;
    JobContext job_;
    std::vector<Leg> legs_;
    int failures_ = 0;
};

/// The task with its ways and places in the field.
Result<RouteTask> taskInField(const OrderTask& task, const Decomposition& cells, const JobContext& job) {
    const PlanRequest& request = task.request;
    RouteTask route = routeTask(request, task.laid.swaths, cells);
    route.isDraft = request.draft;
    route.earlier = request.earlier;
    const auto room = waysRoom(task.rooms, request, task.ground, task.laid.mainland, job);
    if (!room) {
        return std::unexpected(room.error());
    }
    if (request.settings.flag(kStayInside) && !request.draft) {
        const auto ways =
            std::make_shared<WaysOfPath>(request, task.laid.swaths, cells, room->room->raised, job);
        route.way = [ways](const RouteStep& from, const RouteStep& to, SearchEffort effort) {
            return ways->between(from, to, effort);
        };
    }
    // Headland passes lie between the swaths and the place.
    const bool drivesHeadland = request.settings.flag(kHeadlandDriven);
    const bool headlandFirst = drivesHeadland && drivesHeadlandFirst(request.settings);
    const auto position = [](const RoutePlace& place) { return place.position; };
    if (!headlandFirst) {
        route.start = room->places[0].transform(position);
    }
    if (!drivesHeadland || headlandFirst) {
        route.end = room->places[1].transform(position);
    }
    return route;
}

}  // namespace

Result<Ordered> orderStage(const OrderTask& task, const JobContext& job) {
    const LaidSwaths& laid = task.laid;
    if (laid.swaths.swaths.empty()) {
        return Ordered{};
    }
    auto cells = cellsOf(task.request, laid, job.part(0.0, 0.4));
    if (!cells) {
        return std::unexpected(cells.error());
    }
    for (Cell& cell : cells->cells) {
        auto outline = withoutGoneRound(cell.outline, laid.swaths, job);
        if (!outline) {
            return std::unexpected(outline.error());
        }
        cell.outline = *std::move(outline);
    }
    const Method<RoutePlanner>& method = routeMethod(task.request.settings);
    const auto route = method.traits.isByTime
                           ? taskInField(task, *cells, job)
                           : Result<RouteTask>{routeTask(task.request, laid.swaths, *cells)};
    if (!route) {
        return std::unexpected(route.error());
    }
    return method.run(*route, job.part(0.4, 1.0)).transform([&](Route&& found) {
        return Ordered{*std::move(cells), std::move(found)};
    });
}

Result<std::optional<RouteProof>> proofStage(const OrderTask& task, const Ordered& ordered,
                                             const JobContext& job) {
    return taskInField(task, ordered.cells, job).and_then([&](const RouteTask& route) {
        return proofOf(ordered.route, route, job);
    });
}

RouteTask routeTask(const PlanRequest& request, const SwathSet& swaths, const Decomposition& cells) {
    RouteTask task{.swaths = swaths,
                   .machine = request.machine,
                   .turn = turnMethod(request.settings).run,
                   .settings = request.settings};
    for (const Cell& cell : cells.cells) {
        task.cells.push_back(cell.swaths);
    }
    return task;
}

}  // namespace furrow
