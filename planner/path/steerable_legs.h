#pragma once

#include "planner/path/path_builder.h"
#include "planner/turns/rig.h"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace furrow {

/// Lines that were eased before. A path that differs by a few legs costs only those. May be used by several
/// threads at once.
class EasedRuns {
public:
    /// What a run consists of, number by number.
    using Key = std::vector<double>;

    std::optional<std::vector<Curve>> find(const Key& key) const;
    void add(Key key, std::vector<Curve> lines);

private:
    mutable std::mutex mutex_;
    std::map<Key, std::vector<Curve>> known_;
};

/// The machine in its three states, in the area in which it may drive.
struct SteeringRoom {
    SteeringRoom(const AllowedAreas& areas, const Machine& machine);

    Rig lowered;
    Rig raised;
    Rig folded;  ///< on ways in and out, and where no raised way leads
    std::shared_ptr<EasedRuns> known = std::make_shared<EasedRuns>();
};

/// The same legs as a line that steering can follow: its curvature changes over the way that the steering
/// needs at the turning speed from straight to full lock. In turns this is doubled where the side changes, so
/// that it does not cost speed. The line leaves the legs by centimetres, on the inside of their bends, and
/// legs begin within half a metre of where they did. Where that would leave the area, the change takes less
/// way, and is driven more slowly. In the end a bend stays as it is, and the machine stops to steer.
/// Straights stay where they are. At a change of gear the wheels turn while the machine brakes and sets off.
///
/// Cost: some ten microseconds for each bend and the test of its room. Runs between long straights are eased
/// in parallel. Cancelled.
Result<std::vector<Leg>> steerableLegs(std::vector<Leg> legs, const SteeringRoom& room,
                                       const JobContext& job);

}  // namespace furrow
