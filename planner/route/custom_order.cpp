#include "planner/route/given_steps.h"
#include "planner/route/methods.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace furrow {

namespace {

/// The first few of these numbers as text.
Message listed(const std::vector<int>& numbers) {
    constexpr std::size_t kShown = 5;
    std::string text;
    for (std::size_t i = 0; i < std::min(kShown, numbers.size()); ++i) {
        text += (i == 0 ? "" : ", ") + std::to_string(numbers[i]);
    }
    return numbers.size() > kShown ? message("{} and {} more", text, numbers.size() - kShown) : Message{text};
}

Result<Route> customOrder(const RouteTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    const auto count = static_cast<int>(task.swaths.swaths.size());
    auto steps = givenSteps(task.settings, kOrder, task.swaths.swaths.size());
    if (!steps) {
        return std::unexpected(steps.error());
    }
    Route route{.steps = *std::move(steps), .lengthInPlace = {}};
    std::vector<int> missing;
    for (int number = 1; number <= count; ++number) {
        if (!std::ranges::contains(route.steps, static_cast<std::size_t>(number - 1), &RouteStep::swath)) {
            missing.push_back(number);
        }
    }
    if (!missing.empty()) {
        return std::unexpected(refused(
            kOrder,
            message("{} of {} swaths are not in the order: {}", missing.size(), count, listed(missing)),
            "name each swath once, with a minus where it is driven backwards"));
    }
    route.lengthInPlace = lengthInPlace(route.steps, task.swaths);
    return route;
}

constexpr const Parameter* kCustomOrderParameters[] = {&kOrder};

}  // namespace

Error refused(const Parameter& parameter, Message what, Message remedy) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = std::string{parameter.key},
            .remedy = std::move(remedy)};
}

Result<std::vector<RouteStep>> givenSteps(const Settings& settings, const Parameter& parameter,
                                          std::size_t swathCount) {
    const auto count = static_cast<int>(swathCount);
    std::vector<bool> named(swathCount);
    std::vector<RouteStep> steps;
    for (const int number : settings.numbers(parameter)) {
        if (number == 0 || number < -count || number > count) {
            return std::unexpected(refused(parameter,
                                           message("there is no swath {}", std::abs(std::int64_t{number})),
                                           message("use the numbers from 1 to {}", count)));
        }
        const auto swath = static_cast<std::size_t>(std::abs(number) - 1);
        if (named[swath]) {
            return std::unexpected(refused(parameter, message("swath {} is named twice", std::abs(number)),
                                           "name each swath once"));
        }
        named[swath] = true;
        steps.push_back({.swath = swath, .reversed = number < 0});
    }
    return steps;
}

const Parameter kOrder{.key = "route.order",
                       .name = "Order",
                       .description = "Swath numbers in driving order; a minus drives one the other way.",
                       .kind = ParameterKind::Numbers,
                       .standard = {},
                       .choices = {}};

const Method<RoutePlanner> kCustomMethod{
    .info = {.id = "custom",
             .name = "Your own order",
             .description = "The swaths in the order and direction that you type.",
             .parameters = kCustomOrderParameters},
    .run = customOrder,
    .traits = {.isByHand = true}};

}  // namespace furrow
