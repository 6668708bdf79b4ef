#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace furrow {

/// Runs `body(i)` for every i in [0, count) on the job's threads and reports progress, never backwards.
/// The body must not throw and must write only to what belongs to its own i.
/// Cancelled: a stop was requested; some bodies may not have run.
Result<void> parallelFor(std::size_t count, const std::function<void(std::size_t)>& body,
                         const JobContext& job);

/// The values of `make(i)` in the order of i, whatever the thread count. T needs a default.
template <class T, class Make>
Result<std::vector<T>> parallelMap(std::size_t count, const Make& make, const JobContext& job) {
    std::vector<T> values(count);
    const Result<void> done = parallelFor(count, [&](std::size_t i) { values[i] = make(i); }, job);
    if (!done) {
        return std::unexpected(done.error());
    }
    return values;
}

}  // namespace furrow
