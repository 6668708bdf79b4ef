#include "planner/geometry/strip_area.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

/// The mean of x from a to b, with what is beyond ± `most` cut off there.
double meanCutOff(double a, double b, double most) {
    if (std::abs(a) <= most && std::abs(b) <= most) {
        return 0.5 * (a + b);
    }
    if (std::min(a, b) >= most) {
        return most;
    }
    if (std::max(a, b) <= -most) {
        return -most;
    }
    const auto integral = [most](double x) {
        return std::abs(x) <= most ? 0.5 * x * x : most * (std::abs(x) - 0.5 * most);
    };
    return (integral(b) - integral(a)) / (b - a);
}

double signedAreaInM2(const Ring& ring, const Strip& strip) {
    double sumM2 = 0.0;
    const auto inStrip = [&strip](Point point) {
        return Point{dot(strip.along, point - strip.from), cross(strip.along, point - strip.from)};
    };
    Point last = inStrip(ring.back());
    for (const Point& point : ring) {
        const Point here = inStrip(point);
        const double from = std::clamp(last.x, 0.0, strip.lengthM);
        const double to = std::clamp(here.x, 0.0, strip.lengthM);
        if (from != to) {
            const double slope = (here.y - last.y) / (here.x - last.x);
            sumM2 -= (to - from) * meanCutOff(last.y + slope * (from - last.x),
                                              last.y + slope * (to - last.x), strip.halfWidthM);
        }
        last = here;
    }
    return sumM2;
}

}  // namespace

double areaInM2(const Polygon& polygon, const Strip& strip) {
    double sumM2 = signedAreaInM2(polygon.outer, strip);
    for (const Ring& hole : polygon.holes) {
        sumM2 += signedAreaInM2(hole, strip);
    }
    return sumM2;
}

}  // namespace furrow
