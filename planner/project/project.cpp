#include "planner/project/project.h"

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"

#include <algorithm>
#include <format>

namespace furrow {

bool operator==(const ProjectField& a, const ProjectField& b) {
    return a.id == b.id && (a.source == b.source || *a.source == *b.source) && a.plans == b.plans &&
           a.others == b.others && a.obstacleOthers == b.obstacleOthers && a.gateOthers == b.gateOthers;
}

bool operator==(const Project& a, const Project& b) {
    return a.name == b.name && a.currentField == b.currentField && a.currentPlan == b.currentPlan &&
           a.standard == b.standard && a.imagery == b.imagery && a.others == b.others &&
           a.otherFeatures == b.otherFeatures &&
           std::ranges::equal(a.fields, b.fields, [](const auto& left, const auto& right) {
               return left == right || *left == *right;
           });
}

Project Project::empty() {
    return {.name = {},
            .fields = {},
            .standard = {.id = "standard",
                         .name = {},
                         .season = {},
                         .machine = machineLibrary().front(),
                         .settings = {},
                         .review = {},
                         .others = {}},
            .imagery = {},
            .others = {},
            .otherFeatures = {}};
}

const ProjectField* Project::field() const {
    return currentField < fields.size() ? fields[currentField].get() : nullptr;
}

const FieldPlan& Project::plan() const {
    const ProjectField* shown = field();
    return shown == nullptr ? standard : shown->plans[std::min(currentPlan, shown->plans.size() - 1)];
}

const FieldPlan& Project::planOf(std::size_t index) const {
    return index == currentField ? plan() : fields[index]->plans.front();
}

std::string freeFieldId(const Project& project) {
    for (std::size_t number = project.fields.size() + 1;; ++number) {
        const std::string id = std::format("field-{}", number);
        if (std::ranges::none_of(project.fields, [&id](const auto& field) { return field->id == id; })) {
            return id;
        }
    }
}

std::string freePlanId(const Project& project) {
    std::size_t plans = 0;
    for (const auto& field : project.fields) {
        plans += field->plans.size();
    }
    for (std::size_t number = plans + 1;; ++number) {
        const std::string id = std::format("plan-{}", number);
        if (std::ranges::none_of(project.fields, [&id](const auto& field) {
                return std::ranges::contains(field->plans, id, &FieldPlan::id);
            })) {
            return id;
        }
    }
}

FieldPlan planForAnotherField(const FieldPlan& plan) {
    FieldPlan next = plan;
    next.review = {};
    next.order = orderForAnotherPlan(plan.order);
    next.others.clear();
    for (const Parameter* parameter : allParameters()) {
        const bool namesPlaces =
            parameter->kind == ParameterKind::Line || parameter->kind == ParameterKind::Lines ||
            parameter->kind == ParameterKind::Place || parameter->kind == ParameterKind::Places ||
            parameter->kind == ParameterKind::Numbers || parameter->key == "swaths.edge";
        if (!namesPlaces || !next.settings.isSet(*parameter)) {
            continue;
        }
        next.settings.clear(*parameter);
        // A method that was chosen for such a place cannot go on without it.
        for (const StageInfo& stage : stages()) {
            const auto method =
                std::ranges::find(stage.methods, next.settings.choice(*stage.method), &MethodInfo::id);
            if (method != stage.methods.end() && std::ranges::contains(method->parameters, parameter)) {
                next.settings.clear(*stage.method);
            }
        }
    }
    return next;
}

}  // namespace furrow
