#pragma once

#include <QMap>
#include <QString>

namespace furrow {

/// Keys of every text in the planner's sources and registries that people see, and of the errors that the
/// window makes itself; with those that have plural forms. %1 ... stand for what the planner fills in, units
/// included, %n for a count.
///
/// @param project  the folder of the sources
QMap<QString, bool> plannerTexts(const QString& project);

/// Parts of the planner that only the command line and other programs speak through.
bool isForPrograms(const QString& file);

}  // namespace furrow
