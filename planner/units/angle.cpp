#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

constexpr double kPi = std::numbers::pi;

double wrapped(double value, double period) {
    // Most values are there already, and the quotient of no more than one period is a subtraction without
    // rounding (Sterbenz). Only others need fmod, which takes ten times as long.
    if (value >= 0.0 && value < period) {
        return value;
    }
    double rest = std::abs(value) < period                  ? value
                  : value >= period && value < 2.0 * period ? value - period
                                                            : std::fmod(value, period);
    if (rest < 0.0) {
        rest += period;
    }
    // A tiny negative rest plus the period rounds to the period itself.
    return rest >= period ? 0.0 : rest;
}

}  // namespace

Angle normalisedPoseHeading(Angle heading) {
    return radians(wrapped(heading.si(), 2.0 * kPi));
}

Angle normalisedSwathHeading(Angle heading) {
    return radians(wrapped(heading.si(), kPi));
}

Angle headingDifference(Angle from, Angle to) {
    const double turn = wrapped(to.si() - from.si(), 2.0 * kPi);
    return radians(turn > kPi ? turn - 2.0 * kPi : turn);
}

Angle wrappedAngle(Angle angle) {
    return std::abs(angle.si()) <= kPi ? angle : radians(std::remainder(angle.si(), 2.0 * kPi));
}

Angle angleBetweenLines(Angle a, Angle b) {
    const double apart = wrapped(a.si() - b.si(), kPi);
    return radians(std::min(apart, kPi - apart));
}

double lineBearingDeg(Angle swathHeading) {
    return wrapped(90.0 - inDegrees(swathHeading), 180.0);
}

double bearingDeg(Angle heading) {
    return wrapped(90.0 - inDegrees(heading), 360.0);
}

}  // namespace furrow
