#include "ui/project/file_reading.h"

#include "planner/imagery/imagery.h"
#include "planner/io/import/boundary_import.h"
#include "planner/io/import/recorded_drive.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

Error noSuchField(const QString& path) {
    return {.code = ErrorCode::ReadFailed,
            .what = "the sample field cannot be read",
            .where = path.toStdString(),
            .remedy = "open a file of your own"};
}

/// As repaired, so that what is edited is what is planned with; as it is where that fails and the map shows
/// why.
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
    return QFile::copy(path, copy) ? readBoundaries(copy.toStdU16String(), job)
                                   : std::unexpected(noSuchField(path));
}

/// Several files are one recording: of several days, or parts of one.
void addDrive(Reading& reading, const QString& path, TrackFile drive) {
    reading.drives << path;
    if (reading.drive == nullptr) {
        reading.drive = std::make_shared<TrackFile>(std::move(drive));
        return;
    }
    std::ranges::move(drive.tracks, std::back_inserter(reading.drive->tracks));
    std::ranges::move(drive.notes, std::back_inserter(reading.drive->notes));
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
        if (!path.startsWith(QLatin1Char(':')) && fieldId.isEmpty()) {
            if (auto drive = recordedDrive(path.toStdU16String(), job)) {
                addDrive(reading, path, *std::move(drive));
                continue;
            }
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

}  // namespace furrow
