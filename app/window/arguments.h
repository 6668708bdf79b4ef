#pragma once

#include <QCommandLineOption>
#include <QList>
#include <QSize>
#include <QString>

#include <expected>

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

/// The exit status instead where nothing is to be started: help and version are printed, and what is wrong.
std::expected<Arguments, int> argumentsOf(const QCoreApplication& application);

}  // namespace furrow
