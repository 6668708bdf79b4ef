#pragma once

#include "planner/settings/places.h"
#include "ui/explain/plan_reasons.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/shown_plan.h"
#include "ui/order/swath_order.h"
#include "ui/plan/cell_steps.h"
#include "ui/plan/machine_model.h"
#include "ui/plan/plan_job.h"
#include "ui/plan/plan_state.h"
#include "ui/plan/steps_model.h"
#include "ui/project/document.h"
#include "ui/project/field_opener.h"
#include "ui/project/problem.h"

#include <QtQml/qqmlregistration.h>
#include <QElapsedTimer>
#include <QGeoCoordinate>
#include <QObject>
#include <QTimer>
#include <QVariantList>

#include <atomic>
#include <memory>
#include <optional>
#include <utility>

namespace furrow {

/// Plans the current field of the document in the background: anew after every change, the latest request
/// wins.
class Planning : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("belongs to a session")
    Q_PROPERTY(furrow::plan_state::State state READ state NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString statusText READ statusText NOTIFY statusTextChanged FINAL)
    /// Findings of the plan that block.
    Q_PROPERTY(int problemCount READ problemCount NOTIFY stateChanged FINAL)
    Q_PROPERTY(bool slow READ isSlow NOTIFY progressChanged FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)
    Q_PROPERTY(furrow::StepsModel* steps READ steps CONSTANT FINAL)
    Q_PROPERTY(furrow::MachineModel* machine READ machine CONSTANT FINAL)
    Q_PROPERTY(furrow::CellSteps* cells READ cells CONSTANT FINAL)
    Q_PROPERTY(furrow::SwathOrder* order READ order CONSTANT FINAL)
    Q_PROPERTY(furrow::PlanReasons* reasons READ reasons CONSTANT FINAL)

public:
    Planning(Document& document, FieldOpener& opener, ShownPlan& shown, Problem& problem,
             QObject* parent = nullptr);

    PlanState state() const { return state_; }
    QString statusText() const;
    /// Done and known, see PlanCourse.
    std::pair<int, int> compared() const { return {compared_->done, compared_->known}; }
    int problemCount() const { return shown_.plan() ? static_cast<int>(shown_.plan()->blockingCount()) : 0; }
    /// Of what is being read or planned, for long enough that the user should see it.
    bool isSlow() const { return planner_.isSlow() || opener_.isSlow(); }
    double progress() const { return opener_.isReading() ? opener_.progress() : planner_.progress(); }
    StepsModel* steps() { return &steps_; }
    MachineModel* machine() { return &machine_; }
    CellSteps* cells() { return &cells_; }
    SwathOrder* order() { return &order_; }
    PlanReasons* reasons() { return &reasons_; }
    const Settings& settings() const { return document_.project()->plan().settings; }

    /// Stops reading and planning.
    Q_INVOKABLE void cancel();
    Q_INVOKABLE void planAgain();
    /// Gives a setting this text, as `--set key=text` does.
    Q_INVOKABLE void set(const QString& key, const QString& text);
    /// The points of a setting with several places; gates that it names are none.
    Q_INVOKABLE QVariantList pointsOf(const QString& key) const;
    Q_INVOKABLE void addPoint(const QString& key, const QGeoCoordinate& place);
    /// @param index  of `pointsOf`
    Q_INVOKABLE void removePoint(const QString& key, int index);
    /// Makes a change that the planner advises.
    void apply(const SettingChange& change);

signals:
    void stateChanged();
    void statusTextChanged();
    /// Values of settings are others than before.
    void settingsChanged();
    void progressChanged();
    /// A field that was not on the map before: the camera should go there; again when its first plan is
    /// there.
    void fieldOpened();

private:
    using Source = ShownPlan::Source;
    enum class Wanted {
        Plan,   ///< and before it, where it takes long, something to look at
        Draft,  ///< while the user drags: the plan is asked for when they let go
    };
    /// How many plans are compared, and are to be; read by the window while the planner counts.
    struct Compared {
        std::atomic<int> done = 0;
        std::atomic<int> known = 0;
    };

    std::vector<GivenPlace> placesOf(const QString& key) const;
    void followDocument();
    /// What was planned before belongs to another field.
    void begin(const Source& source);
    /// With the operation that another machine is made for.
    void changeMachine(const Machine& machine);
    void changeSetting(const Parameter* parameter, const SettingValue& value, bool live);
    void requestPlan(Wanted wanted);
    /// What is told while this piece of work goes on.
    PlanMeanwhile meanwhile(const PlanTask& task, const JobContext& job, std::shared_ptr<Compared> compared);
    QString planningText() const;
    void take(PlanOutcome outcome);
    /// Shown when the finished plan is not there in time.
    void hold(PlanOutcome outcome);
    void showHeld();
    void forgetHeld();
    void show(PlanOutcome outcome);
    /// The plan is whole, and of the field, machine and settings that the panels show.
    bool isOfWhatIsShown() const;
    PlanState derivedState() const;
    /// What was under way for another request ends; the plan that is there is of this one.
    void keepPlan();
    void showSteps();
    void updateState();

    Document& document_;
    FieldOpener& opener_;
    ShownPlan& shown_;
    Problem& problem_;
    PlanState state_ = PlanState::Empty;
    /// Of the document as it was planned last.
    std::string plannedField_;
    std::string plannedPlan_;
    std::optional<Machine> plannedMachine_;
    Settings plannedSettings_;
    /// Of the source that is shown; null while it has not been checked.
    std::shared_ptr<const Field> field_;
    /// The last one that was no draft.
    std::shared_ptr<const Plan> wholePlan_;
    /// Of the stages of this field's plans.
    std::shared_ptr<StageCache> cache_ = std::make_shared<StageCache>();
    /// A draft or a first plan that waits.
    std::optional<PlanOutcome> held_;
    QTimer hold_;
    QElapsedTimer sinceAsked_;
    std::shared_ptr<Compared> compared_ = std::make_shared<Compared>();
    int toldCompared_ = 0;
    bool stopped_ = false;
    bool announce_ = false;
    /// The last request was for a draft.
    bool draftAsked_ = false;
    /// The user asked for the plan once more, though nothing has changed in the panels.
    bool again_ = false;
    StepsModel steps_;
    MachineModel machine_;
    CellSteps cells_;
    SwathOrder order_{document_, shown_};
    PlanReasons reasons_{document_, shown_};
    JobRunner planner_;
};

}  // namespace furrow
