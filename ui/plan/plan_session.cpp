#include "ui/plan/plan_session.h"

#include "planner/io/import/boundary_import.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/settings/operation.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <utility>

namespace furrow {

namespace {

/// Of two settings only one may be given: setting the second brings the first back to its default.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kExclusive{
    std::pair{std::string_view{"headland.width_m"}, std::string_view{"headland.passes"}},
    std::pair{std::string_view{"headland.passes"}, std::string_view{"headland.width_m"}}};

std::vector<QGeoCoordinate> placesOf(const PlanDrawing& drawing) {
    return drawing.isEmpty() ? std::vector<QGeoCoordinate>{} : drawing.geometry()->findingPlaces;
}

}  // namespace

PlanSession::PlanSession(QObject* parent) : QObject{parent}, samples_{sampleFields()} {
    connect(&steps_, &StepsModel::changeRequested, this, &PlanSession::changeSetting);
    connect(&machine_, &MachineModel::changeRequested, this, [this](const Machine& machine) {
        document_.change([] { return tr("Change the machine"); }, withPlan(*document_.project(), machine, settings()));
    });
    connect(&document_, &Document::projectChanged, this, &PlanSession::followDocument);
    connect(&document_, &Document::dragEnded, this, [this] {
        if (draftAsked_) {
            requestPlan(JobRunner::Replace::Now);
        }
    });
    connect(&files_, &ProjectFiles::saved, this,
            [this](const QString& path) { recent_.add(path, *document_.project()); });
    for (JobRunner* runner : {&reader_, &planner_}) {
        connect(runner, &JobRunner::busyChanged, this, &PlanSession::updateState);
        connect(runner, &JobRunner::slowChanged, this, &PlanSession::updateState);
        connect(runner, &JobRunner::slowChanged, this, &PlanSession::progressChanged);
        connect(runner, &JobRunner::progressChanged, this, &PlanSession::progressChanged);
    }
    connect(&Display::instance(), &Display::changed, this, [this] {
        showModels();
        emit textsChanged();
        emit fieldChanged();
        updateState();
    });
    showModels();
    updateState();
}

void PlanSession::keepIn(const QString& folder) {
    const QDir place{folder};
    files_.keepIn(place.filePath(QStringLiteral("history")));
    recent_.keepIn(place.filePath(QStringLiteral("recent.json")));
}

QString PlanSession::fieldName() const {
    const ProjectField* field = document_.project()->field();
    return field != nullptr ? fromStd(field->source->name) : QString{};
}

QStringList PlanSession::sampleNames() const {
    QStringList names;
    for (const SampleField& sample : samples_) {
        names << shown(sample.name.toStdString());
    }
    return names;
}

QString PlanSession::statusText() const {
    switch (state_) {
        case State::Empty: return {};
        case State::Reading: return tr("Reading %1 …").arg(readingName_);
        case State::Choosing: return tr("%n field(s) in this file", nullptr, choices_.count());
        case State::Planning:
            return !isDraft()                    ? tr("Planning …")
                   : draftAsked_ && !isSlow() ? tr("Draft · the whole plan follows when you let go")
                                                 : tr("Draft · planning …");
        case State::OutOfDate:
            return isDraft() ? tr("Out of date · this is a draft")
                   : plan_   ? tr("Out of date · this is the plan before the change")
                             : tr("Stopped · there is no plan");
        case State::Failed: return tr("No plan");
        case State::Problems:
            return tr("%1 · %2").arg(tr("%n problem(s)", nullptr, findings_.blockingCount()), durationText(plan_->path.duration()));
        case State::Ready: break;
    }
    const double milliseconds = plan_->timings.total.si() * 1e3;
    const QString ready = milliseconds < 1e3
                              ? tr("Plan ready · %1 ms").arg(numberText(milliseconds, milliseconds < 10.0 ? 1 : 0))
                              : tr("Plan ready · %1 s").arg(numberText(1e-3 * milliseconds, 1));
    return tr("%1 · %2").arg(ready, durationText(plan_->path.duration()));
}

