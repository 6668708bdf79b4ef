#pragma once

#include "planner/machine/machine.h"
#include "planner/path/path.h"

#include <cstddef>
#include <span>
#include <vector>

namespace furrow {

/// Whether a machine is narrower when it is folded for the road than with its implement raised.
bool foldsNarrower(const Machine& machine);

/// Whether a segment is driven with the implement folded for the road: where the plan says so, and on the way
/// in and out. Cost: O(segments).
bool isDrivenFolded(std::span<const PathSegment> segments, std::size_t segment);

/// Consecutive segments, driven folded between two pieces of work. The machine stands before the first to
/// fold, and after the last to unfold.
struct FoldedStretch {
    std::size_t first = 0;
    std::size_t last = 0;

    friend bool operator==(const FoldedStretch&, const FoldedStretch&) = default;
};

/// All of them in driving order. Ways in and out are none: the machine arrives and leaves folded. Cost:
/// O(segments).
std::vector<FoldedStretch> foldedStretches(std::span<const PathSegment> segments);

/// The time that the machine stands to fold and to unfold.
Duration foldingTime(std::span<const PathSegment> segments, const Machine& machine);

}  // namespace furrow
