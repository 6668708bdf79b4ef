#include "ui/plan/plan_session.h"

#include "planner/imagery/imagery.h"
#include "planner/io/boundary_import.h"
#include "planner/io/file_folder.h"
#include "planner/io/guide_import.h"
#include "planner/plan/draft.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/settings/operation.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

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

Error noSuchField(const QString& path) {
    return {.code = ErrorCode::ReadFailed,
            .what = "the sample field cannot be read",
            .where = path.toStdString(),
            .remedy = "open a file of your own"};
}

/// What a file is: its extension says so where it is ours, otherwise how it begins.
bool holdsProject(const QString& path) {
    if (path.endsWith(QLatin1String{kProjectExtension}, Qt::CaseInsensitive)) {
        return true;
    }
    const auto start = fileStart(path.toStdU16String(), 4096);
    return start && isProject(*start);
}

/// As repaired, so that what is edited is what is planned with; as it is where that fails and the map shows why.
FieldSource repaired(FieldSource source, const JobContext& job) {
    const auto field = Field::create(source, job);
    if (!field) {
        return source;
    }
    FieldSource mended = field->source();
    mended.repairs = field->repairs();
    return mended;
}

Result<std::vector<FieldSource>> boundariesIn(const QString& path, const JobContext& job) {
    if (!path.startsWith(QLatin1Char(':'))) {
        return readBoundaries(path.toStdU16String(), job);
    }
    // The library that reads boundaries knows nothing of resources.
    const QTemporaryDir folder;
    const QString copy = folder.filePath(QFileInfo{path}.fileName());
    return QFile::copy(path, copy) ? readBoundaries(copy.toStdU16String(), job) : std::unexpected(noSuchField(path));
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
        case State::Planning: return isDraft() ? tr("Draft · planning …") : tr("Planning …");
        case State::Stopped:
            return isDraft() ? tr("Stopped · this is a draft")
                   : plan_   ? tr("Stopped · this is the plan before the change")
                             : tr("Stopped");
        case State::Failed: return tr("No plan");
        case State::Ready: break;
    }
    if (isDraft()) {
        return tr("Draft · the whole plan follows when you let go");
    }
    const double milliseconds = plan_->timings.total.si() * 1e3;
    const QString ready = milliseconds < 1e3
                              ? tr("Plan ready · %1 ms").arg(numberText(milliseconds, milliseconds < 10.0 ? 1 : 0))
                              : tr("Plan ready · %1 s").arg(numberText(1e-3 * milliseconds, 1));
    const int undrivable = plan_->path.undrivableCount();
    return undrivable > 0 ? tr("%1 · %n turn(s) leave the field", nullptr, undrivable).arg(ready)
                          : tr("%1 · %2").arg(ready, durationText(plan_->path.duration()));
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

PlanSession::Reading PlanSession::read(const QStringList& paths, const QString& fieldId, const JobContext& job) {
    Reading reading;
    for (const QString& path : paths) {
        if (!path.startsWith(QLatin1Char(':')) && holdsProject(path)) {
            auto project = readProject(path.toStdU16String());
            if (!project) {
                reading.error = project.error();
                return reading;
            }
            reading.project = {path, std::move(*project)};
            continue;
        }
        if (!path.startsWith(QLatin1Char(':')) && isImagery(path.toStdU16String())) {
            reading.imagery << path;
            continue;
        }
        auto fields = boundariesIn(path, job);
        if (fields && !fieldId.isEmpty()) {
            fields = pickField(*fields, fieldId.toStdString()).transform([](FieldSource field) {
                return std::vector{std::move(field)};
            });
        }
        if (!fields) {
            reading.error = fields.error();
            return reading;
        }
        for (FieldSource& field : *fields) {
            reading.fields.push_back(repaired(std::move(field), job));
        }
    }
    return reading;
}

