#include "planner/geometry/box_tree.h"
#include "planner/swaths/curved_swaths.h"
#include "planner/swaths/guide_curve.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/left_on_purpose.h"
#include "planner/swaths/methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

namespace furrow {

namespace {

// A run of edges ends at a corner of more than this within one operating width,
constexpr double kCornerRad = 35.0 * std::numbers::pi / 180.0;
// or when it has turned by more than this from the picked edge. A line that comes back beside itself is no
// guide.
constexpr double kWholeBendRad = 90.0 * std::numbers::pi / 180.0;

// Tracks beside a line that is farther away would be drawn for longer than anybody waits.
constexpr double kFarthestM = 10'000.0;

/// The ring that holds edge `number`, counted along every ring of the boundary, and the edge's index in it.
struct PickedEdge {
    Ring ring;
    std::size_t index = 0;
};

Result<PickedEdge> pickedEdge(const Field& field, int number) {
    std::size_t left = static_cast<std::size_t>(number);
    std::size_t count = 0;
    std::optional<PickedEdge> found;
    const auto visit = [&](const Ring& ring) {
        if (!found && left < ring.size()) {
            found = PickedEdge{ring, left};
        }
        left -= std::min(left, ring.size());
        count += ring.size();
    };
    for (const Polygon& polygon : field.boundary()) {
        visit(polygon.outer);
        std::ranges::for_each(polygon.holes, visit);
    }
    if (!found) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = message("there is no edge {}", number),
                                     .where = std::string{kEdge.key},
                                     .remedy = message("give a number from 0 to {}", count - 1)});
    }
    return std::move(*found);
}

/// The run from the picked edge, in one direction round the ring, until a corner.
Polyline runFrom(const Ring& ring, std::size_t first, bool onwards, double widthM) {
    const std::size_t size = ring.size();
    const auto vertex = [&](std::size_t step) {
        return ring[onwards ? (first + 1 + step) % size : (first + 2 * size - step) % size];
    };
    const Point start = onwards ? ring[first] : ring[(first + 1) % size];
    const auto turnAt = [&](std::size_t step) {
        const Point in = vertex(step) - (step == 0 ? start : vertex(step - 1));
        const Point out = vertex(step + 1) - vertex(step);
        return std::atan2(cross(in, out), dot(in, out));
    };
    Polyline run;
    double wholeRad = 0.0;
    for (std::size_t step = 0; step < size; ++step) {
        run.push_back(vertex(step));
        double cornerRad = 0.0;
        double wayM = 0.0;
        for (std::size_t k = step; k < step + size && wayM <= widthM; ++k) {
            cornerRad += turnAt(k);
            wayM += distance(vertex(k), vertex(k + 1));
            if (std::abs(cornerRad) > kCornerRad) {
                return run;
            }
        }
        wholeRad += turnAt(step);
        if (std::abs(wholeRad) > kWholeBendRad) {
            return run;
        }
    }
    return run;
}

Result<Polyline> edgeRun(const SwathTask& task) {
    const auto edge = pickedEdge(task.field, *task.settings.count(kEdge));
    if (!edge) {
        return std::unexpected(edge.error());
    }
    const double widthM = task.machine.operatingWidth().si();
    Polyline run = runFrom(edge->ring, edge->index, false, widthM);
    std::ranges::reverse(run);
    std::ranges::copy(runFrom(edge->ring, edge->index, true, widthM), std::back_inserter(run));
    return run;
}

Result<SwathSet> abCurve(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    const std::vector<GeoPoint> given = task.settings.line(kLine);
    const bool isDrawn = !given.empty();
    const auto points = isDrawn ? Result<Polyline>{task.field.frame().toLocal(given)} : edgeRun(task);
    if (!points) {
        return std::unexpected(points.error());
    }
    const auto spacing = spacingFor(task);
    if (!spacing) {
        return std::unexpected(spacing.error());
    }
    Bounds box = bounds(task.mainland);
    const double awayM =
        std::ranges::min(*points | std::views::transform([&](Point point) { return distanceM(point, box); }));
    if (!(awayM <= kFarthestM)) {
        return std::unexpected(
            Error{.code = ErrorCode::InputRefused,
                  .what = message("the curve is {:.0f} km away from the field", 1e-3 * awayM),
                  .where = std::string{kLine.key},
                  .remedy = "give one beside it, in WGS84, longitude first"});
    }
    box = joined(box, bounds(*points));
    const Length reach = metres(box.width() + box.height());
    return guideCurve(*points, swathRadius(task.machine), reach, isDrawn ? kLine.key : kEdge.key)
        .and_then([&](const GuideLine& guide) {
            return parallelSwathLines(guide, *spacing, isDrawn, task, job.part(0.0, 0.5));
        })
        .and_then([&](const std::vector<SwathLine>& lines) {
            return swathsOnLines(lines, task, job.part(0.5, 1.0));
        })
        .and_then([&](SwathSet set) -> Result<SwathSet> {
            if (spacing->lastPass != LastPass::Gap) {
                return set;
            }
            return besideOutermostLanes(set, task.mainland, job).transform([&](MultiPolygon left) {
                set.leftOnPurpose = std::move(left);
                return std::move(set);
            });
        });
}

constexpr const Parameter* kAbCurveParameters[] = {&kLine, &kEdge};

}  // namespace

const Method<SwathGenerator> kAbCurveMethod{
    .info = {.id = "ab-curve",
             .name = "AB curve",
             .description = "Beside a curve of your own, or beside the edges around the one that you pick.",
             .parameters = kAbCurveParameters},
    .run = abCurve};

}  // namespace furrow
