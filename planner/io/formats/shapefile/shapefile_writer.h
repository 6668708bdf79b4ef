#pragma once

#include "planner/io/content/export_job.h"

namespace furrow {

/// One shapefile for each layer (see mapLayers), WGS84, UTF-8.
FormatWriter writeShapefiles;
/// boundary.zip with one flat shapefile of the boundaries, as operations centres take it: text columns CLIENT_NAM,
/// FARM_NAME and FIELD_NAME, whole number POLYGONTYP 1.
FormatWriter writeBoundaryZip;
/// plan.gpkg with the same layers.
FormatWriter writeGeoPackage;
/// AgGPS/Data/<client>/<farm>/<field>/ with Boundary.shp and Swaths.shp in two dimensions: displays of Trimble and
/// those sold by Case and New Holland.
FormatWriter writeAgGps;

}  // namespace furrow
