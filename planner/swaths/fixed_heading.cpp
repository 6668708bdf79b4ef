#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"

namespace furrow {

namespace {

Result<SwathSet> fixedHeading(const SwathTask& task, const JobContext& job) {
    if (job.stopRequested()) {
        return std::unexpected(cancelled());
    }
    return scanLineFor(task).and_then([&](const ScanLine& scanLine) {
        return swathsAlong(scanLine, task, *task.settings.angle(kAngle), SwathObjective::Coverage, job);
    });
}

constexpr const Parameter* kFixedHeadingParameters[] = {&kAngle};

}  // namespace

const Parameter kAngle{.key = "swaths.angle_deg",
                       .name = "Direction",
                       .description = "Of the swaths.",
                       .kind = ParameterKind::Angle,
                       .standard = 0.0,
                       .min = -360.0,
                       .max = 360.0,
                       .step = 1.0,
                       .choices = {}};

const Method<SwathGenerator> kFixedHeadingMethod{
    .info = {.id = "fixed",
             .name = "Given direction",
             .description = "All swaths in the direction that you type.",
             .parameters = kFixedHeadingParameters},
    .run = fixedHeading};

}  // namespace furrow
