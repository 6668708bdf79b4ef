#include "planner/field/ground_around.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/finishing_passes.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"

namespace furrow {

namespace {

/// Keeps the mainland away from obstacles that swaths do not go round, if the tractor is wider than its
/// implement.
Result<MultiPolygon> clearOfObstacles(MultiPolygon mainland, const HeadlandTask& task,
                                      const JobContext& job) {
    const Length beside = uncutEdge(task.machine);
    if (beside <= Length{}) {
        return mainland;
    }
    return obstaclesOf(task.field, task.workable(), job)
        .and_then(
            [&](const MultiPolygon& obstacles) { return dilated(obstacles, beside, kArcTolerance, job); })
        .and_then([&](const MultiPolygon& kept) {
            return kept.empty() ? Result<MultiPolygon>{mainland} : difference(mainland, kept, job);
        });
}

Result<Headland> noHeadland(const HeadlandTask& task, const JobContext& job) {
    const Length margin = task.margin;
    // The margin is kept with or without a headland.
    auto mainland = margin > metres(0.0) ? eroded(task.workable(), margin, kArcTolerance, job)
                                         : Result<MultiPolygon>{task.workable()};
    mainland =
        mainland.and_then([&](MultiPolygon land) { return clearOfObstacles(std::move(land), task, job); });
    if (!mainland) {
        return std::unexpected(mainland.error());
    }
    if (mainland->empty()) {
        return std::unexpected(nothingLeft(margin));
    }
    Headland headland{.width = margin, .passes = 0, .mainland = std::move(*mainland)};
    headland.mainlandRatio = area(headland.mainland) / area(task.workable());
    return headland;
}

constexpr const Parameter* kNoHeadlandParameters[] = {&kHeadlandFinish};

}  // namespace

const Method<HeadlandGenerator> kNoHeadlandMethod{
    .info =
        {.id = "none",
         .name = "No headland",
         .description =
             "Swaths reach to the boundary; for fields with room to turn outside, and for machines that turn "
             "on the spot.",
         .parameters = kNoHeadlandParameters},
    .run = noHeadland};

}  // namespace furrow
