#include "planner/jobs/parallel.h"

#include "planner/jobs/wide_registers.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <atomic>
#include <mutex>

namespace furrow {

Result<void> parallelFor(std::size_t count, const std::function<void(std::size_t)>& body,
                         const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    std::atomic<std::size_t> finished = 0;
    std::mutex reporting;
    std::size_t reported = 0;
    const auto runOne = [&](std::size_t i) {
        body(i);
        // A hundred reports are enough for any bar; in order, whichever thread comes first.
        const std::size_t done = ++finished;
        if (job.progress && done * 100 / count != (done - 1) * 100 / count) {
            const std::lock_guard lock{reporting};
            if (done > reported) {
                reported = done;
                job.report(static_cast<double>(done) / static_cast<double>(count));
            }
        }
    };
    if (job.threads == 1) {
        clearWideRegisters();
        for (std::size_t i = 0; i < count && !job.stopRequested(); ++i) {
            runOne(i);
        }
    } else {
        tbb::task_arena arena{job.threads > 0 ? job.threads : tbb::task_arena::automatic};
        tbb::task_group_context group;
        // Cancels chunks that have not begun; the check in the loop ends those that have.
        const std::stop_callback onStop{job.stop, [&group] { group.cancel_group_execution(); }};
        arena.execute([&] {
            tbb::parallel_for(
                tbb::blocked_range<std::size_t>{0, count},
                [&](const tbb::blocked_range<std::size_t>& range) {
                    clearWideRegisters();
                    for (std::size_t i = range.begin(); i != range.end() && !job.stopRequested(); ++i) {
                        runOne(i);
                    }
                },
                group);
        });
    }
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    return {};
}

}  // namespace furrow
