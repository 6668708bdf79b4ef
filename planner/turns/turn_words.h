#pragma once

#include "planner/geometry/pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <optional>

/// Internal to the turn library: all words of Reeds and Shepp over circles that need not touch their poses at
/// a right angle. So one search serves arcs as well as turns with clothoids at both ends.
namespace furrow::words {

inline constexpr double kPi = std::numbers::pi;

/// The place of a turn's centre, in the caller's unit (metres or radii):
///
///            + centre                 For an arc `ahead` is 0 and `aside` its radius. A turn that begins
///            |                        and ends with a clothoid has its centre ahead of its start and as
///      aside |                        far behind its end, so both lie on one circle around it.
///            |
///     >------+--->  nose
///       ahead
struct TurnCircle {
    double ahead = 0.0;
    double aside = 1.0;
    double radius = 1.0;                   ///< hypot(ahead, aside)
    double lean = 0.5 * std::numbers::pi;  ///< atan2(aside, ahead)
};

/// A turn (side 1 left, -1 right; amount: its change of heading, not negative) or a straight (side 0; amount:
/// length).
struct Part {
    int side = 0;
    int gear = 1;
    double amount = 0.0;
};

struct Word {
    std::array<Part, 5> parts{};
    int count = 0;
    double length = std::numeric_limits<double>::infinity();
};

/// A smaller part, in radians, radii or metres, is rounding: picometres.
inline constexpr double kNoPart = 1e-12;

/// The goal seen from the start. The nose of the start points to +x.
struct Goal {
    Point position;
    double heading = 0.0;
};

inline Goal goalSeenFrom(const Pose& from, const Pose& to, double scale) {
    const Point way = to.position - from.position;
    const Point ahead = direction(from.heading.si());
    return {.position = {scale * dot(ahead, way), scale * cross(ahead, way)},
            .heading = (to.heading - from.heading).si()};
}

/// Wraps into [0, 2 pi). An angle slightly below 0 is a rounded zero, not a full circle.
inline double wrapped(double angle) {
    constexpr double kTwoPi = 2.0 * std::numbers::pi;
    constexpr double kFullCircleSlack = 1e-9;
    const double rest = angle - kTwoPi * std::floor(angle / kTwoPi);
    return rest >= kTwoPi - kFullCircleSlack ? 0.0 : rest;
}

/// acos that accepts a cosine slightly outside [-1, 1] from rounding.
inline std::optional<double> arcCosine(double cosine) {
    // Also false for NaN, the cosine in a triangle with two equal corners.
    if (!(std::abs(cosine) <= 1.0 + 1e-13)) {
        return std::nullopt;
    }
    return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// The shortest of the requested words. `Metric` gives the length of a turn, `length(angle)`, and a cheaper
/// lower bound of it, `bound(angle)`.
///
/// Every word is solved for the centres of its turns. The first and the last centre follow from the poses. If
/// one turn follows another in the same gear, their centres are two radii apart. At a cusp, where clothoids
/// have straight wheels, they are twice `aside` apart. Source: Reeds & Shepp 1990, Optimal paths for a car
/// that goes both forwards and backwards, doi 10.2140/pjm.1990.145.367; with clothoids Fraichard & Scheuer
/// 2004, doi 10.1109/TRO.2004.833789.
template <class Metric>
class TurnWordSearch {
public:
    TurnWordSearch(const Goal& goal, const TurnCircle& circle, const Metric& metric)
        : goal_{goal},
          circle_{circle},
          metric_{metric},
          cosine_{std::cos(goal.heading)},
          sine_{std::sin(goal.heading)} {}

    const Word& best() const { return best_; }
    /// Starts from a word found elsewhere: only shorter ones count now.
    void startFrom(const Word& word) { best_ = word; }

    /// CSC: turn, straight, turn, in one gear.
    void straightWords(int gear) {
        for (const int first : {1, -1}) {
            for (const int last : {1, -1}) {
                straightWord(first, last, gear, false, false);
            }
        }
    }

    /// C|CSC, CSC|C and C|CSC|C. The turns between a cusp and the straight are quarter circles.
    void straightWordsWithCusps() {
        for (const int gear : {1, -1}) {
            for (const int first : {1, -1}) {
                for (const int last : {1, -1}) {
                    straightWord(first, last, gear, true, false);
                    straightWord(first, last, gear, false, true);
                }
                straightWord(first, -first, gear, true, true);
            }
        }
    }

    /// CCC in one gear.
    void threeTurns(int gear) {
        for (const int side : {1, -1}) {
            threeTurnWord(side, gear, gear, gear);
        }
    }

    /// C|C|C, CC|C and C|CC.
    void threeTurnsWithCusps() {
        for (const int side : {1, -1}) {
            for (const int gear : {1, -1}) {
                threeTurnWord(side, gear, -gear, gear);
                threeTurnWord(side, gear, gear, -gear);
                threeTurnWord(side, gear, -gear, -gear);
            }
        }
    }

    /// CC|CC and C|CC|C. The two turns in the middle have the same angle.
    void fourTurns() {
        for (const int side : {1, -1}) {
            for (const int gear : {1, -1}) {
                mirroredFour(side, gear);
                pointSymmetricFour(side, gear);
            }
        }
    }

private:
    /// The line from the centre of the first turn to that of the last.
    struct Centres {
        bool known = false;
        double apart = 0.0;
        double axis = 0.0;    ///< heading of that line
        double inner = -1.0;  ///< length of the tangent that crosses it; negative if there is none
        double tilt = 0.0;    ///< angle of that tangent with the line
    };

    static int index(int side, int gear) { return (side > 0 ? 0 : 1) + (gear > 0 ? 0 : 2); }

    const Centres& centres(int firstSide, int firstGear, int lastSide, int lastGear) {
        // Without clothoids the gear does not matter. This saves three quarters of the work.
        const bool arcs = circle_.ahead == 0.0;
        Centres& found =
            centres_[index(firstSide, arcs ? 1 : firstGear)][index(lastSide, arcs ? 1 : lastGear)];
        if (!found.known) {
            const double back = -lastGear * circle_.ahead;
            const double aside = lastSide * circle_.aside;
            const double x = goal_.position.x + cosine_ * back - sine_ * aside - firstGear * circle_.ahead;
            const double y = goal_.position.y + sine_ * back + cosine_ * aside - firstSide * circle_.aside;
            found.known = true;
            found.apart = std::sqrt(x * x + y * y);
            found.axis = found.apart > 0.0 ? std::atan2(y, x) : 0.0;
            const double across = 2.0 * circle_.aside;
            // (a + b)(a - b) keeps its digits if the circles nearly touch.
            const double square = (found.apart + across) * (found.apart - across);
            if (square >= -1e-13 * across * across) {
                found.inner = std::sqrt(std::max(0.0, square));
                found.tilt = std::atan2(across, found.inner);
            }
        }
        return found;
    }

    void offer(std::initializer_list<Part> parts) {
        double bound = 0.0;
        for (const Part& part : parts) {
            bound += part.side == 0 ? part.amount : metric_.bound(part.amount);
        }
        if (bound >= best_.length) {
            return;
        }
        double length = 0.0;
        for (const Part& part : parts) {
            length += part.side == 0 ? part.amount : metric_.length(part.amount);
        }
        if (length < best_.length) {
            best_.count = static_cast<int>(parts.size());
            std::ranges::copy(parts, best_.parts.begin());
            best_.length = length;
        }
    }

    /// `first` and `last` are the sides of the turns beside the straight; `gear` is the gear of all three. A
    /// cusp before the quarter turn moves the first centre by twice `aside` against the straight. So only the
    /// straight becomes shorter.
    void straightWord(int first, int last, int gear, bool cuspBefore, bool cuspAfter) {
        const Centres& between = centres(cuspBefore ? -first : first, cuspBefore ? -gear : gear,
                                         cuspAfter ? -last : last, cuspAfter ? -gear : gear);
        const int cusps = (cuspBefore ? 1 : 0) + (cuspAfter ? 1 : 0);
        const double tangent = first == last ? between.apart : between.inner;
        const double straight = tangent - 2.0 * circle_.ahead - 2.0 * cusps * circle_.aside;
        if (tangent < 0.0 || straight < 0.0 || straight >= best_.length) {
            return;
        }
        double heading = between.axis;
        if (first != last) {
            heading += first * (gear > 0 ? between.tilt : kPi - between.tilt);
        } else if (gear < 0) {
            heading += kPi;
        }
        const double quarter = 0.5 * kPi;
        const double in = wrapped(first * gear * heading - (cuspBefore ? quarter : 0.0));
        const double out = wrapped(last * gear * (goal_.heading - heading) - (cuspAfter ? quarter : 0.0));
        if (cusps == 0) {
            offer({{first, gear, in}, {0, gear, straight}, {last, gear, out}});
        } else if (cusps == 2) {
            offer({{-first, -gear, in},
                   {first, gear, quarter},
                   {0, gear, straight},
                   {last, gear, quarter},
                   {-last, -gear, out}});
        } else if (cuspBefore) {
            offer({{-first, -gear, in}, {first, gear, quarter}, {0, gear, straight}, {last, gear, out}});
        } else {
            offer({{first, gear, in}, {0, gear, straight}, {last, gear, quarter}, {-last, -gear, out}});
        }
    }

    /// The heading at the change from a turn to `side` to one to the other side, less the heading of the line
    /// from its centre to the next one's.
    double handOver(int side, int gear, int nextGear) const {
        if (gear != nextGear) {
            return side * 0.5 * kPi;
        }
        return side * (gear > 0 ? circle_.lean : kPi - circle_.lean);
    }

    double centreDistance(int gear, int nextGear) const {
        return 2.0 * (gear == nextGear ? circle_.radius : circle_.aside);
    }

    /// The angles at the ends of the base of a triangle with the sides base, left, right.
    struct Triangle {
        double base = -1.0;
        double left = 0.0;
        double right = 0.0;
        bool exists = false;
        double atLeft = 0.0;
        double atRight = 0.0;
    };

    /// Most words of one search need the same triangle as the word before.
    static const Triangle& solved(Triangle& memo, double base, double left, double right) {
        if (memo.base == base && memo.left == left && memo.right == right) {
            return memo;
        }
        memo = {.base = base, .left = left, .right = right};
        if (left == right) {
            const auto angle = arcCosine(0.5 * base / left);
            memo.exists = angle.has_value();
            memo.atLeft = memo.atRight = angle.value_or(0.0);
            return memo;
        }
        const double difference = (left + right) * (left - right);
        const auto atLeft = arcCosine((base * base + difference) / (2.0 * base * left));
        const auto atRight = arcCosine((base * base - difference) / (2.0 * base * right));
        memo.exists = atLeft.has_value() && atRight.has_value();
        memo.atLeft = atLeft.value_or(0.0);
        memo.atRight = atRight.value_or(0.0);
        return memo;
    }

    void threeTurnWord(int side, int gear1, int gear2, int gear3) {
        const Centres& between = centres(side, gear1, side, gear3);
        const Triangle& triangle =
            solved(three_, between.apart, centreDistance(gear1, gear2), centreDistance(gear2, gear3));
        if (!triangle.exists) {
            return;
        }
        for (const int above : {1, -1}) {
            const double heading12 = between.axis + above * triangle.atLeft + handOver(side, gear1, gear2);
            const double heading23 = between.axis - above * triangle.atRight + handOver(-side, gear2, gear3);
            offer({{side, gear1, wrapped(side * gear1 * heading12)},
                   {-side, gear2, wrapped(-side * gear2 * (heading23 - heading12))},
                   {side, gear3, wrapped(side * gear3 * (goal_.heading - heading23))}});
        }
    }

    /// CC|CC: at the cusp the second half mirrors the first.
    void mirroredFour(int side, int gear) {
        const Centres& between = centres(side, gear, -side, -gear);
        const double base = between.apart + 2.0 * circle_.aside;
        const Triangle& triangle = solved(mirrored_, base, 2.0 * circle_.radius, 2.0 * circle_.radius);
        if (!triangle.exists) {
            return;
        }
        for (const int above : {1, -1}) {
            const double heading12 = between.axis + above * triangle.atLeft + handOver(side, gear, gear);
            const double heading23 = between.axis + kPi + handOver(-side, gear, -gear);
            const double heading34 = between.axis - above * triangle.atRight + handOver(side, -gear, -gear);
            offerFour(side, {gear, gear, -gear, -gear}, heading12, heading23, heading34);
        }
    }

    /// C|CC|C: the second half is the first one turned by half a circle around the middle.
    void pointSymmetricFour(int side, int gear) {
        const Centres& between = centres(side, gear, -side, gear);
        const Triangle& triangle =
            solved(symmetric_, 0.5 * between.apart, 2.0 * circle_.aside, circle_.radius);
        if (!triangle.exists) {
            return;
        }
        for (const int above : {1, -1}) {
            const double outer = between.axis + above * triangle.atLeft;
            const double heading12 = outer + handOver(side, gear, -gear);
            const double heading23 = between.axis - above * triangle.atRight + handOver(-side, -gear, -gear);
            const double heading34 = outer + handOver(side, -gear, gear);
            offerFour(side, {gear, -gear, -gear, gear}, heading12, heading23, heading34);
        }
    }

    void offerFour(int side, std::array<int, 4> gears, double heading12, double heading23, double heading34) {
        offer({{side, gears[0], wrapped(side * gears[0] * heading12)},
               {-side, gears[1], wrapped(-side * gears[1] * (heading23 - heading12))},
               {side, gears[2], wrapped(side * gears[2] * (heading34 - heading23))},
               {-side, gears[3], wrapped(-side * gears[3] * (goal_.heading - heading34))}});
    }

    Goal goal_;
    TurnCircle circle_;
    Metric metric_;
    double cosine_;
    double sine_;
    Word best_;
    std::array<std::array<Centres, 4>, 4> centres_{};
    Triangle three_;
    Triangle mirrored_;
    Triangle symmetric_;
};

}  // namespace furrow::words
