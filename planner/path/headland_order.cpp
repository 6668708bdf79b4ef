#include "planner/path/headland_order.h"

#include "planner/geometry/tolerances.h"
#include "planner/headland/smooth_ring.h"
#include "planner/turns/allowed_edges.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/connection.h"
#include "planner/turns/straight_turn.h"
#include "planner/turns/trailer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kMostStarts = 400;
// If none of these places allows a way, no other place does.
constexpr std::size_t kMostChecked = 150;
constexpr std::size_t kMostPlacesTried = 5;
// Places of a short pass whose time is estimated in free space, in each direction, and those of them for
// which ways are searched.
constexpr std::size_t kMostPlacesEstimated = 12;
constexpr std::size_t kMostPlacesSearched = 3;
// Where no way leads to so many short passes, none is searched to the others: each takes some tenths of a
// second.
constexpr std::size_t kMostRefused = 25;
constexpr Length kCheckStep = metres(0.25);
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

Leg legOf(const HeadlandPass& pass, const PassStretch& stretch) {
    return {.kind = stretch.working ? SegmentKind::HeadlandPass : SegmentKind::Turn,
            .number = stretch.working ? pass.ring + 1 : 0,
            .line = stretch.line,
            .implementDown = stretch.working};
}

/// The whole pass, from a place on it.
std::vector<Leg> legsFrom(const HeadlandPass& pass, const StartPlace& start) {
    if (!pass.closed) {
        std::vector<Leg> legs;
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

/// Finds the best start of a closed pass.
class StartChooser {
public:
    StartChooser(const AllowedAreas& drivable, const Machine& machine, TurnPlanner* turn)
        : machine_{machine},
          turn_{turn},
          raised_{drivable, machine, machine.turningFootprint(),
                  machine.turningWidth() + machine.spec().tractor.length} {}

    /// The place with the quickest way between pass and fixed pose that stays inside. If no way stays inside,
    /// the quickest one; without a pose, the first place.
    const StartPlace& best(const std::vector<StartPlace>& places, const std::optional<Pose>& fixed,
                           bool fixedIsNext) const {
        if (!fixed) {
            return places.front();
        }
        std::vector<std::pair<Duration, std::size_t>> byTime;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const Curve between = way(places[i], *fixed, fixedIsNext);
            const Pose& from = fixedIsNext ? places[i].end : *fixed;
            const Pose& to = fixedIsNext ? *fixed : places[i].pose;
            byTime.emplace_back(roughDuration(between, from, to, machine_), i);
        }
        std::ranges::sort(byTime);
        for (const auto& [time, i] : byTime | std::views::take(kMostChecked)) {
            if (raised_.staysInside(way(places[i], *fixed, fixedIsNext), kCheckStep)) {
                return places[i];
            }
        }
        return places[byTime.front().second];
    }

private:
    Curve way(const StartPlace& place, const Pose& fixed, bool fixedIsNext) const {
        return fixedIsNext ? connection(place.end, fixed, machine_, turn_)
                           : connection(fixed, place.pose, machine_, turn_);
    }

    const Machine& machine_;
    TurnPlanner* turn_;
    RigidRoom raised_;
};

/// The gaps between legs, as the leg that follows, with the shortest straight detours to a pass; nearest
/// first.
std::vector<std::size_t> gapsBeside(const Pose& start, const Pose& end, const std::vector<Leg>& legs,
                                    const std::vector<Pose>& ends, std::size_t most) {
    std::vector<std::pair<double, std::size_t>> gaps;
    for (std::size_t i = 0; i <= legs.size(); ++i) {
        const double toM = i > 0 ? distance(ends[i - 1].position, start.position) : 0.0;
        const double onM = i < legs.size() ? distance(end.position, legs[i].line.start.position) : 0.0;
        const double directM =
            i > 0 && i < legs.size() ? distance(ends[i - 1].position, legs[i].line.start.position) : 0.0;
        // Legs that follow on each other without a way between are one pass.
        if (i == 0 || i == legs.size() || directM > kMeetM) {
            gaps.emplace_back(toM + onM - directM, i);
        }
    }
    const std::size_t count = std::min(most, gaps.size());
    std::ranges::partial_sort(gaps, gaps.begin() + static_cast<std::ptrdiff_t>(count));
    gaps.resize(count);
    std::vector<std::size_t> before;
    std::ranges::copy(gaps | std::views::values, std::back_inserter(before));
    return before;
}

/// Places short passes between legs, one after the other.
class PassPlacing {
public:
    PassPlacing(std::vector<Leg> legs, RememberedWays& ways, const Machine& machine, const JobContext& job)
        : legs_{std::move(legs)}, ends_{endsOf(legs_)}, ways_{ways}, machine_{machine}, job_{job} {}

    /// False where no way leads to it or on from it.
    bool add(const HeadlandPass& pass) {
        const auto place = quickestPlace(pass.stretches.front());
        if (!place) {
            return false;
        }
        put(pass, *place);
        return true;
    }

    const std::vector<HeadlandPass>& passes() const { return passes_; }
    std::vector<Leg> legs() && { return std::move(legs_); }

private:
    struct Place {
        std::size_t before = 0;  ///< this leg
        Curve line;
    };

    void put(HeadlandPass pass, const Place& place) {
        PassStretch& stretch = pass.stretches.front();
        stretch.line = place.line;
        stretch.otherWay.reset();
        const auto before = static_cast<std::ptrdiff_t>(place.before);
        legs_.insert(legs_.begin() + before, legOf(pass, stretch));
        ends_.insert(ends_.begin() + before, place.line.end());
        passes_.push_back(std::move(pass));
    }

    /// Of the gaps near it and both directions, by the time that it adds. In free space ways are no slower,
    /// so none is searched that cannot be the quickest.
    std::optional<Place> quickestPlace(const PassStretch& stretch) const {
        struct Option {
            Duration atLeast;
            std::size_t before = 0;
            const Curve* line = nullptr;
            Pose end;
        };
        std::vector<Option> options;
        const auto addOptions = [&](const Curve& line) {
            const Pose end = line.end();
            for (const std::size_t i : gapsBeside(line.start, end, legs_, ends_, kMostPlacesEstimated)) {
                options.push_back({added(i, line.start, end,
                                         [this](const Pose& leaving, const Pose& arriving) {
                                             return std::optional{inFreeSpace(leaving, arriving)};
                                         })
                                       .value(),
                                   i, &line, end});
            }
        };
        addOptions(stretch.line);
        if (stretch.otherWay) {
            addOptions(*stretch.otherWay);
        }
        std::ranges::stable_sort(options, {}, &Option::atLeast);
        std::optional<Place> quickest;
        Duration least;
        std::size_t tried = 0;
        for (const Option& option : options) {
            if ((quickest && option.atLeast >= least) || tried == kMostPlacesSearched ||
                job_.stopRequested()) {
                break;
            }
            ++tried;
            const auto time = added(
                option.before, option.line->start, option.end,
                [this](const Pose& leaving, const Pose& arriving) { return inTheField(leaving, arriving); });
            if (time && (!quickest || *time < least)) {
                least = *time;
                quickest = Place{.before = option.before, .line = *option.line};
            }
        }
        return quickest;
    }

    /// The time that a pass adds between two legs, with its ways there and on; without that for its own line,
    /// which is the same in all places.
    template <class Time>
    std::optional<Duration> added(std::size_t before, const Pose& start, const Pose& end,
                                  const Time& time) const {
        const bool follows = before > 0;
        const bool leads = before < legs_.size();
        const auto there = follows ? time(ends_[before - 1], start) : std::optional{Duration{}};
        const auto on = there && leads ? time(end, legs_[before].line.start) : std::optional{Duration{}};
        if (!there || !on) {
            return std::nullopt;
        }
        const auto direct = follows && leads ? inTheField(ends_[before - 1], legs_[before].line.start)
                                             : std::optional{Duration{}};
        return *there + *on - direct.value_or(Duration{});
    }

    Duration inFreeSpace(const Pose& leaving, const Pose& arriving) const {
        return roughDuration(connection(leaving, arriving, machine_, kBestFeasibleMethod.run), leaving,
                             arriving, machine_);
    }
    std::optional<Duration> inTheField(const Pose& leaving, const Pose& arriving) const {
        return ways_(leaving, arriving, job_, SearchEffort::Quick).transform([&](const Curve& way) {
            return roughDuration(way, leaving, arriving, machine_);
        });
    }

    std::vector<Leg> legs_;
    std::vector<Pose> ends_;
    std::vector<HeadlandPass> passes_;
    RememberedWays& ways_;
    const Machine& machine_;
    const JobContext& job_;
};

}  // namespace

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
    const StartChooser chooser{drive.drivable, machine, turn};
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

