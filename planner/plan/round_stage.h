#pragma once

#include "planner/plan/plan.h"

#include <vector>

namespace furrow {

/// Up to which size obstacles are gone round.
extern const Parameter kRoundUpTo;

/// As given; otherwise the operating width, but no less than 1.5 m.
Length roundUpTo(const Settings& settings, const Machine& machine);

/// Takes out the obstacles that do not lie inside a plan's mainland, clear of what its headland passes take; says
/// whether there were any.
bool eraseOutside(std::vector<Ring>& obstacles, const Plan& plan);

/// Leads the swaths of a plan round obstacles that its headland and swaths were laid without, and measures what they
/// cover then. Those that are refused are taken out of the list: the plan has to be laid out again, with them.
///
/// @param drivable  where the machine may be
/// @return whether any was refused. Cancelled.
Result<bool> roundStage(Plan& plan, std::vector<Ring>& obstacles, const MultiPolygon& drivable, const JobContext& job);

/// Cuts what swaths go round out of the mainland, the cells and what is left on purpose. Cancelled.
Result<void> cutOutGoneRound(Plan& plan, const JobContext& job);

/// The obstacles that swaths go round, but for those near which something blocks the plan; all where there is none.
std::vector<Ring> awayFromBlocking(const Plan& plan);

}  // namespace furrow
