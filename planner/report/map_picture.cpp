#include "planner/report/map_picture.h"

#include "planner/report/svg_document.h"
#include "planner/report/ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow {

namespace {

constexpr double kFinestPx = 0.3;

bool isFinite(Point point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
}

struct Extent {
    Point min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    void add(std::span<const Point> points) {
        for (const Point& point : points) {
            if (isFinite(point)) {
                min = {std::min(min.x, point.x), std::min(min.y, point.y)};
                max = {std::max(max.x, point.x), std::max(max.y, point.y)};
            }
        }
    }
    bool empty() const { return min.x > max.x; }
};

Extent extentOf(const MapPicture& picture) {
    Extent extent;
    for (const MapLayer& layer : picture.layers) {
        for (const Polygon& area : layer.areas) {
            extent.add(area.outer);
        }
        for (const Polyline& line : layer.lines) {
            extent.add(line);
        }
    }
    return extent;
}

/// "50 m", "2 km"
std::string lengthLabel(double metres) {
    return metres >= 1000.0 ? tickLabel(metres / 1000.0, 1.0) + " km" : tickLabel(metres, metres) + " m";
}

class MapDrawing {
public:
    explicit MapDrawing(const MapPicture& picture) : picture_{picture}, extent_{extentOf(picture)} {}

    /// @return the height that was used
    double draw(SvgDocument& svg) {
        double top = kMarginPx;
        const double across = picture_.width - 2.0 * kMarginPx;
        for (const std::string& line : wrapped(picture_.title, kTitleSize * 1.12, across)) {
            top += kTitleSize + 2.0;
            svg.text({kMarginPx, top}, line, {.size = kTitleSize, .bold = true});
        }
        for (const std::string& line : wrapped(picture_.note, kTextSize, across)) {
            top += kLinePx;
            svg.text({kMarginPx, top}, line, {.size = kTextSize, .colour = kQuiet});
        }
        top += 14.0;
        if (extent_.empty()) {
            svg.text({kMarginPx, top + kLinePx}, "There is nothing to show.", {.colour = kQuiet});
            return top + 3.0 * kLinePx;
        }
        const Point size = extent_.max - extent_.min;
        const double largest = std::max({size.x, size.y, 1e-3});
        pxPerM_ = std::min(across / std::max(size.x, 0.02 * largest),
                           picture_.largestHeight / std::max(size.y, 0.02 * largest));
        origin_ = {kMarginPx + 0.5 * (across - pxPerM_ * size.x), top};
        for (const MapLayer& layer : picture_.layers) {
            drawLayer(svg, layer);
        }
        return drawBelow(svg, top + pxPerM_ * size.y + 30.0);
    }

private:
    Point px(Point point) const {
        return {origin_.x + pxPerM_ * (point.x - extent_.min.x),
                origin_.y + pxPerM_ * (extent_.max.y - point.y)};
    }

    /// Without points that are too close to see; what is not finite parts a line.
    std::vector<std::vector<Point>> shown(std::span<const Point> points) const {
        std::vector<std::vector<Point>> runs(1);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!isFinite(points[i])) {
                runs.emplace_back();
                continue;
            }
            const Point at = px(points[i]);
            std::vector<Point>& run = runs.back();
            if (run.empty() || distance(run.back(), at) >= kFinestPx || i + 1 == points.size()) {
                run.push_back(at);
            }
        }
        return runs;
    }

    void drawLayer(SvgDocument& svg, const MapLayer& layer) const {
        const SvgStyle style{
            .fill = layer.fill, .stroke = layer.stroke, .width = layer.width, .dash = layer.dash};
        for (const Polygon& area : layer.areas) {
            std::vector<std::vector<Point>> rings{shown(area.outer).front()};
            for (const Ring& hole : area.holes) {
                rings.push_back(shown(hole).front());
            }
            svg.polygon(rings, style);
        }
        for (const Polyline& line : layer.lines) {
            for (const std::vector<Point>& run : shown(line)) {
                svg.polyline(run, {.stroke = layer.stroke, .width = layer.width, .dash = layer.dash});
                if (layer.arrows) {
                    drawArrow(svg, run, layer);
                }
            }
        }
    }

    /// A small head in the middle of a line that is long enough to carry it.
    static void drawArrow(SvgDocument& svg, const std::vector<Point>& run, const MapLayer& layer) {
        constexpr double kSizePx = 3.5;
        const double length = lengthM(run);
        if (length < 6.0 * kSizePx) {
            return;
        }
        double left = 0.5 * length;
        for (std::size_t i = 1; i < run.size(); ++i) {
            const double step = distance(run[i - 1], run[i]);
            if (step >= left && step > 0.0) {
                const Point along = (1.0 / step) * (run[i] - run[i - 1]);
                const Point tip = run[i - 1] + (left + kSizePx) * along;
                const Point across{-along.y, along.x};
                const std::vector<Point> head{tip, tip - 2.0 * kSizePx * along + kSizePx * across,
                                              tip - 2.0 * kSizePx * along - kSizePx * across};
                svg.polygon({&head, 1}, {.fill = layer.stroke});
                return;
            }
            left -= step;
        }
    }

    /// Scale bar and legend. @return the height that was used
    double drawBelow(SvgDocument& svg, double top) const {
        const double barM = roundedDown(0.25 * (picture_.width - 2.0 * kMarginPx) / pxPerM_);
        const double barPx = barM * pxPerM_;
        const SvgStyle ink{.stroke = "#1f2933", .width = 1.5};
        svg.line({kMarginPx, top}, {kMarginPx + barPx, top}, ink);
        svg.line({kMarginPx, top - 4.0}, {kMarginPx, top + 4.0}, ink);
        svg.line({kMarginPx + barPx, top - 4.0}, {kMarginPx + barPx, top + 4.0}, ink);
        svg.text({kMarginPx + barPx + 8.0, top + 4.0}, lengthLabel(barM), {.size = kTextSize});
        double x = kMarginPx;
        double y = top + 28.0;
        for (const MapLayer& layer : picture_.layers) {
            if (layer.name.empty()) {
                continue;
            }
            const double width = 30.0 + textWidth(layer.name, kTextSize) + 18.0;
            if (x > kMarginPx && x + width > picture_.width - kMarginPx) {
                x = kMarginPx;
                y += kLinePx + 2.0;
            }
            if (!layer.fill.empty()) {
                svg.rectangle({x, y - 10.0}, 22.0, 12.0,
                              {.fill = layer.fill, .stroke = layer.stroke, .width = 1.0});
            } else {
                svg.line({x, y - 4.0}, {x + 22.0, y - 4.0},
                         {.stroke = layer.stroke, .width = std::max(layer.width, 1.2), .dash = layer.dash});
            }
            svg.text({x + 30.0, y}, layer.name, {.size = kTextSize});
            x += width;
        }
        return y + 14.0;
    }

    const MapPicture& picture_;
    Extent extent_;
    double pxPerM_ = 1.0;
    Point origin_;
};

}  // namespace

std::string svgOf(const MapPicture& picture) {
    SvgDocument svg;
    const double height = MapDrawing{picture}.draw(svg);
    return svg.file(picture.width, height, picture.title);
}

std::string svgOf(std::span<const MapPicture> pictures, int columns, const std::string& title,
                  const std::string& note) {
    std::vector<SvgPart> parts;
    for (const MapPicture& picture : pictures) {
        SvgPart part{.picture = {}, .width = picture.width};
        part.height = MapDrawing{picture}.draw(part.picture);
        parts.push_back(std::move(part));
    }
    return svgGrid(parts, columns, title, note);
}

}  // namespace furrow
