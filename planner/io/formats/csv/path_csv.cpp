#include "planner/io/formats/csv/path_csv.h"

#include "planner/core/separated_text.h"
#include "planner/io/content/plan_error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <format>
#include <iterator>
#include <optional>
#include <vector>

namespace furrow {

namespace {

enum PathColumn {
    kS,
    kT,
    kX,
    kY,
    kHeading,
    kCurvature,
    kSpeed,
    kGear,
    kDown,
    kOrder,
    kNumbers,
    kKind = kNumbers
};
constexpr std::array<std::string_view, kNumbers + 1> kColumns = {
    "s_m",   "t_s",    "x_m", "y_m", "heading_rad", "curvature_1pm", "speed_mps", "gear", "implement_down",
    "order", "segment"};
// Plans that follow no tank leave it empty, and other programs may leave it out.
constexpr std::string_view kLevel = "level";
// Numbers of metres that are larger leave too few digits for shapes.
constexpr double kFarthestM = 1e6;

class PathTable {
public:
    explicit PathTable(const std::string& where) : where_{where} {}

    Result<void> readHeader(std::string_view line) {
        const std::vector<std::string_view> names = cellsOf(line, ',');
        for (std::size_t i = 0; i < kColumns.size(); ++i) {
            const auto found = std::ranges::find(names, kColumns[i]);
            if (found == names.end()) {
                return std::unexpected(
                    damagedPlan(where_ + ", line 1", message("there is no column {}", kColumns[i])));
            }
            at_[i] = static_cast<std::size_t>(found - names.begin());
        }
        level_ = static_cast<std::size_t>(std::ranges::find(names, kLevel) - names.begin());
        return {};
    }

    Result<void> readRow(std::string_view line, std::size_t number) {
        const Message place = message("{}, line {}", where_, number);
        const std::vector<std::string_view> cells = cellsOf(line, ',');
        std::array<double, kNumbers> value{};
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string_view cell = at_[i] < cells.size() ? cells[at_[i]] : std::string_view{};
            if (!readNumber(cell, value[i])) {
                return std::unexpected(
                    damagedPlan(place, message("{} is '{}', which is no number", kColumns[i], cell)));
            }
            if ((i == kX || i == kY) && std::abs(value[i]) > kFarthestM) {
                return std::unexpected(damagedPlan(
                    place, message("{} is '{}', which is more than 1,000 km away", kColumns[i], cell)));
            }
        }
        const std::string_view held = level_ < cells.size() ? cells[level_] : std::string_view{};
        std::optional<double> level;
        if (!held.empty() && !readNumber(held, level.emplace())) {
            return std::unexpected(
                damagedPlan(place, message("{} is '{}', which is no number", kLevel, held)));
        }
        const std::string_view kindId = at_[kKind] < cells.size() ? cells[at_[kKind]] : std::string_view{};
        const auto kind = segmentKindFrom(kindId);
        if (!kind) {
            return std::unexpected(damagedPlan(place, message("'{}' is no kind of segment", kindId)));
        }
        if (path.segments.empty() || value[kOrder] != order_) {
            order_ = value[kOrder];
            if (!path.segments.empty()) {
                // Between two segments it changes only where the machine stands at a refill point.
                PathSegment& before = path.segments.back();
                before.refills = before.samples.back().level != level;
            }
            path.segments.push_back({.kind = *kind,
                                     .gear = value[kGear] < 0.0 ? Gear::Reverse : Gear::Forward,
                                     .implementDown = value[kDown] != 0.0});
        }
        path.segments.back().samples.push_back({.sM = value[kS],
                                                .tS = value[kT],
                                                .position = {value[kX], value[kY]},
                                                .headingRad = value[kHeading],
                                                .curvature1pm = value[kCurvature],
                                                .speedMps = value[kSpeed],
                                                .level = level});
        return {};
    }

    Path path;

private:
    static bool readNumber(std::string_view text, double& number) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
        return error == std::errc{} && end == text.data() + text.size() && std::isfinite(number);
    }

    const std::string& where_;
    std::size_t level_ = 0;
    std::array<std::size_t, kColumns.size()> at_{};
    double order_ = 0.0;
};

}  // namespace

std::string pathCsv(const Plan& plan) {
    std::string text =
        "s_m,t_s,x_m,y_m,lon_deg,lat_deg,heading_rad,curvature_1pm,speed_mps,gear,implement_down,segment,"
        "order,"
        "machine,level\n";
    const auto out = std::back_inserter(text);
    for (std::size_t order = 0; order < plan.path.segments.size(); ++order) {
        const PathSegment& segment = plan.path.segments[order];
        Polyline line;
        for (const PathSample& sample : segment.samples) {
            line.push_back(sample.position);
        }
        const GeoRing places = plan.field().frame().toGeo(line);
        for (std::size_t i = 0; i < segment.samples.size(); ++i) {
            const PathSample& sample = segment.samples[i];
            const std::string level = sample.level ? std::format("{}", *sample.level) : std::string{};
            std::format_to(out, "{},{},{},{},{},{},{},{},{},{},{},{},{},0,{}\n", sample.sM, sample.tS,
                           sample.position.x, sample.position.y, places[i].lonDeg, places[i].latDeg,
                           sample.headingRad, sample.curvature1pm, sample.speedMps,
                           static_cast<int>(segment.gear), segment.implementDown ? 1 : 0,
                           segmentKindId(segment.kind), order, level);
        }
    }
    return text;
}

Result<Path> readPathCsv(std::string_view text, const std::string& where) {
    PathTable table{where};
    if (auto header = table.readHeader(nextLine(text)); !header) {
        return std::unexpected(header.error());
    }
    for (std::size_t number = 2; !text.empty(); ++number) {
        const std::string_view line = nextLine(text);
        if (line.empty()) {
            continue;
        }
        if (auto row = table.readRow(line, number); !row) {
            return std::unexpected(row.error());
        }
    }
    if (table.path.segments.empty()) {
        return std::unexpected(damagedPlan(where, "there is no path in it"));
    }
    const auto single = std::ranges::find_if(
        table.path.segments, [](const PathSegment& segment) { return segment.samples.size() < 2; });
    if (single != table.path.segments.end()) {
        return std::unexpected(damagedPlan(
            where, message("segment {} has one sample only", single - table.path.segments.begin())));
    }
    return std::move(table.path);
}

}  // namespace furrow
