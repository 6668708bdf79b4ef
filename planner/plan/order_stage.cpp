#include "planner/plan/order_stage.h"

#include "planner/plan/cell_stage.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/round_stage.h"

#include <utility>

namespace furrow {

Result<Ordered> orderStage(const PlanRequest& request, const LaidSwaths& laid, const JobContext& job) {
    if (laid.swaths.swaths.empty()) {
        return Ordered{};
    }
    auto cells = cellsOf(request, laid, job.part(0.0, 0.4));
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
    return routeMethod(request.settings)
        .run(routeTask(request, laid.swaths, *cells), job.part(0.4, 1.0))
        .transform([&](Route&& route) { return Ordered{*std::move(cells), std::move(route)}; });
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
