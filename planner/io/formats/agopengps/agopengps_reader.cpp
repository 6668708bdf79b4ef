#include "planner/io/formats/agopengps/agopengps_reader.h"

#include "planner/core/file_error.h"
#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/core/text_file.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/formats/agopengps/agopengps_plane.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kMostPoints = 2'000'000;
// A field is smaller than this from its start.
constexpr double kFarthestM = 200'000.0;

// Modes of TrackLines.txt; the others are curves along boundaries.
constexpr int kAbTrack = 2;

std::vector<std::string_view> partsOf(std::string_view line) {
    std::vector<std::string_view> parts = cellsOf(line, ',');
    std::ranges::transform(parts, parts.begin(), [](std::string_view part) { return trimmed(part); });
    return parts;
}

/// One file, line by line; the first line says what it is.
class Text {
public:
    explicit Text(std::string_view text) : lines_{withoutByteOrderMark(text)} {}

    std::optional<std::string_view> line() {
        std::string_view next;
        return lines_.next(next) ? std::optional{trimmed(next)} : std::nullopt;
    }
    std::optional<double> number() {
        const auto next = line();
        return next ? numberIn(*next) : std::nullopt;
    }
    /// Nothing where it is no count that a file can hold.
    std::optional<std::size_t> count() {
        const auto next = number();
        const bool good =
            next && *next >= 0.0 && *next <= static_cast<double>(kMostPoints) && *next == std::floor(*next);
        return good ? std::optional{static_cast<std::size_t>(*next)} : std::nullopt;
    }
    /// East and north; what follows on the line is not needed.
    std::optional<Point> point() {
        const auto next = line();
        if (!next) {
            return std::nullopt;
        }
        const std::vector<std::string_view> parts = partsOf(*next);
        const auto east = numberIn(parts[0]);
        const auto north = parts.size() >= 2 ? numberIn(parts[1]) : std::nullopt;
        const bool good = east && north && std::abs(*east) < kFarthestM && std::abs(*north) < kFarthestM;
        return good ? std::optional{Point{*east, *north}} : std::nullopt;
    }
    std::optional<std::vector<Point>> points(std::size_t count) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < count; ++i) {
            const auto next = point();
            if (!next) {
                return std::nullopt;
            }
            points.push_back(*next);
        }
        return points;
    }
    std::size_t lineNumber() const { return lines_.number(); }

private:
    Lines lines_;
};

class FolderReader {
public:
    FolderReader(const std::string& name, const AgOpenGpsFile& file) : name_{name}, file_{file} {}

    Result<ImportedFields> read() {
        const auto text = file_("Field.txt");
        if (!text) {
            return std::unexpected(readFailed(name_, "there is no Field.txt", "give the folder of a field"));
        }
        const auto start = startFix(*text);
        if (!start) {
            return std::unexpected(inputRefused(message("{}, Field.txt", name_),
                                                "the line after StartFix is no place",
                                                "it needs latitude and longitude, as in 52.09,5.66"));
        }
        plane_ = AgOpenGpsPlane{*start};
        content_.field.id = content_.field.name = content_.field.origin = name_;
        if (auto read = readBoundary(); !read) {
            return std::unexpected(read.error());
        }
        readHeadland();
        readTracks();
        readPath();
        readFlags();
        if (!content_.field.parts.empty()) {
            imported_.fields.push_back(std::move(content_));
        } else {
            imported_.looseLines = std::move(content_.lines);
            tell("", "the field has no boundary");
            if (imported_.looseLines.empty()) {
                return std::unexpected(inputRefused(name_, "the field has neither boundary nor guidance line",
                                                    "record or draw its boundary first"));
            }
        }
        return std::move(imported_);
    }

private:
    void tell(std::string_view file, Message text) {
        imported_.notes.push_back(
            {std::move(text), file.empty() ? Message{name_} : message("{}, {}", name_, file)});
    }

    std::optional<GeoPoint> startFix(std::string_view text) {
        Text lines{text};
        while (const auto line = lines.line()) {
            if (!line->starts_with("StartFix")) {
                continue;
            }
            const auto values = lines.line();
            if (!values) {
                return std::nullopt;
            }
            std::vector<std::string> parts;
            for (const std::string_view part : partsOf(*values)) {
                parts.emplace_back(part);
            }
            if (parts.size() == 4) {
                tell("Field.txt", "decimal commas in the place of the field were taken for points");
                parts = {parts[0] + "." + parts[1], parts[2] + "." + parts[3]};
            }
            const auto lat = numberIn(parts[0]);
            const auto lon = parts.size() == 2 ? numberIn(parts[1]) : std::nullopt;
            const bool good = lat && lon && isOnEarth({*lon, *lat});
            return good ? std::optional{GeoPoint{*lon, *lat}} : std::nullopt;
        }
        return std::nullopt;
    }

