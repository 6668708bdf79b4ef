#include "planner/route/order_edits.h"

#include <algorithm>
#include <array>
#include <limits>

namespace furrow {

namespace {

/// Directions by dynamic programming over the end at which each step is left.
void chooseDirections(std::vector<RouteStep>& steps, const SwathSet& swaths) {
    struct Choice {
        std::array<double, 2> cost{};  ///< with this step forwards, reversed
        std::array<bool, 2> before{};  ///< whether the step before is reversed then
    };
    const auto mayBe = [&](std::size_t i, bool reversed) {
        return reversed == steps[i].reversed || !swaths.swaths[steps[i].swath].isClosed();
    };
    const auto step = [&](std::size_t i, bool reversed) {
        return RouteStep{.swath = steps[i].swath, .reversed = reversed};
    };
    constexpr double kNever = std::numeric_limits<double>::infinity();
    std::vector<Choice> choices(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        for (const bool reversed : {false, true}) {
            double& cost = choices[i].cost[reversed ? 1 : 0];
            cost = !mayBe(i, reversed) ? kNever : i == 0 ? 0.0 : kNever;
            if (i == 0 || !mayBe(i, reversed)) {
                continue;
            }
            const Point start = startPose(step(i, reversed), swaths).position;
            for (const bool before : {false, true}) {
                const double way = choices[i - 1].cost[before ? 1 : 0] +
                                   distance(endPose(step(i - 1, before), swaths).position, start);
                if (way < cost) {
                    cost = way;
                    choices[i].before[reversed ? 1 : 0] = before;
                }
            }
        }
    }
    bool reversed = choices.back().cost[1] < choices.back().cost[0];
    if (choices.back().cost[0] == choices.back().cost[1]) {
        reversed = steps.back().reversed;
    }
    for (std::size_t i = steps.size(); i-- > 0;) {
        steps[i].reversed = reversed;
        reversed = choices[i].before[reversed ? 1 : 0];
    }
}

}  // namespace

std::vector<RouteStep> withStepMoved(const std::vector<RouteStep>& steps, std::size_t from, std::size_t to,
                                     const SwathSet& swaths) {
    std::vector<RouteStep> moved = steps;
    const auto at = [&](std::size_t place) { return moved.begin() + static_cast<std::ptrdiff_t>(place); };
    if (from < to) {
        std::rotate(at(from), at(from + 1), at(to + 1));
    } else if (to < from) {
        std::rotate(at(to), at(from), at(from + 1));
    } else {
        return moved;
    }
    chooseDirections(moved, swaths);
    return moved;
}

std::vector<RouteStep> withStepTurned(std::vector<RouteStep> steps, std::size_t at, const SwathSet& swaths) {
    RouteStep& step = steps[at];
    step.reversed = step.reversed != !swaths.swaths[step.swath].isClosed();
    return steps;
}

std::string orderText(const std::vector<RouteStep>& steps) {
    std::string text;
    for (const RouteStep& step : steps) {
        text += (text.empty() ? "" : ",") + std::string{step.reversed ? "-" : ""} +
                std::to_string(step.swath + 1);
    }
    return text;
}

}  // namespace furrow
