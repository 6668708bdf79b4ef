#include "planner/geometry/geos_bridge.h"

#include <geos_c.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <mutex>
#include <utility>

namespace furrow {

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

GEOSContextHandle_t handle() {
    return context().handle;
}

struct GeometryDeleter {
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(handle(), geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, GeometryDeleter>;

GEOSCoordSequence* sequence(std::span<const Point> points, bool close) {
    const auto count = static_cast<unsigned>(points.size() + (close ? 1 : 0));
    GEOSCoordSequence* coordinates = GEOSCoordSeq_create_r(handle(), count, 2);
    for (unsigned i = 0; i < count; ++i) {
        const Point point = points[i % points.size()];
        GEOSCoordSeq_setXY_r(handle(), coordinates, i, point.x, point.y);
    }
    return coordinates;
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
    for (const Polygon& polygon : polygons) {
        parts.push_back(toGeos(polygon).release());
    }
    return Geometry{GEOSGeom_createCollection_r(handle(), GEOS_MULTIPOLYGON, parts.data(),
                                                static_cast<unsigned>(parts.size()))};
}

Geometry toGeos(const std::vector<Polyline>& lines) {
    std::vector<GEOSGeometry*> parts;
    for (const Polyline& line : lines) {
        parts.push_back(GEOSGeom_createLineString_r(handle(), sequence(line, false)));
    }
    return Geometry{GEOSGeom_createCollection_r(handle(), GEOS_MULTILINESTRING, parts.data(),
                                                static_cast<unsigned>(parts.size()))};
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

MultiPolygon fromGeos(const GEOSGeometry* geometry) {
    MultiPolygon polygons;
    collect(geometry, polygons);
    std::ranges::stable_sort(polygons, std::ranges::greater{},
                             [](const Polygon& polygon) { return area(polygon); });
    return polygons;
}

Error failed() {
    return {.code = ErrorCode::InputRefused,
            .what = message("the shape could not be computed with ({})", context().message),
            .remedy = "check the boundary for crossings"};
}

/// Runs one GEOS operation under the job's stop token.
template <class Operation>
Result<Geometry> run(const JobContext& job, const Operation& operation) {
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

// A boundary with more vertices is thinned before it is moved inwards.
constexpr std::size_t kDenseVertices = 20'000;
constexpr double kLeastSlackM = 0.01;
constexpr double kMostSlackM = 0.05;

/// The number of segments in a quarter circle with which the arc's chords stay within the tolerance.
int quarterSegments(double radiusM, double toleranceM) {
    if (radiusM <= toleranceM) {
        return 2;
    }
    const double step = 2.0 * std::acos(1.0 - toleranceM / radiusM);
    return std::clamp(static_cast<int>(std::ceil(std::numbers::pi / 2.0 / step)), 2, 64);
}

/// For polygons or lines.
template <class Shapes>
Result<MultiPolygon> buffered(const Shapes& shapes, double distanceM, double toleranceM,
                              const JobContext& job) {
    if (shapes.empty()) {
        return MultiPolygon{};
    }
    const Geometry input = toGeos(shapes);
    return run(job,
               [&] {
                   return GEOSBuffer_r(handle(), input.get(), distanceM,
                                       quarterSegments(std::abs(distanceM), toleranceM));
               })
        .transform([](const Geometry& result) { return fromGeos(result.get()); });
}

/// Polygons with the same enclosed area as these rings, even-odd.
Result<Geometry> validOf(const Geometry& shapes, const JobContext& job) {
    return run(job, [&] { return GEOSMakeValid_r(handle(), shapes.get()); });
}

using Overlay = GEOSGeometry* (*)(GEOSContextHandle_t, const GEOSGeometry*, const GEOSGeometry*);
using GridOverlay = GEOSGeometry* (*)(GEOSContextHandle_t, const GEOSGeometry*, const GEOSGeometry*, double);

/// Uses a grid if it has a size. GEOS's overlays on a grid cannot replace those without: 0 skips their
/// fallbacks against failures, -1 is a grid of a metre.
Result<MultiPolygon> combined(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                              Length grid, Overlay plain, GridOverlay snapping) {
    const auto overlaid = [&](const Geometry& first, const Geometry& second) {
        return run(job, [&] {
            return grid > metres(0.0) ? snapping(handle(), first.get(), second.get(), grid.si())
                                      : plain(handle(), first.get(), second.get());
        });
    };
    const Geometry first = toGeos(a);
    const Geometry second = toGeos(b);
    return overlaid(first, second)
        .or_else([&](const Error& error) -> Result<Geometry> {
            if (error.code == ErrorCode::Cancelled) {
                return std::unexpected(error);
            }
            // Rounding made one of them touch or cross itself.
            return validOf(first, job).and_then([&](const Geometry& one) {
                return validOf(second, job).and_then([&](const Geometry& other) {
                    return overlaid(one, other);
                });
            });
        })
        .transform([](const Geometry& result) { return fromGeos(result.get()); });
}

Error notALine(const std::string& wkt) {
    return {.code = ErrorCode::InputRefused,
            .what = message("'{}' is not a line", wkt),
            .where = {},
            .remedy = "write it like LINESTRING (4.1 52.0, 4.2 52.0)"};
}

/// Empty if the text is no WKT, or an empty geometry.
Geometry fromWkt(const std::string& wkt) {
    GEOSWKTReader* const reader = GEOSWKTReader_create_r(handle());
    Geometry geometry{GEOSWKTReader_read_r(handle(), reader, wkt.c_str())};
    GEOSWKTReader_destroy_r(handle(), reader);
    return geometry && GEOSisEmpty_r(handle(), geometry.get()) == 1 ? Geometry{} : std::move(geometry);
}

/// The points of a line or a point.
std::vector<Point> coordinatesOf(const GEOSGeometry* geometry) {
    const GEOSCoordSequence* const coordinates = GEOSGeom_getCoordSeq_r(handle(), geometry);
    unsigned count = 0;
    GEOSCoordSeq_getSize_r(handle(), coordinates, &count);
    std::vector<Point> points(count);
    for (unsigned i = 0; i < count; ++i) {
        GEOSCoordSeq_getXY_r(handle(), coordinates, i, &points[i].x, &points[i].y);
    }
    return points;
}

}  // namespace

Result<MultiPolygon> erodedSharp(const MultiPolygon& polygons, Length distance, const JobContext& job) {
    constexpr double kMitreLimit = 2.0;
    if (polygons.empty()) {
        return MultiPolygon{};
    }
    if (vertexCount(polygons) > kDenseVertices) {
        return eroded(polygons, distance, kArcTolerance, job);
    }
    const Geometry input = toGeos(polygons);
    return run(job,
               [&] {
                   return GEOSBufferWithStyle_r(handle(), input.get(), -distance.si(), 8, GEOSBUF_CAP_ROUND,
                                                GEOSBUF_JOIN_MITRE, kMitreLimit);
               })
        .transform([](const Geometry& result) { return fromGeos(result.get()); });
}

Result<MultiPolygon> eroded(const MultiPolygon& polygons, Length distance, Length tolerance,
                            const JobContext& job) {
    if (vertexCount(polygons) <= kDenseVertices) {
        return buffered(polygons, -distance.si(), tolerance.si(), job);
    }
    // If points are closer than the offset by orders of magnitude, their offsets cross each other a hundred
    // million times. A line within `slack` of the boundary, moved in by that much more, is a safe
    // replacement.
    double slackM = std::clamp(distance.si() / 200.0, kLeastSlackM, kMostSlackM);
    const Geometry input = toGeos(polygons);
    while (true) {
        const auto simple = run(job, [&] { return GEOSSimplify_r(handle(), input.get(), slackM); });
        if (!simple) {
            return std::unexpected(simple.error());
        }
        const MultiPolygon thinned = fromGeos(simple->get());
        // Points that scatter by more than the slack stay. GEOS would take seconds for them, and no stop
        // request ends these.
        if (vertexCount(thinned) <= kDenseVertices || slackM == kMostSlackM) {
            return buffered(thinned, -(distance.si() + slackM), tolerance.si(), job);
        }
        slackM = std::min(2.0 * slackM, kMostSlackM);
    }
}

Result<MultiPolygon> dilated(const MultiPolygon& polygons, Length distance, Length tolerance,
                             const JobContext& job) {
    return buffered(polygons, distance.si(), tolerance.si(), job);
}

Result<MultiPolygon> aroundLines(const std::vector<Polyline>& lines, Length distance, Length tolerance,
                                 const JobContext& job) {
    return buffered(lines, distance.si(), tolerance.si(), job);
}

Result<MultiPolygon> difference(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                                Length grid) {
    return combined(a, b, job, grid, GEOSDifference_r, GEOSDifferencePrec_r);
}

Result<MultiPolygon> intersection(const MultiPolygon& a, const MultiPolygon& b, const JobContext& job,
                                  Length grid) {
    return combined(a, b, job, grid, GEOSIntersection_r, GEOSIntersectionPrec_r);
}

Result<MultiPolygon> unionOf(const MultiPolygon& polygons, const JobContext& job, Length grid) {
    const auto together = [&](const MultiPolygon& parts) {
        const Geometry input = toGeos(parts);
        return run(job,
                   [&] {
                       return grid > metres(0.0) ? GEOSUnaryUnionPrec_r(handle(), input.get(), grid.si())
                                                 : GEOSUnaryUnion_r(handle(), input.get());
                   })
            .transform([](const Geometry& result) { return fromGeos(result.get()); });
    };
    return together(polygons).or_else([&](const Error& error) -> Result<MultiPolygon> {
        if (error.code == ErrorCode::Cancelled) {
            return std::unexpected(error);
        }
        // One of them crosses itself. Each is repaired alone, since the area shared by two belongs to the
        // union.
        MultiPolygon sound;
        for (const Polygon& polygon : polygons) {
            const auto mended = validOf(toGeos(MultiPolygon{polygon}), job);
            if (!mended) {
                return std::unexpected(mended.error());
            }
            std::ranges::move(fromGeos(mended->get()), std::back_inserter(sound));
        }
        return together(sound);
    });
}

Result<MultiPolygon> cutAlong(const MultiPolygon& polygons, const std::vector<Polyline>& lines,
                              const JobContext& job) {
    const Geometry area = toGeos(polygons);
    const Geometry cuts = toGeos(lines);
    const auto edges = run(job, [&] { return GEOSBoundary_r(handle(), area.get()); });
    if (!edges) {
        return std::unexpected(edges.error());
    }
    const auto noded = run(job, [&] { return GEOSUnion_r(handle(), edges->get(), cuts.get()); });
    if (!noded) {
        return std::unexpected(noded.error());
    }
    const auto faces = run(job, [&] {
        const GEOSGeometry* const all[] = {noded->get()};
        return GEOSPolygonize_r(handle(), all, 1);
    });
    if (!faces) {
        return std::unexpected(faces.error());
    }
    // Faces of holes, and faces that the lines enclose outside, are not pieces.
    const GEOSPreparedGeometry* const prepared = GEOSPrepare_r(handle(), area.get());
    MultiPolygon pieces;
    for (Polygon& face : fromGeos(faces->get())) {
        const Geometry one = toGeos(face);
        const Geometry inner{GEOSPointOnSurface_r(handle(), one.get())};
        if (inner && GEOSPreparedContains_r(handle(), prepared, inner.get()) == 1) {
            pieces.push_back(std::move(face));
        }
    }
    GEOSPreparedGeom_destroy_r(handle(), prepared);
    return pieces;
}

Result<Length> breadthOf(const MultiPolygon& polygons, const JobContext& job) {
    if (polygons.empty()) {
        return Length{};
    }
    const Geometry input = toGeos(polygons);
    const double tolerance = std::max(0.01, 0.005 * std::sqrt(std::abs(area(polygons).si())));
    return run(job, [&] { return GEOSMaximumInscribedCircle_r(handle(), input.get(), tolerance); })
        .transform([](const Geometry& radius) {
            double length = 0.0;
            GEOSGeomGetLength_r(handle(), radius.get(), &length);
            return metres(2.0 * length);
        });
}

Result<std::optional<InvalidPlace>> findInvalidPlace(const MultiPolygon& polygons, const JobContext& job) {
    const Geometry input = toGeos(polygons);
    std::optional<InvalidPlace> problem;
    const Result<Geometry> checked = run(job, [&]() -> GEOSGeometry* {
        char* reason = nullptr;
        GEOSGeometry* place = nullptr;
        const char valid = GEOSisValidDetail_r(handle(), input.get(), 0, &reason, &place);
        if (valid == 0 && place != nullptr) {
            InvalidPlace found{.reason = reason, .place = {}};
            GEOSGeomGetX_r(handle(), place, &found.place.x);
            GEOSGeomGetY_r(handle(), place, &found.place.y);
            problem = found;
        }
        GEOSFree_r(handle(), reason);
        GEOSGeom_destroy_r(handle(), place);
        // Any geometry means that the check finished. None means that it was interrupted.
        return valid == 2 ? nullptr : GEOSGeom_createEmptyPoint_r(handle());
    });
    if (!checked) {
        return std::unexpected(checked.error());
    }
    return problem;
}

Result<std::vector<Point>> pointsOfWkt(const std::string& wkt) {
    const Geometry geometry = fromWkt(wkt);
    const int type = geometry ? GEOSGeomTypeId_r(handle(), geometry.get()) : -1;
    if (type != GEOS_LINESTRING && type != GEOS_POINT) {
        return std::unexpected(notALine(wkt));
    }
    return coordinatesOf(geometry.get());
}

Result<std::vector<Polyline>> linesOfWkt(const std::string& wkt) {
    const Geometry geometry = fromWkt(wkt);
    const int count = geometry ? GEOSGetNumGeometries_r(handle(), geometry.get()) : 0;
    std::vector<Polyline> lines;
    for (int i = 0; i < count; ++i) {
        const GEOSGeometry* const part = GEOSGetGeometryN_r(handle(), geometry.get(), i);
        const int type = GEOSGeomTypeId_r(handle(), part);
        if (type == GEOS_LINESTRING) {
            lines.push_back(coordinatesOf(part));
            continue;
        }
        if (type != GEOS_MULTILINESTRING) {
            return std::unexpected(notALine(wkt));
        }
        for (int k = 0; k < GEOSGetNumGeometries_r(handle(), part); ++k) {
            lines.push_back(coordinatesOf(GEOSGetGeometryN_r(handle(), part, k)));
        }
    }
    if (lines.empty()) {
        return std::unexpected(notALine(wkt));
    }
    return lines;
}

Result<MultiPolygon> madeValid(const MultiPolygon& polygons, const JobContext& job) {
    return validOf(toGeos(polygons), job).transform([](const Geometry& result) {
        return fromGeos(result.get());
    });
}

struct PreparedArea::Impl {
    MultiPolygon polygons;

    /// Prepared geometries build their indexes on first use, which must not happen in two threads at once. So
    /// every thread prepares its own and keeps it as long as it uses the same area.
    struct PerThread {
        PerThread(const MultiPolygon& polygons, std::weak_ptr<const char> area)
            : owner{std::move(area)},
              geometry{toGeos(polygons)},
              prepared{GEOSPrepare_r(handle(), geometry.get())} {}
        ~PerThread() { GEOSPreparedGeom_destroy_r(handle(), prepared); }
        PerThread(const PerThread&) = delete;
        PerThread& operator=(const PerThread&) = delete;

        std::weak_ptr<const char> owner;
        Geometry geometry;
        const GEOSPreparedGeometry* prepared;
    };
    const PerThread& prepared() const {
        // Two areas at a time: the area inside, and all land.
        thread_local std::array<std::unique_ptr<PerThread>, 2> cache;
        for (const auto& entry : cache) {
            if (entry && entry->owner.lock() == alive) {
                return *entry;
            }
        }
        std::ranges::rotate(cache, cache.end() - 1);
        cache.front() = std::make_unique<PerThread>(polygons, alive);
        return *cache.front();
    }

    std::shared_ptr<const char> alive = std::make_shared<const char>();
};

PreparedArea::PreparedArea(const MultiPolygon& polygons) : impl_{std::make_unique<Impl>()} {
    impl_->polygons = polygons;
}

PreparedArea::~PreparedArea() = default;
PreparedArea::PreparedArea(PreparedArea&&) noexcept = default;
PreparedArea& PreparedArea::operator=(PreparedArea&&) noexcept = default;

bool PreparedArea::covers(const std::vector<Polyline>& lines) const {
    const Geometry tested = toGeos(lines);
    return GEOSPreparedCovers_r(handle(), impl_->prepared().prepared, tested.get()) == 1;
}

bool PreparedArea::coversHullOf(const std::vector<Polyline>& lines) const {
    const Geometry drawn = toGeos(lines);
    const Geometry hull{GEOSConvexHull_r(handle(), drawn.get())};
    return GEOSPreparedCovers_r(handle(), impl_->prepared().prepared, hull.get()) == 1;
}

std::optional<FarthestPoint> PreparedArea::farthestOutside(const std::vector<Polyline>& lines) const {
    const Geometry tested = toGeos(lines);
    const auto& area = impl_->prepared();
    std::optional<FarthestPoint> farthest;
    const auto consider = [&](Point point) {
        const Geometry place{GEOSGeom_createPointFromXY_r(handle(), point.x, point.y)};
        double away = 0.0;
        if (GEOSPreparedDistance_r(handle(), area.prepared, place.get(), &away) == 1 && away > 0.0 &&
            (!farthest || away > farthest->distance.si())) {
            farthest = {point, metres(away)};
        }
    };
    const Geometry outside{GEOSDifference_r(handle(), tested.get(), area.geometry.get())};
    const int parts = outside ? GEOSGetNumGeometries_r(handle(), outside.get()) : 0;
    for (int i = 0; i < parts; ++i) {
        const GEOSGeometry* part = GEOSGetGeometryN_r(handle(), outside.get(), i);
        const GEOSCoordSequence* coordinates = GEOSGeom_getCoordSeq_r(handle(), part);
        unsigned count = 0;
        GEOSCoordSeq_getSize_r(handle(), coordinates, &count);
        Point before;
        for (unsigned k = 0; k < count; ++k) {
            Point point;
            GEOSCoordSeq_getXY_r(handle(), coordinates, k, &point.x, &point.y);
            consider(point);
            if (k > 0) {
                // A straight line through a hole is farthest outside somewhere between its two crossings.
                consider(0.5 * (before + point));
            }
            before = point;
        }
    }
    return farthest;
}

}  // namespace furrow
