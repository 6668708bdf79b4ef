#include "planner/io/formats/csv/path_csv.h"

#include "planner/core/separated_text.h"
#include "planner/io/content/plan_error.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <format>
#include <iterator>
#include <vector>

namespace furrow {

namespace {

enum Column {
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
        return {};
    }

    Result<void> readRow(std::string_view line, std::size_t number) {
        const Message place = message("{}, line {}", where_, number);
        const std::vector<std::string_view> cells = cellsOf(line, ',');
        std::array<double, kNumbers> value{};
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string_view cell = at_[i] < cells.size() ? cells[at_[i]] : std::string_view{};
            const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value[i]);
            if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value[i])) {
                return std::unexpected(
                    damagedPlan(place, message("{} is '{}', which is no number", kColumns[i], cell)));
            }
        }
        const std::string_view kindId = at_[kKind] < cells.size() ? cells[at_[kKind]] : std::string_view{};
        const auto kind = segmentKindFrom(kindId);
        if (!kind) {
            return std::unexpected(damagedPlan(place, message("'{}' is no kind of segment", kindId)));
        }
        if (path.segments.empty() || value[kOrder] != order_) {
            order_ = value[kOrder];
            path.segments.push_back({.kind = *kind,
                                     .gear = value[kGear] < 0.0 ? Gear::Reverse : Gear::Forward,
                                     .implementDown = value[kDown] != 0.0});
        }
        path.segments.back().samples.push_back({.sM = value[kS],
                                                .tS = value[kT],
                                                .position = {value[kX], value[kY]},
                                                .headingRad = value[kHeading],
                                                .curvature1pm = value[kCurvature],
                                                .speedMps = value[kSpeed]});
        return {};
    }

    Path path;

private:
    const std::string& where_;
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
            std::format_to(out, "{},{},{},{},{},{},{},{},{},{},{},{},{},0,\n", sample.sM, sample.tS,
                           sample.position.x, sample.position.y, places[i].lonDeg, places[i].latDeg,
                           sample.headingRad, sample.curvature1pm, sample.speedMps,
                           static_cast<int>(segment.gear), segment.implementDown ? 1 : 0,
                           segmentKindId(segment.kind), order);
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
