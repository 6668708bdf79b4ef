#include "planner/plan/explanation.h"

#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/headland/turning_room.h"
#include "planner/path/turn_shape.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/order_stage.h"
#include "planner/plan/swath_stage.h"
#include "planner/route/route_costs.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"
#include "planner/units/time_message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// A smaller difference is nothing that anybody would change a plan for.
constexpr double kWorthTellingS = 5.0;
constexpr double kWorthTellingShare = 0.005;
constexpr double kSameShownDeg = 0.05;
constexpr double kDryM2 = 0.5;
// The outermost pass touches the edge; that is no news.
constexpr double kTouchesM = 0.01;

bool isWorthTelling(Duration difference, Duration whole) {
    return std::abs(difference.si()) >= std::max(kWorthTellingS, kWorthTellingShare * whole.si());
}

Message bearingMessage(Angle heading) {
    return message("{:.0f} degrees", std::fmod(std::round(lineBearingDeg(heading)), 180.0));
}

// Headland.

Length roomForTurnsOf(const Plan& plan) {
    const Settings& settings = plan.request.settings;
    return plan.margin + roomForTurns(plan.request.machine, turnMethod(settings).run, drawsOutEnds(settings),
                                      settings.length(kOverhang).value_or(Length{}));
}

Message whyNoHeadland(const Plan& plan) {
    if (turnsOnTheSpotInside(plan.request)) {
        return message("There is no headland, as chosen. The machine turns on the spot inside the field.");
    }
    return message("There is no headland, as chosen. Turns reach {:.1f} m beyond the ends of swaths.",
                   reachOfLevelTurn(plan.request.machine, turnMethod(plan.request.settings).run).si());
}

Message whyPerEdge(const Plan& plan) {
    const Headland& headland = plan.headland;
    return message(
        "Edges that swaths run along get {:.1f} m, edges that they end at up to {:.1f} m: a turn of this machine needs "
        "{:.1f} m.",
        narrowestWidth(headland).si(), headland.width.si(), roomForTurnsOf(plan).si());
}

Message whyThisWidth(const Plan& plan) {
    const Headland& headland = plan.headland;
    const Length room = roomForTurnsOf(plan);
    const Message passes = counted("{} pass of {:.1f} m", "{} passes of {:.1f} m", headland.passes,
                                   plan.request.machine.operatingWidth().si());
    if (headland.narrowed) {
        return message("{}: the field is too narrow for the {:.1f} m that a turn of this machine needs.",
                       passes, room.si());
    }
    if (headland.width >= room) {
        return message("{}: a turn of this machine, with a radius of {:.1f} m, needs {:.1f} m.", passes,
                       plan.request.machine.minTurningRadius().si(), room.si());
    }
    return message("{}: a turn to the next swath would need {:.1f} m, so turns are made in other ways.",
                   passes, room.si());
}

std::optional<Message> whyHeadland(const Plan& plan) {
    const Headland& headland = plan.headland;
    if (headland.isPerimeterOnly) {
        return message("One pass all round works the whole field.");
    }
    if (headland.passes == 0 || headland.width <= Length{}) {
        return whyNoHeadland(plan);
    }
    return headland.strips.empty() ? whyThisWidth(plan) : whyPerEdge(plan);
}

// Swaths.

/// "3 swaths and 9 min", or one of them; empty where both are about the same.
std::optional<Message> savedBetween(const HeadingTrial& less, const HeadingTrial& more) {
    const int swaths = more.figures.count - less.figures.count;
    const Duration time = more.figures.time - less.figures.time;
    if (!isWorthTelling(time, more.figures.time) || time < Duration{}) {
        return std::nullopt;
    }
    return swaths > 0 ? message("{} and {}", counted("{} swath", "{} swaths", swaths), timeMessage(time))
                      : timeMessage(time);
}

