#pragma once

#include "ui/map/map_frame.h"

#include <QRectF>

#include <span>
#include <vector>

namespace furrow {

/// One corner of the rectangle that a segment is drawn as; see shaders/line.vert.
struct LineVertex {
    MapPoint start;
    MapPoint delta;
    float atEnd = 0.0F;
    float side = 0.0F;
    float way = 0.0F;
};

/// Lines ready for the scene graph: four vertices for each segment.
class LineMesh {
public:
    /// Adds a line; a single point becomes a disc. A closed one ends where it begins.
    void add(std::span<const MapPoint> line, bool closed = false);
    const std::vector<LineVertex>& vertices() const { return vertices_; }
    bool isEmpty() const { return vertices_.empty(); }

private:
    void addSegment(MapPoint from, MapPoint to, float way);
    std::vector<LineVertex> vertices_;
};

/// Areas ready for the scene graph: three corners for each triangle.
using FillMesh = std::vector<MapPoint>;

/// Of points; empty for none.
QRectF boxOf(std::span<const MapPoint> points);

}  // namespace furrow
