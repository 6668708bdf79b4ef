#pragma once

#include "planner/io/check/check_run.h"

namespace furrow {

// What is missing from an export, or said otherwise than it is meant.

ExportCheck readable;        ///< the faults that a format's finder saw
ExportCheck contentCounted;  ///< as many parts, holes and lines as are meant
ExportCheck linesUsable;     ///< of two points that differ
ExportCheck widthsMeant;     ///< each width that is stated is one of those meant
ExportCheck numbersInOrder;
ExportCheck systemNamed;       ///< the coordinate system
ExportCheck namesUsable;       ///< unequal, short enough, in letters that the receiver can show
ExportCheck fileNamesAllowed;  ///< on FAT, on Windows, and by terminals of eight and three capitals

}  // namespace furrow
