#pragma once

#include "planner/path/driven_parts.h"
#include "planner/path/fitting_ways.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"
#include "planner/plan/audited_lands.h"
#include "planner/plan/chosen_turns.h"
#include "planner/plan/driving_room.h"
#include "planner/plan/plan_to_beat.h"
#include "planner/plan/stages.h"

#include <optional>
#include <vector>

namespace furrow {

/// The stages that a path follows from.
struct DriveTask {
    const PlanRequest& request;
    const std::shared_ptr<const Ground>& ground;
    const Headland& headland;
    const LaidSwaths& laid;
    const Ordered& ordered;
    DrivingRooms& rooms;  ///< of plans before
    AuditedLands& lands;  ///< the same
};

/// Ways of a machine that is narrower with its implement folded for the road.
struct FoldingWays {
    RememberedWays folded;
    RememberedWays either;  ///< raised, or folded where no raised way leads
};

/// Joins legs by ways, checks the path and audits it. Keeps references to all parameters.
class PathOverLegs {
public:
    /// @param ground         the area for ways, gates open
    /// @param room           of that area
    /// @param folding        taken where no raised way leads; null for machines that are no narrower folded
    /// @param leftOnPurpose  for the audit
    PathOverLegs(const DriveTask& task, const AllowedAreas& ground, const DrivingRoom& room,
                 RememberedWays& ways, FoldingWays* folding, const ChosenTurns& chosen,
                 const MultiPolygon& leftOnPurpose);

    /// In which the paths are driven.
    const DrivingRoom& room() const { return room_; }

    /// The path over these legs with its findings and audit. If no way leads from one leg to the next, the
    /// legs get another order. Where none leads then, the implement is folded.
    ///
    /// @param finishing  short passes among the legs, which are not passes of the headland
    /// @param toBeat     the best plan so far. InputRefused: this one cannot be better.
    /// Cancelled.
    Result<Driven> drive(std::vector<Leg>& legs, std::vector<HeadlandPass> finishing,
                         std::optional<PlanToBeat> toBeat, const JobContext& job) const;

    /// The same with trips among the legs: they keep their order, and the path states the tank's level.
    Result<Driven> driveWithTrips(std::vector<Leg> legs, const RefillTrips& trips,
                                  std::vector<HeadlandPass> finishing, std::optional<PlanToBeat> toBeat,
                                  const JobContext& job) const;

    /// The way from one leg to another with the implement raised, as the path takes it. Empty if none fits.
    std::optional<Curve> way(const Leg& from, const Leg& to, const JobContext& job,
                             SearchEffort effort = SearchEffort::Thorough) const;

private:
    enum class Folding { Never, WhereNeeded };
    /// Places without a way.
    struct Missing {
        std::size_t inAll = 0;
        std::size_t within = 0;  ///< of them, those within one part
    };

    Result<Driven> driveAs(std::vector<Leg>& legs, const RefillTrips* trips,
                           std::vector<HeadlandPass> finishing, std::optional<PlanToBeat> toBeat,
                           const JobContext& job) const;
    /// @param mayReorder  whether the legs may get another order where no way leads
    Result<std::vector<Leg>> joined(std::vector<Leg>& legs, bool mayReorder, const JobContext& job) const;
    /// @param rooms    where the tractor gets from one of them to another nowhere: no way is searched there
    /// @param missing  where no way that fits was found
    Result<std::vector<Leg>> joinedBy(const std::vector<Leg>& legs, Folding folding,
                                      const std::optional<DrivenParts>& rooms, Missing& missing,
                                      const JobContext& job) const;
    /// The legs in an order in which more ways lead from each to the next.
    Result<std::vector<Leg>> reordered(std::vector<Leg> legs, const Missing& missing,
                                       const JobContext& job) const;
    Result<std::vector<Finding>> foundIn(Path& path, const std::vector<Leg>& legs,
                                         const JobContext& job) const;

    const DriveTask& task_;
    const AllowedAreas& ground_;
    RememberedWays& ways_;
    FoldingWays* folding_;
    const ChosenTurns& chosen_;
    const MultiPolygon& leftOnPurpose_;
    const DrivingRoom& room_;
};

/// The kind of turn for all other ways. It is the chosen kind only if the machine may leave the field.
TurnPlanner* otherTurns(const Settings& settings);

}  // namespace furrow
