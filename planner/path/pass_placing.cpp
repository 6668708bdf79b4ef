#include "planner/path/pass_placing.h"

#include "planner/geometry/tolerances.h"
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
