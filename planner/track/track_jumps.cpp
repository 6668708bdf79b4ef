#include "planner/track/track_jumps.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace furrow {

namespace {

constexpr std::size_t kLongestJump = 10;
constexpr std::size_t kFewestToJudge = 20;
constexpr double kLeastJumpM = 2.0;
constexpr double kStepsOfJump = 3.0;
constexpr double kLeastBreakM = 25.0;
constexpr double kStepsOfBreak = 10.0;
// Of the way in long steps: with more of it they are no exception.
constexpr double kSparseShare = 0.3;
constexpr double kPausedShare = 0.1;
// One in so many positions left out: more than receivers usually lose.
constexpr std::size_t kDoubtfulShare = 20;
// 144 km/h.
constexpr double kFastestMps = 40.0;

/// Half of the steps are shorter; 0 for a track that stands still.
double usualStepM(std::vector<double> steps) {
    std::erase_if(steps, [](double step) { return step < 1e-3; });
    if (steps.empty()) {
        return 0.0;
    }
    const auto at = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
    std::ranges::nth_element(steps, at);
    return *at;
}

/// The share of the way that lies in steps over `limitM`.
double shareOfLongSteps(const std::vector<double>& steps, double limitM) {
    double all = 0.0;
    double inLong = 0.0;
    for (const double step : steps) {
        all += step;
        inLong += step > limitM ? step : 0.0;
    }
    return all > 0.0 ? inLong / all : 0.0;
}

/// Whether most of the long steps took less time than any machine needs for them.
bool isFasterThanAnyMachine(const std::vector<double>& steps, const std::vector<std::optional<double>>& times,
                            double limitM) {
    std::size_t longSteps = 0;
    std::size_t fast = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps[i] > limitM) {
            ++longSteps;
            const bool timed = times[i] && times[i + 1] && *times[i + 1] > *times[i];
            fast += timed && steps[i] / (*times[i + 1] - *times[i]) > kFastestMps ? 1 : 0;
        }
    }
    return 2 * fast > longSteps;
}

}  // namespace

SteadyTrack withoutJumps(const Polyline& places, const std::vector<std::optional<double>>& times) {
    std::vector<double> steps;
    for (std::size_t i = 1; i < places.size(); ++i) {
        steps.push_back(distance(places[i - 1], places[i]));
    }
    const double usual = usualStepM(steps);
    const double farM = std::max(kLeastJumpM, kStepsOfJump * usual);
    const double breakM = std::max(kLeastBreakM, kStepsOfBreak * usual);
    SteadyTrack steady;
    const bool judged = places.size() >= kFewestToJudge;
    // A receiver that jumps to and fro makes a long way of it: counted are the steps that lead on.
    std::vector<double> on = steps;
    const auto leavesOut = [&](std::size_t from, std::size_t to) {
        steady.firstJump = steady.firstJump ? steady.firstJump : from;
        steady.jumps += to - from;
    };
    std::size_t i = 0;
    // The first positions of a receiver that does not know yet where it is.
    for (std::size_t k = 1; judged && k <= 3 && k < places.size(); ++k) {
        if (steps[k - 1] > breakM) {
            leavesOut(i, k);
            std::fill(on.begin(), on.begin() + static_cast<std::ptrdiff_t>(k), 0.0);
            i = k;
        }
    }
    if (!places.empty()) {
        steady.kept.push_back(i);
        ++i;
    }
    while (i < places.size()) {
        const Point last = places[steady.kept.back()];
        const double in = distance(last, places[i]);
        std::size_t back = i;
        for (std::size_t k = i + 1; judged && in > farM && k < places.size() && k <= i + kLongestJump; ++k) {
            const double out = distance(places[k - 1], places[k]);
            const bool isNear = distance(last, places[k]) < 0.5 * std::min(in, out);
            if (out > farM && isNear) {
                back = k;
                break;
            }
        }
        if (back == i && judged && in > breakM && places.size() - i <= 3) {
            back = places.size();
        }
        if (back > i) {
            leavesOut(i, back);
            const std::size_t end = std::min(back, on.size());
            std::fill(on.begin() + static_cast<std::ptrdiff_t>(i - 1),
                      on.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
        }
        i = back;
        if (i < places.size()) {
            steady.kept.push_back(i);
            ++i;
        }
    }
    // Where turns are recorded point by point and swaths by their ends only, every turn looks like a jump.
    const bool doubtful =
        steady.jumps * kDoubtfulShare > places.size() && !isFasterThanAnyMachine(steps, times, farM);
    if (doubtful && shareOfLongSteps(steps, farM) > kSparseShare) {
        steady = {};
        steady.kept.resize(places.size());
        std::iota(steady.kept.begin(), steady.kept.end(), std::size_t{0});
        on = steps;
    }
    steady.longestStepM =
        shareOfLongSteps(on, breakM) > kPausedShare ? std::numeric_limits<double>::infinity() : breakM;
    return steady;
}

}  // namespace furrow
