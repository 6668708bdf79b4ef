#pragma once

#include "planner/io/content/export_job.h"

namespace furrow {

/// plan.kml: folders Boundaries (outer ring first), Obstacles, Gates, Headland, Swaths (or Lines, without a plan)
/// and Path, in nine decimals. Each placemark says in its data what it is, so that it is read back as that.
FormatWriter writeKml;
/// The same zipped, with doc.kml in it.
FormatWriter writeKmz;
/// path.gpx (version 1.1): the path as a track with a segment between two changes of gear, a route with a point at
/// each end of each swath, gates as waypoints. Fields alone are tracks that end where they begin.
FormatWriter writeGpx;
/// plan_EPSG<code>.dxf (R12): polylines in metres of the field's UTM zone, layers BOUNDARY, HOLE, OBSTACLE,
/// HEADLAND, SWATH and PATH.
FormatWriter writeDxf;

}  // namespace furrow
