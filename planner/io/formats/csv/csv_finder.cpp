#include "planner/io/formats/csv/csv.h"

#include "planner/core/separated_text.h"
#include "planner/core/text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace furrow {

namespace {

/// Rings between brackets: "POLYGON ((1 2, 3 4, ...), (...))"; with `multi` each pair of outer brackets is a
/// polygon.
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
                (polygon.outer.empty() ? polygon.outer : polygon.holes.emplace_back()) =
                    std::exchange(ring, {});
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

void readBoundaries(std::string_view text, ReceivedContent& found) {
    nextLine(text);
    for (std::size_t number = 2; !text.empty(); ++number) {
        const std::vector<std::string> cells = quotedCellsOf(nextLine(text), ',');
        std::vector<GeoPolygon> polygons =
            cells.size() == 3 ? polygonsIn(cells[2]) : std::vector<GeoPolygon>{};
        if (polygons.empty()) {
            found.faults.push_back(badLine(number));
            return;
        }
        for (GeoPolygon& polygon : polygons) {
            found.areas.push_back({.kind = ReceivedArea::Kind::Field,
                                   .name = std::string{fromPlainCell(cells[1])},
                                   .rings = std::move(polygon),
                                   .statedM2 = std::nullopt});
        }
    }
}

void readPathTable(std::string_view text, ReceivedContent& found) {
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
    ReceivedPath path{.samples = {}, .knowsGear = true};
    for (std::size_t number = 2; !text.empty(); ++number) {
        const std::vector<std::string_view> cells = cellsOf(nextLine(text), ',');
        std::vector<double> values;
        for (const std::size_t column : at) {
            if (const auto value =
                    cells.size() == names.size() ? decimalIn(cells[column]) : std::optional<double>{}) {
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

}  // namespace

std::vector<ReceivedContent> findCsv(std::span<const FileInMemory> files, const ExportJob& job) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path});
        if (job.plan != nullptr) {
            readPathTable(file.bytes, found);
        } else {
            readBoundaries(file.bytes, found);
        }
    }
    return all;
}

}  // namespace furrow
