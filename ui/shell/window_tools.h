#pragma once

namespace furrow {

/// The names that settings are stored under, and the version.
void nameProgram();

/// What every program that shows the window does first: its name, the embedded type, the style of standard
/// dialogs. Call once, after the application exists.
void prepareWindow();

/// How large the user wants everything; before the application is made. QT_SCALE_FACTOR goes before it.
void applyScale();

}  // namespace furrow
