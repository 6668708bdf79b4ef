#include "planner/plan/swath_stage.h"

#include "planner/decomposition/split_lines.h"
#include "planner/field/ground_around.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/turning_room.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/mainland_parts.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/own_headings.h"
#include "planner/swaths/full_ends.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/mainland_edges.h"
#include "planner/swaths/methods.h"
#include "planner/swaths/short_swaths.h"
#include "planner/swaths/tramlines.h"
#include "planner/turns/straight_turn.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <ranges>

namespace furrow {

namespace {

/// What a split line leaves undone, for the user.
Note noteOf(const SplitFault& fault, const LocalFrame& frame) {
    const std::size_t number = fault.line + 1;
    const Message text =
        fault.missing
            ? message(
                  "split line {} ends {:.1f} m short of the headland and cuts nothing off there (decomposition.split); "
                  "draw it right through",
                  number, fault.missing->si())
            : message("split line {} does not lie inside the headland and cuts nothing (decomposition.split)",
                      number);
    return {.text = text, .where = std::string{kSplit.key}, .place = frame.toGeo(fault.place)};
}

Result<std::vector<MultiPolygon>> piecesBetweenSplits(const PlanRequest& request,
                                                      const MultiPolygon& mainland, std::vector<Note>& notes,
                                                      const JobContext& job) {
    const LocalFrame& frame = request.field->frame();
    std::vector<Polyline> drawn;
    for (const std::vector<GeoPoint>& line : request.settings.lines(kSplit)) {
        drawn.push_back(frame.toLocal(line));
    }
    if (drawn.empty()) {
        return std::vector<MultiPolygon>{mainland};
    }
    // By hand nobody ends a line on an edge that is not drawn before the plan.
    const SplitLines cuts = drawnThrough(std::move(drawn), mainland, request.machine.operatingWidth());
    for (const SplitFault& fault : cuts.faults) {
        notes.push_back(noteOf(fault, frame));
    }
    const auto pieces = cutAlong(mainland, cuts.lines, job);
    if (!pieces) {
        return std::unexpected(pieces.error());
    }
    std::vector<MultiPolygon> parts;
    for (const Polygon& piece : *pieces) {
        parts.push_back({piece});
    }
    return parts;
}

LaidSwaths laidInParts(const MultiPolygon& mainland, const SwathSet& common,
                       const std::vector<MultiPolygon>& pieces) {
    PartCollector collector{common, mainland};
    if (pieces.size() == 1) {
        collector.add(mainland, common, {});
        return collector.take();
    }
    for (const MultiPolygon& piece : pieces) {
        collector.add(piece, cutTo(common, piece), {});
    }
    return collector.take();
}

bool hasOwnHeadings(const LaidSwaths& laid) {
    return std::ranges::any_of(laid.parts, [](const MainlandPart& part) { return part.heading.has_value(); });
}

/// Each part by itself where a neighbour has another heading: nothing goes on beyond its edge then. Parts
/// with the common heading are one.
Result<void> drawOut(LaidSwaths& laid, const MultiPolygon& mainland, const EndRoom& room,
                     const Machine& machine, const JobContext& job) {
    if (!hasOwnHeadings(laid)) {
        drawOutEnds(laid.swaths, mainland, room, machine);
        return {};
    }
    MultiPolygon own;
    for (const MainlandPart& part : laid.parts) {
        if (part.heading) {
            own.insert(own.end(), part.outline.begin(), part.outline.end());
        }
    }
    const auto common = difference(mainland, own, job, kSnapGrid);
    if (!common) {
        return std::unexpected(common.error());
    }
    Length total;
    Area overlap;
    for (const MainlandPart& part : laid.parts) {
        SwathSet set = setOf(laid.swaths, part);
        set.endOverlap = {};
        drawOutEnds(set, part.heading ? part.outline : *common, room, machine);
        std::ranges::copy(set.swaths,
                          laid.swaths.swaths.begin() + static_cast<std::ptrdiff_t>(part.firstSwath));
        total += set.totalLength;
        overlap += set.endOverlap;
    }
    laid.swaths.totalLength = total;
    laid.swaths.endOverlap = overlap;
    return {};
}

/// With ends, and without swaths that are too short even with theirs.
Result<LaidSwaths> withoutShortOnes(LaidSwaths laid, const PlanRequest& request, const EndsDrawnOut& withEnds,
                                    const JobContext& job) {
    auto drawn = withEnds(laid);
    if (!drawn) {
        return drawn;
    }
    const Length least = minSwathLength(request.settings, request.machine);
    const std::vector<bool> areShort = shortOnes(drawn->swaths, least);
    if (std::ranges::find(areShort, true) == areShort.end()) {
        return drawn;
    }
    std::size_t first = 0;
    for (MainlandPart& part : laid.parts) {
        const auto begin = areShort.begin() + static_cast<std::ptrdiff_t>(part.firstSwath);
        const auto gone = std::count(begin, begin + static_cast<std::ptrdiff_t>(part.swathCount), true);
        part.firstSwath = first;
        part.swathCount -= static_cast<std::size_t>(gone);
        first += part.swathCount;
    }
    return leaveOut(areShort, least, laid.mainland, laid.swaths, job).and_then([&] {
        return withEnds(std::move(laid));
    });
}

struct GroundForEnds {
    MultiPolygon working;
    AllowedAreas driving;
    bool drawsIn = false;
};

/// Whether swaths have to leave room for turns on the spot at their ends.
bool turnsAtEnds(const LayTask& task) {
    return task.passes == 0 && turnsOnTheSpotInside(task.request);
}

/// The swaths of the chosen method. With turns on the spot at their ends, without what the implement would
/// reach over beside them, unless nothing is left then.
SwathSet commonSwaths(const LayTask& task) {
    if (!turnsAtEnds(task)) {
        return task.found;
    }
    SwathSet inside = withoutReachingOver(task.found, task.ground.drivable, task.request.machine);
    return inside.swaths.empty() || inside.swaths.size() > kMostSwaths ? task.found : inside;
}

/// Inside the outermost pass where there are more. Without any, and with a machine that may leave the field,
/// everywhere but over obstacles. Without any in a field with overhangs, or with a machine that turns on the
/// spot, swaths stop where the tractor would leave the field, so that it needs no more than the boom's room.
Result<GroundForEnds> groundForEnds(const LayTask& task, const JobContext& job) {
    const Machine& machine = task.request.machine;
    if (task.passes == 0 && !task.request.settings.flag(kStayInside)) {
        return groundAround(*task.request.field, job).transform([](const MultiPolygon& ground) {
            return GroundForEnds{ground, ground, true};
        });
    }
    const Length outermost =
        task.ground.margin + (task.passes > 1 ? uncutEdge(machine) + machine.operatingWidth() : Length{});
    return eroded(task.workable, outermost, kArcTolerance, job).transform([&](MultiPolygon&& working) {
        return GroundForEnds{
            .working = std::move(working),
            .driving = task.ground.drivable,
            .drawsIn = turnsAtEnds(task) || (task.passes == 0 && task.ground.drivable.hasOverhang())};
    });
}

}  // namespace

bool turnsOnTheSpotInside(const PlanRequest& request) {
    return request.settings.flag(kStayInside) && canTurnOnTheSpot(request.machine);
}

SwathSet cutTo(const SwathSet& set, const MultiPolygon& part) {
    const MainlandEdges edges{part};
    SwathSet inside = set;
    inside.swaths.clear();
    inside.totalLength = {};
    for (const Swath& swath : set.swaths) {
        for (Curve& piece : edges.partsInside(lineOf(swath))) {
            Swath cut = swath;
            cut.start = piece.start.position;
            cut.end = piece.end().position;
            cut.curve = swath.isCurved() ? std::move(piece) : Curve{};
            inside.totalLength += cut.length();
            inside.swaths.push_back(std::move(cut));
        }
    }
    return inside;
}

Result<std::vector<Pose>> swathEnds(const PlanRequest& request, const MultiPolygon& mainland,
                                    const JobContext& job) {
    return swathsByMethod(request, mainland, job).transform([](const SwathSet& set) {
        std::vector<Pose> ends;
        for (const Swath& swath : set.swaths) {
            const Curve line = lineOf(swath);
            ends.push_back({.position = line.start.position, .heading = line.start.heading + degrees(180.0)});
            ends.push_back(line.end());
        }
        return ends;
    });
}

Result<LaidSwaths> layStage(const LayTask& task, const JobContext& job) {
    const PlanRequest& request = task.request;
    SwathSet common = commonSwaths(task);
    if (task.mainland.empty()) {
        return LaidSwaths{.swaths = std::move(common), .parts = {}, .mainland = {}};
    }
    markTramlines(common, request.settings);
    const auto pieces = piecesBetweenSplits(request, task.mainland, common.notes, job);
    if (!pieces) {
        return std::unexpected(pieces.error());
    }
    const bool drawsOut = drawsOutEnds(request.settings);
    const bool turnsOnTheSpot = turnsAtEnds(task);
    const auto ground =
        drawsOut || turnsOnTheSpot
            ? groundForEnds(task, job)
            : Result<GroundForEnds>{GroundForEnds{task.mainland, task.ground.drivable, false}};
    if (!ground) {
        return std::unexpected(ground.error());
    }
    const EndRoom room{.working = ground->working,
                       .driving = ground->driving,
                       .turning = reachOfLevelTurn(request.machine, turnMethod(request.settings).run),
                       .drawsIn = ground->drawsIn,
                       .turnsOnTheSpot = turnsOnTheSpot,
                       .drawsOut = drawsOut || !turnsOnTheSpot};
    const auto withEnds = [&](LaidSwaths set) -> Result<LaidSwaths> {
        if (drawsOut || turnsOnTheSpot || hasOwnHeadings(set)) {
            if (auto drawn = drawOut(set, task.mainland, room, request.machine, job); !drawn) {
                return std::unexpected(drawn.error());
            }
        }
        return set;
    };
    const bool ownHeadings = hasHeadingPerCell(request.settings) && !common.isCurved();
    auto laid = ownHeadings ? withOwnHeadings(request, task.mainland, common, *pieces, withEnds, job)
                            : Result<LaidSwaths>{laidInParts(task.mainland, common, *pieces)};
    return laid ? withoutShortOnes(std::move(*laid), request, withEnds, job) : laid;
}

}  // namespace furrow
