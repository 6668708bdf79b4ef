#pragma once

#include "planner/path/driven_parts.h"
#include "planner/settings/method.h"
#include "planner/turns/manoeuvre_search.h"
#include "planner/turns/turn_method.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>

namespace furrow {

/// Ways in an area that fit. Once one was not to be had, none is looked for quickly between parts that are joined by
/// narrow necks at most, but for single curves: a search goes through all the room there is before it fails. May be
/// asked by several threads at once; for the same plan each time those that ask quickly come after all that do not.
class FittingWays {
public:
    FittingWays(const MultiPolygon& drivable, const Machine& machine, TravelCost travel);

    const Rig& rig() const { return rig_; }
    /// Cost: as of `fittingConnection`.
    std::optional<Turn> between(const Pose& leaving, const Pose& arriving, const JobContext& job, SearchEffort effort);
    /// The turn of one kind, where it fits.
    std::optional<Turn> byOne(const Method<TurnPlanner>& kind, const Pose& leaving, const Pose& arriving) const;

private:
    MultiPolygon drivable_;
    Rig rig_;
    TravelCost travel_;
    std::once_flag once_;
    std::atomic<std::shared_ptr<const DrivenParts>> parts_;
};

}  // namespace furrow
