#pragma once

#include "planner/io/content/format_parts.h"

#include <filesystem>
#include <string>
#include <vector>

namespace furrow {

/// rosbag2_sqlite3/ and rosbag2_mcap/: nav_msgs/Path as a recording of ROS 2 (see navPaths), and
/// map_frame.yaml, which says where the frame "map" lies.
FormatWriter writeRosbagSqlite;
FormatWriter writeRosbagMcap;
/// Of either storage.
ContentFinder findRosbag;

/// nav_msgs_path.yaml: the same message as `ros2 topic pub` takes it.
FormatWriter writeNavPathYaml;
ContentFinder findNavPathYaml;

/// compute_coverage_path_goal.yaml: a goal of opennav_coverage (ComputeCoveragePath) with the plan's
/// headland, heading and order, in metres of the frame "map". Its planner makes swaths and turns of its own
/// from it.
FormatWriter writeCoverageGoal;
ContentFinder findCoverageGoal;

/// A file of a rosbag2, or a folder with some. Bags of ROS 1 are known, and refused.
FormatRecogniser recogniseRosbag;
TrackReader readRosbag;

/// Of one or more files of one bag, in their order.
Result<TrackFile> rosbagTracks(const std::vector<std::filesystem::path>& files, const std::string& where,
                               const JobContext& job);

}  // namespace furrow
