#pragma once

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/polygon.h"

#include <vector>

namespace furrow {

/// The place of something beside a line, in metres: along the line from its start, and to its left (negative
/// to the right).
struct Extent {
    double fromM = 0.0;
    double toM = 0.0;
    double rightM = 0.0;
    double leftM = 0.0;

    void add(const Extent& other);
    friend bool operator==(const Extent&, const Extent&) = default;
};

/// Places beside a line of straights and arcs. The line is extended straight at both ends. Immutable.
class LineFrame {
public:
    explicit LineFrame(const Curve& line);

    /// The extent of a ring's corners. Cost: O(corners * chords of the line).
    Extent of(const Ring& ring) const;

private:
    Extent of(Point point) const;

    std::vector<CurveSample> samples_;
};

}  // namespace furrow
