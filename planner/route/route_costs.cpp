#include "planner/route/route_costs.h"

#include "planner/route/given_steps.h"
#include "planner/route/methods.h"
#include "planner/turns/connection.h"
#include "planner/turns/straight_turn.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <string>

namespace furrow {

namespace {

/// Added where no way fits: the order goes elsewhere if it can.
constexpr Duration kNoWay = seconds(300.0);
/// Of the time in which the wheels are turned. A way with clothoids in the place of jumps of the curvature is
/// longer by half of what is driven meanwhile; where the machine stands, all of it counts.
constexpr double kSteeringShare = 0.75;
/// Of what parts locked swaths, and of another first swath than the chosen one.
constexpr double kBroken = 1e5;
constexpr double kSecondsPerHour = 3600.0;

constexpr Choice kObjectives[] = {
    {"time", "Time", "The least time for turns and ways."},
    {"length", "Length", "The shortest turns and ways."},
    {"fuel", "Fuel", "The least fuel for turns and ways; the least time if the machine has no fuel figures."},
};

/// What turning the wheels costs, from straight to straight. On a short straight between two bends to the
/// same side they are not turned back: it costs no more than the straight itself.
Duration steering(const Curve& way, const Machine& machine) {
    Duration sum;
    const auto pieces = std::span{way.pieces};
    Curvature before;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Duration turned = kSteeringShare * machine.steeringDuration(before, pieces[i].curvature);
        const bool isBetween = i > 0 && i + 1 < pieces.size() && pieces[i].curvature == Curvature{} &&
                               pieces[i].gear == pieces[i - 1].gear && pieces[i].gear == pieces[i + 1].gear &&
                               before.si() * pieces[i + 1].curvature.si() > 0.0;
        if (isBetween) {
            const Duration there = kSteeringShare * machine.steeringDuration({}, pieces[i + 1].curvature);
            sum += std::min(turned + there, seconds(pieces[i].length.si() / machine.turningSpeed().si()));
            before = pieces[i + 1].curvature;
        } else {
            sum += turned;
            before = pieces[i].endCurvature;
        }
    }
    return sum + kSteeringShare * machine.steeringDuration(before, {});
}

}  // namespace

RouteObjective routeObjective(const Settings& settings) {
    const std::string id = settings.choice(kRouteObjective);
    return id == "length" ? RouteObjective::Length
           : id == "fuel" ? RouteObjective::Fuel
                          : RouteObjective::Time;
}

RouteCosts::RouteCosts(const RouteTask& task)
    : task_{task}, objective_{routeObjective(task.settings)}, links_{task.swaths.swaths.size(), functions()} {
    const Tractor& tractor = task.machine.spec().tractor;
    const double fastest =
        std::max({tractor.turningSpeed.si(), tractor.reverseSpeed.si(), tractor.transferSpeed.si()});
    costPerMetre_ = costOf(metres(1.0), seconds(1.0 / fastest));
    const auto ends = static_cast<SwathEnd>(links_.endCount());
    for (SwathEnd end = 0; end < ends; ++end) {
        lines_.push_back(drivenLine(stepEntering(end), task.swaths, task.machine));
    }
    next_.resize(ends);
    std::iota(next_.begin(), next_.end(), SwathEnd{0});
    before_ = next_;
    isWrongWay_.assign(ends, 0);
    const EndOrder locked = endOrder(
        givenSteps(task.settings, kLocked, task.swaths.swaths.size()).value_or(std::vector<RouteStep>{}));
    for (std::size_t i = 0; i < locked.size(); ++i) {
        isWrongWay_[otherEnd(locked[i])] = 1;
        if (i > 0) {
            next_[otherEnd(locked[i - 1])] = locked[i];
            before_[locked[i]] = otherEnd(locked[i - 1]);
        }
    }
    const auto index = [](int number) { return static_cast<std::size_t>(number - 1); };
    first_ = task.settings.count(kFirstSwath).transform(index);
    last_ = task.settings.count(kLastSwath).transform(index);
    // A swath that is named for the beginning is entered at either end.
    if (task.settings.choice(kCorner) == "first" && !first_) {
        begin_ = 0;
    }
    for (SwathEnd end = 0; end < ends; ++end) {
        left_.push_back(lines_[otherEnd(end)].end());
    }
    for (std::size_t swath = 0; swath < task.swaths.swaths.size(); ++swath) {
        working_ += workingOn(swath);
    }
}

