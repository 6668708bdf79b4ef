#include "planner/swaths/heading_search.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/jobs/parallel.h"
#include "planner/swaths/left_on_purpose.h"
#include "planner/swaths/methods.h"
#include "planner/turns/dubins.h"
#include "planner/turns/straight_turn.h"
#include "planner/units/angle.h"

#include <algorithm>

namespace furrow {

namespace {

constexpr double kRoomSlackM = 0.01;

constexpr Choice kLastPasses[] = {
    {"overlap", "Overlaps its neighbour", "Full spacing; the last swath is moved back to the edge."},
    {"spread", "Spread over all", "The spacing is reduced evenly so that all fit."},
    {"gap", "Left out",
     "Full spacing; a rest of less than half a width stays uncovered, where it costs least."},
};

LastPass lastPassOf(const Settings& settings) {
    const std::string id = settings.choice(kLastPass);
    return id == "spread" ? LastPass::Spread : id == "gap" ? LastPass::Gap : LastPass::Overlap;
}

/// Whether the field continues for half a width beyond the mainland's edge.
bool hasRoomBeside(const SwathTask& task) {
    const Length half = 0.5 * task.machine.operatingWidth();
    const BoundaryDistance edges{task.field.workable(), half};
    bool hasRoom = true;
    forEachEdge(task.mainland, [&](Point from, Point) {
        hasRoom = hasRoom && edges.insideM(from).value_or(half.si()) >= half.si() - kRoomSlackM;
    });
    return hasRoom;
}

/// A machine that turns on the spot brakes at the end of a swath, turns twice and speeds up, unless there is
/// room for a curve and that is quicker. Of other machines the curve is the whole: what they brake differs
/// too little between headings.
DrivingModel drivingModel(const SwathTask& task, Length spacing) {
    const Machine& machine = task.machine;
    const Tractor& tractor = machine.spec().tractor;
    const DrivingModel withCurves{.working = tractor.workingSpeed,
                                  .turning = machine.turningSpeed(),
                                  .radius = machine.minTurningRadius(),
                                  .lead = -machine.spec().implement.offset};
    if (!canTurnOnTheSpot(machine)) {
        return withCurves;
    }
    const Pose from;
    const Pose to{.position = {0.0, spacing.si()}, .heading = degrees(180.0)};
    const Duration braking = seconds(tractor.workingSpeed.si() / tractor.maxAcceleration.si());
    const Duration onTheSpot = roughDuration(straightTurn(from, to), from, to, machine) + braking;
    if (hasRoomBeside(task) && roughDuration(dubinsTurn(from, to, withCurves.radius), machine) < onTheSpot) {
        return withCurves;
    }
    return {.working = withCurves.working,
            .turning = tractor.turningSpeed,
            .radius = {},
            .lead = withCurves.lead,
            .change = onTheSpot - seconds(spacing.si() / tractor.turningSpeed.si())};
}

}  // namespace

Result<SwathSpacing> spacingFor(const SwathTask& task, std::optional<Point> anchor) {
    SwathSpacing spacing{.width = task.machine.operatingWidth(),
                         .overlap = *task.settings.length(kOverlap),
                         .lastPass = lastPassOf(task.settings),
                         .anchor = anchor};
    if (spacing.overlap >= spacing.width) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = message("an overlap of {} m leaves nothing of {} m",
                                                     spacing.overlap.si(), spacing.width.si()),
                                     .where = std::string{kOverlap.key},
                                     .remedy = "give less than the operating width"});
    }
    spacing.overEdge = spacing.lastPass == LastPass::Gap && hasRoomBeside(task);
    return spacing;
}

Result<void> checkTrackCount(const SwathSpacing& spacing, Length across) {
    constexpr auto kMostTracks = static_cast<double>(kMostSwaths);
    const Length step = spacing.width - spacing.overlap;
    const double count = across / step;
    if (count <= kMostTracks) {
        return {};
    }
    return std::unexpected(Error{
        .code = ErrorCode::InputRefused,
        .what = message("{:.3f} m for each swath gives {:.0f} swaths, and no plan may have more than {:.0f}",
                        step.si(), count, kMostTracks),
        .where = "operating_width_m",
        .remedy = "check the operating width and the overlap"});
}

Error noSwathFits() {
    return {.code = ErrorCode::InputRefused,
            .what = "no swath fits inside the headland",
            .where = "swaths",
            .remedy = "choose a narrower headland or a narrower machine"};
}

Result<ScanLine> scanLineFor(const SwathTask& task, std::optional<Point> anchor) {
    const auto spacing = spacingFor(task, anchor);
    if (!spacing) {
        return std::unexpected(spacing.error());
    }
    ScanLine scanLine{task.mainland, *spacing, drivingModel(task, spacing->width - spacing->overlap)};
    if (const auto checked = checkTrackCount(*spacing, scanLine.diameter()); !checked) {
        return std::unexpected(checked.error());
    }
    return scanLine;
}

Result<BestHeading> bestHeading(const ScanLine& scanLine, std::span<const Angle> headings,
                                SwathObjective objective, const JobContext& job) {
    // If lines decide, areas are only measured for headings with the best lines.
    std::vector<Angle> left{headings.begin(), headings.end()};
    if (isOfLines(objective)) {
        const auto lines = parallelMap<HeadingFigures>(
            left.size(), [&](std::size_t i) { return scanLine.lineFigures(left[i], objective); },
            job.part(0.0, 0.8));
        if (!lines) {
            return std::unexpected(lines.error());
        }
        const HeadingFigures best = *std::ranges::min_element(
            *lines,
            [&](const HeadingFigures& a, const HeadingFigures& b) { return isBetter(objective, a, b); });
        left.clear();
        for (std::size_t i = 0; i < headings.size(); ++i) {
            if (isAsGood(objective, (*lines)[i], best)) {
                left.push_back(headings[i]);
            }
        }
    }
    const auto figures = parallelMap<HeadingFigures>(
        left.size(), [&](std::size_t i) { return scanLine.figures(left[i], objective); },
        isOfLines(objective) ? job.part(0.8, 1.0) : job);
    if (!figures) {
        return std::unexpected(figures.error());
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < left.size(); ++i) {
        if (isBetter(objective, (*figures)[i], (*figures)[best])) {
            best = i;
        }
    }
    return BestHeading{left[best], (*figures)[best]};
}

Result<SwathSet> swathsAlong(const ScanLine& scanLine, const SwathTask& task, Angle heading,
                             SwathObjective objective, const JobContext& job) {
    SwathSet set = scanLine.swaths(normalisedSwathHeading(heading), objective);
    if (set.swaths.empty()) {
        return std::unexpected(noSwathFits());
    }
    return besideLanes(set, task.mainland, job).transform([&](MultiPolygon left) {
        set.leftOnPurpose = std::move(left);
        return std::move(set);
    });
}

const Parameter kOverlap{.key = "swaths.overlap_m",
                         .name = "Overlap",
                         .description = "How much neighbouring swaths overlap.",
                         .kind = ParameterKind::Length,
                         .standard = 0.0,
                         .min = 0.0,
                         .max = 50.0,
                         .step = 0.05,
                         .choices = {}};

const Parameter kLastPass{.key = "swaths.last_pass",
                          .name = "Last pass",
                          .description = "What becomes of the width that is left over at the far side.",
                          .kind = ParameterKind::Choice,
                          .standard = 0.0,
                          .choices = kLastPasses};

}  // namespace furrow
