#include "planner/headland/smooth_ring.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>
#include <vector>

namespace furrow {

namespace {

constexpr double kSamePointM = 0.01;
// Largest distance from a corner to its rounding if the radius leaves a choice.
constexpr double kCornerSlackM = 0.01;
// Two corners can become one if their turns sum to less.
constexpr double kWidestMergeRad = std::numbers::pi / 2.0;
// Corners of an arc matter equally. Rounding errors must not decide which of them is removed.
constexpr double kTieM = 1e-4;
// Rounding never turns the vehicle on the spot.
constexpr double kSharpestRad = 0.95 * std::numbers::pi;
// Edges with a smaller difference of heading are one line.
constexpr double kStraightRad = 1e-9;
// A radius counts as kept if only rounding errors are missing.
constexpr double kRadiusSlack = 1.0 + 1e-9;

struct Corner {
    Point at;
    double turnRad = 0.0;  ///< to the left
    double needM = 0.0;    ///< length needed of both edges, for the smallest radius
    double wantM = 0.0;    ///< the same for a gentle bend
    double lengthM = 0.0;  ///< of the edge to the next corner
    Point way;             ///< unit vector of that edge
    bool isCut = false;    ///< one line ends and another begins here: nothing is rounded
};

Ring withoutCloseOnes(const Ring& ring) {
    Ring kept;
    for (const Point& point : ring) {
        if (kept.empty() || distance(kept.back(), point) >= kSamePointM) {
            kept.push_back(point);
        }
    }
    while (kept.size() > 1 && distance(kept.back(), kept.front()) < kSamePointM) {
        kept.pop_back();
    }
    return kept;
}

/// Merges two corners in the same direction with too short an edge between them. The new corner is where the
/// edges before and after meet. Empty if its rounding would not pass close to the edge.
std::optional<Point> oneCornerFor(const Corner& a, const Corner& b, double radiusM, double toleranceM) {
    const double turn = a.turnRad + b.turnRad;
    if (a.turnRad * b.turnRad <= 0.0 || std::abs(turn) > kWidestMergeRad) {
        return std::nullopt;
    }
    // The triangle on the edge with the two turns as its angles.
    const double alongM = a.lengthM * std::sin(b.turnRad) / std::sin(turn);
    const double heightM = alongM * std::abs(std::sin(a.turnRad));
    const double roundedM = radiusM * (1.0 / std::cos(0.5 * turn) - 1.0);
    if (std::abs(heightM - roundedM) > toleranceM) {
        return std::nullopt;
    }
    const double heading = std::atan2(a.way.y, a.way.x) - a.turnRad;
    return a.at + alongM * direction(heading);
}

/// The corners of a ring while points are removed. The remaining corners are linked, and only changes are
/// computed again.
class CornerChain {
public:
    /// @param sharpestRad  corners with a larger turn are cut; without a value, none is cut
    CornerChain(const Ring& ring, double radiusM, double toleranceM, double gentleM,
                std::optional<double> sharpestRad = std::nullopt)
        : radiusM_{radiusM},
          toleranceM_{toleranceM},
          gentleM_{gentleM},
          sharpestRad_{sharpestRad},
          left_{ring.size()} {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            corners_.push_back({.at = ring[i]});
            links_.push_back({(i + ring.size() - 1) % ring.size(), (i + 1) % ring.size()});
        }
        for (std::size_t i = 0; i < ring.size(); ++i) {
            measureEdge(i);
        }
        for (std::size_t i = 0; i < ring.size(); ++i) {
            measureTurn(i);
            pending_.push_back(ring.size() - 1 - i);
        }
    }

    /// Removes points until every edge is long enough for its corners. False if that is not possible.
    bool makeDrivable() {
        while (!pending_.empty()) {
            const std::size_t i = pending_.back();
            pending_.pop_back();
            while (!gone_.contains(i) &&
                   corners_[i].needM + corners_[links_[i].next].needM > corners_[i].lengthM) {
                if (left_ <= 3 || !shorten(i)) {
                    if (!sharpestRad_) {
                        return false;
                    }
                    cut(corners_[i].needM >= corners_[links_[i].next].needM - kTieM ? i : links_[i].next);
                }
            }
        }
        return true;
    }

