#include "planner/geometry/prepared_area.h"

#include "planner/geometry/box_tree.h"
#include "planner/geometry/geos_shapes.h"

#include <algorithm>
#include <array>
#include <utility>

namespace furrow {

using namespace geos;

struct PreparedArea::Impl {
    explicit Impl(const MultiPolygon& area) : polygons{area} {
        std::vector<Bounds> boxes;
        forEachEdge(polygons, [&](Point from, Point to) {
            edges.emplace_back(from, to);
            boxes.push_back(bounds(from, to));
        });
        tree = BoxTree{boxes};
    }

    /// The shares of the way from one point to another at which it meets an edge, with 0 and 1 around them.
    void crossings(Point from, Point to, std::vector<double>& cuts) const {
        cuts.assign(1, 0.0);
        const Bounds box = bounds(from, to);
        const Point way = to - from;
        tree.any([&](const Bounds& other) { return meet(box, other); },
                 [&](std::size_t i) {
                     const auto& [a, b] = edges[i];
                     const double fromSide = cross(b - a, from - a);
                     const double toSide = cross(b - a, to - a);
                     const double aSide = cross(way, a - from);
                     const double bSide = cross(way, b - from);
                     if (fromSide * toSide < 0.0 && aSide * bSide <= 0.0) {
                         cuts.push_back(fromSide / (fromSide - toSide));
                     }
                     return false;
                 });
        cuts.push_back(1.0);
        std::ranges::sort(cuts);
    }

    MultiPolygon polygons;
    std::vector<std::pair<Point, Point>> edges;
    BoxTree tree;  ///< of the edges

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
        // Four areas at a time: the area inside and all land, for the tractor and for the implement.
        thread_local std::array<std::unique_ptr<PerThread>, 4> cache;
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

PreparedArea::PreparedArea(const MultiPolygon& polygons) : impl_{std::make_unique<Impl>(polygons)} {}

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
    const GEOSPreparedGeometry* const area = impl_->prepared().prepared;
    std::optional<FarthestPoint> farthest;
    const auto consider = [&](Point point) {
        if (GEOSPreparedIntersectsXY_r(handle(), area, point.x, point.y) != 0) {
            return;
        }
        const Geometry place{GEOSGeom_createPointFromXY_r(handle(), point.x, point.y)};
        double away = 0.0;
        if (GEOSPreparedDistance_r(handle(), area, place.get(), &away) == 1 && away > 0.0 &&
            (!farthest || away > farthest->distance.si())) {
            farthest = {point, metres(away)};
        }
    };
    std::vector<double> cuts;
    for (const Polyline& line : lines) {
        for (std::size_t k = 0; k < line.size(); ++k) {
            consider(line[k]);
            if (k == 0) {
                continue;
            }
            // A straight line through a hole is farthest outside somewhere between its two crossings.
            impl_->crossings(line[k - 1], line[k], cuts);
            for (std::size_t i = 1; i < cuts.size(); ++i) {
                consider(line[k - 1] + 0.5 * (cuts[i - 1] + cuts[i]) * (line[k] - line[k - 1]));
            }
        }
    }
    return farthest;
}

}  // namespace furrow