QString PlanSession::problem() const {
    if (!error_) {
        return {};
    }
    return sentence(error_->what);
}

QString PlanSession::problemWhere() const {
    if (!error_) {
        return {};
    }
    // A setting by the name it has in the panel.
    const auto parameter = findParameter(error_->where.text());
    return parameter ? shown((*parameter)->name) : shown(error_->where);
}

QString PlanSession::problemRemedy() const {
    return error_ ? sentence(error_->remedy) : QString{};
}

QGeoCoordinate PlanSession::problemPlace() const {
    return error_ && error_->place ? coordinate(*error_->place) : QGeoCoordinate{};
}

void PlanSession::read(const QStringList& paths, const QString& fieldId) {
    readingName_ = paths.size() == 1 ? QFileInfo{paths.front()}.fileName() : tr("%n file(s)", nullptr, static_cast<int>(paths.size()));
    reader_.submit([this, paths, fieldId](const JobContext& job) -> JobRunner::Delivery {
        Reading reading = readFiles(paths, fieldId, job);
        return [this, reading = std::move(reading), choose = paths.size() == 1]() mutable {
            take(std::move(reading), choose);
        };
    });
    updateState();
}

void PlanSession::take(Reading reading, bool choose) {
    if (reading.error) {
        fail(*reading.error);
        return;
    }
    if (reading.project && !files_.open(reading.project->first, std::move(reading.project->second))) {
        updateState();
        return;
    }
    if (reading.project) {
        recent_.add(files_.path(), *document_.project());
    }
    imagery_.add(reading.imagery);
    if (choose && reading.fields.size() > 1) {
        choices_.show(std::move(reading.fields));
    } else if (!reading.fields.empty()) {
        addFields(std::move(reading.fields));
    }
    updateState();
}

void PlanSession::addFields(std::vector<FieldSource> fields) {
    Said text = [name = fromStd(fields.front().name), count = static_cast<int>(fields.size())] {
        return count == 1 ? tr("Add field %1").arg(name) : tr("Add %n field(s)", nullptr, count);
    };
    choices_.show({});
    document_.change(std::move(text), withFields(*document_.project(), std::move(fields)));
    updateState();
}

void PlanSession::open(const QString& path, const QString& fieldId) {
    read({path}, fieldId);
}

void PlanSession::openUrls(const QList<QUrl>& urls) {
    QStringList paths;
    for (const QUrl& url : urls) {
        if (url.isLocalFile()) {
            paths << url.toLocalFile();
        }
    }
    if (!paths.isEmpty()) {
        read(paths, {});
    }
}

bool PlanSession::isProjectFile(const QUrl& url) const {
    return url.isLocalFile() && holdsProject(url.toLocalFile().toStdU16String());
}

void PlanSession::openSample(int index) {
    if (index >= 0 && index < samples_.size()) {
        open(samples_[index].resource);
    }
}

void PlanSession::chooseField(int row) {
    if (row >= 0 && row < choices_.count()) {
        addFields({choices_.field(row)});
    }
}

void PlanSession::chooseAll() {
    std::vector<FieldSource> fields;
    for (int row = 0; row < choices_.count(); ++row) {
        fields.push_back(choices_.field(row));
    }
    if (!fields.empty()) {
        addFields(std::move(fields));
    }
}

void PlanSession::dropChoices() {
    choices_.show({});
    updateState();
}

void PlanSession::setBoundary(const QList<QGeoCoordinate>& points) {
    GeoRing ring;
    std::ranges::transform(points, std::back_inserter(ring), [](const QGeoCoordinate& p) { return geoPoint(p); });
    addFields({{.id = "drawn",
               .name = tr("Field %1").arg(document_.project()->fields.size() + 1).toStdString(),
               .origin = tr("drawn on the map").toStdString(),
               .parts = {GeoPolygon{.outer = std::move(ring), .holes = {}}},
               .obstacles = {},
               .gates = {},
               .boundaryAccuracy = {}}});
}

