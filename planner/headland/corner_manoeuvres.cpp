#include "planner/headland/corner_manoeuvres.h"

#include "planner/geometry/segment.h"
#include "planner/geometry/tolerances.h"
#include "planner/turns/allowed_edges.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/connection.h"
#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace furrow {

namespace {

// Curves with a radius above 2 machine radii are no corners.
constexpr double kCornerRadii = 2.0;
constexpr double kSmallestCornerRad = std::numbers::pi / 4.0;
// A larger turn is a loop round something, not a corner.
constexpr double kLargestCornerRad = 5.0 * std::numbers::pi / 6.0;
// A straight shorter than this between arcs belongs to the corner.
constexpr double kSideStraightM = 0.5;
constexpr double kOnwardStepM = 0.1;
constexpr double kSameHeadingRad = 1e-9;

bool isSame(const Pose& a, const Pose& b) {
    return distance(a.position, b.position) < kRoundingM &&
           std::abs((a.heading - b.heading).si()) < kSameHeadingRad;
}

Pose poseBefore(const Curve& line, std::size_t piece) {
    Pose pose = line.start;
    for (std::size_t i = 0; i < piece; ++i) {
        pose = advanced(pose, line.pieces[i], line.pieces[i].length);
    }
    return pose;
}

/// The same closed line, starting at its first straight. So its start does not cut a corner in two.
Curve fromAStraight(const Curve& line) {
    const auto first = std::ranges::find_if(line.pieces, [](const CurvePiece& piece) {
        return piece.curvature == Curvature{} && piece.endCurvature == Curvature{} &&
               piece.length.si() >= kSideStraightM;
    });
    if (first == line.pieces.end()) {
        return line;
    }
    const auto index = first - line.pieces.begin();
    Curve turned{
        .type = line.type, .start = poseBefore(line, static_cast<std::size_t>(index)), .pieces = line.pieces};
    std::ranges::rotate(turned.pieces, turned.pieces.begin() + index);
    return turned;
}

/// A manoeuvre at a corner: onwards past the point where its two sides meet, and back before that point on
/// the next side.
struct Manoeuvre {
    Length onward;  ///< worked beyond the start of the rounding
    Curve turn;
    Length back;  ///< worked before the end of the rounding
};

std::optional<Manoeuvre> manoeuvre(const Curve& line, const RoundedCorner& corner, CornerMethod method,
                                   const RigidRoom& working, const Rig& rig, CornerWays& ways,
                                   const JobContext& job) {
    const Machine& machine = rig.machine();
    const Pose entry = poseBefore(line, corner.firstPiece);
    const Pose exit = poseBefore(line, corner.lastPiece + 1);
    const Point in = direction(entry.heading.si());
    const Point out = direction(exit.heading.si());
    // From the start of the rounding to the meeting point of the sides, and from there to its end.
    const auto [toCorner, fromCorner] = toMeeting(entry.position, in, exit.position, out);
    // The distance from the meeting point of the middles to that of the outer edges.
    const double width = machine.operatingWidth().si();
    const double beyond =
        std::min(0.5 * width * std::tan(0.5 * std::abs(corner.turn.si())), kMostWidthsOnward * width);
    const double lead = -machine.spec().implement.offset.si();
    const auto farthest = [&](const Pose& from, double sign, double wanted) {
        double best = 0.0;
        for (double m = kOnwardStepM; m <= wanted; m += kOnwardStepM) {
            const Pose pose{.position = from.position + sign * m * direction(from.heading.si()),
                            .heading = from.heading};
            if (!working.isInside(pose)) {
                break;
            }
            best = m;
        }
        return best;
    };
    // On the next side it needs its run-in before the implement is lowered.
    const double runIn = machine.runIn().si();
    const double mostOnward = farthest(entry, 1.0, toCorner + beyond + lead);
    const double mostBack = farthest(exit, -1.0, fromCorner + beyond - lead + runIn);
    // If no way exists from the farthest place, try nearer places.
    for (const double share : {1.0, 0.75, 0.5, 0.25}) {
        const double kept = (1.0 - share) * beyond;
        const double onward = std::max(0.0, mostOnward - kept);
        const double back = std::max(0.0, mostBack - kept - runIn);
        if (onward <= 0.0 && back <= 0.0) {
            break;
        }
        const Pose from{.position = entry.position + onward * in, .heading = entry.heading};
        const Pose to{.position = exit.position - back * out, .heading = exit.heading};
        // For a machine that cannot reverse, the third kind is a forward turn as well.
        const Curve turn = method == CornerMethod::Searched ? ways.between(rig, from, to, job)
                           : method == CornerMethod::Loop
                               ? connection(from, to, machine, kDubinsMethod.run)
                               : connection(from, to, machine, kReedsSheppMethod.run);
        if (rig.driven(Rig::inLine(from), turn)) {
            return Manoeuvre{metres(onward), turn, metres(back)};
        }
        // A machine that can reverse drives in as far as it fits. A nearer place would not help it.
        if (canReverse(machine)) {
            break;
        }
    }
    return std::nullopt;
}

}  // namespace

