#include "ui/project/field_outline.h"

#include "ui/map/map_frame.h"

#include <algorithm>
#include <cmath>

namespace furrow {

QList<QPointF> fieldOutline(const FieldSource& field) {
    constexpr std::size_t kMostPoints = 120;
    if (field.parts.empty() || field.parts.front().outer.size() < 3) {
        return {};
    }
    const GeoRing& ring = field.parts.front().outer;
    const std::size_t step = ring.size() / kMostPoints + 1;
    const WorldPoint origin = worldPoint(ring.front());
    QList<QPointF> points;
    for (std::size_t i = 0; i < ring.size(); i += step) {
        const MapPoint point = mapPoint(worldPoint(ring[i]), origin);
        if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
            return {};
        }
        points.emplace_back(double{point.x}, double{point.y});
    }
    const auto [left, right] = std::ranges::minmax(points, {}, &QPointF::x);
    const auto [top, bottom] = std::ranges::minmax(points, {}, &QPointF::y);
    const double size = std::max({right.x() - left.x(), bottom.y() - top.y(), 1e-6});
    const QPointF corner{(left.x() + right.x() - size) / 2.0, (top.y() + bottom.y() - size) / 2.0};
    for (QPointF& point : points) {
        point = (point - corner) / size;
    }
    points.push_back(points.front());
    return points;
}

}  // namespace furrow
