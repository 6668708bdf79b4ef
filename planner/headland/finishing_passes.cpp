#include "planner/headland/finishing_passes.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/curve_parts.h"
#include "planner/headland/finishing_lanes.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// A piece of land within this distance of an edge lies at it.
constexpr double kAtEdgeM = 0.5;

Point halfWay(const Curve& line) {
    return partOf(line, {}, 0.5 * line.length()).end().position;
}

/// The chosen passes, and the land that they leave.
struct Chosen {
    std::vector<PassStretch> passes;
    LeftLand left;
};

bool isTooMuchInAll(const FinishingTask& task, const LeftLand& left) {
    return left.inAll() > task.mayStay;
}

bool isTooMuch(const FinishingTask& task, const LeftLand& left) {
    return isTooMuchInAll(task, left) || left.largest() > task.mayStayInOnePiece;
}

/// Takes the pass with the largest gain, again and again, while too much is left. Each pass can only lower
/// the other gains. A lane that is still the best after its gain is recomputed is therefore the best of all
/// (Minoux 1978, doi 10.1007/BFb0006528).
Result<void> chooseBest(std::vector<FinishingLane> lanes, const FinishingLanes& finder,
                        const FinishingTask& task, Chosen& chosen, const JobContext& job) {
    const auto less = [](const FinishingLane& a, const FinishingLane& b) { return a.gainM2 < b.gainM2; };
    std::ranges::make_heap(lanes, less);
    while (!lanes.empty() && chosen.passes.size() < task.most && isTooMuch(task, chosen.left) &&
           !finder.isSpent()) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        std::ranges::pop_heap(lanes, less);
        FinishingLane lane = lanes.back();
        lanes.pop_back();
        const auto putBack = [&](const FinishingLane& one) {
            lanes.push_back(one);
            std::ranges::push_heap(lanes, less);
        };
        // Most lanes are never the best. Their room is therefore checked only here, and only where other
        // passes left them enough.
        if (!lane.isFree) {
            const double besideM2 = finder.landBesideM2(lane, chosen.left);
            if (besideM2 < finder.leastGainM2()) {
                continue;
            }
            if (besideM2 < lane.gainM2 && !lanes.empty() && besideM2 < lanes.front().gainM2) {
                lane.gainM2 = besideM2;
                putBack(lane);
                continue;
            }
            std::ranges::for_each(finder.free(lane), putBack);
            continue;
        }
        const std::optional<FinishingPass> found = finder.passAlong(lane, chosen.left);
        if (!found) {
            continue;
        }
        lane.gainM2 = found->gainM2;
        if (!lanes.empty() && lane.gainM2 < lanes.front().gainM2) {
            putBack(lane);
            continue;
        }
        auto after = chosen.left.cutBy({{.outer = stripOf(*found, finder.widthM()), .holes = {}}}, job);
        if (!after) {
            return std::unexpected(after.error());
        }
        // Once enough is worked in total, only a pass that makes a large piece smaller is useful.
        if (isTooMuchInAll(task, chosen.left) || after->largest < chosen.left.largest()) {
            chosen.passes.push_back(
                {.line = lineOf(*found, task.lowered.machine()), .otherWay = finder.otherWay(*found)});
            chosen.left.take(*std::move(after));
            putBack(lane);
        }
    }
    return {};
}

/// Adds passes on full lock over land at the edges, piece by piece, the largest first.
Result<void> chooseBends(const FinishingLanes& finder, const FinishingTask& task,
                         const BoundaryDistance& edges, Chosen& chosen, const JobContext& job) {
    const auto isAtEdge = [&](const Polygon& piece) {
        return std::ranges::any_of(
            piece.outer, [&](Point place) { return edges.insideM(place).value_or(kAtEdgeM) < kAtEdgeM; });
    };
    const auto isRefused = [&](const Curve& line) { return finder.isRefused(line); };
    const auto isOfUse = [&](const LeftLand::Piece& piece, Area inAll) {
        return piece.area.si() >= finder.leastGainOfBendM2() &&
               (inAll > task.mayStay || piece.area > task.mayStayInOnePiece);
    };
    // Those that are tried even if every pass works the whole of its piece.
    std::vector<Polygon> first;
    Area inAll = chosen.left.inAll();
    for (const LeftLand::Piece& piece : chosen.left.pieces()) {
        if (!isOfUse(piece, inAll)) {
            break;
        }
        if (isAtEdge(piece.outline)) {
            first.push_back(piece.outline);
            inAll = inAll - piece.area;
        }
    }
    if (auto done = task.bends->lookAhead(first, isRefused, job.withoutProgress()); !done) {
        return done;
    }
    std::size_t givenUp = 0;
    while (chosen.passes.size() < task.most && isTooMuch(task, chosen.left)) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        if (givenUp >= chosen.left.pieces().size()) {
            break;
        }
        const LeftLand::Piece& piece = chosen.left.pieces()[givenUp];
        if (!isOfUse(piece, chosen.left.inAll())) {
            break;
        }
        ++givenUp;
        auto pass = isAtEdge(piece.outline) ? task.bends->over(piece.outline, isRefused, job) : std::nullopt;
        if (!pass) {
            continue;
        }
        auto after = chosen.left.cutBy(pass->worked, job);
        if (!after) {
            return std::unexpected(after.error());
        }
        if ((chosen.left.inAll() - after->inAll).si() < finder.leastGainOfBendM2()) {
            continue;
        }
        chosen.passes.push_back({.line = std::move(pass->line)});
        chosen.left.take(*std::move(after));
        chosen.left.sortLargestFirst();
        --givenUp;
    }
    return {};
}

}  // namespace

Result<std::vector<HeadlandPass>> finishingPasses(const FinishingTask& task, const JobContext& job) {
    const FinishingLanes finder{task};
    const Machine& machine = task.lowered.machine();
    const BoundaryDistance edges{task.workable, metres(1e4)};
    Chosen chosen{.passes = {}, .left = LeftLand{task.left}};
    if (task.bends != nullptr) {
        task.bends->forgetFailedPoses();
        if (auto done = chooseBends(finder, task, edges, chosen, job); !done) {
            return std::unexpected(done.error());
        }
    }
    for (const auto lanesOver : {&FinishingLanes::beside, &FinishingLanes::across}) {
        if (!isTooMuch(task, chosen.left) || finder.isSpent()) {
            break;
        }
        std::vector<FinishingLane> lanes;
        for (const LeftLand::Piece& piece : chosen.left.pieces()) {
            if (piece.area.si() >= finder.leastGainM2()) {
                std::ranges::move((finder.*lanesOver)(piece.outline), std::back_inserter(lanes));
            }
            if (job.stopRequested()) {
                return std::unexpected(cancelled());
            }
        }
        if (auto done = chooseBest(std::move(lanes), finder, task, chosen, job); !done) {
            return std::unexpected(done.error());
        }
    }
    std::vector<HeadlandPass> passes;
    for (PassStretch& stretch : chosen.passes) {
        const double fromEdgeM = edges.insideM(halfWay(stretch.line)).value_or(0.0);
        passes.push_back({.ring = static_cast<int>(fromEdgeM / finder.widthM()),
                          .width = machine.operatingWidth(),
                          .closed = false,
                          .stretches = {std::move(stretch)}});
    }
    return passes;
}

const Parameter kHeadlandFinish{
    .key = "headland.finish",
    .name = "Finish corners",
    .description = "Short passes where corners would leave more than 1 % of the field.",
    .kind = ParameterKind::Flag,
    .standard = 1.0,
    .choices = {}};

}  // namespace furrow
