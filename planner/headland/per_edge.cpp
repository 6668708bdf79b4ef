#include "planner/headland/edge_strips.h"
#include "planner/headland/finishing_passes.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/headland/strip_headland.h"
#include "planner/headland/turning_room.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

// A side without swath ends needs no pass if it is straight within this distance.
constexpr double kStraightM = 0.05;
constexpr double kSameHeading = 1e-9;
constexpr int kMostWiderings = 4;
// Distance from the middle of a swath to test points near its sides, as a share of its width.
constexpr double kAlmostHalfSwath = 0.45;

double angleBetween(const Pose& leaving, const EdgeStrip& strip) {
    const Point along = strip.to - strip.from;
    const Point way = direction(leaving.heading.si());
    return std::abs(std::atan2(cross(way, along), dot(way, along)));
}

/// The edges straight ahead of a swath, from its middle and both its sides.
std::vector<std::size_t> edgesAhead(const Pose& leaving, const EdgeStrips& strips, const HeadlandTask& task,
                                    Length within) {
    std::vector<std::size_t> edges;
    const Point ahead = direction(leaving.heading.si());
    for (const double side : {-kAlmostHalfSwath, 0.0, kAlmostHalfSwath}) {
        const Point from =
            leaving.position + side * task.machine.operatingWidth().si() * Point{-ahead.y, ahead.x};
        const auto edge = strips.ahead({.position = from, .heading = leaving.heading}, within);
        if (edge && !std::ranges::contains(edges, *edge)) {
            edges.push_back(*edge);
        }
    }
    return edges;
}

/// Widens the edges at swath ends to the room for turning. Returns whether one of them was too narrow.
Result<bool> makeRoom(std::vector<EdgeStrip>& strips, const MultiPolygon& mainland,
                      const HeadlandTask& task) {
    const auto ends = task.swathEnds(mainland);
    if (!ends) {
        return std::unexpected(ends.error());
    }
    const EdgeStrips edges{strips};
    // The search goes beyond the widest strip, because a slanting edge lies farther away on one side.
    const auto widest = std::ranges::max_element(strips, {}, &EdgeStrip::width);
    const Length within = 2.0 * widest->width + 4.0 * task.machine.operatingWidth();
    bool wasNarrow = false;
    for (const Pose& leaving : *ends) {
        for (const std::size_t i : edgesAhead(leaving, edges, task, within)) {
            const Length room = roomForTurnsAt(radians(angleBetween(leaving, strips[i])), task.machine,
                                               task.turn, task.drawsOutEnds, task.overhang);
            if (const int passes = passesFor(room, task.machine); passes > strips[i].passes) {
                strips[i].passes = passes;
                strips[i].width = widthOfPasses(passes, task);
                wasNarrow = true;
            }
        }
    }
    return wasNarrow;
}

/// The narrowest headland along every edge: one pass, so that the outermost goes all round. If no headland is
/// driven and all swaths have one heading, the outermost straight sides along the swaths get no pass.
std::vector<EdgeStrip> narrowest(const HeadlandTask& task, const std::vector<Pose>& ends) {
    std::vector<EdgeStrip> strips = EdgeStrips::along(task.workable(), widthOfPasses(1, task), 1);
    const bool isOneHeading = !ends.empty() && std::ranges::all_of(ends, [&](const Pose& end) {
        return std::abs(std::sin((end.heading - ends.front().heading).si())) < kSameHeading;
    });
    if (task.settings.flag(kHeadlandDriven) || !isOneHeading) {
        return strips;
    }
    const Point way = direction(ends.front().heading.si());
    const auto asideM = [way](const EdgeStrip& strip) { return cross(way, strip.from); };
    const auto [least, most] = std::ranges::minmax(strips, {}, asideM);
    for (EdgeStrip& strip : strips) {
        const auto isAt = [&](double sideM) {
            return std::abs(asideM(strip) - sideM) < kStraightM &&
                   std::abs(cross(way, strip.to) - sideM) < kStraightM;
        };
        if (isAt(asideM(least)) || isAt(asideM(most))) {
            strip.passes = 0;
            strip.width = task.margin + uncutEdge(task.machine);
        }
    }
    return strips;
}

Result<Headland> perEdge(const HeadlandTask& task, const JobContext& job) {
    Headland wanted;
    wanted.strips = EdgeStrips::along(task.workable(), widthOfPasses(1, task), 1);
    const auto first = withoutStrips(task.workable(), wanted.strips, job);
    if (!first) {
        return std::unexpected(first.error());
    }
    if (first->empty()) {
        return headlandOf(std::move(wanted), task, job);
    }
    const auto ends = task.swathEnds(*first);
    if (!ends) {
        return std::unexpected(ends.error());
    }
    wanted.strips = narrowest(task, *ends);
    // A wider strip may move swath ends elsewhere, or turn all swaths.
    for (int round = 0; round < kMostWiderings; ++round) {
        const auto mainland = withoutStrips(task.workable(), wanted.strips, job);
        if (!mainland) {
            return std::unexpected(mainland.error());
        }
        if (mainland->empty()) {
            break;
        }
        const auto wasNarrow = makeRoom(wanted.strips, *mainland, task);
        if (!wasNarrow) {
            return std::unexpected(wasNarrow.error());
        }
        if (!*wasNarrow) {
            break;
        }
    }
    return headlandOf(std::move(wanted), task, job);
}

constexpr const Parameter* kPerEdgeParameters[] = {&kHeadlandDriven,    &kHeadlandOrder,  &kHeadlandWhen,
                                                   &kHeadlandDirection, &kHeadlandCorner, &kHeadlandFinish};

}  // namespace

const Method<HeadlandGenerator> kPerEdgeMethod{
    .info =
        {.id = "per-edge",
         .name = "Only where it turns",
         .description =
             "Along each edge as wide as the turns there need it; a single pass where no swath ends, or nothing if it is not worked.",
         .parameters = kPerEdgeParameters},
    .run = perEdge};

}  // namespace furrow
