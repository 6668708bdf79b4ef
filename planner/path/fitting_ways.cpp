#include "planner/path/fitting_ways.h"

#include "planner/turns/best_feasible.h"

#include <utility>

namespace furrow {

namespace {

// Total room beside the tractor in a neck. Quick searches do not look for ways through narrower necks.
constexpr Length kNeckSpare = metres(0.8);

}  // namespace

FittingWays::FittingWays(const MultiPolygon& drivable, const Machine& machine, TravelCost travel)
    : drivable_{drivable}, rig_{drivable, machine}, travel_{std::move(travel)} {}

std::optional<Curve> FittingWays::between(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                          SearchEffort effort) {
    const auto parts = parts_.load();
    const bool apart =
        effort == SearchEffort::Quick && parts && parts->separate(leaving.position, arriving.position);
    auto way = fittingConnection(rig_, leaving, arriving, travel_, job, apart ? SearchEffort::None : effort);
    if (!way && !job.stopRequested()) {
        std::call_once(once_, [this] {
            if (auto found =
                    DrivenParts::of(drivable_, rig_.machine().spec().tractor.width + kNeckSpare, {})) {
                parts_ = std::make_shared<const DrivenParts>(std::move(*found));
            }
        });
    }
    return way;
}

std::optional<Curve> FittingWays::byOne(const Method<TurnPlanner>& kind, const Pose& leaving,
                                        const Pose& arriving) const {
    return fittingTurn(rig_, leaving, arriving, travel_, kind);
}

}  // namespace furrow
