#pragma once

#include "planner/plan/driving_room.h"
#include "planner/plan/gate_legs.h"

#include <vector>

namespace furrow {

/// Where the ways of one plan may lead.
struct WaysRoom {
    RouteEnds places;
    std::vector<RoutePlace> refills;
    AllowedAreas open;    ///< the drivable area with the gates open
    AllowedAreas ground;  ///< for ways; more than `open` if the machine may leave the field
    std::shared_ptr<const DrivingRoom> room;
};

/// Errors: those of `routePlace` and `routePlaces`. Cancelled.
Result<WaysRoom> waysRoom(DrivingRooms& known, const PlanRequest& request,
                          const std::shared_ptr<const Ground>& ground, const MultiPolygon& mainland,
                          const JobContext& job);

}  // namespace furrow
