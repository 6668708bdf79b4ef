#include "planner/field/outline_steps.h"

#include "planner/geometry/segment.h"
#include "planner/geometry/simplify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// The coarsest images that fields are traced from (Landsat).
constexpr double kHighestM = 30.0;
// Of right angles that projections and rounding bent, and of straights that they did.
constexpr double kSquareCosine = 0.3;
constexpr double kFlatCosine = 0.866;
constexpr int kFewest = 12;
// Of a ring with steps.
constexpr std::size_t kFewestCorners = 4;
constexpr double kLeastShare = 0.4;
// In steps: how far straight lines may be from the middles.
constexpr double kNear = 1.0;
// In the same: how far a corner may move to where two straights meet.
constexpr double kCornersMove = 1.5;
// A gate on the boundary is no farther from it.
constexpr double kOnBoundaryM = 1.0;

struct Straight {
    Point through;
    Point along;  ///< a unit vector
};

/// The straight from which points are least far, by the squares of their distances.
Straight bestAmong(std::span<const Point> points) {
    const auto count = static_cast<double>(points.size());
    const Point middle = (1.0 / count) * std::accumulate(points.begin(), points.end(), Point{});
    double alongX = 0.0;
    double across = 0.0;
    for (const Point& point : points) {
        const Point off = point - middle;
        alongX += off.x * off.x - off.y * off.y;
        across += 2.0 * off.x * off.y;
    }
    const double angle = 0.5 * std::atan2(across, alongX);
    return {.through = middle, .along = {std::cos(angle), std::sin(angle)}};
}

/// A line in few straights, each as near to its points as can be. First and last point stay, unless they are
/// the same. No point of the line is farther than `tolerance` from it.
Polyline inStraights(const Polyline& line, Length tolerance) {
    Polyline kept = simplified(line, tolerance);
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < line.size() && at.size() < kept.size(); ++i) {
        if (line[i] == kept[at.size()]) {
            at.push_back(i);
        }
    }
    std::vector<Straight> straights;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        straights.push_back(bestAmong(std::span{line}.subspan(at[i], at[i + 1] - at[i] + 1)));
    }
    Polyline fitted = kept;
    const auto meet = [&](std::size_t corner, const Straight& in, const Straight& out) {
        const double ahead = toMeeting(in.through, in.along, out.through, out.along).first;
        const Point meeting = in.through + ahead * in.along;
        if (distance(meeting, kept[corner]) <= kCornersMove * tolerance.si()) {
            fitted[corner] = meeting;
        }
    };
    for (std::size_t corner = 1; corner + 1 < kept.size(); ++corner) {
        meet(corner, straights[corner - 1], straights[corner]);
    }
    if (kept.front() == kept.back() && straights.size() > 2) {
        meet(0, straights.back(), straights.front());
        fitted.back() = fitted.front();
    }
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        for (std::size_t k = at[i]; k <= at[i + 1]; ++k) {
            if (distanceToSegment(line[k], fitted[i], fitted[i + 1]) > tolerance.si()) {
                return kept;
            }
        }
    }
    return fitted;
}

/// A ring from corner to corner, and what its edges are. Points on the way are no corners.
class SteppedRing {
public:
    /// @param fixed  edges that stay, by their first points
    SteppedRing(const GeoRing& places, const LocalFrame& frame, const std::vector<bool>& fixed)
        : places_{places}, points_{frame.toLocal(places)} {
        const std::size_t all = points_.size();
        std::vector<bool> stays;
        for (std::size_t i = 0; i < all; ++i) {
            const bool isFixed = fixed[i] || fixed[(i + all - 1) % all];
            const Point in = points_[i] - points_[(i + all - 1) % all];
            const Point out = points_[(i + 1) % all] - points_[i];
            if (isFixed || dot(in, out) < kFlatCosine * norm(in) * norm(out)) {
                corners_.push_back(i);
                stays.push_back(fixed[i]);
            }
        }
        risers_.assign(size(), false);
        steps_.assign(size(), false);
        if (size() < kFewestCorners) {
            return;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            risers_[i] = !stays[i] && squareTurn(i) * squareTurn(next(i)) < 0.0 && lengthM(i) <= kHighestM;
        }
        for (std::size_t i = 0; i < size(); ++i) {
            // Treads, notches as wide as a step and the far ends of the field lie between two risers.
            steps_[i] = risers_[i] || (!stays[i] && risers_[before(i)] && risers_[next(i)]);
        }
    }

    std::size_t size() const { return corners_.size(); }

