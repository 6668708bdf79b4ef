#pragma once

#include "planner/core/result.h"
#include "planner/path/path.h"
#include "planner/plan/plan.h"

#include <string>
#include <string_view>

namespace furrow {

/// The path as a table, one row for each sample, numbers in their shortest form that reads back exactly.
std::string pathCsv(const Plan& plan);

/// The path again, from such a table: columns by their names, in any order; places in its local frame. What
/// the table does not hold is left as it is made: names of turns, swath numbers, what cannot be driven. A
/// segment refills if the level after it differs.
///
/// @param where  the file, for messages
/// @return at least one segment, each with at least two samples. InputRefused, naming the line: a column is
///         missing, a value is no number, an unknown kind of segment, no rows.
/// Cost: linear.
Result<Path> readPathCsv(std::string_view text, const std::string& where);

}  // namespace furrow
