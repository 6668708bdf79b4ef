#pragma once

#include "ui/plan/parameter_model.h"
#include "ui/plan/plan_state.h"

#include <QAbstractListModel>
#include <QVariantList>

namespace furrow {

/// What the steps are made from; each pointer may be null.
struct StepsContent {
    const Field* field = nullptr;
    /// What there is of a field that was not checked yet.
    const FieldSource* source = nullptr;
    const Machine& machine;
    const Settings& settings;
    const Plan* plan = nullptr;
    PlanState state = PlanState::Empty;
};

/// The steps of a plan from field to turns and the check of it: built from the planner's registry, so that a
/// new method or stage needs nothing here.
class StepsModel : public QAbstractListModel {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")

public:
    /// Old: what came of it belongs to a plan of something else than what the panels show.
    enum class Status { None, Good, Warning, Failed, Old };
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

    void show(const StepsContent& content);

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QHash<int, QByteArray> roleNames() const override;

    /// The settings of a step, for tests and for the session.
    ParameterModel* parameters(const QString& stepId) const;

    /// Every setting and every choice of one that the steps have, for a search by name: name, group (of the
    /// step), keywords, stepId, key; of a choice its value.
    Q_INVOKABLE QVariantList searchable() const;

signals:
    void changeRequested(const furrow::Parameter* parameter, const furrow::SettingValue& value, bool live);
    void pickRequested(const QString& key, int how);

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
    static void showField(Step& step, const StepsContent& content);
    static void showMachine(Step& step, const StepsContent& content);
    static void showCheck(Step& step, const StepsContent& content);

    std::vector<Step> steps_;
};

}  // namespace furrow
