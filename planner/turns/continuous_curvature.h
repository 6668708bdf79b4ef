#pragma once

#include "planner/settings/method.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// Curves with continuous curvature. It starts and ends at zero and passes through zero at every change of
/// side and at every cusp, so the wheels need not turn at standstill. It never exceeds 1 / radius, and never
/// changes faster along the way than `rate`.
///
/// They are the words of Dubins and of Reeds and Shepp. Their turns begin and end with a clothoid:
///
///     curvature    ____          A turn by less than the angle of its clothoids (an "elementary path")
///                 /    \         is two flatter clothoids whose ends lie on the same circle around the
///          ______/      \_____   same centre; by nothing, the straight between them.
///
/// A turn is solved in closed form, with Fresnel integrals by their power series. So the end pose is exact
/// except for rounding; a turn of less than 1e-9 rad is left out. The result is the shortest of these words
/// in which all turns have one smallest radius. `radius` and a few larger values are tried, because flatter
/// turns need less way for a small shift sideways. The curve is no shorter than the Dubins or Reeds-Shepp
/// curve and becomes it as the rate grows. It is not known whether a shorter curve exists. At a very low
/// rate, two clothoids would turn past half a circle before they reach the curvature. Then less than the
/// greatest curvature is used.
/// About 2 microseconds forward only, 10 with reversing.
///
/// Source: Fraichard & Scheuer 2004, From Reeds and Shepp's to continuous-curvature paths,
/// doi 10.1109/TRO.2004.833789. Added here: all families of words rather than some, and the larger radii.
Curve continuousDubinsTurn(const Pose& from, const Pose& to, Length radius, CurvatureRate rate);

/// The same with reversing.
Curve continuousReedsSheppTurn(const Pose& from, const Pose& to, Length radius, CurvatureRate rate);

extern const Method<TurnPlanner> kContinuousDubinsMethod;
/// For machines that can reverse. Others get the forward one.
extern const Method<TurnPlanner> kContinuousReedsSheppMethod;

}  // namespace furrow
