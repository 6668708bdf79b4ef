#include "planner/editing/shape_hit.h"

#include "planner/geometry/segment.h"

#include <algorithm>
#include <limits>

namespace furrow {

std::optional<ShapeHit> hitAt(const FieldShape& shape, Point place, Length reach) {
    std::optional<ShapeHit> best;
    double nearest = reach.si();
    const auto offer = [&](ShapeHit::Kind kind, const OutlineId& id, std::size_t index, Point at) {
        const double away = distance(at, place);
        if (away <= nearest) {
            nearest = away;
            best = ShapeHit{.kind = kind, .outline = id, .index = index, .place = at};
        }
    };
    for (std::size_t i = 0; i < shape.gates.size(); ++i) {
        offer(ShapeHit::Kind::Gate, {}, i, shape.gates[i]);
    }
    if (best) {
        return best;
    }
    for (const Outline& outline : shape.outlines) {
        for (std::size_t i = 0; i < outline.points.size(); ++i) {
            offer(ShapeHit::Kind::Vertex, outline.id, i, outline.points[i]);
        }
    }
    if (best) {
        return best;
    }
    for (const Outline& outline : shape.outlines) {
        for (std::size_t i = 0; i < outline.edgeCount(); ++i) {
            offer(ShapeHit::Kind::Edge, outline.id, i,
                  nearestOnSegment(place, outline.from(i), outline.to(i)));
        }
    }
    if (best) {
        return best;
    }
    for (const Outline& outline : shape.outlines) {
        const bool area = outline.id.kind == OutlineKind::Hole || outline.id.kind == OutlineKind::Obstacle;
        if (area && outline.points.size() >= 3 && isInside(outline.points, place)) {
            best =
                ShapeHit{.kind = ShapeHit::Kind::Inside, .outline = outline.id, .index = 0, .place = place};
        }
    }
    return best;
}

std::optional<std::size_t> partAt(const FieldShape& shape, Point place) {
    for (const Outline& outline : shape.outlines) {
        if (outline.id.kind == OutlineKind::Boundary && outline.points.size() >= 3 &&
            isInside(outline.points, place)) {
            return outline.id.item;
        }
    }
    return std::nullopt;
}

std::optional<Point> nearestOnBoundary(const FieldShape& shape, Point place) {
    std::optional<Point> best;
    for (const Outline& outline : shape.outlines) {
        if (outline.id.kind != OutlineKind::Boundary && outline.id.kind != OutlineKind::Hole) {
            continue;
        }
        for (std::size_t i = 0; i < outline.edgeCount(); ++i) {
            const Point at = nearestOnSegment(place, outline.from(i), outline.to(i));
            if (!best || distance(at, place) < distance(*best, place)) {
                best = at;
            }
        }
    }
    return best;
}

}  // namespace furrow
