#pragma once

#include "planner/plan/plan.h"

#include <optional>

namespace furrow {

/// The segment of the path that is nearest to a place within reach, a later one over an earlier. Cost: O(n)
/// for n samples.
std::optional<std::size_t> segmentAt(const Plan& plan, Point place, Length reach);

/// The cell around a place; nothing outside of all of them.
std::optional<std::size_t> cellAt(const Plan& plan, Point place);

/// The segment of another path that is the same stretch: of the same kind, its ends within half a metre,
/// either way round. Cost: O(segments).
std::optional<std::size_t> sameStretch(const PathSegment& segment, const Path& path);

}  // namespace furrow
