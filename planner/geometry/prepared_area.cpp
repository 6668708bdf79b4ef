#include "planner/geometry/prepared_area.h"

#include "planner/geometry/geos_shapes.h"

#include <algorithm>
#include <array>

namespace furrow {

using namespace geos;

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
        const std::vector<Point> line = pointsOf(GEOSGetGeometryN_r(handle(), outside.get(), i));
        for (std::size_t k = 0; k < line.size(); ++k) {
            consider(line[k]);
            if (k > 0) {
                // A straight line through a hole is farthest outside somewhere between its two crossings.
                consider(0.5 * (line[k - 1] + line[k]));
            }
        }
    }
    return farthest;
}

}  // namespace furrow
