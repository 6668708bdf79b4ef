#include "planner/turns/best_feasible.h"

#include "planner/geometry/tolerances.h"
#include "planner/turns/connection.h"
#include "planner/turns/dubins.h"
#include "planner/turns/named_turns.h"
#include "planner/turns/reeds_shepp.h"
#include "planner/turns/straight_turn.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// Number of pieces of a forward curve.
constexpr std::size_t kCurvePieces = 3;
// A smaller increase of cost counts as equal.
constexpr double kNoDearer = 1.0005;

constexpr std::array kForward{&kDubinsMethod, &kOmegaMethod, &kPTurnMethod, &kUTurnMethod};
constexpr std::array kReversing{&kReedsSheppMethod, &kFishtailMethod, &kThreePointMethod};

struct Candidate {
    Curve turn;
    Duration time;
};

/// All turns between two poses, the quickest first.
std::vector<Candidate> candidates(const Pose& leaving, const Pose& arriving, const Machine& machine) {
    std::vector<Candidate> found;
    const auto add = [&](const Method<TurnPlanner>* method) {
        Curve turn = connection(leaving, arriving, machine, method->run);
        // A method that does not suit the poses returns another method's turn.
        if (turn.type == method->info.id || method == &kDubinsMethod) {
            const Duration time = roughDuration(turn, leaving, arriving, machine);
            found.push_back({std::move(turn), time});
        }
    };
    std::ranges::for_each(kForward, add);
    if (canReverse(machine)) {
        std::ranges::for_each(kReversing, add);
    }
    if (canTurnOnTheSpot(machine)) {
        add(&kStraightMethod);
    }
    std::ranges::stable_sort(found, {}, &Candidate::time);
    return found;
}

Curve runBestFeasible(const Pose& from, const Pose& to, const Machine& machine) {
    Curve quickest = dubinsTurn(from, to, machine.minTurningRadius());
    Duration time = roughDuration(quickest, machine);
    const auto take = [&](Curve other) {
        const Duration takes = roughDuration(other, from, to, machine);
        if (takes < time) {
            time = takes;
            quickest = std::move(other);
        }
    };
    if (canReverse(machine)) {
        for (const auto* method : kReversing) {
            take(method->run(from, to, machine));
        }
    }
    if (canTurnOnTheSpot(machine)) {
        take(straightTurn(from, to));
    }
    return quickest;
}

/// Whether a way fits between two poses, with what it turns on the spot at its ends.
bool fits(const Curve& way, const Rig& rig, const Pose& leaving, const Pose& arriving) {
    const auto mayTurn = [&](const Pose& from, Angle to) {
        return rig.mayTurnOnTheSpot(from, wrappedAngle(to - from.heading));
    };
    return rig.driven(Rig::inLine(leaving), way).has_value() &&
           (way.type != kStraightMethod.info.id ||
            (mayTurn(leaving, way.start.heading) && mayTurn(way.end(), arriving.heading)));
}

/// The mean cost of the places of its metres.
double weightOf(const Curve& turn, const Machine& machine, const TravelCost& travel) {
    double cost = 0.0;
    Pose pose = turn.start;
    double wayM = 0.0;
    for (const CurvePiece& piece : turn.pieces) {
        cost += piece.length.si() * meanCost(travel, pose, piece, machine.minTurningRadius());
        wayM += piece.length.si();
        pose = advanced(pose, piece, piece.length);
    }
    return wayM > 0.0 ? cost / wayM : 1.0;
}

double costS(const Curve& turn, const Machine& machine, const TravelCost& travel) {
    return weightOf(turn, machine, travel) * roughDuration(turn, machine).si();
}

/// Whether to search another way.
bool isDear(const Curve& turn, const Machine& machine, const TravelCost& travel) {
    return travel && weightOf(turn, machine, travel) >= kDearWay;
}

/// The same way, with the pieces in [from, to) replaced by one forward curve.
Curve withOneCurve(const Curve& way, std::size_t from, std::size_t to, Length radius) {
    Pose begins = way.start;
    for (std::size_t i = 0; i < from; ++i) {
        begins = advanced(begins, way.pieces[i], way.pieces[i].length);
    }
    Pose ends = begins;
    for (std::size_t i = from; i < to; ++i) {
        ends = advanced(ends, way.pieces[i], way.pieces[i].length);
    }
    const auto at = [&](std::size_t i) { return way.pieces.begin() + static_cast<std::ptrdiff_t>(i); };
    Curve other{.type = way.type, .start = way.start, .pieces = {way.pieces.begin(), at(from)}};
    const Curve curve = dubinsTurn(begins, ends, radius);
    other.pieces.insert(other.pieces.end(), curve.pieces.begin(), curve.pieces.end());
    other.pieces.insert(other.pieces.end(), at(to), way.pieces.end());
    return other;
}

