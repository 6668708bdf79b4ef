#include "planner/path/headland_order.h"

#include "planner/headland/smooth_ring.h"
#include "planner/turns/allowed_edges.h"
#include "planner/turns/connection.h"
#include "planner/turns/straight_turn.h"
#include "planner/turns/trailer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <ranges>
#include <tuple>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kMostStarts = 400;
// If none of these places allows a way, no other place does.
constexpr std::size_t kMostChecked = 150;
constexpr Length kCheckStep = metres(0.25);
// Ways of several moves are searched only where they may save that much, ...
constexpr Duration kWorthSearching = seconds(30.0);
// ... to so many places, this many widths apart.
constexpr std::size_t kMostSearched = 4;
constexpr double kWidthsApart = 2.0;
// A trailed implement comes into line within 3 of its own lengths after a bend.
constexpr double kLengthsIntoLine = 3.0;

/// A place at which a pass may start.
struct StartPlace {
    std::size_t stretch = 0;
    std::size_t piece = 0;
    Length way;  ///< along that piece
    Pose pose;
    Pose end;               ///< the end of the pass with this start
    bool reversed = false;  ///< a single stretch, driven in the other direction
};

/// The starts of a pass in stretches: the beginning of each stretch. In the other direction the nose is at
/// the place of the tail. It must fit there, and it swings differently in bends.
std::vector<StartPlace> startsOfStretches(const HeadlandPass& pass,
                                          const std::function<bool(const Curve&)>& fits) {
    std::vector<StartPlace> places;
    const std::size_t count = pass.stretches.size();
    places.reserve(count + 1);
    for (std::size_t s = 0; s < count; ++s) {
        places.push_back({.stretch = s,
                          .pose = pass.stretches[s].line.start,
                          .end = pass.stretches[(s + count - 1) % count].line.end()});
    }
    if (count == 1) {
        const Curve back = reversedLine(pass.stretches.front().line);
        if (fits(back)) {
            places.push_back({.pose = back.start, .end = back.end(), .reversed = true});
        }
    }
    return places;
}

/// A trailed implement has to be in line again at the end of a closed pass, `inLineAfter` after the last
/// bend.
std::vector<StartPlace> startPlaces(const HeadlandPass& pass, Length inLineAfter,
                                    const std::function<bool(const Curve&)>& fits) {
    if (!pass.closed) {
        return startsOfStretches(pass, fits);
    }
    const Length step = std::max(0.5 * pass.width, (1.0 / kMostStarts) * pass.length());
    std::vector<StartPlace> places;
    for (std::size_t s = 0; s < pass.stretches.size(); ++s) {
        const PassStretch& stretch = pass.stretches[s];
        Pose pose = stretch.line.start;
        for (std::size_t p = 0; p < stretch.line.pieces.size(); ++p) {
            const CurvePiece& piece = stretch.line.pieces[p];
            const bool isStraight = piece.curvature == Curvature{} && piece.endCurvature == Curvature{};
            Length way;
            if (inLineAfter > Length{}) {
                way = isStraight ? inLineAfter : piece.length;
            }
            for (; stretch.working && way < piece.length; way += step) {
                const Pose here = advanced(pose, piece, way);
                places.push_back({.stretch = s, .piece = p, .way = way, .pose = here, .end = here});
            }
            pose = advanced(pose, piece, piece.length);
        }
    }
    // If no straight is long enough, the pass may start anywhere.
    return places.empty() && inLineAfter > Length{} ? startPlaces(pass, Length{}, fits) : places;
}

/// The whole pass, from a place on it.
std::vector<Leg> legsFrom(const HeadlandPass& pass, const StartPlace& start) {
    if (!pass.closed) {
        std::vector<Leg> legs;
        legs.reserve(pass.stretches.size());
        for (std::size_t i = 0; i < pass.stretches.size(); ++i) {
            legs.push_back(legOf(pass, pass.stretches[(start.stretch + i) % pass.stretches.size()]));
        }
        if (start.reversed) {
            legs.front().line = reversedLine(legs.front().line);
        }
        return legs;
    }
    const PassStretch& first = pass.stretches[start.stretch];
    const CurvePiece& split = first.line.pieces[start.piece];
    PassStretch head{.line = {.type = {}, .start = start.pose, .pieces = {}}, .working = true};
    PassStretch tail{.line = {.type = {}, .start = first.line.start, .pieces = {}}, .working = true};
    const Curvature here = split.curvatureAt(start.way);
    head.line.pieces.push_back({split.length - start.way, here, split.endCurvature, split.gear});
    head.line.pieces.insert(head.line.pieces.end(),
                            first.line.pieces.begin() + static_cast<std::ptrdiff_t>(start.piece) + 1,
                            first.line.pieces.end());
    tail.line.pieces.assign(first.line.pieces.begin(),
                            first.line.pieces.begin() + static_cast<std::ptrdiff_t>(start.piece));
    if (start.way > metres(0.0)) {
        tail.line.pieces.push_back({start.way, split.curvature, here, split.gear});
    }
    if (pass.stretches.size() == 1) {
        // The line closes here without a change: one leg.
        head.line.pieces.insert(head.line.pieces.end(), tail.line.pieces.begin(), tail.line.pieces.end());
        return {legOf(pass, head)};
    }
    std::vector<Leg> legs{legOf(pass, head)};
    for (std::size_t i = 1; i < pass.stretches.size(); ++i) {
        legs.push_back(legOf(pass, pass.stretches[(start.stretch + i) % pass.stretches.size()]));
    }
    if (!tail.line.pieces.empty()) {
        legs.push_back(legOf(pass, tail));
    }
    return legs;
}

