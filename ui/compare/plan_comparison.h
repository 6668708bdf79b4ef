#pragma once

#include "planner/plan/plan_difference.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/shown_plan.h"
#include "ui/project/farm_model.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QVariantList>

#include <memory>
#include <optional>
#include <string>

namespace furrow {

/// The plan on the map beside another one of the same field: another plan of the project, or what the
/// standard settings give. The other one is planned in the background.
class PlanComparison : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    /// Plans are compared; otherwise nothing is planned.
    Q_PROPERTY(bool active READ isActive WRITE setActive NOTIFY changed FINAL)
    /// What the plan can be compared with.
    Q_PROPERTY(QStringList choices READ choices NOTIFY changed FINAL)
    Q_PROPERTY(int chosen READ chosen WRITE choose NOTIFY changed FINAL)
    Q_PROPERTY(QString firstName READ firstName NOTIFY changed FINAL)
    Q_PROPERTY(QString secondName READ secondName NOTIFY changed FINAL)
    Q_PROPERTY(bool busy READ isBusy NOTIFY changed FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)
    /// Both plans are there.
    Q_PROPERTY(bool ready READ isReady NOTIFY changed FINAL)
    /// Why there is no other plan; empty where there is one, or it is being made.
    Q_PROPERTY(QString trouble READ trouble NOTIFY changed FINAL)
    /// Each with label, first, second, difference, better (-1, 0, 1).
    Q_PROPERTY(QVariantList figures READ figures NOTIFY changed FINAL)
    /// Each with label, first, second.
    Q_PROPERTY(QVariantList settings READ settings NOTIFY changed FINAL)
    /// How many swaths lie elsewhere.
    Q_PROPERTY(QString swathsText READ swathsText NOTIFY changed FINAL)
    /// How much of headland passes and turns does; one sentence each.
    Q_PROPERTY(QStringList drivenTexts READ drivenTexts NOTIFY changed FINAL)
    /// Of the other plan.
    Q_PROPERTY(furrow::PlanDrawing drawing READ drawing NOTIFY changed FINAL)

public:
    PlanComparison(Document& document, ShownPlan& shown, FarmModel& farm, QObject* parent = nullptr);

    bool isActive() const { return active_; }
    void setActive(bool active);
    QStringList choices() const;
    int chosen() const;
    void choose(int choice);
    QString firstName() const;
    QString secondName() const { return choices().value(chosen()); }
    bool isBusy() const { return runner_.isBusy() || comparer_.isBusy(); }
    double progress() const { return runner_.progress(); }
    bool isReady() const { return compared_ != nullptr; }
    QString trouble() const { return text(trouble_); }
    QVariantList figures() const;
    QVariantList settings() const;
    QString swathsText() const;
    QStringList drivenTexts() const;
    PlanDrawing drawing() const { return drawing_; }

    /// Null unless both plans are there.
    const Plan* first() const { return isReady() ? compared_->first.get() : nullptr; }
    const Plan* second() const { return isReady() ? compared_->second.get() : nullptr; }
    const PlanDifference* difference() const { return isReady() ? &compared_->difference : nullptr; }

    /// Goes on with the other plan: shows it, or takes the standard settings as one step to undo.
    Q_INVOKABLE void takeSecond();

signals:
    void changed();
    void progressChanged();

private:
    struct Compared {
        std::shared_ptr<const Plan> first;
        std::shared_ptr<const Plan> second;
        PlanDifference difference;
    };

    /// What the other plan is made of; nothing without a field.
    std::optional<FieldPlan> wanted() const;
    /// By index in the field; empty for the standard settings.
    std::optional<std::size_t> planIndex(int choice) const;
    void follow();
    /// In the background where both plans are there; what was compared before stays until then.
    void compare();

    Document& document_;
    ShownPlan& shown_;
    FarmModel& farm_;
    bool active_ = false;
    /// Id of the plan that was chosen; empty for the standard settings.
    std::string chosen_;
    bool chosenByUser_ = false;
    /// What the other plan, or the trouble, is of.
    std::string key_;
    std::shared_ptr<const Plan> second_;
    PlanDrawing drawing_;
    LazyText trouble_;
    std::shared_ptr<const Compared> compared_;
    JobRunner runner_;
    JobRunner comparer_;
};

}  // namespace furrow
