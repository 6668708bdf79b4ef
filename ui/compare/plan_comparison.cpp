#include "ui/compare/plan_comparison.h"

#include "planner/plan/method_registry.h"
#include "planner/plan/shown_value.h"
#include "planner/project/plan_key.h"
#include "planner/project/project_edits.h"
#include "ui/plan/plan_job.h"
#include "ui/text/display.h"
#include "ui/text/setting_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

QString labelOf(Figure figure) {
    switch (figure) {
        case Figure::Time: return PlanComparison::tr("Time");
        case Figure::Path: return PlanComparison::tr("Path");
        case Figure::Working: return PlanComparison::tr("Working");
        case Figure::Turning: return PlanComparison::tr("Turning");
        case Figure::Mainland: return PlanComparison::tr("Inside the headland");
        case Figure::Swaths: return PlanComparison::tr("Swaths");
        case Figure::Covered: return PlanComparison::tr("Covered");
        case Figure::Missed: return PlanComparison::tr("Missed");
        case Figure::Overlap: return PlanComparison::tr("Overlap");
        case Figure::Outside: return PlanComparison::tr("Outside the field");
        case Figure::Reversed: return PlanComparison::tr("In reverse");
        case Figure::Problems: break;
    }
    return PlanComparison::tr("Problems");
}

QString figureText(Figure figure, std::optional<double> value) {
    if (!value) {
        return QStringLiteral("–");
    }
    switch (figure) {
        case Figure::Time: return durationText(seconds(*value));
        case Figure::Path:
        case Figure::Working:
        case Figure::Turning:
        case Figure::Reversed: return lengthText(metres(*value));
        case Figure::Mainland:
        case Figure::Covered:
        case Figure::Missed:
        case Figure::Overlap:
        case Figure::Outside:
            return *value < 1e4 ? squareMetresText(squareMetres(*value), 0)
                                : hectaresText(squareMetres(*value), 2);
        case Figure::Swaths:
        case Figure::Problems: break;
    }
    return numberText(*value, 0);
}

QString differenceText(Figure figure, std::optional<double> first, std::optional<double> second) {
    if (!first || !second || std::abs(*second - *first) < 1.0) {
        return {};
    }
    const double difference = std::abs(*second - *first);
    const QString amount =
        figure == Figure::Time ? exactDurationText(seconds(difference)) : figureText(figure, difference);
    return (*second > *first ? QStringLiteral("+") : QStringLiteral("\u2212")) + amount;
}

}  // namespace

PlanComparison::PlanComparison(Document& document, ShownPlan& shown, FarmModel& farm, QObject* parent)
    : QObject{parent}, document_{document}, shown_{shown}, farm_{farm} {
    connect(&document_, &Document::projectChanged, this, &PlanComparison::follow);
    connect(&shown_, &ShownPlan::planChanged, this, &PlanComparison::follow);
    connect(&runner_, &JobRunner::busyChanged, this, &PlanComparison::changed);
    connect(&comparer_, &JobRunner::busyChanged, this, &PlanComparison::changed);
    connect(&runner_, &JobRunner::progressChanged, this, &PlanComparison::progressChanged);
    connect(&Display::instance(), &Display::changed, this, &PlanComparison::changed);
}

void PlanComparison::setActive(bool active) {
    if (active == active_) {
        return;
    }
    active_ = active;
    if (!active_) {
        runner_.cancel();
        chosenByUser_ = false;
    }
    follow();
    emit changed();
}

QStringList PlanComparison::choices() const {
    QStringList names = farm_.plans();
    if (farm_.currentPlan() >= 0) {
        names.removeAt(farm_.currentPlan());
    }
    return names << tr("The standard settings");
}

std::optional<std::size_t> PlanComparison::planIndex(int choice) const {
    const auto current = static_cast<int>(document_.project()->currentPlan);
    const auto others = static_cast<int>(farm_.plans().size()) - 1;
    if (choice < 0 || choice >= others) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(choice < current ? choice : choice + 1);
}

int PlanComparison::chosen() const {
    const auto others = std::max(0, static_cast<int>(farm_.plans().size()) - 1);
    if (!chosenByUser_) {
        return 0;
    }
    for (int choice = 0; choice < others; ++choice) {
        if (document_.project()->field()->plans[*planIndex(choice)].id == chosen_) {
            return choice;
        }
    }
    return others;
}

void PlanComparison::choose(int choice) {
    const auto index = planIndex(choice);
    chosen_ = index ? document_.project()->field()->plans[*index].id : std::string{};
    chosenByUser_ = true;
    follow();
    emit changed();
}

QString PlanComparison::firstName() const {
    return farm_.plans().value(farm_.currentPlan());
}

std::optional<FieldPlan> PlanComparison::wanted() const {
    const ProjectField* const field = document_.project()->field();
    if (field == nullptr) {
        return std::nullopt;
    }
    if (const auto index = planIndex(chosen())) {
        return field->plans[*index];
    }
    FieldPlan standard = document_.project()->plan();
    standard.settings = {};
    return standard;
}

