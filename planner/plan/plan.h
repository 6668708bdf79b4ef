#pragma once

#include "planner/audit/audit.h"
#include "planner/decomposition/decomposition.h"
#include "planner/field/field.h"
#include "planner/headland/headland.h"
#include "planner/machine/machine.h"
#include "planner/path/finding.h"
#include "planner/path/path.h"
#include "planner/route/route.h"
#include "planner/settings/settings.h"
#include "planner/swaths/guide_data.h"
#include "planner/swaths/swath.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace furrow {

/// Everything a plan follows from.
struct PlanRequest {
    std::shared_ptr<const Field> field;
    Machine machine;
    Settings settings;
    /// What swaths.rows and swaths.elevation name, read.
    std::shared_ptr<const GuideData> guides = {};
    /// Only to be looked at: the path is not audited. See draftOf.
    bool draft = false;
};

/// Wall time of each stage.
struct StageTimings {
    Duration headland;
    Duration swaths;
    Duration route;
    Duration path;
    Duration audit;
    Duration total;
};

/// One field, one machine, one set of settings, planned. Immutable; the same request gives an equal
/// plan whatever the thread count (timings aside).
struct Plan {
    PlanRequest request;
    Length margin;  ///< as used: the setting, or the boundary's accuracy
    Headland headland;
    /// Land that may be driven on and is not worked on purpose: wet spots, what is passed over with them, alleys, gaps.
    /// The margin is not in it.
    MultiPolygon leftOnPurpose;
    SwathSet swaths;
    Decomposition cells;
    Route route;
    Path path;
    AuditReport audit;
    /// Of the planner and the audit; what both found is told once.
    std::vector<Finding> findings;
    /// What was used where the quickest was asked for, or a choice that promises time and is slower here; the latter with
    /// a note.
    std::vector<SettingChange> instead;
    std::vector<Note> notes;
    StageTimings timings;

    const Field& field() const { return *request.field; }
    std::ptrdiff_t blockingCount() const;
    bool drivable() const;
};

/// What the audit reads of a plan. Points into it: the plan must outlive it.
AuditInput auditInput(const Plan& plan);

/// Plans a field: headland, swaths, route, path, audit, in this order; choices that promise time are compared with
/// simpler ones (quickestChoice).
/// Errors: those of the stages; InputRefused where the machine fits nowhere in the field. Cancelled.
Result<std::shared_ptr<const Plan>> makePlan(const PlanRequest& request, const JobContext& job = {});

}  // namespace furrow
