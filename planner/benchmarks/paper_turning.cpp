#include "planner/benchmarks/paper.h"
#include "planner/benchmarks/paper_settings.h"
#include "planner/plan/plan.h"
#include "planner/report/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <iterator>

namespace furrow {

namespace {

constexpr Area kFieldArea = squareMetres(1e4);

struct Choice {
    std::string_view id;
    std::string_view words;
};
constexpr std::array kTurningObjectives = {Choice{"swath-count", "number of swaths"},
                                           Choice{"swath-length", "swath length"},
                                           Choice{"coverage", "coverage"}};
constexpr std::array kPatterns = {Choice{"boustrophedon", "Boustrophedon"}, Choice{"snake", "Snake"},
                                  Choice{"spiral", "Spiral"}};
constexpr std::array kCurves = {Choice{"dubins", "Dubins"}, Choice{"reeds-shepp", "Reeds-Shepp"}};

struct Combination {
    std::size_t objective = 0;
    std::size_t pattern = 0;
    std::size_t curve = 0;
};

struct Run {
    std::string field;
    Combination combination;
    double inPlaceM = 0.0;  ///< L_0
    double turningM = 0.0;  ///< L_R
    double swathM = 0.0;
    int swaths = 0;

    double turnShare() const { return 1.0 - swathM / turningM; }
};

template <class Visit>
Result<void> forEachCombination(Visit&& visit) {
    for (std::size_t o = 0; o < kTurningObjectives.size(); ++o) {
        for (std::size_t p = 0; p < kPatterns.size(); ++p) {
            for (std::size_t c = 0; c < kCurves.size(); ++c) {
                if (Result<void> visited = visit(Combination{o, p, c}); !visited) {
                    return visited;
                }
            }
        }
    }
    return {};
}

Result<Settings> settingsOf(const Combination& combination) {
    return paperSettings({{"swaths.objective", kTurningObjectives[combination.objective].id},
                          {"route.method", kPatterns[combination.pattern].id},
                          {"path.method", kCurves[combination.curve].id}});
}

/// The field's outline scaled to one hectare, in its own frame.
Result<std::shared_ptr<const Field>> hectareOf(const FieldSource& source) {
    const auto field = Field::create(source);
    if (!field) {
        return std::unexpected(field.error());
    }
    return fieldOf(scaledTo(field->boundary().front(), kFieldArea), source.name);
}

std::string turningCsv(const std::vector<Run>& runs) {
    std::string text =
        "field,objective,pattern,curve,length_in_place_m,length_m,swath_length_m,swaths,turn_share\n";
    for (const Run& run : runs) {
        std::format_to(std::back_inserter(text), "{},{},{},{},{:.3f},{:.3f},{:.3f},{},{:.5f}\n", run.field,
                       kTurningObjectives[run.combination.objective].id,
                       kPatterns[run.combination.pattern].id, kCurves[run.combination.curve].id, run.inPlaceM,
                       run.turningM, run.swathM, run.swaths, run.turnShare());
    }
    return text;
}

std::string plotsOf(const std::vector<Run>& runs) {
    double low = 1e300;
    double high = 0.0;
    for (const Run& run : runs) {
        low = std::min({low, run.inPlaceM, run.turningM});
        high = std::max({high, run.inPlaceM, run.turningM});
    }
    std::vector<Chart> charts;
    for (std::size_t o = 0; o < kTurningObjectives.size(); ++o) {
        for (std::size_t p = 0; p < kPatterns.size(); ++p) {
            // The same range in all nine charts, so that they can be compared at a glance.
            Chart chart{.title = std::format("{}, by {}", kPatterns[p].words, kTurningObjectives[o].words),
                        .note = {},
                        .x = {.title = "L\u2080, turns in place (m)", .min = low, .max = high},
                        .y = {.title = "L with real turns (m)", .min = low, .max = high},
                        .oneToOne = true,
                        .width = 400.0,
                        .height = 360.0};
            for (std::size_t c = 0; c < kCurves.size(); ++c) {
                ChartSeries series{.name = std::string{kCurves[c].words},
                                   .marks = c == 0 ? Marks::Dots : Marks::Crosses,
                                   .colour = static_cast<int>(c)};
                for (const Run& run : runs) {
                    if (run.combination.objective == o && run.combination.pattern == p &&
                        run.combination.curve == c) {
                        series.points.push_back({run.inPlaceM, run.turningM});
                    }
                }
                chart.series.push_back(std::move(series));
            }
            charts.push_back(std::move(chart));
        }
    }
    return svgOf(charts, static_cast<int>(kPatterns.size()),
                 "Length with turns against length with turns in place",
                 "Each mark is a convex field of 1 ha; the dashed line is where turns would add nothing.");
}

/// The mean of a value over the selected runs.
template <class Fits, class Value>
double mean(const std::vector<Run>& runs, Fits fits, Value value) {
    double sum = 0.0;
    int count = 0;
    for (const Run& run : runs) {
        if (fits(run.combination)) {
            sum += value(run);
            ++count;
        }
    }
    return count == 0 ? 0.0 : sum / count;
}

std::vector<PaperStatement> turningStatements(const std::vector<Run>& runs) {
    const auto [least, most] = std::ranges::minmax(runs, {}, &Run::turnShare);
    std::vector<PaperStatement> statements;
    // The paper's range is for its own shapes. Only the order of magnitude can agree.
    statements.push_back(
        {.paper = "Turns take between 0.5 % and 50 % of the path",
         .found = std::format("{:.1f} % to {:.1f} %", 100.0 * least.turnShare(), 100.0 * most.turnShare()),
         .agrees = least.turnShare() >= 0.004 && most.turnShare() <= 0.6});

    std::array<double, kPatterns.size()> inPlace{};
    std::array<double, kPatterns.size()> dubins{};
    for (std::size_t p = 0; p < kPatterns.size(); ++p) {
        inPlace[p] = mean(
            runs, [p](const Combination& c) { return c.pattern == p && c.curve == 0; },
            [](const Run& run) { return run.inPlaceM; });
        dubins[p] = mean(
            runs, [p](const Combination& c) { return c.pattern == p && c.curve == 0; },
            [](const Run& run) { return run.turningM; });
    }
    statements.push_back(
        {.paper = "With turns in place boustrophedon is shortest, then snake, then spiral",
         .found = std::format("on average {:.0f} m, {:.0f} m, {:.0f} m", inPlace[0], inPlace[1], inPlace[2]),
         .agrees = inPlace[0] <= inPlace[1] && inPlace[1] <= inPlace[2]});
    statements.push_back({.paper = "Boustrophedon loses where the radius makes omega turns necessary",
                          .found = std::format("with Dubins curves {:.0f} m, snake {:.0f} m, spiral {:.0f} m",
                                               dubins[0], dubins[1], dubins[2]),
                          .agrees = dubins[0] > dubins[1] || dubins[0] > dubins[2]});

    std::array<double, kTurningObjectives.size()> swathM{};
    for (std::size_t o = 0; o < kTurningObjectives.size(); ++o) {
        swathM[o] = mean(
            runs, [o](const Combination& c) { return c.objective == o && c.pattern == 0; },
            [](const Run& run) { return run.turningM; });
    }
    const double byCoverage = std::abs(swathM[2] - swathM[1]);
    const double byNumber = std::abs(swathM[0] - swathM[1]);
    statements.push_back(
        {.paper = "Coverage and swath length behave alike",
         .found = std::format("boustrophedon: by coverage {:.0f} m, by length {:.0f} m, by number {:.0f} m",
                              swathM[2], swathM[1], swathM[0]),
         .agrees = byCoverage < byNumber});
    return statements;
}

}  // namespace

Result<PaperExperiment> paperTurning(std::span<const FieldSource> fields, const JobContext& job) {
    // Check first, before any computation, whether the planner has all patterns.
    if (auto known = forEachCombination([](const Combination& combination) -> Result<void> {
            const auto settings = settingsOf(combination);
            return settings ? Result<void>{} : std::unexpected(settings.error());
        });
        !known) {
        return std::unexpected(known.error());
    }
    PaperExperiment experiment{.number = 2, .title = "Length of the path by objective, pattern and curve"};
    std::vector<Run> runs;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto field = hectareOf(fields[i]);
        if (!field) {
            experiment.notes.push_back(
                std::format("{} was left out: {}", fields[i].name, field.error().line()));
            continue;
        }
        std::vector<Run> ofField;
        const auto planned = forEachCombination([&](const Combination& combination) -> Result<void> {
            const auto plan = makePlan(
                {.field = *field, .machine = paperMachine(), .settings = settingsOf(combination).value()},
                {.stop = job.stop, .progress = {}, .threads = job.threads});
            if (!plan) {
                return std::unexpected(plan.error());
            }
            ofField.push_back({.field = fields[i].name,
                               .combination = combination,
                               .inPlaceM = (*plan)->route.lengthInPlace.si(),
                               .turningM = (*plan)->path.length().si(),
                               .swathM = (*plan)->swaths.totalLength.si(),
                               .swaths = static_cast<int>((*plan)->swaths.swaths.size())});
            return {};
        });
        if (!planned && planned.error().code == ErrorCode::Cancelled) {
            return std::unexpected(planned.error());
        }
        if (!planned) {
            experiment.notes.push_back(
                std::format("{} was left out: {}", fields[i].name, planned.error().line()));
            continue;
        }
        runs.insert(runs.end(), ofField.begin(), ofField.end());
        job.report(static_cast<double>(i + 1) / static_cast<double>(fields.size()));
    }
    if (runs.empty()) {
        return std::unexpected(
            Error{.code = ErrorCode::InputRefused,
                  .what = "none of the fields could be planned",
                  .where = "--fields",
                  .remedy = "give convex fields that are wider than 20 m when scaled to 1 ha"});
    }
    experiment.statements = turningStatements(runs);
    experiment.notes.push_back(std::format(
        "The paper's 38 outlines are not public; {} fields of ours, scaled to 1 ha.", runs.size() / 18));
    experiment.files = {{"experiment2_lengths.csv", turningCsv(runs)},
                        {"experiment2_lengths.svg", plotsOf(runs)}};
    return experiment;
}

}  // namespace furrow
