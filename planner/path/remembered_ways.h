#pragma once

#include "planner/path/headland_order.h"

#include <array>
#include <map>
#include <mutex>

namespace furrow {

/// Ways that were looked for once, found or not, are not looked for again: a path that differs from another by a few
/// legs costs those. May be asked by several threads at once; gives what the finder gives.
class RememberedWays {
public:
    explicit RememberedWays(FittingWayFinder finder) : finder_{std::move(finder)} {}

    std::optional<Turn> operator()(const Pose& leaving, const Pose& arriving, const JobContext& job);

private:
    FittingWayFinder finder_;
    std::mutex mutex_;
    std::map<std::array<double, 6>, std::optional<Turn>> found_;
};

}  // namespace furrow
