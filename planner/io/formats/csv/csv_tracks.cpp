#include "planner/io/content/geo_ring.h"
#include "planner/io/formats/csv/csv.h"

#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/core/text_file.h"
#include "planner/io/tracks/track_parts.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace furrow {

namespace {

constexpr double kInchM = 0.0254;

// How far down the header may stand; what is above it says whose file it is.
constexpr std::size_t kMostPreambleLines = 50;

enum class Meaning { None, Lon, Lat, X, Y, Time, Speed, Bearing, Heading, Implement };

struct Column {
    Meaning meaning = Meaning::None;
    double unit = 1.0;    ///< to SI
    bool metres = false;  ///< of X and Y: the header says so
};

struct Word {
    std::string_view name;  ///< small letters and digits only
    Column column;
};

constexpr double kKmhMps = 1.0 / 3.6;
constexpr double kKnotMps = 1852.0 / 3600.0;
constexpr double kMphMps = 1609.344 / 3600.0;

constexpr Word kWords[] = {
    {"lon", {Meaning::Lon}},
    {"lng", {Meaning::Lon}},
    {"long", {Meaning::Lon}},
    {"longitude", {Meaning::Lon}},
    {"londeg", {Meaning::Lon}},
    {"longitudedeg", {Meaning::Lon}},
    {"lat", {Meaning::Lat}},
    {"latitude", {Meaning::Lat}},
    {"latdeg", {Meaning::Lat}},
    {"latitudedeg", {Meaning::Lat}},
    {"x", {Meaning::X}},
    {"y", {Meaning::Y}},
    {"xm", {Meaning::X, 1.0, true}},
    {"ym", {Meaning::Y, 1.0, true}},
    {"time", {Meaning::Time}},
    {"ts", {Meaning::Time}},
    {"times", {Meaning::Time}},
    {"timestamp", {Meaning::Time}},
    {"timems", {Meaning::Time, 1e-3}},
    {"timestampms", {Meaning::Time, 1e-3}},
    {"datetime", {Meaning::Time}},
    {"utc", {Meaning::Time}},
    {"utctime", {Meaning::Time}},
    {"gpstime", {Meaning::Time}},
    {"seconds", {Meaning::Time}},
    {"speed", {Meaning::Speed}},
    {"velocity", {Meaning::Speed}},
    {"speedmps", {Meaning::Speed}},
    {"speedms", {Meaning::Speed}},
    {"speedkmh", {Meaning::Speed, kKmhMps}},
    {"speedkph", {Meaning::Speed, kKmhMps}},
    {"speedknots", {Meaning::Speed, kKnotMps}},
    {"speedkn", {Meaning::Speed, kKnotMps}},
    {"speedmph", {Meaning::Speed, kMphMps}},
    {"kmh", {Meaning::Speed, kKmhMps}},
    {"headingrad", {Meaning::Heading}},
    {"heading", {Meaning::Bearing}},
    {"headingdeg", {Meaning::Bearing}},
    {"bearing", {Meaning::Bearing}},
    {"bearingdeg", {Meaning::Bearing}},
    {"course", {Meaning::Bearing}},
    {"coursedeg", {Meaning::Bearing}},
    {"cog", {Meaning::Bearing}},
    {"track", {Meaning::Bearing}},
    {"trackdeg", {Meaning::Bearing}},
    {"implementdown", {Meaning::Implement}},
    {"workstate", {Meaning::Implement}},
    {"working", {Meaning::Implement}},
};

Column columnNamed(std::string_view header) {
    std::string name;
    for (const char letter : inSmallLetters(header)) {
        if ((letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9')) {
            name += letter;
        }
    }
    const auto found = std::ranges::find(kWords, name, &Word::name);
    return found == std::ranges::end(kWords) ? Column{} : found->column;
}

/// Where each meaning stands; -1 where it does not.
struct Layout {
    char separator = ',';
    std::array<int, 10> at{-1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
    std::vector<Column> columns;
    bool yieldMonitor = false;   ///< Ag Leader's text: distance and time of each row give its speed
    std::size_t rowsBefore = 0;  ///< lines up to and with the header

    int of(Meaning meaning) const { return at[static_cast<std::size_t>(meaning)]; }
    bool hasGeo() const { return of(Meaning::Lon) >= 0 && of(Meaning::Lat) >= 0; }
    bool hasPlane() const { return of(Meaning::X) >= 0 && of(Meaning::Y) >= 0; }
};

constexpr char kSeparators[] = {',', ';', '\t'};

std::optional<Layout> layoutOf(std::string_view header, char separator) {
    Layout layout{.separator = separator};
    const std::vector<std::string> cells = quotedCellsOf(header, separator);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Column column = columnNamed(cells[i]);
        int& place = layout.at[static_cast<std::size_t>(column.meaning)];
        place = place < 0 && column.meaning != Meaning::None ? static_cast<int>(i) : place;
        layout.columns.push_back(column);
    }
    return layout.hasGeo() || layout.hasPlane() ? std::optional{layout} : std::nullopt;
}

/// lon,lat,flow,time,cycle(s),distance(in),swath(in),moisture ... without a header.
std::optional<Layout> yieldMonitorLayout(std::string_view firstLine) {
    const std::vector<std::string> cells = quotedCellsOf(firstLine, ',');
    if (cells.size() < 8) {
        return std::nullopt;
    }
    std::array<double, 7> value{};
    for (std::size_t i = 0; i < value.size(); ++i) {
        const auto number = numberIn(cells[i]);
        if (!number || !std::isfinite(*number)) {
            return std::nullopt;
        }
        value[i] = *number;
    }
    constexpr double kEpochAtLeastS = 1e8;
    if (!isOnEarth({value[0], value[1]}) || value[3] < kEpochAtLeastS || value[4] < 0.0 ||
        value[4] > 3600.0) {
        return std::nullopt;
    }
    Layout layout{.separator = ',', .yieldMonitor = true};
    layout.at[static_cast<std::size_t>(Meaning::Lon)] = 0;
    layout.at[static_cast<std::size_t>(Meaning::Lat)] = 1;
    layout.at[static_cast<std::size_t>(Meaning::Time)] = 3;
    layout.columns.resize(cells.size());
    return layout;
}

std::optional<Layout> findLayout(std::string_view text) {
    Lines lines{text};
    std::string_view line;
    bool first = true;
    while (lines.number() < kMostPreambleLines && lines.next(line)) {
        for (const char separator : kSeparators) {
            if (auto layout = layoutOf(line, separator)) {
                layout->rowsBefore = lines.number();
                return layout;
            }
        }
        if (first && !trimmed(line).empty()) {
            first = false;
            if (auto layout = yieldMonitorLayout(line)) {
                return layout;
            }
        }
    }
    return std::nullopt;
}

std::optional<bool> flagIn(std::string_view text) {
    const std::string small = inSmallLetters(trimmed(text));
    if (small == "1" || small == "true" || small == "yes" || small == "on" || small == "down") {
        return true;
    }
    if (small == "0" || small == "false" || small == "no" || small == "off" || small == "up") {
        return false;
    }
    return std::nullopt;
}

class TableReader {
public:
    TableReader(const Layout& layout, const std::string& where, const JobContext& job)
        : layout_{layout},
          where_{where},
          job_{job},
          // Longitude and latitude say where on Earth; x and y need the frame of a plan.
          first_{layout.hasGeo() ? layout.of(Meaning::Lon) : layout.of(Meaning::X)},
          second_{layout.hasGeo() ? layout.of(Meaning::Lat) : layout.of(Meaning::Y)} {}

    Result<TrackFile> read(std::string_view text) {
        Lines lines{text};
        std::string_view line;
        while (lines.next(line)) {
            if (lines.number() % 4096 == 0 && job_.stopRequested()) {
                return std::unexpected(cancelled());
            }
            if (lines.number() <= layout_.rowsBefore || trimmed(line).empty()) {
                continue;
            }
            if (auto row = readRow(line, lines.number()); !row) {
                return std::unexpected(row.error());
            }
            if (rows_.size() > kMostTrackSamples) {
                return std::unexpected(tooManySamples(where_));
            }
        }
        return finished();
    }

private:
    struct Row {
        double a = 0.0;  ///< longitude or x
        double b = 0.0;
        std::size_t line = 0;
        TrackSample sample;
    };

    std::string_view cell(const std::vector<std::string>& cells, int column) const {
        return column >= 0 && static_cast<std::size_t>(column) < cells.size()
                   ? trimmed(cells[static_cast<std::size_t>(column)])
                   : std::string_view{};
    }

    std::optional<double> number(const std::vector<std::string>& cells, Meaning meaning) const {
        const int column = layout_.of(meaning);
        const auto value = numberIn(cell(cells, column), layout_.separator != ',');
        return value && std::isfinite(*value)
                   ? std::optional{*value * layout_.columns[static_cast<std::size_t>(column)].unit}
                   : std::nullopt;
    }

    Result<void> readRow(std::string_view line, std::size_t number) {
        const std::vector<std::string> cells = quotedCellsOf(line, layout_.separator);
        const std::string_view first = cell(cells, first_);
        const std::string_view second = cell(cells, second_);
        if (first.empty() || second.empty()) {
            ++withoutPlace_;
            return {};
        }
        const auto a = numberIn(first, layout_.separator != ',');
        const auto b = numberIn(second, layout_.separator != ',');
        if (!a || !b || !std::isfinite(*a) || !std::isfinite(*b)) {
            return std::unexpected(trackRefused(message("{}, line {}", where_, number),
                                                message("'{}', '{}' is no position", first, second),
                                                "correct or remove the line"));
        }
        Row row{.a = *a, .b = *b, .line = number};
        row.sample.timeS = timeIn(cells);
        row.sample.speedMps = speedIn(cells);
        row.sample.headingRad = headingIn(cells);
        row.sample.implementDown = flagIn(cell(cells, layout_.of(Meaning::Implement)));
        rows_.push_back(row);
        return {};
    }

    std::optional<double> timeIn(const std::vector<std::string>& cells) const {
        const auto seconds = number(cells, Meaning::Time);
        if (!seconds) {
            return utcSeconds(cell(cells, layout_.of(Meaning::Time)));
        }
        // No clock counts seconds up to here before the year 5138; milliseconds it is.
        constexpr double kMillisecondsFrom = 1e11;
        return *seconds >= kMillisecondsFrom ? *seconds * 1e-3 : *seconds;
    }

    std::optional<double> speedIn(const std::vector<std::string>& cells) const {
        std::optional<double> speed = number(cells, Meaning::Speed);
        if (layout_.yieldMonitor) {
            const auto cycleS = numberIn(cell(cells, 4));
            const auto distanceInches = numberIn(cell(cells, 5));
            if (cycleS && distanceInches && *cycleS > 0.0) {
                speed = *distanceInches * kInchM / *cycleS;
            }
        }
        return speed && std::isfinite(*speed) && *speed >= 0.0 ? speed : std::nullopt;
    }

    std::optional<double> headingIn(const std::vector<std::string>& cells) const {
        if (const auto heading = number(cells, Meaning::Heading)) {
            return normalisedPoseHeading(radians(*heading)).si();
        }
        const auto bearing = number(cells, Meaning::Bearing);
        return bearing ? std::optional{headingFromBearing(*bearing)} : std::nullopt;
    }

    /// Bare `x` and `y` are longitude and latitude where they stay within their ranges and within a
    /// degree of each other: no track in metres is that short.
    bool isGeographic() const {
        if (layout_.hasGeo()) {
            return true;
        }
        if (layout_.columns[static_cast<std::size_t>(first_)].metres) {
            return false;
        }
        const auto a = std::ranges::minmax(rows_, {}, &Row::a);
        const auto b = std::ranges::minmax(rows_, {}, &Row::b);
        return isOnEarth({a.min.a, b.min.b}) && isOnEarth({a.max.a, b.max.b}) && a.max.a - a.min.a < 1.0 &&
               b.max.b - b.min.b < 1.0;
    }

    Result<TrackFile> finished() {
        if (rows_.empty()) {
            return std::unexpected(
                trackRefused(where_, "no row of this table has a position", "record or export it again"));
        }
        const bool geographic = isGeographic();
        RecordedTrack track{.source = layout_.yieldMonitor ? "yield monitor" : "table",
                            .places = geographic ? TrackPlaces::Wgs84 : TrackPlaces::Local,
                            .samples = {}};
        track.samples.reserve(rows_.size());
        constexpr double kFarthestLocalM = 1e6;
        for (Row& row : rows_) {
            if (geographic ? !isOnEarth({row.a, row.b})
                           : std::abs(row.a) > kFarthestLocalM || std::abs(row.b) > kFarthestLocalM) {
                return std::unexpected(trackRefused(
                    message("{}, line {}", where_, row.line),
                    geographic ? message("{}, {} is no longitude and latitude", row.a, row.b)
                               : message("{}, {} is more than 1,000 km from the plan", row.a, row.b),
                    geographic ? "correct the line, or export the track in WGS84"
                               : "give x_m and y_m in the plan's frame, or longitude and latitude"));
            }
            if (geographic) {
                row.sample.geo = {.lonDeg = row.a, .latDeg = row.b};
            } else {
                row.sample.local = {.x = row.a, .y = row.b};
            }
            track.samples.push_back(row.sample);
        }
        TrackFile file{
            .format = layout_.yieldMonitor ? "yield monitor text" : "table", .tracks = {}, .notes = {}};
        file.tracks.push_back(std::move(track));
        noteSkipped(file, withoutPlace_,
                    counted("{} row without a position was passed over",
                            "{} rows without a position were passed over", withoutPlace_),
                    where_);
        return file;
    }

    const Layout& layout_;
    const std::string& where_;
    const JobContext& job_;
    int first_;
    int second_;
    std::vector<Row> rows_;
    std::size_t withoutPlace_ = 0;
};

}  // namespace

Result<TrackFile> tableTracks(std::string_view text, const std::string& where, const JobContext& job) {
    const auto layout = findLayout(text);
    if (!layout) {
        return std::unexpected(
            trackRefused(where, "no header names a longitude and a latitude (or x_m and y_m)",
                         "name the columns, for example time,lon,lat,speed_kmh in the first line"));
    }
    return TableReader{*layout, where, job}.read(text);
}

Recognition recogniseTrackTable(const ChosenFile& chosen) {
    return chosen.isPlainText() ? Recognition::Perhaps : Recognition::No;
}

Result<TrackFile> readTrackTable(const ChosenFile& chosen, const JobContext& job) {
    const auto text = fileBytes(chosen.path());
    return text ? tableTracks(withoutByteOrderMark(*text), chosen.path().string(), job)
                : std::unexpected(text.error());
}

}  // namespace furrow
