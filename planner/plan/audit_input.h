#pragma once

#include "planner/plan/stages.h"

#include <span>

namespace furrow {

/// The parts of a plan that an audit reads.
struct AuditedParts {
    const PlanRequest& request;
    Length margin;
    const std::optional<MultiPolygon>& overhung;  ///< as of Ground
    const Headland& headland;
    std::span<const HeadlandPass> finishing;  ///< short passes, which are not passes of the headland
    const MultiPolygon& mainland;
    const SwathSet& swaths;
    const Route& route;
    const Path& path;
    const MultiPolygon& leftOnPurpose;
    const RefillTrips* refill = nullptr;  ///< null if the path does not follow a tank
};

/// Points into the path, which must outlive it.
AuditInput auditInput(const AuditedParts& plan);

}  // namespace furrow
