#include "planner/core/text.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/formats/isoxml/isoxml.h"

#include "planner/io/files/byte_reader.h"
#include "planner/io/tracks/track_parts.h"

#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <format>
#include <map>
#include <string>
#include <vector>

namespace furrow {

namespace {

// ISO 11783-10, annex D: a time log is TLGnnnnn.xml, a single TIM element that describes the records, and
// TLGnnnnn.bin with the records one after the other, little endian. An attribute that is there and empty
// stands in every record, one with a value holds for all of them, one that is missing is not known.

constexpr double kDayS = 86'400.0;
constexpr double kDegreesPerUnit = 1e-7;
constexpr std::uint16_t kActualWorkState = 141;
constexpr std::uint16_t kActualCondensedWorkState = 161;  // to 176, sixteen sections each
constexpr std::uint16_t kLastCondensedWorkState = 176;
constexpr std::uint16_t kActualSpeed = 397;  // mm/s

enum class Field { None, Time, North, East, Status, GpsTime, GpsDate };

struct Column {
    Field field = Field::None;
    std::size_t bytes = 0;
};

struct Attribute {
    const char* name;
    Column column;
};

// In the order of the records.
constexpr Attribute kStamp[] = {
    {"A", {Field::Time, 6}}, {"B", {Field::None, 6}}, {"C", {Field::None, 4}}, {"D", {Field::None, 1}}};
constexpr Attribute kPosition[] = {
    {"A", {Field::North, 4}},  {"B", {Field::East, 4}},    {"C", {Field::None, 4}},
    {"D", {Field::Status, 1}}, {"E", {Field::None, 2}},    {"F", {Field::None, 2}},
    {"G", {Field::None, 1}},   {"H", {Field::GpsTime, 4}}, {"I", {Field::GpsDate, 2}}};

struct LogHeader {
    std::vector<Column> columns;
    std::vector<std::uint16_t> values;  ///< DDI of each DLV

    bool hasPlaces() const {
        return std::ranges::contains(columns, Field::North, &Column::field) &&
               std::ranges::contains(columns, Field::East, &Column::field);
    }
};

void addColumns(const pugi::xml_node& node, std::span<const Attribute> attributes, LogHeader& header) {
    for (const Attribute& attribute : attributes) {
        const pugi::xml_attribute found = node.attribute(attribute.name);
        if (found && found.value()[0] == '\0') {
            header.columns.push_back(attribute.column);
        }
    }
}

Result<LogHeader> headerFrom(std::string_view xml, const std::string& where) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(xml.data(), xml.size());
    const pugi::xml_node stamp = document.child("TIM");
    if (!parsed || !stamp) {
        return std::unexpected(trackDamaged(where, "this is no header of a time log"));
    }
    LogHeader header;
    addColumns(stamp, kStamp, header);
    addColumns(stamp.child("PTN"), kPosition, header);
    for (const pugi::xml_node& value : stamp.children("DLV")) {
        const std::string_view code = value.attribute("A").as_string();
        std::uint16_t ddi = 0;
        std::from_chars(code.data(), code.data() + code.size(), ddi, 16);
        header.values.push_back(ddi);
    }
    return header;
}

double secondsSince1980(std::uint32_t milliseconds, std::uint16_t days) {
    const double start = utcMidnight(1980, 1, 1).value_or(0.0);
    return start + kDayS * days + 1e-3 * milliseconds;
}

/// Values are logged when they change, and hold until they change again.
class RunningValues {
public:
    explicit RunningValues(const LogHeader& header) : header_{header} {
        hasWorkState_ = std::ranges::contains(header.values, kActualWorkState);
    }

    void set(std::size_t index, std::int32_t value) {
        if (index < header_.values.size()) {
            values_[index] = value;
        }
    }

    /// Any part of the implement at work; nothing before the first state was logged.
    std::optional<bool> implementDown() const {
        std::optional<bool> down;
        for (const auto& [index, value] : values_) {
            const std::uint16_t ddi = header_.values[index];
            if (hasWorkState_ ? ddi == kActualWorkState
                              : ddi >= kActualCondensedWorkState && ddi <= kLastCondensedWorkState) {
                down = down.value_or(false) || isOn(value);
            }
        }
        return down;
    }

