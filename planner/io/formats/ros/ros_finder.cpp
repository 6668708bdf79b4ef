#include "planner/io/formats/ros/ros.h"

#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/io/files/byte_reader.h"
#include "planner/io/files/sqlite.h"
#include "planner/plan/plan.h"

#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace furrow {

namespace {

constexpr std::string_view kWholePath = "/coverage_path";

/// Yaw of a rotation about the vertical; nothing for anything else.
std::optional<double> yawOf(double z, double w) {
    return std::abs(std::hypot(z, w) - 1.0) < 1e-6 ? std::optional{2.0 * std::atan2(z, w)} : std::nullopt;
}

/// nav_msgs/msg/Path with its topic.
struct PathMessage {
    std::string topic;
    std::string_view cdr;
};

/// nav_msgs/msg/Path in little-endian CDR.
ReceivedPath pathOf(std::string_view cdr, bool whole, ReceivedContent& found) {
    ReceivedPath path{.samples = {}, .isWhole = whole};
    ByteReader encapsulation{cdr};
    const bool littleEndian =
        encapsulation.integer<std::uint8_t>() == 0 && encapsulation.integer<std::uint8_t>() == 1;
    ByteReader reader{cdr.substr(std::min<std::size_t>(4, cdr.size()))};
    const auto header = [&reader, &found] {
        reader.align(4);
        const auto seconds = reader.integer<std::int32_t>();
        const auto nanoseconds = reader.integer<std::uint32_t>();
        const std::string_view frame = reader.take(reader.integer<std::uint32_t>());
        found.namesCrs = found.namesCrs.value_or(true) && frame == std::string_view{"map\0", 4};
        return static_cast<double>(seconds) + 1e-9 * static_cast<double>(nanoseconds);
    };
    header();
    reader.align(4);
    const auto count = reader.integer<std::uint32_t>();
    for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
        const double time = header();
        reader.align(8);
        double values[7] = {};
        for (double& value : values) {
            value = reader.real();
        }
        const auto yaw = yawOf(values[5], values[6]);
        if (!yaw || values[3] != 0.0 || values[4] != 0.0) {
            found.faults.push_back(badLine(i + 1));
            break;
        }
        path.samples.push_back(
            {.local = {values[0], values[1]}, .isLocal = true, .timeS = time, .headingRad = yaw});
    }
    if (!littleEndian || !reader.ok() || reader.bytesLeft() != 0) {
        found.faults.push_back(cannotBeRead());
    }
    return path;
}

/// Of a database in memory; `kept` holds their bytes.
std::vector<PathMessage> messagesOfDatabase(std::string& bytes, std::vector<std::string>& kept) {
    const SqliteDatabase database = databaseIn(bytes);
    const SqliteStatement rows =
        prepared(database.get(),
                 "SELECT name, data FROM messages JOIN topics ON topics.id = topic_id ORDER BY timestamp");
    std::vector<std::string> topics;
    while (rows && sqlite3_step(rows.get()) == SQLITE_ROW) {
        topics.emplace_back(textAt(rows.get(), 0));
        kept.emplace_back(bytesAt(rows.get(), 1));
    }
    std::vector<PathMessage> messages;
    for (std::size_t i = 0; i < topics.size(); ++i) {
        messages.push_back({topics[i], kept[i]});
    }
    return messages;
}

// mcap.dev/spec: opcodes
constexpr std::uint8_t kChannelOpcode = 4;
constexpr std::uint8_t kMessageOpcode = 5;
constexpr std::uint8_t kChunkOpcode = 6;
constexpr std::string_view kMagicBytes{"\x89MCAP0\r\n", 8};

void messagesOfRecords(std::string_view records, std::vector<std::pair<std::uint16_t, std::string>>& channels,
                       std::vector<PathMessage>& messages) {
    ByteReader reader{records};
    while (reader.bytesLeft() >= 9) {
        const auto opcode = reader.integer<std::uint8_t>();
        ByteReader body{reader.take(reader.integer<std::uint64_t>())};
        if (opcode == kChannelOpcode) {
            const auto id = body.integer<std::uint16_t>();
            body.skip(2);
            channels.emplace_back(id, body.take(body.integer<std::uint32_t>()));
        } else if (opcode == kMessageOpcode) {
            const auto id = body.integer<std::uint16_t>();
            body.skip(4 + 8 + 8);
            for (const auto& [channel, topic] : channels) {
                if (channel == id) {
                    messages.push_back({topic, body.take(body.bytesLeft())});
                    break;
                }
            }
        } else if (opcode == kChunkOpcode) {
            body.skip(8 + 8 + 8 + 4);
            const bool plain = body.integer<std::uint32_t>() == 0;  // no compression
            const std::string_view inner = body.take(body.integer<std::uint64_t>());
            if (plain) {
                messagesOfRecords(inner, channels, messages);
            }
        }
    }
}

