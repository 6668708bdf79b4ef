#include "ui/plan/plan_session.h"

#include "planner/io/boundary_import.h"
#include "planner/io/guide_import.h"
#include "planner/plan/method_registry.h"
#include "planner/settings/operation.h"
#include "ui/plan/unit_text.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>
#include <array>

namespace furrow {

namespace {

/// Of two settings only one may be given: setting the second brings the first back to its default.
constexpr std::array<std::pair<std::string_view, std::string_view>, 2> kExclusive{
    std::pair{std::string_view{"headland.width_m"}, std::string_view{"headland.passes"}},
    std::pair{std::string_view{"headland.passes"}, std::string_view{"headland.width_m"}}};

std::vector<QGeoCoordinate> placesOf(const PlanDrawing& drawing) {
    return drawing.isEmpty() ? std::vector<QGeoCoordinate>{} : drawing.geometry()->findingPlaces;
}

GeoPoint geoPoint(const QGeoCoordinate& place) {
    return {.lonDeg = place.longitude(), .latDeg = place.latitude()};
}

Error noSuchField(const QString& path) {
    return {.code = ErrorCode::ReadFailed,
            .what = "the sample field cannot be read",
            .where = path.toStdString(),
            .remedy = "open a file of your own"};
}

}  // namespace

PlanSession::PlanSession(QObject* parent) : QObject{parent}, samples_{sampleFields()} {
    connect(&steps_, &StepsModel::changeRequested, this, &PlanSession::changeSetting);
    connect(&machine_, &MachineModel::machineChanged, this, [this] {
        showModels();
        requestPlan(JobRunner::Replace::Now);
    });
    for (JobRunner* runner : {&reader_, &planner_}) {
        connect(runner, &JobRunner::busyChanged, this, &PlanSession::updateState);
        connect(runner, &JobRunner::slowChanged, this, &PlanSession::updateState);
        connect(runner, &JobRunner::slowChanged, this, &PlanSession::progressChanged);
        connect(runner, &JobRunner::progressChanged, this, &PlanSession::progressChanged);
    }
    showModels();
}

QString PlanSession::fieldName() const {
    return source_ ? fromStd(source_->name) : QString{};
}

QStringList PlanSession::sampleNames() const {
    QStringList names;
    for (const SampleField& sample : samples_) {
        names << sample.name;
    }
    return names;
}

QString PlanSession::statusText() const {
    switch (state_) {
        case State::Empty: return {};
        case State::Reading: return tr("Reading %1 …").arg(readingName_);
        case State::Choosing: return tr("%n field(s) in this file", nullptr, choices_.count());
        case State::Planning: return tr("Planning …");
        case State::Stopped: return plan_ ? tr("Stopped · this is the plan before the change") : tr("Stopped");
        case State::Failed: return tr("No plan");
        case State::Ready: break;
    }
    const double milliseconds = plan_->timings.total.si() * 1e3;
    const QString ready = tr("Plan ready · %1 ms").arg(numberText(milliseconds, milliseconds < 10.0 ? 1 : 0));
    const int undrivable = plan_->path.undrivableCount();
    return undrivable > 0 ? tr("%1 · %n turn(s) leave the field", nullptr, undrivable).arg(ready)
                          : tr("%1 · %2").arg(ready, durationText(plan_->path.duration()));
}

QString PlanSession::problem() const {
    if (!error_) {
        return {};
    }
    QString what = fromStd(error_->what);
    if (!what.isEmpty()) {
        what[0] = what[0].toUpper();
    }
    return what;
}

QString PlanSession::problemWhere() const {
    return error_ ? fromStd(error_->where) : QString{};
}

QString PlanSession::problemRemedy() const {
    QString remedy = error_ ? fromStd(error_->remedy) : QString{};
    if (!remedy.isEmpty()) {
        remedy[0] = remedy[0].toUpper();
    }
    return remedy;
}

QGeoCoordinate PlanSession::problemPlace() const {
    return error_ && error_->place ? coordinate(*error_->place) : QGeoCoordinate{};
}

void PlanSession::open(const QString& path, const QString& fieldId) {
    readingName_ = QFileInfo{path}.fileName();
    reader_.submit([this, path, fieldId](const JobContext& job) -> JobRunner::Delivery {
        Result<std::vector<FieldSource>> fields = [&]() -> Result<std::vector<FieldSource>> {
            if (!path.startsWith(QLatin1Char(':'))) {
                return readBoundaries(path.toStdU16String(), job);
            }
            // The library that reads boundaries knows nothing of resources.
            const QTemporaryDir folder;
            const QString copy = folder.filePath(QFileInfo{path}.fileName());
            return QFile::copy(path, copy) ? readBoundaries(copy.toStdU16String(), job)
                                           : std::unexpected(noSuchField(path));
        }();
        if (fields && !fieldId.isEmpty()) {
            fields = pickField(*fields, fieldId.toStdString()).transform([](FieldSource field) {
                return std::vector{std::move(field)};
            });
        }
        return [this, fields = std::move(fields), name = QFileInfo{path}.fileName()]() mutable {
            if (!fields) {
                fail(fields.error());
                return;
            }
            fileName_ = name;
            if (fields->size() == 1) {
                setSource(std::move(fields->front()));
                return;
            }
            choices_.show(std::move(*fields));
            updateState();
        };
    });
    updateState();
}

void PlanSession::openSample(int index) {
    if (index >= 0 && index < samples_.size()) {
        open(samples_[index].resource);
    }
}

void PlanSession::chooseField(int row) {
    if (row >= 0 && row < choices_.count()) {
        setSource(choices_.field(row));
    }
}

void PlanSession::dropChoices() {
    choices_.show({});
    updateState();
}

void PlanSession::setBoundary(const QList<QGeoCoordinate>& points) {
    GeoRing ring;
    std::ranges::transform(points, std::back_inserter(ring), [](const QGeoCoordinate& p) { return geoPoint(p); });
    fileName_.clear();
    setSource({.id = "drawn",
               .name = tr("Drawn field").toStdString(),
               .origin = tr("drawn on the map").toStdString(),
               .parts = {GeoPolygon{.outer = std::move(ring), .holes = {}}},
               .obstacles = {},
               .gates = {},
               .boundaryAccuracy = {}});
}

void PlanSession::moveVertex(int part, int ring, int vertex, const QGeoCoordinate& place, bool finished) {
    if (!source_ || part < 0 || part >= static_cast<int>(source_->parts.size())) {
        return;
    }
    GeoPolygon& polygon = source_->parts[static_cast<std::size_t>(part)];
    if (ring < 0 || ring > static_cast<int>(polygon.holes.size())) {
        return;
    }
    GeoRing& points = ring == 0 ? polygon.outer : polygon.holes[static_cast<std::size_t>(ring - 1)];
    if (vertex < 0 || vertex >= static_cast<int>(points.size())) {
        return;
    }
    points[static_cast<std::size_t>(vertex)] = geoPoint(place);
    field_.reset();
    draggingVertex_ = !finished;
    requestPlan(finished ? JobRunner::Replace::Now : JobRunner::Replace::WhenDone);
}

void PlanSession::cancel() {
    reader_.cancel();
    planner_.cancel();
    stopped_ = source_.has_value();
    updateState();
}

void PlanSession::planAgain() {
    requestPlan(JobRunner::Replace::Now);
}

void PlanSession::closeField() {
    planner_.cancel();
    source_.reset();
    field_.reset();
    plan_.reset();
    drawing_ = {};
    error_.reset();
    stopped_ = false;
    fileName_.clear();
    choices_.show({});
    showModels();
    emit fieldChanged();
    emit planChanged();
    emit drawingChanged();
    updateState();
}

PlanSession::Outcome PlanSession::planned(const FieldSource& source, std::shared_ptr<const Field> field,
                                          const Machine& machine, const Settings& settings, const JobContext& job) {
    if (!field) {
        auto made = Field::create(source, job.part(0.0, 0.1));
        if (!made) {
            return {.field = {}, .plan = {}, .drawing = PlanDrawing{outlineGeometry(source, made.error().place)},
                    .error = made.error()};
        }
        field = std::make_shared<const Field>(std::move(*made));
    }
    const auto plan = readGuides(settings, *field, job).and_then([&](std::shared_ptr<const GuideData> guides) {
        return makePlan({.field = field, .machine = machine, .settings = settings, .guides = std::move(guides)},
                        job.part(0.1, 0.95));
    });
    if (!plan) {
        return {.field = field, .plan = {}, .drawing = PlanDrawing{fieldGeometry(*field, plan.error().place)},
                .error = plan.error()};
    }
    PlanDrawing drawing{planGeometry(**plan)};
    job.report(1.0);
    return {.field = std::move(field), .plan = *plan, .drawing = std::move(drawing), .error = {}};
}

void PlanSession::setSource(FieldSource source) {
    source_ = std::move(source);
    field_.reset();
    plan_.reset();
    drawing_ = {};
    error_.reset();
    draggingVertex_ = false;
    announce_ = true;
    choices_.show({});
    showModels();
    emit fieldChanged();
    emit planChanged();
    emit drawingChanged();
    requestPlan(JobRunner::Replace::Now);
}

void PlanSession::changeSetting(const Parameter* parameter, const SettingValue& value, bool live) {
    if (settings_.value(*parameter) == value) {
        return;
    }
    if (const Result<void> set = settings_.set(*parameter, value); !set) {
        fail(set.error());
        return;
    }
    for (const auto& [given, other] : kExclusive) {
        if (parameter->key == given && !std::holds_alternative<Auto>(value)) {
            settings_.clear(*findParameter(other).value());
        }
    }
    if (parameter == &kOperationKind) {
        // Who picks an operation wants what goes with it, also where another choice was made before.
        for (const OperationDefault& entry : settings_.operation().defaults) {
            settings_.clear(*findParameter(entry.key).value());
        }
    }
    showModels();
    requestPlan(live ? JobRunner::Replace::WhenDone : JobRunner::Replace::Now);
}

void PlanSession::requestPlan(JobRunner::Replace replace) {
    if (!source_) {
        return;
    }
    stopped_ = false;
    planner_.submit(
        [this, source = *source_, field = field_, machine = machine_.machine(),
         settings = settings_](const JobContext& job) -> JobRunner::Delivery {
            Outcome outcome = planned(source, field, machine, settings, job);
            return [this, outcome = std::move(outcome)]() mutable { take(std::move(outcome)); };
        },
        replace);
    updateState();
}

void PlanSession::take(Outcome outcome) {
    if (!source_ || (outcome.error && outcome.error->code == ErrorCode::Cancelled)) {
        return;
    }
    plan_ = std::move(outcome.plan);
    drawing_ = std::move(outcome.drawing);
    error_ = std::move(outcome.error);
    if (!draggingVertex_) {
        // As repaired: vertices on the map and in the source have the same numbers again.
        field_ = outcome.field;
        if (field_) {
            source_ = field_->source();
        }
    }
    exporter_.setPlan(plan_);
    showModels();
    emit fieldChanged();
    emit drawingChanged();
    emit planChanged();
    if (announce_) {
        announce_ = false;
        emit fieldOpened();
    }
    updateState();
}

void PlanSession::fail(const Error& error) {
    if (error.code == ErrorCode::Cancelled) {
        return;
    }
    error_ = error;
    showModels();
    updateState();
}

void PlanSession::showModels() {
    const Field* field = field_ ? field_.get() : plan_ ? &plan_->field() : nullptr;
    steps_.show(field, machine_.machine(), settings_, plan_.get(), error_.has_value());
    figures_.show(plan_.get());
    findings_.show(plan_ ? plan_->findings : std::vector<Finding>{},
                   plan_ ? placesOf(drawing_) : std::vector<QGeoCoordinate>{});
}

void PlanSession::updateState() {
    const bool slowPlanning = planner_.isBusy() && (planner_.isSlow() || !plan_);
    state_ = reader_.isBusy()      ? State::Reading
             : choices_.count() > 0 ? State::Choosing
             : slowPlanning         ? State::Planning
             : error_               ? State::Failed
             : !source_             ? State::Empty
             : stopped_             ? State::Stopped
             : plan_                ? State::Ready
                                    : State::Planning;
    emit stateChanged();
}

}  // namespace furrow
