#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/units/quantity.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace furrow {

/// One measurement: processor time on one thread, wall time on more.
struct SpeedCase {
    std::string name;
    double areaHa = 0.0;
    std::size_t vertices = 0;
    int threads = 1;
    int runs = 0;
    Duration least;
    Duration median;
    /// The same by plain GEOS, in turn with ours, on one thread. Empty if there is no such method.
    std::optional<Duration> yardstickLeast;
    std::optional<Duration> yardstick;  ///< median
    std::optional<double> ratio;        ///< of the yardstick to ours, the median of all turns
    /// The largest growth of memory in one more run. Only for whole plans, if the system gives a figure.
    std::optional<std::size_t> peakMemoryBytes;
};

/// Headings, searches, whole plans (with their memory) and turns, from 0.25 to 256 ha, 10 to 100,000
/// vertices, on one and two threads. The yardstick of a search is measured on a few headings at a time,
/// and scaled to all. Takes a minute or two. Cancelled.
Result<std::vector<SpeedCase>> measureSpeed(const JobContext& job);

}  // namespace furrow
