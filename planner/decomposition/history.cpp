#include "planner/decomposition/history.h"

#include "planner/decomposition/joining.h"
#include "planner/geometry/geos_bridge.h"

#include <numeric>
#include <utility>

namespace furrow {

Groups cellsAt(const DecompositionHistory& history, std::size_t step) {
    Groups groups(history.pieces.size());
    std::iota(groups.begin(), groups.end(), std::size_t{0});
    for (std::size_t i = 0; i <= step; ++i) {
        for (const Join& join : history.steps[i].joins) {
            apply(join, groups);
        }
    }
    return groups;
}

Result<std::vector<MultiPolygon>> outlinesOf(const MultiPolygon& pieces, const Groups& groups,
                                             const JobContext& job) {
    std::vector<MultiPolygon> members(pieces.size());
    for (std::size_t piece = 0; piece < pieces.size(); ++piece) {
        members[groups[piece]].push_back(pieces[piece]);
    }
    std::erase_if(members, [](const MultiPolygon& cell) { return cell.empty(); });
    for (MultiPolygon& cell : members) {
        if (cell.size() > 1) {
            auto outline = unionOf(cell, job);
            if (!outline) {
                return std::unexpected(outline.error());
            }
            cell = std::move(*outline);
        }
    }
    return members;
}

Result<std::vector<MultiPolygon>> outlinesAt(const DecompositionHistory& history, std::size_t step,
                                             const JobContext& job) {
    return outlinesOf(history.pieces, cellsAt(history, step), job);
}

Result<std::vector<MultiPolygon>> joinedAt(const DecompositionHistory& history, std::size_t step,
                                           const JobContext& job) {
    if (step == 0 || !(history.steps[step].cost < history.steps[step - 1].cost)) {
        return std::vector<MultiPolygon>{};
    }
    const Join& join = history.steps[step].joins.front();
    const Groups groups = cellsAt(history, step - 1);
    MultiPolygon members;
    Groups two;
    for (std::size_t piece = 0; piece < groups.size(); ++piece) {
        if (groups[piece] == join.kept || groups[piece] == join.gone) {
            members.push_back(history.pieces[piece]);
            two.push_back(groups[piece] == join.kept ? 0 : 1);
        }
    }
    return outlinesOf(members, two, job);
}

}  // namespace furrow
