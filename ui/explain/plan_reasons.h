#pragma once

#include "planner/plan/explanation.h"
#include "ui/explain/heading_choice.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/shown_plan.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>
#include <QStringList>
#include <QVariantMap>

#include <memory>
#include <vector>

namespace furrow {

/// Why the plan on the map came out as it did, step by step. Worked out in the background once a plan is
/// whole; until then the reasons of the plan before stay.
class PlanReasons : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to the planning")
    /// By the id of a step; steps about which nothing is to be said are not in it.
    Q_PROPERTY(QVariantMap texts READ texts NOTIFY changed FINAL)
    /// The ids of steps that have another method by now than the plan that the reasons are of.
    Q_PROPERTY(QStringList changedSteps READ changedSteps NOTIFY changedStepsChanged FINAL)
    Q_PROPERTY(furrow::HeadingChoice* headings READ headings CONSTANT FINAL)

public:
    PlanReasons(Document& document, ShownPlan& shown, QObject* parent = nullptr);

    QVariantMap texts() const;
    QStringList changedSteps() const;
    HeadingChoice* headings() { return &headings_; }
    /// The plan that they are of; null for none.
    const std::shared_ptr<const Plan>& plan() const { return plan_; }

signals:
    void changed();
    void changedStepsChanged();

private:
    void follow();
    void show(std::shared_ptr<const Plan> plan, std::vector<Explanation> reasons,
              std::optional<HeadingCurve> curve);

    Document& document_;
    ShownPlan& shown_;
    std::shared_ptr<const Plan> asked_;
    std::shared_ptr<const Plan> plan_;
    std::vector<Explanation> reasons_;
    HeadingChoice headings_;
    JobRunner runner_;
};

}  // namespace furrow