Message againstLongestEdge(const HeadingCurve& curve) {
    const HeadingTrial& chosen = curve.trials[curve.chosen];
    const HeadingTrial& edge = curve.trials[*curve.longestEdge];
    if (inDegrees(angleBetweenLines(chosen.heading, edge.heading)) < kSameShownDeg) {
        return message("{} runs along the longest edge", bearingMessage(chosen.heading));
    }
    if (const auto saved = savedBetween(chosen, edge)) {
        return message("{} saves {} against the longest edge ({})", bearingMessage(chosen.heading), *saved,
                       bearingMessage(edge.heading));
    }
    if (const auto lost = savedBetween(edge, chosen)) {
        return message("{} costs {} more than the longest edge ({})", bearingMessage(chosen.heading), *lost,
                       bearingMessage(edge.heading));
    }
    return message("{} is as quick as the longest edge ({})", bearingMessage(chosen.heading),
                   bearingMessage(edge.heading));
}

Message againstQuickest(const Plan& plan, const HeadingCurve& curve) {
    const HeadingTrial& chosen = curve.trials[curve.chosen];
    const HeadingTrial& quickest = curve.trials[curve.quickest];
    if (const auto lost = savedBetween(quickest, chosen)) {
        return message("by this estimate {} would save {}", bearingMessage(quickest.heading), *lost);
    }
    // A finding tells by how little the edge that was preferred is slower.
    return std::ranges::contains(plan.swaths.notes, kPreferEdge.key, &Note::where)
               ? message("no heading is much quicker")
               : message("no heading is quicker");
}

/// What the search looked for, where that is not the time.
std::optional<Message> byObjective(const Plan& plan, const HeadingCurve& curve) {
    const HeadingFigures& figures = curve.trials[curve.chosen].figures;
    if (!swathMethod(plan.request.settings).traits.searchesHeadings) {
        return std::nullopt;
    }
    switch (objectiveOf(plan.request.settings)) {
        case SwathObjective::Time: break;
        case SwathObjective::Count:
            return plan.swaths.proved
                       ? counted("No heading has fewer than {} swath.",
                                 "No heading has fewer than {} swaths.", figures.count)
                       : counted("No heading that was tried has fewer than {} swath.",
                                 "No heading that was tried has fewer than {} swaths.", figures.count);
        case SwathObjective::Length:
            return message("No heading that was tried has shorter swaths: {:.0f} m.",
                           plan.swaths.totalLength.si());
        case SwathObjective::Coverage:
            return message("No heading that was tried covers more: {:.2f} % inside the headland.",
                           100.0 * plan.swaths.coverage);
        case SwathObjective::Overlap:
            return message("No heading that was tried works less land twice: {:.0f} m².",
                           plan.swaths.overlap.si());
    }
    return std::nullopt;
}

std::optional<Message> whySwaths(const Plan& plan, const std::optional<HeadingCurve>& curve) {
    if (!curve || !curve->longestEdge) {
        return std::nullopt;
    }
    const Message compared =
        message("{}; {}.", againstLongestEdge(*curve), againstQuickest(plan, *curve)).capitalised();
    const auto objective = byObjective(plan, *curve);
    return objective ? *objective + " " + compared : compared;
}

// Cells.

std::optional<Message> whyCells(const Plan& plan) {
    const auto cells = static_cast<int>(plan.cells.cells.size());
    const DecompositionHistory& history = plan.cells.history;
    const auto pieces = static_cast<int>(history.pieces.size());
    if (cells == 1 && pieces <= 1) {
        return message("Nothing divides the swaths: one block.");
    }
    if (history.steps.size() > 1 && pieces > cells) {
        const Duration saved = history.steps.front().cost - history.steps.back().cost;
        return saved.si() >= kWorthTellingS
                   ? message(
                         "Cut into {} pieces where swaths are interrupted; joining them to {} saves {} of turns and ways.",
                         pieces, counted("{} block", "{} blocks", cells), timeMessage(saved))
                   : message("Cut into {} pieces where swaths are interrupted, joined to {}.", pieces,
                             counted("{} block", "{} blocks", cells));
    }
    return counted("Swaths are interrupted by corners or obstacles: {} block.",
                   "Swaths are interrupted by corners or obstacles: {} blocks.", cells);
}

// Order.

struct PatternCost {
    std::string_view name;
    double cost = 0.0;
};

/// Of the turns and ways of a plan in free space, and of the best plain pattern for its swaths; in the unit
/// of the objective.
struct OrderCosts {
    double own = 0.0;
    std::optional<PatternCost> plain;
};

