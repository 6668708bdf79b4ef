#pragma once

#include "planner/field/field.h"
#include "planner/machine/machine.h"

#include <string>
#include <string_view>
#include <vector>

namespace furrow::test {

/// The names of the fields that settings are tried on: "rectangle", "pond" ...
std::vector<std::string> sweepShapes();

/// Small ones for the everyday test.
std::vector<std::string> smallSweepShapes();

/// The field of one of these names; one without parts for others. The strip is three operating widths of the
/// machine broad.
FieldSource sweepField(std::string_view shape, const Machine& machine);

/// A field with its obstacles and gates as furrow-cli reads it.
std::string geoJsonOf(const FieldSource& source);

}  // namespace furrow::test
