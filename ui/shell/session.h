#pragma once

#include "ui/best/best_search.h"
#include "ui/compare/plan_comparison.h"
#include "ui/drive/drive_through.h"
#include "ui/driven/driven_track.h"
#include "ui/driven/field_from_track.h"
#include "ui/export/export_model.h"
#include "ui/farm/farm_list.h"
#include "ui/farm/farm_plans.h"
#include "ui/layers/imagery_model.h"
#include "ui/map/shown_plan.h"
#include "ui/plan/made_plans.h"
#include "ui/plan/planning.h"
#include "ui/project/document.h"
#include "ui/project/farm_model.h"
#include "ui/project/field_opener.h"
#include "ui/project/problem.h"
#include "ui/project/project_files.h"
#include "ui/project/recent_files.h"
#include "ui/report/printing.h"
#include "ui/results/figures_model.h"
#include "ui/results/findings_model.h"
#include "ui/results/plan_change.h"
#include "ui/review/review_model.h"
#include "ui/trouble/trouble_report.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>

namespace furrow {

/// What one window works with. It makes the objects that the panels show and tells each of them what it has
/// to know of the others.
class Session : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("made by the application")
    Q_PROPERTY(furrow::Document* document READ document CONSTANT FINAL)
    Q_PROPERTY(furrow::ProjectFiles* files READ files CONSTANT FINAL)
    Q_PROPERTY(furrow::FarmModel* farm READ farm CONSTANT FINAL)
    Q_PROPERTY(furrow::FarmPlans* farmPlans READ farmPlans CONSTANT FINAL)
    Q_PROPERTY(furrow::FarmList* farmList READ farmList CONSTANT FINAL)
    Q_PROPERTY(furrow::ImageryModel* imagery READ imagery CONSTANT FINAL)
    Q_PROPERTY(furrow::RecentFiles* recent READ recent CONSTANT FINAL)
    Q_PROPERTY(furrow::Problem* problem READ problem CONSTANT FINAL)
    Q_PROPERTY(furrow::FieldOpener* opener READ opener CONSTANT FINAL)
    Q_PROPERTY(furrow::ShownPlan* shown READ shown CONSTANT FINAL)
    Q_PROPERTY(furrow::Planning* planning READ planning CONSTANT FINAL)
    Q_PROPERTY(furrow::BestSearch* bestSearch READ bestSearch CONSTANT FINAL)
    Q_PROPERTY(furrow::FiguresModel* figures READ figures CONSTANT FINAL)
    Q_PROPERTY(furrow::FindingsModel* findings READ findings CONSTANT FINAL)
    Q_PROPERTY(furrow::PlanChange* lastChange READ lastChange CONSTANT FINAL)
    Q_PROPERTY(furrow::DriveThrough* drive READ drive CONSTANT FINAL)
    Q_PROPERTY(furrow::PlanComparison* comparison READ comparison CONSTANT FINAL)
    Q_PROPERTY(furrow::DrivenTrack* driven READ driven CONSTANT FINAL)
    Q_PROPERTY(furrow::FieldFromTrack* fieldFromTrack READ fieldFromTrack CONSTANT FINAL)
    Q_PROPERTY(furrow::ReviewModel* review READ review CONSTANT FINAL)
    Q_PROPERTY(furrow::ExportModel* exporter READ exporter CONSTANT FINAL)
    Q_PROPERTY(furrow::Printing* printing READ printing CONSTANT FINAL)
    Q_PROPERTY(furrow::TroubleReport* trouble READ trouble CONSTANT FINAL)

public:
    explicit Session(QObject* parent = nullptr);

    Document* document() { return &document_; }
    ProjectFiles* files() { return &files_; }
    FarmModel* farm() { return &farm_; }
    FarmPlans* farmPlans() { return &farmPlans_; }
    FarmList* farmList() { return &farmList_; }
    ImageryModel* imagery() { return &imagery_; }
    RecentFiles* recent() { return &recent_; }
    Problem* problem() { return &problem_; }
    FieldOpener* opener() { return &opener_; }
    ShownPlan* shown() { return &shown_; }
    Planning* planning() { return &planning_; }
    BestSearch* bestSearch() { return &bestSearch_; }
    FiguresModel* figures() { return &figures_; }
    FindingsModel* findings() { return &findings_; }
    PlanChange* lastChange() { return &lastChange_; }
    DriveThrough* drive() { return &drive_; }
    PlanComparison* comparison() { return &comparison_; }
    DrivenTrack* driven() { return &driven_; }
    FieldFromTrack* fieldFromTrack() { return &fieldFromTrack_; }
    ReviewModel* review() { return &review_; }
    ExportModel* exporter() { return &exporter_; }
    Printing* printing() { return &printing_; }
    TroubleReport* trouble() { return &trouble_; }

    /// Keeps journals of what is done, and the list of recent files, in this folder.
    void keepIn(const QString& folder);

private:
    void showResults();
    void offerExport();

    Document document_;
    ProjectFiles files_{document_};
    FarmModel farm_{document_};
    MadePlans madePlans_;
    FarmPlans farmPlans_{document_, madePlans_};
    FarmList farmList_{document_, farmPlans_};
    ImageryModel imagery_{document_};
    RecentFiles recent_;
    Problem problem_;
    FieldOpener opener_{document_, files_, recent_, problem_};
    ShownPlan shown_;
    Planning planning_{document_, opener_, shown_, problem_};
    BestSearch bestSearch_{document_};
    FiguresModel figures_;
    FindingsModel findings_;
    PlanChange lastChange_;
    DriveThrough drive_{shown_};
    PlanComparison comparison_{document_, shown_, farm_};
    DrivenTrack driven_{shown_};
    FieldFromTrack fieldFromTrack_{document_, opener_, shown_};
    ReviewModel review_{document_};
    ExportModel exporter_{document_, madePlans_};
    Printing printing_{document_, madePlans_};
    TroubleReport trouble_{document_, shown_};
};

}  // namespace furrow
