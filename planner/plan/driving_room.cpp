#include "planner/plan/driving_room.h"

#include "planner/path/travel_rule.h"

#include <utility>

namespace furrow {

Result<std::shared_ptr<const DrivingRoom>> drivingRoom(DrivingRooms& known, const PlanRequest& request,
                                                       DrivingRoomInputs inputs, const JobContext& job) {
    const auto make = [&, given = inputs](const PlanRequest& plain) -> Result<DrivingRoom> {
        const Machine& machine = plain.machine;
        auto travel = travelRule(given.traversal,
                                 {.workable = plain.field->workable(),
                                  .mainland = given.mainland,
                                  .machine = machine,
                                  .margin = given.ground->margin},
                                 job);
        if (!travel) {
            return std::unexpected(travel.error());
        }
        const auto raised = std::make_shared<WaySearches>(given.forWays, machine, *travel);
        const auto folded =
            machine.spec().implement.transportWidth
                ? std::make_shared<WaySearches>(given.forWays, machine.folded(), *std::move(travel))
                : raised;
        return DrivingRoom{raised, folded, SteeringRoom{given.forWays, machine},
                           std::make_shared<WayChecks>(given.forWays, machine),
                           std::make_shared<FullLockTrials>()};
    };
    // What settings decide is among the inputs.
    PlanRequest plain = request;
    plain.settings = {};
    return known.get(plain, std::move(inputs), make);
}

}  // namespace furrow
