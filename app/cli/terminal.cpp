#include "app/cli/terminal.h"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdio>
#include <memory>
#include <print>

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
        // Reported from many threads: only a step forward of a whole percent is drawn.
        job.progress = [shown = std::make_shared<std::atomic<int>>(-1)](double share) {
            const int percent = static_cast<int>(share * 100.0);
            int before = shown->load();
            while (percent > before) {
                if (shown->compare_exchange_weak(before, percent)) {
                    std::print(stderr, "\r[{:<40}] {:3} %",
                               std::string(static_cast<std::size_t>(percent) * 40 / 100, '='), percent);
                    std::fflush(stderr);
                    break;
                }
            }
        };
    }
    return job;
}

void clearProgress(bool quiet) {
    if (showsProgress(quiet)) {
        std::print(stderr, "\r\033[K");
    }
}

}  // namespace furrow::cli
