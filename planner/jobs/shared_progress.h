#pragma once

#include "planner/jobs/job.h"

#include <cstddef>
#include <mutex>
#include <vector>

namespace furrow {

/// The progress of pieces of about equal size that may be worked on at once: the job's is the mean of theirs.
/// Outlives the contexts that it gives. Thread-safe.
class SharedProgress {
public:
    SharedProgress(std::size_t count, const JobContext& job) : job_{job}, shares_(count) {}

    /// A context for this piece. Its progress never goes back.
    JobContext piece(std::size_t index);
    /// Whatever is left of a piece is not needed.
    void finish(std::size_t index) { report(index, 1.0); }

private:
    void report(std::size_t index, double share);

    JobContext job_;
    std::mutex mutex_;
    std::vector<double> shares_;
};

}  // namespace furrow
