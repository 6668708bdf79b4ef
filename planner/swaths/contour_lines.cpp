#include "planner/swaths/contour_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace furrow {

namespace {

// Beyond three deviations the weight of a Gaussian is negligible.
constexpr double kReach = 3.0;

/// Blurs along rows or columns, over the known cells only.
std::vector<double> blurred(const ElevationGrid& grid, const std::vector<double>& values,
                            double deviationCells, bool rows) {
    const auto reach = static_cast<std::ptrdiff_t>(std::ceil(kReach * deviationCells));
    std::vector<double> weights;
    for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
        const double away = static_cast<double>(k) / deviationCells;
        weights.push_back(std::exp(-0.5 * away * away));
    }
    const auto columnCount = static_cast<std::ptrdiff_t>(grid.columns);
    const auto rowCount = static_cast<std::ptrdiff_t>(grid.rows);
    std::vector<double> result(values.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::ptrdiff_t row = 0; row < rowCount; ++row) {
        for (std::ptrdiff_t column = 0; column < columnCount; ++column) {
            const auto self = static_cast<std::size_t>(row * columnCount + column);
            if (!std::isfinite(values[self])) {
                continue;
            }
            double sum = 0.0;
            double weight = 0.0;
            for (std::ptrdiff_t k = -reach; k <= reach; ++k) {
                const std::ptrdiff_t r = rows ? row : row + k;
                const std::ptrdiff_t c = rows ? column + k : column;
                if (r < 0 || c < 0 || r >= rowCount || c >= columnCount) {
                    continue;
                }
                const double value = values[static_cast<std::size_t>(r * columnCount + c)];
                if (std::isfinite(value)) {
                    const double here = weights[static_cast<std::size_t>(k + reach)];
                    sum += here * value;
                    weight += here;
                }
            }
            result[self] = sum / weight;
        }
    }
    return result;
}

/// An edge between two neighbouring grid points, named by its lower left point; `up` to the north, else to
/// the east.
struct GridEdge {
    std::size_t column = 0;
    std::size_t row = 0;
    bool up = false;
    friend auto operator<=>(const GridEdge&, const GridEdge&) = default;
};

/// Links from one edge of a cell to another, uphill to the left.
using Links = std::map<GridEdge, GridEdge>;

Point placeOn(const ElevationGrid& grid, const GridEdge& edge, double heightM) {
    const double from = grid.at(edge.column, edge.row);
    const double to = edge.up ? grid.at(edge.column, edge.row + 1) : grid.at(edge.column + 1, edge.row);
    const double share = (heightM - from) / (to - from);
    const Point corner{static_cast<double>(edge.column), static_cast<double>(edge.row)};
    return grid.origin + grid.cellM * (corner + share * (edge.up ? Point{0.0, 1.0} : Point{1.0, 0.0}));
}

void addCell(const ElevationGrid& grid, std::size_t column, std::size_t row, double heightM, Links& links) {
    // Corners counter-clockwise from the lower left. Edge k goes from corner k to the next.
    const std::array<double, 4> heights{grid.at(column, row), grid.at(column + 1, row),
                                        grid.at(column + 1, row + 1), grid.at(column, row + 1)};
    if (!std::ranges::all_of(heights, [](double height) { return std::isfinite(height); })) {
        return;
    }
    const std::array<GridEdge, 4> edges{
        {{column, row, false}, {column + 1, row, true}, {column, row + 1, false}, {column, row, true}}};
    // Counter-clockwise round the cell, the line enters at the edge that goes up and leaves at the edge that
    // goes down. So uphill lies to its left.
    std::vector<std::size_t> enters;
    std::vector<std::size_t> leaves;
    for (std::size_t k = 0; k < 4; ++k) {
        const bool isUp = heights[k] >= heightM;
        const bool nextIsUp = heights[(k + 1) % 4] >= heightM;
        if (isUp && !nextIsUp) {
            enters.push_back(k);
        } else if (!isUp && nextIsUp) {
            leaves.push_back(k);
        }
    }
    if (enters.size() == 2) {
        // A saddle: the height of the middle decides which of the two corners belong together.
        const double middle = 0.25 * (heights[0] + heights[1] + heights[2] + heights[3]);
        const bool joinsHigh = middle >= heightM;
        for (const std::size_t from : enters) {
            const std::size_t to = joinsHigh ? (from + 1) % 4 : (from + 3) % 4;
            links.emplace(edges[from], edges[to]);
        }
        return;
    }
    if (enters.size() == 1) {
        links.emplace(edges[enters.front()], edges[leaves.front()]);
    }
}

}  // namespace

std::optional<double> heightAt(const ElevationGrid& grid, Point place) {
    const Point cells = (1.0 / grid.cellM) * (place - grid.origin);
    const double column = std::floor(cells.x);
    const double row = std::floor(cells.y);
    if (column < 0.0 || row < 0.0 || column + 1.0 >= static_cast<double>(grid.columns) ||
        row + 1.0 >= static_cast<double>(grid.rows)) {
        return std::nullopt;
    }
    const auto c = static_cast<std::size_t>(column);
    const auto r = static_cast<std::size_t>(row);
    const double x = cells.x - column;
    const double y = cells.y - row;
    const double height = (1.0 - y) * ((1.0 - x) * grid.at(c, r) + x * grid.at(c + 1, r)) +
                          y * ((1.0 - x) * grid.at(c, r + 1) + x * grid.at(c + 1, r + 1));
    return std::isfinite(height) ? std::optional{height} : std::nullopt;
}

ElevationGrid smoothed(const ElevationGrid& grid, Length radius) {
    const double deviationCells = radius.si() / grid.cellM;
    ElevationGrid even = grid;
    if (deviationCells > 0.3) {
        even.heightsM =
            blurred(grid, blurred(grid, grid.heightsM, deviationCells, true), deviationCells, false);
    }
    return even;
}

std::vector<Polyline> contourLines(const ElevationGrid& grid, double heightM) {
    Links links;
    for (std::size_t row = 0; row + 1 < grid.rows; ++row) {
        for (std::size_t column = 0; column + 1 < grid.columns; ++column) {
            addCell(grid, column, row, heightM, links);
        }
    }
    // Open lines begin at an edge without a link to it. The remaining links are rings.
    std::map<GridEdge, int> arrivals;
    for (const auto& [from, to] : links) {
        ++arrivals[to];
    }
    std::vector<Polyline> lines;
    const auto follow = [&](GridEdge edge) {
        Polyline line{placeOn(grid, edge, heightM)};
        for (auto next = links.find(edge); next != links.end(); next = links.find(edge)) {
            edge = next->second;
            links.erase(next);
            line.push_back(placeOn(grid, edge, heightM));
        }
        lines.push_back(std::move(line));
    };
    std::vector<GridEdge> begins;
    for (const auto& [from, to] : links) {
        if (!arrivals.contains(from)) {
            begins.push_back(from);
        }
    }
    std::ranges::for_each(begins, follow);
    while (!links.empty()) {
        follow(links.begin()->first);
    }
    return lines;
}

}  // namespace furrow
