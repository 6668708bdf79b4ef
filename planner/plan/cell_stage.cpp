#include "planner/plan/cell_stage.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/plan/mainland_parts.h"
#include "planner/plan/method_registry.h"

#include <algorithm>
#include <iterator>
#include <ranges>

namespace furrow {

namespace {

/// One part after the other: the figures of a step are those of all parts.
void append(DecompositionHistory& all, DecompositionHistory part) {
    if (part.steps.empty()) {
        return;
    }
    const std::size_t offset = all.pieces.size();
    std::ranges::move(part.pieces, std::back_inserter(all.pieces));
    if (all.steps.empty()) {
        all.steps = std::move(part.steps);
        return;
    }
    const auto add = [](DecompositionStep& sum, const DecompositionStep& more) {
        sum.cells += more.cells;
        sum.altitude += more.altitude;
        sum.cost += more.cost;
    };
    const DecompositionStep before = all.steps.back();
    for (DecompositionStep& step : all.steps) {
        add(step, part.steps.front());
    }
    for (DecompositionStep& step : part.steps | std::views::drop(1)) {
        add(step, before);
        for (Join& join : step.joins) {
            join.kept += offset;
            join.gone += offset;
        }
        all.steps.push_back(std::move(step));
    }
}

}  // namespace

Result<Decomposition> cellsOf(const PlanRequest& request, const LaidSwaths& laid, const JobContext& job) {
    Decomposition all;
    for (const MainlandPart& part : laid.parts) {
        SwathSet set = setOf(laid.forCells(), part);
        if (part.heading) {
            // Straight along a heading of their own.
            std::ranges::for_each(set.swaths, [](Swath& swath) { swath.curve = {}; });
        }
        auto cells = decompositionMethod(request.settings)
                         .run({.mainland = part.outline,
                               .swaths = set,
                               .machine = request.machine,
                               .settings = request.settings},
                              job);
        if (!cells) {
            return std::unexpected(cells.error());
        }
        for (Cell& cell : cells->cells) {
            cell.heading = set.heading;
            std::ranges::for_each(cell.swaths, [&](std::size_t& swath) { swath += part.firstSwath; });
            all.cells.push_back(std::move(cell));
        }
        all.altitude += cells->altitude;
        append(all.history, std::move(cells->history));
    }
    return all;
}

}  // namespace furrow
