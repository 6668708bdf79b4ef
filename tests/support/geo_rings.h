#pragma once

#include "planner/field/field.h"

#include <algorithm>
#include <cmath>

namespace furrow::test {

inline double metresBetween(GeoPoint a, GeoPoint b) {
    constexpr double kMetresPerDegree = 111'195.0;
    return kMetresPerDegree *
           std::hypot(std::remainder(a.lonDeg - b.lonDeg, 360.0) * std::cos(a.latDeg * M_PI / 180.0),
                      a.latDeg - b.latDeg);
}

/// The same corners one after the other, wherever the ring begins and whichever way it runs.
inline bool sameRing(GeoRing actual, const GeoRing& expected, double toleranceM) {
    if (actual.size() != expected.size()) {
        return false;
    }
    const auto begin = std::min_element(actual.begin(), actual.end(), [&](GeoPoint a, GeoPoint b) {
        return metresBetween(a, expected[0]) < metresBetween(b, expected[0]);
    });
    std::rotate(actual.begin(), begin, actual.end());
    const auto equal = [&] {
        return std::equal(actual.begin(), actual.end(), expected.begin(),
                          [toleranceM](GeoPoint a, GeoPoint b) { return metresBetween(a, b) <= toleranceM; });
    };
    if (equal()) {
        return true;
    }
    std::reverse(actual.begin() + 1, actual.end());
    return equal();
}

inline bool samePolygon(const GeoPolygon& actual, const GeoPolygon& expected, double toleranceM) {
    return sameRing(actual.outer, expected.outer, toleranceM) &&
           actual.holes.size() == expected.holes.size() &&
           std::all_of(expected.holes.begin(), expected.holes.end(), [&](const GeoRing& hole) {
               return std::any_of(actual.holes.begin(), actual.holes.end(),
                                  [&](const GeoRing& other) { return sameRing(other, hole, toleranceM); });
           });
}

}  // namespace furrow::test
