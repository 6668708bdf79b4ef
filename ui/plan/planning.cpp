#include "ui/plan/planning.h"

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/settings/operation.h"
#include "ui/project/last_machine.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace furrow {

namespace {

using namespace std::chrono_literals;

// What is there sooner is shown by itself, without a draft before it: no flicker.
constexpr auto kShownWithoutADraft = 150ms;
// After a plan that was quick the next one is waited for, for so long, before a draft of it is begun.
constexpr auto kWaitedFor = 80ms;
constexpr Duration kQuick = seconds(0.15);

/// With a changed setting, those give way that cannot stand beside it.
void clearOthers(Settings& settings, const Parameter& changed, const SettingValue& value) {
    if (!changed.excludes.empty() && !std::holds_alternative<Auto>(value)) {
        settings.clear(*findParameter(changed.excludes).value());
    }
    if (&changed == &kOperationKind) {
        // Who picks an operation wants what goes with it, also where another choice was made before.
        for (const OperationDefault& entry : settings.operation().defaults) {
            settings.clear(*findParameter(entry.key).value());
        }
    }
}

}  // namespace

Planning::Planning(Document& document, FieldOpener& opener, ShownPlan& shown, Problem& problem,
                   QObject* parent)
    : QObject{parent}, document_{document}, opener_{opener}, shown_{shown}, problem_{problem} {
    connect(&steps_, &StepsModel::changeRequested, this, &Planning::changeSetting);
    connect(&machine_, &MachineModel::changeRequested, this, &Planning::changeMachine);
    connect(&document_, &Document::projectChanged, this, &Planning::followDocument);
    connect(&document_, &Document::dragEnded, this, [this] {
        if (draftAsked_) {
            requestPlan(Wanted::Plan);
        }
    });
    connect(&opener_, &FieldOpener::stateChanged, this, &Planning::updateState);
    connect(&opener_, &FieldOpener::progressChanged, this, &Planning::progressChanged);
    connect(&planner_, &JobRunner::busyChanged, this, &Planning::updateState);
    connect(&planner_, &JobRunner::slowChanged, this, &Planning::updateState);
    connect(&planner_, &JobRunner::slowChanged, this, &Planning::progressChanged);
    connect(&planner_, &JobRunner::progressChanged, this, [this] {
        emit progressChanged();
        if (const int done = compared_->done; done != std::exchange(toldCompared_, done)) {
            emit statusTextChanged();
        }
    });
    hold_.setSingleShot(true);
    connect(&hold_, &QTimer::timeout, this, &Planning::showHeld);
    connect(&shown_, &ShownPlan::planChanged, this, [this] { cells_.show(shown_.plan()); });
    connect(&problem_, &Problem::dismissed, this, &Planning::updateState);
    connect(&Display::instance(), &Display::changed, this, &Planning::updateState);
    // Before there is a field: the one that it will get.
    machine_.show(document_.project()->plan().machine);
    updateState();
}

QString Planning::statusText() const {
    const auto& plan = shown_.plan();
    switch (state_) {
        case PlanState::Empty: return {};
        case PlanState::Reading: return tr("Reading %1 …").arg(opener_.readingName());
        case PlanState::Choosing: return tr("%n field(s) in this file", nullptr, opener_.choices()->count());
        case PlanState::Planning:
            return !draftAsked_        ? planningText()
                   : !shown_.isDraft() ? tr("Planning …")
                   : !isSlow()         ? tr("Draft · the whole plan follows when you let go")
                                       : tr("Draft · planning …");
        case PlanState::OutOfDate:
            return shown_.isDraft() ? isFirstPlan(*plan) ? tr("Out of date · this is a first plan")
                                                         : tr("Out of date · this is a draft")
                   : plan ? tr("Out of date · this is the plan before the change")
                                    : tr("Stopped · there is no plan");
        case PlanState::Failed: return tr("No plan");
        case PlanState::Problems:
            return tr("%1 · %2").arg(tr("%n problem(s)", nullptr, problemCount()),
                                     durationText(plan->path.duration()));
        case PlanState::Ready: break;
    }
    const double milliseconds = plan->timings.total.si() * 1e3;
    const QString ready =
        milliseconds < 1e3
            ? tr("Plan ready · %1 ms").arg(numberText(milliseconds, milliseconds < 10.0 ? 1 : 0))
            : tr("Plan ready · %1 s").arg(numberText(1e-3 * milliseconds, 1));
    return tr("%1 · %2").arg(ready, durationText(plan->path.duration()));
}

