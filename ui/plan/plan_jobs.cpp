#include "ui/plan/plan_jobs.h"

#include "planner/imagery/imagery.h"
#include "planner/io/import/boundary_import.h"
#include "planner/plan/advice.h"
#include "planner/plan/draft.h"
#include "planner/project/field_tasks.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

namespace furrow {

namespace {

Error noSuchField(const QString& path) {
    return {.code = ErrorCode::ReadFailed,
            .what = "the sample field cannot be read",
            .where = path.toStdString(),
            .remedy = "open a file of your own"};
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

Reading readFiles(const QStringList& paths, const QString& fieldId, const JobContext& job) {
    Reading reading;
    for (const QString& path : paths) {
        if (!path.startsWith(QLatin1Char(':')) && holdsProject(path.toStdU16String())) {
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

PlanOutcome planned(const std::shared_ptr<const FieldSource>& source, std::shared_ptr<const Field> field,
                    const Machine& machine, const Settings& settings, bool draft, const Plan* before,
                    StageCache& cache, const JobContext& job) {
    if (!field) {
        auto made = Field::create(*source, job.part(0.0, 0.1));
        if (!made) {
            return {.source = source, .field = {}, .plan = {},
                    .drawing = PlanDrawing{outlineGeometry(*source, made.error().place)}, .error = made.error()};
        }
        field = std::make_shared<const Field>(std::move(*made));
    }
    const auto plan = planRequest(field, machine, settings, job).and_then([&](PlanRequest request) {
        return makePlan(draft ? draftOf(std::move(request), before) : request, job.part(0.1, 0.9), &cache)
            .and_then([&](const std::shared_ptr<const Plan>& made) { return withAdvice(made, job.part(0.9, 0.95), &cache); });
    });
    if (!plan) {
        return {.source = source, .field = field, .plan = {},
                .drawing = PlanDrawing{fieldGeometry(*field, plan.error().place)}, .error = plan.error()};
    }
    PlanDrawing drawing{planGeometry(**plan)};
    job.report(1.0);
    return {.source = source, .field = std::move(field), .plan = *plan, .drawing = std::move(drawing), .error = {}};
}

}  // namespace furrow