/// The boundary or obstacle around which each pass runs. A pass belongs to the nearest pass of the ring
/// outside it.
std::vector<std::size_t> families(const std::vector<HeadlandPass>& passes,
                                  const std::vector<std::vector<StartPlace>>& places) {
    std::vector<std::size_t> family(passes.size());
    for (std::size_t i = 0; i < passes.size(); ++i) {
        family[i] = i;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < i; ++k) {
            if (passes[k].ring + 1 != passes[i].ring || places[i].empty()) {
                continue;
            }
            for (const StartPlace& place : places[k]) {
                const double away = distance(place.pose.position, places[i].front().pose.position);
                if (away < nearest) {
                    nearest = away;
                    family[i] = family[k];
                }
            }
        }
    }
    return family;
}

/// Family after family, the one nearest to `from` first. In each family from outside in or inside out.
std::vector<std::size_t> sequence(const std::vector<HeadlandPass>& passes,
                                  const std::vector<std::vector<StartPlace>>& places, bool insideOut,
                                  Point from) {
    const std::vector<std::size_t> family = families(passes, places);
    std::vector<std::size_t> left(passes.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
        left[i] = i;
    }
    std::vector<std::size_t> order;
    while (!left.empty()) {
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t chosen = family[left.front()];
        for (const std::size_t i : left) {
            for (const StartPlace& place : places[i]) {
                if (const double away = distance(place.pose.position, from); away < nearest) {
                    nearest = away;
                    chosen = family[i];
                }
            }
        }
        std::vector<std::size_t> members;
        std::ranges::copy_if(left, std::back_inserter(members),
                             [&](std::size_t i) { return family[i] == chosen; });
        std::erase_if(left, [&](std::size_t i) { return family[i] == chosen; });
        std::ranges::stable_sort(members, {},
                                 [&](std::size_t i) { return insideOut ? -passes[i].ring : passes[i].ring; });
        order.insert(order.end(), members.begin(), members.end());
        if (!places[order.back()].empty()) {
            from = places[order.back()].front().pose.position;
        }
    }
    return order;
}

using RatedPlace = std::pair<Duration, std::size_t>;

/// Places by the time of their ways. A place is rated only once no other one can be nearer in time: no way is
/// quicker than a straight line.
class PlacesByTime {
public:
    /// @param fixed    the other end of all ways
    /// @param fastest  no way is driven faster
    PlacesByTime(const std::vector<StartPlace>& places, Point fixed, Speed fastest,
                 std::function<Duration(const StartPlace&)> rate)
        : places_{places}, rate_{std::move(rate)} {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double awayM =
                std::min(distance(places[i].pose.position, fixed), distance(places[i].end.position, fixed));
            queue_.push({kSurely * seconds(awayM / fastest.si()), false, i});
        }
    }

    bool empty() const { return queue_.empty(); }
    RatedPlace takeNext() {
        for (;;) {
            const auto [time, isRated, place] = queue_.top();
            queue_.pop();
            if (isRated) {
                return {time, place};
            }
            queue_.push({rate_(places_[place]), true, place});
        }
    }

private:
    static constexpr double kSurely = 1.0 - 1e-9;

    using Waiting = std::tuple<Duration, bool, std::size_t>;
    const std::vector<StartPlace>& places_;
    std::function<Duration(const StartPlace&)> rate_;
    std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> queue_;
};

/// Finds the best start of a closed pass.
class StartChooser {
public:
    StartChooser(const HeadlandDrive& drive, const Machine& machine, TurnPlanner* turn)
        : drive_{drive},
          machine_{machine},
          turn_{turn},
          fastest_{std::max(machine.spec().tractor.turningSpeed, machine.spec().tractor.reverseSpeed)},
          raised_{drive.drivable, machine, machine.turningFootprint(),
                  machine.turningWidth() + machine.spec().tractor.length} {}

