#pragma once

#include "planner/field/field.h"
#include "planner/machine/machine.h"

#include <span>
#include <string>
#include <string_view>

namespace furrow::test {

/// The names of the fields that settings are tried on: "rectangle", "pond" ...
std::span<const std::string_view> sweepShapes();

/// Small ones for the everyday test.
std::span<const std::string_view> smallSweepShapes();

/// The field of that name. The strip is three operating widths of the machine broad.
FieldSource sweepField(std::string_view shape, const Machine& machine);

/// A field with its obstacles and gates as furrow-cli reads it.
std::string geoJsonOf(const FieldSource& source);

}  // namespace furrow::test