QString Planning::planningText() const {
    const auto [done, known] = compared();
    if (known == 0) {
        return shown_.isDraft() ? tr("First plan · being improved …") : tr("Planning …");
    }
    // Their number grows meanwhile: the bar tells how much is done.
    const int current = std::min(done + 1, known);
    return shown_.isDraft() ? tr("First plan · comparing plan %1 …").arg(current)
                            : tr("Planning … · comparing plan %1").arg(current);
}

void Planning::cancel() {
    opener_.cancel();
    planner_.cancel();
    forgetHeld();
    draftAsked_ = false;
    again_ = false;
    stopped_ = shown_.source() != nullptr;
    updateState();
}

void Planning::planAgain() {
    again_ = shown_.source() != nullptr;
    requestPlan(Wanted::Plan);
}

void Planning::followDocument() {
    const Project& project = *document_.project();
    const ProjectField* field = project.field();
    const FieldPlan& plan = project.plan();
    const std::string fieldId = field == nullptr ? std::string{} : field->id;
    const Source source = field == nullptr ? nullptr : field->source;
    const bool otherField = fieldId != plannedField_ || (source == nullptr) != (shown_.source() == nullptr);
    const bool otherPlan = otherField || plan.id != plannedPlan_;
    const bool otherSource = source != shown_.source();
    const bool stale =
        otherPlan || otherSource || plan.machine != plannedMachine_ || plan.settings != plannedSettings_;
    if (otherSource) {
        field_.reset();
    }
    plannedField_ = fieldId;
    plannedPlan_ = plan.id;
    plannedMachine_ = plan.machine;
    const bool otherSettings = plan.settings != plannedSettings_;
    plannedSettings_ = plan.settings;
    if (otherSettings) {
        emit settingsChanged();
    }
    machine_.show(plan.machine);
    if (otherField) {
        begin(source);
    } else {
        shown_.follow(source);
    }
    // A drag may end where its last step was: nothing is stale then, but the whole plan is due.
    if (isOfWhatIsShown()) {
        // As after an undo: the plan that is there is the one that would be made.
        keepPlan();
    } else if (stale || (draftAsked_ && !document_.isDragging())) {
        const bool live = document_.isDragging() && !otherPlan;
        requestPlan(live ? Wanted::Draft : Wanted::Plan);
    }
    updateState();
    if (otherField) {
        announce_ = source != nullptr;
        if (announce_) {
            emit fieldOpened();
        }
    }
}

void Planning::begin(const Source& source) {
    planner_.cancel();
    forgetHeld();
    wholePlan_.reset();
    cache_ = std::make_shared<StageCache>();
    problem_.clear();
    stopped_ = false;
    again_ = false;
    shown_.begin(source);
}

void Planning::changeSetting(const Parameter* parameter, const SettingValue& value, bool live) {
    if (settings().value(*parameter) == value) {
        if (!live && document_.isDragging()) {
            document_.endDrag();
            if (!isOfWhatIsShown()) {
                requestPlan(Wanted::Plan);
            }
        }
        return;
    }
    Settings changed = settings();
    if (const Result<void> set = changed.set(*parameter, value); !set) {
        problem_.show(set.error());
        updateState();
        return;
    }
    clearOthers(changed, *parameter, value);
    document_.change([parameter] { return tr("Change: %1").arg(shown(parameter->name)); },
                     withPlan(*document_.project(), machine_.machine(), changed), fromStd(parameter->key),
                     live ? Document::Follows::More : Document::Follows::Nothing);
}

