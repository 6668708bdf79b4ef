#include "planner/report/chart.h"

#include "planner/report/svg_document.h"
#include "planner/report/ticks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace furrow {

namespace {

constexpr std::string_view kGridColour = "#e4e7eb";
constexpr std::string_view kAxisColour = "#7b8794";

std::string_view colourOf(int index) {
    return kPalette[static_cast<std::size_t>(std::max(0, index)) % std::size(kPalette)];
}

bool drawable(Point point, const Chart& chart) {
    return std::isfinite(point.x) && std::isfinite(point.y) &&
           (chart.x.scale == AxisScale::Linear || point.x > 0.0) &&
           (chart.y.scale == AxisScale::Linear || point.y > 0.0);
}

struct Range {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();

    void add(double value) {
        min = std::min(min, value);
        max = std::max(max, value);
    }
    bool empty() const { return min > max; }
};

/// One axis: values to pixels.
class Axis {
public:
    Axis(const ChartAxis& axis, Range range, int count) : scale_{axis.scale} {
        if (scale_ == AxisScale::Linear && range.min > 0.0 && range.min < 0.4 * range.max) {
            range.min = 0.0;
        }
        range.min = axis.min.value_or(range.min);
        range.max = std::max(range.min, axis.max.value_or(range.max));
        if (scale_ == AxisScale::Log) {
            ticks_ = logTicks(range.min, range.max);
        } else if (axis.step && range.max > range.min) {
            ticks_ = steppedTicks(range.min, range.max, *axis.step);
        } else {
            ticks_ = linearTicks(range.min, range.max, count);
        }
    }

    void place(double fromPx, double toPx) {
        fromPx_ = fromPx;
        toPx_ = toPx;
    }

    double px(double value) const {
        const double share = scale_ == AxisScale::Log
                                 ? std::log(value / ticks_.min) / std::log(ticks_.max / ticks_.min)
                                 : (value - ticks_.min) / (ticks_.max - ticks_.min);
        return fromPx_ + share * (toPx_ - fromPx_);
    }

    const Ticks& ticks() const { return ticks_; }
    bool holds(double value) const { return value >= ticks_.min && value <= ticks_.max; }

    double widestLabel() const {
        double widest = 0.0;
        for (const std::string& label : ticks_.labels) {
            widest = std::max(widest, textWidth(label, kTextSize));
        }
        return widest;
    }

private:
    AxisScale scale_;
    Ticks ticks_;
    double fromPx_ = 0.0;
    double toPx_ = 1.0;
};

void drawMark(SvgDocument& svg, Marks marks, Point at, std::string_view colour) {
    constexpr double r = 3.2;
    switch (marks) {
        case Marks::None: break;
        case Marks::Dots: svg.circle(at, r, {.fill = colour, .opacity = 0.8}); break;
        case Marks::Rings: svg.circle(at, r, {.stroke = colour, .width = 1.5}); break;
        case Marks::Squares:
            svg.rectangle(at - Point{r, r}, 2 * r, 2 * r, {.stroke = colour, .width = 1.5});
            break;
        case Marks::Crosses:
            svg.line(at - Point{r, r}, at + Point{r, r}, {.stroke = colour, .width = 1.5});
            svg.line(at + Point{-r, r}, at + Point{r, -r}, {.stroke = colour, .width = 1.5});
            break;
    }
}

/// Draws one chart into a document, from its top left corner.
class ChartDrawing {
public:
    explicit ChartDrawing(const Chart& chart) : chart_{chart} {}

    /// @return the height that was used
    double draw(SvgDocument& svg) {
        double top = drawTitle(svg);
        Range x;
        Range y;
        for (const ChartSeries& series : chart_.series) {
            for (const Point& point : series.points) {
                if (drawable(point, chart_)) {
                    x.add(point.x);
                    y.add(point.y);
                }
            }
        }
        if (x.empty()) {
            svg.text({kMarginPx, top + kLinePx}, "There is nothing to show.", {.colour = kQuiet});
            return chart_.height;
        }
        if (chart_.oneToOne) {
            x = {std::min(x.min, y.min), std::max(x.max, y.max)};
            y = x;
        }
        const double bottom = chart_.height - 2.0 * kLinePx - 8.0;
        Axis vertical{chart_.y, y, std::max(2, static_cast<int>((bottom - top) / 45.0))};
        const double left = kMarginPx + std::ceil(vertical.widestLabel()) + 8.0;
        // Half of the last label stands out on the right.
        const double right = chart_.width - kMarginPx - 20.0;
        Axis horizontal = horizontalAxis(x, right - left);
        top += kLinePx;  // for the title of the vertical axis
        horizontal.place(left, right);
        vertical.place(bottom, top);
        drawAxes(svg, horizontal, vertical, {left, right}, {top, bottom});
        for (const ChartSeries& series : chart_.series) {
            drawSeries(svg, series, horizontal, vertical);
        }
        return drawLegend(svg, chart_.height);
    }

private:
    double drawTitle(SvgDocument& svg) const {
        double at = kMarginPx;
        for (const std::string& line :
             wrapped(chart_.title, kTitleSize * 1.12, chart_.width - 2 * kMarginPx)) {
            at += kTitleSize + 2.0;
            svg.text({kMarginPx, at}, line, {.size = kTitleSize, .bold = true});
        }
        for (const std::string& line : wrapped(chart_.note, kTextSize, chart_.width - 2 * kMarginPx)) {
            at += kLinePx;
            svg.text({kMarginPx, at}, line, {.size = kTextSize, .colour = kQuiet});
        }
        return at + 12.0;
    }

