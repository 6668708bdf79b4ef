#include "planner/io/files/byte_writer.h"
#include "planner/io/files/checksum.h"
#include "planner/io/formats/ros/mcap_records.h"
#include "planner/io/formats/ros/nav_path.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace furrow {

namespace {

constexpr std::uint16_t kSchemaId = 1;

/// From 1: there are readers that take a channel 0 for none.
std::uint16_t channelId(std::size_t topic) {
    return static_cast<std::uint16_t>(topic + 1);
}

// The messages that nav_msgs/msg/Path is made of, as ROS 2 defines them.
constexpr const char* kDefinition =
    R"(std_msgs/Header header
geometry_msgs/PoseStamped[] poses
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
================================================================================
MSG: geometry_msgs/PoseStamped
std_msgs/Header header
geometry_msgs/Pose pose
================================================================================
MSG: geometry_msgs/Pose
geometry_msgs/Point position
geometry_msgs/Quaternion orientation
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
================================================================================
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
)";

void addText(ByteWriter& out, std::string_view text) {
    out.integer(static_cast<std::uint32_t>(text.size()));
    out.bytes(text);
}

std::string record(mcap::Opcode opcode, ByteWriter&& body) {
    const std::string bytes = std::move(body).take();
    ByteWriter out;
    out.integer(static_cast<std::uint8_t>(opcode));
    out.integer(static_cast<std::uint64_t>(bytes.size()));
    out.bytes(bytes);
    return std::move(out).take();
}

std::string schemaRecord() {
    ByteWriter body;
    body.integer(kSchemaId);
    addText(body, "nav_msgs/msg/Path");
    addText(body, "ros2msg");
    addText(body, kDefinition);
    return record(mcap::kSchema, std::move(body));
}

std::string channelRecords(const std::vector<NavTopic>& topics) {
    std::string all;
    for (std::size_t i = 0; i < topics.size(); ++i) {
        ByteWriter body;
        body.integer(channelId(i));
        body.integer(kSchemaId);
        addText(body, topics[i].name);
        addText(body, "cdr");
        body.integer(std::uint32_t{0});  // no metadata
        all += record(mcap::kChannel, std::move(body));
    }
    return all;
}

std::string messageRecord(std::size_t channel, std::uint32_t sequence, const NavPath& path) {
    ByteWriter body;
    body.integer(channelId(channel));
    body.integer(sequence);
    const auto stamp = static_cast<std::uint64_t>(path.recordedNs());
    body.integer(stamp);  // logged
    body.integer(stamp);  // published
    body.bytes(cdrOf(path));
    return record(mcap::kMessage, std::move(body));
}

/// The messages in one chunk, and where they begin in it.
struct MessageChunk {
    std::string records;
    std::uint64_t first = ~std::uint64_t{0};  ///< the earliest time
    std::uint64_t last = 0;
    /// For each channel the times of its messages and their places.
    std::vector<std::vector<std::pair<std::uint64_t, std::uint64_t>>> places;
};

MessageChunk chunkOf(const std::vector<NavTopic>& topics) {
    MessageChunk chunk{.records = schemaRecord() + channelRecords(topics), .places = {}};
    chunk.places.resize(topics.size());
    for (std::size_t channel = 0; channel < topics.size(); ++channel) {
        for (std::size_t i = 0; i < topics[channel].messages.size(); ++i) {
            const NavPath& path = *topics[channel].messages[i];
            const auto stamp = static_cast<std::uint64_t>(path.recordedNs());
            chunk.first = std::min(chunk.first, stamp);
            chunk.last = std::max(chunk.last, stamp);
            chunk.places[channel].emplace_back(stamp, chunk.records.size());
            chunk.records += messageRecord(channel, static_cast<std::uint32_t>(i), path);
        }
    }
    return chunk;
}

std::string headerRecord() {
    ByteWriter header;
    addText(header, "ros2");
    addText(header, "furrow");
    return record(mcap::kHeader, std::move(header));
}

