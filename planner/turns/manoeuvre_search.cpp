#include "planner/turns/manoeuvre_search.h"

#include "planner/geometry/tolerances.h"
#include "planner/turns/dubins.h"
#include "planner/turns/grid_distance.h"
#include "planner/turns/reeds_shepp.h"
#include "planner/turns/turn_method.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace furrow {

namespace {

// Turn of one move on full lock, in radians.
constexpr double kMoveRad = std::numbers::pi / 9.0;
constexpr int kHeadings = 36;
// In the open, straight moves are longer by this factor.
constexpr double kLongMove = 4.0;
// Longest straight move, as a share of the remaining way.
constexpr double kLongestShare = 0.3;
constexpr std::size_t kMostMoves = 3000;
// Following a trailed implement takes ten times as long.
constexpr std::size_t kMostMovesTrailed = 800;
constexpr std::size_t kMostMovesQuick = 200;
// Number of further moves for a quicker way after the first one was found.
constexpr std::size_t kMovesAfterFirst = 80;
constexpr std::size_t kMovesAfterFirstQuick = 20;
// Factors on the estimated way to the goal. They save moves and make the way slightly longer. The factor is
// larger from afar, where many ways are equally good.
constexpr double kGreed = 1.15;
constexpr double kGreedAfar = 2.0;
// From afar the goal is tried only at every eighth move; from near, at each move.
constexpr std::size_t kShotEvery = 8;
constexpr double kNearRadii = 8.0;
/// Range and resolution of the search. Far ways use a coarser grid.
struct Scope {
    double reach = 1.0;               ///< factor on the usual range
    double cellsAcross = 200.0;       ///< largest number of grid cells on the straight line to the goal
    std::size_t mostCells = 200'000;  ///< larger regions are not searched
    bool clear = false;               ///< excludes places where only the tractor gets through
};

constexpr Scope kNear{};
constexpr Scope kAfar{.reach = 4.0, .cellsAcross = 50.0, .clear = true};
// From one corner all round a large field into another.
constexpr Scope kAllRound{.reach = 4.0, .cellsAcross = 1000.0, .mostCells = 2'000'000, .clear = true};
constexpr double kInfinite = std::numeric_limits<double>::infinity();

// Beside an edge a machine escapes in steps of this length. Each step has the sharpest of these shares of its
// greatest curvature that keeps it inside. Its tail or nose then follows the edge.
constexpr double kEscapeStepM = 0.2;
constexpr int kMostEscapeSteps = 90;
constexpr double kEscapeShares[] = {1.0, 0.5, 0.25, 0.125, 0.06, 0.03, 0.015, 0.008, 0.0};
// After so many moves without a way the search looks whether any move leads to the goal from places this far
// from it. It looks at a few places, with these shares of a move: some goals are in corners that a machine
// gets into only by a hair's breadth.
constexpr std::size_t kMovesBeforeLook = 60;
constexpr double kAwayRadii = 2.0;
constexpr std::size_t kMostPlacesLookedAt = 40;
constexpr double kLookedAtShares[] = {1.0, 0.5, 0.25};
// Most ways are seen on the grid within as many cells. Before it looks at more, the search asks whether there
// is any.
constexpr std::size_t kCellsBeforeAsking = 1'000;
// It is free if it can turn by this angle on full lock.
constexpr double kFreeRad = 0.5;
// Ways to one place that differ by less take the same time.
constexpr double kSameTimeS = 1e-9;

/// A way out from beside an edge. A way in is the same, driven backwards in time.
struct Escape {
    std::vector<CurvePiece> pieces;
    Pose end;
};

std::vector<CurvePiece> backInTime(std::vector<CurvePiece> pieces) {
    std::ranges::reverse(pieces);
    for (CurvePiece& piece : pieces) {
        std::swap(piece.curvature, piece.endCurvature);
        piece.gear = piece.gear == Gear::Forward ? Gear::Reverse : Gear::Forward;
    }
    return pieces;
}

/// Most places that moves lead to are never gone on from. What is dear about a place is found out when the
/// search comes to it: the way in free space, and whether the machine stays inside on the move.
struct Node {
    enum class Standing : std::uint8_t {
        Unknown,
        Open,     ///< the move stays inside, and nothing before it led there as quickly
        Refused,  ///< the move leads outside, or is not the quickest
    };

