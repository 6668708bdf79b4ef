#include "planner/plan/drive_stage.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/path/folded_stretches.h"
#include "planner/path/lifted_legs.h"
#include "planner/plan/finish_stage.h"
#include "planner/plan/gate_legs.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/refill_stage.h"
#include "planner/plan/ways_room.h"
#include "planner/plan/work_legs.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace furrow {

namespace {

// Of the progress, where trips to refill points are planned after all else.
constexpr double kWithoutTrips = 0.6;

Error nothingWorked(const Field& field) {
    return {.code = ErrorCode::InputRefused,
            .what = "the margin and the obstacles that may be driven on leave nothing to work",
            .where = field.source().origin.empty() ? field.name() : field.source().origin,
            .remedy = "make them smaller, or delete some of them",
            .place = middleOf(field.source().parts)};
}

/// Wet spots and the land beside them that is passed over, and what the swaths leave.
Result<MultiPolygon> landLeftOnPurpose(const DriveTask& task, MultiPolygon passedOver,
                                       const JobContext& job) {
    std::ranges::copy(task.request.field->passable(), std::back_inserter(passedOver));
    std::ranges::copy(task.laid.swaths.leftOnPurpose, std::back_inserter(passedOver));
    return passedOver.empty() ? Result<MultiPolygon>{} : unionOf(passedOver, job);
}

}  // namespace

Result<Driven> driveStage(const DriveTask& task, std::optional<PlanToBeat> toBeat, const JobContext& job) {
    const Field& field = *task.request.field;
    const Machine& machine = task.request.machine;
    const Settings& settings = task.request.settings;
    const auto roomForWays = waysRoom(task.rooms, task.request, task.ground, task.laid.mainland, job);
    if (!roomForWays) {
        return std::unexpected(roomForWays.error());
    }
    const auto& [places, refills, open, ground, room] = *roomForWays;
    const auto fitting = std::make_shared<FittingWays>(room->raised);
    const auto folded = std::make_shared<FittingWays>(room->folded);
    GateWays gates;
    RememberedWays ways{[&](const Pose& leaving, const Pose& arriving, const JobContext& part,
                            SearchEffort effort) {
        return (gates.leads(leaving, arriving) ? folded : fitting)->between(leaving, arriving, part, effort);
    }};
    FoldingWays folding{.folded = RememberedWays{[&](const Pose& leaving, const Pose& arriving,
                                                     const JobContext& part, SearchEffort effort) {
                            return folded->between(leaving, arriving, part, effort);
                        }},
                        .either = RememberedWays{[&](const Pose& leaving, const Pose& arriving,
                                                     const JobContext& part, SearchEffort effort) {
                            auto way = ways(leaving, arriving, part, effort);
                            return way ? way : folding.folded(leaving, arriving, part, effort);
                        }}};
    FoldingWays* const narrower = foldsNarrower(machine) ? &folding : nullptr;
    const auto work = workLegs(task, *room->raised, room->steering.lowered, job.withoutProgress());
    if (!work) {
        return std::unexpected(work.error());
    }
    auto [legs, passedOver] = liftedOver(*work, field.passable(), machine, machine.spec().implement.length);
    if (std::ranges::none_of(legs, &Leg::implementDown)) {
        return std::unexpected(nothingWorked(field));
    }
    const auto leftOnPurpose = landLeftOnPurpose(task, std::move(passedOver), job);
    if (!leftOnPurpose) {
        return std::unexpected(leftOnPurpose.error());
    }
    const ChosenTurns chosen{settings, task.laid.swaths, task.ordered.cells, *fitting};
    gates = addGateWays(legs, places, field, Rig{open, machine.folded()});
    const PathOverLegs path{task, ground, *room, ways, narrower, chosen, *leftOnPurpose};
    const double working = refills.empty() ? 1.0 : kWithoutTrips;
    auto driven = path.drive(legs, {}, toBeat, job.part(0.0, 0.8 * working));
    if (driven) {
        driven = finishStage(task, *std::move(driven), legs, path, ways, narrower, ground, toBeat,
                             job.part(0.8 * working, working));
    }
    if (driven && !refills.empty() && !task.request.draft) {
        driven = refillStage(task, *std::move(driven), legs, refills, path, fitting->rig(), toBeat,
                             job.part(working, 1.0));
    }
    if (driven) {
        std::ranges::move(gates.findings, std::back_inserter(driven->findings));
    }
    return driven;
}

}  // namespace furrow
