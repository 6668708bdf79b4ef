#include "ui/plan/steps_model.h"

#include "planner/io/boundary_import.h"
#include "planner/plan/method_registry.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QStringList>

#include <algorithm>

namespace furrow {

namespace {

const QString kSeparator = QStringLiteral(" · ");

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

int blockingCount(const Plan& plan) {
    return static_cast<int>(std::ranges::count(plan.findings, Severity::Blocking, &Finding::severity));
}

/// What came of a stage, in one line; empty for stages that are not known here.
QString resultOf(std::string_view stage, const Plan& plan) {
    if (stage == "headland") {
        return plan.headland.width.si() <= 0.0
                   ? StepsModel::tr("mainland %1").arg(percentText(plan.headland.mainlandRatio))
                   : QStringList{metresText(narrowestWidth(plan.headland), plan.headland.width),
                                 StepsModel::tr("%n pass(es)", nullptr, plan.headland.passes),
                                 StepsModel::tr("mainland %1").arg(percentText(plan.headland.mainlandRatio))}
                         .join(kSeparator);
    }
    if (stage == "decomposition") {
        return StepsModel::tr("%n cell(s)", nullptr, static_cast<int>(plan.cells.cells.size()));
    }
    if (stage == "swaths") {
        return QStringList{StepsModel::tr("%n swath(s)", nullptr, static_cast<int>(plan.swaths.swaths.size())),
                           lengthText(plan.swaths.totalLength), bearingText(plan.swaths.heading)}
            .join(kSeparator);
    }
    if (stage == "route") {
        return StepsModel::tr("%1 with turns on the spot").arg(lengthText(plan.route.lengthInPlace));
    }
    if (stage == "path") {
        QStringList parts{StepsModel::tr("%n turn(s)", nullptr, plan.path.turnCount()),
                          lengthText(plan.path.length(SegmentKind::Turn))};
        if (plan.path.undrivableCount() > 0) {
            parts << StepsModel::tr("%n not drivable", nullptr, plan.path.undrivableCount());
        }
        return parts.join(kSeparator);
    }
    return {};
}

StepsModel::Status statusOf(std::string_view stage, const Plan& plan) {
    const bool troubled = stage == "path" && blockingCount(plan) > 0;
    return troubled ? StepsModel::Status::Warning : StepsModel::Status::Good;
}

}  // namespace

StepsModel::StepsModel(QObject* parent) : QAbstractListModel{parent} {
    const auto add = [this](QString id, std::string_view name, const std::vector<const Parameter*>& parameters) {
        auto* model = new ParameterModel{this};
        model->show(parameters, {}, nullptr);
        connect(model, &ParameterModel::changeRequested, this, &StepsModel::changeRequested);
        steps_.push_back({std::move(id), name, {}, {}, Status::None, model});
    };
    // Names of the steps follow the language by themselves, what is in them when it is shown again.
    connect(&Display::instance(), &Display::changed, this, [this] { emit dataChanged(index(0), index(rowCount() - 1)); });
    const auto general = generalParameters();
    add(QStringLiteral("field"), "Field", {general.begin(), general.end()});
    add(QStringLiteral("machine"), "Machine", {});
    for (const StageInfo& stage : stages()) {
        add(fromStd(stage.id), stage.name, parametersOf(stage, {}));
    }
}

void StepsModel::show(const Field* field, const FieldSource* source, const Machine& machine, const Settings& settings,
                      const Plan* plan, bool failed) {
    const std::vector<Step> before = steps_;
    Step& first = steps_[0];
    if (field != nullptr) {
        first.choice = QStringList{fromStd(field->name()), areaText(field->area())}.join(kSeparator);
        QStringList parts;
        if (const auto count = static_cast<int>(field->source().obstacles.size()); count > 0) {
            parts << tr("%n obstacle(s)", nullptr, count);
        }
        if (const auto count = static_cast<int>(field->holeCount()); count > 0) {
            parts << tr("%n hole(s)", nullptr, count);
        }
        parts << tr("%n boundary point(s)", nullptr, static_cast<int>(field->vertexCount()));
        first.result = parts.join(kSeparator);
        first.status = Status::Good;
    } else if (failed) {
        first.choice = tr("No usable boundary");
        first.result = tr("The message on the map says why");
        first.status = Status::Failed;
    } else {
        first.choice = source == nullptr ? tr("No field yet") : fromStd(source->name);
        first.result = source == nullptr ? tr("Open a file or draw a boundary") : areaText(areaOf(*source));
        first.status = Status::None;
    }
    const auto general = generalParameters();
    first.parameters->show({general.begin(), general.end()}, settings, plan);

    Step& second = steps_[1];
    second.choice = shown(machine.name());
    const Tractor& tractor = machine.spec().tractor;
    second.result = QStringList{tr("%1 wide").arg(metresText(machine.operatingWidth(), 1)),
                                tr("%1 radius").arg(metresText(machine.minTurningRadius(), 1)),
                                speedText(tractor.workingSpeed)}
                        .join(kSeparator);
    second.status = Status::Good;

    for (std::size_t i = 0; i < stages().size(); ++i) {
        const StageInfo& stage = stages()[i];
        Step& step = steps_[i + 2];
        step.choice = methodName(stage, settings);
        step.result = plan == nullptr ? QString{} : resultOf(stage.id, *plan);
        step.status = plan == nullptr ? Status::None : statusOf(stage.id, *plan);
        step.parameters->show(parametersOf(stage, settings), settings, plan);
    }
    for (int row = 0; row < rowCount(); ++row) {
        if (const Step& step = steps_[static_cast<std::size_t>(row)]; step != before[static_cast<std::size_t>(row)]) {
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
            return index.row() == 0 ? tr("Field") : index.row() == 1 ? tr("Machine") : shown(step.name);
        case ChoiceRole: return step.choice;
        case ResultRole: return step.result;
        case StatusRole: return static_cast<int>(step.status);
        case ParametersRole: return QVariant::fromValue(step.parameters);
        default: return {};
    }
}

QHash<int, QByteArray> StepsModel::roleNames() const {
    return {{StepIdRole, "stepId"}, {NumberRole, "number"}, {NameRole, "name"},
            {ChoiceRole, "choice"}, {ResultRole, "result"}, {StatusRole, "status"},
            {ParametersRole, "parameters"}};
}

ParameterModel* StepsModel::parameters(const QString& stepId) const {
    const auto step = std::ranges::find(steps_, stepId, &Step::id);
    return step == steps_.end() ? nullptr : step->parameters;
}

}  // namespace furrow
