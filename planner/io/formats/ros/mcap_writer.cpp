#include "planner/io/files/byte_writer.h"
#include "planner/io/files/checksum.h"
#include "planner/io/formats/ros/nav_path.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace furrow {

namespace {

constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};
constexpr std::uint16_t kSchemaId = 1;

/// From 1: there are readers that take a channel 0 for none.
std::uint16_t channelId(std::size_t topic) {
    return static_cast<std::uint16_t>(topic + 1);
}

enum Opcode : std::uint8_t {
    kHeader = 1,
    kFooter = 2,
    kSchema = 3,
    kChannel = 4,
    kMessage = 5,
    kChunk = 6,
    kMessageIndex = 7,
    kChunkIndex = 8,
    kStatistics = 11,
    kDataEnd = 15,
};

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

std::string record(Opcode opcode, ByteWriter&& body) {
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
    return record(kSchema, std::move(body));
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
        all += record(kChannel, std::move(body));
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
    return record(kMessage, std::move(body));
}

}  // namespace

std::string mcapOf(const std::vector<NavPath>& paths) {
    const std::vector<NavTopic> topics = topicsOf(paths);
    std::string records = schemaRecord() + channelRecords(topics);
    // For each channel the times of its messages and where they begin in the chunk.
    std::vector<std::vector<std::pair<std::uint64_t, std::uint64_t>>> places(topics.size());
    std::uint64_t first = ~std::uint64_t{0};
    std::uint64_t last = 0;
    for (std::size_t channel = 0; channel < topics.size(); ++channel) {
        for (std::size_t i = 0; i < topics[channel].messages.size(); ++i) {
            const NavPath& path = *topics[channel].messages[i];
            const auto stamp = static_cast<std::uint64_t>(path.recordedNs());
            first = std::min(first, stamp);
            last = std::max(last, stamp);
            places[channel].emplace_back(stamp, records.size());
            records += messageRecord(channel, static_cast<std::uint32_t>(i), path);
        }
    }

    ByteWriter header;
    addText(header, "ros2");
    addText(header, "furrow");
    std::string file = std::string{kMagic} + record(kHeader, std::move(header));

    const std::uint64_t chunkStart = file.size();
    ByteWriter chunk;
    chunk.integer(first);
    chunk.integer(last);
    chunk.integer(static_cast<std::uint64_t>(records.size()));
    chunk.integer(crc32Of(records));
    addText(chunk, "");  // not compressed
    chunk.integer(static_cast<std::uint64_t>(records.size()));
    chunk.bytes(records);
    file += record(kChunk, std::move(chunk));
    const std::uint64_t chunkLength = file.size() - chunkStart;

    std::vector<std::uint64_t> indexOffsets;
    const std::uint64_t indexStart = file.size();
    for (std::size_t channel = 0; channel < topics.size(); ++channel) {
        indexOffsets.push_back(file.size());
        ByteWriter index;
        index.integer(channelId(channel));
        index.integer(static_cast<std::uint32_t>(places[channel].size() * 16));
        for (const auto& [stamp, offset] : places[channel]) {
            index.integer(stamp);
            index.integer(offset);
        }
        file += record(kMessageIndex, std::move(index));
    }
    const std::uint64_t indexLength = file.size() - indexStart;

    ByteWriter dataEnd;
    dataEnd.integer(std::uint32_t{0});  // checksum not given
    file += record(kDataEnd, std::move(dataEnd));

    const std::uint64_t summaryStart = file.size();
    file += schemaRecord() + channelRecords(topics);
    ByteWriter statistics;
    statistics.integer(static_cast<std::uint64_t>(paths.size()));
    statistics.integer(std::uint16_t{1});  // schemas
    statistics.integer(static_cast<std::uint32_t>(topics.size()));
    statistics.integer(std::uint32_t{0});  // attachments
    statistics.integer(std::uint32_t{0});  // metadata
    statistics.integer(std::uint32_t{1});  // chunks
    statistics.integer(first);
    statistics.integer(last);
    statistics.integer(static_cast<std::uint32_t>(topics.size() * 10));
    for (std::size_t channel = 0; channel < topics.size(); ++channel) {
        statistics.integer(channelId(channel));
        statistics.integer(static_cast<std::uint64_t>(places[channel].size()));
    }
    file += record(kStatistics, std::move(statistics));
    ByteWriter chunkIndex;
    chunkIndex.integer(first);
    chunkIndex.integer(last);
    chunkIndex.integer(chunkStart);
    chunkIndex.integer(chunkLength);
    chunkIndex.integer(static_cast<std::uint32_t>(topics.size() * 10));
    for (std::size_t channel = 0; channel < topics.size(); ++channel) {
        chunkIndex.integer(channelId(channel));
        chunkIndex.integer(indexOffsets[channel]);
    }
    chunkIndex.integer(indexLength);
    addText(chunkIndex, "");
    chunkIndex.integer(static_cast<std::uint64_t>(records.size()));
    chunkIndex.integer(static_cast<std::uint64_t>(records.size()));
    file += record(kChunkIndex, std::move(chunkIndex));

    ByteWriter footer;
    footer.integer(summaryStart);
    footer.integer(std::uint64_t{0});  // no summary offsets
    footer.integer(std::uint32_t{0});  // checksum not given
    return file + record(kFooter, std::move(footer)) + std::string{kMagic};
}

}  // namespace furrow