    std::vector<Corner> take() const {
        std::vector<Corner> kept;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            if (!gone_.contains(i)) {
                kept.push_back(corners_[i]);
            }
        }
        return kept;
    }

private:
    struct Links {
        std::size_t before;
        std::size_t next;
    };

    void measureEdge(std::size_t i) {
        const Point way = corners_[links_[i].next].at - corners_[i].at;
        corners_[i].lengthM = norm(way);
        corners_[i].way = (1.0 / corners_[i].lengthM) * way;
    }

    void measureTurn(std::size_t i) {
        Corner& corner = corners_[i];
        const Point before = corners_[links_[i].before].way;
        corner.turnRad = std::atan2(cross(before, corner.way), dot(before, corner.way));
        const double turn = std::abs(corner.turnRad);
        corner.isCut = corner.isCut || (sharpestRad_ && turn > *sharpestRad_);
        if (corner.isCut) {
            corner.needM = corner.wantM = 0.0;
            return;
        }
        corner.needM = turn > kStraightRad ? radiusM_ * kRadiusSlack * std::tan(0.5 * turn) : 0.0;
        // The middle of the arc is t tan(turn / 4) away from the corner.
        corner.wantM = turn > kStraightRad
                           ? std::max({corner.needM, gentleM_, kCornerSlackM / std::tan(0.25 * turn)})
                           : 0.0;
    }

    void cut(std::size_t i) {
        corners_[i].isCut = true;
        measureTurn(i);
    }

    /// The edge after i is too short. Its corners become one, or the less important one is removed.
    bool shorten(std::size_t i) {
        const std::size_t next = links_[i].next;
        const bool cutAtOne = corners_[i].isCut || corners_[next].isCut;
        if (const auto meeting =
                cutAtOne ? std::nullopt : oneCornerFor(corners_[i], corners_[next], radiusM_, toleranceM_)) {
            corners_[i].at = *meeting;
            drop(next);
            return true;
        }
        const bool firstGoes =
            corners_[next].isCut || (!corners_[i].isCut && moveWithout(i) <= moveWithout(next) + kTieM);
        const std::size_t gone = firstGoes ? i : next;
        if (moveWithout(gone) > toleranceM_) {
            return false;
        }
        drop(gone);
        return true;
    }

    /// The distance that the ring moves if a point is removed.
    double moveWithout(std::size_t i) const {
        const Point before = corners_[links_[i].before].at;
        const Point way = corners_[links_[i].next].at - before;
        const double length = norm(way);
        const Point here = corners_[i].at - before;
        return length > 0.0 ? std::abs(cross(way, here)) / length : norm(here);
    }

    void drop(std::size_t i) {
        const auto [before, next] = links_[i];
        links_[before].next = next;
        links_[next].before = before;
        gone_.insert(i);
        --left_;
        const std::size_t first = links_[before].before;
        for (const std::size_t edge : {first, before, next}) {
            measureEdge(edge);
        }
        for (const std::size_t corner : {first, before, next, links_[next].next}) {
            measureTurn(corner);
            pending_.push_back(corner);
        }
        pending_.push_back(links_[first].before);
    }

    double radiusM_;
    double toleranceM_;
    double gentleM_;
    std::optional<double> sharpestRad_;
    std::size_t left_;
    std::vector<Corner> corners_;
    std::vector<Links> links_;
    std::unordered_set<std::size_t> gone_;
    std::vector<std::size_t> pending_;
};

/// The distance from each corner to the ends of its rounding.
std::vector<double> roundingsOf(const std::vector<Corner>& corners) {
    const std::size_t size = corners.size();
    std::vector<double> cuts(size);
    for (std::size_t i = 0; i < size; ++i) {
        const Corner& before = corners[(i + size - 1) % size];
        const Corner& corner = corners[i];
        const Corner& next = corners[(i + 1) % size];
        // The corners at both ends of an edge share the length that they do not need.
        const double spareBefore = 0.5 * (before.lengthM - before.needM - corner.needM);
        const double spareAfter = 0.5 * (corner.lengthM - corner.needM - next.needM);
        cuts[i] = std::min(corner.wantM, corner.needM + std::min(spareBefore, spareAfter));
    }
    return cuts;
}