    GeoRing placed(const std::vector<Point>& points) const {
        GeoRing ring;
        for (const Point& point : points) {
            ring.push_back(plane_.toGeo(point));
        }
        return ring;
    }

    Result<void> readBoundary() {
        const auto text = file_("Boundary.txt");
        if (!text) {
            return {};
        }
        Text lines{*text};
        std::optional<std::string_view> line = lines.line();
        if (!line || !line->starts_with('$')) {
            return std::unexpected(damaged("Boundary.txt", lines));
        }
        GeoPolygon outline;
        bool isOuter = true;
        for (line = lines.line(); line; line = lines.line()) {
            bool driveThrough = false;
            // Files of older versions have the flag twice.
            while (line && (*line == "True" || *line == "False")) {
                driveThrough = *line == "True";
                line = lines.line();
            }
            if (!line || line->empty()) {
                break;
            }
            const auto count = numberIn(*line);
            // So that what is no number is none of these.
            if (!count || !(*count >= 0.0 && *count <= static_cast<double>(kMostPoints))) {
                return std::unexpected(damaged("Boundary.txt", lines));
            }
            const auto points = lines.points(static_cast<std::size_t>(*count));
            if (!points) {
                return std::unexpected(damaged("Boundary.txt", lines));
            }
            if (points->size() < 3) {
                if (!points->empty()) {
                    tell("Boundary.txt",
                         message("left out: {} {}", 1, Message{"rings with fewer than three corners"}));
                }
                continue;
            }
            if (isOuter) {
                outline.outer = placed(*points);
            } else if (driveThrough) {
                content_.field.obstacles.push_back(
                    {.outline = {.outer = placed(*points), .holes = {}}, .passable = true});
            } else {
                outline.holes.push_back(placed(*points));
            }
            isOuter = false;
        }
        if (!outline.outer.empty()) {
            content_.field.parts.push_back(std::move(outline));
        }
        return {};
    }

    Error damaged(const char* file, const Text& lines) const {
        return inputRefused(message("{}, {}, line {}", name_, file, lines.lineNumber()),
                            "the file is damaged here", "save the field again, or remove this file");
    }

    /// A ring for each of the boundary's; what they enclose is the mainland.
    void readHeadland() {
        const auto text = file_("Headland.txt");
        if (!text || content_.field.parts.empty()) {
            return;
        }
        Text lines{*text};
        lines.line();
        GeoPolygon mainland;
        while (const auto count = lines.count()) {
            const auto points = lines.points(*count);
            if (!points) {
                tell("Headland.txt",
                     message("the headland is left out: line {} is damaged", lines.lineNumber()));
                return;
            }
            if (points->size() >= 3) {
                mainland.outer.empty() ? mainland.outer = placed(*points)
                                       : mainland.holes.emplace_back(placed(*points));
            }
        }
        if (!mainland.outer.empty()) {
            content_.mainland.push_back(std::move(mainland));
        }
    }

    void readTracks() {
        if (const auto text = file_("TrackLines.txt")) {
            readTrackLines(*text);
            return;
        }
        if (const auto text = file_("ABLines.txt")) {
            readOldAbLines(*text);
        }
        if (const auto text = file_("CurveLines.txt")) {
            readOldCurves(*text);
        }
    }

    void addCurve(std::string_view name, const std::vector<Point>& points) {
        content_.lines.push_back(
            {.kind = GuidanceKind::Curve, .name = std::string{name}, .points = placed(points)});
    }

    void readTrackLines(std::string_view text) {
        Text lines{text};
        lines.line();
        while (const auto name = lines.line()) {
            if (name->empty()) {
                continue;
            }
            const auto heading = lines.number();
            const auto a = lines.point();
            const auto b = lines.point();
            const auto nudge = lines.number();
            const auto mode = lines.number();
            const auto visible = lines.line();
            const auto count = lines.count();
            const auto points = count ? lines.points(*count) : std::nullopt;
            if (!heading || !a || !b || !nudge || !mode || !visible || !points) {
                tell("TrackLines.txt",
                     message("the lines from line {} on are left out: it is damaged", lines.lineNumber()));
                return;
            }
            if (*mode == kAbTrack) {
                content_.lines.push_back(
                    {.kind = GuidanceKind::AbLine, .name = std::string{*name}, .points = placed({*a, *b})});
            } else if (points->size() >= 2) {
                addCurve(*name, *points);
            } else {
                tell("TrackLines.txt", message("'{}' is left out: its kind {} is not known", *name, *mode));
            }
        }
    }

