#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// A field's folder, one of its files, a folder or zip of several fields. The program keeps exports to ISOXML
/// in a field's folder: the field itself comes first.
FormatRecogniser recogniseAgOpenGps;
FieldReader readAgOpenGpsFields;

/// A field folder of AgOpenGPS 6: boundary with holes and obstacles, headland, guidance tracks, gates as
/// flags, and of a plan the whole driven path as RecPath.txt. The program drives forwards only: a path with
/// reverse gear is split where it changes gear, into RecPath.txt and numbered .rec files. It keeps one outer
/// ring to a field: each part gets a folder. Coordinates have three decimals (1 mm).
FormatWriter writeAgOpenGps;
ContentFinder findAgOpenGps;

}  // namespace furrow
