#pragma once

#include "ui/document/document.h"
#include "ui/document/project_files.h"
#include "ui/imagery/imagery_model.h"
#include "ui/jobs/job_runner.h"
#include "ui/map/plan_drawing.h"
#include "ui/plan/cell_steps.h"
#include "ui/plan/export_model.h"
#include "ui/plan/farm_model.h"
#include "ui/plan/field_choice_model.h"
#include "ui/plan/figures_model.h"
#include "ui/plan/findings_model.h"
#include "ui/plan/machine_model.h"
#include "ui/plan/plan_jobs.h"
#include "ui/plan/plan_state.h"
#include "ui/plan/recent_files.h"
#include "ui/plan/sample_fields.h"
#include "ui/plan/steps_model.h"

#include <QDateTime>
#include <QObject>
#include <QUrl>
#include <QtQml/qqmlregistration.h>

#include <optional>

namespace furrow {

/// The current field of the document with its machine, settings and plan, as the window shows it. Every change of
/// the document plans anew in the background; the latest request wins.
class PlanSession : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("made by the application")
    Q_PROPERTY(furrow::plan_state::State state READ state NOTIFY stateChanged FINAL)
    Q_PROPERTY(bool hasField READ hasField NOTIFY fieldChanged FINAL)
    Q_PROPERTY(bool hasPlan READ hasPlan NOTIFY planChanged FINAL)
    /// The drawing is of outlines that have changed since: a plan of the field as it is now follows.
    Q_PROPERTY(bool behind READ isBehind NOTIFY fieldChanged FINAL)
    /// What is shown was planned in haste, as while something is dragged; the whole plan follows.
    Q_PROPERTY(bool draft READ isDraft NOTIFY planChanged FINAL)
    Q_PROPERTY(QString fieldName READ fieldName NOTIFY fieldChanged FINAL)
    Q_PROPERTY(furrow::Document* document READ document CONSTANT FINAL)
    Q_PROPERTY(furrow::ProjectFiles* files READ files CONSTANT FINAL)
    Q_PROPERTY(furrow::PlanDrawing drawing READ drawing NOTIFY drawingChanged FINAL)
    Q_PROPERTY(bool slow READ isSlow NOTIFY progressChanged FINAL)
    Q_PROPERTY(double progress READ progress NOTIFY progressChanged FINAL)
    Q_PROPERTY(QString statusText READ statusText NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString problem READ problem NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString problemWhere READ problemWhere NOTIFY stateChanged FINAL)
    Q_PROPERTY(QString problemRemedy READ problemRemedy NOTIFY stateChanged FINAL)
    Q_PROPERTY(QGeoCoordinate problemPlace READ problemPlace NOTIFY stateChanged FINAL)
    Q_PROPERTY(QStringList sampleNames READ sampleNames NOTIFY textsChanged FINAL)
    Q_PROPERTY(furrow::FarmModel* farm READ farm CONSTANT FINAL)
    Q_PROPERTY(furrow::ImageryModel* imagery READ imagery CONSTANT FINAL)
    Q_PROPERTY(furrow::RecentFiles* recent READ recent CONSTANT FINAL)
    Q_PROPERTY(furrow::StepsModel* steps READ steps CONSTANT FINAL)
    Q_PROPERTY(furrow::MachineModel* machine READ machine CONSTANT FINAL)
    Q_PROPERTY(furrow::FiguresModel* figures READ figures CONSTANT FINAL)
    Q_PROPERTY(furrow::FindingsModel* findings READ findings CONSTANT FINAL)
    Q_PROPERTY(furrow::CellSteps* cells READ cells CONSTANT FINAL)
    Q_PROPERTY(furrow::FieldChoiceModel* choices READ choices CONSTANT FINAL)
    Q_PROPERTY(furrow::ExportModel* exporter READ exporter CONSTANT FINAL)

public:
    using State = PlanState;

    explicit PlanSession(QObject* parent = nullptr);

