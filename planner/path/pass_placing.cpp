#include "planner/path/pass_placing.h"

#include "planner/geometry/tolerances.h"
#include "planner/headland/smooth_ring.h"
#include "planner/path/headland_order.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/connection.h"
#include "planner/turns/straight_turn.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <ranges>
#include <utility>

namespace furrow {

namespace {

// If none of these places near a pass allows a way, no other place does.
constexpr std::size_t kMostPlacesTried = 5;
// Places of a short pass whose time is estimated in free space, in each direction, and those of them for
// which ways are searched.
constexpr std::size_t kMostPlacesEstimated = 12;
constexpr std::size_t kMostPlacesSearched = 3;
// Where no way leads to so many short passes, none is searched to the others: each takes some tenths of a
// second.
constexpr std::size_t kMostRefused = 25;
// Longer passes keep their place in the headland.
constexpr Length kShortPass = metres(40.0);
// A short pass is moved where that saves so much.
constexpr Duration kWorthMoving = seconds(15.0);

/// The gaps between legs, as the leg that follows, with the shortest straight detours to a pass; nearest
/// first.
std::vector<std::size_t> gapsBeside(const Pose& start, const Pose& end, const std::vector<Leg>& legs,
                                    const std::vector<Pose>& ends, std::size_t most) {
    std::vector<std::pair<double, std::size_t>> gaps;
    // Nothing comes before the way in at a gate, or after the way out.
    const auto isGateWay = [](const Leg& leg) { return leg.kind == SegmentKind::Transfer; };
    const std::size_t first = !legs.empty() && isGateWay(legs.front()) ? 1 : 0;
    const std::size_t last = !legs.empty() && isGateWay(legs.back()) ? legs.size() - 1 : legs.size();
    for (std::size_t i = first; i <= last; ++i) {
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
    bool add(HeadlandPass pass) {
        PassStretch& stretch = pass.stretches.front();
        auto place = quickestPlace(stretch);
        if (!place) {
            return false;
        }
        stretch.line = place->line;
        stretch.otherWay.reset();
        put(legOf(pass, stretch), *place);
        passes_.push_back(std::move(pass));
        return true;
    }

    /// Moves short headland passes to where they take much less time.
    void moveShort(const Rig& lowered) {
        for (std::size_t i = 1; i + 1 < legs_.size();) {
            const auto place = isAloneAndShort(i) ? moved(i, lowered) : std::nullopt;
            // If it went on, the leg after it is here now.
            if (!place || place->before <= i) {
                ++i;
            }
        }
    }

    const std::vector<HeadlandPass>& passes() const { return passes_; }
    std::vector<Leg> legs() && { return std::move(legs_); }

private:
    struct Place {
        std::size_t before = 0;  ///< this leg
        Curve line;
        Duration added;
    };

    void put(Leg leg, const Place& place) {
        const auto before = static_cast<std::ptrdiff_t>(place.before);
        ends_.insert(ends_.begin() + before, place.line.end());
        leg.line = place.line;
        legs_.insert(legs_.begin() + before, std::move(leg));
    }

    Leg takeOut(std::size_t i) {
        Leg leg = std::move(legs_[i]);
        legs_.erase(legs_.begin() + static_cast<std::ptrdiff_t>(i));
        ends_.erase(ends_.begin() + static_cast<std::ptrdiff_t>(i));
        return leg;
    }

    /// Of one stretch, with ways before and behind it.
    bool isAloneAndShort(std::size_t i) const {
        const Leg& leg = legs_[i];
        return leg.kind == SegmentKind::HeadlandPass && leg.line.length() < kShortPass &&
               distance(ends_[i - 1].position, leg.line.start.position) > kMeetM &&
               distance(ends_[i].position, legs_[i + 1].line.start.position) > kMeetM;
    }

    /// The time that a leg adds between the legs beside it, if that is much.
    std::optional<Duration> muchAdded(std::size_t i) const {
        const Pose& before = ends_[i - 1];
        const Pose& after = legs_[i + 1].line.start;
        const auto there = inTheField(before, legs_[i].line.start, SearchEffort::Thorough);
        const auto on = there ? inTheField(ends_[i], after, SearchEffort::Thorough) : std::nullopt;
        // In free space the way without it is no slower.
        if (!on || *there + *on - inFreeSpace(before, after) < kWorthMoving) {
            return std::nullopt;
        }
        return inTheField(before, after).and_then([&](Duration direct) {
            const Duration added = *there + *on - direct;
            return added < kWorthMoving ? std::nullopt : std::optional{added};
        });
    }

    /// Moves a leg to another place, or turns it round, if that saves much. Its place then.
    std::optional<Place> moved(std::size_t i, const Rig& lowered) {
        const auto added = muchAdded(i);
        if (!added) {
            return std::nullopt;
        }
        const Place old{.before = i, .line = legs_[i].line, .added = *added};
        PassStretch stretch{.line = old.line};
        // The nose is at the place of the tail, so it must be tested.
        Curve back = reversedLine(old.line);
        if (lowered.driven(Rig::inLine(back.start), back)) {
            stretch.otherWay = std::move(back);
        }
        Leg leg = takeOut(i);
        auto place = quickestPlace(stretch);
        if (place && place->added + kWorthMoving > *added) {
            place.reset();
        }
        put(std::move(leg), place.value_or(old));
        return place;
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
                quickest = Place{.before = option.before, .line = *option.line, .added = *time};
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
    std::optional<Duration> inTheField(const Pose& leaving, const Pose& arriving,
                                       SearchEffort effort = SearchEffort::Quick) const {
        return ways_(leaving, arriving, job_, effort).transform([&](const Curve& way) {
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

bool isShortPass(const HeadlandPass& pass) {
    return !pass.closed && pass.stretches.size() == 1 && pass.length() < kShortPass;
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

std::vector<Leg> withShortPassesMoved(std::vector<Leg> legs, RememberedWays& ways, const Rig& lowered,
                                      const JobContext& job) {
    PassPlacing placing{std::move(legs), ways, lowered.machine(), job};
    placing.moveShort(lowered);
    return std::move(placing).legs();
}

PlacedPasses withPassesBetween(std::vector<Leg> given, const std::vector<HeadlandPass>& passes,
                               RememberedWays& ways, const Machine& machine, const JobContext& job) {
    PlacedPasses finished{.legs = {}, .put = {}, .refused = {}};
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
