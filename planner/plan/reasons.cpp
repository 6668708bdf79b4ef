#include "planner/plan/reasons.h"

#include "planner/geometry/polygon.h"
#include "planner/geometry/segment.h"
#include "planner/headland/finishing_passes.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/headland/turning_room.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/swaths/methods.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace furrow {

namespace {

/// The setting that says how wide the headland is; nothing where the planner chooses.
const Parameter* headlandSetting(const Settings& settings) {
    if (!headlandMethod(settings).traits.isOneWidth) {
        return stageMethod("headland");
    }
    for (const Parameter* parameter : {&kHeadlandWidth, &kHeadlandPasses}) {
        if (settings.isSet(*parameter)) {
            return parameter;
        }
    }
    return nullptr;
}

/// A setting that was given and decides which way swaths run, or how long they are.
const Parameter* swathSetting(const Settings& settings) {
    for (const Parameter* parameter : {stageMethod("swaths"), &kObjective, &kSplit}) {
        if (settings.isSet(*parameter)) {
            return parameter;
        }
    }
    return nullptr;
}

Message tooNarrow(const Plan& plan) {
    if (const Parameter* const swaths = swathSetting(plan.request.settings)) {
        return message(
            "The field is too narrow for this machine to turn in: take a smaller machine, or let the swaths run along "
            "the field ({}).",
            swaths->key);
    }
    if (plan.margin > Length{}) {
        return message(
            "The field is too narrow for this machine to turn in: take a smaller machine or a smaller margin ({}).",
            kMargin.key);
    }
    return "The field is too narrow for this machine to turn in: take a smaller machine.";
}

Message noHeadland(const Parameter& setting) {
    return message("Without a headland ({}) there is no room to turn.", setting.key);
}

Message whyOutside(const Plan& plan) {
    const Settings& settings = plan.request.settings;
    const Parameter* const headland = headlandSetting(settings);
    if (plan.headland.passes == 0 && headland != nullptr) {
        return noHeadland(*headland);
    }
    const Length room =
        plan.margin + roomForTurns(plan.request.machine, turnMethod(settings).run, drawsOutEnds(settings),
                                   settings.length(kOverhang).value_or(Length{}));
    if (!plan.headland.narrowed) {
        return headland != nullptr && plan.headland.width < room
                   ? message("A turn of this machine needs {:.1f} m of headland; it is {:.1f} m ({}).",
                             room.si(), plan.headland.width.si(), headland->key)
                   : Message{};
    }
    return tooNarrow(plan);
}

/// In the mainland, or no farther from it than swaths reach.
bool isAtMainland(const Plan& plan, Point place) {
    double nearestM = std::numeric_limits<double>::infinity();
    forEachEdge(plan.headland.mainland,
                [&](Point a, Point b) { nearestM = std::min(nearestM, distanceToSegment(place, a, b)); });
    return nearestM < plan.request.machine.operatingWidth().si() || isInside(plan.headland.mainland, place);
}

Message whyMissed(const Plan& plan, Point place) {
    const Settings& settings = plan.request.settings;
    const Parameter& method = *stageMethod("swaths");
    if (const Parameter* const headland = headlandSetting(settings);
        plan.headland.passes == 0 && headland != nullptr) {
        return noHeadland(*headland);
    }
    if (plan.headland.passes > 0 && !settings.flag(kHeadlandDriven)) {
        return message("No passes are driven in the headland ({}).", kHeadlandDriven.key);
    }
    if (settings.isSet(method) && isAtMainland(plan, place)) {
        return message("The chosen swaths ({}) do not reach it.", method.key);
    }
    if (plan.headland.passes > 0 && !settings.flag(kStayInside)) {
        return message("Land that is left is not finished if the machine may leave the field ({}).",
                       kStayInside.key);
    }
    return settings.flag(kHeadlandFinish)
               ? Message{}
               : message("Land that is left is not finished, because that is switched off ({}).",
                         kHeadlandFinish.key);
}

}  // namespace

void addReasons(Plan& plan) {
    std::optional<Message> outside;
    for (Finding& finding : plan.findings) {
        if (finding.severity != Severity::Blocking || !finding.suggestion.text().empty()) {
            continue;
        }
        if (finding.kind == FindingKind::Outside) {
            outside = outside ? outside : whyOutside(plan);
            finding.suggestion = *outside;
        } else if (finding.kind == FindingKind::Missed) {
            finding.suggestion = whyMissed(plan, finding.place);
        }
    }
}

}  // namespace furrow
