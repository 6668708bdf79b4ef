#include "planner/io/formats/ros/nav_path.h"

#include "planner/io/files/byte_writer.h"

#include <algorithm>
#include <cmath>
#include <format>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

constexpr const char* kFrame = "map";

NavPose poseOf(const PathSample& sample) {
    return {.stampNs = std::llround(sample.tS * 1e9),
            .x = sample.position.x,
            .y = sample.position.y,
            .qz = std::sin(sample.headingRad / 2.0),
            .qw = std::cos(sample.headingRad / 2.0)};
}

void addSegment(const PathSegment& segment, std::vector<NavPose>& poses) {
    for (const PathSample& sample : segment.samples) {
        const NavPose pose = poseOf(sample);
        // A segment begins where the one before ends.
        const bool again = !poses.empty() && poses.back().x == pose.x && poses.back().y == pose.y &&
                           poses.back().stampNs == pose.stampNs;
        if (!again) {
            poses.push_back(pose);
        }
    }
}

/// std_msgs/Header.
void addHeader(ByteWriter& cdr, std::int64_t stampNs) {
    cdr.align(4);
    cdr.integer(static_cast<std::int32_t>(stampNs / 1'000'000'000));
    cdr.integer(static_cast<std::uint32_t>(stampNs % 1'000'000'000));
    cdr.integer(static_cast<std::uint32_t>(std::string_view{kFrame}.size() + 1));
    cdr.bytes(kFrame);
    cdr.integer(std::uint8_t{0});
}

}  // namespace

std::vector<NavPath> navPaths(const Plan& plan) {
    NavPath whole{"/coverage_path", {}};
    std::vector<NavPath> stretches;
    bool reverses = false;
    for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
        const PathSegment& segment = plan.path.segments[i];
        addSegment(segment, whole.poses);
        const bool reversing = segment.gear == Gear::Reverse;
        reverses = reverses || reversing;
        if (i == 0 || segment.gear != plan.path.segments[i - 1].gear) {
            stretches.push_back({reversing ? "/coverage_path/reverse" : "/coverage_path/forward", {}});
        }
        addSegment(segment, stretches.back().poses);
    }
    std::vector<NavPath> paths{std::move(whole)};
    if (reverses) {
        std::ranges::move(stretches, std::back_inserter(paths));
    }
    return paths;
}

std::string cdrOf(const NavPath& path) {
    ByteWriter cdr;  // without the encapsulation, from which nothing is counted
    addHeader(cdr, path.poses.empty() ? 0 : path.poses.front().stampNs);
    cdr.align(4);
    cdr.integer(static_cast<std::uint32_t>(path.poses.size()));
    for (const NavPose& pose : path.poses) {
        addHeader(cdr, pose.stampNs);
        cdr.align(8);
        for (const double value : {pose.x, pose.y, 0.0, 0.0, 0.0, pose.qz, pose.qw}) {
            cdr.real(value);
        }
    }
    return std::string{'\0', '\1', '\0', '\0'} + std::move(cdr).take();
}

std::vector<NavTopic> topicsOf(const std::vector<NavPath>& paths) {
    std::vector<NavTopic> topics;
    for (const NavPath& path : paths) {
        auto known = std::ranges::find(topics, path.topic, &NavTopic::name);
        if (known == topics.end()) {
            known = topics.insert(topics.end(), {path.topic, {}});
        }
        known->messages.push_back(&path);
    }
    return topics;
}

std::string bagMetadata(const std::vector<NavPath>& paths, std::string_view storage, std::string_view file) {
    std::int64_t last = 0;
    for (const NavPath& path : paths) {
        last = std::max(last, path.recordedNs());
    }
    std::string text = std::format(
        "rosbag2_bagfile_information:\n  version: 4\n  storage_identifier: {}\n  relative_file_paths:\n    - {}\n"
        "  duration:\n    nanoseconds: {}\n  starting_time:\n    nanoseconds_since_epoch: {}\n  message_count: {}\n"
        "  topics_with_message_count:\n",
        storage, file, last - paths.front().recordedNs(), paths.front().recordedNs(), paths.size());
    for (const NavTopic& topic : topicsOf(paths)) {
        std::format_to(std::back_inserter(text),
                       "    - topic_metadata:\n        name: {}\n        type: nav_msgs/msg/Path\n"
                       "        serialization_format: cdr\n        offered_qos_profiles: \"\"\n"
                       "      message_count: {}\n",
                       topic.name, topic.messages.size());
    }
    return text + "  compression_format: \"\"\n  compression_mode: \"\"\n";
}

}  // namespace furrow