    RigState state;  ///< the implement's heading once it stands
    std::size_t firstPiece = 0;
    std::size_t endPiece = 0;  ///< of the pieces that led to this node
    std::size_t before = 0;
    double timeS = 0.0;   ///< with every stretch weighted by the cost of its place
    double plainS = 0.0;  ///< the same without weights
    double gridWayM = 0.0;
    std::optional<double> freeWayM;
    FootprintRoom room;  ///< once moves start there
    Standing standing = Standing::Unknown;
};

/// The nodes in one place of the search, by number.
struct Reached {
    std::vector<std::size_t> open;
    std::vector<std::size_t> unknown;  ///< ascending
};

class Search {
public:
    Search(const Rig& rig, const Pose& from, const Pose& to, const TravelCost& travel, const JobContext& job,
           const Scope& scope)
        : rig_{rig},
          machine_{rig.machine()},
          to_{to},
          travel_{travel},
          job_{job},
          radiusM_{machine_.minTurningRadius().si()},
          reverses_{canReverse(machine_)},
          forwardMps_{machine_.turningSpeed().si()},
          reverseMps_{machine_.spec().tractor.reverseSpeed.si()},
          gearChangeS_{gearChangeDuration(machine_).si()},
          reach_{scope.reach},
          cellM_{std::max(std::clamp(0.4 * radiusM_, 0.6, 4.0),
                          distance(from.position, to.position) / scope.cellsAcross)},
          grid_{rig,
                travel_,
                to.position,
                from.position,
                cellM_,
                scope.clear ? 0.5 * machine_.turningWidth() : Length{},
                scope.mostCells} {
        nodes_.push_back({.state = Rig::inLine(from)});
        ends_.push_back({.pieces = {}, .end = to});
    }

    std::optional<Curve> run(SearchEffort effort, const Apart& apart) {
        mostWayM_ = reach_ * (200.0 + 60.0 * radiusM_ + 8.0 * distance(from().position, to_.position));
        if (apart && !grid_.soonReaches(from().position, mostWayM_, kCellsBeforeAsking) &&
            apart(from(), to_)) {
            isGoalShut_ = true;
            return std::nullopt;
        }
        const double byGrid = grid_.from(from().position, mostWayM_);
        greed_ = byGrid > kNearRadii * radiusM_ ? kGreedAfar : kGreed;
        auto out = escapes(from());
        auto in = escapes(to_);
        if (!out || !in) {
            return std::nullopt;
        }
        start(0);
        for (const Escape& escape : *out) {
            Node node{.state = Rig::inLine(escape.end), .firstPiece = pieces_.size()};
            for (const CurvePiece& piece : escape.pieces) {
                node.timeS += secondsOf(piece, nullptr);
                pieces_.push_back(piece);
            }
            node.endPiece = pieces_.size();
            node.plainS = node.timeS;
            nodes_.push_back(node);
            start(nodes_.size() - 1);
        }
        for (Escape& escape : *in) {
            ends_.push_back({.pieces = backInTime(std::move(escape.pieces)), .end = escape.end});
        }
        std::size_t movesLeft = effort == SearchEffort::Quick ? kMovesAfterFirstQuick : kMovesAfterFirst;
        const std::size_t most = effort == SearchEffort::Quick ? kMostMovesQuick
                                 : rig_.hasTrailer()           ? kMostMovesTrailed
                                                               : kMostMoves;
        for (std::size_t moves = 0; moves < most && findNext(); ++moves) {
            const auto [priority, index] = open_.top();
            // A way over dear places does not stop the search.
            const bool isGood = best_ && bestS_ < kDearWay * bestPlainS_;
            if (best_ && (priority >= bestS_ || (isGood && --movesLeft == 0))) {
                break;
            }
            if (moves == kMovesBeforeLook && !best_ && !canComeToGoal()) {
                isGoalShut_ = true;
                return std::nullopt;
            }
            if (moves % 64 == 0 && job_.stopRequested()) {
                return std::nullopt;
            }
            open_.pop();
            Node& node = nodes_[index];
            const auto isOvertaken = [&](std::size_t other) {
                return nodes_[other].timeS < node.timeS - kSameTimeS;
            };
            if (std::ranges::any_of(reached_[keyOf(node)].open, isOvertaken)) {
                continue;
            }
            node.room = rig_.roomAt(node.state);
            const bool isNear = *node.freeWayM < kNearRadii * radiusM_;
            if (isNear || moves % kShotEvery == 0) {
                shoot(index);
            }
            expand(index);
        }
        return best_;
    }

