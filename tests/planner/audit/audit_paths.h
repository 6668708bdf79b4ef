#pragma once

#include "planner/audit/audit.h"
#include "planner/machine/machine_library.h"
#include "tests/support/field_generator.h"

#include <cmath>
#include <vector>

namespace furrow::test {

/// A mounted machine whose implement works right under the reference point.
inline Machine plainMachine(double widthM, double radiusM = 2.0) {
    MachineSpec spec;
    spec.tractor.width = metres(std::min(widthM, 2.0));
    spec.tractor.length = metres(2.0);
    spec.tractor.rearOverhang = metres(1.0);
    spec.tractor.minTurningRadius = metres(radiusM);
    spec.implement.operatingWidth = metres(widthM);
    spec.implement.offset = metres(0.0);
    spec.implement.length = metres(1.0);
    return Machine::create(spec).value();
}

/// Draws paths by hand: straight lines and arcs, position, way and time running on.
class PathDrawer {
public:
    explicit PathDrawer(Point position, double headingRad = 0.0) {
        at_.position = position;
        at_.headingRad = headingRad;
        at_.speedMps = 1.0;
    }

    PathDrawer& begin(SegmentKind kind, bool down, int number = 0, Gear gear = Gear::Forward) {
        PathSegment segment{
            .kind = kind, .turnType = {}, .number = number, .gear = gear, .implementDown = down};
        at_.curvature1pm = 0.0;
        segment.samples.push_back(at_);
        segments.push_back(segment);
        return *this;
    }
    PathDrawer& straight(double way) { return drive(way, 0.0, 0.0, 1); }
    PathDrawer& arc(double way, double curvature, int steps = 40) {
        return drive(way, curvature, curvature, steps);
    }
    /// Curvature changes evenly, sampled finely by the midpoint rule.
    PathDrawer& clothoid(double way, double from, double to, int steps = 40) {
        return drive(way, from, to, steps);
    }
    PathDrawer& jumpTo(Point position, double headingRad) {
        at_.position = position;
        at_.headingRad = headingRad;
        return *this;
    }

    std::vector<PathSegment> segments;

private:
    PathDrawer& drive(double way, double from, double to, int steps) {
        PathSegment& segment = segments.back();
        const double sign = segment.gear == Gear::Reverse ? -1.0 : 1.0;
        segment.samples.back().curvature1pm = from;
        const double step = way / steps;
        for (int i = 0; i < steps; ++i) {
            constexpr int kFine = 2000;
            // Simpson's rule over the exact heading.
            const auto curvature = [&](double s) { return from + (to - from) * (i * step + s) / way; };
            const auto heading = [&](double s) {
                return at_.headingRad + sign * s * 0.5 * (curvature(0.0) + curvature(s));
            };
            Point sum;
            const double h = step / kFine;
            for (int k = 0; k <= kFine && way > 0.0; ++k) {
                const double weight = k == 0 || k == kFine ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0);
                sum = sum + weight * direction(heading(k * h));
            }
            const double next = heading(step);
            at_.position = at_.position + (sign * h / 3.0) * sum;
            at_.headingRad = next;
            at_.sM += step;
            at_.tS += step;
            at_.curvature1pm = curvature(step);
            segment.samples.push_back(at_);
        }
        return *this;
    }

    PathSample at_;
};

}  // namespace furrow::test