    /// One for each riser. Where a tread looks like one, too, the shorter of the two.
    void addHeights(std::vector<double>& heights) const {
        for (std::size_t i = 0; i < size(); ++i) {
            if (risers_[i]) {
                heights.push_back(std::min({lengthM(i), riserM(before(i)), riserM(next(i))}));
            }
        }
    }

    /// Of treads that look like risers, only every second one is.
    int count() const {
        int steps = 0;
        int row = 0;
        for (std::size_t i = 0; i < size(); ++i) {
            row = risers_[i] ? row + 1 : 0;
            steps += row % 2;
        }
        return steps;
    }

    /// The new ring; for each of its points the old one that it is, if any.
    struct Straightened {
        GeoRing places;
        std::vector<std::optional<std::size_t>> old;
    };

    Straightened straightened(const LocalFrame& frame, Length tolerance) const {
        Straightened made;
        const auto add = [&](Point point) {
            made.places.push_back(frame.toGeo(point));
            made.old.emplace_back();
        };
        const auto other = std::ranges::find(steps_, false);
        if (size() < kFewestCorners) {
            made.places = places_;
            for (std::size_t i = 0; i < places_.size(); ++i) {
                made.old.emplace_back(i);
            }
            return made;
        }
        if (other == steps_.end()) {
            Polyline closed = middles();
            closed.push_back(closed.front());
            const Polyline straight = inStraights(closed, tolerance);
            std::for_each(straight.begin() + 1, straight.end(), add);
            return made;
        }
        // Begins with an edge that is no step, so that no row of steps goes over the ring's first point.
        const auto first = static_cast<std::size_t>(other - steps_.begin());
        for (std::size_t k = 0; k < size();) {
            std::size_t end = k;
            while (end < size() && steps_[(first + end) % size()]) {
                ++end;
            }
            const std::size_t edge = (first + k) % size();
            keep(corners_[edge], made);
            if (end == k) {
                for (std::size_t i = after(corners_[edge]); i != corners_[next(edge)]; i = after(i)) {
                    keep(i, made);
                }
                ++k;
                continue;
            }
            Polyline line{corner(edge)};
            for (std::size_t m = k + 1; m + 1 < end; ++m) {
                line.push_back(middle((first + m) % size()));
            }
            line.push_back(corner((first + end) % size()));
            const Polyline straight = inStraights(line, tolerance);
            std::for_each(straight.begin() + 1, straight.end() - 1, add);
            k = end;
        }
        return made;
    }

    bool changes(const LocalFrame& frame, Length tolerance) const {
        const Straightened made = straightened(frame, tolerance);
        return made.old.size() != places_.size() ||
               !std::ranges::all_of(made.old, &std::optional<std::size_t>::has_value);
    }

private:
    std::size_t next(std::size_t edge) const { return edge + 1 == size() ? 0 : edge + 1; }
    std::size_t before(std::size_t edge) const { return edge == 0 ? size() - 1 : edge - 1; }
    std::size_t after(std::size_t point) const { return point + 1 == points_.size() ? 0 : point + 1; }
    Point corner(std::size_t i) const { return points_[corners_[i]]; }
    Point along(std::size_t edge) const { return corner(next(edge)) - corner(edge); }
    double lengthM(std::size_t edge) const { return norm(along(edge)); }
    Point middle(std::size_t edge) const { return corner(edge) + 0.5 * along(edge); }

    void keep(std::size_t point, Straightened& made) const {
        made.places.push_back(places_[point]);
        made.old.emplace_back(point);
    }

    /// Of all edges, beginning where the ring is farthest from its first corner: that one stays.
    Ring middles() const {
        Ring all;
        for (std::size_t edge = 0; edge < size(); ++edge) {
            all.push_back(middle(edge));
        }
        std::ranges::rotate(all, std::ranges::max_element(all, {}, [this](const Point& point) {
                                return distance(point, corner(0));
                            }));
        return all;
    }

    /// 1 for a right angle to the left at a corner, -1 to the right, 0 for anything else.
    double squareTurn(std::size_t i) const {
        const Point in = along(before(i));
        const Point out = along(i);
        return std::abs(dot(in, out)) > kSquareCosine * norm(in) * norm(out) ? 0.0
               : cross(in, out) > 0.0                                        ? 1.0
                                                                             : -1.0;
    }

    double riserM(std::size_t edge) const {
        return risers_[edge] ? lengthM(edge) : std::numeric_limits<double>::infinity();
    }

    const GeoRing& places_;
    Ring points_;
    std::vector<std::size_t> corners_;  ///< of the points
    std::vector<bool> risers_;          ///< edges between a corner to the left and one to the right
    std::vector<bool> steps_;           ///< edges that may be left out
};

