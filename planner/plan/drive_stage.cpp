#include "planner/plan/drive_stage.h"

#include "planner/field/ground_around.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/finishing_passes.h"
#include "planner/headland/headland_passes.h"
#include "planner/path/drivable_check.h"
#include "planner/path/driven_parts.h"
#include "planner/path/fitting_ways.h"
#include "planner/path/gate_ways.h"
#include "planner/path/headland_order.h"
#include "planner/path/lifted_legs.h"
#include "planner/path/path_builder.h"
#include "planner/path/remembered_ways.h"
#include "planner/path/travel_rule.h"
#include "planner/path/way_repair.h"
#include "planner/plan/chosen_turns.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/connection.h"
#include "planner/turns/straight_turn.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <ranges>
#include <span>

namespace furrow {

namespace {

using Clock = std::chrono::steady_clock;

// Short passes are added until so little is left: below what the audit blocks a plan for.
constexpr double kMayStayShare = 0.009;
constexpr Area kMayStayInOnePiece = squareMetres(95.0);
constexpr int kFinishingRounds = 6;
// Where no way was found through a neck with no more room beside the machine, it is the neck that is in the way.
constexpr Length kNeckSpare = metres(0.5);
// A segment that begins where a pass does is that pass.
constexpr double kSamePlaceM = 1e-6;

/// "The way from swath 3 to swath 4", "Headland pass 1".
Message nameOfWay(const Path& path, std::size_t segment) {
    if (path.segments[segment].implementDown) {
        return nameOf(path.segments[segment]).capitalised();
    }
    const PathSegment* const before = path.workBefore(segment);
    const PathSegment* const after = path.workAfter(segment);
    return message("The way from {} to {}", before == nullptr ? Message{"the start"} : nameOf(*before),
                       after == nullptr ? Message{"the end"} : nameOf(*after));
}

/// Whether a way leaves one part of the field for another.
bool leadsBetweenParts(const DrivenParts& parts, const Path& path, std::size_t segment) {
    const PathSegment* const before = path.workBefore(segment);
    const PathSegment* const after = path.workAfter(segment);
    return !path.segments[segment].implementDown && before != nullptr && after != nullptr &&
           parts.separate(before->samples.back().position, after->samples.front().position);
}

Finding blockedFinding(const Path& path, const BlockedConnection& blocked, const DrivenParts& parts) {
    const Message way = nameOfWay(path, blocked.segment);
    if (leadsBetweenParts(parts, path, blocked.segment)) {
        return {.severity = Severity::Blocking,
                .kind = blocked.obstacle ? "obstacle" : "outside",
                .place = blocked.place,
                .text = message("{} leads from one part of the field to another that this machine cannot drive to.", way),
                .suggestion = "Plan the parts of the field apart, or widen the passage between them."};
    }
    if (blocked.obstacle) {
        return {.severity = Severity::Blocking,
                .kind = "obstacle",
                .place = blocked.place,
                .text = message("{} crosses an obstacle.", way),
                .suggestion = "Plan the sides of the obstacle apart."};
    }
    return {.severity = Severity::Blocking,
            .kind = "outside",
            .place = blocked.place,
            .text = message("{} leaves the field by {:.2f} m.", way, blocked.outside.si())};
}

/// What ways are that are no turns between swaths: the chosen kind is kept where nothing has to fit.
TurnPlanner* otherTurns(const Settings& settings) {
    return settings.flag(kStayInside) ? kBestFeasibleMethod.run : turnMethod(settings);
}

/// Headland passes before or after the swaths.
std::vector<Leg> layOut(const Plan& plan, const MultiPolygon& drivable) {
    const Settings& settings = plan.request.settings;
    const Machine& machine = plan.request.machine;
    std::vector<Leg> legs = swathLegs(plan.swaths, plan.route, machine);
    if (!plan.headland.rings.empty()) {
        const bool first = settings.choice(kHeadlandWhen) == "before";
        HeadlandDrive drive{.insideOut = settings.choice(kHeadlandOrder) == "inside-out",
                            .before = {},
                            .after = {},
                            .drivable = drivable};
        if (first && !legs.empty()) {
            drive.after = legs.front().line.start;
        } else if (!legs.empty()) {
            drive.before = legs.back().line.end();
        }
        const std::vector<Leg> passes = headlandLegs(plan.headland.rings, drive, machine, otherTurns(settings));
        legs.insert(first ? legs.begin() : legs.end(), passes.begin(), passes.end());
    }
    return legs;
}

Error nothingWorked(const Field& field) {
    return {.code = ErrorCode::InputRefused,
            .what = "the margin and the obstacles that may be driven on leave nothing to work",
            .where = field.source().origin.empty() ? field.name() : field.source().origin,
            .remedy = "make them smaller, or delete some of them",
            .place = middleOf(field.source().parts)};
}

/// Never told: a quicker plan is there.
Error tooSlow(const Field& field) {
    return {.code = ErrorCode::InputRefused, .what = "the path takes longer than another", .where = field.name()};
}

/// Wet spots and what is passed over beside them, and what the swaths leave.
Result<MultiPolygon> landLeftOnPurpose(const Plan& plan, MultiPolygon passedOver, const JobContext& job) {
    std::ranges::copy(plan.field().passable(), std::back_inserter(passedOver));
    std::ranges::copy(plan.swaths.leftOnPurpose, std::back_inserter(passedOver));
    return passedOver.empty() ? Result<MultiPolygon>{} : unionOf(passedOver, job);
}

Message blockedReason(const BlockedConnection& blocked) {
    return blocked.obstacle ? Message{"crosses an obstacle"}
                            : message("leaves the field by {:.2f} m", blocked.outside.si());
}

/// The planner's own words come first: they know what was tried. The audit adds what they leave out.
void addAuditFindings(Plan& plan) {
    const auto saidAlready = [&plan](const AuditFinding& found) {
        if (found.segment && !plan.path.segments[*found.segment].drivable &&
            (found.finding.kind == "outside" || found.finding.kind == "obstacle" ||
             found.finding.kind == "undrivable")) {
            return true;
        }
        return found.finding.kind == "heading-jump" &&
               std::ranges::contains(plan.findings, found.finding.kind, &Finding::kind);
    };
    std::vector<Finding> added;
    for (const AuditFinding& found : plan.audit.findings) {
        if (!saidAlready(found)) {
            added.push_back(found.finding);
        }
    }
    std::ranges::move(added, std::back_inserter(plan.findings));
}

/// The ways in and out. On them, and on the ways from and to them, the implement is folded.
struct GateWays {
    std::optional<Pose> in;   ///< where the way in ends
    std::optional<Pose> out;  ///< where the way out begins
    std::vector<Finding> findings;  ///< where there is none, and why

