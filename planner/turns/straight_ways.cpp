#include "planner/turns/straight_ways.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/simplify.h"
#include "planner/geometry/tolerances.h"
#include "planner/turns/manoeuvre_search.h"
#include "planner/turns/rig_parts.h"
#include "planner/turns/straight_turn.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace furrow {

namespace {

// Of an area with more corners only the more important ones are looked at, and of one with far more none:
// each search looks at each.
constexpr std::size_t kManyCorners = 300;
constexpr std::size_t kMostCorners = 2000;
constexpr int kMostRounds = 3;
// The arc round a corner is drawn to this share of the machine's reach.
constexpr double kArcShare = 0.1;
constexpr double kCoarser = 2.0;
constexpr std::size_t kMostTested = 4000;
// After so many the search looks whether any straight leads to the end. Most ends that are not found have
// none: they lie beside an edge, where the machine cannot turn.
constexpr std::size_t kTestedBeforeLook = 10;

/// Where the machine may turn by any angle.
Result<MultiPolygon> turningArea(const AllowedAreas& areas, const Machine& machine, const JobContext& job) {
    const auto within = [&](const MultiPolygon& area, Length reach) {
        return eroded(area, reach, kArcShare * reach, job);
    };
    const TurningReach reach = turningReach(machine);
    if (!areas.hasOverhang()) {
        return within(areas.tractor(), reach.whole);
    }
    return within(areas.tractor(), reach.tractor).and_then([&](const MultiPolygon& forTractor) {
        return within(areas.implement(), reach.whole).and_then([&](const MultiPolygon& forImplement) {
            return intersection(forTractor, forImplement, job);
        });
    });
}

/// The corners of an area round which shortest ways bend: those that point into it.
void addCorners(const Ring& ring, std::vector<Point>& corners) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point before = ring[(i + ring.size() - 1) % ring.size()];
        const Point after = ring[(i + 1) % ring.size()];
        // Rings have their area on the left.
        if (cross(ring[i] - before, after - ring[i]) < 0.0) {
            corners.push_back(ring[i]);
        }
    }
}

std::vector<Point> cornersOf(const MultiPolygon& area, Length tolerance) {
    std::vector<Point> corners;
    for (const Polygon& polygon : area) {
        addCorners(simplifiedRing(polygon.outer, tolerance), corners);
        for (const Ring& hole : polygon.holes) {
            addCorners(simplifiedRing(hole, tolerance), corners);
        }
    }
    return corners;
}

Angle headingOf(Point from, Point to) {
    const Point way = to - from;
    return radians(std::atan2(way.y, way.x));
}

}  // namespace

StraightWays::StraightWays(const AllowedAreas& areas, const Rig& rig, const JobContext& job) : rig_{rig} {
    if (!canTurnOnTheSpot(rig.machine())) {
        return;
    }
    if (const auto area = turningArea(areas, rig.machine(), job)) {
        Length tolerance = kArcShare * turningReach(rig.machine()).whole;
        corners_ = cornersOf(*area, tolerance);
        // Every hole keeps some corners.
        for (int round = 0; corners_.size() > kManyCorners && round < kMostRounds; ++round) {
            tolerance = kCoarser * tolerance;
            corners_ = cornersOf(*area, tolerance);
        }
        if (corners_.size() > kMostCorners) {
            corners_.clear();
        }
    }
    fits_ = std::vector<std::atomic<Fit>>(corners_.size() * corners_.size());
}

bool StraightWays::leads(Point from, Point to) const {
    const CurvePiece straight{.length = metres(distance(from, to)), .curvature = {}};
    return rig_.driven(Rig::inLine({.position = from, .heading = headingOf(from, to)}), straight).has_value();
}

bool StraightWays::leadsBetweenCorners(std::size_t from, std::size_t to) const {
    std::atomic<Fit>& known = fits_[from * corners_.size() + to];
    Fit fit = known.load(std::memory_order_relaxed);
    if (fit == Fit::Unknown) {
        fit = leads(corners_[from], corners_[to]) ? Fit::Yes : Fit::No;
        known.store(fit, std::memory_order_relaxed);
    }
    return fit == Fit::Yes;
}

/// One search. Places are the corners, then the end and the start.
class StraightSearch {
public:
    StraightSearch(const StraightWays& ways, const Pose& leaving, const Pose& arriving,
                   const TravelCost& travel)
        : ways_{ways},
          machine_{ways.rig_.machine()},
          leaving_{leaving},
          arriving_{arriving},
          travel_{travel},
          end_{ways.corners_.size()},
          begin_{end_ + 1},
          isDone_((begin_ + 1) * (begin_ + 1), false) {}

    std::optional<Curve> run(const JobContext& job) {
        open(kNone, begin_);
        for (std::size_t tested = 0; !open_.empty() && tested < kMostTested; ++tested) {
            if ((tested % 64 == 0 && job.stopRequested()) || (tested == kTestedBeforeLook && !leadsToEnd())) {
                return std::nullopt;
            }
            const Entry entry = open_.top();
            open_.pop();
            const Step step = steps_[entry.step];
            // What follows depends on the straight alone, not on how it was reached.
            const auto isDone =
                isDone_.begin() + static_cast<std::ptrdiff_t>(step.from * (begin_ + 1) + step.to);
            if (*isDone) {
                continue;
            }
            *isDone = true;
            if (!fits(step)) {
                continue;
            }
            if (step.to == end_) {
                return lineTo(entry.step);
            }
            open(entry.step, step.to);
        }
        return std::nullopt;
    }

private:
    static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

