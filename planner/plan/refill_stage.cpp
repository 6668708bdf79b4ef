#include "planner/plan/refill_stage.h"

#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"
#include "planner/path/refill_pieces.h"
#include "planner/path/refill_split.h"
#include "planner/path/refill_stops.h"
#include "planner/path/speed_profile.h"
#include "planner/settings/traversal.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

// Steering moves the ends of passes by centimetres, so the work may take a little more than its legs.
constexpr int kRounds = 4;
constexpr double kNoMore = 1e-9;
constexpr double kSpareShare = 1.05;

Finding noteOf(const RoutePlace& place, Message text) {
    return {.severity = Severity::Note,
            .kind = FindingKind::Setting,
            .place = place.position,
            .text = std::move(text),
            .suggestion = "",
            .setting = std::string{kRouteRefill.key}};
}

Finding blocking(Point place, Message text, Message suggestion) {
    return {.severity = Severity::Blocking,
            .kind = FindingKind::Refill,
            .place = place,
            .text = std::move(text),
            .suggestion = std::move(suggestion)};
}

/// Why the refill points are of no use, if they are not.
std::optional<Message> whyUnused(const PlanRequest& request) {
    const auto& tank = request.machine.spec().tank;
    if (request.settings.operation().tank == TankUse::None) {
        return "The refill points are not used: this operation uses no tank.";
    }
    if (!tank || tank->capacity <= 0.0) {
        return "The refill points are not used: this machine has no tank.";
    }
    return tank->ratePerM2 <= 0.0
               ? std::optional{Message{"The refill points are not used: this machine's tank has no rate."}}
               : std::nullopt;
}

Duration durationOf(const Curve& line, SegmentKind kind, const Machine& machine) {
    if (line.pieces.empty()) {
        return {};
    }
    const Leg leg{.kind = kind, .number = 0, .line = line, .implementDown = false};
    return withSpeeds(std::span{&leg, 1}, machine, SteeringLimit::Ignored).duration();
}

/// The trips that may be driven before each piece of work, and what they cost.
class Trips {
public:
    Trips(const std::vector<RefillPiece>& pieces, const std::vector<Leg>& stops, const PathOverLegs& path,
          const Machine& machine, const JobContext& job)
        : pieces_{pieces}, stops_{stops}, path_{path}, machine_{machine}, job_{job} {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            direct_.push_back(i > 0 ? directS(i) : 0.0);
        }
        best_.resize(pieces.size());
    }

    /// What a trip before each piece costs at least: straight there and back.
    std::vector<double> atLeast() const {
        std::vector<double> costs(pieces_.size(), 0.0);
        for (std::size_t i = 1; i < pieces_.size(); ++i) {
            double least = leastS(i, stops_.front());
            for (const Leg& stop : stops_) {
                least = std::min(least, leastS(i, stop));
            }
            costs[i] = least;
        }
        return costs;
    }

    Result<std::vector<std::optional<double>>> real(std::span<const std::size_t> pieces) {
        auto found = parallelMap<std::optional<Trip>>(
            pieces.size(), [&](std::size_t i) { return tripBefore(pieces[i]); }, job_.withoutProgress());
        if (!found) {
            return std::unexpected(found.error());
        }
        std::vector<std::optional<double>> costs;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            best_[pieces[i]] = (*found)[i];
            costs.push_back((*found)[i].transform([](const Trip& trip) { return trip.costS; }));
        }
        return costs;
    }

    /// The stop of the trip before a piece. Empty if none is possible.
    std::optional<Leg> stopBefore(std::size_t piece) const {
        return best_[piece].transform([&](const Trip& trip) { return stops_[trip.stop]; });
    }

