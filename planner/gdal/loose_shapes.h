#pragma once

#include "planner/gdal/vector_dataset.h"

#include <string>

namespace furrow {

// Shapes in files that are no datasets to GDAL, but whose shapes it reads.

/// One or more geometries in well-known text, one after the other; "SRID=25832;" before one is understood.
///
/// @param name  of the file, for messages
/// @return InputRefused, with the line and column: no well-known text, a coordinate system that is not known.
///         Cancelled: asked between geometries.
Result<void> readWktShapes(const std::string& text, const std::string& name, const VectorReading& reading);

/// Polygon elements of an XML document that its driver makes no layers of: field files of Fields2Cover,
/// KML without the element kml. (Polygons of KML and of GML 2 are written alike.)
///
/// @return ReadFailed, with the line and column: no XML. InputRefused: a polygon that cannot be read.
Result<void> readPolygonElements(const std::string& text, const std::string& name,
                                 const VectorReading& reading);

}  // namespace furrow
