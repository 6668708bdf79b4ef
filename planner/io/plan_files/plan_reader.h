#pragma once

#include "planner/audit/audit.h"
#include "planner/core/result.h"
#include "planner/geodesy/local_frame.h"
#include "planner/jobs/job.h"

#include <filesystem>
#include <string>
#include <vector>

namespace furrow {

/// A plan as its files tell it: what an audit needs, and nothing that only the planner knew.
struct WrittenPlan {
    std::string name;  ///< of the field
    LocalFrame frame;
    MultiPolygon workable;
    MultiPolygon drivable;
    std::vector<AuditGate> gates;
    std::optional<Machine> machine;
    std::vector<PathSegment> segments;
    std::vector<PlannedPass> passes;
    std::optional<MultiPolygon> mainland;  ///< where the strip around it is not driven
    Length margin;
    MultiPolygon leftOnPurpose;
    std::optional<MultiPolygon> overhung;  ///< as of AuditInput
    std::optional<AuditTank> tank;         ///< whose level path.csv states
    bool mayLeaveField = false;
    bool statedMotion = true;  ///< headings, speeds and times were read, not only lines
    Length positionRounding;
};

/// Reads a plan back.
///
/// @param path  a folder with summary.json (machine, settings, local frame), plan.geojson (field, obstacles,
///              gates, swaths, what is drivable) and path.csv (the path, to the last bit), or a
///              plan's GeoJSON alone, whose lines have positions only
/// @return ReadFailed: a file is missing or cannot be read. InputRefused, naming file and row or feature:
///         no path in it, damaged, and what the field's own checks refuse. Cancelled.
Result<WrittenPlan> readPlan(const std::filesystem::path& path, const JobContext& job = {});

/// What the audit reads of it. Points into it.
AuditInput auditInput(const WrittenPlan& plan);

}  // namespace furrow
