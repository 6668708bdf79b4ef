#pragma once

#include <QString>
#include <QStringList>

namespace furrow {

// The texts in source files, found by their form.

/// A pattern of a string literal, with those that follow it as one.
extern const QString kLiteral;

/// What a literal of the sources says.
QString joined(const QString& literal);

/// The whole text of a file; empty where it cannot be read.
QString textOf(const QString& path);

/// A source file without comments, includes and raw strings.
QString codeOf(const QString& path);

/// The files below a folder whose names fit, sorted.
QStringList filesIn(const QString& folder, const QStringList& names);

}  // namespace furrow
