#pragma once

#include "planner/jobs/job.h"

#include <stop_token>
#include <string>
#include <thread>

namespace furrow::cli {

/// Turns Ctrl+C into a stop request. Make it before any other thread.
class InterruptWatch {
public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::jthread waiter_;
};

/// A context that stops on Ctrl+C and draws a bar on standard error where that is a terminal.
JobContext terminalJob(const InterruptWatch& watch, int threads, bool quiet);

/// The same, with a line on standard error for each tenth of the work, for other programs to read.
JobContext linesJob(const InterruptWatch& watch, int threads);

/// Takes the bar away again.
void clearProgress(bool quiet);

}  // namespace furrow::cli
