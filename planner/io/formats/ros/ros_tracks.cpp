#include "planner/io/content/geo_ring.h"
#include "planner/io/formats/ros/ros.h"

#include "planner/core/text.h"
#include "planner/io/files/byte_reader.h"
#include "planner/io/formats/ros/rosbag_storage.h"
#include "planner/io/tracks/track_parts.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <map>

namespace furrow {

namespace {

namespace fs = std::filesystem;

struct Topic;

/// Reads one message behind its encapsulation. False where it is cut off.
using Decode = bool (*)(ByteReader& bytes, double recordedS, Topic& topic);

struct Topic {
    std::string name;
    std::size_t rank = 0;  ///< of its type in kTypes
    std::vector<TrackSample> samples;
    std::size_t withoutPlace = 0;
};

void add(Topic& topic, const TrackSample& sample, bool isPlace) {
    if (isPlace) {
        topic.samples.push_back(sample);
    } else {
        ++topic.withoutPlace;
    }
}

/// std_msgs/Header: the stamp of the message, or the time of recording where that is zero.
double readHeader(ByteReader& bytes, double recordedS) {
    bytes.align(4);
    const auto seconds = bytes.integer<std::int32_t>();
    const auto nanoseconds = bytes.integer<std::uint32_t>();
    bytes.skip(bytes.integer<std::uint32_t>());  // frame_id
    return seconds == 0 && nanoseconds == 0 ? recordedS : seconds + 1e-9 * nanoseconds;
}

constexpr double kFarthestLocalM = 1e6;

bool isLocalPlace(const Point& point) {
    return std::abs(point.x) <= kFarthestLocalM && std::abs(point.y) <= kFarthestLocalM;
}

/// geometry_msgs/Pose: position, then a quaternion, of which the yaw is kept.
TrackSample readPose(ByteReader& bytes, double timeS) {
    bytes.align(8);
    TrackSample sample{.timeS = timeS};
    sample.local.x = bytes.real();
    sample.local.y = bytes.real();
    bytes.skip(8);
    const double x = bytes.real();
    const double y = bytes.real();
    const double z = bytes.real();
    const double w = bytes.real();
    const double size = x * x + y * y + z * z + w * w;
    if (size > 0.5 && size < 2.0) {
        const double yaw = std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
        sample.headingRad = normalisedPoseHeading(radians(yaw)).si();
    }
    return sample;
}

bool decodeNavSatFix(ByteReader& bytes, double recordedS, Topic& topic) {
    const double timeS = readHeader(bytes, recordedS);
    const auto status = bytes.integer<std::int8_t>();
    bytes.align(2);
    bytes.skip(2);  // service
    bytes.align(8);
    const double lat = bytes.real();
    const double lon = bytes.real();
    constexpr int kNoFix = -1;
    add(topic, {.geo = {.lonDeg = lon, .latDeg = lat}, .timeS = timeS},
        status != kNoFix && isOnEarth({lon, lat}));
    return bytes.ok();
}

bool decodeOdometry(ByteReader& bytes, double recordedS, Topic& topic) {
    const double timeS = readHeader(bytes, recordedS);
    bytes.align(4);
    bytes.skip(bytes.integer<std::uint32_t>());  // child_frame_id
    TrackSample sample = readPose(bytes, timeS);
    bytes.skip(36 * sizeof(double));  // covariance
    const double vx = bytes.real();
    const double vy = bytes.real();
    const double speed = std::hypot(vx, vy);
    if (std::isfinite(speed)) {
        sample.speedMps = speed;
    }
    add(topic, sample, isLocalPlace(sample.local));
    return bytes.ok();
}

bool decodePoseStamped(ByteReader& bytes, double recordedS, Topic& topic) {
    const double timeS = readHeader(bytes, recordedS);
    const TrackSample sample = readPose(bytes, timeS);
    add(topic, sample, isLocalPlace(sample.local));
    return bytes.ok();
}

/// A path is sent again and again while it grows: the longest one is the track.
bool decodePath(ByteReader& bytes, double recordedS, Topic& topic) {
    readHeader(bytes, recordedS);
    bytes.align(4);
    const auto count = bytes.integer<std::uint32_t>();
    Topic path;
    for (std::uint32_t i = 0; i < count && bytes.ok(); ++i) {
        decodePoseStamped(bytes, recordedS, path);
    }
    if (!bytes.ok()) {
        return false;
    }
    const bool timed = std::ranges::any_of(path.samples, [&path](const TrackSample& sample) {
        return sample.timeS != path.samples.front().timeS;
    });
    for (TrackSample& sample : path.samples) {
        sample.timeS = timed ? sample.timeS : std::nullopt;  // a plan's path is stamped once
    }
    if (path.samples.size() >= topic.samples.size()) {
        topic.samples = std::move(path.samples);
        topic.withoutPlace = path.withoutPlace;
    }
    return true;
}

struct Type {
    std::string_view name;
    TrackPlaces places;
    Decode decode;
};

// Longitude and latitude before local places, what was driven before what may have been planned.
constexpr Type kTypes[] = {
    {"sensor_msgs/msg/NavSatFix", TrackPlaces::Wgs84, decodeNavSatFix},
    {"nav_msgs/msg/Odometry", TrackPlaces::Local, decodeOdometry},
    {"geometry_msgs/msg/PoseStamped", TrackPlaces::Local, decodePoseStamped},
    {"nav_msgs/msg/Path", TrackPlaces::Local, decodePath},
};

std::optional<std::size_t> rankOf(std::string_view type) {
    const auto found = std::ranges::find(kTypes, type, &Type::name);
    return found == std::ranges::end(kTypes)
               ? std::nullopt
               : std::optional{static_cast<std::size_t>(found - std::ranges::begin(kTypes))};
}

class BagTracks {
public:
    explicit BagTracks(const std::string& where) : where_{where} {}

