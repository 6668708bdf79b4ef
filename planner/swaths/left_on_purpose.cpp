#include "planner/swaths/left_on_purpose.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"
#include "planner/swaths/curved_swaths.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace furrow {

namespace {

// Lanes that lie on each other's edges leave slivers of rounding.
constexpr double kSliverM2 = 1e-3;
// A narrower strip is rounding, too.
constexpr Length kFlush = metres(1e-3);
// A piece this close to the end of a lane begins there.
constexpr double kBeginsM = 1e-3;
// A piece within this distance lies beside a lane.
constexpr double kBesideM = 0.02;

/// A rectangle along a direction: its range along it, and its range across it, to the left.
Polygon rectangleAlong(Point along, Point origin, std::pair<double, double> length,
                       std::pair<double, double> across) {
    const Point left{-along.y, along.x};
    const auto at = [&](double x, double y) { return origin + x * along + y * left; };
    return {.outer = {at(length.first, across.first), at(length.second, across.first),
                      at(length.second, across.second), at(length.first, across.second)},
            .holes = {}};
}

/// The bounds of a mainland along and across a direction.
Bounds turnedBounds(const MultiPolygon& mainland, Point along) {
    std::vector<Point> turned;
    forEachEdge(mainland,
                [&](Point from, Point) { turned.push_back({dot(along, from), cross(along, from)}); });
    return bounds(turned);
}

/// The continuation of a lane in the mainland, straight ahead of the pose at its end.
Result<MultiPolygon> aheadOf(const Pose& end, Length width, const MultiPolygon& mainland,
                             const JobContext& job) {
    const Bounds box = bounds(mainland);
    const double farM = box.width() + box.height() + norm(end.position - box.min);
    const Point along = direction(end.heading.si());
    const double halfM = 0.5 * width.si();
    auto pieces =
        intersection(mainland, {rectangleAlong(along, end.position, {0.0, farM}, {-halfM, halfM})}, job);
    if (pieces) {
        // Beyond the mainland's edge the land belongs to another lane.
        std::erase_if(*pieces, [&](const Polygon& piece) {
            return std::ranges::none_of(piece.outer,
                                        [&](Point p) { return dot(along, p - end.position) < kBeginsM; });
        });
    }
    return pieces;
}

/// The lanes of a set, each with its continuations straight ahead of both ends.
Result<MultiPolygon> lanesOf(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job) {
    MultiPolygon lanes;
    for (const Swath& swath : set.swaths) {
        const Curve line = lineOf(swath);
        addStrips(line, swath.width, lanes);
        if (swath.isClosed()) {
            continue;
        }
        const Pose back{.position = line.start.position, .heading = line.start.heading + degrees(180.0)};
        for (const Pose& end : {back, line.end()}) {
            auto ahead = aheadOf(end, swath.width, mainland, job);
            if (!ahead) {
                return ahead;
            }
            std::ranges::move(*ahead, std::back_inserter(lanes));
        }
    }
    return lanes;
}

/// The first and the last track beside a piece.
std::pair<int, int> tracksBeside(const Polygon& piece, const SwathSet& set,
                                 const std::vector<Polyline>& middles) {
    std::pair<int, int> tracks{std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};
    for (std::size_t i = 0; i < middles.size(); ++i) {
        const Swath& swath = set.swaths[i];
        const double reachM = 0.5 * swath.width.si() + kBesideM;
        const bool isBeside = std::ranges::any_of(piece.outer, [&](Point point) {
            for (std::size_t k = 0; k + 1 < middles[i].size(); ++k) {
                if (distanceToSegment(point, middles[i][k], middles[i][k + 1]) < reachM) {
                    return true;
                }
            }
            return false;
        });
        if (isBeside) {
            tracks = {std::min(tracks.first, swath.track), std::max(tracks.second, swath.track)};
        }
    }
    return tracks;
}

}  // namespace

Result<MultiPolygon> besideLanes(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job) {
    const Point along = direction(set.heading.si());
    const Bounds box = turnedBounds(mainland, along);
    MultiPolygon left;
    const auto take = [&](double from, double to) -> Result<void> {
        auto strip = intersection(
            mainland, {rectangleAlong(along, {}, {box.min.x - 1.0, box.max.x + 1.0}, {from, to})}, job);
        if (!strip) {
            return std::unexpected(strip.error());
        }
        std::ranges::move(*strip, std::back_inserter(left));
        return {};
    };
    Result<void> taken;
    if (set.restRight > kFlush) {
        taken = take(box.min.y - 1.0, box.min.y + set.restRight.si());
    }
    if (taken && set.restLeft > kFlush) {
        taken = take(box.max.y - set.restLeft.si(), box.max.y + 1.0);
    }
    return taken.transform([&] { return std::move(left); });
}

Result<MultiPolygon> betweenLanes(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job) {
    return lanesOf(set, mainland, job)
        .and_then([&](const MultiPolygon& lanes) { return unionOf(lanes, job, kSnapGrid); })
        .and_then([&](const MultiPolygon& lanes) { return difference(mainland, lanes, job, kSnapGrid); })
        .transform([](MultiPolygon left) {
            std::erase_if(left, [](const Polygon& piece) { return area(piece).si() < kSliverM2; });
            return left;
        });
}

Result<MultiPolygon> besideOutermostLanes(const SwathSet& set, const MultiPolygon& mainland,
                                          const JobContext& job) {
    auto left = betweenLanes(set, mainland, job);
    if (!left || left->empty()) {
        return left;
    }
    std::vector<Polyline> middles;
    std::ranges::transform(set.swaths, std::back_inserter(middles),
                           [](const Swath& swath) { return middleLine(swath); });
    const auto [first, last] = std::ranges::minmax(set.swaths, {}, &Swath::track);
    std::erase_if(*left, [&](const Polygon& piece) {
        const auto [from, to] = tracksBeside(piece, set, middles);
        return from != to || (from != first.track && from != last.track);
    });
    return left;
}

}  // namespace furrow