    bool leads(const Pose& leaving, const Pose& arriving) const { return leaving == in || arriving == out; }
};

/// Puts the ways in and out before and behind legs, of which there is one at least.
GateWays addGateWays(std::vector<Leg>& legs, const std::array<std::optional<RoutePlace>, 2>& places, const Field& field,
                     const Rig& rig) {
    GateWays gates;
    const auto nameOfPlace = [](const RoutePlace& place) {
        return place.gate && !place.gate->name.empty() ? Message{place.gate->name} : Message{"this place"};
    };
    const auto tell = [&](const RoutePlace& place, Message text) {
        gates.findings.push_back({.severity = Severity::Blocking,
                                  .kind = "gate",
                                  .place = place.position,
                                  .text = std::move(text),
                                  .suggestion = place.gate ? "Make the gate wider, or take another." : "Choose another place."});
    };
    const Length width = rig.machine().transportWidth();
    const auto isNarrow = [&](const RoutePlace& place) {
        return place.gate && place.gate->width > Length{} && place.gate->width < width;
    };
    for (const auto& place : places) {
        const bool isSaid = place && std::ranges::contains(gates.findings, place->position, &Finding::place);
        if (place && isNarrow(*place) && !isSaid) {
            tell(*place, message("{} is {:.2f} m wide; this machine is {:.2f} m wide for transport.",
                                 nameOfPlace(*place).capitalised(), place->gate->width.si(), width.si()));
        }
    }
    if (const auto& start = places[0]) {
        if (const auto in = wayIn(*start, field, rig, legs.front().line.start.position)) {
            gates.in = in->line.end();
            legs.insert(legs.begin(), *in);
        } else {
            tell(*start, message("The machine does not get in at {}.", nameOfPlace(*start)));
        }
    }
    if (const auto& end = places[1]) {
        if (const auto out = wayOut(*end, field, rig, legs.back().line.end().position)) {
            gates.out = out->line.start;
            legs.push_back(*out);
        } else {
            tell(*end, message("The machine does not get out at {}.", nameOfPlace(*end)));
        }
    }
    return gates;
}

/// Marks what leaves the field and tells it, a way in several gears once, at its worst place.
Result<void> checkWays(Plan& plan, const MultiPolygon& drivable, const JobContext& job) {
    const auto blocked = blockedConnections(plan.path, drivable, plan.request.machine, job);
    if (!blocked) {
        return std::unexpected(blocked.error());
    }
    if (blocked->empty()) {
        return {};
    }
    const auto parts = DrivenParts::of(drivable, plan.request.machine, kNeckSpare, job);
    if (!parts) {
        return std::unexpected(parts.error());
    }
    std::optional<BlockedConnection> worst;
    for (const BlockedConnection& connection : *blocked) {
        PathSegment& segment = plan.path.segments[connection.segment];
        segment.drivable = false;
        segment.reason = blockedReason(connection);
        const bool sameWay = worst && !segment.implementDown &&
                             plan.path.workBefore(worst->segment) == plan.path.workBefore(connection.segment);
        if (sameWay && connection.outside <= worst->outside) {
            continue;
        }
        if (sameWay) {
            plan.findings.pop_back();
        }
        worst = connection;
        plan.findings.push_back(blockedFinding(plan.path, connection, *parts));
    }
    return {};
}

/// The path over these legs, checked and audited, with what both find. Where no way leads from one to the next they are
/// put in another order.
Result<void> drive(Plan& plan, std::vector<Leg>& legs, RememberedWays& ways, const ChosenTurns& chosen,
                   const MultiPolygon& drivable, std::optional<Duration> atMost, const JobContext& job) {
    const Settings& settings = plan.request.settings;
    const Machine& machine = plan.request.machine;
    const bool fits = settings.flag(kStayInside);
    const Clock::time_point begin = Clock::now();
    std::atomic<bool> isWhole{true};
    const auto build = [&](const JobContext& part) {
        return buildPath(
            legs, machine,
            [&](const Leg& from, const Leg& to, const JobContext& piece) {
                const Pose leaving = from.line.end();
                const Pose arriving = to.line.start;
                // What may leave the field keeps its kind but where that leads through an obstacle.
                auto way = fits ? chosen.between(from, to) : chosen.anywhere(from, to);
                if (!way) {
                    way = ways(leaving, arriving, piece);
                }
                isWhole = isWhole && way;
                return way ? std::move(*way) : connection(leaving, arriving, machine, otherTurns(settings));
            },
            part);
    };
    auto path = build(job.part(0.0, 0.3));
    if (path && fits && !isWhole) {
        const auto parts = DrivenParts::of(drivable, machine, {}, job);
        if (!parts) {
            return std::unexpected(parts.error());
        }
        legs = withWaysBetween(partByPart(std::move(legs), *parts), ways, Rig{drivable, machine, ImplementAt::Lowered}, *parts, job);
        path = build(job.part(0.3, 0.4));
    }
    if (!path) {
        return std::unexpected(path.error());
    }
    if (atMost && path->duration() > *atMost) {
        return std::unexpected(tooSlow(plan.field()));
    }
    plan.path = std::move(*path);
    plan.findings.clear();
    if (settings.flag(kStayInside)) {
        if (auto checked = checkWays(plan, drivable, job.part(0.4, 0.6)); !checked) {
            return checked;
        }
        if (auto told = chosen.told(legs)) {
            plan.findings.push_back(std::move(*told));
        }
    }
    if (turnMethod(settings) == kStraightMethod.run && !machine.spec().tractor.canTurnInPlace && plan.path.turnCount() > 0) {
        plan.findings.push_back(
            {.severity = Severity::Blocking,
             .kind = "heading-jump",
             .place = std::ranges::find(plan.path.segments, SegmentKind::Turn, &PathSegment::kind)->samples.front().position,
             .text = "Turns on the spot are chosen (path.method), and this machine cannot turn on the spot.",
             .suggestion = "Take a machine that can."});
    }
    const Clock::time_point driven = Clock::now();
    plan.timings.path += seconds(std::chrono::duration<double>(driven - begin).count());
    if (plan.request.draft) {
        return {};
    }
    auto report = audit(auditInput(plan), job.part(0.6, 1.0));
    if (!report) {
        return std::unexpected(report.error());
    }
    plan.audit = std::move(*report);
    addAuditFindings(plan);
    plan.timings.audit += seconds(std::chrono::duration<double>(Clock::now() - driven).count());
    return {};
}

/// Ways and passes that leave where the machine may be.
std::ptrdiff_t outsideCount(const Plan& plan) {
    return std::ranges::count_if(plan.path.segments, [](const PathSegment& segment) { return !segment.drivable; });
}

bool leavesTooMuch(const Plan& plan) {
    return std::ranges::contains(plan.findings, "missed", &Finding::kind);
}

/// Of these passes, those that leave where the machine may be, or whose ways in or out do.
std::vector<HeadlandPass> leadingOutside(const Path& path, const std::vector<HeadlandPass>& passes) {
    std::vector<HeadlandPass> outside;
    const auto begins = [](const PathSegment* segment, const HeadlandPass& pass) {
        return segment != nullptr && distance(segment->samples.front().position, pass.stretches.front().line.start.position) < kSamePlaceM;
    };
    for (const HeadlandPass& pass : passes) {
        const auto isOutside = [&](std::size_t i) {
            const PathSegment& segment = path.segments[i];
            return !segment.drivable &&
                   (begins(&segment, pass) ||
                    (!segment.implementDown && (begins(path.workBefore(i), pass) || begins(path.workAfter(i), pass))));
        };
        if (std::ranges::any_of(std::views::iota(std::size_t{0}, path.segments.size()), isOutside)) {
            outside.push_back(pass);
        }
    }
    return outside;
}

/// Where more is left than may stay, short passes over it, if the plan gets better by them. What has no way in is
/// replaced by others in another round.
Result<void> finish(Plan& plan, std::vector<Leg> legs, RememberedWays& ways, const ChosenTurns& chosen,
                    const MultiPolygon& drivable, const JobContext& job) {
    const Settings& settings = plan.request.settings;
    // Beside obstacles that swaths stop short of, too, where there is no headland.
    const bool applies = settings.flag(kHeadlandFinish) &&
                         (settings.flag(kStayInside) ? !plan.headland.rings.empty() : plan.headland.passes == 0);
    if (!applies || !leavesTooMuch(plan)) {
        return {};
    }
    const Machine& machine = plan.request.machine;
    const Rig lowered{drivable, machine, ImplementAt::Lowered};
    std::optional<FullLockPasses> bends;
    if (!canReverse(machine) && !machine.spec().tractor.canTurnInPlace) {
        auto made = FullLockPasses::of(
            drivable, lowered, [&](const Turn& line) { return placeFor(line, legs, ways, job).access; }, job);
        if (!made) {
            return std::unexpected(made.error());
        }
        bends = std::move(*made);
    }
    const auto land = plan.margin > Length{} ? eroded(plan.field().workable(), plan.margin, kArcTolerance, job)
                                             : Result<MultiPolygon>{plan.field().workable()};
    if (!land) {
        return std::unexpected(land.error());
    }
    std::vector<PassStretch> refused;
    for (int round = 0; round < kFinishingRounds && leavesTooMuch(plan); ++round) {
        const Clock::time_point begin = Clock::now();
        const JobContext part = job.part(static_cast<double>(round) / kFinishingRounds, (round + 1.0) / kFinishingRounds);
        const Area hairs = plan.audit.left - area(plan.audit.leftAreas);
        const auto passes = finishingPasses({.workable = *land,
                                             .left = plan.audit.leftAreas,
                                             .mayStay = kMayStayShare * plan.audit.workable - hairs,
                                             .mayStayInOnePiece = kMayStayInOnePiece,
                                             .lowered = lowered,
                                             .bends = bends ? &*bends : nullptr,
                                             .leftOnPurpose = plan.leftOnPurpose,
                                             .refused = refused},
                                            part.part(0.0, 0.2));
        if (!passes) {
            return std::unexpected(passes.error());
        }
        Plan finished = plan;
        FinishedLegs more = withFinishingPasses(legs, *passes, ways, part);
        finished.headland.rings.insert(finished.headland.rings.end(), more.put.begin(), more.put.end());
        const auto refuse = [&refused](const HeadlandPass& pass) { refused.push_back(pass.stretches.front()); };
        std::ranges::for_each(more.refused, refuse);
        finished.timings.path += seconds(std::chrono::duration<double>(Clock::now() - begin).count());
        if (more.put.empty()) {
            if (more.refused.empty()) {
                break;
            }
            continue;
        }
        if (auto driven = drive(finished, more.legs, ways, chosen, drivable, {}, part.part(0.2, 1.0)); !driven) {
            return driven;
        }
        if (finished.blockingCount() > plan.blockingCount() || outsideCount(finished) > outsideCount(plan)) {
            const std::vector<HeadlandPass> outside = leadingOutside(finished.path, more.put);
            if (outside.empty()) {
                break;
            }
            std::ranges::for_each(outside, refuse);
            continue;
        }
        plan = std::move(finished);
        legs = std::move(more.legs);
    }
    return {};
}

}  // namespace

Result<void> driveStage(Plan& plan, const MultiPolygon& drivable, std::optional<Duration> atMost, const JobContext& job) {
    const Field& field = plan.field();
    const Machine& machine = plan.request.machine;
    const Settings& settings = plan.request.settings;
    const auto start = routePlace(field, settings, kRouteStart);
    const auto end = routePlace(field, settings, kRouteEnd);
    if (!start || !end) {
        return std::unexpected(start ? end.error() : start.error());
    }
    const std::array places{*start, *end};
    const auto open = withOpenGates(drivable, field, places, job);
    if (!open) {
        return std::unexpected(open.error());
    }
    const auto travel = travelRule(traversalOf(settings),
                                   {.workable = field.workable(),
                                    .mainland = plan.headland.mainland,
                                    .machine = machine,
                                    .margin = plan.margin},
                                   job);
    if (!travel) {
        return std::unexpected(travel.error());
    }
    const auto ground = settings.flag(kStayInside) ? open : groundAround(field, job);
    if (!ground) {
        return std::unexpected(ground.error());
    }
    const auto fitting = std::make_shared<FittingWays>(*ground, machine, *travel);
    const bool folds = machine.spec().implement.transportWidth && std::ranges::any_of(places, &std::optional<RoutePlace>::has_value);
    const auto folded = folds ? std::make_shared<FittingWays>(*ground, machine.folded(), *travel) : fitting;
    GateWays gates;
    RememberedWays ways{[&](const Pose& leaving, const Pose& arriving, const JobContext& part, SearchEffort effort) {
        return (gates.leads(leaving, arriving) ? folded : fitting)->between(leaving, arriving, part, effort);
    }};
    auto [legs, passedOver] = liftedOver(layOut(plan, drivable), field.passable(), machine, machine.spec().implement.length);
    if (std::ranges::none_of(legs, &Leg::implementDown)) {
        return std::unexpected(nothingWorked(field));
    }
    auto onPurpose = landLeftOnPurpose(plan, std::move(passedOver), job);
    if (!onPurpose) {
        return std::unexpected(onPurpose.error());
    }
    plan.leftOnPurpose = std::move(*onPurpose);
    const ChosenTurns chosen{plan, *fitting};
    gates = addGateWays(legs, places, field, Rig{*open, machine.folded()});
    if (auto driven = drive(plan, legs, ways, chosen, *ground, atMost, job.part(0.0, 0.8)); !driven) {
        return std::unexpected(driven.error());
    }
    if (auto finished = finish(plan, legs, ways, chosen, *ground, job.part(0.8, 1.0)); !finished) {
        return std::unexpected(finished.error());
    }
    std::ranges::move(gates.findings, std::back_inserter(plan.findings));
    return {};
}

}  // namespace furrow
