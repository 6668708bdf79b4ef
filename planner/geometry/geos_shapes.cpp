#include "planner/geometry/geos_shapes.h"

#include <algorithm>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace furrow::geos {

namespace {

// GEOS calls this from time to time within its long loops.
thread_local const JobContext* runningJob = nullptr;

void interruptWhenStopped() {
    if (runningJob != nullptr && runningJob->stopRequested()) {
        GEOS_interruptRequest();
    }
}

struct Context {
    GEOSContextHandle_t handle = GEOS_init_r();
    std::string message;

    Context() {
        static std::once_flag registered;
        std::call_once(registered, [] { GEOS_interruptRegisterCallback(interruptWhenStopped); });
        GEOSContext_setErrorMessageHandler_r(
            handle, [](const char* text, void* self) { static_cast<Context*>(self)->message = text; }, this);
    }
    ~Context() { GEOS_finish_r(handle); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

Context& context() {
    thread_local Context instance;
    return instance;
}

GEOSCoordSequence* sequence(std::span<const Point> points, bool close) {
    const auto count = static_cast<unsigned>(points.size() + (close ? 1 : 0));
    GEOSCoordSequence* coordinates = GEOSCoordSeq_create_r(handle(), count, 2);
    for (unsigned i = 0; i < count; ++i) {
        const Point point = points[i % points.size()];
        GEOSCoordSeq_setXY_r(handle(), coordinates, i, point.x, point.y);
    }
    return coordinates;
}

Ring ringFrom(const GEOSGeometry* ring, bool counterClockwise) {
    const GEOSCoordSequence* coordinates = GEOSGeom_getCoordSeq_r(handle(), ring);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(handle(), coordinates, &count);
    Ring points;
    points.reserve(count);
    for (unsigned i = 0; i + 1 < count; ++i) {
        Point point;
        GEOSCoordSeq_getXY_r(handle(), coordinates, i, &point.x, &point.y);
        points.push_back(point);
    }
    if ((signedAreaM2(points) > 0.0) != counterClockwise) {
        std::ranges::reverse(points);
    }
    return points;
}

void collect(const GEOSGeometry* geometry, MultiPolygon& polygons) {
    if (GEOSisEmpty_r(handle(), geometry) == 1) {
        return;
    }
    if (GEOSGeomTypeId_r(handle(), geometry) == GEOS_POLYGON) {
        Polygon polygon{.outer = ringFrom(GEOSGetExteriorRing_r(handle(), geometry), true), .holes = {}};
        const int holes = GEOSGetNumInteriorRings_r(handle(), geometry);
        for (int i = 0; i < holes; ++i) {
            polygon.holes.push_back(ringFrom(GEOSGetInteriorRingN_r(handle(), geometry, i), false));
        }
        polygons.push_back(std::move(polygon));
        return;
    }
    const int type = GEOSGeomTypeId_r(handle(), geometry);
    if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
        const int count = GEOSGetNumGeometries_r(handle(), geometry);
        for (int i = 0; i < count; ++i) {
            collect(GEOSGetGeometryN_r(handle(), geometry, i), polygons);
        }
    }
}

Error failed() {
    return {.code = ErrorCode::InputRefused,
            .what = message("the shape could not be computed with ({})", context().message),
            .remedy = "check the boundary for crossings"};
}

}  // namespace

GEOSContextHandle_t handle() {
    return context().handle;
}

Geometry toGeos(const Polygon& polygon) {
    std::vector<GEOSGeometry*> holes;
    for (const Ring& hole : polygon.holes) {
        holes.push_back(GEOSGeom_createLinearRing_r(handle(), sequence(hole, true)));
    }
    GEOSGeometry* shell = GEOSGeom_createLinearRing_r(handle(), sequence(polygon.outer, true));
    return Geometry{
        GEOSGeom_createPolygon_r(handle(), shell, holes.data(), static_cast<unsigned>(holes.size()))};
}

Geometry toGeos(const MultiPolygon& polygons) {
    std::vector<GEOSGeometry*> parts;
    parts.reserve(polygons.size());
    for (const Polygon& polygon : polygons) {
        parts.push_back(toGeos(polygon).release());
    }
    return Geometry{GEOSGeom_createCollection_r(handle(), GEOS_MULTIPOLYGON, parts.data(),
                                                static_cast<unsigned>(parts.size()))};
}

Geometry toGeos(const std::vector<Polyline>& lines) {
    std::vector<GEOSGeometry*> parts;
    parts.reserve(lines.size());
    for (const Polyline& line : lines) {
        parts.push_back(GEOSGeom_createLineString_r(handle(), sequence(line, false)));
    }
    return Geometry{GEOSGeom_createCollection_r(handle(), GEOS_MULTILINESTRING, parts.data(),
                                                static_cast<unsigned>(parts.size()))};
}

MultiPolygon fromGeos(const GEOSGeometry* geometry) {
    MultiPolygon polygons;
    collect(geometry, polygons);
    std::ranges::stable_sort(polygons, std::ranges::greater{},
                             [](const Polygon& polygon) { return area(polygon); });
    return polygons;
}

std::vector<Point> pointsOf(const GEOSGeometry* geometry) {
    const GEOSCoordSequence* const coordinates = GEOSGeom_getCoordSeq_r(handle(), geometry);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(handle(), coordinates, &count);
    std::vector<Point> points(count);
    for (unsigned i = 0; i < count; ++i) {
        GEOSCoordSeq_getXY_r(handle(), coordinates, i, &points[i].x, &points[i].y);
    }
    return points;
}

Result<Geometry> run(const JobContext& job, const std::function<GEOSGeometry*()>& operation) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    // GEOS has one interrupt flag for the whole process. The request of another planner may arrive here,
    // which is no reason to give up.
    for (int attempt = 0; attempt < 8; ++attempt) {
        context().message.clear();
        runningJob = &job;
        Geometry result{operation()};
        runningJob = nullptr;
        if (result) {
            return result;
        }
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (context().message.find("nterrupt") == std::string::npos) {
            break;
        }
    }
    return std::unexpected(failed());
}

}  // namespace furrow::geos