    /// With as many marks as their labels leave room for.
    Axis horizontalAxis(Range range, double width) const {
        for (int count = std::max(2, static_cast<int>(width / 60.0)); count > 1; --count) {
            Axis axis{chart_.x, range, count};
            const auto labels = static_cast<double>(axis.ticks().labels.size());
            if (labels * (axis.widestLabel() + 14.0) <= width || chart_.x.scale == AxisScale::Log) {
                return axis;
            }
        }
        return Axis{chart_.x, range, 1};
    }

    void drawAxes(SvgDocument& svg, const Axis& horizontal, const Axis& vertical, Point leftRight,
                  Point topBottom) const {
        double lastLabelEnd = -1e9;
        for (std::size_t i = 0; i < horizontal.ticks().values.size(); ++i) {
            const double x = horizontal.px(horizontal.ticks().values[i]);
            const std::string& label = horizontal.ticks().labels[i];
            svg.line({x, topBottom.x}, {x, topBottom.y}, {.stroke = kGridColour});
            const double half = 0.5 * textWidth(label, kTextSize);
            if (x - half > lastLabelEnd + 6.0) {
                svg.text({x, topBottom.y + 16.0}, label,
                         {.size = kTextSize, .colour = kQuiet, .anchor = TextAnchor::Middle});
                lastLabelEnd = x + half;
            }
        }
        double lastLabelY = 1e9;
        for (std::size_t i = 0; i < vertical.ticks().values.size(); ++i) {
            const double y = vertical.px(vertical.ticks().values[i]);
            svg.line({leftRight.x, y}, {leftRight.y, y}, {.stroke = kGridColour});
            if (y + kLinePx <= lastLabelY) {
                svg.text({leftRight.x - 6.0, y + 4.0}, vertical.ticks().labels[i],
                         {.size = kTextSize, .colour = kQuiet, .anchor = TextAnchor::End});
                lastLabelY = y;
            }
        }
        svg.line({leftRight.x, topBottom.y}, {leftRight.y, topBottom.y}, {.stroke = kAxisColour});
        svg.line({leftRight.x, topBottom.x}, {leftRight.x, topBottom.y}, {.stroke = kAxisColour});
        if (chart_.oneToOne) {
            const double low = std::max(horizontal.ticks().min, vertical.ticks().min);
            const double high = std::min(horizontal.ticks().max, vertical.ticks().max);
            svg.line({horizontal.px(low), vertical.px(low)}, {horizontal.px(high), vertical.px(high)},
                     {.stroke = kAxisColour, .width = 1.2, .dash = "5 4"});
        }
        svg.text({kMarginPx, topBottom.x - 10.0}, chart_.y.title, {.size = kTextSize});
        svg.text({0.5 * (leftRight.x + leftRight.y), topBottom.y + 16.0 + kLinePx + 2.0}, chart_.x.title,
                 {.size = kTextSize, .anchor = TextAnchor::Middle});
    }

    void drawSeries(SvgDocument& svg, const ChartSeries& series, const Axis& horizontal,
                    const Axis& vertical) const {
        const std::string_view colour = colourOf(series.colour);
        std::vector<Point> run;
        const auto finishRun = [&] {
            if (series.line) {
                svg.polyline(run, {.stroke = colour, .width = 1.8, .dash = series.dashed ? "6 4" : ""});
            }
            run.clear();
        };
        for (const Point& point : series.points) {
            // Outside of a range that was asked for nothing is drawn.
            if (!drawable(point, chart_) || !horizontal.holds(point.x) || !vertical.holds(point.y)) {
                finishRun();
                continue;
            }
            run.push_back({horizontal.px(point.x), vertical.px(point.y)});
            drawMark(svg, series.marks, run.back(), colour);
        }
        finishRun();
    }

    double drawLegend(SvgDocument& svg, double top) const {
        double x = kMarginPx;
        double y = top + 16.0;
        bool any = false;
        const auto entry = [&](const std::string& name, auto drawSample) {
            const double width = 26.0 + textWidth(name, kTextSize) + 18.0;
            if (any && x + width > chart_.width - kMarginPx) {
                x = kMarginPx;
                y += kLinePx + 2.0;
            }
            drawSample(Point{x + 10.0, y - 4.0});
            svg.text({x + 26.0, y}, name, {.size = kTextSize});
            x += width;
            any = true;
        };
        for (const ChartSeries& series : chart_.series) {
            if (series.name.empty() || series.points.empty()) {
                continue;
            }
            entry(series.name, [&](Point at) {
                const std::string_view colour = colourOf(series.colour);
                if (series.line) {
                    svg.line(at - Point{10.0, 0.0}, at + Point{10.0, 0.0},
                             {.stroke = colour, .width = 1.8, .dash = series.dashed ? "6 4" : ""});
                }
                drawMark(svg, series.marks, at, colour);
            });
        }
        if (chart_.oneToOne) {
            entry("1 : 1", [&](Point at) {
                svg.line(at - Point{10.0, 0.0}, at + Point{10.0, 0.0},
                         {.stroke = kAxisColour, .width = 1.2, .dash = "5 4"});
            });
        }
        return any ? y + 14.0 : top;
    }

    const Chart& chart_;
};

}  // namespace

std::string svgOf(const Chart& chart) {
    SvgDocument svg;
    const double height = ChartDrawing{chart}.draw(svg);
    return svg.file(chart.width, height, chart.title);
}

std::string svgOf(std::span<const Chart> charts, int columns, const std::string& title,
                  const std::string& note) {
    std::vector<SvgPart> parts;
    for (const Chart& chart : charts) {
        SvgPart part{.picture = {}, .width = chart.width};
        part.height = ChartDrawing{chart}.draw(part.picture);
        parts.push_back(std::move(part));
    }
    return svgGrid(parts, columns, title, note);
}

}  // namespace furrow
