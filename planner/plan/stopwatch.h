#pragma once

#include "planner/units/quantity.h"

#include <chrono>
#include <utility>

namespace furrow {

/// Wall time since it was made, or since the last lap.
class Stopwatch {
public:
    Duration lap() {
        const Clock::time_point now = Clock::now();
        return seconds(std::chrono::duration<double>(now - std::exchange(begin_, now)).count());
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin_ = Clock::now();
};

}  // namespace furrow
