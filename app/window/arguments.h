#pragma once

#include <QCommandLineOption>
#include <QList>
#include <QSize>
#include <QString>

class QCoreApplication;

namespace furrow {

/// What the window was started with.
struct Arguments {
    QString file;
    QString fieldId;
    QString screenshot;
    QString theme;
    QString language;
    QString units;
    QSize size;
    bool selfTest = false;
};

QString windowDescription();

/// Every option but help and version.
QList<QCommandLineOption> windowOptions();

/// Ends the program where the arguments ask for help or are wrong.
Arguments argumentsOf(const QCoreApplication& application);

}  // namespace furrow
