#pragma once

#include <string_view>

namespace furrow {

/// The version of this program, as plans and exported files state it.
inline constexpr std::string_view kVersion = FURROW_VERSION;

}  // namespace furrow
