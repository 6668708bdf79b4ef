#include "ui/map/finding_marks.h"

#include <QLineF>

#include <algorithm>
#include <array>

namespace furrow {

namespace {

/// Marks are at least this far apart.
constexpr double kRoomPx = 22.0;
constexpr double kReachPx = 14.0;

/// Above the start and the end of the path, where it would hide them.
QPointF clearOfEnds(QPointF pixel, const PlanGeometry& geometry, const PlanView& view) {
    for (const auto& end : std::array{geometry.start, geometry.end}) {
        if (end && QLineF{view.toItem(*end), pixel}.length() < kRoomPx) {
            return view.toItem(*end) - QPointF{0.0, kRoomPx + 1.0};
        }
    }
    return pixel;
}

}  // namespace

std::vector<FindingMark> findingMarks(const PlanGeometry& geometry, const PlanView& view, int selected) {
    std::vector<FindingMark> marks;
    const auto add = [&](int i) {
        const FindingPlace& finding = geometry.findings[static_cast<std::size_t>(i)];
        if (!view.shows(finding.place) || (finding.weight == Weight::Information && i != selected)) {
            return;
        }
        const QPointF pixel = clearOfEnds(view.toItem(finding.place), geometry, view);
        const auto crowded = std::ranges::find_if(
            marks, [&](const FindingMark& mark) { return QLineF{mark.middle, pixel}.length() < kRoomPx; });
        if (crowded == marks.end()) {
            marks.push_back({.finding = i, .more = 0, .middle = pixel});
        } else {
            ++crowded->more;
        }
    };
    const int count = static_cast<int>(geometry.findings.size());
    if (selected >= 0 && selected < count) {
        add(selected);
    }
    for (int i = 0; i < count; ++i) {
        if (i != selected) {
            add(i);
        }
    }
    std::ranges::sort(marks, {}, &FindingMark::finding);
    return marks;
}

int findingAt(const std::vector<FindingMark>& marks, QPointF pixel) {
    const auto hit = std::ranges::find_if(
        marks, [&](const FindingMark& mark) { return QLineF{mark.middle, pixel}.length() <= kReachPx; });
    return hit == marks.end() ? -1 : hit->finding;
}

}  // namespace furrow