double RouteCosts::costOf(Length length, Duration time, double FuelUse::* litresPerHour) const {
    const std::optional<FuelUse>& fuel = task_.machine.spec().fuel;
    if (objective_ == RouteObjective::Length) {
        return length.si();
    }
    return objective_ == RouteObjective::Fuel && fuel ? time.si() * *fuel.*litresPerHour / kSecondsPerHour
                                                      : time.si();
}

double RouteCosts::costOf(const Curve& way, const Pose& from, const Pose& to) const {
    const Machine& machine = task_.machine;
    const Duration time = drivenDuration(way, from, to, machine);
    const Implement& implement = machine.spec().implement;
    return costOf(way.length(),
                  std::max(time + steering(way, machine), implement.liftTime + implement.lowerTime));
}

bool RouteCosts::isLockedOut(SwathEnd leaving, SwathEnd entered) const {
    return isWrongWay_[entered] != 0 || isWrongWay_[otherEnd(leaving)] != 0 ||
           (next_[leaving] != leaving && next_[leaving] != entered) ||
           (before_[entered] != entered && before_[entered] != leaving);
}

bool RouteCosts::isWrongFirst(SwathEnd entered) const {
    return before_[entered] != entered || (begin_ && entered != *begin_) ||
           (first_ && entered / 2 != *first_);
}

bool RouteCosts::isWrongLast(SwathEnd left) const {
    return next_[left] != left || (last_ && left / 2 != *last_);
}

bool RouteCosts::isBroken(const EndOrder& order) const {
    bool broken = !order.empty() && (isWrongFirst(order.front()) || isWrongLast(otherEnd(order.back())));
    for (std::size_t i = 1; i < order.size(); ++i) {
        broken = broken || isLockedOut(otherEnd(order[i - 1]), order[i]);
    }
    return broken;
}

double RouteCosts::workingOn(std::size_t swath) const {
    const Length length = task_.swaths.swaths[swath].length();
    const Duration time = seconds(length.si() / task_.machine.spec().tractor.workingSpeed.si());
    return costOf(length, time, &FuelUse::workingLph);
}

LinkCosts::Functions RouteCosts::functions() {
    LinkCosts::Functions costs;
    costs.link = [this](SwathEnd leaving, SwathEnd entered) {
        const Pose& from = left_[leaving];
        const Pose& to = lines_[entered].start;
        return costOf(connection(from, to, task_.machine, task_.turn), from, to) +
               (isLockedOut(leaving, entered) ? kBroken : 0.0);
    };
    costs.atLeast = [this](SwathEnd a, SwathEnd b) {
        return costPerMetre_ * std::min(distance(left_[a].position, lines_[b].start.position),
                                        distance(left_[b].position, lines_[a].start.position));
    };
    costs.begin = [this](SwathEnd entered) {
        return (isWrongFirst(entered) ? kBroken : 0.0) +
               (task_.start ? costPerMetre_ * distance(*task_.start, lines_[entered].start.position) : 0.0);
    };
    costs.finish = [this](SwathEnd left) {
        return (isWrongLast(left) ? kBroken : 0.0) +
               (task_.end ? costPerMetre_ * distance(left_[left].position, *task_.end) : 0.0);
    };
    if (task_.way) {
        const double noWay = costOf(metres(kNoWay.si() * task_.machine.turningSpeed().si()), kNoWay);
        costs.fitting = [this, noWay](SwathEnd leaving, SwathEnd entered) -> std::optional<double> {
            const auto way = task_.way(stepEntering(otherEnd(leaving)), stepEntering(entered), effort_);
            if (!way && effort_ == SearchEffort::None) {
                return std::nullopt;
            }
            return way ? costOf(*way, left_[leaving], lines_[entered].start)
                       : links_.link(leaving, entered) + noWay;
        };
    }
    return costs;
}

const Parameter kRouteObjective{.key = "route.objective",
                                .name = "Saves",
                                .description = "What the order of the swaths is to save.",
                                .kind = ParameterKind::Choice,
                                .standard = 0.0,
                                .choices = kObjectives};

}  // namespace furrow
