#pragma once

#include "planner/geometry/point.h"

#include <span>

namespace furrow {

/// y = offset + slope x, by least squares.
struct LineFit {
    double offset = 0.0;
    double slope = 0.0;
    double r2 = 0.0;  ///< share of the variance of y that the line explains; 1 if y does not vary
};

/// @param points  at least two, with different x
LineFit fitLine(std::span<const Point> points);

}  // namespace furrow
