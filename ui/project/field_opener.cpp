#include "ui/project/field_opener.h"

#include "planner/project/project_edits.h"
#include "ui/map/map_frame.h"
#include "ui/text/display.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <QFileInfo>

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

FieldOpener::FieldOpener(Document& document, ProjectFiles& files, RecentFiles& recent, Problem& problem,
                         QObject* parent)
    : QObject{parent},
      document_{document},
      files_{files},
      recent_{recent},
      problem_{problem},
      samples_{sampleFields()} {
    connect(&files_, &ProjectFiles::saved, this,
            [this](const QString& path) { recent_.add(path, *document_.project()); });
    connect(&reader_, &JobRunner::busyChanged, this, &FieldOpener::stateChanged);
    connect(&reader_, &JobRunner::slowChanged, this, &FieldOpener::stateChanged);
    connect(&reader_, &JobRunner::slowChanged, this, &FieldOpener::progressChanged);
    connect(&reader_, &JobRunner::progressChanged, this, &FieldOpener::progressChanged);
    connect(&Display::instance(), &Display::changed, this, &FieldOpener::textsChanged);
}

QStringList FieldOpener::sampleNames() const {
    QStringList names;
    for (const SampleField& sample : samples_) {
        names << shown(sample.name.toStdString());
    }
    return names;
}

void FieldOpener::read(const QStringList& paths, const QString& fieldId) {
    readingName_ = paths.size() == 1 ? QFileInfo{paths.front()}.fileName()
                                     : tr("%n file(s)", nullptr, static_cast<int>(paths.size()));
    reader_.submit([this, paths, fieldId](const JobContext& job) -> JobRunner::Delivery {
        Reading reading = readFiles(paths, fieldId, job);
        return [this, reading = std::move(reading), choose = paths.size() == 1]() mutable {
            take(std::move(reading), choose);
        };
    });
    emit stateChanged();
}

void FieldOpener::take(Reading reading, bool choose) {
    if (reading.error) {
        problem_.show(*reading.error);
        emit stateChanged();
        return;
    }
    if (reading.project && !files_.open(reading.project->first, std::move(reading.project->second))) {
        emit stateChanged();
        return;
    }
    if (reading.project) {
        recent_.add(files_.path(), *document_.project());
    }
    emit imageryFound(reading.imagery);
    if (reading.drive != nullptr) {
        emit driveFound(QFileInfo{reading.drives.front()}.fileName(), reading.drive);
    }
    if (choose && reading.fields.size() > 1) {
        choices_.show(std::move(reading.fields));
    } else if (!reading.fields.empty()) {
        addFields(std::move(reading.fields));
    }
    emit stateChanged();
}

void FieldOpener::addFields(std::vector<FieldSource> fields) {
    LazyText text = [name = fromStd(fields.front().name), count = static_cast<int>(fields.size())] {
        return count == 1 ? tr("Add field %1").arg(name) : tr("Add %n field(s)", nullptr, count);
    };
    choices_.show({});
    document_.change(std::move(text), withFields(*document_.project(), std::move(fields)));
    emit stateChanged();
}

void FieldOpener::open(const QString& path, const QString& fieldId) {
    read({path}, fieldId);
}

void FieldOpener::openUrls(const QList<QUrl>& urls) {
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

bool FieldOpener::isProjectFile(const QUrl& url) const {
    return url.isLocalFile() && holdsProject(url.toLocalFile().toStdU16String());
}

void FieldOpener::openSample(int index) {
    if (index >= 0 && index < samples_.size()) {
        open(samples_[index].resource);
    }
}

void FieldOpener::chooseField(int row) {
    if (row >= 0 && row < choices_.count()) {
        addFields({choices_.field(row)});
    }
}

void FieldOpener::chooseAll() {
    std::vector<FieldSource> fields;
    for (int row = 0; row < choices_.count(); ++row) {
        fields.push_back(choices_.field(row));
    }
    if (!fields.empty()) {
        addFields(std::move(fields));
    }
}

void FieldOpener::dropChoices() {
    choices_.show({});
    emit stateChanged();
}

void FieldOpener::addDrawn(const QList<QGeoCoordinate>& boundary) {
    GeoRing ring;
    std::ranges::transform(boundary, std::back_inserter(ring),
                           [](const QGeoCoordinate& p) { return geoPoint(p); });
    addFields({{.id = "drawn",
                .name = tr("Field %1").arg(document_.project()->fields.size() + 1).toStdString(),
                .origin = tr("drawn on the map").toStdString(),
                .parts = {GeoPolygon{.outer = std::move(ring), .holes = {}}},
                .obstacles = {},
                .gates = {},
                .boundaryAccuracy = {}}});
}

void FieldOpener::startNew() {
    choices_.show({});
    problem_.clear();
    files_.begin();
    emit stateChanged();
}

}  // namespace furrow
