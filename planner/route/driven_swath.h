#pragma once

#include "planner/geometry/point.h"

namespace furrow {

/// A swath as it is driven, in metres.
struct DrivenSwath {
    Point from;
    Point middle;
    Point to;

    friend bool operator==(const DrivenSwath&, const DrivenSwath&) = default;
};

}  // namespace furrow