void Planning::changeMachine(const Machine& machine) {
    Settings changed = settings();
    // A sprayer sprays. Other numbers of the same machine say nothing of that.
    if (const std::string_view usual = usualOperation(machine); machine.id() != machine_.machine().id() &&
                                                                !usual.empty() &&
                                                                usual != settings().choice(kOperationKind)) {
        if (changed.setText(kOperationKind, std::string{usual})) {
            clearOthers(changed, kOperationKind, changed.value(kOperationKind));
        }
    }
    document_.change([] { return tr("Change the machine"); },
                     withPlan(*document_.project(), machine, changed));
    rememberMachine(machine, changed);
}

void Planning::set(const QString& key, const QString& text) {
    apply({.key = key.toStdString(), .value = text.toStdString()});
}

std::vector<GivenPlace> Planning::placesOf(const QString& key) const {
    const auto parameter = findParameter(key.toStdString());
    return parameter ? givenPlaces(settings().place(**parameter)).value_or(std::vector<GivenPlace>{})
                     : std::vector<GivenPlace>{};
}

QVariantList Planning::pointsOf(const QString& key) const {
    QVariantList points;
    for (const GivenPlace& place : placesOf(key)) {
        if (place.point) {
            points.append(QVariant::fromValue(coordinate(*place.point)));
        }
    }
    return points;
}

void Planning::addPoint(const QString& key, const QGeoCoordinate& place) {
    std::vector<GivenPlace> places = placesOf(key);
    places.push_back(
        {.name = {}, .point = GeoPoint{.lonDeg = place.longitude(), .latDeg = place.latitude()}});
    set(key, QString::fromStdString(placesText(places)));
}

void Planning::removePoint(const QString& key, int index) {
    std::vector<GivenPlace> places = placesOf(key);
    int at = 0;
    std::erase_if(places, [&](const GivenPlace& place) { return place.point && at++ == index; });
    set(key, QString::fromStdString(placesText(places)));
}

void Planning::apply(const SettingChange& change) {
    const auto parameter = findParameter(change.key);
    Settings read;
    if (parameter && read.setText(**parameter, change.value)) {
        changeSetting(*parameter, read.value(**parameter), false);
    }
}

void Planning::requestPlan(Wanted wanted) {
    if (!shown_.source()) {
        return;
    }
    stopped_ = false;
    // One draft after the other is shown while the user drags; a plan that is being made gives way to them.
    const bool dragsOn = std::exchange(draftAsked_, wanted == Wanted::Draft) && draftAsked_;
    forgetHeld();
    sinceAsked_.start();
    compared_ = std::make_shared<Compared>();
    PlanTask task{.source = shown_.source(),
                  .field = field_,
                  .machine = machine_.machine(),
                  .settings = settings(),
                  .draft = draftAsked_,
                  .before = wholePlan_};
    // What is on the map already is not replaced by less.
    const bool improves = !draftAsked_ && !isOfWhatIsShown();
    planner_.submit(
        [this, task = std::move(task), improves, cache = cache_,
         compared = compared_](const JobContext& job) -> JobRunner::Delivery {
            PlanOutcome outcome =
                planned(task, *cache, job, improves ? meanwhile(task, job, compared) : PlanMeanwhile{});
            return [this, outcome = std::move(outcome)]() mutable { take(std::move(outcome)); };
        },
        dragsOn ? JobRunner::Replace::WhenDone : JobRunner::Replace::Now);
    updateState();
}

