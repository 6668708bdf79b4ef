#include "planner/plan/swath_stage.h"

#include "planner/field/ground_around.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/headland_passes.h"
#include "planner/headland/turning_room.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/route/patterns.h"
#include "planner/swaths/full_ends.h"
#include "planner/swaths/mainland_edges.h"
#include "planner/swaths/methods.h"
#include "planner/swaths/tramlines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <ranges>

namespace furrow {

namespace {

// A heading of its own is worth it from this share of the time on.
constexpr double kWorthwhile = 0.99;

/// Work and turns to and fro, and what is missed worked by itself: in free space, as an estimate.
double estimatedSeconds(const SwathSet& set, const MultiPolygon& part, const PlanRequest& request) {
    if (set.swaths.empty()) {
        return 0.0;
    }
    const Machine& machine = request.machine;
    const RouteTask task{.swaths = set, .machine = machine, .turn = turnMethod(request.settings), .settings = request.settings};
    const Duration turning = turningTime(alongTracks(set, toAndFroOrder(trackCount(set)), false), task);
    const double missedM = (1.0 - set.coverage) * area(part).si() / machine.operatingWidth().si();
    return (set.totalLength.si() + missedM) / machine.spec().tractor.workingSpeed.si() + turning.si();
}

Result<SwathSet> byMethod(const PlanRequest& request, const MultiPolygon& mainland, const JobContext& job) {
    return swathMethod(request.settings)({.field = *request.field,
                                          .mainland = mainland,
                                          .machine = request.machine,
                                          .settings = request.settings,
                                          .guides = request.guides.get()},
                                         job);
}

Result<std::vector<MultiPolygon>> piecesBetweenSplits(const Plan& plan, const JobContext& job) {
    const MultiPolygon& mainland = plan.headland.mainland;
    std::vector<Polyline> cuts;
    for (const std::vector<GeoPoint>& line : plan.request.settings.lines(kSplit)) {
        cuts.push_back(plan.field().frame().toLocal(line));
    }
    if (cuts.empty()) {
        return std::vector<MultiPolygon>{mainland};
    }
    const auto pieces = cutAlong(mainland, cuts, job);
    if (!pieces) {
        return std::unexpected(pieces.error());
    }
    std::vector<MultiPolygon> parts;
    for (const Polygon& piece : *pieces) {
        parts.push_back({piece});
    }
    return parts;
}

/// The parts of a set with their swaths one after the other.
class PartCollector {
public:
    explicit PartCollector(const SwathSet& common) : laid_{.swaths = common, .parts = {}} {
        laid_.swaths.swaths.clear();
        laid_.swaths.totalLength = {};
    }

    /// @param heading  of its own; its swaths then get lines of their own
    void add(MultiPolygon outline, SwathSet set, std::optional<Angle> heading) {
        MainlandPart part{.outline = std::move(outline),
                          .firstSwath = laid_.swaths.swaths.size(),
                          .swathCount = set.swaths.size(),
                          .heading = heading};
        for (Swath& swath : set.swaths) {
            swath.number = static_cast<int>(laid_.swaths.swaths.size()) + 1;
            if (heading && !swath.isCurved()) {
                swath.curve = lineOf(swath);
            }
            laid_.swaths.totalLength += swath.length();
            laid_.swaths.swaths.push_back(std::move(swath));
        }
        laid_.parts.push_back(std::move(part));
    }

