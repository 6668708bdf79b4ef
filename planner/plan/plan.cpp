#include "planner/plan/plan.h"

#include "planner/field/drivable_area.h"
#include "planner/geometry/convex_hull.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/plan/drive_stage.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/swath_stage.h"
#include "planner/swaths/methods.h"
#include "planner/turns/turn_sampling.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace furrow {

namespace {

using Clock = std::chrono::steady_clock;

/// Runs one stage and notes how long it took.
template <class Run>
auto timed(Duration& taken, const Run& run) {
    const Clock::time_point begin = Clock::now();
    auto result = run();
    taken = seconds(std::chrono::duration<double>(Clock::now() - begin).count());
    return result;
}

/// How long the machine is where it is as wide as its tractor. A trailed implement may stand at an angle.
Length rigidLength(const Machine& machine) {
    if (machine.spec().implement.mounting == Mounting::Trailed) {
        return machine.spec().tractor.length;
    }
    const Ring outline = machine.turningFootprint();
    const auto [rear, front] = std::ranges::minmax(outline, {}, &Point::x);
    return metres(front.x - rear.x);
}

/// Whether some straight line of this length may be in it: for convex parts that is so, for others perhaps.
bool mayHoldLine(const MultiPolygon& polygons, Length length) {
    return std::ranges::any_of(polygons, [length](const Polygon& polygon) {
        const Bounds box = bounds({polygon});
        // Of large ones the box says enough.
        return std::max(box.width(), box.height()) >= length.si() ||
               diameter(convexHull(polygon.outer)) >= length;
    });
}

/// No machine fits where not even what is within its outline does: the middle of it, as wide as the tractor,
/// with round ends. It stands where its middle line stays clear of the edge by half its width.
Result<void> checkThatItFits(const Field& field, const Machine& machine, Length margin,
                             const JobContext& job) {
    const Length width = machine.spec().tractor.width;
    const Length length = rigidLength(machine);
    const auto room = eroded(field.drivable(), 0.5 * std::min(width, length) + margin, metres(0.05), job);
    if (!room) {
        return std::unexpected(room.error());
    }
    const Message withMargin =
        margin > metres(0.0) ? message(" and twice {:.2f} m of margin", margin.si()) : Message{};
    Message what;
    if (room->empty()) {
        what = message("the field is nowhere as wide as the machine ({:.2f} m{})",
                           std::min(width, length).si(), withMargin);
    } else if (!mayHoldLine(*room, std::max(width, length) - std::min(width, length))) {
        what = message("the machine ({:.2f} m wide, {:.2f} m long{}) fits nowhere into the field", width.si(),
                           length.si(), withMargin);
    } else {
        return {};
    }
    return std::unexpected(
        Error{.code = ErrorCode::InputRefused,
              .what = std::move(what),
              .where = field.source().origin.empty() ? field.name() : field.source().origin,
              .remedy = "choose a smaller machine or check the boundary's coordinate system",
              .place = middleOf(field.source().parts)});
}

bool drawsOutEnds(const Settings& settings) {
    return settings.choice(kEnds) == "full";
}

Polyline lineOf(const Turn& turn) {
    Polyline line;
    for (const TurnSample& sample : sampled(turn, kChordTolerance)) {
        line.push_back(sample.pose.position);
    }
    return line;
}

}  // namespace

bool Plan::drivable() const {
    return std::ranges::none_of(
        findings, [](const Finding& finding) { return finding.severity == Severity::Blocking; });
}

