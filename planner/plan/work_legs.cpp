#include "planner/plan/work_legs.h"

#include "planner/geometry/tolerances.h"
#include "planner/headland/headland_passes.h"
#include "planner/jobs/parallel.h"
#include "planner/path/headland_order.h"
#include "planner/path/pass_placing.h"
#include "planner/plan/general_parameters.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/connection.h"
#include "planner/turns/straight_turn.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// What a way takes, beyond its time in free space, where none fits in the field.
constexpr Duration kNoWay = seconds(1000.0);

class WorkLegs {
public:
    WorkLegs(const DriveTask& task, WaySearches& ways, const Rig& lowered, const JobContext& job)
        : task_{task},
          machine_{task.request.machine},
          ways_{ways},
          lowered_{lowered},
          job_{job},
          staysInside_{task.request.settings.flag(kStayInside) && !task.request.draft},
          isFirst_{drivesHeadlandFirst(task.request.settings)},
          swaths_{swathLegs(task.laid.swaths, task.ordered.route, machine_)} {}

    Result<std::vector<Leg>> quickest() {
        const std::vector<HeadlandPass>& all = task_.headland.drivenPasses;
        if (all.empty()) {
            return swaths_;
        }
        if (!staysInside_) {
            return joined(headland(all));
        }
        std::vector<Leg> ringByRing = moved(joined(headland(all)));
        if (std::ranges::none_of(all, isShortPass)) {
            return ringByRing;
        }
        std::vector<HeadlandPass> shortOnes;
        std::vector<HeadlandPass> others;
        std::ranges::partition_copy(all, std::back_inserter(shortOnes), std::back_inserter(others),
                                    isShortPass);
        std::vector<Leg> asTheyFit = moved(withShort(joined(headland(others)), shortOnes));
        const auto inRings = timeOfWays(ringByRing);
        const auto fitted = timeOfWays(asTheyFit);
        if (!inRings || !fitted) {
            return std::unexpected(cancelled());
        }
        return *fitted < *inRings ? std::move(asTheyFit) : std::move(ringByRing);
    }

private:
    std::vector<Leg> headland(const std::vector<HeadlandPass>& passes) const {
        HeadlandDrive drive{.insideOut = drivesInsideOut(task_.request.settings),
                            .before = {},
                            .after = {},
                            .drivable = task_.ground->drivable};
        if (isFirst_ && !swaths_.empty()) {
            drive.after = swaths_.front().line.start;
        } else if (!swaths_.empty()) {
            drive.before = swaths_.back().line.end();
        }
        if (staysInside_) {
            drive.searched = [&](const Pose& leaving, const Pose& arriving) {
                return timeInTheField(leaving, arriving);
            };
        }
        return headlandLegs(passes, drive, machine_, otherTurns(task_.request.settings));
    }

    /// Headland and swaths.
    std::vector<Leg> joined(std::vector<Leg> passes) const {
        std::vector<Leg> legs = swaths_;
        legs.insert(isFirst_ ? legs.begin() : legs.end(), std::make_move_iterator(passes.begin()),
                    std::make_move_iterator(passes.end()));
        return legs;
    }

    /// Short passes where they add least in free space.
    std::vector<Leg> withShort(std::vector<Leg> legs, const std::vector<HeadlandPass>& passes) const {
        RememberedWays free{[&](const Pose& leaving, const Pose& arriving, const JobContext&, SearchEffort) {
            return std::optional{freeWay(leaving, arriving)};
        }};
        return withPassesBetween(std::move(legs), passes, free, machine_, job_).legs;
    }

    /// Short passes that real ways lead to elsewhere much quicker.
    std::vector<Leg> moved(std::vector<Leg> legs) const {
        RememberedWays inTheField{
            [&](const Pose& leaving, const Pose& arriving, const JobContext& part, SearchEffort effort) {
                return ways_.between(leaving, arriving, part, effort);
            }};
        return withShortPassesMoved(std::move(legs), inTheField, lowered_, job_);
    }

    Curve freeWay(const Pose& leaving, const Pose& arriving) const {
        return connection(leaving, arriving, machine_, kBestFeasibleMethod.run);
    }

    std::optional<Duration> timeInTheField(const Pose& leaving, const Pose& arriving) const {
        return ways_.between(leaving, arriving, job_, SearchEffort::Thorough)
            .transform([&](const Curve& way) { return drivenDuration(way, leaving, arriving, machine_); });
    }

    /// From leg to leg.
    Result<Duration> timeOfWays(const std::vector<Leg>& legs) const {
        const auto times = parallelMap<Duration>(
            std::max<std::size_t>(legs.size(), 1) - 1,
            [&](std::size_t i) {
                const Pose leaving = legs[i].line.end();
                const Pose& arriving = legs[i + 1].line.start;
                if (distance(leaving.position, arriving.position) < kMeetM) {
                    return Duration{};
                }
                const auto time = timeInTheField(leaving, arriving);
                return time
                           ? *time
                           : kNoWay + drivenDuration(freeWay(leaving, arriving), leaving, arriving, machine_);
            },
            job_.withoutProgress());
        return times.transform([](const std::vector<Duration>& all) {
            return std::ranges::fold_left(all, Duration{}, std::plus{});
        });
    }

    const DriveTask& task_;
    const Machine& machine_;
    WaySearches& ways_;
    const Rig& lowered_;
    const JobContext& job_;
    bool staysInside_;
    bool isFirst_;
    std::vector<Leg> swaths_;
};

}  // namespace

Result<std::vector<Leg>> workLegs(const DriveTask& task, WaySearches& ways, const Rig& lowered,
                                  const JobContext& job) {
    return WorkLegs{task, ways, lowered, job}.quickest();
}

}  // namespace furrow
