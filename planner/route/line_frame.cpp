#include "planner/route/line_frame.h"

#include "planner/geometry/segment.h"

#include <algorithm>
#include <limits>

namespace furrow {

namespace {

constexpr Length kChord = metres(0.005);

}  // namespace

void Extent::add(const Extent& other) {
    fromM = std::min(fromM, other.fromM);
    toM = std::max(toM, other.toM);
    rightM = std::min(rightM, other.rightM);
    leftM = std::max(leftM, other.leftM);
}

LineFrame::LineFrame(const Curve& line) : samples_{sampled(line, kChord)} {}

Extent LineFrame::of(const Ring& ring) const {
    Extent extent = of(ring.front());
    for (const Point& point : ring) {
        extent.add(of(point));
    }
    return extent;
}

Extent LineFrame::of(Point point) const {
    std::size_t nearest = 0;
    double nearestM = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < samples_.size(); ++i) {
        const double awayM =
            distanceToSegment(point, samples_[i].pose.position, samples_[i + 1].pose.position);
        if (awayM < nearestM && samples_[i + 1].way > samples_[i].way) {
            nearest = i;
            nearestM = awayM;
        }
    }
    const Point from = samples_[nearest].pose.position;
    const Point chord = samples_[nearest + 1].pose.position - from;
    const double lengthM = norm(chord);
    const Point ahead = (1.0 / lengthM) * chord;
    double alongM = dot(ahead, point - from);
    if (nearest > 0) {
        alongM = std::max(alongM, 0.0);
    }
    if (nearest + 2 < samples_.size()) {
        alongM = std::min(alongM, lengthM);
    }
    const double stationM = samples_[nearest].way.si() + alongM;
    const double leftM = cross(ahead, point - from);
    return {stationM, stationM, leftM, leftM};
}

}  // namespace furrow
