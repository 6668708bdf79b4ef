#include "planner/field/overhung_land.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// Corners of a quarter of a round end. Its chords lie inside the arc, so the area is never too large.
constexpr int kQuarterCorners = 8;

/// An edge of the boundary with the field on its left, and how far an implement may stand over it.
struct HungEdge {
    Point from;
    Point to;
    Length overhang;
    std::size_t next = 0;  ///< of its ring

    Point along() const { return (1.0 / distance(from, to)) * (to - from); }
    Point outwards() const { return {along().y, -along().x}; }
};

std::vector<HungEdge> hungEdges(const Field& field, Length least) {
    std::vector<HungEdge> edges;
    forEachEdge(field.boundary(), [&](Point from, Point to) {
        const WideEdge* const given = edgeWith(field.edgeOverhangs(), from, to);
        edges.push_back(
            {.from = from, .to = to, .overhang = given != nullptr ? std::max(least, given->width) : least});
    });
    std::size_t first = 0;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool isLast = i + 1 == edges.size() || edges[i + 1].from != edges[i].to;
        edges[i].next = isLast ? first : i + 1;
        first = isLast ? i + 1 : first;
    }
    return edges;
}

/// The land outside an edge with a quarter of a disc at either end. Its points on the edge are those of the
/// boundary, so that it joins the field without a gap.
Ring stripOutside(const HungEdge& edge) {
    const double farM = edge.overhang.si();
    Ring ring{edge.to, edge.from};
    for (int i = 0; i <= kQuarterCorners; ++i) {
        const double turn = 0.5 * std::numbers::pi * i / kQuarterCorners;
        ring.push_back(edge.from - farM * std::cos(turn) * edge.along() +
                       farM * std::sin(turn) * edge.outwards());
    }
    for (int i = kQuarterCorners; i >= 0; --i) {
        const double turn = 0.5 * std::numbers::pi * i / kQuarterCorners;
        ring.push_back(edge.to + farM * std::cos(turn) * edge.along() +
                       farM * std::sin(turn) * edge.outwards());
    }
    return ring;
}

Ring discAround(Point middle, double radiusM) {
    Ring ring;
    for (int i = 0; i < 4 * kQuarterCorners; ++i) {
        ring.push_back(middle + radiusM * direction(0.5 * std::numbers::pi * i / kQuarterCorners));
    }
    return ring;
}

bool areNear(const HungEdge& a, const HungEdge& b, double awayM) {
    const auto apart = [awayM](double a0, double a1, double b0, double b1) {
        return std::max(a0, a1) + awayM < std::min(b0, b1) || std::max(b0, b1) + awayM < std::min(a0, a1);
    };
    return !apart(a.from.x, a.to.x, b.from.x, b.to.x) && !apart(a.from.y, a.to.y, b.from.y, b.to.y);
}

/// The land in front of the edges with less overhang, as far as the strip of this edge may reach. An
/// implement that stands there has crossed one of them.
MultiPolygon keptBy(const std::vector<HungEdge>& edges, const HungEdge& hung) {
    MultiPolygon kept;
    const double farM = hung.overhang.si();
    const auto isLower = [&](const HungEdge& edge) { return edge.overhang < hung.overhang; };
    for (const HungEdge& edge : edges) {
        if (!isLower(edge) || !areNear(edge, hung, 2.0 * farM)) {
            continue;
        }
        const Point away = farM * edge.outwards();
        kept.push_back({.outer = {edge.from, edge.from + away, edge.to + away, edge.to}, .holes = {}});
        if (isLower(edges[edge.next])) {
            kept.push_back({.outer = discAround(edge.to, farM), .holes = {}});
        }
    }
    return kept;
}

/// The boundary, and the land outside its edges up to their overhang.
Result<MultiPolygon> overEdges(const Field& field, Length least, const JobContext& job) {
    auto land = least > Length{} ? dilated(field.boundary(), least, kArcTolerance, job)
                                 : Result<MultiPolygon>{field.boundary()};
    if (!land || field.edgeOverhangs().empty()) {
        return land;
    }
    const std::vector<HungEdge> edges = hungEdges(field, least);
    for (const HungEdge& edge : edges) {
        if (edge.overhang <= least) {
            continue;
        }
        const MultiPolygon strip{{.outer = stripOutside(edge), .holes = {}}};
        const auto free = unionOf(keptBy(edges, edge), job).and_then([&](const MultiPolygon& kept) {
            return kept.empty() ? Result<MultiPolygon>{strip} : difference(strip, kept, job, kSnapGrid);
        });
        if (!free) {
            return free;
        }
        std::ranges::copy(*free, std::back_inserter(*land));
    }
    return unionOf(*land, job, kSnapGrid);
}

}  // namespace

Result<std::optional<MultiPolygon>> overhungLand(const Field& field, Length least, const JobContext& job) {
    const auto isHung = [](const auto& given, auto width) {
        return std::ranges::any_of(given, [](Length each) { return each > Length{}; }, width);
    };
    if (least <= Length{} && !isHung(field.edgeOverhangs(), &WideEdge::width) &&
        !isHung(field.impassable(), &ImpassableObstacle::overhang)) {
        return std::nullopt;
    }
    MultiPolygon forbidden;
    for (const ImpassableObstacle& obstacle : field.impassable()) {
        const Length overhang = std::max(least, obstacle.overhang);
        auto core = overhang > Length{} ? eroded(obstacle.outline, overhang, kArcTolerance, job)
                                        : Result<MultiPolygon>{obstacle.outline};
        if (!core) {
            return std::unexpected(core.error());
        }
        std::ranges::move(*core, std::back_inserter(forbidden));
    }
    return overEdges(field, least, job)
        .and_then([&](MultiPolygon&& land) -> Result<std::optional<MultiPolygon>> {
            if (forbidden.empty()) {
                return std::optional{std::move(land)};
            }
            return unionOf(forbidden, job)
                .and_then([&](const MultiPolygon& one) { return difference(land, one, job, kSnapGrid); })
                .transform([](MultiPolygon&& rest) { return std::optional{std::move(rest)}; });
        });
}

}  // namespace furrow
