#include "planner/swaths/edge_preference.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"

#include <cmath>
#include <optional>

namespace furrow {

namespace {

Result<SwathSet> longestEdge(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    return scanLineFor(task).and_then([&](const ScanLine& scanLine) {
        return swathsAlong(scanLine, task, longestEdgeHeading(task), SwathObjective::Coverage, job);
    });
}

/// The heading of an edge, counted along every ring of the boundary, in the field's order.
Result<Angle> edgeHeading(const Field& field, int number) {
    int count = 0;
    std::optional<Point> edge;
    forEachEdge(field.boundary(), [&](Point from, Point to) {
        if (count++ == number) {
            edge = to - from;
        }
    });
    if (!edge) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = message("there is no edge {}", number),
                                     .where = std::string{kEdge.key},
                                     .remedy = message("give a number from 0 to {}", count - 1)});
    }
    return radians(std::atan2(edge->y, edge->x));
}

Result<SwathSet> edge(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    const auto heading = edgeHeading(task.field, *task.settings.count(kEdge));
    if (!heading) {
        return std::unexpected(heading.error());
    }
    return scanLineFor(task).and_then([&](const ScanLine& scanLine) {
        return swathsAlong(scanLine, task, *heading, SwathObjective::Coverage, job);
    });
}

constexpr const Parameter* kEdgeParameters[] = {&kEdge};

}  // namespace

const Parameter kEdge{
    .key = "swaths.edge",
    .name = "Edge",
    .description =
        "Number of the boundary's edge, from 0 in the order of its points; for curves with all around it up to a corner of "
        "35 degrees within a width, or a bend of 90 in all.",
    .kind = ParameterKind::Count,
    .standard = 0.0,
    .min = 0.0,
    .max = 1e6,
    .choices = {}};

const Method<SwathGenerator> kEdgeMethod{
    .info = {.id = "edge",
             .name = "Along an edge",
             .description = "All swaths along the edge of the boundary that you pick.",
             .parameters = kEdgeParameters},
    .run = edge};

const Method<SwathGenerator> kLongestEdgeMethod{
    .info = {.id = "longest-edge",
             .name = "Along the longest edge",
             .description = "All swaths along the longest straight edge inside the headland.",
             .parameters = {}},
    .run = longestEdge};

}  // namespace furrow
