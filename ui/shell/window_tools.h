#pragma once

namespace furrow {

/// What every program that shows the window does first: the embedded type, the style of standard dialogs and
/// the names that settings are stored under. Call once, after the application exists.
void prepareWindow();

}  // namespace furrow
