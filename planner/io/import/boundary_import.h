#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/io/content/field_choice.h"
#include "planner/jobs/job.h"

#include <filesystem>
#include <vector>

namespace furrow {

/// Reads the fields of a file or folder: what readFields reads, without its lines. Of vector files: GeoJSON,
/// Shapefile, KML, GeoPackage, GML, FlatGeobuf, file geodatabase, WKT, CSV (a WKT column, or longitude and
/// latitude with one point a row), loose or zipped.
///
/// A feature with polygons is a field; several polygons in it are parts of one field. Where a file has no
/// polygon, lines that end where they begin are taken. Features that say what they are in an attribute
/// `kind`, as a written plan does, are read as that: `field`; `obstacle` (passable, buffer_m, overhang_m,
/// name) and `gate` (width_m, name), which go to the field they lie in; every other kind of a plan is passed
/// over.
///
/// @return at least one field, in the order of the file, not checked yet: coordinates that are not finite
///         are still in it. Rings that do not end where they begin are closed, with a note. Each has an id
///         (its own, or its number in the file), a name (its own, or its id) and an origin. ReadFailed: not
///         there, a folder, unknown format, damaged. InputRefused: empty, no polygon (says what was found),
///         coordinates without a known system, a coordinate that is no number, an obstacle in none of the
///         fields. Cancelled.
/// Cost: linear in the size of the file. Thread-safe. Nothing is fetched from a network.
Result<std::vector<FieldSource>> readBoundaries(const std::filesystem::path& path,
                                                const JobContext& job = {});

}  // namespace furrow
