#pragma once

namespace furrow {

// A field of these formats belongs to somebody; boundaries that are read do not say to whom.
inline constexpr const char* kClient = "Furrow";
inline constexpr const char* kFarm = "Farm";

}  // namespace furrow
