#pragma once

#include <string>
#include <string_view>

namespace furrow {

/// Of these bytes; two that have equal ones hold the same. Tells what was changed; nobody is to be kept out
/// by it.
std::string fingerprint(std::string_view bytes);

}  // namespace furrow