double numberAfter(std::string_view text, std::string_view name) {
    const std::size_t at = text.find(name);
    const std::string_view rest =
        at == std::string_view::npos ? std::string_view{} : text.substr(at + name.size());
    return decimalIn(rest.substr(0, rest.find_first_of(",}"))).value_or(std::nan(""));
}

}  // namespace

std::vector<ReceivedContent> findRosbag(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    std::optional<double> announced;
    std::size_t count = 0;
    for (const FileInMemory& file : files) {
        if (file.path.ends_with("metadata.yaml")) {
            for (std::string_view text = file.bytes; !text.empty() && !announced;) {
                const std::string_view line = nextLine(text);
                constexpr std::string_view kCount = "  message_count: ";
                announced = line.starts_with(kCount) ? decimalIn(line.substr(kCount.size())) : announced;
            }
        }
        const bool isDatabase = file.path.ends_with(".db3");
        if (!isDatabase && !file.path.ends_with(".mcap")) {
            continue;
        }
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path});
        std::string bytes = file.bytes;
        std::vector<std::string> data;
        std::vector<PathMessage> messages;
        const bool framed =
            bytes.starts_with(kMagicBytes) && bytes.ends_with(kMagicBytes) && bytes.size() >= 16;
        if (isDatabase) {
            messages = messagesOfDatabase(bytes, data);
        } else if (framed) {
            std::vector<std::pair<std::uint16_t, std::string>> channels;
            messagesOfRecords(std::string_view{bytes}.substr(8, bytes.size() - 16), channels, messages);
        }
        count = messages.size();
        if (messages.empty()) {
            found.faults.push_back(cannotBeRead());
        }
        for (const PathMessage& each : messages) {
            found.paths.push_back(pathOf(each.cdr, each.topic == kWholePath, found));
        }
    }
    if (!all.empty() && announced != static_cast<double>(count)) {
        all.front().faults.push_back(badCount(static_cast<std::size_t>(announced.value_or(0.0)), count));
    }
    return all;
}

std::vector<ReceivedContent> findNavPathYaml(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        if (!file.path.ends_with("nav_msgs_path.yaml")) {
            continue;
        }
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path});
        ReceivedPath path;
        std::string_view text = file.bytes;
        found.namesCrs = text.contains("frame_id: map");
        for (std::size_t number = 1; !text.empty(); ++number) {
            const std::string_view line = nextLine(text);
            if (line.starts_with("- header:")) {
                path.samples.push_back(
                    {.isLocal = true,
                     .timeS = numberAfter(line, "sec: ") + 1e-9 * numberAfter(line, "nanosec: ")});
            } else if (line.starts_with("    position:") && !path.samples.empty()) {
                path.samples.back().local = {numberAfter(line, "x: "), numberAfter(line, "y: ")};
            } else if (line.starts_with("    orientation:") && !path.samples.empty()) {
                path.samples.back().headingRad = yawOf(numberAfter(line, "z: "), numberAfter(line, "w: "));
                if (!path.samples.back().headingRad) {
                    found.faults.push_back(badLine(number));
                    break;
                }
            }
        }
        found.paths.push_back(std::move(path));
    }
    return all;
}

std::vector<ReceivedContent> findCoverageGoal(std::span<const FileInMemory> files, const ExportJob& job) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        if (!file.path.ends_with("goal.yaml") || job.plan == nullptr) {
            continue;
        }
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path});
        ReceivedArea area{.name = job.plan->field().name(), .rings = {}, .statedM2 = std::nullopt};
        std::string_view text = file.bytes;
        found.namesCrs = text.contains("frame_id: map");
        int rings = 0;
        while (!text.empty()) {
            const std::string_view line = nextLine(text);
            if (line.starts_with("- coordinates:")) {
                ++rings;
                if (rings > 1) {
                    area.rings.holes.emplace_back();
                }
            } else if (line.starts_with("  - {axis1:") && rings > 0) {
                GeoRing& ring = rings == 1 ? area.rings.outer : area.rings.holes.back();
                ring.push_back(job.plan->field().frame().toGeo(
                    Point{numberAfter(line, "axis1: "), numberAfter(line, "axis2: ")}));
            }
        }
        const double width = numberAfter(file.bytes, "mode: CONSTANT, width: ");
        if (!(std::abs(width - job.plan->headland.width.si()) < 1e-3)) {
            found.faults.push_back(message("'{}' is said to be {:.3f} m wide", "headland_mode", width));
        }
        found.areas.push_back(std::move(area));
    }
    return all;
}

}  // namespace furrow
