#include "planner/headland/strip_headland.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"
#include "planner/headland/edge_strips.h"
#include "planner/headland/headland_passes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

// Rounding must not turn 7.5 m / 2.5 m into two passes.
constexpr double kPassSlack = 1e-9;
// Obstacles and repairs cut edges into parts. A part lies within this distance of its edge.
constexpr double kSameLineM = 0.01;

/// Whether the mainland is an operating width wide somewhere. A narrower one is not worth a headland around
/// it.
Result<bool> isWorthWorking(const MultiPolygon& mainland, const Machine& machine, const JobContext& job) {
    const Length half = 0.5 * machine.operatingWidth();
    double perimeterM = 0.0;
    forEachEdge(mainland, [&](Point from, Point to) { perimeterM += distance(from, to); });
    // A disc with radius area / perimeter fits into every shape. This settles nearly all cases without
    // geometry.
    if (area(mainland).si() >= half.si() * perimeterM && perimeterM > 0.0) {
        return true;
    }
    return eroded(mainland, half - kArcTolerance, kArcTolerance, job).transform([](const MultiPolygon& core) {
        return !core.empty();
    });
}

void widenEdges(Headland& headland, const HeadlandTask& task) {
    for (EdgeStrip& strip : headland.strips) {
        for (const WideEdge& wide : task.field.edgeHeadlands()) {
            if (distanceToSegment(strip.from, wide.from, wide.to) < kSameLineM &&
                distanceToSegment(strip.to, wide.from, wide.to) < kSameLineM) {
                strip.passes = passesWithin(wide.width, task);
                strip.width = heldWidth(wide.width, task);
            }
        }
    }
    for (const EdgeStrip& strip : headland.strips) {
        headland.width = std::max(headland.width, strip.width);
        headland.passes = std::max(headland.passes, strip.passes);
    }
}

/// Limits the passes along every edge to `most`.
void limitPasses(Headland& headland, int most, const HeadlandTask& task) {
    const auto limit = [&](Length& width, int& passes) {
        if (passes > most || most == 0) {
            passes = most;
            width = widthOfPasses(most, task);
        }
    };
    limit(headland.width, headland.passes);
    for (EdgeStrip& strip : headland.strips) {
        limit(strip.width, strip.passes);
    }
}

Result<MultiPolygon> mainlandOf(const Headland& headland, const HeadlandTask& task, const JobContext& job) {
    const MultiPolygon& workable = task.workable();
    if (!headland.strips.empty()) {
        return withoutStrips(workable, headland.strips, job);
    }
    return headland.width > metres(0.0) ? eroded(workable, headland.width, kArcTolerance, job)
                                        : Result<MultiPolygon>{workable};
}

}  // namespace

Length widthOfPasses(int passes, const HeadlandTask& task) {
    return passes == 0 ? task.margin
                       : task.margin + uncutEdge(task.machine) + passes * task.machine.operatingWidth();
}

int passesWithin(Length width, const HeadlandTask& task) {
    const double passes = (width - task.margin - uncutEdge(task.machine)) / task.machine.operatingWidth();
    return std::max(0, static_cast<int>(std::floor(passes + kPassSlack)));
}

Length heldWidth(Length given, const HeadlandTask& task) {
    const int passes = passesWithin(given, task);
    return task.settings.flag(kHeadlandDriven) && passes > 0 ? widthOfPasses(passes, task)
                                                             : std::max(given, task.margin);
}

int passesFor(Length room, const Machine& machine) {
    return std::max(1, static_cast<int>(std::ceil(room / machine.operatingWidth() - kPassSlack)));
}

Result<Headland> headlandOf(Headland wanted, const HeadlandTask& task, const JobContext& job) {
    Headland headland = std::move(wanted);
    widenEdges(headland, task);
    const Length widest = headland.width;
    for (;;) {
        auto mainland = mainlandOf(headland, task, job);
        if (!mainland) {
            return std::unexpected(mainland.error());
        }
        const auto useful = isWorthWorking(*mainland, task.machine, job);
        if (!useful) {
            return std::unexpected(useful.error());
        }
        if (*useful || headland.width <= task.margin) {
            headland.mainland = std::move(*mainland);
            break;
        }
        // The field is too narrow for this headland: use fewer passes, finally none.
        const int fitting = std::min(headland.passes, passesWithin(headland.width, task));
        limitPasses(headland, std::max(0, fitting - 1), task);
    }
    if (headland.mainland.empty()) {
        return std::unexpected(nothingLeft(task.margin));
    }
    if (headland.width < widest) {
        headland.narrowed = true;
        headland.notes.push_back(
            {headland.passes == 0
                 ? message("The field is too narrow for {:.1f} m of headland; there is none", widest.si())
                 : message("The field is too narrow for {:.1f} m of headland; it is {:.1f} m with {}",
                           widest.si(), headland.width.si(),
                           counted("{} pass", "{} passes", headland.passes)),
             "headland",
             {}});
    }
    headland.mainlandRatio = area(headland.mainland) / area(task.workable());
    if (const auto added = addPasses(headland, task, job); !added) {
        return std::unexpected(added.error());
    }
    return headland;
}

}  // namespace furrow
