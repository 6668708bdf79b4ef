#include "planner/core/separated_text.h"
#include "planner/io/content/export_job.h"
#include "planner/io/content/received_content.h"
#include "planner/io/files/byte_reader.h"
#include "planner/plan/plan.h"

#include "path_message.pb.h"

#include <sqlite3.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

namespace furrow {

namespace {

constexpr std::string_view kWholePath = "/coverage_path";

/// Yaw of a rotation about the vertical; nothing for anything else.
std::optional<double> yawOf(double z, double w) {
    return std::abs(std::hypot(z, w) - 1.0) < 1e-6 ? std::optional{2.0 * std::atan2(z, w)} : std::nullopt;
}

struct BagMessage {
    std::string topic;
    std::string_view cdr;
};

/// nav_msgs/msg/Path in little-endian CDR.
FoundPath pathOf(std::string_view cdr, bool whole, FoundContent& found) {
    FoundPath path{.samples = {}, .isWhole = whole};
    ByteReader encapsulation{cdr};
    const bool littleEndian = encapsulation.integer<std::uint8_t>() == 0 && encapsulation.integer<std::uint8_t>() == 1;
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
    if (!littleEndian || !reader.ok() || reader.left() != 0) {
        found.faults.push_back(cannotBeRead());
    }
    return path;
}

struct DatabaseCloser {
    void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct StatementCloser {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

std::vector<BagMessage> messagesOfDatabase(std::string& bytes, sqlite3* database, std::vector<std::string>& data) {
    const auto size = static_cast<sqlite3_int64>(bytes.size());
    sqlite3_stmt* made = nullptr;
    if (sqlite3_deserialize(database, "main", reinterpret_cast<unsigned char*>(bytes.data()), size, size,
                            SQLITE_DESERIALIZE_READONLY) == SQLITE_OK) {
        sqlite3_prepare_v2(database,
                           "SELECT name, data FROM messages JOIN topics ON topics.id = topic_id ORDER BY timestamp", -1,
                           &made, nullptr);
    }
    const std::unique_ptr<sqlite3_stmt, StatementCloser> rows{made};
    std::vector<std::string> topics;
    while (rows && sqlite3_step(rows.get()) == SQLITE_ROW) {
        const auto* name = reinterpret_cast<const char*>(sqlite3_column_text(rows.get(), 0));
        const auto* blob = static_cast<const char*>(sqlite3_column_blob(rows.get(), 1));
        topics.emplace_back(name == nullptr ? "" : name);
        data.emplace_back(blob == nullptr ? "" : blob, static_cast<std::size_t>(sqlite3_column_bytes(rows.get(), 1)));
    }
    std::vector<BagMessage> messages;
    for (std::size_t i = 0; i < topics.size(); ++i) {
        messages.push_back({topics[i], data[i]});
    }
    return messages;
}

// mcap.dev/spec: opcodes
constexpr std::uint8_t kChannel = 4;
constexpr std::uint8_t kMessage = 5;
constexpr std::uint8_t kChunk = 6;
constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

void messagesOfRecords(std::string_view records, std::vector<std::pair<std::uint16_t, std::string>>& channels,
                       std::vector<BagMessage>& messages) {
    ByteReader reader{records};
    while (reader.left() >= 9) {
        const auto opcode = reader.integer<std::uint8_t>();
        ByteReader body{reader.take(reader.integer<std::uint64_t>())};
        if (opcode == kChannel) {
            const auto id = body.integer<std::uint16_t>();
            body.skip(2);
            channels.emplace_back(id, body.take(body.integer<std::uint32_t>()));
        } else if (opcode == kMessage) {
            const auto id = body.integer<std::uint16_t>();
            body.skip(4 + 8 + 8);
            for (const auto& [channel, topic] : channels) {
                if (channel == id) {
                    messages.push_back({topic, body.take(body.left())});
                    break;
                }
            }
        } else if (opcode == kChunk) {
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
    const std::string_view rest = at == std::string_view::npos ? std::string_view{} : text.substr(at + name.size());
    return decimalIn(rest.substr(0, rest.find_first_of(",}"))).value_or(std::nan(""));
}

GeoPoint geoOf(const v1::Place& place) {
    return {place.lon_deg(), place.lat_deg()};
}

FoundArea areaOf(const v1::Polygon& polygon, FoundArea::Kind kind) {
    FoundArea area{.kind = kind, .name = polygon.name(), .rings = {}, .statedM2 = std::nullopt};
    for (const v1::Place& place : polygon.outer()) {
        area.rings.outer.push_back(geoOf(place));
    }
    for (const v1::Ring& ring : polygon.holes()) {
        GeoRing& hole = area.rings.holes.emplace_back();
        for (const v1::Place& place : ring.places()) {
            hole.push_back(geoOf(place));
        }
    }
    return area;
}

}  // namespace

std::vector<FoundContent> findRosbag(std::span<const ExportedFile> files, const ExportJob&) {
    std::vector<FoundContent> all;
    std::optional<double> announced;
    std::size_t count = 0;
    for (const ExportedFile& file : files) {
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
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path});
        std::string bytes = file.bytes;
        std::vector<std::string> data;
        std::vector<BagMessage> messages;
        sqlite3* opened = nullptr;
        if (isDatabase) {
            sqlite3_open(":memory:", &opened);
        }
        const std::unique_ptr<sqlite3, DatabaseCloser> database{opened};
        const bool framed = bytes.starts_with(kMcapMagic) && bytes.ends_with(kMcapMagic) && bytes.size() >= 16;
        if (isDatabase) {
            messages = messagesOfDatabase(bytes, opened, data);
        } else if (framed) {
            std::vector<std::pair<std::uint16_t, std::string>> channels;
            messagesOfRecords(std::string_view{bytes}.substr(8, bytes.size() - 16), channels, messages);
        }
        count = messages.size();
        if (messages.empty()) {
            found.faults.push_back(cannotBeRead());
        }
        for (const BagMessage& each : messages) {
            found.paths.push_back(pathOf(each.cdr, each.topic == kWholePath, found));
        }
    }
    if (!all.empty() && announced != static_cast<double>(count)) {
        all.front().faults.push_back(badCount(static_cast<std::size_t>(announced.value_or(0.0)), count));
    }
    return all;
}

std::vector<FoundContent> findNavPathYaml(std::span<const ExportedFile> files, const ExportJob&) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        if (!file.path.ends_with("nav_msgs_path.yaml")) {
            continue;
        }
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path});
        FoundPath path;
        std::string_view text = file.bytes;
        found.namesCrs = text.contains("frame_id: map");
        for (std::size_t number = 1; !text.empty(); ++number) {
            const std::string_view line = nextLine(text);
            if (line.starts_with("- header:")) {
                path.samples.push_back(
                    {.isLocal = true, .timeS = numberAfter(line, "sec: ") + 1e-9 * numberAfter(line, "nanosec: ")});
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

std::vector<FoundContent> findCoverageGoal(std::span<const ExportedFile> files, const ExportJob& job) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        if (!file.path.ends_with("goal.yaml") || job.plan == nullptr) {
            continue;
        }
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path});
        FoundArea area{.name = job.plan->field().name(), .rings = {}, .statedM2 = std::nullopt};
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

std::vector<FoundContent> findPathMessage(std::span<const ExportedFile> files, const ExportJob&) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path, .repeatsFirst = false});
        v1::PathMessage message;
        if (!message.ParseFromString(file.bytes)) {
            found.faults.push_back(cannotBeRead());
            continue;
        }
        found.namesCrs = message.frame().proj().starts_with("+proj=");
        for (const v1::Polygon& polygon : message.fence()) {
            found.areas.push_back(areaOf(polygon, FoundArea::Kind::Field));
        }
        for (const v1::Polygon& polygon : message.keep_out()) {
            found.areas.push_back(areaOf(polygon, FoundArea::Kind::Obstacle));
        }
        FoundPath path{.samples = {}, .knowsGear = true};
        for (const v1::Segment& segment : message.segments()) {
            for (const v1::Sample& sample : segment.samples()) {
                path.samples.push_back({.geo = geoOf(sample.place()),
                                        .timeS = sample.time_s(),
                                        .headingRad = sample.heading_rad(),
                                        .speedMps = sample.speed_mps(),
                                        .reverse = segment.reverse()});
            }
        }
        found.paths.push_back(std::move(path));
    }
    return all;
}

}  // namespace furrow
