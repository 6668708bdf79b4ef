#pragma once

#include "ui/plan/parameter_model.h"

#include <QAbstractListModel>

namespace furrow {

/// The steps of a plan from field to turns: built from the planner's registry, so that a new method or stage
/// needs nothing here.
class StepsModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")

public:
    enum class Status { None, Good, Warning, Failed };
    Q_ENUM(Status)
    enum Role {
        StepIdRole = Qt::UserRole + 1,
        NumberRole,
        NameRole,
        ChoiceRole,  ///< what is chosen: "Constant width · 2 passes"
        ResultRole,  ///< what came of it: "24.0 m · mainland 81 %"
        StatusRole,
        ParametersRole,
    };

    explicit StepsModel(QObject* parent = nullptr);

    /// What the steps show; each pointer may be null. `source` is what there is of a field that was not checked yet.
    void show(const Field* field, const FieldSource* source, const Machine& machine, const Settings& settings, const Plan* plan, bool failed);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// The settings of a step, for tests and for the session.
    ParameterModel* parameters(const QString& stepId) const;

signals:
    void changeRequested(const furrow::Parameter* parameter, const furrow::SettingValue& value, bool live);

private:
    struct Step {
        QString id;
        std::string_view name;
        QString choice;
        QString result;
        Status status = Status::None;
        ParameterModel* parameters = nullptr;

        friend bool operator==(const Step&, const Step&) = default;
    };
    std::vector<Step> steps_;
};

}  // namespace furrow
