#include "planner/swaths/edge_preference.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <vector>

namespace furrow {

namespace {

constexpr double kFirstStepDeg = 30.0;
constexpr double kLastStepDeg = 0.5;
constexpr std::size_t kKept = 3;

/// Tries six headings all round and keeps the best three. Their neighbours at half the step join them, and so
/// on (Oksanen & Visala 2009, doi 10.1002/rob.20300).
Result<SwathSet> oksanen(const SwathTask& task, const JobContext& job) {
    const auto scanLine = scanLineFor(task);
    if (!scanLine) {
        return std::unexpected(scanLine.error());
    }
    const SwathObjective objective = objectiveOf(task.settings);
    std::vector<BestHeading> candidates;
    const auto tryHeading = [&](Angle heading) {
        heading = normalisedSwathHeading(heading);
        if (std::ranges::find(candidates, heading, &BestHeading::heading) == candidates.end()) {
            candidates.push_back({heading, scanLine->figures(heading, objective)});
        }
    };
    for (double deg = 0.0; deg < 180.0; deg += kFirstStepDeg) {
        tryHeading(degrees(deg));
    }
    auto tried = candidates.size();
    for (double stepDeg = 0.5 * kFirstStepDeg; stepDeg >= kLastStepDeg; stepDeg *= 0.5) {
        if (job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        std::ranges::stable_sort(candidates, [&](const BestHeading& a, const BestHeading& b) {
            return isBetter(objective, a.figures, b.figures);
        });
        candidates.resize(std::min(kKept, candidates.size()));
        for (std::size_t i = 0, kept = candidates.size(); i < kept; ++i) {
            const Angle heading = candidates[i].heading;
            tryHeading(heading - degrees(stepDeg));
            tryHeading(heading + degrees(stepDeg));
        }
        tried += candidates.size() - std::min(kKept, candidates.size());
    }
    const auto best = std::ranges::min_element(candidates, [&](const BestHeading& a, const BestHeading& b) {
        return isBetter(objective, a.figures, b.figures);
    });
    auto set = swathsOfBest(*scanLine, task, objective, *best, candidates, job);
    if (set) {
        set->headingsTried = static_cast<int>(tried);
    }
    return set;
}

constexpr const Parameter* kOksanenParameters[] = {&kObjective, &kPreferEdge};

}  // namespace

const Method<SwathGenerator> kOksanenMethod{
    .info = {.id = "oksanen",
             .name = "Quick search",
             .description = "Six directions, then ever finer around the best three (Oksanen & Visala).",
             .parameters = kOksanenParameters},
    .run = oksanen,
    .traits = {.searchesHeadings = true}};

}  // namespace furrow
