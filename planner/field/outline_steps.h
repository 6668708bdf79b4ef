#pragma once

#include "planner/field/field.h"

#include <optional>

namespace furrow {

/// The steps of an outline that was traced along the pixels of an image.
struct OutlineSteps {
    int count = 0;
    Length height;  ///< of the middle one, across the outline

    friend bool operator==(const OutlineSteps&, const OutlineSteps&) = default;
};

/// The steps of boundary and holes. Empty unless there are at least a dozen, no higher than 30 m, and two in
/// five of all edges are risers: notches that somebody drew are no steps. Empty, too, where all of them stay
/// as they are when the outline is made straight. Cost: O(n log n).
std::optional<OutlineSteps> stepsOf(const FieldSource& source);

/// Leads the outline through the middles of its steps, in straight lines where they come near enough. It
/// moves by a step and a half at most; where there are no steps, no point moves. An edge with a headland or
/// an overhang of its own stays. Gates on the boundary stay on it. Errors: those of Field::create for the new
/// outline, as for rings that cross then. Cancelled. Cost: O(n log n) for usual outlines.
Result<FieldSource> withStraightSteps(const FieldSource& source, const JobContext& job = {});

}  // namespace furrow
