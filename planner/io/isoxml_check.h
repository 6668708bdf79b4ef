#pragma once

#include "planner/io/field_content.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow {

/// What a terminal would stumble over in task data that is well-formed, and that no schema notices: rings that
/// are open, too short or cross themselves; holes outside their boundary; a pattern without exactly one line;
/// points of the wrong number or kind for the pattern; references to nothing; ids or names twice; names over
/// 32 characters; numbers that are no plain decimals; areas that differ from the outline by over 0.5 %; points
/// farther than 10 km from the fields that were meant (longitude and latitude exchanged).
///
/// Shares no code with the writer. Empty for a good file; one sentence each, in the order of the file.
/// Cost: O(n log n) for n points.
std::vector<std::string> isoxmlProblems(std::string_view xml, std::span<const FieldContent> meant);

}  // namespace furrow
