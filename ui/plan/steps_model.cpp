#include "ui/plan/steps_model.h"

#include "planner/headland/headland.h"
#include "planner/io/import/boundary_import.h"
#include "planner/path/blocking.h"
#include "planner/plan/method_registry.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <utility>

namespace furrow {

namespace {

/// The setting that picks the method, those of the method, and those of the stage.
std::vector<const Parameter*> parametersOf(const StageInfo& stage, const Settings& settings) {
    std::vector<const Parameter*> all;
    if (stage.methods.size() > 1) {
        all.push_back(stage.method);
    }
    const auto add = [&all](std::span<const Parameter* const> more) {
        for (const Parameter* parameter : more) {
            if (std::ranges::find(all, parameter) == all.end()) {
                all.push_back(parameter);
            }
        }
    };
    const auto method = std::ranges::find(stage.methods, settings.choice(*stage.method), &MethodInfo::id);
    if (method != stage.methods.end()) {
        add(method->parameters);
    }
    add(stage.parameters);
    return all;
}

QString methodName(const StageInfo& stage, const Settings& settings) {
    const auto method = std::ranges::find(stage.methods, settings.choice(*stage.method), &MethodInfo::id);
    return method == stage.methods.end() ? QString{} : shown(method->name);
}

/// Edges with a width of their own are told where the method says that all have the same.
QString methodOf(const StageInfo& stage, const StepsContent& content) {
    const QString name = methodName(stage, content.settings);
    const auto edges = content.field == nullptr ? 0 : content.field->source().edgeHeadlands.size();
    return stage.id == "headland" && edges > 0 && headlandMethod(content.settings).traits.isOneWidth
               ? StepsModel::tr("%1 but for %n edge(s)", nullptr, static_cast<int>(edges)).arg(name)
               : name;
}

/// The step in which what a finding tells is decided.
std::string_view stepOf(const Finding& finding) {
    switch (finding.kind) {
        case FindingKind::Gate:
        case FindingKind::Repair: return "field";
        case FindingKind::Refill: return "route";
        case FindingKind::DroppedPass:
        case FindingKind::HeadlandNotWorked: return "headland";
        case FindingKind::DroppedSwath:
        case FindingKind::Missed: return "swaths";
        default: return "path";  // the way that is driven
    }
}

int problemsOf(std::string_view step, const Plan& plan) {
    return static_cast<int>(std::ranges::count_if(plan.findings, [step](const Finding& finding) {
        return isBlocking(finding) && stepOf(finding) == step;
    }));
}

/// What came of a stage, in one line; empty for stages that are not known here.
QString resultOf(std::string_view stage, const Plan& plan) {
    if (stage == "headland") {
        return plan.headland.width.si() <= 0.0
                   ? StepsModel::tr("%1 inside").arg(percentText(plan.headland.mainlandRatio))
                   : inOneLine({metresText(narrowestWidth(plan.headland), plan.headland.width),
                                StepsModel::tr("%n pass(es)", nullptr, plan.headland.passes),
                                StepsModel::tr("%1 inside").arg(percentText(plan.headland.mainlandRatio))});
    }
    if (stage == "decomposition") {
        return StepsModel::tr("%n block(s)", nullptr, static_cast<int>(plan.cells.cells.size()));
    }
    if (stage == "swaths") {
        return inOneLine({StepsModel::tr("%n swath(s)", nullptr, static_cast<int>(plan.swaths.swaths.size())),
                          lengthText(plan.swaths.totalLength), bearingText(plan.swaths.heading)});
    }
    if (stage == "route") {
        if (plan.proof) {
            return plan.proof->isBest()
                       ? StepsModel::tr("proved: no order is better")
                       : StepsModel::tr("turns within %1 of the best").arg(percentText(plan.proof->gap(), 1));
        }
        return StepsModel::tr("%1 with turns on the spot").arg(lengthText(plan.route.lengthInPlace));
    }
    if (stage == "path") {
        return inOneLine({StepsModel::tr("%n turn(s)", nullptr, plan.path.turnCount()),
                          lengthText(plan.path.length(SegmentKind::Turn))});
    }
    return {};
}

/// What stands behind the result of a step that findings block.
QString withProblems(const QString& result, int problems) {
    QStringList parts;
    if (!result.isEmpty()) {
        parts << result;
    }
    if (problems > 0) {
        parts << StepsModel::tr("%n problem(s)", nullptr, problems);
    }
    return inOneLine(parts);
}

}  // namespace

StepsModel::StepsModel(QObject* parent) : QAbstractListModel{parent} {
    const auto add = [this](QString id, std::string_view name,
                            const std::vector<const Parameter*>& parameters) {
        auto* model = new ParameterModel{this};
        model->show(parameters, {}, nullptr);
        connect(model, &ParameterModel::changeRequested, this, &StepsModel::changeRequested);
        connect(model, &ParameterModel::pickRequested, this, &StepsModel::pickRequested);
        steps_.push_back({std::move(id), name, {}, {}, Status::None, model});
    };
    // Names of the steps follow the language by themselves, what is in them when it is shown again.
    connect(&Display::instance(), &Display::changed, this,
            [this] { emit dataChanged(index(0), index(rowCount() - 1)); });
    const auto general = generalParameters();
    add(QStringLiteral("field"), "Field", {general.begin(), general.end()});
    add(QStringLiteral("machine"), "Machine", {});
    for (const StageInfo& stage : stages()) {
        add(fromStd(stage.id), stage.name, parametersOf(stage, {}));
    }
    add(QStringLiteral("check"), "Check", {});
    add(QStringLiteral("export"), "Export", {});
}

void StepsModel::showField(Step& step, const StepsContent& content) {
    step.status = Status::None;
    if (content.field != nullptr) {
        const Field& field = *content.field;
        step.choice = inOneLine({fromStd(field.name()), areaText(field.area())});
        QStringList parts;
        if (const auto count = static_cast<int>(field.source().obstacles.size()); count > 0) {
            parts << tr("%n obstacle(s)", nullptr, count);
        }
        if (const auto count = static_cast<int>(field.holeCount()); count > 0) {
            parts << tr("%n hole(s)", nullptr, count);
        }
        parts << tr("%n boundary point(s)", nullptr, static_cast<int>(field.vertexCount()));
        step.result = inOneLine(parts);
        step.status = Status::Good;
    } else if (content.state == PlanState::Failed) {
        step.choice = tr("No usable boundary");
        step.result = tr("The message on the map says why");
        step.status = Status::Failed;
    } else if (content.source != nullptr) {
        step.choice = fromStd(content.source->name);
        step.result = areaText(areaOf(*content.source));
    } else {
        step.choice = tr("No field yet");
        step.result = tr("Open a file or draw a boundary");
    }
}

void StepsModel::showMachine(Step& step, const StepsContent& content) {
    const Machine& machine = content.machine;
    step.choice = shown(machine.name());
    step.result = inOneLine({tr("%1 wide").arg(metresText(machine.operatingWidth(), 1)),
                             tr("%1 radius").arg(metresText(machine.minTurningRadius(), 1)),
                             speedText(machine.spec().tractor.workingSpeed)});
    step.status = Status::Good;
}

void StepsModel::showCheck(Step& step, const StepsContent& content) {
    step.status = Status::None;
    step.result.clear();
    switch (content.state) {
        case PlanState::Empty:
        case PlanState::Reading:
        case PlanState::Choosing: step.choice = tr("Nothing to check yet"); return;
        case PlanState::Planning:
            if (content.plan != nullptr && content.plan->request.draft) {
                step.choice = tr("First plan, being improved");
                step.result = tr("Only the finished plan is checked");
            } else {
                step.choice = tr("Planning …");
                step.result =
                    content.plan != nullptr ? tr("Until then the map shows the plan before") : QString{};
            }
            return;
        case PlanState::Failed:
            step.choice = tr("No plan");
            step.status = Status::Failed;
            return;
        case PlanState::OutOfDate:
            step.choice = tr("Out of date");
            step.result = tr("Plan again to check what the panels show");
            step.status = Status::Warning;
            return;
        case PlanState::Ready:
        case PlanState::Problems: break;
    }
    const int problems = static_cast<int>(content.plan->blockingCount());
    const int notes = static_cast<int>(content.plan->findings.size()) - problems;
    step.choice = problems > 0 ? tr("%n problem(s)", nullptr, problems) : tr("No problems");
    step.result = notes > 0 ? tr("%n note(s)", nullptr, notes) : QString{};
    step.status = problems > 0 ? Status::Warning : Status::Good;
}

void StepsModel::show(const StepsContent& content) {
    const std::vector<Step> before = steps_;
    const bool finished = isFinished(content.state);
    // What a plan filled in is not shown beside settings that it was not made with.
    const Plan* const filledIn = content.state == PlanState::OutOfDate ? nullptr : content.plan;
    showField(steps_.front(), content);
    const auto general = generalParameters();
    steps_.front().parameters->show({general.begin(), general.end()}, content.settings, filledIn);
    showMachine(steps_[1], content);
    for (std::size_t i = 0; i < stages().size(); ++i) {
        const StageInfo& stage = stages()[i];
        Step& step = steps_[i + 2];
        step.choice = methodOf(stage, content);
        step.result = content.plan == nullptr ? QString{} : resultOf(stage.id, *content.plan);
        step.status = content.plan == nullptr ? Status::None : finished ? Status::Good : Status::Old;
        step.parameters->show(parametersOf(stage, content.settings), content.settings, filledIn);
    }
    for (Step& step : steps_) {
        if (const int problems = finished ? problemsOf(step.id.toStdString(), *content.plan) : 0;
            problems > 0) {
            step.result = withProblems(step.result, problems);
            step.status = Status::Warning;
        }
    }
    showCheck(steps_[steps_.size() - 2], content);
    steps_.back().status = !finished                              ? Status::None
                           : content.state == PlanState::Problems ? Status::Warning
                                                                  : Status::Good;
    steps_.back().choice = finished ? tr("To a stick, to files or on paper")
                           : content.state == PlanState::Failed || content.state == PlanState::Empty
                               ? tr("No plan to export yet")
                               : tr("Waits for the finished plan");
    for (int row = 0; row < rowCount(); ++row) {
        if (const Step& step = steps_[static_cast<std::size_t>(row)];
            step != before[static_cast<std::size_t>(row)]) {
            emit dataChanged(index(row), index(row));
        }
    }
}

int StepsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(steps_.size());
}

