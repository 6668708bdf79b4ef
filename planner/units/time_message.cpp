#include "planner/units/time_message.h"

#include <cmath>

namespace furrow {

namespace {

constexpr double kMinuteS = 60.0;
// Shorter times are told in seconds, longer ones in hours.
constexpr double kSecondsUpToS = 90.0;
constexpr double kMinutesUpToS = 90.0 * kMinuteS;

}  // namespace

Message timeMessage(Duration time) {
    const double s = std::abs(time.si());
    if (s < kSecondsUpToS) {
        return message("{:.0f} s", s);
    }
    if (s < kMinutesUpToS) {
        return message("{:.0f} min", s / kMinuteS);
    }
    const auto minutes = static_cast<int>(std::lround(s / kMinuteS));
    return message("{} h {} min", minutes / 60, minutes % 60);
}

}  // namespace furrow
