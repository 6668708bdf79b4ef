#pragma once

#include "planner/plan/plan.h"

#include <string>

namespace furrow {

/// The field of a plan with its guidance lines as ISOXML 4.3 task data (ISO 11783-10): the content of
/// TASKDATA.XML.
///
/// One field with a boundary per part (holes as inner rings), obstacles as polygons of their own, gates
/// as points of access, and an AB line for each direction that is driven: the longest swath of that
/// direction's first track, with the operating width. Terminals take such lines and plan the turns
/// themselves; driving order and turns have no place in the format. Longitudes and latitudes have nine
/// decimals (0.1 mm), names are cut to 32 characters.
/// Cost: linear in the points of the field and in the swaths. Does not fail.
std::string isoxmlTaskData(const Plan& plan);

}  // namespace furrow
