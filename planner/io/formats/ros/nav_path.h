#pragma once

#include "planner/plan/plan.h"

#include <cstdint>
#include <string>
#include <vector>

namespace furrow {

/// A place and a direction of nav_msgs/Path, in the plan's local frame: metres east and north, yaw
/// counter-clockwise from east as a quaternion about z.
struct NavPose {
    std::int64_t stampNs = 0;  ///< since the start of the path
    double x = 0.0;
    double y = 0.0;
    double qz = 0.0;
    double qw = 1.0;
};

/// One message.
struct NavPath {
    std::string topic;
    std::vector<NavPose> poses;

    /// When it counts as recorded: with its first pose. A nanosecond later, because in MCAP a chunk whose
    /// first time is 0 has no messages.
    std::int64_t recordedNs() const { return poses.front().stampNs + 1; }
};

/// "/coverage_path" with the whole path. The message does not say which gear: where the path reverses, each
/// stretch in one gear follows as a message of its own on "/coverage_path/forward" or
/// "/coverage_path/reverse".
std::vector<NavPath> navPaths(const Plan& plan);

/// nav_msgs/msg/Path in little-endian CDR, frame "map", with its four bytes of encapsulation.
std::string cdrOf(const NavPath& path);

/// What a topic is called by, its messages in their order.
struct NavTopic {
    std::string name;
    std::vector<const NavPath*> messages;
};
std::vector<NavTopic> topicsOf(const std::vector<NavPath>& paths);

/// The text of metadata.yaml of a rosbag2 folder with one file.
std::string bagMetadata(const std::vector<NavPath>& paths, std::string_view storage, std::string_view file);

/// MCAP with one chunk, its index and statistics (mcap.dev/spec, version of 2024; profile ros2).
std::string mcapOf(const std::vector<NavPath>& paths);

}  // namespace furrow
