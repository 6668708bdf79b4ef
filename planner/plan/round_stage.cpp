#include "planner/plan/round_stage.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/headland_passes.h"
#include "planner/plan/swath_stage.h"
#include "planner/route/way_round.h"
#include "planner/swaths/curved_swaths.h"
#include "planner/swaths/mainland_edges.h"

#include <algorithm>

namespace furrow {

namespace {

// What any machine gets round with less work than a headland takes; wide ones get round what is as wide as they are.
constexpr Length kSmallForAll = metres(1.5);
// Passes along the mainland's edge swing out over it in bends.
constexpr Length kSwing = metres(0.5);
// What blocks a plan has to do with an obstacle that is so many radii and widths away, or less.
constexpr double kNearRadii = 3.0;
constexpr double kNearWidths = 2.0;

Polygon outlineOf(const Ring& hole) {
    return {.outer = Ring{hole.rbegin(), hole.rend()}, .holes = {}};
}

MultiPolygon withHoles(MultiPolygon polygons, const std::vector<Ring>& holes) {
    for (Polygon& polygon : polygons) {
        const MainlandEdges edges{{polygon}};
        std::ranges::copy_if(holes, std::back_inserter(polygon.holes),
                             [&](const Ring& hole) { return edges.contains(hole.front()); });
    }
    return polygons;
}

}  // namespace

Length roundUpTo(const Settings& settings, const Machine& machine) {
    return settings.length(kRoundUpTo).value_or(std::max(machine.operatingWidth(), kSmallForAll));
}

bool eraseOutside(std::vector<Ring>& obstacles, const Plan& plan) {
    if (obstacles.empty()) {
        return false;
    }
    const MultiPolygon& mainland = plan.headland.mainland;
    const Length clear = plan.margin + std::max(Length{}, uncutEdge(plan.request.machine)) + kSwing;
    const MainlandEdges edges{mainland};
    const BoundaryDistance distance{mainland, clear};
    return std::erase_if(obstacles, [&](const Ring& ring) {
               return !std::ranges::all_of(
                   ring, [&](Point point) { return edges.contains(point) && !distance.insideM(point); });
           }) > 0;
}

Result<bool> roundStage(Plan& plan, std::vector<Ring>& obstacles, const MultiPolygon& drivable, const JobContext& job) {
    if (obstacles.empty()) {
        return false;
    }
    const auto refused = leadRound(
        plan.swaths,
        {.drivable = drivable, .obstacles = obstacles, .machine = plan.request.machine, .margin = plan.margin}, job);
    if (!refused) {
        return std::unexpected(refused.error());
    }
    if (!refused->empty()) {
        for (auto index = refused->rbegin(); index != refused->rend(); ++index) {
            obstacles.erase(obstacles.begin() + static_cast<std::ptrdiff_t>(*index));
        }
        return true;
    }
    plan.swaths.goneRound = obstacles;
    const auto covered = coverageOf(cutTo(plan.swaths, plan.headland.mainland),
                                    withHoles(plan.headland.mainland, obstacles), job);
    if (!covered) {
        return std::unexpected(covered.error());
    }
    plan.swaths.coverage = covered->share;
    plan.swaths.overlap = covered->overlap;
    plan.swaths.proved = false;
    return false;
}

Result<void> cutOutGoneRound(Plan& plan, const JobContext& job) {
    const std::vector<Ring>& obstacles = plan.swaths.goneRound;
    if (obstacles.empty()) {
        return {};
    }
    MultiPolygon outlines;
    std::ranges::transform(obstacles, std::back_inserter(outlines), outlineOf);
    std::vector<MultiPolygon*> cut{&plan.swaths.leftOnPurpose};
    std::ranges::transform(plan.cells.cells, std::back_inserter(cut), [](Cell& cell) { return &cell.outline; });
    for (MultiPolygon* const area : cut) {
        if (area->empty()) {
            continue;
        }
        auto left = difference(*area, outlines, job, kSnapGrid);
        if (!left) {
            return std::unexpected(left.error());
        }
        *area = std::move(*left);
    }
    plan.headland.mainland = withHoles(std::move(plan.headland.mainland), obstacles);
    plan.headland.mainlandRatio = area(plan.headland.mainland) / area(plan.field().workable());
    return {};
}

std::vector<Ring> awayFromBlocking(const Plan& plan) {
    const Machine& machine = plan.request.machine;
    const double nearM = (kNearRadii * machine.minTurningRadius() + kNearWidths * machine.operatingWidth()).si();
    std::vector<Ring> away = plan.swaths.goneRound;
    std::erase_if(away, [&](const Ring& ring) {
        return std::ranges::any_of(plan.findings, [&](const Finding& finding) {
            return finding.severity == Severity::Blocking && distance(finding.place, ring.front()) < nearM;
        });
    });
    return away;
}

const Parameter kRoundUpTo{
    .key = "swaths.round_up_to_m",
    .name = "Go round obstacles up to",
    .description = "Swaths go round obstacles of up to this size; larger ones get a headland. Auto is the operating width.",
    .kind = ParameterKind::Length,
    .standard = {},
    .canBeAuto = true,
    .min = 0.0,
    .max = 50.0,
    .step = 0.5,
    .choices = {}};

}  // namespace furrow
