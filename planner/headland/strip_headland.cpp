#include "planner/headland/strip_headland.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/headland/edge_strips.h"
#include "planner/headland/headland_passes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// Rounding must not turn 7.5 m / 2.5 m into two passes.
constexpr double kPassSlack = 1e-9;
// Smallest piece of mainland inside a single pass that gets swaths.
constexpr Area kWorthSwaths = squareMetres(50.0);

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
        if (const WideEdge* const wide = edgeWith(task.field.edgeHeadlands(), strip.from, strip.to)) {
            strip.passes = passesWithin(wide->width, task);
            strip.width = heldWidth(wide->width, task);
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

/// What a single pass all round leaves, if that pass can be driven. It may be nothing, and pieces that are
/// too small for the audit to block are left to the passes that finish a plan.
Result<std::optional<Headland>> perimeterOnly(Headland headland, MultiPolygon left, const HeadlandTask& task,
                                              const JobContext& job) {
    headland.isPerimeterOnly = true;
    headland.mainland = std::move(left);
    std::erase_if(headland.mainland, [](const Polygon& piece) { return area(piece) < kWorthSwaths; });
    return addPasses(headland, task, job).transform([&] {
        return headland.drivenPasses.empty() ? std::nullopt : std::optional{std::move(headland)};
    });
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
    std::optional<Headland> perimeter;
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
        if (headland.passes == 1) {
            auto only = perimeterOnly(headland, *std::move(mainland), task, job);
            if (!only) {
                return std::unexpected(only.error());
            }
            if (*only) {
                perimeter = *std::move(only);
                break;
            }
        }
        // The field is too narrow for this headland: use fewer passes, finally none.
        const int fitting = std::min(headland.passes, passesWithin(headland.width, task));
        limitPasses(headland, std::max(0, fitting - 1), task);
    }
    if (!perimeter) {
        if (headland.mainland.empty()) {
            return std::unexpected(nothingLeft(task.margin));
        }
        if (const auto added = addPasses(headland, task, job); !added) {
            return std::unexpected(added.error());
        }
    }
    Headland made = perimeter ? *std::move(perimeter) : std::move(headland);
    if (made.width < widest) {
        made.notes.push_back(
            {made.passes == 0
                 ? message("The field is too narrow for {:.1f} m of headland; there is none", widest.si())
                 : message("The field is too narrow for {:.1f} m of headland; it is {:.1f} m with {}",
                           widest.si(), made.width.si(), counted("{} pass", "{} passes", made.passes)),
             "headland",
             {}});
    }
    made.narrowed = made.width < widest || made.isPerimeterOnly;
    made.mainlandRatio = area(made.mainland) / area(task.workable());
    return made;
}

}  // namespace furrow
