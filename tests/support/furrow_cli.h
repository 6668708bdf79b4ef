#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

namespace furrow::test {

/// What one run of furrow-cli came to.
struct Answer {
    int status = -1;  ///< -1: it crashed, or did not end in time
    QByteArray out;
    QByteArray error;

    QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
    QByteArray all() const { return out + error; }
};

inline const QString kFurrowCli = QStringLiteral(FURROW_BINARY_DIR "/furrow-cli");

inline Answer furrowCli(const QStringList& arguments, int withinMs = 60'000) {
    QProcess process;
    process.start(kFurrowCli, arguments);
    if (!process.waitForFinished(withinMs) || process.exitStatus() != QProcess::NormalExit) {
        return {};
    }
    return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

/// A sample field that comes with Furrow, by the name of its file.
inline QString sampleField(const QString& name) {
    return QStringLiteral(FURROW_SOURCE_DIR "/resources/sample_fields/%1.geojson").arg(name);
}

/// Nothing where there is no such file.
inline QByteArray contentsOf(const QString& path) {
    QFile file{path};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
}

/// Makes the file, or replaces what is in it; gives its path.
inline QString writeFile(const QString& path, const QByteArray& text) {
    QFile file{path};
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
        qFatal("%s could not be written", qPrintable(path));
    }
    return path;
}

}  // namespace furrow::test
