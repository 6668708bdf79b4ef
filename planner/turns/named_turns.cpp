#include "planner/turns/named_turns.h"

#include "planner/turns/dubins.h"
#include "planner/turns/turn_words.h"

namespace furrow {

namespace {

using words::Goal;
using words::kPi;
using words::Part;
using words::wrapped;

// An arc of exactly half a circle may come out longer by this.
constexpr double kAngleSlack = 1e-9;
constexpr double kHalfCircle = kPi + kAngleSlack;

constexpr double kTieSlack = 1e-9;

// The cosine of 60 degrees. An end that points back by less needs a run-out more than twice as long as the
// distance that it lies behind.
constexpr double kLeastBack = 0.5;

/// The shortest of the offered manoeuvres. If only rounding distinguishes them, the first one. Lengths are in
/// radii, as in all of this file.
class Shortest {
public:
    void offer(std::initializer_list<Part> parts) {
        double length = 0.0;
        for (const Part& part : parts) {
            length += part.amount;
        }
        if (length < best_.length - kTieSlack) {
            best_.count = static_cast<int>(parts.size());
            std::ranges::copy(parts, best_.parts.begin());
            best_.length = length;
        }
    }

    Curve turn(std::string_view type, const Pose& from, const Pose& to, Length radius) const {
        if (best_.count == 0) {
            return dubinsTurn(from, to, radius);
        }
        Curve turn{.type = type, .start = from, .pieces = {}};
        for (int i = 0; i < best_.count; ++i) {
            const Part& part = best_.parts[i];
            if (part.amount > words::kNoPart) {
                turn.pieces.push_back({.length = radius * part.amount,
                                       .curvature = Curvature::fromSi(part.side / radius.si()),
                                       .gear = part.gear > 0 ? Gear::Forward : Gear::Reverse});
            }
        }
        return turn;
    }

private:
    words::Word best_;
};

/// Straight ways before and after a manoeuvre.
struct RunOuts {
    double before = 0.0;
    double after = 0.0;
};

/// The goal seen from the end of the first run-out, moved back to the beginning of the second.
Goal between(const Goal& goal, const RunOuts& run) {
    const Point ahead = direction(goal.heading);
    return {.position = goal.position - Point{run.before, 0.0} - run.after * ahead, .heading = goal.heading};
}

/// The useful run-outs: none, and the one that brings both ends to one level across the start's heading. For
/// that, the swath that ends earlier is driven on. Ends that point across rather than back at each other have
/// no common level: square to the start it would be infinitely far away.
std::array<RunOuts, 2> levellings(const Goal& goal) {
    const double ahead = goal.position.x;
    const double back = -std::cos(goal.heading);
    RunOuts level;
    if (ahead > 0.0) {
        level.before = ahead;
    } else if (back > kLeastBack) {
        level.after = -ahead / back;
    }
    return {RunOuts{}, level};
}

Point leftOf(double heading) {
    return {-std::sin(heading), std::cos(heading)};
}

/// The way from the centre of an arc to `side` at the start to that of one at the goal.
Point centreWay(const Goal& goal, int side) {
    return goal.position + side * leftOf(goal.heading) - Point{0.0, static_cast<double>(side)};
}

/// Arc, arc to the other side, arc to the first side. The middle arc is driven in `gear`: forward in an omega
/// turn, in reverse in a three-point turn.
void offerThreeArcs(Shortest& shortest, const Goal& whole, int side, int gear, const RunOuts& run) {
    const Goal goal = between(whole, run);
    const Point way = centreWay(goal, side);
    const auto angle = words::arcCosine(0.25 * norm(way));
    if (!angle) {
        return;
    }
    const double axis = std::atan2(way.y, way.x);
    for (const int above : {1, -1}) {
        // At the join of two arcs, the line between their centres is square to the heading.
        const double heading12 = axis + above * *angle + side * 0.5 * kPi;
        const double heading23 = axis - above * *angle - side * 0.5 * kPi;
        const double first = wrapped(side * heading12);
        const double middle = wrapped(-side * gear * (heading23 - heading12));
        const double last = wrapped(side * (goal.heading - heading23));
        const bool middleFits = gear > 0 ? middle > kPi : middle < kHalfCircle;
        if (first < kHalfCircle && last < kHalfCircle && middleFits) {
            shortest.offer({{0, 1, run.before},
                            {side, 1, first},
                            {-side, gear, middle},
                            {side, 1, last},
                            {0, 1, run.after}});
        }
    }
}

/// Tries the shortest run-outs, one at a time, after which the three circles reach each other.
void offerThreeArcsAfterRunOut(Shortest& shortest, const Goal& goal, int side, int gear) {
    // Slightly less than the four radii that three circles span, so that rounding does not separate them.
    constexpr double kReach = 4.0 * (1.0 - 1e-12);
    const Point way = centreWay(goal, side);
    const double beyond = dot(way, way) - kReach * kReach;
    if (beyond <= 0.0) {
        return;
    }
    const auto runOut = [&](Point heading) -> double {
        const double along = dot(way, heading);
        const double square = along * along - beyond;
        return square >= 0.0 ? along - std::sqrt(square) : -1.0;
    };
    if (const double before = runOut({1.0, 0.0}); before >= 0.0) {
        offerThreeArcs(shortest, goal, side, gear, {.before = before});
    }
    if (const double after = runOut(direction(goal.heading)); after >= 0.0) {
        offerThreeArcs(shortest, goal, side, gear, {.after = after});
    }
}

Shortest shortestThreeArcs(const Pose& from, const Pose& to, Length radius, int gear) {
    const Goal goal = words::goalSeenFrom(from, to, 1.0 / radius.si());
    Shortest shortest;
    // Between level swaths both three-point turns are equally long. The one towards the goal comes first.
    const int towards = goal.position.y >= 0.0 ? 1 : -1;
    for (const int side : {towards, -towards}) {
        for (const RunOuts& run : levellings(goal)) {
            offerThreeArcs(shortest, goal, side, gear, run);
        }
        offerThreeArcsAfterRunOut(shortest, goal, side, gear);
    }
    return shortest;
}

/// Arc, straight in `gear`, arc to the same side.
Shortest shortestArcStraightArc(const Pose& from, const Pose& to, Length radius, int gear) {
    const Goal whole = words::goalSeenFrom(from, to, 1.0 / radius.si());
    Shortest shortest;
    for (const int side : {1, -1}) {
        for (const RunOuts& run : levellings(whole)) {
            const Goal goal = between(whole, run);
            const Point way = gear * centreWay(goal, side);
            const double straight = norm(way);
            const double heading = std::atan2(way.y, way.x);
            const double first = wrapped(side * heading);
            const double last = wrapped(side * (goal.heading - heading));
            // More than two radii in reverse would lead away from the goal.
            const bool straightFits = gear > 0 || straight <= 2.0 + kAngleSlack;
            if (first < kHalfCircle && last < kHalfCircle && straightFits) {
                shortest.offer({{0, 1, run.before},
                                {side, 1, first},
                                {0, gear, straight},
                                {side, 1, last},
                                {0, 1, run.after}});
            }
        }
    }
    return shortest;
}

/// A P turn with the straight at its end: small arc, loop to the other side, straight.
struct LoopAndStraight {
    double arc = 0.0;
    double loop = 0.0;
    double straight = 0.0;
};

/// The loop's centre is two radii from the first one's and one radius from the goal's line. There are two
/// such places along the line; the one farther out is the bulb.
std::optional<LoopAndStraight> loopAndStraight(const Goal& goal, int side) {
    const Point ahead = direction(goal.heading);
    const Point way = goal.position - side * leftOf(goal.heading) - Point{0.0, static_cast<double>(side)};
    const double along = dot(way, ahead);
    const double square = along * along - dot(way, way) + 4.0;
    if (square < 0.0) {
        return std::nullopt;
    }
    const double straight = along + std::sqrt(square);
    const Point centres = way - straight * ahead;
    const double heading = std::atan2(centres.y, centres.x) + side * 0.5 * kPi;
    const LoopAndStraight found{.arc = wrapped(side * heading),
                                .loop = wrapped(side * (heading - goal.heading)),
                                .straight = straight};
    const bool isP = straight >= 0.0 && found.arc < kHalfCircle && found.loop > kPi - kAngleSlack;
    return isP ? std::optional{found} : std::nullopt;
}

template <class Drive>
Curve withReversing(Drive drive, const Pose& from, const Pose& to, const Machine& machine) {
    return canReverse(machine) ? drive(from, to, machine.minTurningRadius())
                               : dubinsTurn(from, to, machine.minTurningRadius());
}

}  // namespace

Curve uTurn(const Pose& from, const Pose& to, Length radius) {
    return shortestArcStraightArc(from, to, radius, 1).turn("u", from, to, radius);
}

Curve omegaTurn(const Pose& from, const Pose& to, Length radius) {
    return shortestThreeArcs(from, to, radius, 1).turn("omega", from, to, radius);
}

Curve pTurn(const Pose& from, const Pose& to, Length radius) {
    const auto about = [](const Pose& p) { return Pose{p.position, p.heading + radians(kPi)}; };
    const Goal there = words::goalSeenFrom(from, to, 1.0 / radius.si());
    // The same turn driven from the goal to the start: first becomes last, left becomes right.
    const Goal back = words::goalSeenFrom(about(to), about(from), 1.0 / radius.si());
    Shortest shortest;
    for (const int side : {1, -1}) {
        if (const auto found = loopAndStraight(there, side)) {
            shortest.offer({{side, 1, found->arc}, {-side, 1, found->loop}, {0, 1, found->straight}});
        }
        if (const auto found = loopAndStraight(back, side)) {
            shortest.offer({{0, 1, found->straight}, {side, 1, found->loop}, {-side, 1, found->arc}});
        }
    }
    return shortest.turn("p", from, to, radius);
}

Curve fishtailTurn(const Pose& from, const Pose& to, Length radius) {
    return shortestArcStraightArc(from, to, radius, -1).turn("fishtail", from, to, radius);
}

Curve threePointTurn(const Pose& from, const Pose& to, Length radius) {
    return shortestThreeArcs(from, to, radius, -1).turn("three-point", from, to, radius);
}

const Method<TurnPlanner> kUTurnMethod{
    .info = {.id = "u",
             .name = "U turn",
             .description = "Arc, straight, arc; for swaths at least two turning radii apart.",
             .parameters = {}},
    .run = [](const Pose& from, const Pose& to, const Machine& machine) {
        return uTurn(from, to, machine.minTurningRadius());
    }};

const Method<TurnPlanner> kOmegaMethod{
    .info = {.id = "omega",
             .name = "Omega turn",
             .description = "A bulb to both sides; for swaths nearer than two turning radii.",
             .parameters = {}},
    .run = [](const Pose& from, const Pose& to, const Machine& machine) {
        return omegaTurn(from, to, machine.minTurningRadius());
    }};

const Method<TurnPlanner> kPTurnMethod{
    .info = {.id = "p",
             .name = "P turn",
             .description = "A bulb to one side and straight back; for swaths nearer than two turning radii.",
             .parameters = {}},
    .run = [](const Pose& from, const Pose& to, const Machine& machine) {
        return pTurn(from, to, machine.minTurningRadius());
    }};

const Method<TurnPlanner> kFishtailMethod{
    .info = {.id = "fishtail",
             .name = "Fishtail",
             .description = "Forward arc, straight back, forward arc; little room for near swaths.",
             .parameters = {}},
    .run = [](const Pose& from, const Pose& to,
              const Machine& machine) { return withReversing(fishtailTurn, from, to, machine); },
    .traits = {.reverses = true}};

const Method<TurnPlanner> kThreePointMethod{
    .info = {.id = "three-point",
             .name = "Three-point turn",
             .description = "Forward, back with the wheels the other way, forward again.",
             .parameters = {}},
    .run = [](const Pose& from, const Pose& to,
              const Machine& machine) { return withReversing(threePointTurn, from, to, machine); },
    .traits = {.reverses = true}};

}  // namespace furrow
