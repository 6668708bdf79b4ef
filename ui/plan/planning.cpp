#include "ui/plan/planning.h"

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/settings/operation.h"
#include "ui/project/last_machine.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <utility>

namespace furrow {

namespace {

/// A plan that took longer is followed by a draft of the next one first.
constexpr Duration kLongToWaitFor = seconds(0.5);

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
    connect(&planner_, &JobRunner::progressChanged, this, &Planning::progressChanged);
    connect(&shown_, &ShownPlan::planChanged, this, [this] { cells_.show(shown_.plan()); });
    connect(&problem_, &Problem::dismissed, this, &Planning::updateState);
    connect(&Display::instance(), &Display::changed, this, &Planning::updateState);
    updateState();
}

QString Planning::statusText() const {
    const auto& plan = shown_.plan();
    switch (state_) {
        case PlanState::Empty: return {};
        case PlanState::Reading: return tr("Reading %1 …").arg(opener_.readingName());
        case PlanState::Choosing: return tr("%n field(s) in this file", nullptr, opener_.choices()->count());
        case PlanState::Planning:
            return !shown_.isDraft()          ? tr("Planning …")
                   : draftAsked_ && !isSlow() ? tr("Draft · the whole plan follows when you let go")
                                              : tr("Draft · planning …");
        case PlanState::OutOfDate:
            return shown_.isDraft() ? tr("Out of date · this is a draft")
                   : plan           ? tr("Out of date · this is the plan before the change")
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

void Planning::cancel() {
    opener_.cancel();
    planner_.cancel();
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
    plannedSettings_ = plan.settings;
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
        requestPlan(live                 ? Wanted::DraftWhileDragging
                    : startsWithADraft() ? Wanted::DraftFirst
                                         : Wanted::Plan);
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

void Planning::apply(const SettingChange& change) {
    const auto parameter = findParameter(change.key);
    Settings read;
    if (parameter && read.setText(**parameter, change.value)) {
        changeSetting(*parameter, read.value(**parameter), false);
    }
}

bool Planning::startsWithADraft() const {
    return wholePlan_ == nullptr || wholePlan_->timings.total > kLongToWaitFor;
}

void Planning::requestPlan(Wanted wanted) {
    if (!shown_.source()) {
        return;
    }
    stopped_ = false;
    draftAsked_ = wanted != Wanted::Plan;
    planner_.submit(
        [this, source = shown_.source(), field = field_, machine = machine_.machine(), settings = settings(),
         draft = draftAsked_, before = wholePlan_,
         cache = cache_](const JobContext& job) -> JobRunner::Delivery {
            PlanOutcome outcome = planned(source, field, machine, settings, draft, before.get(), *cache, job);
            return [this, outcome = std::move(outcome)]() mutable { take(std::move(outcome)); };
        },
        wanted == Wanted::DraftWhileDragging ? JobRunner::Replace::WhenDone : JobRunner::Replace::Now);
    updateState();
}

void Planning::take(PlanOutcome outcome) {
    if (!shown_.source() || (outcome.error && outcome.error->code == ErrorCode::Cancelled)) {
        return;
    }
    if (outcome.source == shown_.source()) {
        field_ = outcome.field;
    }
    const bool goesOn = draftAsked_ && !document_.isDragging();
    if (goesOn) {
        requestPlan(Wanted::Plan);
        if (!outcome.plan) {
            return;  // the whole plan tells the reason
        }
    }
    again_ = false;
    problem_.clear();
    if (outcome.error) {
        problem_.show(*outcome.error);
    }
    if (!outcome.plan || !outcome.plan->request.draft) {
        wholePlan_ = outcome.plan;
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
}

}  // namespace furrow