    std::optional<double> speedMps() const {
        for (const auto& [index, value] : values_) {
            if (header_.values[index] == kActualSpeed && value >= 0) {
                return 1e-3 * value;
            }
        }
        return std::nullopt;
    }

private:
    /// Two bits a section: 00 off, 01 on, 10 fault, 11 not known. A plain work state uses the lowest two.
    bool isOn(std::int32_t value) const {
        auto bits = static_cast<std::uint32_t>(value);
        if (hasWorkState_) {
            return (bits & 3U) == 1U;
        }
        for (; bits != 0; bits >>= 2U) {
            if ((bits & 3U) == 1U) {
                return true;
            }
        }
        return false;
    }

    const LogHeader& header_;
    bool hasWorkState_ = false;
    std::map<std::size_t, std::int32_t> values_;
};

struct LogCounts {
    std::size_t withoutPlace = 0;
};

/// One record's fixed part; the running values are added by the caller.
struct Stamp {
    std::optional<double> clockS;  ///< of the terminal, its own zone
    std::optional<std::uint32_t> gpsMs;
    std::optional<std::uint16_t> gpsDays;
    std::int32_t north = INT32_MAX;
    std::int32_t east = INT32_MAX;
    int status = 1;

    std::optional<double> timeS() const {
        // 1980-01-01 is day 0: a receiver that knows no date yet says so, or all ones.
        constexpr std::uint16_t kNoDate = 0xFFFF;
        return gpsMs && gpsDays && *gpsDays != 0 && *gpsDays != kNoDate ? secondsSince1980(*gpsMs, *gpsDays)
                                                                        : clockS;
    }
    bool hasPlace() const {
        constexpr int kNoFix = 0;
        constexpr int kFault = 14;
        return status != kNoFix && status != kFault &&
               isOnEarth({kDegreesPerUnit * east, kDegreesPerUnit * north}) && (north != 0 || east != 0);
    }
};

Stamp readStamp(ByteReader& bytes, const LogHeader& header) {
    Stamp stamp;
    for (const Column& column : header.columns) {
        switch (column.field) {
            case Field::Time: {
                const auto milliseconds = bytes.integer<std::uint32_t>();
                stamp.clockS = secondsSince1980(milliseconds, bytes.integer<std::uint16_t>());
                break;
            }
            case Field::North: stamp.north = bytes.integer<std::int32_t>(); break;
            case Field::East: stamp.east = bytes.integer<std::int32_t>(); break;
            case Field::Status: stamp.status = bytes.integer<std::uint8_t>(); break;
            case Field::GpsTime: stamp.gpsMs = bytes.integer<std::uint32_t>(); break;
            case Field::GpsDate: stamp.gpsDays = bytes.integer<std::uint16_t>(); break;
            case Field::None: bytes.skip(column.bytes); break;
        }
    }
    return stamp;
}

Result<RecordedTrack> readLog(std::string_view binary, const LogHeader& header, const std::string& where,
                              LogCounts& counts, const JobContext& job) {
    RecordedTrack track{.source = {}, .places = TrackPlaces::Wgs84, .samples = {}};
    ByteReader bytes{binary};
    RunningValues values{header};
    std::size_t records = 0;
    while (bytes.bytesLeft() > 0) {
        const std::size_t begin = bytes.at();
        if (++records % 4096 == 0 && job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const Stamp stamp = readStamp(bytes, header);
        const int count = bytes.integer<std::uint8_t>();
        for (int i = 0; i < count; ++i) {
            const auto index = bytes.integer<std::uint8_t>();
            values.set(index, bytes.integer<std::int32_t>());
            if (index >= header.values.size()) {
                return std::unexpected(
                    trackDamaged(message("{}, byte {}", where, begin),
                                 message("record {} has a value that its header does not name", records)));
            }
        }
        if (!bytes.ok()) {
            return std::unexpected(trackDamaged(message("{}, byte {}", where, begin),
                                                message("the log is cut off in record {}", records)));
        }
        if (!stamp.hasPlace()) {
            ++counts.withoutPlace;
            continue;
        }
        track.samples.push_back(
            {.geo = {.lonDeg = kDegreesPerUnit * stamp.east, .latDeg = kDegreesPerUnit * stamp.north},
             .timeS = stamp.timeS(),
             .speedMps = values.speedMps(),
             .implementDown = values.implementDown()});
        if (track.samples.size() > kMostTrackSamples) {
            return std::unexpected(tooManySamples(where));
        }
    }
    return track;
}

/// From the name of a log to that of its task; empty where the task data cannot be read, which the logs
/// themselves do not need.
std::map<std::string, std::string> taskNames(const FileFolder& folder, std::string_view inner) {
    std::map<std::string, std::string> names;
    const FileFolder::Entry* entry = folder.find(inner, "TASKDATA.XML");
    const auto xml = entry == nullptr ? Result<std::string>{} : folder.read(*entry);
    pugi::xml_document document;
    if (!xml || !document.load_buffer(xml->data(), xml->size())) {
        return names;
    }
    for (const pugi::xml_node& task : document.child("ISO11783_TaskData").children("TSK")) {
        for (const pugi::xml_node& log : task.children("TLG")) {
            names[inSmallLetters(log.attribute("A").as_string())] = task.attribute("B").as_string();
        }
    }
    return names;
}

std::string stemOf(const FileFolder::Entry& entry) {
    return entry.name.substr(0, entry.name.size() - std::string_view{".xml"}.size());
}

/// TLG and five digits, as the norm has it.
bool hasLogName(const FileFolder::Entry& entry) {
    const std::string name = inSmallLetters(entry.name);
    return name.size() == 12 && name.starts_with("tlg") && name.ends_with(".xml") &&
           std::all_of(name.begin() + 3, name.begin() + 8, [](char c) { return c >= '0' && c <= '9'; });
}

/// By its name, or by what it is where it has another one: a description with records of its name beside it.
bool isLogHeader(const FileFolder& folder, const FileFolder::Entry& entry) {
    if (hasLogName(entry)) {
        return true;
    }
    if (!inSmallLetters(entry.name).ends_with(".xml") ||
        folder.find(entry.folder, stemOf(entry) + ".bin") == nullptr) {
        return false;
    }
    const auto xml = folder.read(entry);
    return xml && headerFrom(*xml, {}).has_value();
}

}  // namespace

Result<TrackFile> isoxmlTracks(const FileFolder& folder, const std::string& where, const JobContext& job) {
    TrackFile file{.format = "ISOXML time log", .tracks = {}, .notes = {}};
    LogCounts counts;
    std::size_t logs = 0;
    std::map<std::string, std::map<std::string, std::string>> tasksByFolder;
    for (const FileFolder::Entry& entry : folder.entries()) {
        if (!isLogHeader(folder, entry)) {
            continue;
        }
        ++logs;
        const std::string stem = stemOf(entry);
        const FileFolder::Entry* records = folder.find(entry.folder, stem + ".bin");
        if (records == nullptr) {
            file.notes.push_back({.text = message("{}.bin is not there", stem), .where = where});
            continue;
        }
        const auto xml = folder.read(entry);
        const auto binary = xml ? folder.read(*records) : std::unexpected(xml.error());
        if (!binary) {
            return std::unexpected(binary.error());
        }
        const auto header = headerFrom(*xml, folder.placeOf(entry));
        if (!header) {
            return std::unexpected(header.error());
        }
        if (!header->hasPlaces()) {
            file.notes.push_back({.text = message("{} holds no positions", stem), .where = where});
            continue;
        }
        auto track = readLog(*binary, *header, folder.placeOf(*records), counts, job);
        if (!track) {
            return std::unexpected(track.error());
        }
        if (!tasksByFolder.contains(entry.folder)) {
            tasksByFolder[entry.folder] = taskNames(folder, entry.folder);
        }
        const auto& tasks = tasksByFolder[entry.folder];
        const auto task = tasks.find(inSmallLetters(stem));
        track->source =
            task == tasks.end() || task->second.empty() ? stem : std::format("{} ({})", stem, task->second);
        if (!track->samples.empty()) {
            file.tracks.push_back(std::move(*track));
        }
        if (file.sampleCount() > kMostTrackSamples) {
            return std::unexpected(tooManySamples(where));
        }
    }
    if (file.tracks.empty()) {
        return std::unexpected(trackRefused(
            where,
            logs == 0 ? Message{"there is no recorded track in it"}
                      : message("none of its {} time logs holds a position", logs),
            "give the folder or zip with TASKDATA.XML and its TLG files, a rosbag2 folder, or one file"));
    }
    noteSkipped(file, counts.withoutPlace,
                counted("{} record without a position was passed over",
                        "{} records without a position were passed over", counts.withoutPlace),
                where);
    return file;
}

}  // namespace furrow