void PlanSession::cancel() {
    reader_.cancel();
    planner_.cancel();
    draftAsked_ = false;
    again_ = false;
    stopped_ = source_ != nullptr;
    updateState();
}

void PlanSession::planAgain() {
    again_ = source_ != nullptr;
    requestPlan(JobRunner::Replace::Now);
}

void PlanSession::dismissProblem() {
    error_.reset();
    updateState();
}

void PlanSession::closeField() {
    choices_.show({});
    error_.reset();
    files_.begin();
    updateState();
}

void PlanSession::followDocument() {
    const Project& project = *document_.project();
    const ProjectField* field = project.field();
    const FieldPlan& plan = project.plan();
    const std::string fieldId = field == nullptr ? std::string{} : field->id;
    const Source source = field == nullptr ? nullptr : field->source;
    const bool otherField = fieldId != shownField_ || (source == nullptr) != (source_ == nullptr);
    const bool otherPlan = otherField || plan.id != shownPlan_;
    const bool stale = otherPlan || source != source_ || plan.machine != shownMachine_ || plan.settings != shownSettings_;
    if (source != source_) {
        field_.reset();
    }
    shownField_ = fieldId;
    source_ = source;
    shownPlan_ = plan.id;
    shownMachine_ = plan.machine;
    shownSettings_ = plan.settings;
    machine_.show(plan.machine);
    if (otherField) {
        // What was planned before belongs to another field.
        planner_.cancel();
        plan_.reset();
        wholePlan_.reset();
        cache_ = std::make_shared<StageCache>();
        // Its outline is there at once; the plan may take seconds.
        drawing_ = source_ ? PlanDrawing{outlineGeometry(*source_, std::nullopt)} : PlanDrawing{};
        drawnSource_ = source_;
        error_.reset();
        stopped_ = false;
        again_ = false;
        emit planChanged();
        emit drawingChanged();
    }
    if (otherField) {
        showModels();
    }
    emit fieldChanged();
    // A drag may end where its last step was: nothing is stale then, but the whole plan is due.
    if (isOfWhatIsShown()) {
        // As after an undo: the plan that is there is the one that would be made.
        keepPlan();
    } else if (stale || (draftAsked_ && !document_.isDragging())) {
        const bool live = document_.isDragging() && !otherPlan;
        requestPlan(live ? JobRunner::Replace::WhenDone : JobRunner::Replace::Now);
    }
    updateState();
    if (otherField) {
        announce_ = source_ != nullptr;
        if (announce_) {
            emit fieldOpened();
        }
    }
}

void PlanSession::changeSetting(const Parameter* parameter, const SettingValue& value, bool live) {
    if (settings().value(*parameter) == value) {
        if (!live && document_.isDragging()) {
            document_.endDrag();
            if (!isOfWhatIsShown()) {
                requestPlan(JobRunner::Replace::Now);
            }
        }
        return;
    }
    Settings changed = settings();
    if (const Result<void> set = changed.set(*parameter, value); !set) {
        fail(set.error());
        return;
    }
    for (const auto& [given, other] : kExclusive) {
        if (parameter->key == given && !std::holds_alternative<Auto>(value)) {
            changed.clear(*findParameter(other).value());
        }
    }
    if (parameter == &kOperationKind) {
        // Who picks an operation wants what goes with it, also where another choice was made before.
        for (const OperationDefault& entry : changed.operation().defaults) {
            changed.clear(*findParameter(entry.key).value());
        }
    }
    document_.change([parameter] { return tr("Change: %1").arg(shown(parameter->name)); },
                     withPlan(*document_.project(), machine_.machine(), changed), fromStd(parameter->key),
                     live ? Document::Follows::More : Document::Follows::Nothing);
}

void PlanSession::requestPlan(JobRunner::Replace replace) {
    if (!source_) {
        return;
    }
    stopped_ = false;
    draftAsked_ = replace == JobRunner::Replace::WhenDone;
    planner_.submit(
        [this, source = source_, field = field_, machine = machine_.machine(), settings = settings(),
         draft = draftAsked_,
         before = wholePlan_, cache = cache_](const JobContext& job) -> JobRunner::Delivery {
            PlanOutcome outcome = planned(source, field, machine, settings, draft, before.get(), *cache, job);
            return [this, outcome = std::move(outcome)]() mutable { take(std::move(outcome)); };
        },
        replace);
    updateState();
}

