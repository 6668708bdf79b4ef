#pragma once

#include "planner/turns/manoeuvre_search.h"

#include <array>
#include <functional>
#include <map>
#include <mutex>
#include <optional>

namespace furrow {

/// Finds a way that fits with the given effort, or none.
using FittingWayFinder = std::function<std::optional<Curve>(const Pose& leaving, const Pose& arriving,
                                                            const JobContext& job, SearchEffort effort)>;

/// Remembers the result of each search, found or not. So a path that differs by a few legs costs only those.
/// May be used by several threads at once. Returns the same as the finder.
class RememberedWays {
public:
    explicit RememberedWays(FittingWayFinder finder) : finder_{std::move(finder)} {}

    std::optional<Curve> operator()(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                    SearchEffort effort = SearchEffort::Thorough);

private:
    FittingWayFinder finder_;
    std::mutex mutex_;
    std::map<std::array<double, 6>, std::optional<Curve>> found_;
};

}  // namespace furrow
