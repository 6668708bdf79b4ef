#pragma once

#include "planner/plan/driving_room.h"
#include "planner/plan/stages.h"
#include "planner/route/route_proof.h"

#include <memory>

namespace furrow {

/// The stages that an order follows from.
struct OrderTask {
    const PlanRequest& request;
    const std::shared_ptr<const Ground>& ground;
    const LaidSwaths& laid;
    DrivingRooms& rooms;  ///< of plans before
};

/// Divides the mainland into cells and orders the swaths, by the chosen methods. Errors: those of the route.
/// Cancelled.
Result<Ordered> orderStage(const OrderTask& task, const JobContext& job);

/// How far this order is from the best one. Empty if that cannot be told. Cancelled.
Result<std::optional<RouteProof>> proofStage(const OrderTask& task, const Ordered& ordered,
                                             const JobContext& job);

/// What a route over these cells is made from, in free space. Points into all three, which must outlive it.
RouteTask routeTask(const PlanRequest& request, const SwathSet& swaths, const Decomposition& cells);

}  // namespace furrow
