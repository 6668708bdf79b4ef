#include "ui/project/sample_fields.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace furrow {

namespace {

/// The name of the first feature, or the file's own.
QString nameIn(const QString& resource, const QString& fallback) {
    QFile file{resource};
    if (!file.open(QIODevice::ReadOnly)) {
        return fallback;
    }
    const QJsonArray features = QJsonDocument::fromJson(file.readAll()).object().value(u"features").toArray();
    for (const QJsonValue& feature : features) {
        const QString name = feature.toObject().value(u"properties").toObject().value(u"name").toString();
        if (!name.isEmpty()) {
            return name;
        }
    }
    return fallback;
}

}  // namespace

QList<SampleField> sampleFields() {
    QList<SampleField> fields;
    const QDir folder{QStringLiteral(":/furrow/samples")};
    for (const QFileInfo& info :
         folder.entryInfoList({QStringLiteral("*.geojson")}, QDir::Files, QDir::Name)) {
        QString plain = info.completeBaseName();
        plain.replace(QLatin1Char('_'), QLatin1Char(' '));
        fields.push_back({nameIn(info.filePath(), plain), info.filePath()});
    }
    return fields;
}

}  // namespace furrow
