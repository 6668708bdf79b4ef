#include "planner/io/content/obstacle_shapes.h"

#include "planner/core/file_error.h"
#include "planner/core/place_message.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/geos_bridge.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr Length kTolerance = metres(0.01);

Error withoutSize(const Message& where, Message what, GeoPoint place) {
    Error error =
        inputRefused(where, std::move(what), "say how far to keep from it (buffer_m), or draw its outline");
    error.place = place;
    return error;
}

/// Around the circle rather than in it, so that nothing of the obstacle is left out.
Polygon discAround(Point centre, double radiusM) {
    const double step = std::acos(1.0 / (1.0 + kTolerance.si() / radiusM));
    const int corners = std::max(8, static_cast<int>(std::ceil(std::numbers::pi / step)));
    const double outM = radiusM / std::cos(std::numbers::pi / corners);
    Polygon disc;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        disc.outer.push_back(centre + outM * Point{std::cos(angle), std::sin(angle)});
    }
    return disc;
}

}  // namespace

Result<std::vector<GeoPolygon>> outlinesAround(std::span<const GeoPoint> points,
                                               std::span<const GeoRing> lines, Length buffer,
                                               const Message& where, const JobContext& job) {
    const auto first = points.empty() ? lines.empty() ? std::nullopt : std::optional{lines.front().front()}
                                      : std::optional{points.front()};
    if (!first) {
        return std::vector<GeoPolygon>{};
    }
    if (!(buffer > metres(0.0))) {
        return std::unexpected(
            withoutSize(where,
                        points.empty() ? message("it is a line at {} without a width", placeMessage(*first))
                                       : message("it is a point at {} without a size", placeMessage(*first)),
                        *first));
    }
    const auto frame = LocalFrame::centredOn(*first);
    if (!frame) {
        return std::unexpected(frame.error());
    }
    std::vector<GeoPolygon> outlines;
    for (const GeoPoint& point : points) {
        outlines.push_back(frame->toGeo(discAround(frame->toLocal(point), buffer.si())));
    }
    for (const GeoRing& line : lines) {
        auto strip = aroundLines({frame->toLocal(line)}, buffer, kTolerance, job);
        if (!strip) {
            return std::unexpected(strip.error());
        }
        for (const Polygon& piece : *strip) {
            outlines.push_back(frame->toGeo(piece));
        }
    }
    return outlines;
}

}  // namespace furrow
