#pragma once

#include <string>
#include <vector>

namespace furrow {

/// The marks of an axis: round numbers, and the range that holds all values between two of them.
struct Ticks {
    double min = 0.0;
    double max = 1.0;
    std::vector<double> values;       ///< ascending, within the range
    std::vector<std::string> labels;  ///< as many
};

/// Multiples of 1, 2 or 5 times a power of ten, about `count` of them.
/// @param min, max  finite, min <= max; equal ones are given some room
Ticks linearTicks(double min, double max, int count);

/// Multiples of a step, for a range that stays as it is.
/// @param step  > 0, at most 100 of them in the range
Ticks steppedTicks(double min, double max, double step);

/// Powers of ten, over less than two of them 2 and 5 as well. The range is the values', with some room.
/// @param min, max  finite, 0 < min <= max
Ticks logTicks(double min, double max);

/// 1, 2 or 5 times a power of ten, the largest that is not above `value` (> 0).
double roundedDown(double value);

/// A number as people read it: thousands apart, no more decimals than `step` needs.
std::string tickLabel(double value, double step);

}  // namespace furrow
