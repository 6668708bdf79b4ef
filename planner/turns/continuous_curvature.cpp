#include "planner/turns/continuous_curvature.h"

#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"
#include "planner/turns/turn_words.h"

namespace furrow {

namespace {

using words::kPi;

/// C(t) / t and S(t) / t of the Fresnel integrals at t = sqrt(2 angle / pi). This is the end of a clothoid of
/// length 1 that begins straight and turns by `angle`. Power series (Abramowitz & Stegun 1964, 7.3.11 and
/// 7.3.13), exact except for rounding for angles up to half a circle.
Point unitClothoid(double angle) {
    Point sum;
    double term = 1.0;  // angle^n / n!, with signs + + - - ...
    for (int n = 0; std::abs(term) > 1e-17; n += 2) {
        sum.x += term / (2 * n + 1);
        term *= angle / (n + 1);
        sum.y += term / (2 * n + 3);
        term *= -angle / (n + 2);
    }
    return sum;
}

/// Turns with clothoids, all with the same greatest curvature and rate.
class ClothoidTurns {
public:
    ClothoidTurns(double curvature, double rate)
        : curvature_{curvature}, clothoid_{curvature / rate}, clothoidsAngle_{curvature * curvature / rate} {
        const double angle = 0.5 * clothoidsAngle_;
        const Point end = clothoid_ * unitClothoid(angle);
        circle_.ahead = end.x - std::sin(angle) / curvature_;
        circle_.aside = end.y + std::cos(angle) / curvature_;
        circle_.radius = std::hypot(circle_.ahead, circle_.aside);
        circle_.lean = std::atan2(circle_.aside, circle_.ahead);
    }

    const words::TurnCircle& circle() const { return circle_; }

    double bound(double angle) const {
        // The elementary path is shortest for angle 0.
        return angle >= clothoidsAngle_ ? angle / curvature_ + clothoid_
                                        : std::max(2.0 * circle_.ahead, angle / curvature_);
    }

    double length(double angle) const {
        return angle >= clothoidsAngle_ ? angle / curvature_ + clothoid_ : 2.0 * elementaryClothoid(angle);
    }

    void drive(Curve& turn, int side, Gear gear, double angle) const {
        const auto add = [&](double length, double from, double to) {
            turn.pieces.push_back({.length = metres(length),
                                   .curvature = Curvature::fromSi(side * from),
                                   .endCurvature = Curvature::fromSi(side * to),
                                   .gear = gear});
        };
        if (angle >= clothoidsAngle_) {
            add(clothoid_, 0.0, curvature_);
            if (angle > clothoidsAngle_ + words::kNoPart) {
                add((angle - clothoidsAngle_) / curvature_, curvature_, curvature_);
            }
            add(clothoid_, curvature_, 0.0);
        } else if (angle > words::kNoPart) {
            const double length = elementaryClothoid(angle);
            add(length, 0.0, angle / length);
            add(length, angle / length, 0.0);
        } else {
            add(2.0 * circle_.ahead, 0.0, 0.0);
        }
    }

private:
    /// Length of each of the two clothoids that turn by half of `angle` and reach from circle to circle.
    /// Their ends are as far apart as those of any turn by this angle. (Fraichard & Scheuer give the same as
    /// a sharpness. The length stays finite if the angle goes to zero.)
    double elementaryClothoid(double angle) const {
        const double half = 0.5 * angle;
        // half + the angle between pose and tangent of the circle; its complement is the lean
        const double halfChord = circle_.radius * std::cos(half - circle_.lean);
        return halfChord / dot(direction(half), unitClothoid(half));
    }

