#pragma once

#include "planner/geometry/polygon.h"
#include "planner/headland/full_lock_bend.h"

#include <vector>

namespace furrow {

/// What an implement sweeps between its working lines. While both of its ends go ahead, one polygon; the
/// overlay of some hundred triangles would take longer than all else.
class SweptLand {
public:
    explicit SweptLand(const WorkingLine& first) : run_{first} {}

    void to(const WorkingLine& line);

    /// Counter-clockwise, without holes. They may overlap. Once, at the end.
    MultiPolygon polygons();

private:
    void addTriangle(Ring ring);
    void endRun();

    std::vector<WorkingLine> run_;
    MultiPolygon polygons_;
};

}  // namespace furrow
