#pragma once

#include "planner/plan/choice_table.h"
#include "planner/plan/stage_runner.h"
#include "planner/route/route_proof.h"

#include <optional>

namespace furrow {

/// One field, one machine, one set of settings, planned. Immutable; the same request gives an equal
/// plan whatever the thread count (timings aside).
struct Plan {
    PlanRequest request;
    Length margin;                         ///< as used: the setting, or the boundary's accuracy
    std::optional<MultiPolygon> overhung;  ///< where implements may stand; empty: in the drivable area
    Headland headland;
    /// Land that may be driven on and is not worked on purpose: wet spots, what is passed over with them,
    /// alleys, gaps. The margin is not in it.
    MultiPolygon leftOnPurpose;
    SwathSet swaths;
    Decomposition cells;
    Route route;
    /// How far the route is from the best one. Empty for drafts, and where the order was not left to the
    /// planner.
    std::optional<RouteProof> proof;
    Path path;
    std::optional<RefillTrips> refill;  ///< the tank whose level the path states
    AuditReport audit;
    /// Of the planner and the audit; what both found is told once.
    std::vector<Finding> findings;
    /// What was used where the quickest was asked for, or a choice that promises time and is slower here; the
    /// latter with a note.
    std::vector<SettingChange> instead;
    std::vector<Note> notes;
    /// Of a best plan: what each of its choices is worth.
    std::optional<ChoiceTable> choices;
    StageTimings timings;

    const Field& field() const { return *request.field; }
    std::ptrdiff_t blockingCount() const;
    bool drivable() const;
};

/// What the audit reads of a plan. Points into it: the plan must outlive it.
AuditInput auditInput(const Plan& plan);

/// Plans a field: headland, swaths, cells and route, path, audit, in this order; choices that promise time
/// are compared with simpler ones (quickestChoice).
///
/// @param cache  of plans before this one; the plan is the same without
/// Errors: those of the stages; InputRefused where the machine fits nowhere in the field. Cancelled.
Result<std::shared_ptr<const Plan>> makePlan(const PlanRequest& request, const JobContext& job = {},
                                             StageCache* cache = nullptr);

}  // namespace furrow
