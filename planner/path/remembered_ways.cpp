#include "planner/path/remembered_ways.h"

namespace furrow {

std::optional<Curve> RememberedWays::operator()(const Pose& leaving, const Pose& arriving,
                                                const JobContext& job, SearchEffort effort) {
    const std::array key{leaving.position.x,  leaving.position.y,  leaving.heading.si(),
                         arriving.position.x, arriving.position.y, arriving.heading.si()};
    {
        const std::lock_guard lock{mutex_};
        if (const auto known = found_.find(key); known != found_.end()) {
            return known->second;
        }
    }
    std::optional<Curve> way = finder_(leaving, arriving, job, effort);
    // A quick search may miss an existing way, so its failure is not remembered.
    if (!job.stopRequested() && (way || effort == SearchEffort::Thorough)) {
        const std::lock_guard lock{mutex_};
        found_.emplace(key, way);
    }
    return way;
}

}  // namespace furrow
