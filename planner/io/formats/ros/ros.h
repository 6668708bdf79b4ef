#pragma once

#include "planner/io/content/export_job.h"

namespace furrow {

/// rosbag2_sqlite3/ and rosbag2_mcap/: nav_msgs/Path as a recording of ROS 2 (see navPaths), and
/// map_frame.yaml, which says where the frame "map" lies.
FormatWriter writeRosbagSqlite;
FormatWriter writeRosbagMcap;
/// nav_msgs_path.yaml: the same message as `ros2 topic pub` takes it.
FormatWriter writeNavPathYaml;
/// compute_coverage_path_goal.yaml: a goal of opennav_coverage (ComputeCoveragePath) with the plan's headland,
/// heading and order, in metres of the frame "map". Its planner makes swaths and turns of its own from it.
FormatWriter writeCoverageGoal;
/// plan.waypoints: a mission as text (QGC WPL 110) for ArduPilot Rover and the like.
FormatWriter writeWaypoints;
/// plan.plan: the same for QGroundControl, with the boundary and obstacles as fences.
FormatWriter writeGroundStationPlan;
/// path.pb: the message furrow.v1.PathMessage of planner/io/proto/path_message.proto.
FormatWriter writeProtobuf;

}  // namespace furrow