void PlanSession::take(PlanOutcome outcome) {
    if (!source_ || (outcome.error && outcome.error->code == ErrorCode::Cancelled)) {
        return;
    }
    again_ = false;
    plan_ = std::move(outcome.plan);
    finished_ = QDateTime::currentDateTime();
    drawing_ = std::move(outcome.drawing);
    drawnSource_ = outcome.source;
    error_ = std::move(outcome.error);
    if (outcome.source == source_) {
        field_ = outcome.field;
    }
    if (!isDraft()) {
        wholePlan_ = plan_;
    }
    showModels();
    emit fieldChanged();
    emit drawingChanged();
    emit planChanged();
    if (std::exchange(announce_, false)) {
        // Its results take room of the map.
        emit fieldOpened();
    }
    updateState();
}

void PlanSession::keepPlan() {
    planner_.cancel();
    error_.reset();
    stopped_ = false;
    draftAsked_ = false;
}

void PlanSession::fail(const Error& error) {
    if (error.code == ErrorCode::Cancelled) {
        return;
    }
    error_ = error;
    showModels();
    updateState();
}

void PlanSession::showSteps() {
    // While a point is dragged the field before it stands for the one that is being checked.
    const bool before = plan_ != nullptr && state_ == State::Planning;
    steps_.show({.field = field_ ? field_.get() : before ? &plan_->field() : nullptr,
                 .source = source_.get(),
                 .machine = machine_.machine(),
                 .settings = settings(),
                 .plan = plan_.get(),
                 .state = state_});
}

void PlanSession::showModels() {
    figures_.show(plan_.get());
    cells_.show(plan_);
    if (isDraft()) {
        // Not looked for: what was found last stays until the whole plan says what there is.
        return;
    }
    findings_.show(plan_ ? plan_->findings : std::vector<Finding>{},
                   plan_ ? placesOf(drawing_) : std::vector<QGeoCoordinate>{});
}

bool PlanSession::isOfWhatIsShown() const {
    return plan_ != nullptr && !isDraft() && drawnSource_ == source_ && plan_->request.machine == machine_.machine() &&
           plan_->request.settings == settings();
}

PlanState PlanSession::derivedState() const {
    if (reader_.isBusy()) {
        return State::Reading;
    }
    if (choices_.count() > 0) {
        return State::Choosing;
    }
    if (!source_) {
        return error_ ? State::Failed : State::Empty;
    }
    if (isOfWhatIsShown() && !again_) {
        return findings_.blockingCount() > 0 ? State::Problems : State::Ready;
    }
    if (planner_.isBusy()) {
        return State::Planning;
    }
    if (error_) {
        return State::Failed;
    }
    // A draft is followed by the whole plan unless that was stopped.
    return stopped_ ? State::OutOfDate : State::Planning;
}

Said PlanSession::exportRefusal() const {
    switch (state_) {
        case State::Ready:
        case State::Problems: return {};
        case State::Empty: return [] { return tr("There is no field yet, and no plan to export."); };
        case State::Reading:
        case State::Choosing:
            return [] { return tr("A field is being opened. Its plan can be exported when it is finished."); };
        case State::Planning:
            return [] { return tr("The plan is still being made. It can be exported when it is finished."); };
        case State::OutOfDate:
            return [] {
                return tr("The plan is out of date: the field, the machine or a setting was changed after it was made.");
            };
        case State::Failed:
            return [] { return tr("There is no plan to export. The message on the map says why."); };
    }
    return {};
}

void PlanSession::updateState() {
    state_ = derivedState();
    showSteps();
    exporter_.setPlan(isFinished(state_) ? PlanTitle{.plan = plan_, .name = farm_.ownName(), .finished = finished_} : PlanTitle{},
                      exportRefusal());
    emit stateChanged();
}

}  // namespace furrow
