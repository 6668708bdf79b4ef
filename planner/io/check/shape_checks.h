#pragma once

#include "planner/io/check/check_run.h"

namespace furrow {

// What is wrong with the points and rings of an export.

ExportCheck coordinatesOnEarth;
ExportCheck nearTheFields;  ///< within ten kilometres of what was meant
ExportCheck ringsClosed;    ///< or open, as the format has them, with three corners
ExportCheck ringsSimple;    ///< no ring crosses itself, no hole lies outside
ExportCheck ringsWound;     ///< the way round that the format asks for
ExportCheck areasAsStated;

}  // namespace furrow
