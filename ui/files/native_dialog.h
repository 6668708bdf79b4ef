#pragma once

namespace furrow {

/// Whether the desktop brings a file dialog of its own that Qt shows. Qt does not say so; it is told by the
/// desktop and by what Qt needs for its dialog.
bool desktopHasFileDialog();

}  // namespace furrow