Result<OrderCosts> orderCosts(const Plan& plan, const JobContext& job) {
    const RouteTask task = routeTask(plan.request, plan.swaths, plan.cells);
    RouteCosts costs{task};
    OrderCosts all{.own = costs.links().between(endOrder(plan.route.steps)), .plain = {}};
    for (const Method<RoutePlanner>* pattern : routePatterns()) {
        if (!pattern->traits.isPlain ||
            pattern->info.id == plan.request.settings.choice(*stageMethod("route"))) {
            continue;
        }
        const auto route = pattern->run(task, job);
        if (!route) {
            return std::unexpected(route.error());
        }
        const double cost = costs.links().between(endOrder(route->steps));
        if (!all.plain || cost < all.plain->cost) {
            all.plain = PatternCost{pattern->info.name, cost};
        }
    }
    return all;
}

Message costMessage(RouteObjective objective, double cost) {
    switch (objective) {
        case RouteObjective::Time: return timeMessage(seconds(cost));
        case RouteObjective::Length: return message("{:.0f} m", cost);
        case RouteObjective::Fuel: break;
    }
    return message("{:.1f} l", cost);
}

bool isAboutTheSame(double saved, double cost, RouteObjective objective) {
    return std::abs(saved) < kWorthTellingShare * cost ||
           (objective == RouteObjective::Time && std::abs(saved) < kWorthTellingS);
}

/// Nothing of a searched order that is dearer in free space only: in the field it is not.
std::optional<Message> againstPattern(const OrderCosts& costs, RouteObjective objective, bool isSearched) {
    if (!costs.plain || costs.plain->cost <= 0.0) {
        return std::nullopt;
    }
    const double saved = costs.plain->cost - costs.own;
    const double percent = 100.0 * std::abs(saved) / costs.plain->cost;
    const Message name{costs.plain->name};
    if (isAboutTheSame(saved, costs.plain->cost, objective)) {
        return message("Turns take about as much as with the pattern “{}”.", name);
    }
    if (saved > 0.0) {
        return message("Turns take {} less than with the pattern “{}” ({:.0f} %).",
                       costMessage(objective, saved), name, percent);
    }
    return isSearched ? std::nullopt
                      : std::optional{message("Turns take {} more than with the pattern “{}” ({:.0f} %).",
                                              costMessage(objective, -saved), name, percent)};
}

std::optional<Message> ofProof(const Plan& plan) {
    if (!plan.proof) {
        return std::nullopt;
    }
    const double gap = plan.proof->gap();
    return plan.proof->isBest()
               ? message("No order of these swaths is better; that is proved.")
               : message(
                     "No order of these swaths can save more than {:.1f} % of the turns, or {:.1f} % of all.",
                     100.0 * (1.0 - 1.0 / (1.0 + gap)), 100.0 * (1.0 - 1.0 / (1.0 + plan.proof->gapTotal())));
}

/// How often the work is interrupted to fill the tank or to empty the bunker.
std::optional<Message> ofTrips(const Plan& plan) {
    const int refills = plan.path.refillCount();
    if (refills == 0) {
        return std::nullopt;
    }
    const double wayM = plan.path.length(SegmentKind::Refill).si();
    const Duration stands = refills * plan.request.machine.spec().tank->fillTime();
    const Message times = message("{} of standing", timeMessage(stands));
    return plan.refill->work.gathers
               ? counted("{} unloading, with {:.0f} m of way to it and back and {}.",
                         "{} unloadings, with {:.0f} m of way to them and back and {}.", refills, wayM, times)
               : counted("{} refill, with {:.0f} m of way to it and back and {}.",
                         "{} refills, with {:.0f} m of way to them and back and {}.", refills, wayM, times);
}

/// One after the other, of those that are there.
std::optional<Message> together(std::optional<Message> first, std::optional<Message> second) {
    return first && second ? std::optional{*first + " " + *second} : first ? first : second;
}

Result<std::optional<Message>> whyOrder(const Plan& plan, const JobContext& job) {
    if (plan.route.steps.size() < 2) {
        return ofTrips(plan);
    }
    const auto costs = orderCosts(plan, job);
    if (!costs) {
        return std::unexpected(costs.error());
    }
    const auto pattern =
        againstPattern(*costs, routeObjective(plan.request.settings), plan.proof.has_value());
    const auto proof = ofProof(plan);
    return together(together(pattern, proof), ofTrips(plan));
}