    double curvature_;
    double clothoid_;        ///< length of one
    double clothoidsAngle_;  ///< of two
    words::TurnCircle circle_;
};

/// Curvatures of the smallest radius that are tried, as shares of the largest curvature.
constexpr double kLevels[] = {1.0, 0.7, 0.5, 0.35, 0.25, 0.125};
/// Largest turn of two clothoids. Beyond it the circle grows again and turns become longer.
constexpr double kLargestClothoidsAngle = kPi;

/// Within these metres and radians of the axis of the start, a goal is straight ahead.
constexpr double kAheadSlackM = 1e-9;
constexpr double kAheadSlackRad = 1e-10;

Curve shortestTurn(const Pose& from, const Pose& to, Length radius, CurvatureRate rate, bool reversing) {
    const words::Goal goal = words::goalSeenFrom(from, to, 1.0);
    Curve turn{.type = reversing ? "reeds-shepp-cc" : "dubins-cc", .start = from, .pieces = {}};
    const double ahead = goal.position.x;
    if (std::abs(goal.position.y) <= kAheadSlackM &&
        std::abs(std::remainder(goal.heading, 2.0 * kPi)) <= kAheadSlackRad && (reversing || ahead >= 0.0)) {
        if (std::abs(ahead) > words::kNoPart) {
            turn.pieces.push_back({.length = metres(std::abs(ahead)),
                                   .curvature = {},
                                   .gear = ahead > 0.0 ? Gear::Forward : Gear::Reverse});
        }
        return turn;
    }

    const double largest = std::min(1.0 / radius.si(), std::sqrt(kLargestClothoidsAngle * rate.si()));
    words::Word best;
    double bestLevel = 1.0;
    for (const double level : kLevels) {
        // The plain curve of a radius is never longer. If it does not win, no flatter turn can win.
        const Length plainRadius = metres(1.0 / (level * largest));
        if (level < 1.0 && best.length <= (reversing ? reedsSheppLength(from, to, plainRadius)
                                                     : dubinsLength(from, to, plainRadius))
                                              .si()) {
            break;
        }
        const ClothoidTurns turns{level * largest, rate.si()};
        words::TurnWordSearch<ClothoidTurns> search{goal, turns.circle(), turns};
        search.startFrom(best);
        search.straightWords(1);
        search.threeTurns(1);
        if (reversing) {
            search.straightWords(-1);
            search.threeTurns(-1);
            search.threeTurnsWithCusps();
            search.straightWordsWithCusps();
            search.fourTurns();
        }
        if (search.best().length < best.length) {
            best = search.best();
            bestLevel = level;
        }
    }

    const ClothoidTurns turns{bestLevel * largest, rate.si()};
    turn.pieces.reserve(15);
    for (int i = 0; i < best.count; ++i) {
        const words::Part& part = best.parts[i];
        const Gear gear = part.gear > 0 ? Gear::Forward : Gear::Reverse;
        if (part.side != 0) {
            turns.drive(turn, part.side, gear, part.amount);
        } else if (part.amount > words::kNoPart) {
            turn.pieces.push_back({.length = metres(part.amount), .curvature = {}, .gear = gear});
        }
    }
    return turn;
}

Curve runForward(const Pose& from, const Pose& to, const Machine& machine) {
    return continuousDubinsTurn(from, to, machine.minTurningRadius(), machine.maxCurvatureRate());
}

Curve runWithReversing(const Pose& from, const Pose& to, const Machine& machine) {
    return canReverse(machine)
               ? continuousReedsSheppTurn(from, to, machine.minTurningRadius(), machine.maxCurvatureRate())
               : runForward(from, to, machine);
}

}  // namespace

Curve continuousDubinsTurn(const Pose& from, const Pose& to, Length radius, CurvatureRate rate) {
    return shortestTurn(from, to, radius, rate, false);
}

Curve continuousReedsSheppTurn(const Pose& from, const Pose& to, Length radius, CurvatureRate rate) {
    return shortestTurn(from, to, radius, rate, true);
}

const Method<TurnPlanner> kContinuousDubinsMethod{
    .info = {.id = "dubins-cc",
             .name = "Forward curves, smooth steering",
             .description =
                 "Without reversing, the wheels turned no faster than the machine can (clothoids).",
             .parameters = {}},
    .run = runForward,
    .traits = {.isSmooth = true}};

const Method<TurnPlanner> kContinuousReedsSheppMethod{
    .info = {.id = "reeds-shepp-cc",
             .name = "Curves with reversing, smooth steering",
             .description = "Forwards and backwards, the wheels turned no faster than the machine can "
                            "(clothoids).",
             .parameters = {}},
    .run = runWithReversing,
    .traits = {.isSmooth = true, .reverses = true}};

}  // namespace furrow
