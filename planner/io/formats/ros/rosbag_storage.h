#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace furrow {

/// One message of a rosbag2, as it lies in its storage.
struct BagMessage {
    std::string_view topic;
    std::string_view type;        ///< "sensor_msgs/msg/NavSatFix"
    std::int64_t recordedNs = 0;  ///< since 1970
    std::string_view data;        ///< CDR with its four bytes of encapsulation
};

/// Calls `visit` for every CDR message of a file in the order of the file, until it answers an error, which
/// is passed on. A file that starts like MCAP is read as that (chunks plain, lz4 or zstd), any other as
/// sqlite3; neither is written to.
///
/// @param wants  whether messages of a type are of interest; the others are passed over unread
/// @return ReadFailed: not there, damaged, cut off. InputRefused: a chunk or message above 256 MiB, an
///         unknown compression. Cancelled.
Result<void> visitBag(const std::filesystem::path& file, const std::function<bool(std::string_view)>& wants,
                      const std::function<Result<void>(const BagMessage&)>& visit, const JobContext& job);

}  // namespace furrow
