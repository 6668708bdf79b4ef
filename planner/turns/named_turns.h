#pragma once

#include "planner/settings/method.h"
#include "planner/turns/turn_method.h"

/// The turns of farm practice, as a driver would name them, between any two poses. Field edges need not be
/// square to the swaths. Each is the shortest of its kind, to the left or right, in arcs of the smallest
/// radius and straights. If one swath ends before the other, run-outs along the swaths level them. Closed
/// form; the end pose is exact except for rounding, and an arc of less than 1e-9 rad is left out. If the
/// poses do not allow the manoeuvre, the result is the Dubins turn, and its type says so. All cost under a
/// microsecond.
namespace furrow {

/// U turn: arc, straight, arc to one side, no arc over half a circle. For swaths at least two radii apart.
///
///        .-------.
///       /         \       w + (pi - 2) R long between level swaths w apart.
///      |           |
///      ^           v
Curve uTurn(const Pose& from, const Pose& to, Length radius);

/// Omega or bulb turn: arc away from the goal, loop of more than half a circle, another arc away from the
/// goal. For swaths nearer than two radii.
///
///        .-----.
///       /       \        With cos a = (2 R + w) / 4 R the outer arcs turn by a each, the loop by pi + 2 a.
///       \       /
///        `\   /'
///          ^ v
Curve omegaTurn(const Pose& from, const Pose& to, Length radius);

/// P turn: the whole bulb lies to one side. It has an arc away from the goal, a loop of more than half a
/// circle that ends on the goal's line, and a straight along it; or the same backwards, the straight first.
/// For swaths nearer than two radii.
///
///       .---.
///      /     \           With cos b = w / 2 R the arcs turn by b and pi + b, and 2 R sin b straight.
///      \      |
///       `\    |
///         ^   v
Curve pTurn(const Pose& from, const Pose& to, Length radius);

/// Fishtail or swallowtail: forward arc, straight in reverse, forward arc to the same side. The reverse
/// straight is at most two radii long. For swaths nearer than two radii and machines that can reverse.
///
///      <------------>
///       `.        .'     Two quarter circles and 2 R - w in reverse between level swaths w apart.
///         \      /
///          ^    v        (drawn apart; the arcs cross where the swaths are near)
Curve fishtailTurn(const Pose& from, const Pose& to, Length radius);

/// Three-point turn: forward arc, reverse arc with the wheels the other way, forward arc, none over half a
/// circle. For swaths nearer than two radii and machines that can reverse.
///
///      1 .-.   .-. 3      1 forward by c, 2 back by pi - 2 c, 3 forward by c with cos c = (2 R - w) / 4 R:
///       /   `2'   `       pi R in all between level swaths w apart.
///      ^           v      (drawn apart; between near swaths 1 and 3 cross)
Curve threePointTurn(const Pose& from, const Pose& to, Length radius);

extern const Method<TurnPlanner> kUTurnMethod;
extern const Method<TurnPlanner> kOmegaMethod;
extern const Method<TurnPlanner> kPTurnMethod;
/// With machines that cannot reverse, these two drive the Dubins turn.
extern const Method<TurnPlanner> kFishtailMethod;
extern const Method<TurnPlanner> kThreePointMethod;

}  // namespace furrow
