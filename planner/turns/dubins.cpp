#include "planner/turns/dubins.h"

#include "planner/turns/turn_words.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow {

namespace {

using words::kPi;

/// Three pieces: angles of arcs; the middle of the first four words is a length in radii.
struct Word {
    double first = 0.0;
    double middle = 0.0;
    double last = 0.0;
    // Left 1, straight 0, right -1.
    int turns[3] = {0, 0, 0};

    double length() const { return first + middle + last; }
};

/// Tries the six words on the problem scaled to radius 1, seen from the start.
class ShortestWord {
public:
    explicit ShortestWord(const words::Goal& goal)
        : heading_{goal.heading}, left_{side(goal, 1)}, right_{side(goal, -1)} {
        outerTangent(1, left_);
        outerTangent(-1, right_);
        const Point across{0.0, 2.0};
        innerTangent(1, right_ - across);
        innerTangent(-1, left_ + across);
        threeArcs(1, left_);
        threeArcs(-1, right_);
    }

    const Word& word() const { return best_; }

private:
    static constexpr double kTouchSlack = 1e-12;

    /// The way from the centre of the arc to `side` (left 1, right -1) at the start to that at the goal.
    static Point side(const words::Goal& goal, int side) {
        const Point ahead = direction(goal.heading);
        return {goal.position.x - side * ahead.y, goal.position.y + side * (ahead.x - 1.0)};
    }

    void offer(const Word& word) {
        if (const double length = word.length(); length < shortest_) {
            best_ = word;
            shortest_ = length;
        }
    }

    void outerTangent(int side, Point way) {
        const double k = side;
        const double axis = std::atan2(way.y, way.x);
        (side > 0 ? leftAxis_ : rightAxis_) = axis;
        offer({words::wrapped(k * axis),
               std::sqrt(dot(way, way)),
               words::wrapped(k * (heading_ - axis)),
               {side, 0, side}});
    }

    void innerTangent(int side, Point way) {
        const double square = dot(way, way) - 4.0;
        // A square slightly below zero from rounding is zero: the circles touch.
        const double middle = std::sqrt(std::max(0.0, square));
        if (square < -kTouchSlack || middle >= shortest_) {
            return;
        }
        const double k = side;
        // The angle between the tangent and the line of the centres is atan(2 / middle). One rotation
        // replaces the sum of two arc tangents.
        const double axis = std::atan2(way.y * middle + 2.0 * k * way.x, way.x * middle - 2.0 * k * way.y);
        offer({words::wrapped(k * axis), middle, words::wrapped(k * (axis - heading_)), {side, 0, -side}});
    }

    void threeArcs(int side, Point way) {
        const double square = dot(way, way);
        // The middle arc alone is longer than half a circle.
        if (square > 16.0 || shortest_ <= kPi) {
            return;
        }
        const double k = side;
        const double outer = std::acos(0.25 * std::sqrt(square)) + 0.5 * kPi;
        const double axis = side > 0 ? leftAxis_ : rightAxis_;
        offer({words::wrapped(k * axis + outer),
               2.0 * outer,
               words::wrapped(k * (heading_ - axis) + outer),
               {side, -side, side}});
    }

    double heading_;
    Point left_;
    Point right_;
    double leftAxis_ = 0.0;
    double rightAxis_ = 0.0;
    Word best_;
    double shortest_ = std::numeric_limits<double>::infinity();
};

Word shortestDubinsWord(const Pose& from, const Pose& to, Length radius) {
    return ShortestWord{words::goalSeenFrom(from, to, 1.0 / radius.si())}.word();
}

Curve runDubins(const Pose& from, const Pose& to, const Machine& machine) {
    return dubinsTurn(from, to, machine.minTurningRadius());
}

}  // namespace

Curve dubinsTurn(const Pose& from, const Pose& to, Length radius) {
    const Word word = shortestDubinsWord(from, to, radius);
    Curve turn{.type = "dubins", .start = from, .pieces = {}};
    turn.pieces.reserve(3);
    const double parts[] = {word.first, word.middle, word.last};
    for (int i = 0; i < 3; ++i) {
        if (parts[i] > words::kNoPart) {
            turn.pieces.push_back(
                {.length = radius * parts[i], .curvature = Curvature::fromSi(word.turns[i] / radius.si())});
        }
    }
    return turn;
}

Length dubinsLength(const Pose& from, const Pose& to, Length radius) {
    return radius * shortestDubinsWord(from, to, radius).length();
}

const Method<TurnPlanner> kDubinsMethod{
    .info = {.id = "dubins",
             .name = "Forward curves",
             .description = "The shortest curve without reversing, at the smallest turning radius (Dubins).",
             .parameters = {}},
    .run = runDubins};

}  // namespace furrow
