#pragma once

#include "ui/map/plan_drawing.h"
#include "ui/map/plan_view.h"

#include <vector>

namespace furrow {

/// A finding as it is marked on the screen, with those that have no room beside it.
struct FindingMark {
    int finding = 0;  ///< the first of them
    int more = 0;     ///< others behind the same mark
    QPointF middle;   ///< pixels of the item
};

/// The marks in view, in the order of their findings. The selected finding stands for those
/// around it. One that
/// lies on the start or the end of the path stands above it: both are seen. What is just so is marked only
/// while it is selected. Cost: O(findings x marks).
std::vector<FindingMark> findingMarks(const PlanGeometry& geometry, const PlanView& view, int selected);

/// The finding whose mark is at this place of the item, or -1.
int findingAt(const std::vector<FindingMark>& marks, QPointF pixel);

}  // namespace furrow
