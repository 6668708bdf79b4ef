#include "planner/project/project_edits.h"

#include "planner/decomposition/decomposition.h"
#include "planner/field/outline_steps.h"
#include "planner/plan/method_registry.h"

#include <algorithm>
#include <format>
#include <utility>

namespace furrow {

namespace {

/// Lets `change` work on a copy of the current field.
template <class Change>
Project withField(Project project, Change change) {
    if (const ProjectField* shown = project.field()) {
        ProjectField field = *shown;
        change(field);
        project.fields[project.currentField] = std::make_shared<const ProjectField>(std::move(field));
    }
    return project;
}

template <class Change>
Project withSourceChanged(Project project, Change change) {
    return withField(std::move(project), [&change](ProjectField& field) {
        FieldSource source = *field.source;
        change(field, source);
        field.source = std::make_shared<const FieldSource>(std::move(source));
    });
}

const Parameter& parameterOf(std::string_view key) {
    return **findParameter(key);
}

bool hasSwathMethod(std::string_view id) {
    return std::ranges::contains(stageInfo("swaths").methods, id, &MethodInfo::id);
}

/// Methods that lay swaths along a line of at least two points.
bool followsLine(const std::string& method) {
    return method == "ab-line" || method == "ab-curve";
}

/// Coordinates as well-known text has them.
std::string pointsText(const GeoRing& line) {
    std::string text;
    for (const GeoPoint& point : line) {
        text += std::format("{}{} {}", text.empty() ? "" : ", ", point.lonDeg, point.latDeg);
    }
    return text;
}

/// A plan to go on from: what was said of the first one and ordered with it stays there.
FieldPlan copyUnder(FieldPlan plan, std::string id, const std::string& name) {
    plan.id = std::move(id);
    plan.name = name;
    plan.review = {};
    plan.order = orderForAnotherPlan(plan.order);
    return plan;
}

std::size_t indexOf(const ProjectField& field, const FieldPlan& plan) {
    return static_cast<std::size_t>(
        std::distance(field.plans.begin(), std::ranges::find(field.plans, plan.id, &FieldPlan::id)));
}

template <class Entry>
void erase(std::vector<Entry>& list, std::size_t index) {
    if (index < list.size()) {
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
    }
}

}  // namespace

Project withSource(Project project, FieldSource source) {
    return withField(std::move(project), [&source](ProjectField& field) {
        field.source = std::make_shared<const FieldSource>(std::move(source));
    });
}

Project withPlan(Project project, const Machine& machine, const Settings& settings) {
    const auto change = [&](FieldPlan& plan) {
        plan.machine = machine;
        plan.settings = settings;
    };
    if (project.field() == nullptr) {
        change(project.standard);
        return project;
    }
    const std::size_t current = project.currentPlan;
    return withField(std::move(project), [&](ProjectField& field) {
        change(field.plans[std::min(current, field.plans.size() - 1)]);
    });
}

Project withFields(Project project, std::vector<FieldSource> sources) {
    const FieldPlan plan = planForAnotherField(project.plan());
    const std::size_t first = project.fields.size();
    for (FieldSource& source : sources) {
        ProjectField field{.id = freeFieldId(project),
                           .source = std::make_shared<const FieldSource>(std::move(source)),
                           .plans = {plan},
                           .others = {},
                           .obstacleOthers = {},
                           .gateOthers = {}};
        field.plans.front().id = freePlanId(project);
        project.fields.push_back(std::make_shared<const ProjectField>(std::move(field)));
    }
    return showing(std::move(project), first, 0);
}

Project withoutField(Project project) {
    erase(project.fields, project.currentField);
    const std::size_t field = project.currentField;
    return showing(std::move(project), field, 0);
}

Project withObstacle(Project project, Obstacle obstacle) {
    return withSourceChanged(std::move(project), [&obstacle](ProjectField&, FieldSource& source) {
        source.obstacles.push_back(std::move(obstacle));
    });
}

Project withGate(Project project, Gate gate) {
    return withSourceChanged(std::move(project), [&gate](ProjectField&, FieldSource& source) {
        source.gates.push_back(std::move(gate));
    });
}

Project withHole(Project project, std::size_t part, GeoRing hole) {
    return withSourceChanged(std::move(project), [part, &hole](ProjectField&, FieldSource& source) {
        if (part < source.parts.size()) {
            source.parts[part].holes.push_back(std::move(hole));
        }
    });
}

Project withoutHole(Project project, std::size_t part, std::size_t hole) {
    return withSourceChanged(std::move(project), [part, hole](ProjectField&, FieldSource& source) {
        if (part < source.parts.size()) {
            erase(source.parts[part].holes, hole);
            for (std::vector<EdgeWidth>* widths : {&source.edgeHeadlands, &source.edgeOverhangs}) {
                std::erase_if(*widths,
                              [&](const EdgeWidth& own) { return own.part == part && own.ring == hole + 1; });
                for (EdgeWidth& own : *widths) {
                    own.ring -= own.part == part && own.ring > hole + 1 ? 1 : 0;
                }
            }
        }
    });
}

bool canFollowCurves() {
    return hasSwathMethod("ab-curve");
}

Project withGuide(Project project, const GeoRing& line) {
    Settings settings = project.plan().settings;
    const Parameter& method = parameterOf("swaths.method");
    if (line.size() < 2) {
        settings.clear(parameterOf("swaths.line"));
        if (followsLine(settings.choice(method))) {
            settings.clear(method);
        }
        const Machine machine = project.plan().machine;
        return withPlan(std::move(project), machine, settings);
    }
    const bool curve = line.size() > 2 && canFollowCurves();
    const std::string points = pointsText(curve ? line : GeoRing{line.front(), line.back()});
    const bool set = settings.set(parameterOf("swaths.line"), std::format("LINESTRING ({})", points)) &&
                     settings.set(method, std::string{curve ? "ab-curve" : "ab-line"});
    const Machine machine = project.plan().machine;
    return set ? withPlan(std::move(project), machine, settings) : project;
}

Project withSplits(Project project, const std::vector<GeoRing>& lines) {
    Settings settings = project.plan().settings;
    settings.clear(kSplit);
    std::string text;
    for (const GeoRing& line : lines) {
        text += std::format("{}({})", text.empty() ? "" : ", ", pointsText(line));
    }
    if (!text.empty() && !settings.set(kSplit, std::format("MULTILINESTRING ({})", text))) {
        return project;
    }
    const Machine machine = project.plan().machine;
    return withPlan(std::move(project), machine, settings);
}

DrawnLines linesOf(const Project& project) {
    const Settings& settings = project.plan().settings;
    return {.guide = followsLine(settings.choice(parameterOf("swaths.method")))
                         ? settings.line(parameterOf("swaths.line"))
                         : GeoRing{},
            .splits = settings.lines(kSplit)};
}

Project withoutObstacle(Project project, std::size_t obstacle) {
    return withSourceChanged(std::move(project), [obstacle](ProjectField& field, FieldSource& source) {
        erase(source.obstacles, obstacle);
        erase(field.obstacleOthers, obstacle);
    });
}

Project withoutGate(Project project, std::size_t gate) {
    return withSourceChanged(std::move(project), [gate](ProjectField& field, FieldSource& source) {
        erase(source.gates, gate);
        erase(field.gateOthers, gate);
    });
}

Project withWorkOrder(Project project, WorkOrder order) {
    if (project.field() == nullptr) {
        return project;
    }
    const std::size_t current = project.currentPlan;
    return withField(std::move(project), [&](ProjectField& field) {
        field.plans[std::min(current, field.plans.size() - 1)].order = std::move(order);
    });
}

Project withPlanCopy(Project project, const std::string& name) {
    const FieldPlan copy = copyUnder(project.plan(), freePlanId(project), name);
    project = withField(std::move(project), [&copy](ProjectField& field) { field.plans.push_back(copy); });
    const std::size_t field = project.currentField;
    const std::size_t last = project.field() != nullptr ? project.field()->plans.size() - 1 : 0;
    return showing(std::move(project), field, last);
}

Project withStraightSteps(Project project, std::span<const std::size_t> fields) {
    for (const std::size_t index : fields) {
        const FieldSource& source = *project.fields[index]->source;
        auto straight = withStraightSteps(source);
        if (straight && *straight != source) {
            ProjectField field = *project.fields[index];
            field.source = std::make_shared<const FieldSource>(*std::move(straight));
            project.fields[index] = std::make_shared<const ProjectField>(std::move(field));
        }
    }
    return project;
}

Project withPlansLike(Project project, std::span<const std::size_t> fields, const FieldPlan& like) {
    const FieldPlan next = planForAnotherField(like);
    const Project before = project;
    for (const std::size_t index : fields) {
        // The plan that is the example may hold places of its own field.
        if (index == project.currentField && project.plan().id == like.id) {
            continue;
        }
        ProjectField field = *before.fields[index];
        FieldPlan& plan = field.plans[indexOf(field, before.planOf(index))];
        plan.machine = next.machine;
        plan.settings = next.settings;
        project.fields[index] = std::make_shared<const ProjectField>(std::move(field));
    }
    return project;
}

Project withPlansAdded(Project project, std::span<const std::size_t> fields, const std::string& name,
                       const std::string& season) {
    for (const std::size_t index : fields) {
        FieldPlan copy = copyUnder(project.planOf(index), freePlanId(project), name);
        copy.season = season;
        ProjectField field = *project.fields[index];
        field.plans.insert(field.plans.begin(), std::move(copy));
        project.fields[index] = std::make_shared<const ProjectField>(std::move(field));
        if (index == project.currentField) {
            project.currentPlan = 0;
        }
    }
    return project;
}

Project withoutPlan(Project project) {
    const std::size_t current = project.currentPlan;
    project = withField(std::move(project), [current](ProjectField& field) {
        if (field.plans.size() > 1) {
            erase(field.plans, current);
        }
    });
    const std::size_t field = project.currentField;
    return showing(std::move(project), field, current);
}

Project withFieldName(Project project, const std::string& name) {
    return withSourceChanged(std::move(project),
                             [&name](ProjectField&, FieldSource& source) { source.name = name; });
}

Project withPlanName(Project project, const std::string& name, const std::string& season) {
    const std::size_t current = project.currentPlan;
    return withField(std::move(project), [&](ProjectField& field) {
        FieldPlan& plan = field.plans[std::min(current, field.plans.size() - 1)];
        plan.name = name;
        plan.season = season;
    });
}

Project withReview(Project project, Review review) {
    const std::size_t current = project.currentPlan;
    return withField(std::move(project), [&](ProjectField& field) {
        field.plans[std::min(current, field.plans.size() - 1)].review = std::move(review);
    });
}

Project withImagery(Project project, std::vector<ImageryLayer> layers) {
    std::ranges::move(layers, std::back_inserter(project.imagery));
    return project;
}

Project withImageryLayer(Project project, std::size_t index, ImageryLayer layer) {
    if (index < project.imagery.size()) {
        project.imagery[index] = std::move(layer);
    }
    return project;
}

Project withoutImageryLayer(Project project, std::size_t index) {
    erase(project.imagery, index);
    return project;
}

Project withImageryMoved(Project project, std::size_t from, std::size_t to) {
    if (from < project.imagery.size()) {
        ImageryLayer layer = std::move(project.imagery[from]);
        erase(project.imagery, from);
        const std::size_t place = std::min(to, project.imagery.size());
        project.imagery.insert(project.imagery.begin() + static_cast<std::ptrdiff_t>(place),
                               std::move(layer));
    }
    return project;
}

Project showing(Project project, std::size_t field, std::size_t plan) {
    project.currentField = project.fields.empty() ? 0 : std::min(field, project.fields.size() - 1);
    project.currentPlan =
        project.fields.empty() ? 0 : std::min(plan, project.fields[project.currentField]->plans.size() - 1);
    return project;
}

}  // namespace furrow