void PlanSession::read(const QStringList& paths, const QString& fieldId) {
    readingName_ = paths.size() == 1 ? QFileInfo{paths.front()}.fileName() : tr("%n file(s)", nullptr, static_cast<int>(paths.size()));
    reader_.submit([this, paths, fieldId](const JobContext& job) -> JobRunner::Delivery {
        Reading reading = read(paths, fieldId, job);
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
    return url.isLocalFile() && holdsProject(url.toLocalFile());
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
    stopped_ = source_ != nullptr;
    updateState();
}

void PlanSession::planAgain() {
    requestPlan(JobRunner::Replace::Now);
}

void PlanSession::closeField() {
    choices_.show({});
    error_.reset();
    files_.begin();
    updateState();
}

PlanSession::Outcome PlanSession::planned(const Source& source, std::shared_ptr<const Field> field,
                                          const Machine& machine, const Settings& settings, bool draft, const Plan* before,
                                          const JobContext& job) {
    if (!field) {
        auto made = Field::create(*source, job.part(0.0, 0.1));
        if (!made) {
            return {.source = source, .field = {}, .plan = {},
                    .drawing = PlanDrawing{outlineGeometry(*source, made.error().place)}, .error = made.error()};
        }
        field = std::make_shared<const Field>(std::move(*made));
    }
    const auto plan = readGuides(settings, *field, job).and_then([&](std::shared_ptr<const GuideData> guides) {
        PlanRequest request{.field = field, .machine = machine, .settings = settings, .guides = std::move(guides)};
        return makePlan(draft ? draftOf(std::move(request), before) : request, job.part(0.1, 0.95));
    });
    if (!plan) {
        return {.source = source, .field = field, .plan = {},
                .drawing = PlanDrawing{fieldGeometry(*field, plan.error().place)}, .error = plan.error()};
    }
    PlanDrawing drawing{planGeometry(**plan)};
    job.report(1.0);
    return {.source = source, .field = std::move(field), .plan = *plan, .drawing = std::move(drawing), .error = {}};
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
        // Its outline is there at once; the plan may take seconds.
        drawing_ = source_ ? PlanDrawing{outlineGeometry(*source_, std::nullopt)} : PlanDrawing{};
        drawnSource_ = source_;
        error_.reset();
        stopped_ = false;
        exporter_.setPlan(nullptr);
        emit planChanged();
        emit drawingChanged();
    }
    if (otherField) {
        showModels();
    } else {
        showSteps();
    }
    emit fieldChanged();
    // A drag may end where its last step was: nothing is stale then, but the whole plan is due.
    if (stale || (draftAsked_ && !document_.isDragging())) {
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
            requestPlan(JobRunner::Replace::Now);
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
         before = wholePlan_](const JobContext& job) -> JobRunner::Delivery {
            Outcome outcome = planned(source, field, machine, settings, draft, before.get(), job);
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
    drawnSource_ = outcome.source;
    error_ = std::move(outcome.error);
    if (outcome.source == source_) {
        field_ = outcome.field;
    }
    if (!isDraft()) {
        wholePlan_ = plan_;
    }
    exporter_.setPlan(isDraft() ? nullptr : plan_);
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

void PlanSession::fail(const Error& error) {
    if (error.code == ErrorCode::Cancelled) {
        return;
    }
    error_ = error;
    showModels();
    updateState();
}

void PlanSession::showSteps() {
    const Field* field = field_ ? field_.get() : plan_ ? &plan_->field() : nullptr;
    steps_.show(field, source_.get(), machine_.machine(), settings(), plan_.get(), error_.has_value());
}

void PlanSession::showModels() {
    showSteps();
    figures_.show(plan_.get());
    cells_.show(plan_);
    if (isDraft()) {
        // Not looked for: what was found last stays until the whole plan says what there is.
        return;
    }
    findings_.show(plan_ ? plan_->findings : std::vector<Finding>{},
                   plan_ ? placesOf(drawing_) : std::vector<QGeoCoordinate>{});
}

void PlanSession::updateState() {
    const bool slowPlanning = planner_.isBusy() && (planner_.isSlow() || !plan_ || (isDraft() && !document_.isDragging()));
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
