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

/// Ways that fit in an area. After the first failed search, quick searches are limited: between parts that
/// only narrow necks join, only single curves are tried. A failing search would otherwise go through all the
/// room. May be used by several threads at once. To get the same plan each time, all quick searches must come
/// after the others.
class FittingWays {
public:
    FittingWays(const MultiPolygon& drivable, const Machine& machine, TravelCost travel);

    const Rig& rig() const { return rig_; }
    /// Cost: as of `fittingConnection`.
    std::optional<Curve> between(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                 SearchEffort effort);
    /// The turn of one kind, if it fits.
    std::optional<Curve> byOne(const Method<TurnPlanner>& kind, const Pose& leaving,
                               const Pose& arriving) const;

private:
    MultiPolygon drivable_;
    Rig rig_;
    TravelCost travel_;
    std::once_flag once_;
    std::atomic<std::shared_ptr<const DrivenParts>> parts_;
};

}  // namespace furrow
