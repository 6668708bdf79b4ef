#pragma once

#include "planner/path/driven_parts.h"
#include "planner/settings/method.h"
#include "planner/turns/manoeuvre_search.h"
#include "planner/turns/straight_ways.h"
#include "planner/turns/turn_method.h"

#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace furrow {

/// Searches for ways in one area, with the results of all of them. Plans that share an area share these. May
/// be used by several threads at once. A result is the same whether it was searched before or not.
class WaySearches {
public:
    WaySearches(const AllowedAreas& areas, const Machine& machine, TravelCost travel);

    const Rig& rig() const { return rig_; }
    /// Cost: as of `fittingConnection` the first time.
    std::optional<Curve> between(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                 SearchEffort effort);
    /// The turn of one kind, if it fits.
    std::optional<Curve> byOne(const Method<TurnPlanner>& kind, const Pose& leaving,
                               const Pose& arriving) const;
    /// The parts of the area that only narrow necks join. Null where that cannot be told.
    const DrivenParts* parts();
    /// Whether no neck between two places lets the tractor through. On every way a disc as wide as the
    /// tractor comes along, so there is none then.
    bool areApart(const Pose& from, const Pose& to);

private:
    /// Null for machines that do not turn on the spot.
    const StraightWays* straights(const JobContext& job);

    using Key = std::array<double, 7>;

    AllowedAreas areas_;
    Rig rig_;
    TravelCost travel_;
    std::once_flag once_;
    std::optional<DrivenParts> parts_;
    std::once_flag onceThrough_;
    std::optional<DrivenParts> through_;  ///< where the tractor just fits
    std::mutex mutex_;
    std::shared_ptr<const StraightWays> straights_;
    std::map<Key, std::optional<Curve>> found_;
};

/// Ways of one plan. After its first failed search, quick searches are limited: between parts that only
/// narrow necks join, only single curves are tried. A failing search would otherwise go through all the room.
/// May be used by several threads at once. To get the same plan each time, all quick searches must come after
/// the others.
class FittingWays {
public:
    explicit FittingWays(std::shared_ptr<WaySearches> searches) : searches_{std::move(searches)} {}

    const Rig& rig() const { return searches_->rig(); }
    std::optional<Curve> between(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                 SearchEffort effort);
    std::optional<Curve> byOne(const Method<TurnPlanner>& kind, const Pose& leaving,
                               const Pose& arriving) const {
        return searches_->byOne(kind, leaving, arriving);
    }

private:
    std::shared_ptr<WaySearches> searches_;
    std::atomic<bool> hasFailed_{false};
};

}  // namespace furrow
