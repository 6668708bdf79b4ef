#include "planner/path/fitting_ways.h"

#include "planner/geometry/tolerances.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/straight_turn.h"

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

// Total room beside the tractor in a neck. Quick searches do not look for ways through narrower necks.
constexpr Length kNeckSpare = metres(0.8);
// Beyond this number of results all are forgotten: some ten megabytes.
constexpr std::size_t kMostWaysKept = 20'000;

std::optional<DrivenParts> partsOf(const MultiPolygon& area, Length breadth) {
    auto found = DrivenParts::of(area, breadth, {});
    return found ? std::optional{*std::move(found)} : std::nullopt;
}

}  // namespace

WaySearches::WaySearches(const AllowedAreas& areas, const Machine& machine, TravelCost travel)
    : areas_{areas}, rig_{areas, machine}, travel_{std::move(travel)} {}

std::optional<Curve> WaySearches::between(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                          SearchEffort effort) {
    const Key key{leaving.position.x,  leaving.position.y,    leaving.heading.si(),       arriving.position.x,
                  arriving.position.y, arriving.heading.si(), static_cast<double>(effort)};
    {
        const std::scoped_lock lock{mutex_};
        if (const auto known = found_.find(key); known != found_.end()) {
            return known->second;
        }
    }
    std::optional<Curve> way =
        fittingConnection(rig_, leaving, arriving, travel_, job, effort, straights(job),
                          [this](const Pose& from, const Pose& to) { return areApart(from, to); });
    if (!job.stopRequested()) {
        const std::scoped_lock lock{mutex_};
        if (found_.size() >= kMostWaysKept) {
            found_.clear();
        }
        found_.emplace(key, way);
    }
    return way;
}

std::optional<Curve> WaySearches::byOne(const Method<TurnPlanner>& kind, const Pose& leaving,
                                        const Pose& arriving) const {
    return fittingTurn(rig_, leaving, arriving, travel_, kind);
}

const StraightWays* WaySearches::straights(const JobContext& job) {
    if (!canTurnOnTheSpot(rig_.machine())) {
        return nullptr;
    }
    const std::scoped_lock lock{mutex_};
    if (!straights_) {
        const auto made = std::make_shared<const StraightWays>(areas_, rig_, job);
        // Those of a stopped job lack their corners.
        if (job.stopRequested()) {
            return nullptr;
        }
        straights_ = made;
    }
    return straights_.get();
}

bool WaySearches::areApart(const Pose& from, const Pose& to) {
    const Tractor& tractor = rig_.machine().spec().tractor;
    std::call_once(onceThrough_, [&] {
        const Length disc = std::min(tractor.width, tractor.length) - metres(kNeckContactM);
        through_ = partsOf(areas_.tractor(), disc);
    });
    const auto middle = [&](const Pose& pose) {
        const Length ahead = 0.5 * tractor.length - tractor.rearOverhang;
        return pose.position + ahead.si() * direction(pose.heading.si());
    };
    return through_ && through_->separate(middle(from), middle(to));
}

const DrivenParts* WaySearches::parts() {
    std::call_once(once_, [this] {
        parts_ = partsOf(areas_.tractor(), rig_.machine().spec().tractor.width + kNeckSpare);
    });
    return parts_ ? &*parts_ : nullptr;
}

std::optional<Curve> FittingWays::between(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                          SearchEffort effort) {
    if (effort == SearchEffort::Quick && hasFailed_) {
        const DrivenParts* const parts = searches_->parts();
        if (parts != nullptr && parts->separate(leaving.position, arriving.position)) {
            effort = SearchEffort::None;
        }
    }
    auto way = searches_->between(leaving, arriving, job, effort);
    if (!way && !job.stopRequested()) {
        hasFailed_ = true;
    }
    return way;
}

}  // namespace furrow
