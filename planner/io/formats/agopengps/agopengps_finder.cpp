#include "planner/io/formats/agopengps/agopengps.h"

#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/io/formats/agopengps/agopengps_plane.h"

#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
// Five decimals, from points of three, a decimetre apart at the least.
constexpr double kHeadingSlackRad = 0.05;
constexpr std::size_t kFewestReadPoints = 5;

/// One text file, line by line; `bad` remembers the first that is not as the format has it.
class Rows {
public:
    explicit Rows(std::string_view text) : text_{text} {}

    bool atEnd() const { return text_.empty(); }
    std::string_view next() {
        ++number_;
        return nextLine(text_);
    }
    bool is(std::string_view expected) { return check(next() == expected); }
    std::size_t count() {
        const auto value = decimalIn(next());
        const bool good = check(value && *value >= 0.0 && *value == std::floor(*value) && *value < 1e7);
        return good ? static_cast<std::size_t>(*value) : 0;
    }
    /// At least `fewest` numbers, divided by commas; what follows them is left.
    std::vector<double> numbers(std::size_t fewest) {
        const std::string_view line = next();
        std::vector<double> values;
        for (const std::string_view cell : cellsOf(line, ',')) {
            const auto value = decimalIn(cell);
            if (!value) {
                break;
            }
            values.push_back(*value);
        }
        last_ = line;
        return check(values.size() >= fewest) ? values : std::vector<double>(fewest, 0.0);
    }
    std::string_view last() const { return last_; }
    bool check(bool good) {
        bad_ = bad_ || good ? bad_ : std::optional{number_};
        return good;
    }
    std::optional<std::size_t> bad() const { return bad_; }

private:
    std::string_view text_;
    std::string_view last_;
    std::size_t number_ = 0;
    std::optional<std::size_t> bad_;
};

class FolderContent {
public:
    FolderContent(std::string folder, const std::map<std::string, std::string_view>& files)
        : folder_{std::move(folder)}, files_{files} {}

    std::vector<ReceivedContent> take() {
        const auto field = files_.find("Field.txt");
        if (field == files_.end() || !readOrigin(field->second)) {
            ReceivedContent& missing = begin("Field.txt");
            missing.faults.push_back(isMissing(field == files_.end() ? "Field.txt" : "StartFix"));
            return std::move(all_);
        }
        readRings("Boundary.txt", "$Boundary", ReceivedArea::Kind::Field);
        readRings("Headland.txt", "$Headland", ReceivedArea::Kind::Other);
        readTracks();
        readFlags();
        for (const auto& [name, text] : files_) {
            if (name == "RecPath.txt" || name.ends_with(".rec")) {
                readPath(name, text);
            }
        }
        return std::move(all_);
    }

private:
    ReceivedContent& begin(const std::string& name) {
        all_.push_back({.file = folder_ + "/" + name,
                        .repeatsFirst = false,
                        .winding = ReceivedContent::Winding::OuterLeft});
        return all_.back();
    }

    bool readOrigin(std::string_view text) {
        while (!text.empty()) {
            if (nextLine(text) == "StartFix") {
                const auto cells = cellsOf(nextLine(text), ',');
                const auto lat = cells.size() == 2 ? decimalIn(cells[0]) : std::nullopt;
                const auto lon = cells.size() == 2 ? decimalIn(cells[1]) : std::nullopt;
                if (lat && lon) {
                    plane_.emplace(GeoPoint{*lon, *lat});
                }
                return plane_.has_value();
            }
        }
        return false;
    }

    struct Pose {
        Point place;
        double heading = 0.0;
    };

    /// A count and as many rows of place and heading.
    static std::vector<Pose> poses(Rows& rows) {
        const std::size_t count = rows.count();
        std::vector<Pose> read;
        for (std::size_t i = 0; i < count && !rows.atEnd(); ++i) {
            const auto row = rows.numbers(3);
            read.push_back({{row[0], row[1]}, row[2]});
        }
        rows.check(read.size() == count);
        return read;
    }