    double cellM() const { return cellM_; }
    bool isGridSpent() const { return grid_.isSpent(); }
    /// No move leads to the goal, or no way at all.
    bool isGoalShut() const { return isGoalShut_; }

private:
    using Key = std::uint64_t;

    Key keyOf(const Node& node) const { return keyOf(node.state.tractor, lastPiece(node)); }

    /// @param last  that led there; null at the start
    Key keyOf(const Pose& pose, const CurvePiece* last) const {
        const double cellM = 0.5 * kMoveRad * radiusM_;
        const auto x =
            static_cast<std::int64_t>(std::floor((pose.position.x - to_.position.x) / cellM)) & 0xFFFFFF;
        const auto y =
            static_cast<std::int64_t>(std::floor((pose.position.y - to_.position.y) / cellM)) & 0xFFFFFF;
        const double turns = pose.heading.si() / (2.0 * std::numbers::pi);
        const auto heading = static_cast<Key>((turns - std::floor(turns)) * kHeadings) % kHeadings;
        return static_cast<Key>(x) << 40U | static_cast<Key>(y) << 16U | heading << 1U |
               (last != nullptr && last->gear == Gear::Reverse ? 1U : 0U);
    }

    const CurvePiece* lastPiece(const Node& node) const {
        return node.endPiece > node.firstPiece ? &pieces_[node.endPiece - 1] : nullptr;
    }

    const Pose& from() const { return nodes_.front().state.tractor; }

    CurvePiece pieceOf(Gear gear, double curvature, double lengthM) const {
        return {.length = metres(lengthM),
                .curvature = Curvature::fromSi(curvature),
                .endCurvature = Curvature::fromSi(curvature),
                .gear = gear};
    }

    bool isFree(const RigState& state, Gear gear, double side) const {
        return rig_.driven(state, pieceOf(gear, side / radiusM_, kFreeRad * radiusM_)).has_value();
    }

    /// Ways out from beside an edge, in both gears and to both sides. An empty list if the machine can turn
    /// at once; no value if it cannot get out. Not searched for a trailed implement, which does not follow
    /// the same way back.
    std::optional<std::vector<Escape>> escapes(const Pose& pose) const {
        std::vector<Escape> found;
        const RigState start = Rig::inLine(pose);
        if (rig_.hasTrailer() || !reverses_) {
            return found;
        }
        for (const Gear gear : {Gear::Forward, Gear::Reverse}) {
            for (const double side : {-1.0, 1.0}) {
                if (isFree(start, gear, side)) {
                    return found;
                }
            }
        }
        for (const Gear gear : {Gear::Forward, Gear::Reverse}) {
            for (const double side : {-1.0, 1.0}) {
                if (auto escape = escapeTo(start, gear, side)) {
                    found.push_back(std::move(*escape));
                }
            }
        }
        return found.empty() && !canMove(start) ? std::nullopt : std::optional{std::move(found)};
    }

