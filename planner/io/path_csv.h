#pragma once

#include "planner/plan/plan.h"

#include <string>

namespace furrow {

/// The path as a table, one row for each sample, numbers in their shortest form that reads back exactly.
std::string pathCsv(const Plan& plan);

}  // namespace furrow