    /// The place with the quickest way between pass and fixed pose that stays inside: a single curve, or
    /// several moves near by where that curve leads far round. If no way stays inside, the quickest one;
    /// without a pose, the first place.
    const StartPlace& best(const std::vector<StartPlace>& places, const std::optional<Pose>& fixed,
                           bool fixedIsNext) const {
        if (!fixed) {
            return places.front();
        }
        PlacesByTime inOrder{places, fixed->position, fastest_, [&](const StartPlace& place) {
                                 const Pose& from = fixedIsNext ? place.end : *fixed;
                                 const Pose& to = fixedIsNext ? *fixed : place.pose;
                                 return roughDuration(way(place, *fixed, fixedIsNext), from, to, machine_);
                             }};
        std::vector<RatedPlace> byTime;
        std::optional<RatedPlace> quickest;
        while (!quickest && byTime.size() < kMostChecked && !inOrder.empty()) {
            byTime.push_back(inOrder.takeNext());
            if (raised_.staysInside(way(places[byTime.back().second], *fixed, fixedIsNext), kCheckStep)) {
                quickest = byTime.back();
            }
        }
        if (quickest && drive_.searched) {
            quickest = quickestOf(*quickest, byTime, places, *fixed, fixedIsNext);
        }
        return places[quickest.value_or(byTime.front()).second];
    }

private:
    /// The place of the quickest single curve, or one with a way of several moves that is quicker. In free
    /// space no way is quicker.
    RatedPlace quickestOf(RatedPlace quickest, const std::vector<RatedPlace>& byTime,
                          const std::vector<StartPlace>& places, const Pose& fixed, bool fixedIsNext) const {
        std::vector<Point> tried;
        const auto isBeside = [&](Point place) {
            return std::ranges::any_of(tried, [&](Point other) {
                return distance(other, place) < kWidthsApart * machine_.operatingWidth().si();
            });
        };
        for (const auto& [time, i] : byTime) {
            if (time + kWorthSearching >= quickest.first || tried.size() == kMostSearched) {
                break;
            }
            if (isBeside(places[i].pose.position)) {
                continue;
            }
            tried.push_back(places[i].pose.position);
            const auto searched =
                fixedIsNext ? drive_.searched(places[i].end, fixed) : drive_.searched(fixed, places[i].pose);
            if (searched && *searched < quickest.first) {
                quickest = {*searched, i};
            }
        }
        return quickest;
    }

    Curve way(const StartPlace& place, const Pose& fixed, bool fixedIsNext) const {
        return fixedIsNext ? connection(place.end, fixed, machine_, turn_)
                           : connection(fixed, place.pose, machine_, turn_);
    }

    const HeadlandDrive& drive_;
    const Machine& machine_;
    TurnPlanner* turn_;
    Speed fastest_;  ///< on ways
    RigidRoom raised_;
};

}  // namespace

Leg legOf(const HeadlandPass& pass, const PassStretch& stretch) {
    return {.kind = stretch.working ? SegmentKind::HeadlandPass : SegmentKind::Turn,
            .number = stretch.working ? pass.ring + 1 : 0,
            .line = stretch.line,
            .implementDown = stretch.working};
}

std::vector<Leg> headlandLegs(const std::vector<HeadlandPass>& passes, const HeadlandDrive& drive,
                              const Machine& machine, TurnPlanner* turn) {
    const Implement& implement = machine.spec().implement;
    const Length inLineAfter =
        Trailer::of(machine) ? kLengthsIntoLine * (implement.hitchOffset - implement.offset) : Length{};
    const RigidRoom working{drive.drivable, machine, machine.workingFootprint(),
                            machine.workingFootprintWidth() + machine.spec().tractor.length};
    const auto fits = [&](const Curve& line) {
        return working.isInside(line.start) && working.staysInside(line, kCheckStep);
    };
    std::vector<std::vector<StartPlace>> places;
    places.reserve(passes.size());
    for (const HeadlandPass& pass : passes) {
        places.push_back(startPlaces(pass, inLineAfter, fits));
    }
    // The end that meets the swaths is fixed. From there the passes are lined up, backwards if the swaths
    // come after them.
    const bool backwards = drive.after.has_value();
    const std::optional<Pose> fixed = backwards ? drive.after : drive.before;
    // Lined up backwards, outside in begins with the innermost.
    const std::vector<std::size_t> order =
        sequence(passes, places, backwards != drive.insideOut, fixed ? fixed->position : Point{});
    const StartChooser chooser{drive, machine, turn};
    std::vector<std::vector<Leg>> lined;
    std::optional<Pose> met = fixed;
    for (const std::size_t i : order) {
        if (places[i].empty()) {
            continue;
        }
        const StartPlace& start = chooser.best(places[i], met, backwards);
        lined.push_back(legsFrom(passes[i], start));
        met = backwards ? start.pose : start.end;
    }
    if (backwards) {
        std::ranges::reverse(lined);
    }
    std::vector<Leg> legs;
    for (std::vector<Leg>& some : lined) {
        std::ranges::move(some, std::back_inserter(legs));
    }
    return legs;
}

}  // namespace furrow
