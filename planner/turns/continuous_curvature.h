#pragma once

#include "planner/settings/method.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// Curves whose curvature is continuous: it starts and ends at zero, passes through zero at every change of
/// side and at every cusp (the wheels need not be turned at standstill), never exceeds 1 / radius, and never
/// changes faster along the way than `rate`.
///
/// They are the words of Dubins and of Reeds and Shepp with turns that begin and end with a clothoid:
///
///     curvature    ____          A turn by less than its clothoids alone would make (an "elementary path")
///                 /    \         is two flatter clothoids whose ends lie on the same circle around the
///          ______/      \_____   same centre; by nothing, the straight between them.
///
/// A turn is solved exactly, in closed form: Fresnel integrals by their power series, so the end pose is
/// exact to rounding, but for a turn of less than 1e-9 rad that is left out. The result is the shortest of
/// these words with all turns of one smallest radius, which is tried at `radius` and at a few larger ones,
/// because flatter turns need less way for a small shift sideways. It is no shorter than the Dubins or
/// Reeds-Shepp curve and becomes it as the rate grows; that nothing at all is shorter is not known.
/// At a rate so low that two clothoids would turn past half a circle before the curvature is reached, less
/// than the greatest curvature is used.
/// About 2 microseconds forward only, 10 with reversing.
///
/// Source: Fraichard & Scheuer 2004, From Reeds and Shepp's to continuous-curvature paths,
/// doi 10.1109/TRO.2004.833789. Beyond it: all families of words rather than some, and the larger radii.
Turn continuousDubinsTurn(const Pose& from, const Pose& to, Length radius, CurvatureRate rate);

/// The same with reversing.
Turn continuousReedsSheppTurn(const Pose& from, const Pose& to, Length radius, CurvatureRate rate);

extern const Method<TurnPlanner> kContinuousDubinsMethod;
/// For machines that can reverse; others get the forward one.
extern const Method<TurnPlanner> kContinuousReedsSheppMethod;

}  // namespace furrow