// Turns.

struct ShapeCount {
    TurnShape shape = TurnShape::U;
    int count = 0;
    Duration time;
};

std::vector<ShapeCount> shapesOf(const std::vector<DrivenTurn>& turns) {
    std::vector<ShapeCount> shapes;
    for (const DrivenTurn& turn : turns) {
        auto known = std::ranges::find(shapes, turn.shape, &ShapeCount::shape);
        if (known == shapes.end()) {
            known = shapes.insert(known, {.shape = turn.shape});
        }
        ++known->count;
        known->time += turn.duration;
    }
    std::ranges::stable_sort(shapes, std::ranges::greater{}, &ShapeCount::count);
    return shapes;
}

Message shapeMessage(const ShapeCount& shape) {
    return message("{} × {}, {} each", shape.count, nameOf(shape.shape),
                   timeMessage(shape.time / shape.count));
}

/// The longest way without work, with the work before it.
std::optional<Message> longestWay(const Path& path) {
    const PathSegment* longest = nullptr;
    std::size_t at = 0;
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        const PathSegment& segment = path.segments[i];
        if (segment.kind == SegmentKind::Transfer && path.workBefore(i) != nullptr &&
            path.workAfter(i) != nullptr && (longest == nullptr || segment.length() > longest->length())) {
            longest = &segment;
            at = i;
        }
    }
    if (longest == nullptr) {
        return std::nullopt;
    }
    return message("The longest way without work, {:.0f} m, follows {}.", longest->length().si(),
                   nameOf(*path.workBefore(at)));
}

std::optional<Message> whyTurns(const Plan& plan) {
    const std::vector<ShapeCount> shapes = shapesOf(drivenTurns(plan.path));
    constexpr std::size_t kMostShapes = 3;
    std::optional<Message> told;
    int others = 0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        if (i >= kMostShapes && shapes.size() > kMostShapes + 1) {
            others += shapes[i].count;
            continue;
        }
        const Message one = shapeMessage(shapes[i]);
        told = told ? message("{}; {}", *told, one) : one;
    }
    if (others > 0) {
        told = message("{}; {} × other turns", *told, others);
    }
    const auto way = longestWay(plan.path);
    if (told) {
        told = *told + ".";
    }
    return told && way ? std::optional{*told + " " + *way} : told ? told : way;
}

// Check.

std::optional<Message> whyCheck(const Plan& plan) {
    const AuditReport& audit = plan.audit;
    if (!audit.outside || !audit.coveredShare) {
        return std::nullopt;
    }
    const Message outside = audit.outside->si() < kDryM2
                                ? message("Nothing stands outside of the field")
                                : message("{:.0f} m² are driven outside of the field", audit.outside->si());
    Message clearance = audit.minClearance && audit.minClearance->si() >= kTouchesM
                            ? message("{}; the machine keeps {:.2f} m from its edge at least.", outside,
                                      audit.minClearance->si())
                            : message("{}.", outside);
    return clearance;
}

std::optional<Message> whyField(const Plan& plan) {
    if (plan.margin <= Length{}) {
        return std::nullopt;
    }
    return plan.request.settings.isSet(kMargin)
               ? message("Everything keeps {:.2f} m from the boundary, as chosen.", plan.margin.si())
               : message("Everything keeps {:.2f} m from the boundary: no more is known of where it runs.",
                         plan.margin.si());
}

}  // namespace

Result<std::vector<Explanation>> explanations(const Plan& plan, const std::optional<HeadingCurve>& curve,
                                              const JobContext& job) {
    const auto order = whyOrder(plan, job);
    if (!order) {
        return std::unexpected(order.error());
    }
    const std::pair<std::string_view, std::optional<Message>> all[] = {
        {"field", whyField(plan)},
        {"headland", whyHeadland(plan)},
        {"swaths", whySwaths(plan, curve)},
        {"decomposition", whyCells(plan)},
        {"route", *order},
        {"path", whyTurns(plan)},
        {"check", whyCheck(plan)},
    };
    std::vector<Explanation> told;
    for (const auto& [step, text] : all) {
        if (text) {
            told.push_back({step, *text});
        }
    }
    return told;
}

}  // namespace furrow
