#pragma once

#include "planner/plan/audited_lands.h"
#include "planner/plan/driving_room.h"
#include "planner/plan/stage_memo.h"
#include "planner/plan/stages.h"

#include <memory>
#include <vector>

namespace furrow {

/// What the headland is made from, beside the request.
struct HeadlandInputs {
    std::shared_ptr<const Ground> ground;
    std::vector<Ring> filled;  ///< obstacles that it is laid without, since swaths go round them

    friend bool operator==(const HeadlandInputs&, const HeadlandInputs&) = default;
};

/// What swaths are laid in.
struct SwathInputs {
    std::shared_ptr<const Ground> ground;
    std::vector<Ring> round;  ///< obstacles that swaths go round
    MultiPolygon mainland;
    std::shared_ptr<const SwathSet> found;
    int passes = 0;  ///< of the headland

    friend bool operator==(const SwathInputs&, const SwathInputs&) = default;
};

/// Whether these look the same to the stages that follow: how they were found, and their notes, do not
/// matter.
bool isSameHeadland(const Headland& a, const Headland& b);
bool isSameSwaths(const LaidSwaths& a, const LaidSwaths& b);

/// What an order is made from.
struct OrderInputs {
    std::shared_ptr<const Ground> ground;
    std::shared_ptr<const LaidSwaths> laid;
    bool draft = false;
    std::vector<DrivenSwath> earlier = {};

    friend bool operator==(const OrderInputs& a, const OrderInputs& b) {
        return a.ground == b.ground && a.draft == b.draft && a.earlier == b.earlier &&
               isSameSwaths(*a.laid, *b.laid);
    }
};

struct DriveInputs {
    std::shared_ptr<const Ground> ground;
    std::shared_ptr<const Headland> headland;
    std::shared_ptr<const LaidSwaths> laid;
    std::shared_ptr<const Ordered> ordered;
    std::vector<std::vector<std::size_t>> turnCells;  ///< all that cells are to the path
    bool draft = false;

    friend bool operator==(const DriveInputs& a, const DriveInputs& b) {
        return a.ground == b.ground && a.draft == b.draft && isSameHeadland(*a.headland, *b.headland) &&
               isSameSwaths(*a.laid, *b.laid) && a.ordered->route == b.ordered->route &&
               a.turnCells == b.turnCells;
    }
};

struct NoInputs {
    friend bool operator==(const NoInputs&, const NoInputs&) = default;
};

/// The results of all stages that plans were made from lately: what does not depend on a change is not made
/// again. Results are the same with a cache and without. Thread-safe.
struct StageCache {
    StageMemo<NoInputs, Ground> grounds;
    StageMemo<HeadlandInputs, Headland> headlands;
    StageMemo<MultiPolygon, SwathSet> searches;  ///< of headings in a mainland
    StageMemo<SwathInputs, RoundedSwaths> swaths;
    StageMemo<OrderInputs, Ordered> orders;
    DrivingRooms rooms;
    AuditedLands lands;
    StageMemo<DriveInputs, Driven, 6> drives;  ///< megabytes each
};

}  // namespace furrow
