#include "planner/geometry/geos_bridge.h"
#include "planner/headland/methods.h"

namespace furrow {

namespace {

Result<Headland> noHeadland(const HeadlandTask& task, const JobContext& job) {
    const Length margin = task.margin;
    // The margin is kept everywhere, headland or not.
    auto mainland = margin > metres(0.0) ? eroded(task.workable(), margin, kArcTolerance, job)
                                         : Result<MultiPolygon>{task.workable()};
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

}  // namespace

const Method<HeadlandGenerator> kNoHeadlandMethod{
    .info = {.id = "none",
             .name = "No headland",
             .description = "Swaths reach to the boundary; for fields with room to turn outside.",
             .parameters = {}},
    .run = noHeadland};

}  // namespace furrow
