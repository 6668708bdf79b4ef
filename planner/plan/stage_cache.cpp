#include "planner/plan/stage_cache.h"

#include <tuple>

namespace furrow {

namespace {

auto workOf(const SwathSet& set) {
    return std::tie(set.swaths, set.heading, set.shift, set.restRight, set.restLeft, set.leftOnPurpose,
                    set.goneRound);
}

}  // namespace

bool isSameHeadland(const Headland& a, const Headland& b) {
    const auto driven = [](const Headland& headland) {
        return std::tie(headland.width, headland.passes, headland.strips, headland.mainland,
                        headland.drivenPasses, headland.uncutStrip, headland.uncutCorners, headland.narrowed,
                        headland.isPerimeterOnly);
    };
    return &a == &b || driven(a) == driven(b);
}

bool isSameSwaths(const LaidSwaths& a, const LaidSwaths& b) {
    return &a == &b ||
           (workOf(a.swaths) == workOf(b.swaths) && workOf(a.forCells()) == workOf(b.forCells()) &&
            a.parts == b.parts && a.mainland == b.mainland);
}

}  // namespace furrow
