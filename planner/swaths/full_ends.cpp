#include "planner/swaths/full_ends.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/tolerances.h"
#include "planner/swaths/clamped_integral.h"
#include "planner/swaths/methods.h"
#include "planner/turns/rig_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace furrow {

namespace {

/// Polygons turned so that swaths run along x, with their edges sorted into bands across.
class TurnedEdges {
public:
    TurnedEdges(const MultiPolygon& polygons, Point along, double bandM) : bandM_{bandM} {
        const auto add = [&](const Ring& ring) {
            Ring turned;
            for (const Point& point : ring) {
                turned.push_back({dot(along, point), cross(along, point)});
                lowY_ = std::min(lowY_, turned.back().y);
                highY_ = std::max(highY_, turned.back().y);
            }
            rings_.push_back(std::move(turned));
        };
        for (const Polygon& polygon : polygons) {
            add(polygon.outer);
            std::ranges::for_each(polygon.holes, add);
        }
        sortIntoBands();
    }

    struct Edge {
        std::size_t ring = 0;
        std::size_t index = 0;
    };

    Point vertex(std::size_t ring, std::size_t index) const {
        return rings_[ring][index % rings_[ring].size()];
    }
    std::size_t ringSize(std::size_t ring) const { return rings_[ring].size(); }

    /// Calls visit(edge, from, to) for every edge that may touch heights from low to high; for some edges
    /// twice.
    template <class Visit>
    void between(double low, double high, const Visit& visit) const {
        if (bands_.empty() || high < lowY_ || low > highY_) {
            return;
        }
        for (std::size_t band = bandOf(low); band <= bandOf(high); ++band) {
            for (const Edge& edge : bands_[band]) {
                visit(edge, vertex(edge.ring, edge.index), vertex(edge.ring, edge.index + 1));
            }
        }
    }

private:
    std::size_t bandOf(double y) const {
        const double band = std::clamp((y - lowY_) / bandM_, 0.0, static_cast<double>(bands_.size() - 1));
        return static_cast<std::size_t>(band);
    }

    void sortIntoBands() {
        if (rings_.empty()) {
            return;
        }
        bands_.resize(static_cast<std::size_t>((highY_ - lowY_) / bandM_) + 1);
        for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
            for (std::size_t i = 0; i < rings_[ring].size(); ++i) {
                const double from = vertex(ring, i).y;
                const double to = vertex(ring, i + 1).y;
                for (std::size_t band = bandOf(std::min(from, to)); band <= bandOf(std::max(from, to));
                     ++band) {
                    bands_[band].push_back({ring, i});
                }
            }
        }
    }

    double bandM_;
    double lowY_ = std::numeric_limits<double>::infinity();
    double highY_ = -std::numeric_limits<double>::infinity();
    std::vector<Ring> rings_;
    std::vector<std::vector<Edge>> bands_;
};

/// The part of an edge between two heights. Empty if there is none.
struct Piece {
    Point from;
    Point to;
};
std::optional<Piece> clipped(Point a, Point b, double low, double high) {
    const auto at = [&](double y) { return Point{a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), y}; };
    if (std::max(a.y, b.y) < low || std::min(a.y, b.y) > high) {
        return std::nullopt;
    }
    const auto clamp = [&](Point p) { return p.y < low ? at(low) : p.y > high ? at(high) : p; };
    return Piece{clamp(a), clamp(b)};
}

/// One end of a swath in the turned frame. Ahead is +x for the far end, -x for the near one.
struct End {
    double x = 0.0;
    double y = 0.0;
    double ahead = 1.0;
};

/// The distance from the end to the first edge ahead within a band of heights. Infinite if there is none.
double freeAhead(const TurnedEdges& edges, const End& end, double halfWidthM) {
    const double low = end.y - halfWidthM + kContactM;
    const double high = end.y + halfWidthM - kContactM;
    double free = std::numeric_limits<double>::infinity();
    edges.between(low, high, [&](TurnedEdges::Edge, Point a, Point b) {
        if (const auto piece = clipped(a, b, low, high)) {
            const double from = end.ahead * (piece->from.x - end.x);
            const double to = end.ahead * (piece->to.x - end.x);
            if (std::max(from, to) > kContactM) {
                free = std::min(free, std::max(0.0, std::min(from, to)));
            }
        }
    });
    return free;
}

