#include "planner/headland/edge_strips.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

namespace furrow {

namespace {

std::vector<Bounds> boxesOf(const std::vector<EdgeStrip>& strips) {
    std::vector<Bounds> boxes;
    std::ranges::transform(strips, std::back_inserter(boxes),
                           [](const EdgeStrip& strip) { return bounds(strip.from, strip.to); });
    return boxes;
}

}  // namespace

EdgeStrips::EdgeStrips(std::vector<EdgeStrip> strips) : strips_{std::move(strips)}, tree_{boxesOf(strips_)} {}

std::vector<EdgeStrip> EdgeStrips::along(const MultiPolygon& polygons, Length width, int passes) {
    std::vector<EdgeStrip> strips;
    forEachEdge(polygons, [&](Point from, Point to) { strips.push_back({from, to, width, passes}); });
    return strips;
}

std::size_t EdgeStrips::nearest(Point point) const {
    double leastM = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    tree_.any([&](const Bounds& box) { return distanceM(point, box) < leastM; },
              [&](std::size_t i) {
                  if (const double m = distanceToSegment(point, strips_[i].from, strips_[i].to); m < leastM) {
                      leastM = m;
                      nearest = i;
                  }
                  return false;
              });
    return nearest;
}

std::optional<std::size_t> EdgeStrips::ahead(const Pose& pose, Length within) const {
    const Point way = direction(pose.heading.si());
    const Point end = pose.position + within.si() * way;
    const Bounds around = bounds(pose.position, end);
    double leastM = within.si();
    std::optional<std::size_t> first;
    tree_.any([&](const Bounds& box) { return meet(box, around); },
              [&](std::size_t i) {
                  const Point along = strips_[i].to - strips_[i].from;
                  const auto [aheadM, backShare] = toMeeting(pose.position, way, strips_[i].from, along);
                  // Distance behind the start of the edge, as a negative share of the edge.
                  if (aheadM >= 0.0 && aheadM <= leastM && backShare <= 0.0 && backShare >= -1.0) {
                      leastM = aheadM;
                      first = i;
                  }
                  return false;
              });
    return first;
}

Result<MultiPolygon> withoutStrips(const MultiPolygon& workable, std::span<const EdgeStrip> strips,
                                   const JobContext& job) {
    // Edges that follow on each other are one line: fewer buffers, and no seams.
    std::map<double, std::vector<Polyline>> linesByWidth;
    for (const EdgeStrip& strip : strips) {
        if (strip.width <= Length{}) {
            continue;
        }
        std::vector<Polyline>& lines = linesByWidth[strip.width.si()];
        if (!lines.empty() && lines.back().back() == strip.from) {
            lines.back().push_back(strip.to);
        } else {
            lines.push_back({strip.from, strip.to});
        }
    }
    Result<MultiPolygon> left = workable;
    for (const auto& [widthM, lines] : linesByWidth) {
        left = left.and_then([&](const MultiPolygon& rest) {
            return aroundLines(lines, metres(widthM), kArcTolerance, job)
                .and_then([&](const MultiPolygon& taken) { return difference(rest, taken, job); });
        });
    }
    return left;
}

}  // namespace furrow
