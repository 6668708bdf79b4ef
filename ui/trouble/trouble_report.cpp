#include "ui/trouble/trouble_report.h"

#include "planner/project/project_file.h"
#include "planner/version.h"
#include "ui/trouble/crash_record.h"

#include <QDateTime>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <QSysInfo>

#include <memory>
#include <utility>

namespace furrow {

namespace {

constexpr int kPauseMs = 1000;
/// Of records that are kept: the last ones tell enough.
constexpr qsizetype kMostRecords = 5;
/// Of a field whose shape is in the record of a crash.
constexpr std::size_t kMostPoints = 20'000;

/// The field and the plan that are worked on, without what is private.
Project withoutNames(const Project& project) {
    Project bare = Project::empty();
    const ProjectField* field = project.field();
    if (field == nullptr) {
        return bare;
    }
    ProjectField only = *field;
    FieldSource source = *only.source;
    source.name = "Field";
    source.origin = {};
    only.id = source.id = "field";
    for (Obstacle& obstacle : source.obstacles) {
        obstacle.name.clear();
    }
    for (Gate& gate : source.gates) {
        gate.name.clear();
    }
    only.source = std::make_shared<const FieldSource>(std::move(source));
    only.others.clear();
    only.obstacleOthers.clear();
    only.gateOthers.clear();
    FieldPlan plan = project.plan();
    plan.name = "Plan";
    plan.season.clear();
    plan.review = {};
    plan.order = {};
    plan.others.clear();
    only.plans = {std::move(plan)};
    bare.fields = {std::make_shared<const ProjectField>(std::move(only))};
    return bare;
}

std::size_t pointsOf(const Project& project) {
    std::size_t points = 0;
    if (const ProjectField* field = project.field()) {
        for (const GeoPolygon& part : field->source->parts) {
            points += part.outer.size();
            for (const GeoRing& hole : part.holes) {
                points += hole.size();
            }
        }
    }
    return points;
}

QJsonObject programJson() {
    return {{QStringLiteral("furrow"),
             QString::fromUtf8(kVersion.data(), static_cast<qsizetype>(kVersion.size()))},
            {QStringLiteral("qt"), QString::fromLatin1(qVersion())},
            {QStringLiteral("system"), QSysInfo::prettyProductName()},
            {QStringLiteral("processor"), QSysInfo::currentCpuArchitecture()}};
}

QStringList recordsIn(const QString& folder, const QString& pattern) {
    return QDir{folder}.entryList({pattern}, QDir::Files, QDir::Time);
}

}  // namespace

TroubleReport::TroubleReport(Document& document, ShownPlan& shown, QObject* parent)
    : QObject{parent}, document_{document}, shown_{shown} {
    later_.setSingleShot(true);
    later_.setInterval(kPauseMs);
    connect(&later_, &QTimer::timeout, this, &TroubleReport::prepare);
}

void TroubleReport::keepIn(const QString& folder) {
    folder_ = folder;
    crash_record::begin(folder.toStdString());
    crashed_ = !recordsIn(folder_, QStringLiteral("crash-*.txt")).isEmpty();
    connect(&document_, &Document::projectChanged, this, [this] { later_.start(); });
    prepare();
    emit changed();
}

void TroubleReport::prepare() {
    QJsonObject record = programJson();
    // A field of very many points would hold up the window; the report that is asked for has it all the same.
    if (pointsOf(*document_.project()) <= kMostPoints) {
        record.insert(QStringLiteral("project"),
                      QString::fromStdString(projectText(withoutNames(*document_.project()))));
    }
    crash_record::setText(QJsonDocument{record}.toJson(QJsonDocument::Compact).toStdString());
}

void TroubleReport::dismiss() {
    const QDir folder{folder_};
    for (const QString& name : recordsIn(folder_, QStringLiteral("crash-*.txt"))) {
        const QString told = QStringLiteral("told-") + name;
        QFile::remove(folder.filePath(told));
        QFile::rename(folder.filePath(name), folder.filePath(told));
    }
    const QStringList told = recordsIn(folder_, QStringLiteral("told-*.txt"));
    for (const QString& name : told.mid(kMostRecords)) {
        QFile::remove(folder.filePath(name));
    }
    crashed_ = false;
    emit changed();
}

QByteArray TroubleReport::text() const {
    QJsonObject report = programJson();
    report.insert(QStringLiteral("written"), QDateTime::currentDateTimeUtc().toString(Qt::ISODate));
    report.insert(
        QStringLiteral("project"),
        QJsonDocument::fromJson(QByteArray::fromStdString(projectText(withoutNames(*document_.project()))))
            .object());
    QJsonArray findings;
    if (shown_.plan()) {
        for (const Finding& finding : shown_.plan()->findings) {
            findings.append(QString::fromStdString(finding.text.text()));
        }
    }
    report.insert(QStringLiteral("findings"), findings);
    QJsonArray crashes;
    for (const char* pattern : {"crash-*.txt", "told-*.txt"}) {
        for (const QString& name : recordsIn(folder_, QLatin1String{pattern})) {
            QFile record{QDir{folder_}.filePath(name)};
            if (!folder_.isEmpty() && record.open(QIODevice::ReadOnly)) {
                crashes.append(QString::fromUtf8(record.readAll()));
            }
        }
    }
    report.insert(QStringLiteral("crashes"), crashes);
    return QJsonDocument{report}.toJson();
}

QUrl TroubleReport::suggestedFile() const {
    const QString day = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd"));
    return QUrl::fromLocalFile(
        QDir{QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)}.filePath(
            QStringLiteral("furrow-problem-%1.json").arg(day)));
}

void TroubleReport::save(const QUrl& file) {
    QSaveFile out{file.toLocalFile()};
    const QByteArray report = text();
    failed_ = !out.open(QIODevice::WriteOnly) || out.write(report) != report.size() || !out.commit();
    outcome_ = failed_ ? tr("The report could not be written: %1").arg(out.errorString())
                       : tr("The report is in %1.").arg(QDir::toNativeSeparators(file.toLocalFile()));
    emit changed();
}

}  // namespace furrow
