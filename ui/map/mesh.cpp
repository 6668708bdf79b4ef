#include "ui/map/mesh.h"

#include <algorithm>
#include <cmath>

namespace furrow {

void LineMesh::add(std::span<const MapPoint> line, bool closed) {
    if (line.size() == 1) {
        addSegment(line[0], line[0], 0.0F);
        return;
    }
    float way = 0.0F;
    const std::size_t segments = closed ? line.size() : line.size() - (line.empty() ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) {
        const MapPoint from = line[i];
        const MapPoint to = line[i + 1 == line.size() ? 0 : i + 1];
        addSegment(from, to, way);
        way += std::hypot(to.x - from.x, to.y - from.y);
    }
}

void LineMesh::addSegment(MapPoint from, MapPoint to, float way) {
    const MapPoint delta{to.x - from.x, to.y - from.y};
    vertices_.push_back({from, delta, 0.0F, -1.0F, way});
    vertices_.push_back({from, delta, 0.0F, 1.0F, way});
    vertices_.push_back({from, delta, 1.0F, -1.0F, way});
    vertices_.push_back({from, delta, 1.0F, 1.0F, way});
}

QRectF boxOf(std::span<const MapPoint> points) {
    if (points.empty()) {
        return {};
    }
    MapPoint low = points.front();
    MapPoint high = low;
    for (const MapPoint point : points) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
    }
    return {low.x, low.y, high.x - low.x, high.y - low.y};
}

}  // namespace furrow
