#pragma once

namespace furrow {

/// What every program that shows the window does first: the embedded type, the style of standard dialogs and
/// the names that settings are stored under. Call once, after the application exists.
void prepareWindow();

/// How large the user wants everything; before the application is made. QT_SCALE_FACTOR goes before it.
void applyScale();

}  // namespace furrow