    /// "name,heading in degrees,E,N" on each line.
    void readOldAbLines(std::string_view text) {
        Text lines{text};
        while (const auto line = lines.line()) {
            const std::vector<std::string_view> parts = partsOf(*line);
            if (parts.size() < 4) {
                continue;
            }
            const auto heading = numberIn(parts[1]);
            const auto east = numberIn(parts[2]);
            const auto north = numberIn(parts[3]);
            const bool good = heading && std::isfinite(*heading) && east && std::abs(*east) < kFarthestM &&
                              north && std::abs(*north) < kFarthestM;
            if (!good) {
                tell("ABLines.txt", message("line {} is left out: it is damaged", lines.lineNumber()));
                continue;
            }
            content_.lines.push_back({.kind = GuidanceKind::APlus,
                                      .name = std::string{parts[0]},
                                      .points = placed({{*east, *north}}),
                                      .bearing = degrees(std::fmod(*heading + 720.0, 360.0))});
        }
    }

    void readOldCurves(std::string_view text) {
        Text lines{text};
        lines.line();
        while (const auto name = lines.line()) {
            if (name->empty()) {
                continue;
            }
            const auto heading = lines.number();
            const auto count = lines.count();
            const auto points = count ? lines.points(*count) : std::nullopt;
            if (!heading || !points) {
                tell("CurveLines.txt",
                     message("the curves from line {} on are left out: it is damaged", lines.lineNumber()));
                return;
            }
            if (points->size() >= 2) {
                addCurve(*name, *points);
            }
        }
    }

    void readPath() {
        const auto text = file_("RecPath.txt");
        if (!text) {
            return;
        }
        Text lines{*text};
        lines.line();
        const auto count = lines.count();
        const auto points = count ? lines.points(*count) : std::nullopt;
        if (!points) {
            tell("RecPath.txt", "the recorded path is left out: it is damaged");
        } else if (points->size() >= 2) {
            addCurve("Recorded path", *points);
            content_.lines.back().repeats = false;
        }
    }

    /// Those in the colour in which gates are written.
    void readFlags() {
        const auto text = file_("Flags.txt");
        if (!text) {
            return;
        }
        Text lines{*text};
        lines.line();
        const std::size_t count = lines.count().value_or(0);
        for (std::size_t i = 0; i < count; ++i) {
            const auto line = lines.line();
            const std::vector<std::string_view> parts =
                line ? partsOf(*line) : std::vector<std::string_view>{};
            constexpr std::string_view kGreen = "1";
            if (parts.size() < 8 || parts[5] != kGreen) {
                continue;
            }
            const auto lat = numberIn(parts[0]);
            const auto lon = numberIn(parts[1]);
            if (lat && lon && isOnEarth({*lon, *lat})) {
                content_.field.gates.push_back(
                    {.name = std::string{parts[7]}, .position = {*lon, *lat}, .width = {}});
            }
        }
    }

    std::string name_;
    const AgOpenGpsFile& file_;
    AgOpenGpsPlane plane_{{}};
    FieldContent content_;
    ImportedFields imported_;
};

}  // namespace

Result<ImportedFields> readAgOpenGps(const std::string& name, const AgOpenGpsFile& file) {
    return FolderReader{name, file}.read();
}

Result<ImportedFields> readAgOpenGpsFolder(const FileFolder& folder, const std::string& name,
                                           const JobContext& job) {
    ImportedFields all;
    Error first;
    for (const FileFolder::Entry& entry : folder.entries()) {
        if (inSmallLetters(entry.name) != "field.txt") {
            continue;
        }
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const auto file = [&](std::string_view wanted) -> std::optional<std::string> {
            const FileFolder::Entry* found = folder.find(entry.folder, wanted);
            auto text = found == nullptr ? Result<std::string>{""} : folder.read(*found);
            return found != nullptr && text ? std::optional{*std::move(text)} : std::nullopt;
        };
        const std::size_t slash = entry.folder.rfind('/');
        const std::string field = entry.folder.empty()         ? name
                                  : slash == std::string::npos ? entry.folder
                                                               : entry.folder.substr(slash + 1);
        auto read = readAgOpenGps(field, file);
        if (!read) {
            first = first.what.empty() ? read.error() : first;
            all.notes.push_back({message("the field '{}' is left out: {}", field, read.error().what), name});
            continue;
        }
        std::ranges::move(read->fields, std::back_inserter(all.fields));
        std::ranges::move(read->looseLines, std::back_inserter(all.looseLines));
        std::ranges::move(read->notes, std::back_inserter(all.notes));
    }
    if (all.fields.empty() && all.looseLines.empty()) {
        return std::unexpected(first);
    }
    return all;
}

}  // namespace furrow