/// Removes bends as long as the way fits and costs no more, longest stretches first. A search turns in steps,
/// so its way along an edge goes to and fro, and bends are driven slowly.
Curve straightened(Curve way, const Rig& rig, const TravelCost& travel, const JobContext& job) {
    const Machine& machine = rig.machine();
    double cost = costS(way, machine, travel);
    for (std::size_t from = 0; from < way.pieces.size() && !job.stopRequested(); ++from) {
        for (std::size_t to = way.pieces.size(); to > from + kCurvePieces; --to) {
            Curve other = withOneCurve(way, from, to, machine.minTurningRadius());
            const double otherCost = costS(other, machine, travel);
            if (otherCost <= kNoDearer * cost && rig.driven(Rig::inLine(other.start), other)) {
                way = std::move(other);
                cost = std::min(cost, otherCost);
                break;
            }
        }
    }
    return way;
}

/// The searched way, with the straight that the implement needs before it is lowered, if that fits.
std::optional<Curve> searched(const Rig& rig, const Pose& leaving, const Pose& arriving,
                              const TravelCost& travel, const JobContext& job, SearchEffort effort,
                              const Apart& apart) {
    if (effort == SearchEffort::None) {
        return std::nullopt;
    }
    const Length runIn = rig.machine().runIn();
    const Pose before{.position = arriving.position - runIn.si() * direction(arriving.heading.si()),
                      .heading = arriving.heading};
    if (rig.outsideM(Rig::inLine(leaving)) > kContactM || rig.outsideM(Rig::inLine(before)) > kContactM) {
        return std::nullopt;
    }
    auto way = searchManoeuvre(rig, leaving, before, travel, job, effort, apart);
    if (way && travel) {
        way = straightened(std::move(*way), rig, travel, job);
    }
    if (way && runIn > metres(0.0)) {
        way->pieces.push_back({.length = runIn, .curvature = {}});
    }
    return way;
}

std::optional<Curve> quickestThatFits(const Rig& rig, const Pose& leaving, const Pose& arriving,
                                      const Machine& machine) {
    std::vector<Candidate> turns = candidates(leaving, arriving, machine);
    const auto found = std::ranges::find_if(
        turns, [&](const Candidate& candidate) { return fits(candidate.turn, rig, leaving, arriving); });
    return found != turns.end() ? std::optional{std::move(found->turn)} : std::nullopt;
}

}  // namespace

std::optional<Curve> fittingConnection(const Rig& rig, const Pose& leaving, const Pose& arriving,
                                       const TravelCost& travel, const JobContext& job, SearchEffort effort,
                                       const StraightWays* straights, const Apart& apart) {
    const Machine& machine = rig.machine();
    std::optional<Curve> turn = quickestThatFits(rig, leaving, arriving, rig.steeredMachine());
    if (!turn) {
        turn = quickestThatFits(rig, leaving, arriving, machine);
    }
    if (turn && !isDear(*turn, machine, travel)) {
        return turn;
    }
    const auto takesS = [&](const Curve& line) {
        return weightOf(line, machine, travel) * roughDuration(line, leaving, arriving, machine).si();
    };
    const auto take = [&](std::optional<Curve> other) {
        if (other && (!turn || takesS(*other) < takesS(*turn))) {
            turn = std::move(other);
        }
    };
    if (straights != nullptr) {
        take(straights->between(leaving, arriving, travel, job));
    }
    take(searched(rig, leaving, arriving, travel, job, effort, apart));
    return turn;
}

std::optional<Curve> fittingTurn(const Rig& rig, const Pose& leaving, const Pose& arriving,
                                 const TravelCost& travel, const Method<TurnPlanner>& kind) {
    for (const Machine* const machine : {&rig.steeredMachine(), &rig.machine()}) {
        Curve turn = connection(leaving, arriving, *machine, kind.run);
        if (turn.type == kind.info.id && !isDear(turn, *machine, travel) &&
            fits(turn, rig, leaving, arriving)) {
            return turn;
        }
    }
    return std::nullopt;
}

Curve feasibleConnection(const Rig& rig, const Pose& leaving, const Pose& arriving, const TravelCost& travel,
                         const JobContext& job) {
    auto way = fittingConnection(rig, leaving, arriving, travel, job);
    return way ? std::move(*way) : std::move(candidates(leaving, arriving, rig.machine()).front().turn);
}

const Method<TurnPlanner> kBestFeasibleMethod{
    .info = {.id = "best-feasible",
             .name = "Best that fits",
             .description =
                 "The quickest turn of any kind that stays inside the field, in several moves where it must.",
             .parameters = {}},
    .run = runBestFeasible,
    .traits = {.isAnyKind = true}};

}  // namespace furrow
