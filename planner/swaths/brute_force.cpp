#include "planner/swaths/edge_preference.h"
#include "planner/swaths/methods.h"

#include <cmath>

namespace furrow {

namespace {

Result<SwathSet> bruteForce(const SwathTask& task, const JobContext& job) {
    const auto scanLine = scanLineFor(task);
    if (!scanLine) {
        return std::unexpected(scanLine.error());
    }
    const double stepDeg = inDegrees(*task.settings.angle(kStep));
    std::vector<Angle> headings;
    for (int i = 0; i * stepDeg < 180.0; ++i) {
        headings.push_back(degrees(i * stepDeg));
    }
    const SwathObjective objective = objectiveOf(task.settings);
    const auto heading = bestHeading(*scanLine, headings, objective, job);
    if (!heading) {
        return std::unexpected(heading.error());
    }
    auto set = swathsOfBest(*scanLine, task, objective, *heading, {}, job);
    if (set) {
        set->headingsTried = static_cast<int>(headings.size());
    }
    return set;
}

constexpr const Parameter* kBruteForceParameters[] = {&kObjective, &kPreferEdge, &kStep};

}  // namespace

const Parameter kStep{.key = "swaths.step_deg",
                      .name = "Step",
                      .description = "Between the headings that are tried.",
                      .kind = ParameterKind::Angle,
                      .standard = 1.0,
                      .min = 0.01,
                      .max = 90.0,
                      .step = 0.5,
                      .choices = {}};

const Method<SwathGenerator> kBruteForceMethod{
    .info = {.id = "brute-force",
             .name = "Best of all headings",
             .description = "Tries every heading in steps and keeps the best.",
             .parameters = kBruteForceParameters},
    .run = bruteForce,
    .traits = {.searchesHeadings = true}};

}  // namespace furrow
