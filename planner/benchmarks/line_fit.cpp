#include "planner/benchmarks/line_fit.h"

namespace furrow {

LineFit fitLine(std::span<const Point> points) {
    const auto count = static_cast<double>(points.size());
    Point mean;
    for (const Point& point : points) {
        mean = mean + (1.0 / count) * point;
    }
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const Point& point : points) {
        const Point off = point - mean;
        xx += off.x * off.x;
        xy += off.x * off.y;
        yy += off.y * off.y;
    }
    LineFit fit;
    fit.slope = xx > 0.0 ? xy / xx : 0.0;
    fit.offset = mean.y - fit.slope * mean.x;
    fit.r2 = yy > 0.0 ? fit.slope * xy / yy : 1.0;
    return fit;
}

}  // namespace furrow