Curve CornerWays::between(const Rig& rig, const Pose& from, const Pose& to, const JobContext& job) {
    const auto known = std::ranges::find_if(
        known_, [&](const Known& one) { return isSame(one.from, from) && isSame(one.to, to); });
    if (known != known_.end()) {
        return known->way;
    }
    Curve way = feasibleConnection(rig, from, to, {}, job);
    known_.push_back({from, to, way});
    return way;
}

std::vector<RoundedCorner> roundedCorners(const Curve& line, Length radius) {
    std::vector<RoundedCorner> corners;
    const auto isSharp = [&](const CurvePiece& piece) {
        return std::max(std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si())) >
               1.0 / (kCornerRadii * radius.si());
    };
    for (std::size_t i = 0; i < line.pieces.size();) {
        if (!isSharp(line.pieces[i])) {
            ++i;
            continue;
        }
        RoundedCorner corner{.firstPiece = i, .lastPiece = i};
        double turnRad = 0.0;
        double arcM = 0.0;
        for (; i < line.pieces.size(); ++i) {
            const CurvePiece& piece = line.pieces[i];
            if (!isSharp(piece) && piece.length.si() >= kSideStraightM) {
                break;
            }
            turnRad += 0.5 * (piece.curvature + piece.endCurvature).si() * piece.length.si();
            arcM += piece.length.si();
            if (isSharp(piece)) {
                corner.lastPiece = i;
            }
        }
        corner.turn = radians(turnRad);
        corner.place = 0.5 * (poseBefore(line, corner.firstPiece).position +
                              poseBefore(line, corner.lastPiece + 1).position);
        corner.radius = metres(arcM / std::max(1e-9, std::abs(turnRad)));
        if (std::abs(turnRad) >= kSmallestCornerRad && std::abs(turnRad) <= kLargestCornerRad) {
            corners.push_back(corner);
        }
    }
    return corners;
}

Area uncutCorner(const RoundedCorner& corner, Length width) {
    const double a = std::abs(corner.turn.si());
    const double r = corner.radius.si() + 0.5 * width.si();
    return squareMetres((std::tan(0.5 * a) - 0.5 * a) * r * r);
}

std::vector<PassStretch> withCorners(const Curve& closed, CornerMethod method, const AllowedAreas& drivable,
                                     const Machine& machine,
                                     const std::function<bool(const RoundedCorner&)>& wanted,
                                     CornerWays& ways, std::vector<RoundedCorner>& left,
                                     const JobContext& job) {
    const Curve line = fromAStraight(closed);
    std::vector<RoundedCorner> corners = roundedCorners(line, machine.minTurningRadius());
    std::vector<PassStretch> stretches{{.line = {.type = {}, .start = line.start, .pieces = {}}}};
    if (method == CornerMethod::Rounded) {
        stretches.back().line = line;
        left = std::move(corners);
        return stretches;
    }
    const RigidRoom working{drivable, machine, machine.workingFootprint(),
                            machine.operatingWidth() + machine.spec().tractor.length};
    const Rig rig{drivable, machine};
    std::size_t next = 0;
    const auto work = [&](const CurvePiece& piece) { stretches.back().line.pieces.push_back(piece); };
    for (const RoundedCorner& corner : corners) {
        const auto found = corner.firstPiece > 0 && wanted(corner)
                               ? manoeuvre(line, corner, method, working, rig, ways, job)
                               : std::nullopt;
        if (!found) {
            left.push_back(corner);
            continue;
        }
        for (; next < corner.firstPiece; ++next) {
            work(line.pieces[next]);
        }
        if (found->onward > metres(0.0)) {
            work({.length = found->onward, .curvature = {}});
        }
        stretches.push_back({.line = found->turn, .working = false});
        stretches.push_back({.line = {.type = {}, .start = found->turn.end(), .pieces = {}}});
        if (found->back > metres(0.0)) {
            work({.length = found->back, .curvature = {}});
        }
        next = corner.lastPiece + 1;
    }
    for (; next < line.pieces.size(); ++next) {
        work(line.pieces[next]);
    }
    std::erase_if(stretches, [](const PassStretch& stretch) { return stretch.line.pieces.empty(); });
    if (stretches.size() > 1 && stretches.front().working && stretches.back().working) {
        // The line closes here without a corner.
        Curve& across = stretches.front().line;
        const Curve& closing = stretches.back().line;
        across.start = closing.start;
        across.pieces.insert(across.pieces.begin(), closing.pieces.begin(), closing.pieces.end());
        stretches.pop_back();
    }
    return stretches;
}

}  // namespace furrow
