#include "planner/plan/path_over_legs.h"

#include "planner/geometry/tolerances.h"
#include "planner/path/speed_profile.h"
#include "planner/path/way_repair.h"
#include "planner/plan/audit_input.h"
#include "planner/plan/drive_findings.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/stopwatch.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/connection.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <span>
#include <utility>

namespace furrow {

namespace {

// An eased path is shorter than its legs by less than this.
constexpr double kEasedShare = 0.995;
// A search that fails takes up to half a second. After so many of them the ways of all further legs are
// searched quickly. That is looked at from time to time, so that the number of threads does not matter.
constexpr std::size_t kMostFailed = 25;
constexpr std::size_t kLegsAtOnce = 64;

/// The rooms of an area in several polygons. A search that fails goes through all of one.
Result<std::optional<DrivenParts>> roomsApart(const MultiPolygon& area, const Tractor& tractor,
                                              const JobContext& job) {
    if (area.size() < 2) {
        return std::optional<DrivenParts>{};
    }
    // A disc of this breadth lies in the tractor, whichever way it stands.
    const Length breadth = std::min(tractor.width, tractor.length) - metres(kNeckContactM);
    return DrivenParts::of(area, breadth, job).transform([](DrivenParts&& rooms) {
        return std::optional{std::move(rooms)};
    });
}

bool areApart(const Leg& from, const Leg& to, const std::optional<DrivenParts>& rooms) {
    return rooms && rooms->separate(from.line.end().position, to.line.start.position);
}

}  // namespace

PathOverLegs::PathOverLegs(const DriveTask& task, const AllowedAreas& ground, const DrivingRoom& room,
                           RememberedWays& ways, FoldingWays* folding, const ChosenTurns& chosen,
                           const MultiPolygon& leftOnPurpose)
    : task_{task},
      ground_{ground},
      ways_{ways},
      folding_{folding},
      chosen_{chosen},
      leftOnPurpose_{leftOnPurpose},
      room_{room} {}

std::optional<Curve> PathOverLegs::way(const Leg& from, const Leg& to, const JobContext& job,
                                       SearchEffort effort) const {
    // A way that may leave the field keeps its kind but where it leads through an obstacle.
    auto way =
        task_.request.settings.flag(kStayInside) ? chosen_.between(from, to) : chosen_.anywhere(from, to);
    return way ? way : ways_(from.line.end(), to.line.start, job, effort);
}

Result<std::vector<Leg>> PathOverLegs::joinedBy(const std::vector<Leg>& legs, Folding folding,
                                                const std::optional<DrivenParts>& rooms, Missing& missing,
                                                const JobContext& job) const {
    const Settings& settings = task_.request.settings;
    const Machine& machine = task_.request.machine;
    std::atomic<std::size_t> inAll{0};
    std::atomic<std::size_t> within{0};
    SearchEffort effort = SearchEffort::Thorough;
    const auto wayBetween = [&](const Leg& from, const Leg& to, const JobContext& piece) {
        const Pose leaving = from.line.end();
        const Pose arriving = to.line.start;
        const bool mayLead = !areApart(from, to, rooms);
        if (auto raised = mayLead ? way(from, to, piece, effort) : std::nullopt) {
            return WayBetween{.line = *std::move(raised)};
        }
        if (folding == Folding::WhereNeeded && mayLead) {
            if (auto narrow = folding_->folded(leaving, arriving, piece)) {
                return WayBetween{.line = *std::move(narrow), .folded = true};
            }
        }
        ++inAll;
        within += mayLead ? 1 : 0;
        return WayBetween{.line = connection(leaving, arriving, machine, otherTurns(settings))};
    };
    std::vector<Leg> all;
    std::size_t end = 0;
    for (std::size_t begin = 0; end < legs.size(); begin += kLegsAtOnce) {
        // The first leg of the next ones ends these.
        end = std::min(begin + kLegsAtOnce + 1, legs.size());
        const auto share = [&](std::size_t leg) {
            return static_cast<double>(leg) / static_cast<double>(legs.size());
        };
        auto some = joinedLegs(std::span{legs}.subspan(begin, end - begin), machine, wayBetween,
                               job.part(share(begin), share(end)));
        if (!some) {
            return some;
        }
        if (end < legs.size()) {
            some->pop_back();
        }
        std::ranges::move(*some, std::back_inserter(all));
        if (within > kMostFailed) {
            effort = SearchEffort::Quick;
        }
    }
    missing = {.inAll = inAll, .within = within};
    return all;
}

Result<std::vector<Leg>> PathOverLegs::reordered(std::vector<Leg> legs, const Missing& missing,
                                                 const JobContext& job) const {
    const Machine& machine = task_.request.machine;
    const auto parts = DrivenParts::of(ground_, machine, {}, job);
    if (!parts) {
        return std::unexpected(parts.error());
    }
    legs = partByPart(std::move(legs), *parts);
    // Each takes some dozen searches.
    if (missing.within > kMostFailed) {
        return legs;
    }
    legs = withWaysBetween(std::move(legs), ways_, room_.steering.lowered, *parts, job);
    if (folding_ == nullptr) {
        return legs;
    }
    // Folded, the machine gets from part to part, though not to every place of them.
    const auto foldedParts = DrivenParts::of(ground_, machine.folded(), {}, job);
    if (!foldedParts) {
        return std::unexpected(foldedParts.error());
    }
    return withWaysBetween(std::move(legs), folding_->either, room_.steering.lowered, *foldedParts, job);
}

Result<std::vector<Leg>> PathOverLegs::joined(std::vector<Leg>& legs, bool mayReorder,
                                              const JobContext& job) const {
    Missing missing;
    const bool staysInside = task_.request.settings.flag(kStayInside);
    const auto rooms = staysInside ? roomsApart(ground_.tractor(), task_.request.machine.spec().tractor, job)
                                   : Result<std::optional<DrivenParts>>{std::optional<DrivenParts>{}};
    if (!rooms) {
        return std::unexpected(rooms.error());
    }
    auto all = joinedBy(legs, Folding::Never, *rooms, missing, job.part(0.0, 0.75));
    if (!all || missing.inAll == 0 || !staysInside) {
        return all;
    }
    if (mayReorder) {
        auto other = reordered(std::move(legs), missing, job.withoutProgress());
        if (!other) {
            return std::unexpected(other.error());
        }
        legs = *std::move(other);
    }
    return joinedBy(legs, folding_ != nullptr ? Folding::WhereNeeded : Folding::Never, *rooms, missing,
                    job.part(0.75, 1.0));
}

Result<std::vector<Finding>> PathOverLegs::foundIn(Path& path, const std::vector<Leg>& legs,
                                                   const JobContext& job) const {
    std::vector<Finding> findings;
    if (task_.request.settings.flag(kStayInside)) {
        auto checked = checkWays(path, *room_.checks, ground_, task_.request.machine, job);
        if (!checked) {
            return checked;
        }
        findings = *std::move(checked);
        std::ranges::move(foldedWays(path), std::back_inserter(findings));
        if (auto told = chosen_.told(legs)) {
            findings.push_back(*std::move(told));
        }
    }
    if (auto impossible = impossibleTurns(task_.request, path)) {
        findings.push_back(*std::move(impossible));
    }
    return findings;
}

Result<Driven> PathOverLegs::drive(std::vector<Leg>& legs, std::vector<HeadlandPass> finishing,
                                   std::optional<PlanToBeat> toBeat, const JobContext& job) const {
    return driveAs(legs, nullptr, std::move(finishing), toBeat, job);
}

Result<Driven> PathOverLegs::driveWithTrips(std::vector<Leg> legs, const RefillTrips& trips,
                                            std::vector<HeadlandPass> finishing,
                                            std::optional<PlanToBeat> toBeat, const JobContext& job) const {
    return driveAs(legs, &trips, std::move(finishing), toBeat, job);
}

Result<Driven> PathOverLegs::driveAs(std::vector<Leg>& legs, const RefillTrips* trips,
                                     std::vector<HeadlandPass> finishing, std::optional<PlanToBeat> toBeat,
                                     const JobContext& job) const {
    const PlanRequest& request = task_.request;
    const auto isSlower = [&](const Path& path, double share) {
        return toBeat && toBeat->isLostAfter(share * path.duration());
    };
    const auto all = joined(legs, trips == nullptr, job.part(0.0, 0.4));
    if (!all) {
        return std::unexpected(all.error());
    }
    if (toBeat && isSlower(withSpeeds(*all, request.machine, SteeringLimit::Ignored), kEasedShare)) {
        return std::unexpected(noBetter(*request.field));
    }
    // What may leave the field in a draft is not eased within it, either.
    const bool isSketch = request.draft && !request.settings.flag(kStayInside);
    auto path = isSketch ? Result<Path>{withSpeeds(*all, request.machine, SteeringLimit::Ignored)}
                         : steerableLegs(*all, room_.steering, job.withoutProgress())
                               .transform([&](const std::vector<Leg>& eased) {
                                   return withSpeeds(eased, request.machine);
                               });
    if (!path) {
        return std::unexpected(path.error());
    }
    if (trips != nullptr) {
        addLevels(*path, trips->work);
    }
    if (isSlower(*path, 1.0)) {
        return std::unexpected(noBetter(*request.field));
    }
    auto findings = foundIn(*path, legs, job.part(0.4, 0.6));
    if (!findings) {
        return std::unexpected(findings.error());
    }
    Driven driven{.path = *std::move(path),
                  .finishing = std::move(finishing),
                  .leftOnPurpose = leftOnPurpose_,
                  .audit = {},
                  .findings = *std::move(findings),
                  .refill = trips != nullptr ? std::optional{*trips} : std::nullopt,
                  .leftBeforeFinishing = {},
                  .finishingCost = {},
                  .auditing = {}};
    // Other finishing passes, or headlands in the place of swaths round obstacles, may be better.
    const bool isLast = driven.finishing.empty() && task_.laid.swaths.goneRound.empty();
    const auto isLost = [&] { return toBeat && isLast && !mayBeat(*toBeat, request.machine, driven); };
    if (request.draft) {
        return driven;
    }
    if (isLost()) {
        return std::unexpected(noBetter(*request.field));
    }
    Stopwatch watch;
    const AuditInput input = auditInput({.request = request,
                                         .margin = task_.ground->margin,
                                         .overhung = task_.ground->overhung,
                                         .headland = task_.headland,
                                         .finishing = driven.finishing,
                                         .mainland = task_.laid.mainland,
                                         .swaths = task_.laid.swaths,
                                         .route = task_.ordered.route,
                                         .path = driven.path,
                                         .leftOnPurpose = driven.leftOnPurpose,
                                         .refill = trips});
    const auto land = auditedLand(task_.lands, request, task_.ground, input, job.withoutProgress());
    if (!land) {
        return std::unexpected(land.error());
    }
    auto report = audit(input, **land, job.part(0.6, 1.0));
    if (!report) {
        return std::unexpected(report.error());
    }
    driven.audit = *std::move(report);
    std::ranges::move(newFindings(driven.audit, driven.findings, driven.path),
                      std::back_inserter(driven.findings));
    driven.auditing = watch.lap();
    if (isLost()) {
        return std::unexpected(noBetter(*request.field));
    }
    return driven;
}

/// What ways are that are no turns between swaths: the chosen kind is kept where nothing has to fit.
TurnPlanner* otherTurns(const Settings& settings) {
    return settings.flag(kStayInside) ? kBestFeasibleMethod.run : turnMethod(settings).run;
}

}  // namespace furrow
