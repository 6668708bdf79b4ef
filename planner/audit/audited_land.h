#pragma once

#include "planner/audit/audit.h"
#include "planner/audit/clearance_meter.h"
#include "planner/audit/known_pieces.h"
#include "planner/audit/motion.h"
#include "planner/audit/working_room.h"

#include <memory>
#include <optional>

namespace furrow {

/// An area with gates open, and the index of its edges.
struct OpenLand {
    explicit OpenLand(MultiPolygon area);

    MultiPolygon open;
    ClearanceMeter meter;
};

/// The areas that footprints are measured against.
struct ClearanceLand {
    OpenLand drivable;
    std::optional<OpenLand> overhung;  ///< for the implement, if not the same
};

/// Cancelled.
Result<ClearanceLand> clearanceLand(const AuditInput& input, const JobContext& job);

/// What audits measure paths against. It follows from the areas, gates, machine and margin of an AuditInput
/// and not from its path: plans of one field share it. Immutable; thread-safe.
struct AuditedLand {
    MultiPolygon withinMargin;               ///< the drivable area less the margin
    std::optional<MultiPolygon> reach;       ///< of it, by a disc, see `audit`; empty without a machine
    std::optional<ClearanceLand> clearance;  ///< empty without a machine
    std::optional<WorkingRoom> room;         ///< within the margin, of a machine with a mounted implement
    /// Pieces of missed land that were looked at before: without hairs, and their parts with room. The
    /// answers are the same without.
    std::shared_ptr<KnownPieces> withoutHairs = std::make_shared<KnownPieces>(kMostPieces);
    std::shared_ptr<KnownPieces> withRoom = std::make_shared<KnownPieces>(kMostPieces);
};

/// Cost: two offsets of the field, and two sorted lists of its edges. Cancelled.
Result<AuditedLand> auditedLand(const AuditInput& input, const JobContext& job);

/// `audit` with the land of this input made before.
Result<AuditReport> audit(const AuditInput& input, const AuditedLand& land, const JobContext& job);

}  // namespace furrow