    Result<void> add(const BagMessage& sent) {
        const std::size_t rank = rankOf(sent.type).value_or(0);
        Topic& topic = topics_[std::string{sent.topic}];
        topic.name = sent.topic;
        topic.rank = rank;
        const auto order = orderOf(sent.data);
        if (!order) {
            return std::unexpected(
                trackDamaged(message("{}, {}", where_, sent.topic), "a message is not plain CDR"));
        }
        ByteReader bytes{sent.data.substr(4), *order};
        if (!kTypes[rank].decode(bytes, 1e-9 * static_cast<double>(sent.recordedNs), topic)) {
            return std::unexpected(
                trackDamaged(message("{}, {}", where_, sent.topic), "a message is cut off"));
        }
        return topic.samples.size() > kMostTrackSamples ? std::unexpected(tooManySamples(where_))
                                                        : Result<void>{};
    }

    Result<TrackFile> finished() {
        Topic* best = nullptr;
        for (auto& [name, topic] : topics_) {
            if (!topic.samples.empty() &&
                (best == nullptr || topic.rank < best->rank ||
                 (topic.rank == best->rank && topic.samples.size() > best->samples.size()))) {
                best = &topic;
            }
        }
        if (best == nullptr) {
            return std::unexpected(trackRefused(where_, "no topic of this bag has a position",
                                                "record sensor_msgs/NavSatFix, nav_msgs/Odometry, "
                                                "geometry_msgs/PoseStamped or nav_msgs/Path"));
        }
        TrackFile file{.format = "rosbag2", .tracks = {}, .notes = {}};
        for (const auto& [name, topic] : topics_) {
            if (&topic != best) {
                file.notes.push_back(
                    {.text = message("topic {} was left out for {}", name, best->name), .where = where_});
            }
        }
        noteSkipped(file, best->withoutPlace,
                    counted("{} message without a position was passed over",
                            "{} messages without a position were passed over", best->withoutPlace),
                    where_);
        file.tracks.push_back(
            {.source = best->name, .places = kTypes[best->rank].places, .samples = std::move(best->samples)});
        return file;
    }

private:
    /// CDR says in its second byte which end comes first.
    static std::optional<std::endian> orderOf(std::string_view data) {
        if (data.size() < 4 || data[0] != 0 || data[1] < 0 || data[1] > 1) {
            return std::nullopt;
        }
        return data[1] == 1 ? std::endian::little : std::endian::big;
    }

    const std::string& where_;
    std::map<std::string, Topic> topics_;
};

constexpr std::string_view kMcapStart = "\x89MCAP";
constexpr std::string_view kSqliteMagic = "SQLite format 3";
constexpr std::string_view kRos1Magic = "#ROSBAG V";

bool isBagFile(const fs::path& path) {
    const std::string extension = extensionInSmallLetters(path);
    return extension == ".db3" || extension == ".mcap";
}

/// A later piece of a bag has a larger number at its end: x_2.db3 before x_10.db3.
std::vector<fs::path> bagFilesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::directory_iterator it{folder, failed}, end; !failed && it != end; it.increment(failed)) {
        if (isBagFile(it->path()) && it->is_regular_file(failed)) {
            files.push_back(it->path());
        }
    }
    std::ranges::sort(files, {}, [](const fs::path& file) {
        const std::string name = file.filename().string();
        return std::pair{name.size(), name};
    });
    return files;
}

}  // namespace

Result<TrackFile> rosbagTracks(const std::vector<std::filesystem::path>& files, const std::string& where,
                               const JobContext& job) {
    BagTracks tracks{where};
    for (const std::filesystem::path& file : files) {
        const auto visited = visitBag(
            file, [](std::string_view type) { return rankOf(type).has_value(); },
            [&tracks](const BagMessage& message) { return tracks.add(message); }, job);
        if (!visited) {
            return std::unexpected(visited.error());
        }
    }
    return tracks.finished();
}

Recognition recogniseRosbag(const ChosenFile& chosen) {
    if (chosen.isDirectory()) {
        return bagFilesIn(chosen.path()).empty() ? Recognition::No : Recognition::Certain;
    }
    const bool known =
        chosen.start() &&
        (chosen.start()->starts_with(kMcapStart) || chosen.start()->starts_with(kSqliteMagic) ||
         chosen.start()->starts_with(kRos1Magic) || isBagFile(chosen.path()));
    return known ? Recognition::Certain : Recognition::No;
}

Result<TrackFile> readRosbag(const ChosenFile& chosen, const JobContext& job) {
    const std::string where = chosen.path().string();
    if (chosen.isDirectory()) {
        return rosbagTracks(bagFilesIn(chosen.path()), where, job);
    }
    if (chosen.start()->starts_with(kRos1Magic) && !isBagFile(chosen.path())) {
        return std::unexpected(
            trackRefused(where, "this is a bag of ROS 1", "turn it into a rosbag2 with rosbags-convert"));
    }
    return rosbagTracks({chosen.path()}, where, job);
}

}  // namespace furrow
