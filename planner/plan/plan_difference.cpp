#include "planner/plan/plan_difference.h"

#include "planner/geometry/curve.h"
#include "planner/plan/method_registry.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// A boom is not steered more exactly than this.
constexpr double kSamePlaceM = 0.1;
// Smaller differences would read as none.
constexpr double kLeast = 1.0;

bool isNear(Point a, Point b) {
    return std::hypot(a.x - b.x, a.y - b.y) <= kSamePlaceM;
}

bool isSame(const Swath& a, const Swath& b) {
    const bool ends = (isNear(a.start, b.start) && isNear(a.end, b.end)) ||
                      (isNear(a.start, b.end) && isNear(a.end, b.start));
    return ends && std::abs(lineOf(a).length().si() - lineOf(b).length().si()) <= kSamePlaceM;
}

std::vector<std::size_t> onlyIn(const SwathSet& set, const SwathSet& other) {
    std::vector<std::size_t> only;
    for (std::size_t i = 0; i < set.swaths.size(); ++i) {
        if (std::ranges::none_of(other.swaths,
                                 [&swath = set.swaths[i]](const Swath& its) { return isSame(swath, its); })) {
            only.push_back(i);
        }
    }
    return only;
}

std::optional<double> squareMetresOf(const std::optional<Area>& area) {
    return area.transform([](Area measured) { return measured.si(); });
}

}  // namespace

Better betterOf(Figure figure) {
    switch (figure) {
        case Figure::Covered: return Better::More;
        case Figure::Working:
        case Figure::Swaths: return Better::Neither;
        default: return Better::Less;
    }
}

std::optional<double> figureOf(const Plan& plan, Figure figure) {
    switch (figure) {
        case Figure::Time: return plan.path.duration().si();
        case Figure::Path: return plan.path.length().si();
        case Figure::Working: return plan.path.workedLength().si();
        case Figure::Turning: return (plan.path.length() - plan.path.workedLength()).si();
        case Figure::Swaths: return static_cast<double>(plan.swaths.swaths.size());
        case Figure::Covered: return squareMetresOf(plan.audit.covered);
        case Figure::Missed: return squareMetresOf(plan.audit.missed);
        case Figure::Overlap: return squareMetresOf(plan.audit.overlap);
        case Figure::Outside: return squareMetresOf(plan.audit.outside);
        case Figure::Reversed: return plan.audit.reversed.si();
        case Figure::Problems: break;
    }
    return static_cast<double>(plan.blockingCount());
}

int better(Figure figure, std::optional<double> first, std::optional<double> second) {
    const Better wanted = betterOf(figure);
    if (wanted == Better::Neither || !first || !second || std::abs(*first - *second) < kLeast) {
        return 0;
    }
    return (*first < *second) == (wanted == Better::Less) ? -1 : 1;
}

PlanDifference differenceOf(const Plan& first, const Plan& second) {
    PlanDifference difference{.machine = first.request.machine != second.request.machine,
                              .settings = {},
                              .onlyInFirst = onlyIn(first.swaths, second.swaths),
                              .onlyInSecond = onlyIn(second.swaths, first.swaths)};
    for (const Parameter* parameter : allParameters()) {
        const SettingValue mine = first.request.settings.value(*parameter);
        const SettingValue its = second.request.settings.value(*parameter);
        if (mine != its) {
            difference.settings.push_back({.parameter = parameter, .first = mine, .second = its});
        }
    }
    return difference;
}

}  // namespace furrow
