#include "planner/field/ground_around.h"

#include "planner/geometry/geos_bridge.h"

#include <algorithm>

namespace furrow {

namespace {

// No machine turns farther beyond the field than the length of the field plus this.
constexpr double kFarM = 1000.0;

}  // namespace

Result<MultiPolygon> obstaclesOf(const Field& field, const MultiPolygon& free, const JobContext& job) {
    return unionOf(withoutHoles(field.boundary()), job).and_then([&](const MultiPolygon& land) {
        return difference(land, free, job);
    });
}

Result<MultiPolygon> groundAround(const Field& field, const JobContext& job) {
    const Bounds box = bounds(field.boundary());
    const double farM = std::max(box.width(), box.height()) + kFarM;
    const Point low = box.min - Point{farM, farM};
    const Point high = box.max + Point{farM, farM};
    const MultiPolygon around{{.outer = {low, {high.x, low.y}, high, {low.x, high.y}}, .holes = {}}};
    return obstaclesOf(field, field.drivable(), job).and_then([&](const MultiPolygon& obstacles) {
        return difference(around, obstacles, job);
    });
}

}  // namespace furrow