std::optional<OutlineSteps> stepsIn(const std::vector<SteppedRing>& rings) {
    std::vector<double> heights;
    std::size_t points = 0;
    int count = 0;
    for (const SteppedRing& ring : rings) {
        ring.addHeights(heights);
        points += ring.size();
        count += ring.count();
    }
    if (count < kFewest || static_cast<double>(heights.size()) < kLeastShare * static_cast<double>(points)) {
        return std::nullopt;
    }
    const auto middle = heights.begin() + std::ssize(heights) / 2;
    std::ranges::nth_element(heights, middle);
    return OutlineSteps{.count = count, .height = metres(*middle)};
}

/// Calls `visit(part, ring, places)` for every ring of the boundary.
template <class Source, class Visit>
void forEachRing(Source& source, Visit&& visit) {
    for (std::size_t part = 0; part < source.parts.size(); ++part) {
        visit(part, std::size_t{0}, source.parts[part].outer);
        for (std::size_t hole = 0; hole < source.parts[part].holes.size(); ++hole) {
            visit(part, hole + 1, source.parts[part].holes[hole]);
        }
    }
}

std::vector<SteppedRing> steppedRings(const FieldSource& source, const LocalFrame& frame) {
    std::vector<SteppedRing> rings;
    forEachRing(source, [&](std::size_t part, std::size_t ring, const GeoRing& places) {
        std::vector<bool> fixed(places.size(), false);
        for (const std::vector<EdgeWidth>* given : {&source.edgeHeadlands, &source.edgeOverhangs}) {
            for (const EdgeWidth& edge : *given) {
                if (edge.part == part && edge.ring == ring && edge.edge < fixed.size()) {
                    fixed[edge.edge] = true;
                }
            }
        }
        rings.emplace_back(places, frame, fixed);
    });
    return rings;
}

Result<LocalFrame> frameOf(const FieldSource& source) {
    return LocalFrame::centredOn(middleOf(source.parts));
}

Point nearestOn(const FieldSource& source, const LocalFrame& frame, Point point) {
    Point nearest = point;
    double least = std::numeric_limits<double>::infinity();
    forEachRing(source, [&](std::size_t, std::size_t, const GeoRing& places) {
        const Ring ring = frame.toLocal(places);
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Point at = nearestOnSegment(point, ring[j], ring[i]);
            if (const double away = distance(point, at); away < least) {
                least = away;
                nearest = at;
            }
        }
    });
    return nearest;
}

}  // namespace

std::optional<OutlineSteps> stepsOf(const FieldSource& source) {
    const auto frame = frameOf(source);
    if (!frame) {
        return std::nullopt;
    }
    const std::vector<SteppedRing> rings = steppedRings(source, *frame);
    auto steps = stepsIn(rings);
    // Steps between edges that stay may be all that is left.
    const bool stay = steps && std::ranges::none_of(rings, [&](const SteppedRing& ring) {
                          return ring.changes(*frame, kNear * steps->height);
                      });
    return stay ? std::nullopt : steps;
}

Result<FieldSource> withStraightSteps(const FieldSource& source, const JobContext& job) {
    const auto frame = frameOf(source);
    if (!frame) {
        return std::unexpected(frame.error());
    }
    const std::vector<SteppedRing> rings = steppedRings(source, *frame);
    const auto steps = stepsIn(rings);
    if (!steps) {
        return source;
    }
    FieldSource straight = source;
    std::size_t number = 0;
    forEachRing(straight, [&](std::size_t part, std::size_t ring, GeoRing& places) {
        const auto made = rings[number++].straightened(*frame, kNear * steps->height);
        for (std::vector<EdgeWidth>* given : {&straight.edgeHeadlands, &straight.edgeOverhangs}) {
            for (EdgeWidth& edge : *given) {
                const auto now = std::ranges::find(made.old, std::optional{edge.edge});
                if (edge.part == part && edge.ring == ring && now != made.old.end()) {
                    edge.edge = static_cast<std::size_t>(now - made.old.begin());
                }
            }
        }
        places = made.places;
    });
    for (Gate& gate : straight.gates) {
        const Point at = frame->toLocal(gate.position);
        if (distance(at, nearestOn(source, *frame, at)) <= kOnBoundaryM) {
            gate.position = frame->toGeo(nearestOn(straight, *frame, at));
        }
    }
    if (const auto field = Field::create(straight, job); !field) {
        return std::unexpected(field.error());
    }
    return straight;
}

}  // namespace furrow
