#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// plan.kml: folders Boundaries (outer ring first), Obstacles, Gates, Headland, Swaths (or Lines, without a
/// plan) and Path, in nine decimals. Each placemark says in its data what it is, so that it is read back as
/// that.
FormatWriter writeKml;
/// The same zipped, with doc.kml in it.
FormatWriter writeKmz;
/// Of either.
ContentFinder findKml;

}  // namespace furrow