PlanMeanwhile Planning::meanwhile(const PlanTask& task, const JobContext& job,
                                  std::shared_ptr<Compared> compared) {
    const bool wasQuick = task.before != nullptr && task.before->timings.total < kQuick;
    return {.firstPlan =
                [this, job](PlanOutcome outcome) {
                    planner_.handOver(job, [this, outcome = std::move(outcome)] { hold(outcome); });
                },
            .draftAfter = wasQuick ? kWaitedFor : 0ms,
            .course = {.firstPlan = {},
                       .compared = [compared = std::move(compared)](std::size_t done, std::size_t known) {
                           compared->known = static_cast<int>(known);
                           compared->done = static_cast<int>(done);
                       }}};
}

void Planning::hold(PlanOutcome outcome) {
    if (outcome.source != shown_.source()) {
        return;
    }
    field_ = outcome.field;
    held_ = std::move(outcome);
    const auto left = kShownWithoutADraft - std::chrono::milliseconds{sinceAsked_.elapsed()};
    if (left > 0ms) {
        hold_.start(left);
    } else {
        showHeld();
    }
}

void Planning::showHeld() {
    if (held_) {
        PlanOutcome outcome = *std::move(held_);
        forgetHeld();
        show(std::move(outcome));
    }
}

void Planning::forgetHeld() {
    held_.reset();
    hold_.stop();
}

void Planning::take(PlanOutcome outcome) {
    if (!shown_.source() || (outcome.error && outcome.error->code == ErrorCode::Cancelled)) {
        return;
    }
    forgetHeld();
    if (outcome.source == shown_.source()) {
        field_ = outcome.field;
    }
    if (draftAsked_ && !document_.isDragging()) {
        requestPlan(Wanted::Plan);
        if (!outcome.plan) {
            return;  // the whole plan tells the reason
        }
    }
    again_ = false;
    if (!outcome.plan || !outcome.plan->request.draft) {
        wholePlan_ = outcome.plan;
    }
    show(std::move(outcome));
}

void Planning::show(PlanOutcome outcome) {
    problem_.clear();
    if (outcome.error) {
        problem_.show(*outcome.error);
    }
    shown_.show(std::move(outcome.plan), std::move(outcome.drawing), std::move(outcome.source));
    if (std::exchange(announce_, false)) {
        // Its results take room of the map.
        emit fieldOpened();
    }
    updateState();
}

void Planning::keepPlan() {
    planner_.cancel();
    forgetHeld();
    problem_.clear();
    stopped_ = false;
    draftAsked_ = false;
}

void Planning::showSteps() {
    // While a point is dragged the field before it stands for the one that is being checked.
    const Plan* const plan = shown_.plan().get();
    const bool before = plan != nullptr && state_ == PlanState::Planning;
    steps_.show({.field = field_   ? field_.get()
                          : before ? &plan->field()
                                   : nullptr,
                 .source = shown_.source().get(),
                 .machine = machine_.machine(),
                 .settings = settings(),
                 .plan = plan,
                 .state = state_});
}

bool Planning::isOfWhatIsShown() const {
    const auto& plan = shown_.plan();
    return plan != nullptr && !shown_.isDraft() && !shown_.isBehind() &&
           plan->request.machine == machine_.machine() && plan->request.settings == settings();
}

PlanState Planning::derivedState() const {
    if (opener_.isReading()) {
        return PlanState::Reading;
    }
    if (opener_.isChoosing()) {
        return PlanState::Choosing;
    }
    if (!shown_.source()) {
        return problem_.isThere() ? PlanState::Failed : PlanState::Empty;
    }
    if (isOfWhatIsShown() && !again_) {
        return problemCount() > 0 ? PlanState::Problems : PlanState::Ready;
    }
    if (planner_.isBusy()) {
        return PlanState::Planning;
    }
    if (problem_.isThere()) {
        return PlanState::Failed;
    }
    // A draft is followed by the whole plan unless that was stopped.
    return stopped_ ? PlanState::OutOfDate : PlanState::Planning;
}

void Planning::updateState() {
    state_ = derivedState();
    showSteps();
    emit stateChanged();
    emit statusTextChanged();
}

}  // namespace furrow
