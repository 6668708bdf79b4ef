#include "planner/plan/heading_curve.h"

#include "planner/jobs/parallel.h"
#include "planner/swaths/edge_preference.h"
#include "planner/swaths/heading_search.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

constexpr double kStepDeg = 1.0;
// Headings closer than this are one.
constexpr double kSameTrialDeg = 1e-6;
// Differences below are rounding.
constexpr double kTimeSlackS = 0.05;
constexpr double kAreaSlackM2 = 0.5;

bool areSame(Angle a, Angle b) {
    return inDegrees(angleBetweenLines(a, b)) < kSameTrialDeg;
}

bool hasCommonHeading(const Plan& plan) {
    return !plan.swaths.isCurved() && !plan.swaths.swaths.empty() && !plan.headland.mainland.empty() &&
           std::ranges::all_of(plan.cells.cells, [&](const Cell& cell) {
               return cell.swaths.empty() || areSame(cell.heading, plan.swaths.heading);
           });
}

/// Every whole degree of bearing, and the headings that are marked.
std::vector<Angle> headingsToTry(Angle chosen, Angle longestEdge) {
    std::vector<Angle> headings{chosen};
    const auto add = [&](Angle heading) {
        if (std::ranges::none_of(headings, [&](Angle other) { return areSame(other, heading); })) {
            headings.push_back(normalisedSwathHeading(heading));
        }
    };
    add(longestEdge);
    for (double bearing = 0.0; bearing < 180.0; bearing += kStepDeg) {
        add(degrees(90.0 - bearing));
    }
    std::ranges::sort(headings, {}, lineBearingDeg);
    return headings;
}

bool isBeatenBy(const HeadingTrial& a, const HeadingTrial& b) {
    const double time = (a.figures.time - b.figures.time).si();
    const double overlap = (a.figures.overlap - b.figures.overlap).si();
    const double missed = (a.missed - b.missed).si();
    return time >= -kTimeSlackS && overlap >= -kAreaSlackM2 && missed >= -kAreaSlackM2 &&
           (time > kTimeSlackS || overlap > kAreaSlackM2 || missed > kAreaSlackM2);
}

void markTradeOffs(std::vector<HeadingTrial>& trials) {
    for (HeadingTrial& trial : trials) {
        trial.isTradeOff =
            trial.figures.count > 0 && std::ranges::none_of(trials, [&](const HeadingTrial& other) {
                return other.figures.count > 0 && isBeatenBy(trial, other);
            });
    }
}

std::size_t indexOf(const std::vector<Angle>& headings, Angle heading) {
    const auto found = std::ranges::find_if(headings, [&](Angle each) { return areSame(each, heading); });
    return static_cast<std::size_t>(found - headings.begin());
}

std::size_t quickestOf(const std::vector<HeadingTrial>& trials) {
    const auto quickest = std::ranges::min_element(trials, [](const HeadingTrial& a, const HeadingTrial& b) {
        return isBetter(SwathObjective::Time, a.figures, b.figures);
    });
    return static_cast<std::size_t>(quickest - trials.begin());
}

}  // namespace

Result<std::optional<HeadingCurve>> headingCurve(const Plan& plan, const JobContext& job) {
    if (!hasCommonHeading(plan)) {
        return std::nullopt;
    }
    const Machine& machine = plan.request.machine;
    const SwathTask task{.field = plan.field(),
                         .mainland = plan.headland.mainland,
                         .machine = machine,
                         .settings = plan.request.settings};
    const auto scanLine = scanLineFor(task);
    if (!scanLine) {
        return std::unexpected(scanLine.error());
    }
    const Angle chosen = normalisedSwathHeading(plan.swaths.heading);
    const Angle edge = longestEdgeHeading(task);
    const std::vector<Angle> headings = headingsToTry(chosen, edge);
    const double paceMps = machine.spec().tractor.workingSpeed.si();
    auto trials = parallelMap<HeadingTrial>(
        headings.size(),
        [&](std::size_t i) {
            const HeadingFigures figures = scanLine->figures(headings[i], SwathObjective::Time);
            const double worked = (figures.length + kPiecemealFactor * figures.missed).si() / paceMps;
            return HeadingTrial{.heading = headings[i],
                                .figures = figures,
                                .turning = seconds(std::max(0.0, figures.time.si() - worked)),
                                .missed = squareMetres(figures.missed.si() * machine.operatingWidth().si())};
        },
        job);
    if (!trials) {
        return std::unexpected(trials.error());
    }
    markTradeOffs(*trials);
    HeadingCurve curve{.trials = *std::move(trials)};
    curve.chosen = indexOf(headings, chosen);
    curve.quickest = quickestOf(curve.trials);
    // The chosen heading is as quick where nothing tells them apart.
    if ((curve.trials[curve.chosen].figures.time - curve.trials[curve.quickest].figures.time).si() <
        kTimeSlackS) {
        curve.quickest = curve.chosen;
    }
    curve.longestEdge = indexOf(headings, edge);
    return curve;
}

}  // namespace furrow
