#pragma once

#include "planner/io/content/format_parts.h"

namespace furrow {

/// plan.waypoints: a mission as text (QGC WPL 110) for ArduPilot Rover and the like.
FormatWriter writeWaypoints;
ContentFinder findWaypoints;

/// plan.plan: the same for QGroundControl, with the boundary and obstacles as fences.
FormatWriter writeGroundStationPlan;
ContentFinder findGroundStationPlan;

}  // namespace furrow