    /// The program tells inside from outside by the headings, from the point before to the point after.
    static bool headingsFit(const std::vector<Pose>& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point along =
                ring[(i + 1) % ring.size()].place - ring[(i + ring.size() - 1) % ring.size()].place;
            const double bearing = std::atan2(along.x, along.y);
            if (norm(along) > 0.1 &&
                std::abs(std::remainder(ring[i].heading - bearing, kTwoPi)) > kHeadingSlackRad) {
                return false;
            }
        }
        return true;
    }

    GeoRing geo(const std::vector<Pose>& line) const {
        GeoRing points;
        for (const Pose& pose : line) {
            points.push_back(plane_->toGeo(pose.place));
        }
        return points;
    }

    void readRings(const char* name, std::string_view title, ReceivedArea::Kind kind) {
        const auto file = files_.find(name);
        if (file == files_.end()) {
            return;
        }
        ReceivedContent& found = begin(name);
        Rows rows{file->second};
        rows.is(title);
        ReceivedArea area{
            .kind = kind, .name = std::filesystem::path{folder_}.filename().string(), .rings = {}};
        bool first = true;
        bool headings = true;
        while (!rows.atEnd() && !rows.bad()) {
            if (kind == ReceivedArea::Kind::Field) {
                const std::string_view flag = rows.next();
                rows.check(flag == "True" || flag == "False");
            }
            const std::vector<Pose> ring = poses(rows);
            headings = headings && headingsFit(ring);
            if (first) {
                area.rings.outer = geo(ring);
            } else if (!ring.empty()) {  // a ring without a headland
                area.rings.holes.push_back(geo(ring));
            }
            first = false;
        }
        if (!headings) {
            found.faults.emplace_back("the headings of a ring do not point along it");
        }
        finish(rows, found);
        if (!first) {
            found.areas.push_back(std::move(area));
        }
    }

    static void finish(const Rows& rows, ReceivedContent& found) {
        if (rows.bad()) {
            found.faults.push_back(badLine(*rows.bad()));
        }
    }

    void readTracks() {
        const auto file = files_.find("TrackLines.txt");
        if (file == files_.end()) {
            return;
        }
        ReceivedContent& found = begin("TrackLines.txt");
        ReceivedNames names{.names = {}};
        Rows rows{file->second};
        rows.is("$TrackLines");
        while (!rows.atEnd() && !rows.bad()) {
            const std::string name{rows.next()};
            rows.check(!name.empty());
            rows.numbers(1);
            const auto a = rows.numbers(2);
            const auto b = rows.numbers(2);
            rows.numbers(1);
            const std::size_t mode = rows.count();
            const std::string_view visible = rows.next();
            rows.check(visible == "True" || visible == "False");
            const std::vector<Pose> curve = poses(rows);
            rows.check(mode == 2 ? curve.empty() : mode == 4 && curve.size() >= 2);
            names.names.push_back(name);
            found.lines.push_back(
                {.name = name,
                 .points = mode == 4 ? geo(curve)
                                     : GeoRing{plane_->toGeo({a[0], a[1]}), plane_->toGeo({b[0], b[1]})},
                 .widthM = std::nullopt});
        }
        found.names.push_back(std::move(names));
        finish(rows, found);
    }

    void readFlags() {
        const auto file = files_.find("Flags.txt");
        if (file == files_.end()) {
            return;
        }
        ReceivedContent& found = begin("Flags.txt");
        Rows rows{file->second};
        rows.is("$Flags");
        const std::size_t count = rows.count();
        for (std::size_t i = 0; i < count; ++i) {
            const auto row = rows.numbers(7);
            rows.check(cellsOf(rows.last(), ',').size() == 8);
            found.points.push_back({row[1], row[0]});
        }
        rows.check(rows.atEnd());
        finish(rows, found);
    }

    void readPath(const std::string& name, std::string_view text) {
        ReceivedContent& found = begin(name);
        Rows rows{text};
        rows.is("$RecPath");
        const std::size_t count = rows.count();
        // It drives forwards only: stretches where the plan reverses.
        ReceivedPath path{.samples = {}, .isWhole = false, .knowsGear = true};
        for (std::size_t i = 0; i < count && !rows.atEnd(); ++i) {
            const auto row = rows.numbers(4);
            rows.check(rows.last().ends_with("True") || rows.last().ends_with("False"));
            path.samples.push_back({.geo = plane_->toGeo({row[0], row[1]}),
                                    .headingRad = std::numbers::pi / 2.0 - row[2],
                                    .speedMps = row[3] / 3.6});
        }
        rows.check(rows.atEnd() && path.samples.size() == count);
        if (count > 0 && count < kFewestReadPoints) {
            found.faults.push_back(badLine(2));
        }
        finish(rows, found);
        if (!path.samples.empty()) {
            found.paths.push_back(std::move(path));
        }
    }

    std::string folder_;
    const std::map<std::string, std::string_view>& files_;
    std::optional<AgOpenGpsPlane> plane_;
    std::vector<ReceivedContent> all_;
};

}  // namespace

std::vector<ReceivedContent> findAgOpenGps(std::span<const FileInMemory> files, const ExportJob& job) {
    std::map<std::string, std::map<std::string, std::string_view>> folders;
    for (const FileInMemory& file : files) {
        const std::filesystem::path path{file.path};
        folders[path.parent_path().generic_string()][path.filename().string()] = file.bytes;
    }
    std::vector<ReceivedContent> all;
    bool paths = false;
    for (const auto& [folder, texts] : folders) {
        for (ReceivedContent& found : FolderContent{folder, texts}.take()) {
            paths = paths || !found.paths.empty();
            all.push_back(std::move(found));
        }
    }
    if (job.plan != nullptr && !paths && !all.empty()) {
        all.front().paths.push_back({.samples = {}, .isWhole = false});
    }
    return all;
}

}  // namespace furrow
