#include "planner/plan/plan.h"

#include "planner/field/drivable_area.h"
#include "planner/field/small_obstacles.h"
#include "planner/geometry/convex_hull.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/plan/as_asked.h"
#include "planner/plan/drive_stage.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/quicker_choice.h"
#include "planner/plan/reasons.h"
#include "planner/plan/round_stage.h"
#include "planner/plan/swath_stage.h"
#include "planner/swaths/methods.h"
#include "planner/turns/turn_sampling.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace furrow {

namespace {

using Clock = std::chrono::steady_clock;

// Of the progress where obstacles may have to be planned once more.
constexpr double kFirstTry = 0.95;

/// Runs one stage and adds how long it took.
template <class Run>
auto timed(Duration& taken, const Run& run) {
    const Clock::time_point begin = Clock::now();
    auto result = run();
    taken += seconds(std::chrono::duration<double>(Clock::now() - begin).count());
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
              .remedy = margin > Length{}
                            ? message("choose a smaller machine or a smaller margin ({})", kMargin.key)
                            : Message{"choose a smaller machine or check the boundary's coordinate system"},
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

/// The notes of all stages, as findings behind what was found.
void addNotes(Plan& plan) {
    const Field& field = plan.field();
    const Point middle = field.frame().toLocal(middleOf(field.source().parts));
    for (const auto& notes : {plan.notes, plan.headland.notes, plan.swaths.notes}) {
        for (const Note& note : notes) {
            plan.findings.push_back({.severity = Severity::Note,
                                     .kind = note.where,
                                     .place = note.place ? field.frame().toLocal(*note.place) : middle,
                                     .text = message("{}.", note.text.capitalised()),
                                     .suggestion = ""});
        }
    }
    for (const Note& repair : field.repairs()) {
        plan.findings.push_back({.severity = Severity::Note,
                                 .kind = "repair",
                                 .place = repair.place ? field.frame().toLocal(*repair.place) : middle,
                                 .text = message("Repaired in {}: {}.", repair.where, repair.text),
                                 .suggestion = ""});
    }
}

/// The headland and where it lies, as the settings have it.
Result<Headland> headlandAlong(const Plan& plan, const MultiPolygon& workable, const MultiPolygon& drivable, const JobContext& job) {
    const PlanRequest& request = plan.request;
    const Settings& settings = request.settings;
    return headlandMethod(settings)(
        {.field = *request.field,
         .drivable = drivable,
         .machine = request.machine,
         .turn = turnMethod(settings),
         .settings = settings,
         .margin = plan.margin,
         .drawsOutEnds = drawsOutEnds(settings),
         .swathEnds = [&](const MultiPolygon& mainland) { return swathEnds(request, mainland, job); },
         .along = &workable},
        job);
}

/// Headland and swaths, with swaths that go round these obstacles or as many of them as they can.
Result<LaidSwaths> layOutRound(Plan& plan, std::vector<Ring> obstacles, const MultiPolygon& drivable, const JobContext& job) {
    for (bool again = false;; again = true) {
        const JobContext part = again ? job.quiet() : job;
        const MultiPolygon workable = filled(plan.field().drivable(), obstacles);
        auto headland = timed(plan.timings.headland, [&] { return headlandAlong(plan, workable, drivable, part.part(0.0, 0.1)); });
        if (!headland) {
            return std::unexpected(headland.error());
        }
        plan.headland = std::move(*headland);
        if (eraseOutside(obstacles, plan)) {
            continue;
        }
        Result<bool> wasRefused = false;
        auto laid = timed(plan.timings.swaths, [&] {
            auto swaths = layStage(plan, workable, drivable, part.part(0.1, 0.78));
            if (swaths) {
                plan.swaths = swaths->swaths;
                wasRefused = roundStage(plan, obstacles, drivable, part.part(0.78, 0.8));
            }
            return swaths;
        });
        if (!wasRefused) {
            return std::unexpected(wasRefused.error());
        }
        if (!laid || !*wasRefused) {
            return laid;
        }
    }
}

/// All stages, with swaths that go round these obstacles or as many of them as they can.
Result<std::shared_ptr<Plan>> plannedRound(const PlanRequest& request, std::vector<Ring> obstacles,
                                           const MultiPolygon& drivable, Length margin, std::optional<Duration> atMost,
                                           const JobContext& job) {
    auto plan = std::make_shared<Plan>(Plan{.request = request, .margin = margin});
    const auto laid = layOutRound(*plan, std::move(obstacles), drivable, job);
    if (!laid) {
        return std::unexpected(laid.error());
    }
    auto route = timed(plan->timings.route, [&]() -> Result<Route> {
        auto cells = cellStage(request, *laid, job.part(0.8, 0.82));
        if (!cells) {
            return std::unexpected(cells.error());
        }
        plan->cells = std::move(*cells);
        if (auto cut = cutOutGoneRound(*plan, job); !cut) {
            return std::unexpected(cut.error());
        }
        return routeMethod(request.settings)(routeTask(*plan), job.part(0.82, 0.85));
    });
    if (!route) {
        return std::unexpected(route.error());
    }
    plan->route = std::move(*route);
    if (auto driven = driveStage(*plan, drivable, atMost, job.part(0.85, 1.0)); !driven) {
        return std::unexpected(driven.error());
    }
    return plan;
}

}  // namespace

std::ptrdiff_t Plan::blockingCount() const {
    return std::ranges::count(findings, Severity::Blocking, &Finding::severity);
}

bool Plan::drivable() const {
    return blockingCount() == 0;
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
                     .margin = plan.margin,
                     .leftOnPurpose = plan.leftOnPurpose,
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

RouteTask routeTask(const Plan& plan) {
    const PlanRequest& request = plan.request;
    RouteTask task{.swaths = plan.swaths,
                   .machine = request.machine,
                   .turn = turnMethod(request.settings),
                   .settings = request.settings};
    for (const Cell& cell : plan.cells.cells) {
        task.cells.push_back(cell.swaths);
    }
    return task;
}

Result<std::shared_ptr<const Plan>> makePlan(const PlanRequest& request, const JobContext& job) {
    const Clock::time_point begin = Clock::now();
    auto plan = quickestChoice(request, job);
    if (!plan) {
        return std::unexpected(plan.error());
    }
    addReasons(**plan);
    addNotes(**plan);
    (*plan)->timings.total = seconds(std::chrono::duration<double>(Clock::now() - begin).count());
    job.report(1.0);
    return std::shared_ptr<const Plan>{std::move(*plan)};
}

Result<std::shared_ptr<Plan>> planAsAsked(const PlanRequest& request, const JobContext& job, std::optional<Duration> atMost) {
    const Field& field = *request.field;
    const Machine& machine = request.machine;
    const Length margin = request.settings.length(kMargin).value_or(field.source().boundaryAccuracy);

    if (auto fits = checkThatItFits(field, machine, margin, job); !fits) {
        return std::unexpected(fits.error());
    }
    const auto drivable = drivableArea(field, margin, job);
    if (!drivable) {
        return std::unexpected(drivable.error());
    }
    const std::vector<Ring> small = smallObstacles(field, roundUpTo(request.settings, machine));
    auto best = plannedRound(request, small, *drivable, margin, atMost, job.part(0.0, small.empty() ? 1.0 : kFirstTry));
    if (!best) {
        return std::unexpected(best.error());
    }
    // What is blocked near obstacles that are gone round may be better off with headlands there, or everywhere.
    for (const bool isLast : {false, true}) {
        const Plan& blocked = **best;
        if (request.draft || blocked.drivable() || blocked.swaths.goneRound.empty()) {
            break;
        }
        const std::vector<Ring> fewer = isLast ? std::vector<Ring>{} : awayFromBlocking(blocked);
        if (fewer.size() == blocked.swaths.goneRound.size()) {
            continue;
        }
        auto other = plannedRound(request, fewer, *drivable, margin, atMost, job.quiet());
        if (!other && other.error().code == ErrorCode::Cancelled) {
            return std::unexpected(other.error());
        }
        // Headlands may leave nothing to work.
        if (other && (*other)->blockingCount() < blocked.blockingCount()) {
            best = std::move(other);
        }
    }
    return best;
}

}  // namespace furrow