    State state() const { return state_; }
    bool hasField() const { return document_.project()->field() != nullptr; }
    bool isBehind() const { return drawnSource_ != source_; }
    bool hasPlan() const { return plan_ != nullptr; }
    bool isDraft() const { return plan_ != nullptr && plan_->request.draft; }
    QString fieldName() const;
    const PlanDrawing& drawing() const { return drawing_; }
    /// Of what is being read or planned, for long enough that the user should see it.
    bool isSlow() const { return planner_.isSlow() || reader_.isSlow(); }
    double progress() const { return reader_.isBusy() ? reader_.progress() : planner_.progress(); }
    QString statusText() const;
    QString problem() const;
    QString problemWhere() const;
    QString problemRemedy() const;
    QGeoCoordinate problemPlace() const;
    QStringList sampleNames() const;
    StepsModel* steps() { return &steps_; }
    MachineModel* machine() { return &machine_; }
    FiguresModel* figures() { return &figures_; }
    FindingsModel* findings() { return &findings_; }
    CellSteps* cells() { return &cells_; }
    FieldChoiceModel* choices() { return &choices_; }
    ExportModel* exporter() { return &exporter_; }
    Document* document() { return &document_; }
    ProjectFiles* files() { return &files_; }
    FarmModel* farm() { return &farm_; }
    ImageryModel* imagery() { return &imagery_; }
    RecentFiles* recent() { return &recent_; }

    /// Keeps journals of what is done, and the list of recent files, in this folder.
    void keepIn(const QString& folder);

    const std::shared_ptr<const Plan>& plan() const { return plan_; }
    const Settings& settings() const { return document_.project()->plan().settings; }

    /// Reads a file: a project in place of the one that is open, a boundary as another field of it. With several
    /// fields in a boundary file and no id, the user picks from `choices`.
    void open(const QString& path, const QString& fieldId = {});
    /// Reads several: a project among them first, then every field of the others; pictures become imagery.
    Q_INVOKABLE void openUrls(const QList<QUrl>& urls);
    Q_INVOKABLE void openSample(int index);
    /// Whether a file would take the place of the project that is open.
    Q_INVOKABLE bool isProjectFile(const QUrl& url) const;
    Q_INVOKABLE void chooseField(int row);
    Q_INVOKABLE void chooseAll();
    /// Goes back from the list of fields to what was there before.
    Q_INVOKABLE void dropChoices();
    /// Adds a field with this boundary.
    Q_INVOKABLE void setBoundary(const QList<QGeoCoordinate>& points);
    Q_INVOKABLE void cancel();
    Q_INVOKABLE void planAgain();
    /// The message about what went wrong is read.
    Q_INVOKABLE void dismissProblem();
    /// Begins with an empty project.
    Q_INVOKABLE void closeField();

signals:
    void stateChanged();
    /// Language or units are others.
    void textsChanged();
    void fieldChanged();
    void planChanged();
    void drawingChanged();
    void progressChanged();
    /// A field that was not on the map before: the camera should go there; again when its first plan is there.
    void fieldOpened();

private:
    using Source = std::shared_ptr<const FieldSource>;

    void read(const QStringList& paths, const QString& fieldId);
    void take(Reading reading, bool choose);
    void addFields(std::vector<FieldSource> fields);
    void followDocument();
    void changeSetting(const Parameter* parameter, const SettingValue& value, bool live);
    void requestPlan(JobRunner::Replace replace);
    void take(PlanOutcome outcome);
    void fail(const Error& error);
    /// The plan is whole, and of the field, machine and settings that the panels show.
    bool isOfWhatIsShown() const;
    PlanState derivedState() const;
    /// Why the plan cannot leave the window as it is; empty where it can.
    Said exportRefusal() const;
    /// What was under way for another request ends; the plan that is there is of this one.
    void keepPlan();
    void showModels();
    void showSteps();
    void updateState();

    State state_ = State::Empty;
    QString readingName_;
    /// Of the document as it was planned last.
    std::string shownField_;
    Source source_;
    std::string shownPlan_;
    std::optional<Machine> shownMachine_;
    Settings shownSettings_;
    /// Of `source_`; null while it has not been checked.
    std::shared_ptr<const Field> field_;
    std::shared_ptr<const Plan> plan_;
    QDateTime finished_;
    /// The last one that was no draft.
    std::shared_ptr<const Plan> wholePlan_;
    /// Of the stages of this field's plans.
    std::shared_ptr<StageCache> cache_ = std::make_shared<StageCache>();
    PlanDrawing drawing_;
    Source drawnSource_;
    std::optional<Error> error_;
    bool stopped_ = false;
    bool announce_ = false;
    /// The last request was for a draft.
    bool draftAsked_ = false;
    /// The user asked for the plan once more, though nothing has changed in the panels.
    bool again_ = false;
    QList<SampleField> samples_;

    Document document_;
    ProjectFiles files_{document_};
    FarmModel farm_{document_};
    ImageryModel imagery_{document_};
    RecentFiles recent_;
    StepsModel steps_;
    MachineModel machine_;
    FiguresModel figures_;
    FindingsModel findings_;
    CellSteps cells_;
    FieldChoiceModel choices_;
    ExportModel exporter_;
    JobRunner reader_;
    JobRunner planner_;
};

}  // namespace furrow
