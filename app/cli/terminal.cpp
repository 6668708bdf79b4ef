#include "app/cli/terminal.h"

#include "app/cli/exit_status.h"
#include "planner/io/files/atomic_files.h"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <mutex>
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

/// Work looks at the request every few milliseconds. What does not (a library in a long loop, a pipe that
/// nobody writes) is left where it is; files that are being written are finished or taken away first.
void leaveUnlessOver(const std::stop_token& over) {
    constexpr auto kPatience = std::chrono::milliseconds{700};
    std::mutex mutex;
    std::condition_variable_any wakened;
    std::unique_lock lock{mutex};
    do {
        wakened.wait_for(lock, over, kPatience, [] { return false; });
    } while (!over.stop_requested() && isWritingFiles());
    if (!over.stop_requested()) {
        std::println(stderr, "furrow-cli: {}", cancelled().line());
        ::_exit(kCancelled);
    }
}

}  // namespace

InterruptWatch::InterruptWatch() {
    // Blocked in every thread, so that only the one that waits for it gets it: no handler, nothing unsafe.
    const sigset_t set = stopSignals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    waiter_ = std::jthread{[this](const std::stop_token& over) {
        const sigset_t waited = stopSignals();
        int received = 0;
        sigwait(&waited, &received);
        source_.request_stop();
        leaveUnlessOver(over);
    }};
}

InterruptWatch::~InterruptWatch() {
    waiter_.request_stop();
    pthread_kill(waiter_.native_handle(), SIGINT);
}

std::string harmless(std::string_view text, bool keepLines) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
        const bool isControl = (byte < 0x20 && byte != '\t' && !(keepLines && byte == '\n')) || byte == 0x7F;
        // U+0080 to U+009F mean to some terminals what Escape and a letter do.
        const bool isLongControl = byte == 0xC2 && next >= 0x80 && next < 0xA0;
        shown += isControl || isLongControl ? '?' : text[i];
        i += isLongControl ? 1 : 0;
    }
    return shown;
}

void sayLines(std::string_view lines) {
    std::print("{}", harmless(lines, true));
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
            .progress = inSteps(100, [](int percent) { std::println(stderr, "progress {} %", percent); }),
            .threads = threads};
}

void clearProgress(bool quiet) {
    if (showsProgress(quiet)) {
        std::print(stderr, "\r\033[K");
    }
}

}  // namespace furrow::cli
