#include "planner/benchmarks/geos_yardstick.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace furrow {

namespace {

GEOSContextHandle_t handle() {
    struct Context {
        GEOSContextHandle_t value = GEOS_init_r();
        ~Context() { GEOS_finish_r(value); }
    };
    thread_local const Context context;
    return context.value;
}

struct Deleter {
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(handle(), geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Deleter>;

GEOSCoordSequence* sequenceOf(const std::vector<Point>& points) {
    GEOSCoordSequence* const sequence =
        GEOSCoordSeq_create_r(handle(), static_cast<unsigned>(points.size()), 2);
    for (unsigned i = 0; i < points.size(); ++i) {
        GEOSCoordSeq_setXY_r(handle(), sequence, i, points[i].x, points[i].y);
    }
    return sequence;
}

std::vector<Point> turnedRing(const Ring& ring, Angle heading) {
    const double c = std::cos(heading.si());
    const double s = std::sin(heading.si());
    std::vector<Point> turned;
    turned.reserve(ring.size() + 1);
    for (const Point& point : ring) {
        turned.push_back({c * point.x + s * point.y, c * point.y - s * point.x});
    }
    turned.push_back(turned.front());
    return turned;
}

Geometry turnedPolygon(const Polygon& polygon, Angle heading, const std::vector<Point>& outer) {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : polygon.holes) {
        holes.push_back(GEOSGeom_createLinearRing_r(handle(), sequenceOf(turnedRing(hole, heading))));
    }
    return Geometry{GEOSGeom_createPolygon_r(handle(),
                                             GEOSGeom_createLinearRing_r(handle(), sequenceOf(outer)),
                                             holes.data(), static_cast<unsigned>(holes.size()))};
}

Geometry collection(int type, std::vector<GEOSGeometry*>& parts) {
    return Geometry{
        GEOSGeom_createCollection_r(handle(), type, parts.data(), static_cast<unsigned>(parts.size()))};
}

Geometry rectangle(double fromX, double toX, double y, double half) {
    const std::vector<Point> corners{
        {fromX, y - half}, {toX, y - half}, {toX, y + half}, {fromX, y + half}, {fromX, y - half}};
    return Geometry{GEOSGeom_createPolygon_r(
        handle(), GEOSGeom_createLinearRing_r(handle(), sequenceOf(corners)), nullptr, 0)};
}

}  // namespace

PlainFigures plainFigures(const Polygon& mainland, Length width, Angle heading, bool withCoverage) {
    const std::vector<Point> outer = turnedRing(mainland.outer, heading);
    const auto [low, high] = std::ranges::minmax(outer, {}, &Point::y);
    const auto [left, right] = std::ranges::minmax(outer, {}, &Point::x);
    const Geometry polygon = turnedPolygon(mainland, heading, outer);
    const double half = 0.5 * width.si();
    std::vector<GEOSGeometry*> tracks;
    for (double y = low.y + half; y < high.y; y += width.si()) {
        tracks.push_back(
            GEOSGeom_createLineString_r(handle(), sequenceOf({{left.x - 1.0, y}, {right.x + 1.0, y}})));
    }
    const Geometry lines = collection(GEOS_MULTILINESTRING, tracks);
    const Geometry inside{GEOSIntersection_r(handle(), lines.get(), polygon.get())};
    PlainFigures figures;
    double lengthM = 0.0;
    GEOSLength_r(handle(), inside.get(), &lengthM);
    figures.length = metres(lengthM);
    figures.count = GEOSGetNumGeometries_r(handle(), inside.get());
    if (!withCoverage) {
        return figures;
    }
    std::vector<GEOSGeometry*> strips;
    for (int i = 0; i < figures.count; ++i) {
        const GEOSGeometry* const swath = GEOSGetGeometryN_r(handle(), inside.get(), i);
        double fromX = 0.0;
        double toX = 0.0;
        double y = 0.0;
        GEOSGeom_getXMin_r(handle(), swath, &fromX);
        GEOSGeom_getXMax_r(handle(), swath, &toX);
        GEOSGeom_getYMin_r(handle(), swath, &y);
        if (toX > fromX) {
            strips.push_back(rectangle(fromX, toX, y, half).release());
        }
    }
    const Geometry apart = collection(GEOS_MULTIPOLYGON, strips);
    const Geometry united{GEOSUnaryUnion_r(handle(), apart.get())};
    const Geometry covered{GEOSIntersection_r(handle(), united.get(), polygon.get())};
    double coveredM2 = 0.0;
    double wholeM2 = 1.0;
    GEOSArea_r(handle(), covered.get(), &coveredM2);
    GEOSArea_r(handle(), polygon.get(), &wholeM2);
    figures.coverage = coveredM2 / wholeM2;
    return figures;
}

}  // namespace furrow
