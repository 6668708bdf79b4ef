#include "ui/map/simplify.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

float distanceToSegment(MapPoint point, MapPoint from, MapPoint to) {
    const float dx = to.x - from.x;
    const float dy = to.y - from.y;
    const float squared = dx * dx + dy * dy;
    const float along =
        squared > 0.0F ? std::clamp(((point.x - from.x) * dx + (point.y - from.y) * dy) / squared, 0.0F, 1.0F)
                       : 0.0F;
    return std::hypot(point.x - from.x - along * dx, point.y - from.y - along * dy);
}

}  // namespace

std::vector<MapPoint> simplified(std::span<const MapPoint> line, float tolerance) {
    if (line.size() < 3) {
        return {line.begin(), line.end()};
    }
    std::vector<bool> keep(line.size(), false);
    keep.front() = keep.back() = true;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        float farthest = tolerance;
        std::size_t split = 0;
        for (std::size_t i = first + 1; i < last; ++i) {
            const float away = distanceToSegment(line[i], line[first], line[last]);
            if (away > farthest) {
                farthest = away;
                split = i;
            }
        }
        if (split != 0) {
            keep[split] = true;
            open.emplace_back(first, split);
            open.emplace_back(split, last);
        }
    }
    std::vector<MapPoint> result;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (keep[i]) {
            result.push_back(line[i]);
        }
    }
    return result;
}

}  // namespace furrow
