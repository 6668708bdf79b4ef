#pragma once

#include "planner/project/plan_results.h"
#include "ui/jobs/job_runner.h"
#include "ui/plan/made_plans.h"
#include "ui/project/document.h"
#include "ui/text/message_text.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace furrow {

/// What is known of the plans of all fields of the farm, and the planning of many of them in the background.
/// The results of the current field come from its plan in the window, the others from here; they are kept in
/// a file, so that a farm that is opened again shows them.
class FarmPlans : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(bool busy READ isBusy NOTIFY progressChanged FINAL)
    /// "3 of 12: Long Acre" while it is busy, then what came of it.
    Q_PROPERTY(QString status READ status NOTIFY progressChanged FINAL)
    /// Of everything that was asked for, in [0, 1].
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)

public:
    /// @param made  where the plans themselves go
    FarmPlans(Document& document, MadePlans& made, QObject* parent = nullptr);

    /// Where results are kept; without a place they last as long as the program.
    void keepIn(const QString& file);

    /// Null where a plan of this key was not made, or failed.
    const PlanResult* resultOf(const std::string& planKey) const { return results_.find(planKey); }
    /// Why there is no plan; empty where nothing was tried.
    const Error* errorOf(const std::string& planKey) const;
    /// There was a plan, of other inputs.
    bool wasPlanned(const ProjectField& field, const FieldPlan& plan) const;
    /// It waits for its turn, or is being planned.
    bool isWaiting(const ProjectField& field) const;
    bool isUnderWay(const ProjectField& field) const;

    /// A plan that was made in the window, of the field and plan that are current.
    void keep(const std::shared_ptr<const Plan>& plan);
    /// A plan that was made elsewhere, with advice, of a field of this project.
    void keep(const ProjectField& field, const FieldPlan& wanted, const std::shared_ptr<const Plan>& plan);
    /// Plans those of these fields that have no plan of their present inputs; by index in the project.
    void plan(const std::vector<std::size_t>& fields);
    Q_INVOKABLE void cancel();
    /// Forgets what came of it.
    Q_INVOKABLE void dismiss();

    bool isBusy() const { return !waiting_.empty() || underWay() > 0; }
    QString status() const;
    double progress() const;

signals:
    void progressChanged();
    /// Of one field or of several.
    void resultsChanged();

private:
    /// One field is planned on several cores, but much of it on one: two at a time keep them busy.
    static constexpr std::size_t kAtOnce = 2;
    struct Worker {
        JobRunner runner;
        std::string field;  ///< empty while there is nothing to do
        std::string name;
    };
    /// With the field's name: ids are counted anew in each project.
    static std::string placeOf(const ProjectField& field, const FieldPlan& plan);

    void goOn();
    void start(Worker& worker, std::size_t field);
    void finish(Worker& worker, const std::string& key, const std::string& place,
                const Result<std::shared_ptr<const Plan>>& plan);
    void store(const std::string& key, const std::string& place, const MadePlan& made);
    void save();
    std::size_t underWay() const;

    Document& document_;
    MadePlans& made_;
    QString file_;
    PlanResults results_;
    std::map<std::string, Error> errors_;
    /// Plans that were made, now or before, whatever their inputs were.
    std::set<std::string> planned_;
    /// The plan of the window that was taken last.
    std::shared_ptr<const Plan> kept_;
    std::string keptPlace_;
    std::deque<std::string> waiting_;  ///< ids of fields
    std::size_t asked_ = 0;
    std::size_t drivable_ = 0;
    std::size_t withFindings_ = 0;
    std::size_t failed_ = 0;
    bool stopped_ = false;
    JobRunner saver_;
    std::array<Worker, kAtOnce> workers_;
};

}  // namespace furrow