/// The line from the end of one corner's rounding over `edges` edges: straights, and arcs round the corners
/// between. If it closes, also the arc round the first corner.
Curve lineThrough(const std::vector<Corner>& corners, const std::vector<double>& cuts, std::size_t from,
                  std::size_t edges, bool closes) {
    const std::size_t size = corners.size();
    const Corner& first = corners[from];
    Curve line{.type = {},
               .start = {.position = first.at + cuts[from] * first.way,
                         .heading = radians(std::atan2(first.way.y, first.way.x))},
               .pieces = {}};
    for (std::size_t i = 1; i <= edges; ++i) {
        const std::size_t before = (from + i - 1) % size;
        const std::size_t at = (from + i) % size;
        const Corner& corner = corners[at];
        if (const double straightM = corners[before].lengthM - cuts[before] - cuts[at]; straightM > 1e-9) {
            line.pieces.push_back({.length = metres(straightM), .curvature = {}});
        }
        if ((i < edges || closes) && std::abs(corner.turnRad) > kStraightRad) {
            const double radiusM = cuts[at] / std::tan(0.5 * std::abs(corner.turnRad));
            line.pieces.push_back(
                {.length = metres(radiusM * std::abs(corner.turnRad)),
                 .curvature = Curvature::fromSi(std::copysign(1.0 / radiusM, corner.turnRad))});
            line.pieces.back().endCurvature = line.pieces.back().curvature;
        }
    }
    return line;
}

}  // namespace

std::optional<Curve> smoothRing(const Ring& given, Length radius, Length tolerance, Length gentle) {
    const Ring ring = withoutCloseOnes(given);
    if (ring.size() < 3) {
        return std::nullopt;
    }
    CornerChain chain{ring, radius.si(), tolerance.si(), gentle.si()};
    if (!chain.makeDrivable()) {
        return std::nullopt;
    }
    const std::vector<Corner> corners = chain.take();
    const bool sharp = std::ranges::any_of(
        corners, [](const Corner& corner) { return std::abs(corner.turnRad) > kSharpestRad; });
    return sharp ? std::nullopt
                 : std::optional{lineThrough(corners, roundingsOf(corners), 0, corners.size(), true)};
}

SmoothStretches smoothStretches(const Ring& given, const StretchRules& rules) {
    const Ring ring = withoutCloseOnes(given);
    if (ring.size() < 3) {
        return {};
    }
    // The area between two passes with the same rounding is 2 (tan(a/2) - a/2) R w, for small angles a^3 R w
    // / 12.
    double sharpestRad = 0.1;
    const double share = 0.5 * rules.mostUncut.si() / (rules.radius.si() * rules.width.si());
    while (sharpestRad < 3.0 && std::tan(0.5 * sharpestRad) - 0.5 * sharpestRad < share) {
        sharpestRad += 0.02;
    }
    CornerChain chain{ring, rules.radius.si(), rules.tolerance.si(), rules.gentle.si(), sharpestRad};
    chain.makeDrivable();
    const std::vector<Corner> corners = chain.take();
    const std::vector<double> cuts = roundingsOf(corners);
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (corners[i].isCut) {
            ends.push_back(i);
        }
    }
    if (ends.empty()) {
        return {.lines = {lineThrough(corners, cuts, 0, corners.size(), true)}, .closed = true};
    }
    SmoothStretches stretches;
    for (std::size_t k = 0; k < ends.size(); ++k) {
        const std::size_t next = ends[(k + 1) % ends.size()];
        const std::size_t edges = (next + corners.size() - ends[k] - 1) % corners.size() + 1;
        stretches.lines.push_back(lineThrough(corners, cuts, ends[k], edges, false));
    }
    return stretches;
}

Curve reversedLine(const Curve& line) {
    Curve back{.type = line.type, .start = line.end(), .pieces = {}};
    back.start.heading = back.start.heading + degrees(180.0);
    for (auto piece = line.pieces.rbegin(); piece != line.pieces.rend(); ++piece) {
        back.pieces.push_back({.length = piece->length,
                               .curvature = Curvature::fromSi(-piece->endCurvature.si()),
                               .endCurvature = Curvature::fromSi(-piece->curvature.si()),
                               .gear = piece->gear});
    }
    return back;
}

}  // namespace furrow
