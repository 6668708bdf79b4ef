#include "planner/plan/round_stage.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/headland_passes.h"
#include "planner/route/swath_detours.h"
#include "planner/swaths/curved_swaths.h"
#include "planner/swaths/mainland_edges.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

// What any machine gets round with less work than a headland takes; wide ones get round what is as wide as
// they are.
constexpr Length kSmallForAll = metres(1.5);
// Passes along the mainland's edge swing out over it in bends.
constexpr Length kSwing = metres(0.5);
// What blocks a plan has to do with an obstacle that is so many radii and widths away, or less.
constexpr double kRoundNearRadii = 3.0;
constexpr double kRoundNearWidths = 2.0;

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

std::vector<Ring> insideMainland(const std::vector<Ring>& obstacles, const MultiPolygon& mainland,
                                 Length margin, const Machine& machine) {
    std::vector<Ring> inside = obstacles;
    if (inside.empty()) {
        return inside;
    }
    const Length clear = margin + std::max(Length{}, uncutEdge(machine)) + kSwing;
    const MainlandEdges edges{mainland};
    const BoundaryDistance distance{mainland, clear};
    std::erase_if(inside, [&](const Ring& ring) {
        return !std::ranges::all_of(
            ring, [&](Point point) { return edges.contains(point) && !distance.insideM(point); });
    });
    return inside;
}

Result<RoundedSwaths> roundStage(LaidSwaths laid, std::span<const Ring> obstacles, const LayTask& task,
                                 const JobContext& job) {
    if (obstacles.empty()) {
        return RoundedSwaths{std::move(laid), {}};
    }
    SwathSet round = laid.swaths;
    auto refused = addDetours(round,
                              {.drivable = task.ground.drivable,
                               .obstacles = obstacles,
                               .machine = task.request.machine,
                               .margin = task.ground.margin},
                              job);
    if (!refused) {
        return std::unexpected(refused.error());
    }
    if (!refused->empty()) {
        return RoundedSwaths{std::move(laid), *std::move(refused)};
    }
    round.goneRound.assign(obstacles.begin(), obstacles.end());
    MultiPolygon without = withHoles(laid.mainland, round.goneRound);
    const auto covered = coverageOf(cutTo(round, laid.mainland), without, job);
    if (!covered) {
        return std::unexpected(covered.error());
    }
    round.coverage = covered->share;
    round.overlap = covered->overlap;
    round.proved = false;
    auto onPurpose = withoutGoneRound(round.leftOnPurpose, round, job);
    if (!onPurpose) {
        return std::unexpected(onPurpose.error());
    }
    round.leftOnPurpose = *std::move(onPurpose);
    laid.beforeRound = std::exchange(laid.swaths, std::move(round));
    laid.mainland = std::move(without);
    return RoundedSwaths{std::move(laid), {}};
}

Result<MultiPolygon> withoutGoneRound(const MultiPolygon& polygons, const SwathSet& swaths,
                                      const JobContext& job) {
    if (polygons.empty() || swaths.goneRound.empty()) {
        return polygons;
    }
    MultiPolygon outlines;
    std::ranges::transform(swaths.goneRound, std::back_inserter(outlines), outlineOf);
    return difference(polygons, outlines, job, kSnapGrid);
}

std::vector<Ring> awayFromBlocking(const SwathSet& swaths, std::span<const Finding> findings,
                                   const Machine& machine) {
    const double nearM =
        (kRoundNearRadii * machine.minTurningRadius() + kRoundNearWidths * machine.operatingWidth()).si();
    std::vector<Ring> away = swaths.goneRound;
    std::erase_if(away, [&](const Ring& ring) {
        return std::ranges::any_of(findings, [&](const Finding& finding) {
            return finding.severity == Severity::Blocking && distance(finding.place, ring.front()) < nearM;
        });
    });
    return away;
}

const Parameter kRoundUpTo{
    .key = "swaths.round_up_to_m",
    .name = "Go round obstacles up to",
    .description =
        "Swaths go round obstacles of up to this size; larger ones get a headland. Auto is the operating width.",
    .kind = ParameterKind::Length,
    .standard = {},
    .canBeAuto = true,
    .min = 0.0,
    .max = 50.0,
    .step = 0.5,
    .choices = {}};

}  // namespace furrow
