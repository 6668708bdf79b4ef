#include "planner/geometry/segment.h"
#include "planner/swaths/curved_swaths.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace furrow {

namespace {

/// The distances from the centre to the nearest and the farthest point of the mainland.
std::pair<double, double> reachOf(const MultiPolygon& mainland, Point centre) {
    double nearestM = std::numeric_limits<double>::infinity();
    double farthestM = 0.0;
    forEachEdge(mainland, [&](Point from, Point to) {
        nearestM = std::min(nearestM, distanceToSegment(centre, from, to));
        farthestM = std::max(farthestM, distance(centre, from));
    });
    return {MainlandEdges{mainland}.contains(centre) ? 0.0 : nearestM, farthestM};
}

Curve ringAround(Point centre, double radiusM, double fromRad) {
    const Curvature curvature = Curvature::fromSi(1.0 / radiusM);
    return {.type = {},
            .start = {.position = centre + radiusM * direction(fromRad),
                      .heading = radians(fromRad + 0.5 * std::numbers::pi)},
            .pieces = {{.length = metres(2.0 * std::numbers::pi * radiusM), .curvature = curvature}}};
}

/// The parts of a ring inside the mainland. A part across the start of the ring stays in one piece.
std::vector<Curve> piecesOf(const Curve& ring, const MainlandEdges& edges) {
    std::vector<Curve> parts = edges.partsInside(ring);
    if (parts.size() < 2 || !edges.contains(ring.start.position)) {
        return parts;
    }
    // The last part continues at the beginning of the first.
    Curve joined = std::move(parts.back());
    parts.pop_back();
    joined.pieces.insert(joined.pieces.end(), parts.front().pieces.begin(), parts.front().pieces.end());
    parts.front() = std::move(joined);
    return parts;
}

Result<SwathSet> pivot(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    const std::vector<GeoPoint> given = task.settings.line(kLine);
    if (given.empty()) {
        return std::unexpected(Error{.code = ErrorCode::Usage,
                                     .what = "pivot needs its centre",
                                     .where = std::string{kLine.key},
                                     .remedy = "give it as WKT in WGS84, such as POINT (4.1 52.0)"});
    }
    const auto spacing = spacingFor(task);
    if (!spacing) {
        return std::unexpected(spacing.error());
    }
    const Point centre = task.field.frame().toLocal(given.front());
    const auto [nearestM, farthestM] = reachOf(task.mainland, centre);
    const double stepM = (spacing->width - spacing->overlap).si();
    if (const auto checked = checkTrackCount(*spacing, metres(farthestM - nearestM)); !checked) {
        return std::unexpected(checked.error());
    }
    const double tightestM = swathRadius(task.machine).si();
    const MainlandEdges edges{task.mainland};
    std::vector<SwathLine> lines;
    int leftOut = 0;
    int track = 0;
    double fromRad = 0.0;
    // From the outside inwards, starting half a width inside, because a pivot's land is measured by its rim.
    for (double radiusM = farthestM - 0.5 * spacing->width.si(); radiusM > nearestM;
         radiusM -= stepM, ++track) {
        if (radiusM < tightestM) {
            leftOut = static_cast<int>(std::ceil((radiusM - nearestM) / stepM));
            break;
        }
        for (Curve& part : piecesOf(ringAround(centre, radiusM, fromRad), edges)) {
            lines.push_back({track, std::move(part)});
        }
        // The next ring begins farther on, by the length of the way over to it: two arcs of the smallest
        // radius.
        const double aheadM = std::sqrt(std::max(0.0, stepM * (4.0 * tightestM - stepM)));
        fromRad +=
            (aheadM + 2.0 * task.machine.spec().implement.runIn.si()) / std::max(radiusM - stepM, tightestM);
    }
    auto set = swathsOnLines(lines, task, job);
    if (set && leftOut > 0) {
        set->notes.push_back(
            {.text =
                 message("{} within {:.1f} m of the centre: tighter than this machine can follow, left out",
                         counted("{} circle", "{} circles", leftOut), tightestM),
             .where = "swaths",
             .place = given.front()});
    }
    return set;
}

constexpr const Parameter* kPivotParameters[] = {&kLine};

}  // namespace

const Method<SwathGenerator> kPivotMethod{
    .info = {.id = "pivot",
             .name = "Circles",
             .description = "Round and round the centre of a pivot, from the rim inwards.",
             .parameters = kPivotParameters},
    .run = pivot};

}  // namespace furrow
