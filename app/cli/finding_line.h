#pragma once

#include "planner/geodesy/local_frame.h"
#include "planner/path/finding.h"

#include <cstddef>
#include <string>

namespace furrow {

/// "  !   1  What is the matter. What to do. (longitude, latitude)".
std::string findingLine(std::size_t number, const Finding& finding, const LocalFrame& frame);

}  // namespace furrow
