#pragma once

#include "planner/settings/method.h"
#include "planner/turns/turn_method.h"

namespace furrow {

/// The shortest curve between two poses, with reversing, whose radius is never below the given one. It is the
/// best of the 48 words of Reeds and Shepp in closed form. The end pose is exact except for rounding; an arc
/// of less than 1e-9 rad is left out. Up to five pieces, each with a length. About 1 microsecond. Source:
/// Reeds & Shepp 1990, doi 10.2140/pjm.1990.145.367. The words are solved for the centres of the arcs (see
/// word_search.h). This covers their formulas 8.1 to 8.11 with all reflections and time flips.
Curve reedsSheppTurn(const Pose& from, const Pose& to, Length radius);

/// The length of that curve only.
Length reedsSheppLength(const Pose& from, const Pose& to, Length radius);

/// For machines that can reverse. Others get the Dubins turn.
extern const Method<TurnPlanner> kReedsSheppMethod;

}  // namespace furrow
