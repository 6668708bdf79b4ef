#include "ui/map/cell_drawing.h"

#include "ui/map/even_odd_fill.h"

namespace furrow {

namespace {

void add(FillMesh& fill, LineMesh& edges, const MapFrame& frame, const std::vector<MultiPolygon>& cells) {
    for (const MultiPolygon& cell : cells) {
        std::vector<std::vector<MapPoint>> rings;
        for (const Polygon& polygon : cell) {
            rings.push_back(frame.map(polygon.outer));
            for (const Ring& hole : polygon.holes) {
                rings.push_back(frame.map(hole));
            }
        }
        for (const std::vector<MapPoint>& ring : rings) {
            edges.add(ring, true);
        }
        const FillMesh triangles = evenOddTriangles(rings);
        fill.insert(fill.end(), triangles.begin(), triangles.end());
    }
}

}  // namespace

CellGeometry cellGeometry(const LocalFrame& local, const std::vector<MultiPolygon>& cells,
                          const std::vector<MultiPolygon>& joined) {
    const MapFrame frame{local};
    CellGeometry geometry;
    geometry.origin = frame.origin();
    add(geometry.cells, geometry.edges, frame, cells);
    add(geometry.joined, geometry.joinedEdges, frame, joined);
    return geometry;
}

}  // namespace furrow
