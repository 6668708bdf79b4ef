#include "planner/plan/draft.h"

#include "planner/decomposition/decomposition.h"
#include "planner/headland/finishing_passes.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/route/route.h"
#include "planner/swaths/methods.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"

#include <algorithm>
#include <array>

namespace furrow {

namespace {

void choose(Settings& settings, std::string_view stage, std::string_view method) {
    settings.set(*stageMethod(stage), std::string{method}).value();
}

/// The swaths of a plan in their order, in the frame of a field whose boundary may have changed.
std::vector<DrivenSwath> swathsInOrder(const Plan& plan, const LocalFrame& frame) {
    const auto here = [&](Point place) { return frame.toLocal(plan.field().frame().toGeo(place)); };
    std::vector<DrivenSwath> swaths;
    for (const RouteStep& step : plan.route.steps) {
        const DrivenSwath swath = drivenSwath(step, plan.swaths);
        swaths.push_back({.from = here(swath.from), .middle = here(swath.middle), .to = here(swath.to)});
    }
    return swaths;
}

}  // namespace

PlanRequest draftOf(PlanRequest request, const Plan* before) {
    Settings& settings = request.settings;
    request.draft = true;
    const bool onlyFieldChanged = before != nullptr && before->request.machine == request.machine &&
                                  before->request.settings == request.settings;
    if (onlyFieldChanged) {
        request.earlier = swathsInOrder(*before, request.field->frame());
    }
    if (swathMethod(settings).traits.searchesHeadings) {
        if (before != nullptr) {
            choose(settings, "swaths", kFixedHeadingMethod.info.id);
            settings.set(kAngle, inDegrees(before->swaths.heading)).value();
        } else {
            choose(settings, "swaths", kLongestEdgeMethod.info.id);
        }
    }
    settings.clear(kCellHeading);
    const bool ownWidth = settings.isSet(kHeadlandWidth) || settings.isSet(kHeadlandPasses);
    if (headlandMethod(settings).traits.isOneWidth && before != nullptr && !ownWidth &&
        before->request.machine == request.machine && before->headland.width > metres(0.0)) {
        // As wide as the passes make it that are left out.
        settings.set(kHeadlandWidth, before->headland.width.si()).value();
    }
    settings.set(kHeadlandDriven, false).value();
    settings.set(kHeadlandFinish, false).value();
    settings.set(kStayInside, false).value();
    if (turnMethod(settings).traits.isAnyKind) {
        const auto& spec = request.machine.spec();
        const bool reverses = spec.tractor.canReverse && spec.implement.canReverse;
        choose(settings, "path", reverses ? kReedsSheppMethod.info.id : kDubinsMethod.info.id);
    }
    return request;
}

}  // namespace furrow
