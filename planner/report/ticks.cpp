#include "planner/report/ticks.h"

#include <algorithm>
#include <cmath>
#include <format>

namespace furrow {

namespace {

/// "12 345" with narrow no-break spaces; four digits stay together.
std::string withThousandsApart(std::string digits) {
    const std::size_t begin = digits.starts_with('-') ? 1 : 0;
    const std::size_t end = std::min(digits.find('.'), digits.size());
    if (end - begin < 5) {
        return digits;
    }
    for (std::size_t at = end - 3; at > begin; at = at > begin + 3 ? at - 3 : begin) {
        digits.insert(at, "\u202f");
    }
    return digits;
}

}  // namespace

double roundedDown(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double share = value / power * (1.0 + 1e-12);
    return power * (share >= 5.0 ? 5.0 : share >= 2.0 ? 2.0 : 1.0);
}

std::string tickLabel(double value, double step) {
    if (value == 0.0) {
        return "0";
    }
    const int decimals = static_cast<int>(std::clamp(std::ceil(-std::log10(step) - 1e-9), 0.0, 9.0));
    const std::string text = std::abs(value) >= 1e9 || std::abs(value) < 1e-6
                                 ? std::format("{:.3g}", value)
                                 : withThousandsApart(std::format("{:.{}f}", value, decimals));
    return text.starts_with('-') ? "\u2212" + text.substr(1) : text;
}

Ticks linearTicks(double min, double max, int count) {
    if (!(max > min)) {
        const double room = min == 0.0 ? 1.0 : 0.1 * std::abs(min);
        min -= room;
        max += room;
    }
    const double wanted = (max - min) / std::max(1, count);
    // The next round number above, so that there are not more than asked for.
    double step = roundedDown(wanted);
    if (step < wanted * (1.0 - 1e-9)) {
        const double lead = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
        step *= lead > 1.5 && lead < 3.0 ? 2.5 : 2.0;
    }
    Ticks ticks;
    const double first = std::floor(min / step + 1e-9);
    const double last = std::ceil(max / step - 1e-9);
    ticks.min = first * step;
    ticks.max = last * step;
    for (double i = first; i <= last; i += 1.0) {
        ticks.values.push_back(i * step);
        ticks.labels.push_back(tickLabel(i * step, step));
    }
    return ticks;
}

Ticks steppedTicks(double min, double max, double step) {
    Ticks ticks;
    ticks.min = min;
    ticks.max = max;
    for (double i = std::ceil(min / step - 1e-9); i <= max / step + 1e-9 && ticks.values.size() < 100;
         i += 1.0) {
        ticks.values.push_back(i * step);
        ticks.labels.push_back(tickLabel(i * step, step));
    }
    return ticks;
}

Ticks logTicks(double min, double max) {
    Ticks ticks;
    constexpr double kRoom = 1.15;
    ticks.min = min / kRoom;
    ticks.max = max * kRoom;
    const bool fine = std::log10(ticks.max / ticks.min) < 2.0;
    for (double power = std::floor(std::log10(ticks.min)); power <= std::ceil(std::log10(ticks.max));
         power += 1.0) {
        for (const double lead : {1.0, 2.0, 5.0}) {
            const double value = lead * std::pow(10.0, power);
            if ((lead == 1.0 || fine) && value >= ticks.min && value <= ticks.max) {
                ticks.values.push_back(value);
                ticks.labels.push_back(tickLabel(value, value));
            }
        }
    }
    return ticks;
}

}  // namespace furrow
