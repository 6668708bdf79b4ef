#include "planner/editing/snapping.h"

#include "planner/editing/shape_hit.h"
#include "planner/geometry/segment.h"

#include <cmath>

namespace furrow {

namespace {

struct Candidate {
    Point place;
    double away;
    const SnapLine* line = nullptr;  ///< null for an edge
    Point from;                      ///< of the edge
    Point to;
};

Point nearestOnLine(const SnapLine& line, Point place) {
    return line.through + dot(place - line.through, line.along) * line.along;
}

std::optional<Point> crossing(Point a, Point alongA, Point b, Point alongB) {
    const double sine = cross(alongA, alongB);
    // Below about 6 degrees, the crossing jumps with every pixel.
    if (std::abs(sine) < 0.1) {
        return std::nullopt;
    }
    return a + (cross(b - a, alongB) / sine) * alongA;
}

Point unit(Point way) {
    const double length = norm(way);
    return length > 0.0 ? (1.0 / length) * way : Point{};
}

}  // namespace

std::vector<SnapLine> angleLines(Point anchor, Point before) {
    const Point along = unit(anchor - before);
    if (norm(along) == 0.0) {
        return {};
    }
    return {{anchor, {-along.y, along.x}, SnapKind::RightAngle}, {anchor, along, SnapKind::Straight}};
}

Snap snapped(const FieldShape& shape, Point place, Length reach, std::span<const SnapLine> lines,
             std::optional<std::pair<OutlineId, std::size_t>> except) {
    Snap snap{.place = place, .kinds = {}, .from = {}};
    double nearest = reach.si();
    std::vector<Candidate> candidates;
    for (const Outline& outline : shape.outlines) {
        const bool own = except && except->first == outline.id;
        for (std::size_t i = 0; i < outline.points.size(); ++i) {
            if (own && except->second == i) {
                continue;
            }
            if (const double away = distance(outline.points[i], place); away <= nearest) {
                nearest = away;
                snap = {.place = outline.points[i], .kinds = {SnapKind::Vertex}, .from = {}};
            }
        }
        for (std::size_t edge = 0; edge < outline.edgeCount(); ++edge) {
            const std::size_t next = edge + 1 == outline.points.size() ? 0 : edge + 1;
            if (own && (except->second == edge || except->second == next)) {
                continue;
            }
            const Point at = nearestOnSegment(place, outline.from(edge), outline.to(edge));
            if (const double away = distance(at, place); away <= reach.si()) {
                candidates.push_back({at, away, nullptr, outline.from(edge), outline.to(edge)});
            }
        }
    }
    if (snap.isSnapped()) {
        return snap;
    }
    for (const SnapLine& line : lines) {
        const Point at = nearestOnLine(line, place);
        if (const double away = distance(at, place); away <= reach.si()) {
            candidates.push_back({at, away, &line, {}, {}});
        }
    }
    const auto take = [&snap](Point at, std::initializer_list<const Candidate*> met) {
        snap = {.place = at, .kinds = {}, .from = {}};
        for (const Candidate* candidate : met) {
            snap.kinds.push_back(candidate->line == nullptr ? SnapKind::Edge : candidate->line->kind);
            if (candidate->line != nullptr) {
                snap.from.push_back(candidate->line->through);
            }
        }
    };
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        for (std::size_t j = i + 1; j < candidates.size(); ++j) {
            const auto ray = [](const Candidate& each) {
                return each.line == nullptr ? std::pair{each.from, unit(each.to - each.from)}
                                            : std::pair{each.line->through, each.line->along};
            };
            const auto [a, alongA] = ray(candidates[i]);
            const auto [b, alongB] = ray(candidates[j]);
            const auto at = crossing(a, alongA, b, alongB);
            if (at && distance(*at, place) <= nearest) {
                nearest = distance(*at, place);
                take(*at, {&candidates[i], &candidates[j]});
            }
        }
    }
    if (snap.isSnapped()) {
        return snap;
    }
    for (const Candidate& candidate : candidates) {
        if (candidate.away <= nearest) {
            nearest = candidate.away;
            take(candidate.place, {&candidate});
        }
    }
    return snap;
}

}  // namespace furrow