/// The mainland's edge at a swath's end, across the strip from side to side, as long as it runs across.
std::vector<Piece> edgeAcross(const TurnedEdges& mainland, const End& end, double halfWidthM) {
    std::optional<TurnedEdges::Edge> crossing;
    double nearest = kContactM;
    mainland.between(end.y, end.y, [&](TurnedEdges::Edge edge, Point a, Point b) {
        if ((a.y <= end.y) != (b.y <= end.y)) {
            const double x = a.x + (b.x - a.x) * (end.y - a.y) / (b.y - a.y);
            if (std::abs(x - end.x) < nearest) {
                nearest = std::abs(x - end.x);
                crossing = edge;
            }
        }
    });
    std::vector<Piece> across;
    if (!crossing) {
        return across;
    }
    const double low = end.y - halfWidthM;
    const double high = end.y + halfWidthM;
    const std::size_t size = mainland.ringSize(crossing->ring);
    const Point a = mainland.vertex(crossing->ring, crossing->index);
    const Point b = mainland.vertex(crossing->ring, crossing->index + 1);
    const bool rising = b.y > a.y;
    across.push_back(*clipped(a, b, low, high));
    // Up in one direction round the ring and down in the other, until the edge turns back or leaves the
    // strip.
    for (const bool up : {true, false}) {
        const bool onwards = up == rising;
        std::size_t at = onwards ? crossing->index + 1 : crossing->index;
        for (std::size_t steps = 0; steps < size; ++steps) {
            const std::size_t next = onwards ? at + 1 : at + size - 1;
            const Point from = mainland.vertex(crossing->ring, at);
            const Point to = mainland.vertex(crossing->ring, next);
            const bool turnsBack = up ? to.y < from.y : to.y > from.y;
            const auto piece = clipped(from, to, low, high);
            if (turnsBack || !piece) {
                break;
            }
            across.push_back(*piece);
            at = next % size;
        }
    }
    return across;
}

struct Machinery {
    double halfWidthM;      // of the implement at work
    double halfImplementM;  // along the swath
    double halfTractorM;    // width
    double aheadM;          // distance that the tractor reaches beyond the implement, the larger of both
                            // directions
    double axleAheadM;      // distance of the reference point from the implement
    double axleBesideM;
    TurningReach reach;  // round the reference point
};

Machinery machineryOf(const Machine& machine) {
    const Tractor& tractor = machine.spec().tractor;
    const Implement& implement = machine.spec().implement;
    const Length front = tractor.length - tractor.rearOverhang;
    return {.halfWidthM = 0.5 * implement.operatingWidth.si(),
            .halfImplementM = 0.5 * implement.length.si(),
            .halfTractorM = 0.5 * tractor.width.si(),
            .aheadM = std::max(front - implement.offset, implement.offset + tractor.rearOverhang).si(),
            .axleAheadM = std::abs(implement.offset.si()),
            .axleBesideM = std::abs(implement.lateralOffset.si()),
            .reach = turningReach(machine)};
}

/// Extends ends of swaths that run along one direction.
class EndDrawer {
public:
    EndDrawer(SwathSet& set, Point along, const MultiPolygon& mainland, const EndRoom& room,
              const Machine& machine)
        : set_{set},
          along_{along},
          left_{-along_.y, along_.x},
          machinery_{machineryOf(machine)},
          mainland_{mainland, along_, 2.0 * machinery_.halfWidthM},
          working_{room.working, along_, 2.0 * machinery_.halfWidthM},
          implement_{room.driving.implement(), along_, 2.0 * machinery_.halfWidthM},
          tractor_{room.driving.tractor(), along_, 2.0 * machinery_.halfWidthM},
          turningM_{room.turning.si()},
          drawsIn_{room.drawsIn},
          turnsOnTheSpot_{room.turnsOnTheSpot},
          drawsOut_{room.drawsOut} {}