QVariant StepsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) {
        return {};
    }
    const Step& step = steps_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case StepIdRole: return step.id;
        case NumberRole: return index.row() + 1;
        case Qt::DisplayRole:
        case NameRole:
            // The planner has no stages of these names.
            return index.row() == 0                ? tr("Field")
                   : index.row() == 1              ? tr("Machine")
                   : index.row() == rowCount() - 2 ? tr("Check")
                   : index.row() == rowCount() - 1 ? tr("Export")
                                                   : shown(step.name);
        case ChoiceRole: return step.choice;
        case ResultRole: return step.result;
        case StatusRole: return static_cast<int>(step.status);
        case ParametersRole: return QVariant::fromValue(step.parameters);
        default: return {};
    }
}

QHash<int, QByteArray> StepsModel::roleNames() const {
    return {{StepIdRole, "stepId"},        {NumberRole, "number"}, {NameRole, "name"},
            {ChoiceRole, "choice"},        {ResultRole, "result"}, {StatusRole, "status"},
            {ParametersRole, "parameters"}};
}

QVariantList StepsModel::searchable() const {
    QVariantList found;
    const auto add = [&found](const QString& name, const QString& group, const QString& keywords,
                              const QString& stepId, std::string_view key, std::string_view value = {}) {
        QVariantMap entry{{QStringLiteral("name"), name},
                          {QStringLiteral("group"), group},
                          {QStringLiteral("keywords"), keywords},
                          {QStringLiteral("stepId"), stepId},
                          {QStringLiteral("key"), fromStd(key)}};
        if (!value.empty()) {
            entry.insert(QStringLiteral("value"), fromStd(value));
        }
        found << entry;
    };
    const auto addParameter = [&](const Parameter& parameter, const QString& group, const QString& stepId) {
        add(shown(parameter.name), group, shown(parameter.description), stepId, parameter.key);
        for (const Choice& choice : parameter.choices) {
            add(tr("%1: %2").arg(shown(parameter.name), shown(choice.name)), group, shown(choice.description),
                stepId, parameter.key, choice.id);
        }
    };
    for (const Parameter* parameter : generalParameters()) {
        addParameter(*parameter, tr("Field"), QStringLiteral("field"));
    }
    for (const StageInfo& stage : stages()) {
        const QString group = shown(stage.name);
        const QString stepId = fromStd(stage.id);
        std::vector<const Parameter*> told{stage.method};
        const auto addOnce = [&](std::span<const Parameter* const> parameters) {
            for (const Parameter* parameter : parameters) {
                if (!std::ranges::contains(told, parameter)) {
                    told.push_back(parameter);
                    addParameter(*parameter, group, stepId);
                }
            }
        };
        for (const MethodInfo& method : stage.methods) {
            add(shown(method.name), group, shown(method.description), stepId, stage.method->key, method.id);
            addOnce(method.parameters);
        }
        addOnce(stage.parameters);
    }
    return found;
}

ParameterModel* StepsModel::parameters(const QString& stepId) const {
    const auto step = std::ranges::find(steps_, stepId, &Step::id);
    return step == steps_.end() ? nullptr : step->parameters;
}

}  // namespace furrow
