#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/units/quantity.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// One measurement, wall time on this machine.
struct SpeedCase {
    std::string name;
    double areaHa = 0.0;
    std::size_t vertices = 0;
    int threads = 1;
    int runs = 0;
    Duration median;
    /// The same by plain GEOS in the same run. Empty if there is no such method.
    std::optional<Duration> yardstick;
    /// The largest growth of memory in one more run. Only for whole plans, if the system gives a figure.
    std::optional<std::size_t> peakMemoryBytes;

    std::optional<double> ratio() const {
        return yardstick ? std::optional{*yardstick / median} : std::nullopt;
    }
};

/// Headings, searches, whole plans (with their memory) and turns, from 0.25 to 256 ha, 10 to 100,000
/// vertices, on one and two threads. If the yardstick of a search takes long, it is measured on some of its
/// headings and scaled to all. Takes a minute or two. Cancelled.
Result<std::vector<SpeedCase>> measureSpeed(const JobContext& job);

}  // namespace furrow
