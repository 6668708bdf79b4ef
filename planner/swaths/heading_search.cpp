#include "planner/swaths/heading_search.h"

#include "planner/jobs/parallel.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <format>

namespace furrow {

namespace {

constexpr Choice kObjectives[] = {
    {"swath-count", "Fewest swaths", "As few swaths, and so turns, as possible."},
    {"swath-length", "Shortest swaths", "The least metres driven in swaths."},
    {"coverage", "Most covered", "The largest covered share of the mainland."},
};

constexpr Choice kLastPasses[] = {
    {"overlap", "Overlaps its neighbour", "Full spacing; the last swath is moved back to the edge."},
    {"spread", "Spread over all", "The spacing is reduced evenly so that all fit."},
};

// Differences below these are rounding.
constexpr double kLengthSlackM = 1e-6;
constexpr double kCoverageSlack = 1e-12;

}  // namespace

bool isBetter(SwathObjective objective, const HeadingFigures& a, const HeadingFigures& b) {
    // A heading whose lines miss the mainland altogether is no answer to anything.
    if ((a.count == 0) != (b.count == 0)) {
        return b.count == 0;
    }
    const double shorter = b.length.si() - a.length.si();
    const double more = a.coverage - b.coverage;
    switch (objective) {
        case SwathObjective::Count:
            if (a.count != b.count) {
                return a.count < b.count;
            }
            break;
        case SwathObjective::Length:
            if (std::abs(shorter) > kLengthSlackM) {
                return shorter > 0.0;
            }
            break;
        case SwathObjective::Coverage: break;
    }
    if (std::abs(more) > kCoverageSlack) {
        return more > 0.0;
    }
    return shorter > kLengthSlackM;
}

Result<ScanLine> scanLineFor(const MultiPolygon& mainland, const Machine& machine, const Settings& settings) {
    const SwathSpacing spacing{
        .width = machine.operatingWidth(),
        .overlap = *settings.length(kOverlap),
        .lastPass = settings.choice(kLastPass) == "spread" ? LastPass::Spread : LastPass::Overlap};
    if (spacing.overlap >= spacing.width) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = std::format("an overlap of {} m leaves nothing of {} m",
                                                         spacing.overlap.si(), spacing.width.si()),
                                     .where = std::string{kOverlap.key},
                                     .remedy = "give less than the operating width"});
    }
    ScanLine scanLine{mainland, spacing};
    if (scanLine.tooManyTracks()) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = std::format("{} m for each swath makes over a million swaths",
                                                         (spacing.width - spacing.overlap).si()),
                                     .where = "operating_width_m",
                                     .remedy = "check the operating width and the overlap"});
    }
    return scanLine;
}

SwathObjective objectiveOf(const Settings& settings) {
    const std::string id = settings.choice(kObjective);
    return id == "coverage"       ? SwathObjective::Coverage
           : id == "swath-length" ? SwathObjective::Length
                                  : SwathObjective::Count;
}

Result<Angle> bestHeading(const ScanLine& scanLine, std::span<const Angle> headings, SwathObjective objective,
                          const JobContext& job) {
    const auto figures = parallelMap<HeadingFigures>(
        headings.size(), [&](std::size_t i) { return scanLine.figures(headings[i]); }, job);
    if (!figures) {
        return std::unexpected(figures.error());
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < headings.size(); ++i) {
        if (isBetter(objective, (*figures)[i], (*figures)[best])) {
            best = i;
        }
    }
    return headings[best];
}

Result<SwathSet> swathsAlong(const ScanLine& scanLine, Angle heading) {
    SwathSet set = scanLine.swaths(normalisedSwathHeading(heading));
    if (set.swaths.empty()) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "no swath fits into the mainland",
                                     .where = "swaths",
                                     .remedy = "choose a narrower headland or a narrower machine"});
    }
    return set;
}

const Parameter kObjective{.key = "swaths.objective",
                           .name = "Prefer",
                           .description = "What the search for the best heading looks for.",
                           .kind = ParameterKind::Choice,
                           .standard = 0.0,
                           .choices = kObjectives};

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
