#include "planner/plan/path_over_legs.h"

#include "planner/path/driven_parts.h"
#include "planner/path/headland_order.h"
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
#include <utility>

namespace furrow {

namespace {

// An eased path is shorter than its legs by less than this.
constexpr double kEasedShare = 0.995;

}  // namespace

PathOverLegs::PathOverLegs(const DriveTask& task, const AllowedAreas& ground, const SteeringRoom& room,
                           RememberedWays& ways, const ChosenTurns& chosen, const MultiPolygon& leftOnPurpose)
    : task_{task},
      ground_{ground},
      ways_{ways},
      chosen_{chosen},
      leftOnPurpose_{leftOnPurpose},
      room_{room} {}

Result<std::vector<Leg>> PathOverLegs::joined(std::vector<Leg>& legs, const JobContext& job) const {
    const Settings& settings = task_.request.settings;
    const Machine& machine = task_.request.machine;
    const bool fits = settings.flag(kStayInside);
    std::atomic<bool> isWhole{true};
    const auto build = [&](const JobContext& part) {
        return joinedLegs(
            legs, machine,
            [&](const Leg& from, const Leg& to, const JobContext& piece) {
                const Pose leaving = from.line.end();
                const Pose arriving = to.line.start;
                // A way that may leave the field keeps its kind but where it leads through an obstacle.
                auto way = fits ? chosen_.between(from, to) : chosen_.anywhere(from, to);
                if (!way) {
                    way = ways_(leaving, arriving, piece);
                }
                isWhole = isWhole && way;
                return way ? std::move(*way) : connection(leaving, arriving, machine, otherTurns(settings));
            },
            part);
    };
    auto all = build(job.part(0.0, 0.75));
    if (!all || !fits || isWhole) {
        return all;
    }
    const auto parts = DrivenParts::of(ground_, machine, {}, job);
    if (!parts) {
        return std::unexpected(parts.error());
    }
    legs = withWaysBetween(partByPart(std::move(legs), *parts), ways_, room_.lowered, *parts, job);
    return build(job.part(0.75, 1.0));
}

Result<std::vector<Finding>> PathOverLegs::foundIn(Path& path, const std::vector<Leg>& legs,
                                                   const JobContext& job) const {
    std::vector<Finding> findings;
    if (task_.request.settings.flag(kStayInside)) {
        auto checked = checkWays(path, ground_, task_.request.machine, job);
        if (!checked) {
            return checked;
        }
        findings = *std::move(checked);
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
    Stopwatch watch;
    const PlanRequest& request = task_.request;
    const auto isSlower = [&](const Path& path, double share) {
        return toBeat && toBeat->isLostAfter(share * path.duration());
    };
    const auto all = joined(legs, job.part(0.0, 0.4));
    if (!all) {
        return std::unexpected(all.error());
    }
    if (toBeat && isSlower(withSpeeds(*all, request.machine, SteeringLimit::Ignored), kEasedShare)) {
        return std::unexpected(noBetter(*request.field));
    }
    auto path =
        steerableLegs(*all, room_, job.withoutProgress()).transform([&](const std::vector<Leg>& eased) {
            return withSpeeds(eased, request.machine);
        });
    if (!path) {
        return std::unexpected(path.error());
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
                  .leftBeforeFinishing = {},
                  .finishingCost = {},
                  .driving = watch.lap(),
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
    auto report = audit(auditInput({.request = request,
                                    .margin = task_.ground->margin,
                                    .overhung = task_.ground->overhung,
                                    .headland = task_.headland,
                                    .finishing = driven.finishing,
                                    .mainland = task_.laid.mainland,
                                    .swaths = task_.laid.swaths,
                                    .route = task_.ordered.route,
                                    .path = driven.path,
                                    .leftOnPurpose = driven.leftOnPurpose}),
                        job.part(0.6, 1.0));
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
