#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/track/recorded_track.h"

#include <filesystem>

namespace furrow {

/// What is read of a file to tell whether it is a track.
inline constexpr std::size_t kTrackStartBytes = 16'384;
/// A folder of logs, in the folder of a task, on a stick.
inline constexpr int kDeepestTrack = 2;

/// Reads what a machine drove. The format is told by the content:
/// - GPX: each track segment (routes where there is no track); time, and speed and course of version 1.0;
/// - a table with a header (comma, semicolon or tab; decimal comma unless the comma separates): longitude
///   and latitude, or `x_m` and `y_m` in the plan's frame; time, speed with its unit, `heading_rad` or a
///   course in degrees clockwise from north, `implement_down`; a plan's own path.csv; lines before the
///   header are passed over. The yield monitor text of Ag Leader is read without a header;
/// - a gpsd JSON log (TPV), an NMEA 0183 log (RMC, or GGA where there is none);
/// - ISOXML time logs: TASKDATA.XML, its folder, or a zip of it; every log is a track;
/// - rosbag2: the folder, or its .db3 or .mcap file; sensor_msgs/NavSatFix, else nav_msgs/Odometry,
///   geometry_msgs/PoseStamped or nav_msgs/Path, whose places are in the plan's frame. One topic is read,
///   the one with the most samples; the others are named in a note.
///
/// @return at least one track with at least one sample. Lines, records and messages that carry no place are
///         passed over and counted in a note. ReadFailed: not there, cut off, damaged. InputRefused: empty,
///         no track in it, a place that is no number or not on Earth (with its line), larger than 1 GiB
///         (GPX 256 MiB) or 5 million samples. Each with what to do. Cancelled.
/// Cost: linear in the size of the file, which is in memory once (of rosbags one chunk or message at a
/// time). Thread-safe. Nothing is written, nothing is fetched from a network.
Result<TrackFile> readTracks(const std::filesystem::path& path, const JobContext& job = {});

}  // namespace furrow