private:
    struct Trip {
        std::size_t stop = 0;
        double costS = 0.0;
    };

    const Leg& leaving(std::size_t piece) const { return pieces_[piece - 1].legs.back(); }
    const Leg& arriving(std::size_t piece) const { return pieces_[piece].legs.front(); }
    double fillS() const { return machine_.spec().tank->fillTime().si(); }

    /// Of the way without a trip.
    double directS(std::size_t piece) const {
        if (pieces_[piece].goesOn ||
            distance(leaving(piece).line.end().position, arriving(piece).line.start.position) < kMeetM) {
            return 0.0;
        }
        const auto way = path_.way(leaving(piece), arriving(piece), job_);
        return way ? durationOf(*way, SegmentKind::Turn, machine_).si() : 0.0;
    }

    double leastS(std::size_t piece, const Leg& stop) const {
        const double wayM = distance(leaving(piece).line.end().position, stop.line.start.position) +
                            distance(stop.line.end().position, arriving(piece).line.start.position);
        return fillS() + wayM / machine_.spec().tractor.transferSpeed.si() - direct_[piece];
    }

    std::optional<Trip> tripBefore(std::size_t piece) const {
        std::vector<std::pair<double, std::size_t>> nearest;
        nearest.reserve(stops_.size());
        for (std::size_t i = 0; i < stops_.size(); ++i) {
            nearest.emplace_back(leastS(piece, stops_[i]), i);
        }
        std::ranges::sort(nearest);
        std::optional<Trip> best;
        for (const auto& [least, i] : nearest) {
            if (job_.stopRequested() || (best && best->costS <= least)) {
                break;
            }
            const Leg& stop = stops_[i];
            const auto there = path_.way(leaving(piece), stop, job_);
            const auto back = there ? path_.way(stop, arriving(piece), job_) : std::nullopt;
            if (!back) {
                continue;
            }
            const double waysS = (durationOf(*there, SegmentKind::Refill, machine_) +
                                  durationOf(stop.line, SegmentKind::Refill, machine_) +
                                  durationOf(*back, SegmentKind::Refill, machine_))
                                     .si();
            const double costS = fillS() + waysS - direct_[piece];
            if (!best || costS < best->costS) {
                best = Trip{.stop = i, .costS = costS};
            }
        }
        return best;
    }

    const std::vector<RefillPiece>& pieces_;
    const std::vector<Leg>& stops_;
    const PathOverLegs& path_;
    const Machine& machine_;
    const JobContext& job_;
    std::vector<double> direct_;
    std::vector<std::optional<Trip>> best_;
};

/// The stop before each piece; empty where none is.
using Stops = std::vector<std::optional<Leg>>;

/// The first piece in which more is used than the tank holds, although no single piece takes that much.
std::optional<std::size_t> beyondIn(const std::vector<RefillPiece>& pieces, const Stops& stops,
                                    double capacity) {
    double used = 0.0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        used = (stops[i] ? 0.0 : used) + pieces[i].uses;
        if (used > (1.0 + kNoMore) * capacity && pieces[i].uses <= capacity) {
            return i;
        }
    }
    return std::nullopt;
}

const Leg& workOf(const RefillPiece& piece) {
    const auto leg = std::ranges::find(piece.legs, true, &Leg::implementDown);
    return leg != piece.legs.end() ? *leg : piece.legs.front();
}

/// One for all passes that take more than a whole tank.
std::optional<Finding> tooLong(const std::vector<RefillPiece>& pieces, const TankWork& work) {
    const auto isTooLong = [&](const RefillPiece& piece) {
        return piece.uses > (1.0 + kNoMore) * work.capacity;
    };
    if (std::ranges::none_of(pieces, isTooLong)) {
        return std::nullopt;
    }
    const RefillPiece& longest = *std::ranges::max_element(pieces, {}, &RefillPiece::uses);
    const Leg& leg = workOf(longest);
    const Message name = passName(leg.kind, leg.number);
    const std::ptrdiff_t count = std::ranges::count_if(pieces, isTooLong);
    Message text = work.gathers ? message("{} gathers {:.0f}; the bunker holds {:.0f}.", name.capitalised(),
                                          longest.uses, work.capacity)
                                : message("{} takes {:.0f}; the tank holds {:.0f}.", name.capitalised(),
                                          longest.uses, work.capacity);
    if (count > 1) {
        text =
            text + " " +
            counted("{} pass is too long for it.", "{} passes are too long for it.", static_cast<int>(count));
    }
    return blocking(leg.line.start.position, std::move(text),
                    "Let ways cross the mainland (route.traversal), so that swaths may be interrupted, or "
                    "lay the swaths the short way.");
}