    /// Whether one of the search's own moves is possible.
    bool canMove(const RigState& state) const {
        for (const Gear gear : {Gear::Forward, Gear::Reverse}) {
            for (const double side : {-1.0, 0.0, 1.0}) {
                if (rig_.driven(state, pieceOf(gear, side / radiusM_, kMoveRad * radiusM_))) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Whether moves lead from farther away to the goal. They are driven backwards in time, which only a
    /// machine without a trailed implement can.
    bool canComeToGoal() const {
        if (rig_.hasTrailer()) {
            return true;
        }
        std::vector<RigState> places;
        std::priority_queue<std::pair<double, std::size_t>> farthestFirst;
        std::unordered_set<Key> seen;
        const auto add = [&](const RigState& state, const CurvePiece* piece) {
            if (seen.insert(keyOf(state.tractor, piece)).second) {
                farthestFirst.emplace(distance(state.tractor.position, to_.position), places.size());
                places.push_back(state);
            }
        };
        for (const Escape& end : ends_) {
            add(Rig::inLine(end.end), nullptr);
        }
        for (std::size_t looked = 0; !farthestFirst.empty(); ++looked) {
            const auto [awayM, index] = farthestFirst.top();
            if (looked == kMostPlacesLookedAt || awayM >= kAwayRadii * radiusM_) {
                return true;
            }
            farthestFirst.pop();
            const RigState place = places[index];
            const FootprintRoom room = rig_.roomAt(place);
            for (const Gear gear : {Gear::Reverse, Gear::Forward}) {
                if (gear == Gear::Forward && !reverses_) {
                    break;
                }
                for (const double curvature : {-1.0 / radiusM_, 0.0, 1.0 / radiusM_}) {
                    for (const double share : kLookedAtShares) {
                        const CurvePiece piece = pieceOf(gear, curvature, share * kMoveRad * radiusM_);
                        if (const auto next = rig_.driven(place, piece, metres(kContactM), room)) {
                            add(*next, &piece);
                        }
                    }
                }
            }
        }
        return false;
    }

    std::optional<Escape> escapeTo(RigState state, Gear gear, double side) const {
        Escape escape;
        for (int i = 0; i < kMostEscapeSteps; ++i) {
            if (i > 0 && isFree(state, gear, side)) {
                escape.end = state.tractor;
                return escape;
            }
            std::optional<RigState> next;
            for (const double share : kEscapeShares) {
                const CurvePiece piece = pieceOf(gear, side * share / radiusM_, kEscapeStepM);
                next = rig_.driven(state, piece);
                if (next) {
                    escape.pieces.push_back(piece);
                    break;
                }
            }
            if (!next) {
                return std::nullopt;
            }
            state = *next;
        }
        return std::nullopt;
    }

    double freeWayM(const Pose& pose) const {
        const Length radius = metres(radiusM_);
        return (reverses_ ? reedsSheppLength(pose, to_, radius) : dubinsLength(pose, to_, radius)).si();
    }

    double secondsOf(const CurvePiece& piece, const CurvePiece* before) const {
        const bool changes = before != nullptr && before->gear != piece.gear;
        const double speed = piece.gear == Gear::Forward ? forwardMps_ : reverseMps_;
        return piece.length.si() / speed + (changes ? gearChangeS_ : 0.0);
    }

    double costAlong(const Pose& from, const CurvePiece& piece) const {
        return meanCost(travel_, from, piece, metres(radiusM_));
    }

    /// A first guess of the time to the goal via a node: the way in free space, which is dear, is not in it
    /// before the node comes up.
    double priorityOf(const Node& node) const {
        const double leftM = std::max(node.freeWayM.value_or(0.0), node.gridWayM);
        return node.timeS + greed_ * leftM / forwardMps_;
    }

    /// One of the nodes that the search starts from.
    void start(std::size_t index) {
        Node& node = nodes_[index];
        node.gridWayM = grid_.from(node.state.tractor.position, mostWayM_);
        if (node.gridWayM == kInfinite) {
            return;
        }
        node.standing = Node::Standing::Open;
        reached_[keyOf(node)] = {.open = {index}, .unknown = {}};
        open_.push({priorityOf(node), index});
    }

    /// Takes nodes off the list until the next one stands, and is the next by its way in free space, too.
    /// False if there is none.
    bool findNext() {
        while (!open_.empty()) {
            const auto [priority, index] = open_.top();
            if (priority >= bestS_) {
                return true;
            }
            Node& node = nodes_[index];
            if (node.standing == Node::Standing::Unknown) {
                settle(reached_[keyOf(node)], node.timeS);
            }
            if (node.standing == Node::Standing::Open && node.freeWayM) {
                return true;
            }
            open_.pop();
            if (node.standing == Node::Standing::Open) {
                node.freeWayM = freeWayM(node.state.tractor);
                open_.push({priorityOf(node), index});
            }
        }
        return false;
    }

    /// Whether a node that stands, made before this one, was there as quickly.
    bool isBeaten(const Reached& place, std::size_t index, double timeS) const {
        return std::ranges::any_of(
            place.open, [&](std::size_t other) { return other < index && nodes_[other].timeS <= timeS; });
    }

    /// Finds out which of the nodes in a place stand, if they took at most `mostS`.
    void settle(Reached& place, double mostS) {
        std::erase_if(place.unknown, [&](std::size_t index) {
            Node& node = nodes_[index];
            if (node.timeS > mostS) {
                return false;
            }
            const Node& before = nodes_[node.before];
            const auto state =
                isBeaten(place, index, node.timeS)
                    ? std::nullopt
                    : rig_.driven(before.state, *lastPiece(node), metres(kContactM), before.room);
            node.standing = state ? Node::Standing::Open : Node::Standing::Refused;
            if (state) {
                node.state = *state;
                place.open.push_back(index);
            }
            return true;
        });
    }

    void expand(std::size_t index) {
        const Node node = nodes_[index];
        const std::optional<CurvePiece> last =
            lastPiece(node) != nullptr ? std::optional{*lastPiece(node)} : std::nullopt;
        const auto move = [&](Gear gear, double curvature, double lengthM) {
            const CurvePiece piece = pieceOf(gear, curvature, lengthM);
            const Pose end = advanced(node.state.tractor, piece, piece.length);
            const double plainS = secondsOf(piece, last ? &*last : nullptr);
            const double timeS = node.timeS + costAlong(node.state.tractor, piece) * plainS;
            const std::size_t number = nodes_.size();
            Reached& place = reached_[keyOf(end, &piece)];
            if (isBeaten(place, number, timeS)) {
                return;
            }
            // Not quicker than the way that was found, or no way on.
            const double gridWayM = grid_.from(end.position, mostWayM_);
            if (timeS + gridWayM / forwardMps_ >= bestS_) {
                return;
            }
            nodes_.push_back({.state = Rig::inLine(end),
                              .firstPiece = pieces_.size(),
                              .endPiece = pieces_.size() + 1,
                              .before = index,
                              .timeS = timeS,
                              .plainS = node.plainS + plainS,
                              .gridWayM = gridWayM});
            pieces_.push_back(piece);
            place.unknown.push_back(number);
            open_.push({priorityOf(nodes_.back()), number});
        };
        const double shortM = kMoveRad * radiusM_;
        for (const Gear gear : {Gear::Forward, Gear::Reverse}) {
            if (gear == Gear::Reverse && !reverses_) {
                break;
            }
            for (const double curvature : {-1.0 / radiusM_, 0.0, 1.0 / radiusM_}) {
                move(gear, curvature, shortM);
            }
        }
        // Straight moves grow with the remaining way. A way along a side of a large field then needs no more
        // moves than a way round a corner.
        const double leftM = grid_.from(node.state.tractor.position, mostWayM_);
        double longM = kLongMove * shortM;
        do {
            move(Gear::Forward, 0.0, longM);
            longM *= kLongMove;
        } while (longM < kLongestShare * leftM);
        // A long move in reverse, out of a lane that it came into.
        if (reverses_) {
            move(Gear::Reverse, 0.0, kLongMove * shortM);
        }
    }

    /// Tries the rest of the way as one curve.
    void shoot(std::size_t index) {
        const Node& node = nodes_[index];
        const auto attempt = [&](Curve rest, const Escape& end) {
            const std::size_t checked = rest.pieces.size();
            rest.pieces.insert(rest.pieces.end(), end.pieces.begin(), end.pieces.end());
            double timeS = node.timeS;
            double plainS = node.plainS;
            const CurvePiece* before = lastPiece(node);
            Pose pose = rest.start;
            for (const CurvePiece& piece : rest.pieces) {
                const double pieceS = secondsOf(piece, before);
                timeS += costAlong(pose, piece) * pieceS;
                plainS += pieceS;
                pose = advanced(pose, piece, piece.length);
                before = &piece;
            }
            if (timeS >= bestS_) {
                return;
            }
            // The way in along the edge has already been checked.
            const Curve open{
                .type = rest.type,
                .start = rest.start,
                .pieces = {rest.pieces.begin(), rest.pieces.begin() + static_cast<std::ptrdiff_t>(checked)}};
            if (rig_.driven(node.state, open, node.room)) {
                bestS_ = timeS;
                bestPlainS_ = plainS;
                best_ = joined(index, rest);
            }
        };
        const Length radius = metres(radiusM_);
        for (const Escape& end : ends_) {
            attempt(dubinsTurn(node.state.tractor, end.end, radius), end);
            if (reverses_) {
                attempt(reedsSheppTurn(node.state.tractor, end.end, radius), end);
            }
        }
    }

    Curve joined(std::size_t index, const Curve& rest) const {
        Curve turn{.type = kCombinedTurn, .start = nodes_.front().state.tractor, .pieces = {}};
        for (std::size_t i = index; i != 0; i = nodes_[i].before) {
            const auto first = pieces_.begin() + static_cast<std::ptrdiff_t>(nodes_[i].firstPiece);
            const auto end = pieces_.begin() + static_cast<std::ptrdiff_t>(nodes_[i].endPiece);
            turn.pieces.insert(turn.pieces.end(), std::make_reverse_iterator(end),
                               std::make_reverse_iterator(first));
        }
        std::ranges::reverse(turn.pieces);
        turn.pieces.insert(turn.pieces.end(), rest.pieces.begin(), rest.pieces.end());
        // Successive moves with equal gear and curvature become one.
        std::vector<CurvePiece> merged;
        for (const CurvePiece& piece : turn.pieces) {
            if (!merged.empty() && merged.back().gear == piece.gear &&
                merged.back().curvature == piece.curvature &&
                merged.back().endCurvature == piece.endCurvature && piece.curvature == piece.endCurvature) {
                merged.back().length = merged.back().length + piece.length;
            } else {
                merged.push_back(piece);
            }
        }
        turn.pieces = std::move(merged);
        return turn;
    }

    const Rig& rig_;
    const Machine& machine_;
    Pose to_;
    const TravelCost& travel_;
    const JobContext& job_;
    double radiusM_;
    bool reverses_;
    double forwardMps_;
    double reverseMps_;
    double gearChangeS_;
    double reach_;
    double cellM_;
    GridDistance grid_;
    std::vector<Escape> ends_;  ///< the goal itself and the ends of the ways in to it
    double mostWayM_ = 0.0;
    double greed_ = kGreed;
    std::vector<Node> nodes_;
    std::vector<CurvePiece> pieces_;
    std::unordered_map<Key, Reached> reached_;
    std::priority_queue<std::pair<double, std::size_t>, std::vector<std::pair<double, std::size_t>>,
                        std::greater<>>
        open_;
    std::optional<Curve> best_;
    double bestS_ = kInfinite;
    double bestPlainS_ = kInfinite;
    bool isGoalShut_ = false;
};

}  // namespace

std::optional<Curve> searchManoeuvre(const Rig& rig, const Pose& from, const Pose& to,
                                     const TravelCost& travel, const JobContext& job, SearchEffort effort,
                                     const Apart& apart) {
    Search near{rig, from, to, travel, job, kNear};
    auto way = near.run(effort, apart);
    if (way || effort != SearchEffort::Thorough || near.isGoalShut() || job.stopRequested()) {
        return way;
    }
    // The way may be long: round a bay of a large field, or round a neck too narrow for the implement.
    Search afar{rig, from, to, travel, job, kAfar};
    way = afar.run(effort, {});
    if (way || job.stopRequested()) {
        return way;
    }
    // Between places near each other both grids are the same, and so are the searches.
    Search allRound{rig, from, to, travel, job, kAllRound};
    return allRound.cellM() == afar.cellM() && !afar.isGridSpent() ? std::nullopt : allRound.run(effort, {});
}

}  // namespace furrow
