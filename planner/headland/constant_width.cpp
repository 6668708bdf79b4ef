#include "planner/headland/edge_strips.h"
#include "planner/headland/finishing_passes.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/headland/strip_headland.h"
#include "planner/headland/turning_room.h"

#include <algorithm>

namespace furrow {

namespace {

// Smallest width beyond the passes that is reported.
constexpr Length kWorthTelling = metres(0.05);

int passesForTurns(const HeadlandTask& task) {
    return passesFor(roomForTurns(task.machine, task.turn, task.drawsOutEnds, task.overhang), task.machine);
}

Result<Headland> constantWidth(const HeadlandTask& task, const JobContext& job) {
    const Settings& settings = task.settings;
    const auto givenWidth = settings.length(kHeadlandWidth);
    const auto givenPasses = settings.count(kHeadlandPasses);
    if (givenWidth && givenPasses && passesWithin(*givenWidth, task) != *givenPasses) {
        return std::unexpected(
            Error{.code = ErrorCode::Usage,
                  .what = "headland.width_m and headland.passes do not agree",
                  .where = "settings",
                  .remedy = "give one of the two, or a width that holds just these passes"});
    }
    Headland wanted;
    wanted.passes = givenPasses  ? *givenPasses
                    : givenWidth ? passesWithin(*givenWidth, task)
                                 : passesForTurns(task);
    wanted.width = givenWidth ? heldWidth(*givenWidth, task) : widthOfPasses(wanted.passes, task);
    if (givenWidth && *givenWidth - wanted.width > kWorthTelling) {
        wanted.notes.push_back(
            {message(
                 "A headland of {:.1f} m holds {}; it is {:.1f} m wide, and the rest belongs to the swaths",
                 givenWidth->si(), counted("{} pass", "{} passes", wanted.passes), wanted.width.si()),
             "headland",
             {}});
    }
    if (!task.field.edgeHeadlands().empty()) {
        wanted.strips = EdgeStrips::along(task.workable(), wanted.width, wanted.passes);
    }
    return headlandOf(std::move(wanted), task, job);
}

constexpr const Parameter* kConstantWidthParameters[] = {
    &kHeadlandPasses, &kHeadlandWidth,     &kHeadlandDriven, &kHeadlandOrder,
    &kHeadlandWhen,   &kHeadlandDirection, &kHeadlandCorner, &kHeadlandFinish};

}  // namespace

const Parameter kHeadlandWidth{.key = "headland.width_m",
                               .name = "Width",
                               .description = "From the boundary inwards; holds as many passes as fit.",
                               .kind = ParameterKind::Length,
                               .standard = {},
                               .canBeAuto = true,
                               .min = 0.0,
                               .max = 500.0,
                               .step = 0.5,
                               .choices = {},
                               .excludes = "headland.passes"};

const Parameter kHeadlandPasses{.key = "headland.passes",
                                .name = "Passes",
                                .description = "Width in operating widths; auto leaves room for the turns.",
                                .kind = ParameterKind::Count,
                                .standard = {},
                                .canBeAuto = true,
                                .min = 0.0,
                                .max = 50.0,
                                .step = 1.0,
                                .choices = {},
                                .excludes = "headland.width_m"};

const Method<HeadlandGenerator> kConstantWidthMethod{
    .info = {.id = "constant",
             .name = "Same width all round",
             .description = "A strip of the same width along the boundary and around obstacles, for turning.",
             .parameters = kConstantWidthParameters},
    .run = constantWidth,
    .traits = {.isOneWidth = true}};

}  // namespace furrow