    void drawStraightOnes() {
        for (Swath& swath : set_.swaths) {
            if (swath.isCurved()) {
                continue;
            }
            const double y = cross(along_, swath.start);
            const double halfM = 0.5 * swath.length().si();
            const double from = drawnOut({.x = dot(along_, swath.start), .y = y, .ahead = -1.0}, halfM);
            const double to = drawnOut({.x = dot(along_, swath.end), .y = y, .ahead = 1.0}, halfM);
            swath.start = from * along_ + y * left_;
            swath.end = to * along_ + y * left_;
        }
    }

    /// The length by which a line with this end, along the drawer's direction, is extended.
    /// @param most  by which it may be shortened
    Length beyond(Point end, Length most) {
        const double x = dot(along_, end);
        return metres(drawnOut({.x = x, .y = cross(along_, end), .ahead = 1.0}, most.si()) - x);
    }

private:
    /// The length by which an end has to be shortened. Tractor and implement then stay in the allowed area in
    /// both directions of driving.
    double tooFar(const End& end, double mostM) const {
        const double reachM = machinery_.axleAheadM + machinery_.reach.whole.si();
        const double backM = std::min(mostM, std::max(machinery_.aheadM + machinery_.halfWidthM, reachM));
        const End before{.x = end.x - end.ahead * backM, .y = end.y, .ahead = end.ahead};
        const double free =
            std::min(freeAhead(implement_, before, machinery_.halfWidthM) - machinery_.halfImplementM,
                     freeAhead(tractor_, before, machinery_.halfTractorM) - machinery_.aheadM);
        const double turning = turnsOnTheSpot_
                                   ? std::min(freeToTurn(tractor_, before, machinery_.reach.tractor),
                                              freeToTurn(implement_, before, machinery_.reach.whole))
                                   : free;
        return std::clamp(backM - (turning > 0.0 ? std::min(free, turning) : free), 0.0, mostM);
    }

    /// How far the machine may go on until it has no room to turn on the spot.
    double freeToTurn(const TurnedEdges& edges, const End& end, Length reach) const {
        return freeAhead(edges, end, machinery_.axleBesideM + reach.si()) - machinery_.axleAheadM -
               reach.si();
    }

    double drawnOut(const End& end, double mostM) {
        if (const double back = drawsIn_ ? tooFar(end, mostM) : 0.0; back > 0.0) {
            return end.x - end.ahead * back;
        }
        if (!drawsOut_) {
            return end.x;
        }
        const std::vector<Piece> across = edgeAcross(mainland_, end, machinery_.halfWidthM);
        double wanted = 0.0;
        for (const Piece& piece : across) {
            wanted = std::max({wanted, end.ahead * (piece.from.x - end.x), end.ahead * (piece.to.x - end.x)});
        }
        if (wanted <= kContactM) {
            return end.x;
        }
        // The turn goes to one of the neighbours, so the room is one width more on both sides.
        const double free =
            std::min({freeAhead(working_, end, machinery_.halfWidthM),
                      freeAhead(implement_, end, machinery_.halfWidthM) - machinery_.halfImplementM,
                      freeAhead(tractor_, end, machinery_.halfTractorM) - machinery_.aheadM,
                      freeAhead(implement_, end, 3.0 * machinery_.halfWidthM) - turningM_});
        const double more = std::clamp(free, 0.0, wanted);
        set_.endOverlap += squareMetres(areaBeyond(end, across, more));
        return end.x + end.ahead * more;
    }

    /// The area of the added strip that lies outside the mainland.
    double areaBeyond(const End& end, const std::vector<Piece>& across, double more) const {
        double inside = 0.0;
        for (const Piece& piece : across) {
            const Point from{end.ahead * (piece.from.x - end.x), piece.from.y};
            const Point to{end.ahead * (piece.to.x - end.x), piece.to.y};
            inside += std::abs(clampedIntegral(from, to, {0.0, more}));
        }
        return std::max(0.0, 2.0 * machinery_.halfWidthM * more - inside);
    }

    SwathSet& set_;
    Point along_;
    Point left_;
    Machinery machinery_;
    TurnedEdges mainland_;
    TurnedEdges working_;
    TurnedEdges implement_;  ///< edges of its area
    TurnedEdges tractor_;
    double turningM_;
    bool drawsIn_;
    bool turnsOnTheSpot_;
    bool drawsOut_;
};