AuditInput auditInput(const Plan& plan) {
    const Field& field = plan.field();
    AuditInput input{.workable = field.workable(),
                     .drivable = field.drivable(),
                     .gates = {},
                     .machine = plan.request.machine,
                     .segments = plan.path.segments,
                     .passes = {},
                     .mainland = {},
                     .mayLeaveField = !plan.request.settings.flag(kStayInside)};
    for (const Gate& gate : field.source().gates) {
        input.gates.push_back({field.frame().toLocal(gate.position), gate.width});
    }
    for (const RouteStep& step : plan.route.steps) {
        const Swath& swath = plan.swaths.swaths[step.swath];
        input.passes.push_back(
            {.line = drivenMiddle(step, plan.swaths),
             .width = swath.width,
             .number = swath.number});
    }
    for (const HeadlandPass& pass : plan.headland.rings) {
        for (const PassStretch& stretch : pass.stretches) {
            if (stretch.working) {
                input.passes.push_back({.line = lineOf(stretch.line),
                                        .width = pass.width,
                                        .number = pass.ring + 1,
                                        .kind = SegmentKind::HeadlandPass});
            }
        }
    }
    if (plan.headland.width > metres(0.0) && plan.headland.rings.empty()) {
        input.mainland = plan.headland.mainland;
    }
    return input;
}

Result<std::shared_ptr<const Plan>> makePlan(const PlanRequest& request, const JobContext& job) {
    const Clock::time_point begin = Clock::now();
    const Field& field = *request.field;
    const Machine& machine = request.machine;
    const Settings& settings = request.settings;
    const auto plan = std::make_shared<Plan>(Plan{.request = request});
    plan->margin = settings.length(kMargin).value_or(field.source().boundaryAccuracy);

    if (auto fits = checkThatItFits(field, machine, plan->margin, job); !fits) {
        return std::unexpected(fits.error());
    }
    const auto drivable = drivableArea(field, plan->margin, job);
    if (!drivable) {
        return std::unexpected(drivable.error());
    }
    auto headland = timed(plan->timings.headland, [&] {
        return headlandMethod(settings)({.field = field,
                                         .drivable = *drivable,
                                         .machine = machine,
                                         .turn = turnMethod(settings),
                                         .settings = settings,
                                         .margin = plan->margin,
                                         .drawsOutEnds = drawsOutEnds(settings),
                                         .swathEnds = [&](const MultiPolygon& mainland) {
                                             return swathEnds(request, mainland, job.part(0.0, 0.1));
                                         }},
                                        job.part(0.0, 0.1));
    });
    if (!headland) {
        return std::unexpected(headland.error());
    }
    plan->headland = std::move(*headland);

    auto laid = timed(plan->timings.swaths, [&] { return layStage(*plan, *drivable, job.part(0.1, 0.8)); });
    if (!laid) {
        return std::unexpected(laid.error());
    }
    plan->swaths = laid->swaths;

    auto route = timed(plan->timings.route, [&]() -> Result<Route> {
        auto cells = cellStage(request, *laid, job.part(0.8, 0.82));
        if (!cells) {
            return std::unexpected(cells.error());
        }
        plan->cells = std::move(*cells);
        RouteTask task{.swaths = plan->swaths, .machine = machine, .turn = turnMethod(settings), .settings = settings};
        for (const Cell& cell : plan->cells.cells) {
            task.cells.push_back(cell.swaths);
        }
        return routeMethod(settings)(task, job.part(0.82, 0.85));
    });
    if (!route) {
        return std::unexpected(route.error());
    }
    plan->route = std::move(*route);

    if (auto driven = driveStage(*plan, *drivable, job.part(0.85, 1.0)); !driven) {
        return std::unexpected(driven.error());
    }
    const Point middle = field.frame().toLocal(middleOf(field.source().parts));
    for (const auto& notes : {plan->headland.notes, plan->swaths.notes}) {
        for (const Note& note : notes) {
            plan->findings.push_back({.severity = Severity::Note,
                                      .kind = note.where,
                                      .place = note.place ? field.frame().toLocal(*note.place) : middle,
                                      .text = message("{}.", note.text),
                                      .suggestion = ""});
        }
    }
    for (const Note& repair : field.repairs()) {
        plan->findings.push_back({.severity = Severity::Note,
                                  .kind = "repair",
                                  .place = repair.place ? field.frame().toLocal(*repair.place) : middle,
                                  .text = message("Repaired in {}: {}.", repair.where, repair.text),
                                  .suggestion = ""});
    }
    plan->timings.total = seconds(std::chrono::duration<double>(Clock::now() - begin).count());
    job.report(1.0);
    return std::shared_ptr<const Plan>{plan};
}

}  // namespace furrow
