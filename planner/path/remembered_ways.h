#pragma once

#include "planner/turns/manoeuvre_search.h"

#include <array>
#include <functional>
#include <map>
#include <mutex>
#include <optional>

namespace furrow {

/// Finds a way that fits with as much effort as asked for, or none.
using FittingWayFinder = std::function<std::optional<Turn>(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                                          SearchEffort effort)>;

/// Ways that were looked for once, found or not, are not looked for again: a path that differs from another by a few
/// legs costs those. May be asked by several threads at once; gives what the finder gives.
class RememberedWays {
public:
    explicit RememberedWays(FittingWayFinder finder) : finder_{std::move(finder)} {}

    std::optional<Turn> operator()(const Pose& leaving, const Pose& arriving, const JobContext& job,
                                   SearchEffort effort = SearchEffort::Thorough);

private:
    FittingWayFinder finder_;
    std::mutex mutex_;
    std::map<std::array<double, 6>, std::optional<Turn>> found_;
};

}  // namespace furrow
