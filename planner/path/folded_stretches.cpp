#include "planner/path/folded_stretches.h"

namespace furrow {

bool foldsNarrower(const Machine& machine) {
    return machine.transportWidth() < machine.turningWidth();
}

bool isDrivenFolded(std::span<const PathSegment> segments, std::size_t segment) {
    return segments[segment].folded || isWayInOrOut(segments, segment);
}

std::vector<FoldedStretch> foldedStretches(std::span<const PathSegment> segments) {
    std::vector<FoldedStretch> stretches;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (!segments[i].folded) {
            continue;
        }
        if (i > 0 && segments[i - 1].folded) {
            stretches.back().last = i;
        } else {
            stretches.push_back({i, i});
        }
    }
    return stretches;
}

Duration foldingTime(std::span<const PathSegment> segments, const Machine& machine) {
    return 2.0 * static_cast<double>(foldedStretches(segments).size()) * machine.spec().implement.timeToFold;
}

}  // namespace furrow