std::string chunkRecord(const MessageChunk& chunk) {
    ByteWriter body;
    body.integer(chunk.first);
    body.integer(chunk.last);
    body.integer(static_cast<std::uint64_t>(chunk.records.size()));
    body.integer(crc32Of(chunk.records));
    addText(body, "");  // not compressed
    body.integer(static_cast<std::uint64_t>(chunk.records.size()));
    body.bytes(chunk.records);
    return record(mcap::kChunk, std::move(body));
}

std::string messageIndexRecord(const MessageChunk& chunk, std::size_t channel) {
    ByteWriter index;
    index.integer(channelId(channel));
    index.integer(static_cast<std::uint32_t>(chunk.places[channel].size() * 16));
    for (const auto& [stamp, offset] : chunk.places[channel]) {
        index.integer(stamp);
        index.integer(offset);
    }
    return record(mcap::kMessageIndex, std::move(index));
}

std::string dataEndRecord() {
    ByteWriter body;
    body.integer(std::uint32_t{0});  // checksum not given
    return record(mcap::kDataEnd, std::move(body));
}

std::string statisticsRecord(const MessageChunk& chunk, std::size_t messages) {
    ByteWriter statistics;
    statistics.integer(static_cast<std::uint64_t>(messages));
    statistics.integer(std::uint16_t{1});  // schemas
    statistics.integer(static_cast<std::uint32_t>(chunk.places.size()));
    statistics.integer(std::uint32_t{0});  // attachments
    statistics.integer(std::uint32_t{0});  // metadata
    statistics.integer(std::uint32_t{1});  // chunks
    statistics.integer(chunk.first);
    statistics.integer(chunk.last);
    statistics.integer(static_cast<std::uint32_t>(chunk.places.size() * 10));
    for (std::size_t channel = 0; channel < chunk.places.size(); ++channel) {
        statistics.integer(channelId(channel));
        statistics.integer(static_cast<std::uint64_t>(chunk.places[channel].size()));
    }
    return record(mcap::kStatistics, std::move(statistics));
}

/// Where the chunk and the indexes of its channels lie in the file.
struct ChunkPlace {
    std::uint64_t start = 0;
    std::uint64_t length = 0;
    std::vector<std::uint64_t> indexes;
    std::uint64_t indexLength = 0;
};

std::string chunkIndexRecord(const MessageChunk& chunk, const ChunkPlace& place) {
    ByteWriter index;
    index.integer(chunk.first);
    index.integer(chunk.last);
    index.integer(place.start);
    index.integer(place.length);
    index.integer(static_cast<std::uint32_t>(place.indexes.size() * 10));
    for (std::size_t channel = 0; channel < place.indexes.size(); ++channel) {
        index.integer(channelId(channel));
        index.integer(place.indexes[channel]);
    }
    index.integer(place.indexLength);
    addText(index, "");
    index.integer(static_cast<std::uint64_t>(chunk.records.size()));
    index.integer(static_cast<std::uint64_t>(chunk.records.size()));
    return record(mcap::kChunkIndex, std::move(index));
}

std::string footerRecord(std::uint64_t summaryStart) {
    ByteWriter footer;
    footer.integer(summaryStart);
    footer.integer(std::uint64_t{0});  // no summary offsets
    footer.integer(std::uint32_t{0});  // checksum not given
    return record(mcap::kFooter, std::move(footer));
}

}  // namespace

std::string mcapOf(const std::vector<NavPath>& paths) {
    const std::vector<NavTopic> topics = topicsOf(paths);
    const MessageChunk chunk = chunkOf(topics);
    std::string file = std::string{kMcapMagic} + headerRecord();
    ChunkPlace place{.start = file.size(), .indexes = {}};
    file += chunkRecord(chunk);
    place.length = file.size() - place.start;
    const std::uint64_t indexStart = file.size();
    for (std::size_t channel = 0; channel < topics.size(); ++channel) {
        place.indexes.push_back(file.size());
        file += messageIndexRecord(chunk, channel);
    }
    place.indexLength = file.size() - indexStart;
    file += dataEndRecord();
    const std::uint64_t summaryStart = file.size();
    file += schemaRecord() + channelRecords(topics);
    file += statisticsRecord(chunk, paths.size());
    file += chunkIndexRecord(chunk, place);
    return file + footerRecord(summaryStart) + std::string{kMcapMagic};
}

}  // namespace furrow
