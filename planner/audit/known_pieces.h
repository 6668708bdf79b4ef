#pragma once

#include "planner/geometry/polygon_memo.h"

namespace furrow {

/// What became of pieces of land.
using KnownPieces = PolygonMemo<MultiPolygon>;

/// About a megabyte.
inline constexpr std::size_t kMostPieces = 1000;

}  // namespace furrow
