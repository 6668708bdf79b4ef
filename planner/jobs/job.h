#pragma once

#include <functional>
#include <stop_token>

namespace furrow {

/// What a running stage needs to know of the world: whether to stop, whom to tell, how many threads.
struct JobContext {
    std::stop_token stop;
    /// Called with a share in [0, 1] from whichever thread got there; may be empty.
    std::function<void(double)> progress;
    /// 0: as many as the machine has. The result never depends on it.
    int threads = 0;

    bool stopRequested() const { return stop.stop_requested(); }
    void report(double share) const {
        if (progress) {
            progress(share);
        }
    }
    /// Without progress: what is tried beside takes no part of it.
    JobContext withoutProgress() const { return {stop, {}, threads}; }
    /// A context whose progress from 0 to 1 is this one's from `begin` to `end`.
    JobContext part(double begin, double end) const {
        if (!progress) {
            return {stop, {}, threads};
        }
        return {stop, [sink = progress, begin, end](double share) { sink(begin + share * (end - begin)); },
                threads};
    }
};

}  // namespace furrow