    /// A straight from one place to another, after those before it.
    struct Step {
        std::size_t from = 0;
        std::size_t to = 0;
        std::size_t before = kNone;
        double costS = 0.0;  ///< of the way up to its end
    };
    struct Entry {
        double atLeastS;
        std::size_t step;
        bool operator<(const Entry& other) const { return atLeastS > other.atLeastS; }
    };

    Point placeOf(std::size_t place) const {
        return place == end_     ? arriving_.position
               : place == begin_ ? leaving_.position
                                 : ways_.corners_[place];
    }
    Angle headingOf(const Step& step) const {
        return furrow::headingOf(placeOf(step.from), placeOf(step.to));
    }
    double turningS(Angle from, Angle to) const {
        return turningOnTheSpot({.position = {}, .heading = from}, {.position = {}, .heading = to}, machine_)
            .si();
    }

    /// All straights from a place on. Whether they fit is looked at when they are the best ones.
    void open(std::size_t before, std::size_t from) {
        const Point here = placeOf(from);
        const Angle arrived = before == kNone ? leaving_.heading : headingOf(steps_[before]);
        const double doneS = before == kNone ? 0.0 : steps_[before].costS;
        for (std::size_t to = 0; to <= end_; ++to) {
            const Point there = placeOf(to);
            const double wayM = distance(here, there);
            if (to == from || wayM < kMeetM) {
                continue;
            }
            const Angle heading = furrow::headingOf(here, there);
            const CurvePiece straight{.length = metres(wayM), .curvature = {}};
            const double dear = meanCost(travel_, {.position = here, .heading = heading}, straight,
                                         machine_.minTurningRadius());
            double costS =
                doneS + turningS(arrived, heading) + dear * fromStandToStand(metres(wayM), machine_).si();
            if (to == end_) {
                costS += turningS(heading, arriving_.heading);
            }
            const double leftM = distance(there, arriving_.position);
            steps_.push_back({.from = from, .to = to, .before = before, .costS = costS});
            open_.push({costS + (leftM > kMeetM ? fromStandToStand(metres(leftM), machine_).si() : 0.0),
                        steps_.size() - 1});
        }
    }

    bool mayTurn(const Pose& at, Angle to) const {
        return ways_.rig_.mayTurnOnTheSpot(at, wrappedAngle(to - at.heading));
    }

    bool fits(const Step& step) const {
        const Angle heading = headingOf(step);
        if (step.from == begin_ && !mayTurn(leaving_, heading)) {
            return false;
        }
        if (step.to == end_ &&
            !mayTurn({.position = arriving_.position, .heading = heading}, arriving_.heading)) {
            return false;
        }
        return step.from < end_ && step.to < end_ ? ways_.leadsBetweenCorners(step.from, step.to)
                                                  : ways_.leads(placeOf(step.from), placeOf(step.to));
    }

    /// Whether a straight leads to the end from any place.
    bool leadsToEnd() const {
        for (std::size_t from = 0; from <= begin_; ++from) {
            if (from != end_ && distance(placeOf(from), arriving_.position) >= kMeetM &&
                fits({.from = from, .to = end_})) {
                return true;
            }
        }
        return false;
    }

    Curve lineTo(std::size_t last) const {
        std::vector<Step> all;
        for (std::size_t step = last; step != kNone; step = steps_[step].before) {
            all.push_back(steps_[step]);
        }
        std::ranges::reverse(all);
        Curve line{.type = kCombinedTurn,
                   .start = {.position = leaving_.position, .heading = headingOf(all.front())},
                   .pieces = {}};
        Angle heading = line.start.heading;
        for (const Step& step : all) {
            const Angle turn = wrappedAngle(headingOf(step) - heading);
            if (turn != Angle{}) {
                line.pieces.push_back({.length = {}, .curvature = {}, .onTheSpot = turn});
            }
            heading = headingOf(step);
            line.pieces.push_back(
                {.length = metres(distance(placeOf(step.from), placeOf(step.to))), .curvature = {}});
        }
        return line;
    }

    const StraightWays& ways_;
    const Machine& machine_;
    Pose leaving_;
    Pose arriving_;
    const TravelCost& travel_;
    std::size_t end_;
    std::size_t begin_;
    std::vector<bool> isDone_;
    std::vector<Step> steps_;
    std::priority_queue<Entry> open_;
};

std::optional<Curve> StraightWays::between(const Pose& leaving, const Pose& arriving,
                                           const TravelCost& travel, const JobContext& job) const {
    return canTurnOnTheSpot(rig_.machine()) ? StraightSearch{*this, leaving, arriving, travel}.run(job)
                                            : std::nullopt;
}

}  // namespace furrow
