#include "planner/geometry/geos_bridge.h"
#include "planner/headland/finishing_passes.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/headland/turning_room.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// Rounding must not turn 7.5 m / 2.5 m into two passes.
constexpr double kPassSlack = 1e-9;

int passesForTurns(const HeadlandTask& task) {
    const double room =
        roomForTurns(task.machine, task.turn, task.drawsOutEnds) / task.machine.operatingWidth();
    return std::max(1, static_cast<int>(std::ceil(room - kPassSlack)));
}

int passesWithin(Length width, Length margin, const Machine& machine) {
    const double passes = (width - margin - uncutEdge(machine)) / machine.operatingWidth();
    return std::max(0, static_cast<int>(std::floor(passes + kPassSlack)));
}

/// Whether the mainland is an operating width wide somewhere; less is not worth a headland around it.
Result<bool> isWorthWorking(const MultiPolygon& mainland, const Machine& machine, const JobContext& job) {
    const Length half = 0.5 * machine.operatingWidth();
    double perimeterM = 0.0;
    forEachEdge(mainland, [&](Point from, Point to) { perimeterM += distance(from, to); });
    // A disc of area / perimeter fits into every shape, which settles nearly all cases without geometry.
    if (area(mainland).si() >= half.si() * perimeterM && perimeterM > 0.0) {
        return true;
    }
    return eroded(mainland, half - kArcTolerance, kArcTolerance, job).transform([](const MultiPolygon& core) {
        return !core.empty();
    });
}

Result<Headland> constantWidth(const HeadlandTask& task, const JobContext& job) {
    const Field& field = task.field;
    const Machine& machine = task.machine;
    const Settings& settings = task.settings;
    const Length margin = task.margin;
    const auto givenWidth = settings.length(kHeadlandWidth);
    const auto givenPasses = settings.count(kHeadlandPasses);
    if (givenWidth && givenPasses) {
        return std::unexpected(Error{.code = ErrorCode::Usage,
                                     .what = "both headland.width_m and headland.passes are given",
                                     .where = "settings",
                                     .remedy = "give at most one of the two"});
    }
    const auto widthOf = [&](int passes) {
        return passes == 0 ? margin : margin + uncutEdge(machine) + passes * machine.operatingWidth();
    };
    Headland headland;
    headland.passes = givenPasses  ? *givenPasses
                      : givenWidth ? passesWithin(*givenWidth, margin, machine)
                                   : passesForTurns(task);
    headland.width = givenWidth ? std::max(*givenWidth, margin) : widthOf(headland.passes);
    const Length wanted = headland.width;
    for (;;) {
        auto mainland = headland.width > metres(0.0)
                            ? eroded(field.workable(), headland.width, kArcTolerance, job)
                            : Result<MultiPolygon>{field.workable()};
        if (!mainland) {
            return std::unexpected(mainland.error());
        }
        const auto useful = isWorthWorking(*mainland, machine, job);
        if (!useful) {
            return std::unexpected(useful.error());
        }
        if (*useful || headland.width <= margin) {
            headland.mainland = std::move(*mainland);
            break;
        }
        // Too narrow for this much: fewer passes, in the end none.
        headland.passes =
            std::max(0, std::min(headland.passes, passesWithin(headland.width, margin, machine)) - 1);
        headland.width = widthOf(headland.passes);
    }
    if (headland.mainland.empty()) {
        return std::unexpected(nothingLeft(margin));
    }
    if (headland.width < wanted) {
        headland.notes.push_back(
            {headland.passes == 0
                 ? message("The field is too narrow for {:.1f} m of headland; there is none", wanted.si())
                 : message("The field is too narrow for {:.1f} m of headland; it is {:.1f} m with {}", wanted.si(),
                           headland.width.si(), counted("{} pass", "{} passes", headland.passes)),
             "headland",
             {}});
    }
    headland.mainlandRatio = area(headland.mainland) / area(field.workable());
    if (const auto added = addPasses(headland, task, job); !added) {
        return std::unexpected(added.error());
    }
    return headland;
}

constexpr const Parameter* kParameters[] = {&kHeadlandPasses,    &kHeadlandWidth, &kHeadlandDriven,
                                            &kHeadlandOrder,     &kHeadlandWhen,  &kHeadlandDirection,
                                            &kHeadlandCorner,     &kHeadlandFinish};

}  // namespace

const Parameter kHeadlandWidth{
    .key = "headland.width_m",
    .name = "Width",
    .description = "From the boundary to the mainland; holds as many passes as fit.",
    .kind = ParameterKind::Length,
    .standard = {},
    .canBeAuto = true,
    .min = 0.0,
    .max = 500.0,
    .step = 0.5,
    .choices = {}};

const Parameter kHeadlandPasses{.key = "headland.passes",
                                .name = "Passes",
                                .description = "Width in operating widths; auto leaves room for the turns.",
                                .kind = ParameterKind::Count,
                                .standard = {},
                                .canBeAuto = true,
                                .min = 0.0,
                                .max = 50.0,
                                .step = 1.0,
                                .choices = {}};

const Method<HeadlandGenerator> kConstantWidthMethod{
    .info = {.id = "constant",
             .name = "Same width all round",
             .description = "A strip of the same width along the boundary and around obstacles, for turning.",
             .parameters = kParameters},
    .run = constantWidth};

}  // namespace furrow
