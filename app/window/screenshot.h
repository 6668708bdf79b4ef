#pragma once

#include <QString>

class QQuickWindow;

namespace furrow {

class Session;

/// Saves a picture of the window as soon as nothing is being planned or loaded any more, and ends the
/// program: status 0, or 1 where the file cannot be written.
void saveScreenshotWhenReady(QQuickWindow& window, Session& session, const QString& file);

}  // namespace furrow
