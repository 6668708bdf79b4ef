#include "planner/benchmarks/paired_timing.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace furrow {

namespace {

constexpr int kTurns = 7;
constexpr double kTurnS = 0.02;

struct Turn {
    double eachS = 0.0;
    int runs = 0;
};

Turn timed(const std::function<void()>& work, const ClockReading& clock) {
    const double begin = clock();
    double goneS = 0.0;
    int runs = 0;
    do {
        work();
        ++runs;
        goneS = clock() - begin;
    } while (goneS < kTurnS);
    return {goneS / runs, runs};
}

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

Timing timingOf(const std::vector<Turn>& turns) {
    std::vector<double> times;
    Timing timing;
    for (const Turn& turn : turns) {
        times.push_back(turn.eachS);
        timing.runs += turn.runs;
    }
    timing.least = seconds(std::ranges::min(times));
    timing.median = seconds(medianOf(std::move(times)));
    return timing;
}

}  // namespace

double processorSeconds() {
    std::timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double wallSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

PairedTiming timedInTurn(const std::function<void()>& ours, const std::function<void()>& yardstick,
                         const ClockReading& clock) {
    std::vector<Turn> oursTook;
    std::vector<Turn> yardstickTook;
    std::vector<double> ratios;
    for (int i = 0; i < kTurns; ++i) {
        oursTook.push_back(timed(ours, clock));
        if (yardstick) {
            yardstickTook.push_back(timed(yardstick, clock));
            ratios.push_back(yardstickTook.back().eachS / oursTook.back().eachS);
        }
    }
    PairedTiming timing{.ours = timingOf(oursTook), .yardstick = {}, .ratio = {}};
    if (yardstick) {
        timing.yardstick = timingOf(yardstickTook);
        timing.ratio = medianOf(std::move(ratios));
    }
    return timing;
}

}  // namespace furrow
