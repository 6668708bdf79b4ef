#include "planner/editing/outline_edits.h"

#include "planner/editing/shape_hit.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace furrow {

namespace {

std::size_t nextOf(const Outline& outline, std::size_t vertex) {
    return vertex + 1 == outline.points.size() ? 0 : vertex + 1;
}

std::size_t lastOf(const Outline& outline, std::size_t vertex) {
    return vertex == 0 ? outline.points.size() - 1 : vertex - 1;
}

/// The new place of the end of a moved edge: on the line of the edge beside it, from `end` to `beyond`.
Point slid(Point end, Point beyond, Point along, Point sideways) {
    // Edges that meet at less than 10 degrees would move out far.
    constexpr double kLeastSine = 0.17;
    const Point beside = beyond - end;
    const double sine = norm(beside) > 0.0 ? cross(along, beside) / norm(beside) : 0.0;
    if (std::abs(sine) < kLeastSine) {
        return end + sideways;
    }
    const Point left{-along.y, along.x};
    const double share = dot(sideways, left) / dot(beside, left);
    // Beyond its other end, the edge beside it would point in the other direction.
    return share < 1.0 ? end + share * beside : end + sideways;
}

}  // namespace

GeoRing withVertexAt(const Outline& outline, const LocalFrame& frame, std::size_t vertex, Point place) {
    GeoRing places = outline.places;
    places[vertex] = frame.toGeo(place);
    return places;
}

GeoRing withVertexOn(const Outline& outline, const LocalFrame& frame, std::size_t edge, Point place) {
    GeoRing places = outline.places;
    places.insert(places.begin() + static_cast<std::ptrdiff_t>(edge) + 1, frame.toGeo(place));
    return places;
}

std::optional<GeoRing> withoutVertex(const Outline& outline, std::size_t vertex) {
    if (outline.places.size() <= (outline.closed ? 3U : 2U)) {
        return std::nullopt;
    }
    GeoRing places = outline.places;
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(vertex));
    return places;
}

GeoRing withEdgeMoved(const Outline& outline, const LocalFrame& frame, std::size_t edge, Length sideways) {
    const std::size_t next = nextOf(outline, edge);
    const Point from = outline.from(edge);
    const Point to = outline.to(edge);
    const double length = distance(from, to);
    GeoRing places = outline.places;
    if (length <= 0.0) {
        return places;
    }
    const Point along = (1.0 / length) * (to - from);
    const Point way = sideways.si() * Point{-along.y, along.x};
    const bool hasLast = outline.closed || edge > 0;
    const bool hasNext = outline.closed || next + 1 < outline.points.size();
    places[edge] =
        frame.toGeo(hasLast ? slid(from, outline.points[lastOf(outline, edge)], along, way) : from + way);
    places[next] =
        frame.toGeo(hasNext ? slid(to, outline.points[nextOf(outline, next)], along, way) : to + way);
    return places;
}

GeoRing withEdgeLength(const Outline& outline, const LocalFrame& frame, std::size_t edge, Length length) {
    const Point way = outline.to(edge) - outline.from(edge);
    const double before = norm(way);
    if (before <= 0.0) {
        return outline.places;
    }
    return withVertexAt(outline, frame, nextOf(outline, edge),
                        outline.from(edge) + (length.si() / before) * way);
}

GeoRing withEdgeHeading(const Outline& outline, const LocalFrame& frame, std::size_t edge, Angle heading) {
    const double length = distance(outline.from(edge), outline.to(edge));
    return withVertexAt(outline, frame, nextOf(outline, edge),
                        outline.from(edge) + length * direction(heading.si()));
}

GeoRing withAllMoved(const Outline& outline, const LocalFrame& frame, Point way) {
    std::vector<Point> points = outline.points;
    for (Point& point : points) {
        point = point + way;
    }
    return frame.toGeo(points);
}

GeoRing turnedRing(GeoRing places, const LocalFrame& frame, bool counterClockwise) {
    if ((signedAreaM2(frame.toLocal(places)) > 0.0) != counterClockwise) {
        std::ranges::reverse(places);
    }
    return places;
}

Angle cornerAngle(const Outline& outline, std::size_t vertex) {
    const Point here = outline.points[vertex];
    const Point before = outline.points[lastOf(outline, vertex)] - here;
    const Point after = outline.points[nextOf(outline, vertex)] - here;
    const bool leftInside = !outline.closed || signedAreaM2(outline.points) > 0.0;
    const double turn = leftInside ? std::atan2(cross(after, before), dot(after, before))
                                   : std::atan2(cross(before, after), dot(before, after));
    return radians(turn < 0.0 ? turn + 2.0 * std::numbers::pi : turn);
}

}  // namespace furrow
