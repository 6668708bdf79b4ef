#include "planner/plan/audit_input.h"

#include "planner/geometry/curve_sampling.h"
#include "planner/path/refill_stops.h"
#include "planner/plan/general_parameters.h"

#include <ranges>

namespace furrow {

namespace {

Polyline lineOf(const Curve& turn) {
    Polyline line;
    for (const CurveSample& sample : sampled(turn, kChordTolerance)) {
        line.push_back(sample.pose.position);
    }
    return line;
}

void addPasses(std::span<const HeadlandPass> headland, std::vector<PlannedPass>& passes) {
    for (const HeadlandPass& pass : headland) {
        for (const PassStretch& stretch : pass.stretches | std::views::filter(&PassStretch::working)) {
            passes.push_back({.line = lineOf(stretch.line),
                              .width = pass.width,
                              .number = pass.ring + 1,
                              .kind = SegmentKind::HeadlandPass});
        }
    }
}

}  // namespace

AuditInput auditInput(const AuditedParts& plan) {
    const Field& field = *plan.request.field;
    AuditInput input{.workable = field.workable(),
                     .drivable = field.drivable(),
                     .overhung = plan.overhung,
                     .gates = {},
                     .machine = plan.request.machine,
                     .segments = plan.path.segments,
                     .passes = {},
                     .mainland = {},
                     .margin = plan.margin,
                     .leftOnPurpose = plan.leftOnPurpose,
                     .mayLeaveField = !plan.request.settings.flag(kStayInside)};
    if (plan.refill != nullptr) {
        input.tank = AuditTank{.gathers = plan.refill->work.gathers,
                               .points = plan.refill->points,
                               .reach = refillReach(plan.request.machine)};
    }
    for (const Gate& gate : field.source().gates) {
        input.gates.push_back({field.frame().toLocal(gate.position), gate.width});
    }
    for (const RouteStep& step : plan.route.steps) {
        const Swath& swath = plan.swaths.swaths[step.swath];
        input.passes.push_back(
            {.line = drivenMiddle(step, plan.swaths), .width = swath.width, .number = swath.number});
    }
    addPasses(plan.headland.drivenPasses, input.passes);
    addPasses(plan.finishing, input.passes);
    if (plan.headland.width > Length{} && plan.headland.drivenPasses.empty() && plan.finishing.empty()) {
        input.mainland = plan.mainland;
    }
    return input;
}

}  // namespace furrow
