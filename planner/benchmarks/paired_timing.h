#pragma once

#include "planner/units/quantity.h"

#include <functional>
#include <optional>

namespace furrow {

/// The time of one run of a piece of work.
struct Timing {
    Duration least;
    Duration median;
    int runs = 0;
};

struct PairedTiming {
    Timing ours;
    std::optional<Timing> yardstick;
    /// The median of the yardstick's time over ours, turn by turn. A machine that slows down for a while
    /// slows both.
    std::optional<double> ratio;
};

/// Reads seconds.
using ClockReading = std::function<double()>;

/// The processor time of this process, of all its threads.
double processorSeconds();
double wallSeconds();

/// Runs both in turn, at least seven times. Each turn repeats its work until it takes 20 ms.
/// @param yardstick  empty: only ours
PairedTiming timedInTurn(const std::function<void()>& ours, const std::function<void()>& yardstick,
                         const ClockReading& clock);

}  // namespace furrow
