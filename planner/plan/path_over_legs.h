#pragma once

#include "planner/path/fitting_ways.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"
#include "planner/plan/chosen_turns.h"
#include "planner/plan/plan_to_beat.h"
#include "planner/plan/stages.h"

#include <optional>
#include <vector>

namespace furrow {

/// The stages that a path follows from.
struct DriveTask {
    const PlanRequest& request;
    const Ground& ground;
    const Headland& headland;
    const LaidSwaths& laid;
    const Ordered& ordered;
};

/// A path's legs are joined by ways, checked and audited here. Keeps references to all it is made from.
class PathOverLegs {
public:
    /// @param ground         where ways may lead, gates open
    /// @param leftOnPurpose  for the audit
    PathOverLegs(const DriveTask& task, const MultiPolygon& ground, RememberedWays& ways,
                 const ChosenTurns& chosen, const MultiPolygon& leftOnPurpose);

    /// The path over these legs with what is found along it. Where no way leads from one leg to the next they
    /// are put in another order.
    ///
    /// @param finishing  passes among the legs that the headland does not have
    /// @param toBeat     InputRefused for a plan that is no better, as soon as that is known
    /// Cancelled.
    Result<Driven> drive(std::vector<Leg>& legs, std::vector<HeadlandPass> finishing,
                         std::optional<PlanToBeat> toBeat, const JobContext& job) const;

private:
    Result<Path> joined(std::vector<Leg>& legs, const JobContext& job) const;
    Result<std::vector<Finding>> foundIn(Path& path, const std::vector<Leg>& legs,
                                         const JobContext& job) const;

    const DriveTask& task_;
    const MultiPolygon& ground_;
    RememberedWays& ways_;
    const ChosenTurns& chosen_;
    const MultiPolygon& leftOnPurpose_;
};

/// The ways that are no turns between swaths: the chosen kind is kept where nothing has to fit.
TurnPlanner* otherTurns(const Settings& settings);

}  // namespace furrow
