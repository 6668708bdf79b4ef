#include "ui/project/farm_model.h"

#include "planner/io/import/boundary_import.h"
#include "planner/project/project_edits.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

QString nameOf(const FieldPlan& plan) {
    const QString name = plan.name.empty() ? shown(plan.machine.name()) : fromStd(plan.name);
    return plan.season.empty() ? name : FarmModel::tr("%1 · %2").arg(name, fromStd(plan.season));
}

}  // namespace

FarmModel::FarmModel(Document& document, QObject* parent) : QObject{parent}, document_{document} {
    connect(&document_, &Document::projectChanged, this, &FarmModel::follow);
    connect(&document_, &Document::dragEnded, this, &FarmModel::follow);
    connect(&Display::instance(), &Display::changed, this, &FarmModel::follow);
    follow();
}

void FarmModel::follow() {
    if (document_.isDragging()) {
        return;
    }
    QStringList names;
    for (const auto& field : document_.project()->fields) {
        names << tr("%1 · %2").arg(fromStd(field->source->name), areaText(areaOf(*field->source)));
    }
    fields_ = std::move(names);
    emit changed();
}

int FarmModel::currentField() const {
    return document_.project()->field() == nullptr ? -1 : static_cast<int>(document_.project()->currentField);
}

void FarmModel::setCurrentField(int index) {
    if (index >= 0 && index != currentField()) {
        document_.look(showing(*document_.project(), static_cast<std::size_t>(index), 0));
    }
}

QString FarmModel::fieldName() const {
    const ProjectField* field = document_.project()->field();
    return field == nullptr ? QString{} : fromStd(field->source->name);
}

QStringList FarmModel::plans() const {
    QStringList names;
    if (const ProjectField* field = document_.project()->field()) {
        std::ranges::transform(field->plans, std::back_inserter(names), nameOf);
    }
    return names;
}

int FarmModel::currentPlan() const {
    return document_.project()->field() == nullptr ? -1 : static_cast<int>(document_.project()->currentPlan);
}

void FarmModel::setCurrentPlan(int index) {
    if (index >= 0 && index != currentPlan()) {
        document_.look(showing(*document_.project(), document_.project()->currentField,
                               static_cast<std::size_t>(index)));
    }
}

QString FarmModel::planName() const {
    return fromStd(document_.project()->plan().name);
}

QString FarmModel::season() const {
    return fromStd(document_.project()->plan().season);
}

QString FarmModel::ownName() const {
    const FieldPlan& plan = document_.project()->plan();
    return plan.name.empty() ? fromStd(plan.season) : nameOf(plan);
}

void FarmModel::renameField(const QString& name) {
    if (!name.trimmed().isEmpty()) {
        document_.change([] { return tr("Rename the field"); },
                         withFieldName(*document_.project(), name.trimmed().toStdString()));
    }
}

void FarmModel::removeField() {
    document_.change([name = fieldName()] { return tr("Remove field %1").arg(name); },
                     withoutField(*document_.project()));
}

void FarmModel::addPlan(const QString& name) {
    document_.change([] { return tr("Add a plan"); },
                     withPlanCopy(*document_.project(), name.trimmed().toStdString()));
}

void FarmModel::renamePlan(const QString& name, const QString& season) {
    document_.change(
        [] { return tr("Rename the plan"); },
        withPlanName(*document_.project(), name.trimmed().toStdString(), season.trimmed().toStdString()));
}

void FarmModel::removePlan() {
    document_.change([] { return tr("Remove the plan"); }, withoutPlan(*document_.project()));
}

}  // namespace furrow
