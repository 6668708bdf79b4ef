#include "planner/headland/moving_in.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/simplify.h"
#include "planner/headland/ring_bend.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

// Smaller moves are ignored, because the bend at their start swings nothing out.
constexpr double kLeastMoveM = 2e-4;
// Largest distance between points of a ring that can be moved.
constexpr double kDenseM = 1.0;

/// Adds points, close enough for the curve of the moved ring, but none on unmoved parts.
Ring densified(const Ring& ring, const Displacement& displacement) {
    Ring dense;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point from = ring[i];
        const Point way = ring[(i + 1) % ring.size()] - from;
        const auto pieces = std::max(1, static_cast<int>(std::ceil(norm(way) / kDenseM)));
        bool wasMoved = true;
        for (int k = 0; k < pieces; ++k) {
            const Point at = from + (static_cast<double>(k) / pieces) * way;
            const bool isMoved = displacement.at(at) > 0.0;
            if (k == 0 || isMoved || wasMoved) {
                dense.push_back(at);
            }
            wasMoved = isMoved;
        }
    }
    return dense;
}

Ring moved(const Ring& ring, const Displacement& displacement) {
    const Ring dense = densified(ring, displacement);
    Ring result;
    for (std::size_t i = 0; i < dense.size(); ++i) {
        const Bend bend = bendAt(dense, i);
        // At a corner the point moves along the bisector. Both edges then move by the same distance.
        const double mitre = 1.0 / std::max(0.5, std::cos(0.5 * bend.turnRad));
        result.push_back(dense[i] + displacement.at(dense[i]) * mitre * bend.inward);
    }
    // Fewer points on the same curve, since the cost of the buffers grows with the points.
    return simplifiedRing(std::move(result), kRingTolerance);
}

}  // namespace

void Displacement::add(std::vector<Excess> excesses) {
    std::ranges::sort(excesses, {}, [](const Excess& excess) { return excess.place.x; });
    rounds_.push_back(std::move(excesses));
}

double Displacement::at(Point point) const {
    double sum = 0.0;
    for (const std::vector<Excess>& round : rounds_) {
        sum += mostAt(point, round);
    }
    return sum < kLeastMoveM ? 0.0 : sum;
}

/// The largest demand counts. A sum within one round would grow with the number of places.
double Displacement::mostAt(Point point, const std::vector<Excess>& round) const {
    // Farther away, exp() is too small for a move.
    const double seenM = 10.0 * reachM_;
    const auto xOf = [](const Excess& excess) { return excess.place.x; };
    double most = 0.0;
    for (auto it = std::ranges::lower_bound(round, point.x - seenM, {}, xOf);
         it != round.end() && it->place.x <= point.x + seenM; ++it) {
        if (std::abs(it->place.y - point.y) <= seenM) {
            const double away = distance(point, it->place);
            most = std::max(most, it->moveM * std::exp(-std::max(0.0, away - reachM_) / reachM_));
        }
    }
    return most;
}

Result<MultiPolygon> moved(const MultiPolygon& polygons, const Displacement& displacement,
                           const JobContext& job) {
    if (displacement.isEmpty()) {
        return polygons;
    }
    MultiPolygon result;
    for (const Polygon& polygon : polygons) {
        result.push_back({.outer = moved(polygon.outer, displacement), .holes = {}});
        for (const Ring& hole : polygon.holes) {
            result.back().holes.push_back(moved(hole, displacement));
        }
    }
    return madeValid(result, job);
}

}  // namespace furrow