/// Adds the stretches of a line in which edges lie within a band beside it.
/// @param ahead  how far the machine reaches beyond its place on the line
void addReached(const TurnedEdges& edges, double y, double halfBandM, double ahead,
                std::vector<Interval>& reached) {
    const double low = y - halfBandM + kContactM;
    const double high = y + halfBandM - kContactM;
    edges.between(low, high, [&](TurnedEdges::Edge, Point a, Point b) {
        if (const auto piece = clipped(a, b, low, high)) {
            reached.push_back({std::min(piece->from.x, piece->to.x) - ahead + kContactM,
                               std::max(piece->from.x, piece->to.x) + ahead - kContactM});
        }
    });
}

/// What is left of a stretch.
std::vector<Interval> without(Interval whole, std::vector<Interval> taken) {
    std::ranges::sort(taken, {}, &Interval::from);
    std::vector<Interval> left;
    double from = whole.from;
    for (const Interval& each : taken) {
        if (each.from > from) {
            left.push_back({from, std::min(each.from, whole.to)});
        }
        from = std::max(from, each.to);
        if (from >= whole.to) {
            return left;
        }
    }
    left.push_back({from, whole.to});
    return left;
}

constexpr Choice kEndKinds[] = {
    {"full", "Full width", "Drawn out until the whole width is covered, as far as there is room."},
    {"centre", "Centre line", "Where the middle of the swath meets the headland."},
};

}  // namespace

void drawOutEnds(SwathSet& set, const MultiPolygon& mainland, const EndRoom& room, const Machine& machine) {
    EndDrawer{set, direction(set.heading.si()), mainland, room, machine}.drawStraightOnes();
    set.totalLength = {};
    for (Swath& swath : set.swaths) {
        if (swath.isCurved() && !swath.isClosed()) {
            // Each end is extended straight, in its own direction.
            const Pose end = swath.curve.end();
            const auto drawn = [&](Point from, Point along) {
                // Curves are never shortened.
                return EndDrawer{set, along, mainland, room, machine}.beyond(from, Length{});
            };
            const Length before = drawn(swath.start, -1.0 * direction(swath.curve.start.heading.si()));
            const Length after = drawn(swath.end, direction(end.heading.si()));
            swath.curve = extended(swath.curve, before, after);
            swath.start = swath.curve.start.position;
            swath.end = swath.curve.end().position;
        }
        set.totalLength += swath.length();
    }
}

SwathSet withoutReachingOver(SwathSet set, const AllowedAreas& driving, const Machine& machine) {
    const Point along = direction(set.heading.si());
    const Point left{-along.y, along.x};
    const Machinery machinery = machineryOf(machine);
    const TurnedEdges implement{driving.implement(), along, 2.0 * machinery.halfWidthM};
    const TurnedEdges tractor{driving.tractor(), along, 2.0 * machinery.halfWidthM};
    std::vector<Swath> kept;
    for (const Swath& swath : set.swaths) {
        if (swath.isCurved()) {
            kept.push_back(swath);
            continue;
        }
        const double y = cross(along, swath.start);
        std::vector<Interval> reached;
        addReached(implement, y, machinery.halfWidthM, machinery.halfImplementM, reached);
        addReached(tractor, y, machinery.halfTractorM, machinery.aheadM, reached);
        for (const Interval& piece :
             without({dot(along, swath.start), dot(along, swath.end)}, std::move(reached))) {
            kept.push_back(swath);
            kept.back().start = piece.from * along + y * left;
            kept.back().end = piece.to * along + y * left;
        }
    }
    set.swaths = std::move(kept);
    set.totalLength = {};
    for (const Swath& swath : set.swaths) {
        set.totalLength += swath.length();
    }
    return set;
}

bool drawsOutEnds(const Settings& settings) {
    return settings.choice(kEnds) == "full";
}

const Parameter kEnds{.key = "swaths.ends",
                      .name = "Ends",
                      .description = "Where a swath ends at a slanting edge.",
                      .kind = ParameterKind::Choice,
                      .standard = 0.0,
                      .choices = kEndKinds};

}  // namespace furrow
