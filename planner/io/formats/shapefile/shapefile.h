#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// One shapefile for each layer (see mapLayers), WGS84, UTF-8.
FormatWriter writeShapefiles;
/// Also of AgGPS folders.
ContentFinder findShapefiles;

/// boundary.zip with one flat shapefile of the boundaries, as operations centres take it: text columns
/// CLIENT_NAM, FARM_NAME and FIELD_NAME, whole number POLYGONTYP 1.
FormatWriter writeBoundaryZip;
ContentFinder findZippedShapefile;

/// A folder with Boundary.shp at some depth, and the swaths that lie beside each.
FormatRecogniser recogniseAgGps;
FieldReader readAgGpsFields;
/// AgGPS/Data/<client>/<farm>/<field>/ with Boundary.shp and Swaths.shp in two dimensions: displays of
/// Trimble and those sold by Case and New Holland.
FormatWriter writeAgGps;

}  // namespace furrow
