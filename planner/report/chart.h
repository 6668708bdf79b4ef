#pragma once

#include "planner/geometry/point.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace furrow {

enum class AxisScale { Linear, Log };

struct ChartAxis {
    std::string title;  ///< with its unit: "Area (ha)"
    AxisScale scale = AxisScale::Linear;
    std::optional<double> min;  ///< otherwise as the data needs; linear axes start at 0 if that is near
    std::optional<double> max;
    std::optional<double> step;  ///< between the marks of a linear axis; > 0
};

enum class Marks { None, Dots, Rings, Squares, Crosses };

/// Points in data units. Those that are not finite, or not positive on a logarithmic axis, are left out and
/// interrupt the line.
struct ChartSeries {
    std::string name;  ///< in the legend; empty for none
    std::vector<Point> points;
    Marks marks = Marks::Dots;
    bool line = false;
    bool dashed = false;
    int colour = 0;  ///< of kPalette, taken around
};

/// A scatter or line chart.
struct Chart {
    std::string title;
    std::string note;  ///< one or two sentences under the title
    ChartAxis x;
    ChartAxis y;
    std::vector<ChartSeries> series;
    bool oneToOne = false;  ///< the line y = x, and the same range on both axes
    double width = 640.0;   ///< pixels
    double height = 460.0;  ///< of plot, axes and title; a legend comes below
};

/// As an SVG file: light ground, round numbers at the axes, texts that do not overlap, colours that
/// colour-blind people tell apart and marks that differ as well. A chart without points says so.
std::string svgOf(const Chart& chart);

/// Several charts in one file, row by row, under one title; each keeps its own axes.
std::string svgOf(std::span<const Chart> charts, int columns, const std::string& title,
                  const std::string& note);

}  // namespace furrow