Finding noTrip(const RefillPiece& piece) {
    const Leg& leg = workOf(piece);
    return blocking(
        leg.line.start.position,
        message("No way to a refill point leads from the work before {}.", passName(leg.kind, leg.number)),
        "Choose another refill point.");
}

}  // namespace

Result<Driven> refillStage(const DriveTask& task, Driven driven, const std::vector<Leg>& legs,
                           std::span<const RoutePlace> places, const PathOverLegs& path, const Rig& rig,
                           std::optional<PlanToBeat> toBeat, const JobContext& job) {
    const Machine& machine = task.request.machine;
    const Settings& settings = task.request.settings;
    if (auto why = whyUnused(task.request)) {
        driven.findings.push_back(noteOf(places.front(), *std::move(why)));
        return driven;
    }
    const TankWork work = *tankWork(machine, settings.operation());
    RefillTrips trips{.work = work, .points = {}};
    std::vector<Leg> stops;
    std::vector<Finding> findings;
    for (const RoutePlace& place : places) {
        const std::vector<Leg> here = refillStops(place, *task.request.field, rig);
        if (here.empty()) {
            findings.push_back(blocking(place.position, "The machine has no room at this refill point.",
                                        "Choose another place."));
        }
        trips.points.push_back(place.position);
        stops.insert(stops.end(), here.begin(), here.end());
    }
    const bool mayCutSwaths = traversalOf(settings) == Traversal::Interior;
    const std::vector<RefillPiece> pieces = refillPieces(legs, work, mayCutSwaths);
    std::optional<Trips> known;
    if (!stops.empty()) {
        known.emplace(pieces, stops, path, machine, job);
    }
    double capacity = work.capacity;
    std::optional<std::size_t> unreached;
    const Driven before = std::exchange(driven, {});
    for (int round = 0; round < kRounds; ++round) {
        Stops stopped(pieces.size());
        if (known) {
            RefillTask split{.uses = {}, .capacity = capacity, .atLeast = known->atLeast()};
            std::ranges::transform(pieces, std::back_inserter(split.uses), &RefillPiece::uses);
            const auto found =
                cheapestSplit(split, [&](std::span<const std::size_t> asked) { return known->real(asked); });
            if (!found) {
                return std::unexpected(found.error());
            }
            for (const std::size_t piece : *found) {
                stopped[piece] = known->stopBefore(piece);
            }
        }
        unreached = beyondIn(pieces, stopped, capacity);
        auto made =
            path.driveWithTrips(legsWithStops(pieces, stopped), trips, before.finishing, toBeat,
                                job.part(static_cast<double>(round) / kRounds, (round + 1.0) / kRounds));
        if (!made) {
            return made;
        }
        made->leftBeforeFinishing = before.leftBeforeFinishing;
        made->finishingCost = before.finishingCost;
        made->auditing += before.auditing;
        driven = *std::move(made);
        const double beyond = addLevels(driven.path, work);
        if (unreached || beyond <= kNoMore * work.capacity || tooLong(pieces, work)) {
            break;
        }
        capacity -= kSpareShare * beyond;
    }
    if (auto finding = tooLong(pieces, work)) {
        findings.push_back(*std::move(finding));
    } else if (unreached && !stops.empty()) {
        findings.push_back(noTrip(pieces[*unreached]));
    }
    if (!findings.empty()) {
        // They say why the tank runs empty.
        std::erase_if(driven.findings,
                      [](const Finding& finding) { return finding.kind == FindingKind::Refill; });
        std::ranges::move(findings, std::back_inserter(driven.findings));
    } else if (driven.path.refillCount() == 0) {
        double used = 0.0;
        for (const RefillPiece& piece : pieces) {
            used += piece.uses;
        }
        driven.findings.push_back(noteOf(
            places.front(),
            work.gathers ? message("No trip to a refill point is needed: {:.0f} of the {:.0f} that the "
                                   "bunker holds are gathered.",
                                   used, work.capacity)
                         : message("No trip to a refill point is needed: {:.0f} of the {:.0f} that the "
                                   "tank holds are used.",
                                   used, work.capacity)));
    }
    return driven;
}

}  // namespace furrow
