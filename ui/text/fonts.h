#pragma once

namespace furrow {

/// Adds the type that Furrow brings along to that of the system. The application has to exist.
void loadFonts();

}  // namespace furrow