std::vector<Pose> endsOf(const std::vector<Leg>& legs) {
    std::vector<Pose> ends;
    ends.reserve(legs.size());
    std::ranges::transform(legs, std::back_inserter(ends), [](const Leg& leg) { return leg.line.end(); });
    return ends;
}

PassAccess accessTo(const Curve& line, const std::vector<Leg>& legs, const std::vector<Pose>& ends,
                    RememberedWays& ways, const JobContext& job) {
    const Pose end = line.end();
    const auto leads = [&](const Pose& leaving, const Pose& arriving) {
        return !job.stopRequested() && ways(leaving, arriving, job, SearchEffort::Quick).has_value();
    };
    PassAccess access = PassAccess::NoWayIn;
    for (const std::size_t i : gapsBeside(line.start, end, legs, ends, kMostPlacesTried)) {
        if (i > 0 && !leads(ends[i - 1], line.start)) {
            continue;
        }
        if (i == legs.size() || leads(end, legs[i].line.start)) {
            return PassAccess::There;
        }
        access = PassAccess::NoWayOut;
    }
    return access;
}

FinishedLegs withFinishingPasses(std::vector<Leg> given, const std::vector<HeadlandPass>& passes,
                                 RememberedWays& ways, const Machine& machine, const JobContext& job) {
    FinishedLegs finished{.legs = {}, .put = {}, .refused = {}};
    PassPlacing placing{std::move(given), ways, machine, job};
    for (const HeadlandPass& pass : passes) {
        if (finished.refused.size() >= kMostRefused || !placing.add(pass)) {
            finished.refused.push_back(pass);
        }
    }
    finished.put = placing.passes();
    finished.legs = std::move(placing).legs();
    return finished;
}

}  // namespace furrow
