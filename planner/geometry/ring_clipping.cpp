#include "planner/geometry/ring_clipping.h"

#include <cstddef>

namespace furrow {

/// The part of a ring on the left of a line: the ring itself, if all of it is.
const Ring* RingClipping::leftOf(const Ring& ring, Point on, Point along, Ring& kept) {
    left_.clear();
    bool isWhole = true;
    for (const Point& point : ring) {
        left_.push_back(cross(along, point - on));
        isWhole = isWhole && left_.back() >= 0.0;
    }
    if (isWhole) {
        return &ring;
    }
    kept.clear();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t next = i + 1 < ring.size() ? i + 1 : 0;
        if (left_[i] >= 0.0) {
            kept.push_back(ring[i]);
        }
        if ((left_[i] >= 0.0) != (left_[next] >= 0.0)) {
            kept.push_back(ring[i] + (left_[i] / (left_[i] - left_[next])) * (ring[next] - ring[i]));
        }
    }
    return &kept;
}

const Ring& RingClipping::clipped(const Ring& ring, const Ring& convex) {
    const Ring* inside = &ring;
    for (std::size_t i = 0; i < convex.size() && !inside->empty(); ++i) {
        inside = leftOf(*inside, convex[i], convex[i + 1 < convex.size() ? i + 1 : 0] - convex[i],
                        inside == &first_ ? second_ : first_);
    }
    if (inside->size() < 3) {
        first_.clear();
        return first_;
    }
    return *inside;
}

}  // namespace furrow