    LaidSwaths take() { return std::move(laid_); }

private:
    LaidSwaths laid_;
};

/// The swaths of one part in a set of their own, as the methods read them.
SwathSet setOf(const LaidSwaths& laid, const MainlandPart& part) {
    SwathSet set = laid.swaths;
    set.heading = part.heading.value_or(laid.swaths.heading);
    const auto first = laid.swaths.swaths.begin() + static_cast<std::ptrdiff_t>(part.firstSwath);
    set.swaths.assign(first, first + static_cast<std::ptrdiff_t>(part.swathCount));
    return set;
}

/// Within a cell that gets swaths of its own, what these leave on purpose takes the place of what was left.
Result<void> leaveInstead(const MultiPolygon& own, const MultiPolygon& cell, MultiPolygon& left, const JobContext& job) {
    if (!left.empty()) {
        auto outside = difference(left, cell, job, kSnapGrid);
        if (!outside) {
            return std::unexpected(outside.error());
        }
        left = std::move(*outside);
    }
    std::ranges::copy(own, std::back_inserter(left));
    return {};
}

Result<LaidSwaths> laidInParts(const Plan& plan, const SwathSet& common, const JobContext& job) {
    const PlanRequest& request = plan.request;
    const auto pieces = piecesBetweenSplits(plan, job);
    if (!pieces) {
        return std::unexpected(pieces.error());
    }
    const bool ownHeadings = request.settings.choice(kCellHeading) == "per-cell" && !common.isCurved();
    PartCollector collector{common};
    MultiPolygon leftOnPurpose = common.leftOnPurpose;
    if (pieces->size() == 1 && !ownHeadings) {
        collector.add(plan.headland.mainland, common, {});
        return collector.take();
    }
    for (const MultiPolygon& piece : *pieces) {
        SwathSet inside = cutTo(common, piece);
        if (!ownHeadings) {
            collector.add(piece, std::move(inside), {});
            continue;
        }
        const auto cells = decompositionMethod(request.settings)(
            {.mainland = piece, .swaths = inside, .machine = request.machine, .settings = request.settings}, job);
        if (!cells) {
            return std::unexpected(cells.error());
        }
        for (const Cell& cell : cells->cells) {
            SwathSet shared = inside;
            shared.swaths.clear();
            shared.totalLength = {};
            for (const std::size_t index : cell.swaths) {
                shared.swaths.push_back(inside.swaths[index]);
                shared.totalLength += inside.swaths[index].length();
            }
            auto own = byMethod(request, cell.outline, job);
            if (!own && own.error().code == ErrorCode::Cancelled) {
                return std::unexpected(own.error());
            }
            const bool isBetter = own && estimatedSeconds(*own, cell.outline, request) <
                                             kWorthwhile * estimatedSeconds(shared, cell.outline, request);
            if (isBetter) {
                const Angle heading = own->heading;
                if (auto left = leaveInstead(own->leftOnPurpose, cell.outline, leftOnPurpose, job); !left) {
                    return std::unexpected(left.error());
                }
                collector.add(cell.outline, std::move(*own), heading);
            } else {
                collector.add(cell.outline, std::move(shared), {});
            }
        }
    }
    LaidSwaths laid = collector.take();
    laid.swaths.leftOnPurpose = std::move(leftOnPurpose);
    return laid;
}

/// Each part by itself where a neighbour has another heading: nothing goes on beyond its edge then.
void drawOut(LaidSwaths& laid, const MultiPolygon& mainland, const EndRoom& room, const Machine& machine) {
    if (std::ranges::none_of(laid.parts, [](const MainlandPart& part) { return part.heading.has_value(); })) {
        drawOutEnds(laid.swaths, mainland, room, machine);
        return;
    }
    Length total;
    Area overlap;
    for (const MainlandPart& part : laid.parts) {
        SwathSet set = setOf(laid, part);
        set.endOverlap = {};
        drawOutEnds(set, part.outline, room, machine);
        std::ranges::copy(set.swaths, laid.swaths.swaths.begin() + static_cast<std::ptrdiff_t>(part.firstSwath));
        total += set.totalLength;
        overlap += set.endOverlap;
    }
    laid.swaths.totalLength = total;
    laid.swaths.endOverlap = overlap;
}

struct GroundForEnds {
    MultiPolygon working;
    MultiPolygon driving;
    bool drawsIn = false;
};

/// Inside the outermost pass where there are more. Without any, and with a machine that may leave the field, everywhere
/// but over obstacles.
Result<GroundForEnds> groundForEnds(const Plan& plan, const MultiPolygon& workable, const MultiPolygon& drivable,
                                    const JobContext& job) {
    const Machine& machine = plan.request.machine;
    const Field& field = plan.field();
    if (plan.headland.passes == 0 && !plan.request.settings.flag(kStayInside)) {
        return obstaclesOf(field, job)
            .and_then([&](const MultiPolygon& obstacles) { return groundAround(field, obstacles, job); })
            .transform([](const MultiPolygon& ground) { return GroundForEnds{ground, ground, true}; });
    }
    const Length outermost = plan.margin + (plan.headland.passes > 1 ? uncutEdge(machine) + machine.operatingWidth() : Length{});
    return eroded(workable, outermost, kArcTolerance, job).transform([&](MultiPolygon&& working) {
        return GroundForEnds{std::move(working), drivable, false};
    });
}

}  // namespace

SwathSet cutTo(const SwathSet& set, const MultiPolygon& part) {
    const MainlandEdges edges{part};
    SwathSet inside = set;
    inside.swaths.clear();
    inside.totalLength = {};
    for (const Swath& swath : set.swaths) {
        for (Turn& piece : edges.partsInside(lineOf(swath))) {
            Swath cut = swath;
            cut.start = piece.start.position;
            cut.end = piece.end().position;
            cut.curve = swath.isCurved() ? std::move(piece) : Turn{};
            inside.totalLength += cut.length();
            inside.swaths.push_back(std::move(cut));
        }
    }
    return inside;
}

Result<std::vector<Pose>> swathEnds(const PlanRequest& request, const MultiPolygon& mainland, const JobContext& job) {
    return byMethod(request, mainland, job).transform([](const SwathSet& set) {
        std::vector<Pose> ends;
        for (const Swath& swath : set.swaths) {
            const Turn line = lineOf(swath);
            ends.push_back({.position = line.start.position, .heading = line.start.heading + degrees(180.0)});
            ends.push_back(line.end());
        }
        return ends;
    });
}

Result<LaidSwaths> layStage(const Plan& plan, const MultiPolygon& workable, const MultiPolygon& drivable,
                            const JobContext& job) {
    const PlanRequest& request = plan.request;
    auto common = byMethod(request, plan.headland.mainland, job);
    if (!common) {
        return std::unexpected(common.error());
    }
    markTramlines(*common, request.settings);
    auto laid = laidInParts(plan, *common, job);
    if (!laid || request.settings.choice(kEnds) != "full") {
        return laid;
    }
    const auto room = groundForEnds(plan, workable, drivable, job);
    if (!room) {
        return std::unexpected(room.error());
    }
    drawOut(*laid, plan.headland.mainland,
            {.working = room->working,
             .driving = room->driving,
             .turning = reachOfLevelTurn(request.machine, turnMethod(request.settings)),
             .drawsIn = room->drawsIn},
            request.machine);
    return laid;
}

namespace {

/// One part after the other: the figures of a step are those of all parts.
void append(DecompositionHistory& all, DecompositionHistory part) {
    if (part.steps.empty()) {
        return;
    }
    const std::size_t offset = all.pieces.size();
    std::ranges::move(part.pieces, std::back_inserter(all.pieces));
    if (all.steps.empty()) {
        all.steps = std::move(part.steps);
        return;
    }
    const auto add = [](DecompositionStep& sum, const DecompositionStep& more) {
        sum.cells += more.cells;
        sum.altitude += more.altitude;
        sum.cost += more.cost;
    };
    const DecompositionStep before = all.steps.back();
    for (DecompositionStep& step : all.steps) {
        add(step, part.steps.front());
    }
    for (DecompositionStep& step : part.steps | std::views::drop(1)) {
        add(step, before);
        for (Join& join : step.joins) {
            join.kept += offset;
            join.gone += offset;
        }
        all.steps.push_back(std::move(step));
    }
}

}  // namespace

Result<Decomposition> cellStage(const PlanRequest& request, const LaidSwaths& laid, const JobContext& job) {
    Decomposition all;
    for (const MainlandPart& part : laid.parts) {
        SwathSet set = setOf(laid, part);
        if (part.heading) {
            // Straight along a heading of their own.
            std::ranges::for_each(set.swaths, [](Swath& swath) { swath.curve = {}; });
        }
        auto cells = decompositionMethod(request.settings)(
            {.mainland = part.outline, .swaths = set, .machine = request.machine, .settings = request.settings}, job);
        if (!cells) {
            return std::unexpected(cells.error());
        }
        for (Cell& cell : cells->cells) {
            cell.heading = set.heading;
            std::ranges::for_each(cell.swaths, [&](std::size_t& swath) { swath += part.firstSwath; });
            all.cells.push_back(std::move(cell));
        }
        all.altitude += cells->altitude;
        append(all.history, std::move(cells->history));
    }
    return all;
}

}  // namespace furrow