void PlanComparison::follow() {
    const auto plan = wanted();
    if (!active_ || !plan || document_.isDragging()) {
        return;
    }
    const auto source = document_.project()->field()->source;
    const std::string key = planKey(*source, *plan);
    if (key != std::exchange(key_, key)) {
        // Before anybody is told that the runner is busy.
        comparer_.cancel();
        compared_.reset();
        second_.reset();
        drawing_ = {};
        trouble_ = {};
        runner_.submit([this, source, machine = plan->machine,
                        settings = plan->settings](const JobContext& job) -> JobRunner::Delivery {
            StageCache cache;
            PlanOutcome outcome =
                planned({.source = source, .machine = machine, .settings = settings}, cache, job);
            return [this, outcome = std::move(outcome)] {
                second_ = outcome.plan;
                drawing_ = outcome.drawing;
                if (outcome.error) {
                    trouble_ = [what = outcome.error->what] { return sentence(what); };
                }
                compare();
            };
        });
    } else if (second_ == nullptr && !trouble_ && !runner_.isBusy()) {
        // It was stopped half-way.
        key_.clear();
        follow();
        return;
    }
    compare();
}

void PlanComparison::compare() {
    const std::shared_ptr<const Plan> first = shown_.isDraft() ? nullptr : shown_.plan();
    if (first == nullptr || second_ == nullptr) {
        comparer_.cancel();
        compared_.reset();
    } else if (compared_ == nullptr || compared_->first != first || compared_->second != second_) {
        comparer_.submit([this, first, second = second_](const JobContext&) -> JobRunner::Delivery {
            auto compared = std::make_shared<const Compared>(
                Compared{.first = first, .second = second, .difference = differenceOf(*first, *second)});
            return [this, compared] {
                compared_ = compared;
                emit changed();
            };
        });
    }
    emit changed();
}

QVariantList PlanComparison::figures() const {
    QVariantList rows;
    if (!isReady()) {
        return rows;
    }
    for (const Figure figure : kFigures) {
        const auto mine = figureOf(*first(), figure);
        const auto its = figureOf(*second(), figure);
        const QString left = figureText(figure, mine);
        const QString right = figureText(figure, its);
        rows.push_back(
            QVariantMap{{QStringLiteral("label"), labelOf(figure)},
                        {QStringLiteral("first"), left},
                        {QStringLiteral("second"), right},
                        {QStringLiteral("difference"), differenceText(figure, mine, its)},
                        // What reads the same is the same.
                        {QStringLiteral("better"), left == right ? 0 : better(figure, mine, its)}});
    }
    return rows;
}

QVariantList PlanComparison::settings() const {
    QVariantList rows;
    if (!isReady()) {
        return rows;
    }
    const auto add = [&rows](const QString& label, const QString& mine, const QString& its) {
        rows.push_back(QVariantMap{{QStringLiteral("label"), label},
                                   {QStringLiteral("first"), mine},
                                   {QStringLiteral("second"), its}});
    };
    if (difference()->machine) {
        const auto machine = [](const Plan& plan) {
            return inOneLine(
                {shown(plan.request.machine.name()), shortLengthText(plan.request.machine.operatingWidth())});
        };
        add(tr("Machine"), machine(*first()), machine(*second()));
    }
    for (const SettingDifference& setting : difference()->settings) {
        add(settingName(*setting.parameter), shown(shownValue(*setting.parameter, setting.first)),
            shown(shownValue(*setting.parameter, setting.second)));
    }
    return rows;
}

QString PlanComparison::swathsText() const {
    if (!isReady()) {
        return {};
    }
    const auto elsewhere = static_cast<int>(difference()->onlyInSecond.size());
    return difference()->onlyInFirst.empty() && elsewhere == 0
               ? tr("All swaths lie in the same places.")
               : tr("%n swath(s) of the other plan lie elsewhere.", nullptr, elsewhere);
}

QStringList PlanComparison::drivenTexts() const {
    QStringList texts;
    if (!isReady()) {
        return texts;
    }
    for (const bool worked : {true, false}) {
        const Length mine = lengthOf(difference()->drivenOnlyInFirst, worked);
        const Length its = lengthOf(difference()->drivenOnlyInSecond, worked);
        if (mine > Length{} || its > Length{}) {
            texts << (worked ? tr("Headland passes: %1 only in this plan, %2 only in the other.")
                             : tr("Turns and ways: %1 only in this plan, %2 only in the other."))
                         .arg(lengthText(mine), lengthText(its));
        } else {
            texts << (worked ? tr("All headland passes lie in the same places.")
                             : tr("All turns and ways lie in the same places."));
        }
    }
    return texts;
}

void PlanComparison::takeSecond() {
    const auto plan = wanted();
    if (!plan) {
        return;
    }
    const Project& project = *document_.project();
    if (const auto index = planIndex(chosen())) {
        document_.look(showing(project, project.currentField, *index));
    } else {
        document_.change([] { return tr("Take the standard settings"); },
                         withPlan(project, plan->machine, plan->settings));
    }
}

}  // namespace furrow
