#include "planner/core/separated_text.h"
#include "planner/io/content/export_job.h"
#include "planner/io/content/received_content.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace furrow {

namespace {

/// Rings between brackets: "POLYGON ((1 2, 3 4, ...), (...))"; with `multi` each pair of outer brackets is a polygon.
std::vector<GeoPolygon> polygonsIn(std::string_view wkt) {
    const int ringDepth = wkt.starts_with("MULTI") ? 3 : 2;
    std::vector<GeoPolygon> polygons;
    int depth = 0;
    GeoRing ring;
    std::string number;
    std::vector<double> numbers;
    const auto endPoint = [&] {
        if (numbers.size() == 2) {
            ring.push_back({numbers[0], numbers[1]});
        }
        numbers.clear();
    };
    const auto endNumber = [&] {
        if (const auto value = decimalIn(number)) {
            numbers.push_back(*value);
        }
        number.clear();
    };
    for (const char letter : wkt) {
        if (letter == '(') {
            ++depth;
            if (depth == ringDepth - 1) {
                polygons.emplace_back();
            }
        } else if (letter == ')') {
            endNumber();
            endPoint();
            if (depth == ringDepth && !polygons.empty()) {
                GeoPolygon& polygon = polygons.back();
                (polygon.outer.empty() ? polygon.outer : polygon.holes.emplace_back()) = std::exchange(ring, {});
            }
            --depth;
        } else if (depth == ringDepth && letter == ',') {
            endNumber();
            endPoint();
        } else if (depth == ringDepth && letter == ' ') {
            endNumber();
        } else if (depth == ringDepth) {
            number += letter;
        }
    }
    return polygons;
}

void readBoundaries(std::string_view text, FoundContent& found) {
    nextLine(text);
    for (std::size_t number = 2; !text.empty(); ++number) {
        const std::vector<std::string> cells = quotedCellsOf(nextLine(text), ',');
        std::vector<GeoPolygon> polygons = cells.size() == 3 ? polygonsIn(cells[2]) : std::vector<GeoPolygon>{};
        if (polygons.empty()) {
            found.faults.push_back(badLine(number));
            return;
        }
        for (GeoPolygon& polygon : polygons) {
            found.areas.push_back(
                {.kind = FoundArea::Kind::Field, .name = cells[1], .rings = std::move(polygon), .statedM2 = std::nullopt});
        }
    }
}

void readPathTable(std::string_view text, FoundContent& found) {
    const std::vector<std::string_view> names = cellsOf(nextLine(text), ',');
    constexpr std::array<std::string_view, 6> kColumns = {"t_s",         "lon_deg",   "lat_deg",
                                                          "heading_rad", "speed_mps", "gear"};
    std::array<std::size_t, kColumns.size()> at{};
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
        at[i] = static_cast<std::size_t>(std::ranges::find(names, kColumns[i]) - names.begin());
        if (at[i] == names.size()) {
            found.faults.push_back(isMissing(kColumns[i]));
            return;
        }
    }
    FoundPath path{.samples = {}, .knowsGear = true};
    for (std::size_t number = 2; !text.empty(); ++number) {
        const std::vector<std::string_view> cells = cellsOf(nextLine(text), ',');
        std::vector<double> values;
        for (const std::size_t column : at) {
            if (const auto value = cells.size() == names.size() ? decimalIn(cells[column]) : std::optional<double>{}) {
                values.push_back(*value);
            }
        }
        if (values.size() != kColumns.size()) {
            found.faults.push_back(badLine(number));
            break;
        }
        path.samples.push_back({.geo = {values[1], values[2]},
                                .timeS = values[0],
                                .headingRad = values[3],
                                .speedMps = values[4],
                                .reverse = values[5] < 0.0});
    }
    found.paths.push_back(std::move(path));
}

// MAV_CMD that are written, and MAV_FRAME
constexpr std::int64_t kWaypoint = 16;
constexpr std::array<std::int64_t, 4> kCommands = {kWaypoint, 178, 181, 194};
constexpr double kAbsolute = 0.0;
constexpr double kRelative = 3.0;

}  // namespace

std::vector<FoundContent> findCsv(std::span<const ExportedFile> files, const ExportJob& job) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path});
        if (job.plan != nullptr) {
            readPathTable(file.bytes, found);
        } else {
            readBoundaries(file.bytes, found);
        }
    }
    return all;
}

std::vector<FoundContent> findWaypoints(std::span<const ExportedFile> files, const ExportJob&) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path});
        std::string_view text = file.bytes;
        if (nextLine(text) != "QGC WPL 110") {
            found.faults.push_back(badLine(1));
            continue;
        }
        FoundOrder rows;
        FoundPath path;
        for (std::size_t number = 2; !text.empty(); ++number) {
            const std::vector<std::string_view> cells = cellsOf(nextLine(text), '\t');
            std::vector<double> values;
            for (const std::string_view cell : cells) {
                if (const auto value = decimalIn(cell)) {
                    values.push_back(*value);
                }
            }
            constexpr std::size_t kColumns = 12;
            const bool isHome = number == 2;
            const bool good = cells.size() == kColumns && values.size() == kColumns && values[1] == (isHome ? 1.0 : 0.0) &&
                              values[2] == (isHome ? kAbsolute : kRelative) &&
                              std::ranges::contains(kCommands, static_cast<std::int64_t>(values[3]));
            if (!good) {
                found.faults.push_back(badLine(number));
                break;
            }
            rows.numbers.push_back(static_cast<std::int64_t>(values[0]));
            const GeoPoint place{values[9], values[8]};
            if (isHome) {
                found.points.push_back(place);
            } else if (static_cast<std::int64_t>(values[3]) == kWaypoint) {
                path.samples.push_back({.geo = place});
            }
        }
        found.orders.push_back(std::move(rows));
        found.paths.push_back(std::move(path));
    }
    return all;
}

}  // namespace furrow
