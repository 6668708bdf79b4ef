#include "app/cli/terminal.h"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <print>
#include <utility>

namespace furrow::cli {

namespace {

sigset_t stopSignals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

bool showsProgress(bool quiet) {
    return !quiet && ::isatty(STDERR_FILENO) == 1;
}

/// Calls tell(step) for every step that the work reaches, of this many in all. Work reports from many
/// threads, and not always in order.
std::function<void(double)> inSteps(int steps, std::function<void(int)> tell) {
    return [steps, tell = std::move(tell), told = std::make_shared<std::atomic<int>>(0)](double share) {
        const int step = static_cast<int>(share * steps);
        int before = told->load();
        while (step > before) {
            if (told->compare_exchange_weak(before, step)) {
                tell(step);
                return;
            }
        }
    };
}

}  // namespace

InterruptWatch::InterruptWatch() {
    // Blocked in every thread, so that only the one that waits for it gets it: no handler, nothing unsafe.
    const sigset_t set = stopSignals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    waiter_ = std::jthread{[this] {
        const sigset_t waited = stopSignals();
        int received = 0;
        sigwait(&waited, &received);
        source_.request_stop();
    }};
}

InterruptWatch::~InterruptWatch() {
    pthread_kill(waiter_.native_handle(), SIGINT);
}

JobContext terminalJob(const InterruptWatch& watch, int threads, bool quiet) {
    JobContext job{.stop = watch.token(), .progress = {}, .threads = threads};
    if (showsProgress(quiet)) {
        job.progress = inSteps(100, [](int percent) {
            std::print(stderr, "\r[{:<40}] {:3} %",
                       std::string(static_cast<std::size_t>(percent) * 40 / 100, '='), percent);
            std::fflush(stderr);
        });
    }
    return job;
}

JobContext linesJob(const InterruptWatch& watch, int threads) {
    return {.stop = watch.token(),
            .progress = inSteps(10, [](int tenth) { std::println(stderr, "progress {} %", 10 * tenth); }),
            .threads = threads};
}

void clearProgress(bool quiet) {
    if (showsProgress(quiet)) {
        std::print(stderr, "\r\033[K");
    }
}

}  // namespace furrow::cli
