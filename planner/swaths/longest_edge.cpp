#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"

#include <cmath>

namespace furrow {

namespace {

/// The heading of the longest edge; of equally long ones the first.
Angle longestEdgeHeading(const MultiPolygon& mainland) {
    double longestM = -1.0;
    Point edge;
    forEachEdge(mainland, [&](Point from, Point to) {
        if (const double lengthM = distance(from, to); lengthM > longestM) {
            longestM = lengthM;
            edge = to - from;
        }
    });
    return radians(std::atan2(edge.y, edge.x));
}

Result<SwathSet> longestEdge(const MultiPolygon& mainland, const Machine& machine, const Settings& settings,
                             const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    return scanLineFor(mainland, machine, settings).and_then([&](const ScanLine& scanLine) {
        return swathsAlong(scanLine, longestEdgeHeading(mainland), SwathObjective::Coverage);
    });
}

}  // namespace

const Method<SwathGenerator> kLongestEdgeMethod{
    .info = {.id = "longest-edge",
             .name = "Along the longest edge",
             .description = "All swaths along the longest straight edge of the mainland.",
             .parameters = {}},
    .run = longestEdge};

}  // namespace furrow
