#include "planner/benchmarks/line_fit.h"
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

constexpr double kAreasHa[] = {0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0};
constexpr int kRuns = 9;
constexpr std::size_t kOneHectare = 2;  // of kAreasHa

struct TimedObjective {
    std::string_view id;
    std::string_view words;
    double paperS;  ///< at 1 ha, on the paper's laptop
    bool linear;    ///< the paper's law: linear in the area, or in its square root
};
constexpr std::array kTimedObjectives = {TimedObjective{"swath-count", "number of swaths", 0.5, false},
                                         TimedObjective{"swath-length", "swath length", 0.5, false},
                                         TimedObjective{"coverage", "coverage", 3.5, true}};

struct AreaTiming {
    double areaHa = 0.0;
    double totalS = 0.0;   ///< the whole plan
    double searchS = 0.0;  ///< for the best heading
};

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

Result<AreaTiming> timeOf(double areaHa, const TimedObjective& objective, const JobContext& job) {
    const auto settings = paperSettings({{"swaths.objective", objective.id}});
    const auto field = fieldOf(scaledTo(paperSlanted(), squareMetres(1e4 * areaHa)), "SAL_B");
    if (!settings || !field) {
        return std::unexpected(settings ? field.error() : settings.error());
    }
    std::vector<double> total;
    std::vector<double> search;
    for (int run = 0; run < kRuns; ++run) {
        const auto plan = makePlan({.field = *field, .machine = paperMachine(), .settings = *settings},
                                   {.stop = job.stop, .progress = {}, .threads = job.threads});
        if (!plan) {
            return std::unexpected(plan.error());
        }
        total.push_back((*plan)->timings.total.si());
        search.push_back((*plan)->timings.swaths.si());
    }
    return AreaTiming{
        .areaHa = areaHa, .totalS = median(std::move(total)), .searchS = median(std::move(search))};
}

struct Fits {
    LineFit root;    ///< T = C_0 sqrt(A) / w + C_1
    LineFit linear;  ///< T = C_0 A + C_1
};

Fits fitsOf(const std::vector<AreaTiming>& timings) {
    const double widthM = paperMachine().operatingWidth().si();
    std::vector<Point> root;
    std::vector<Point> linear;
    for (const AreaTiming& timing : timings) {
        const double areaM2 = 1e4 * timing.areaHa;
        root.push_back({std::sqrt(areaM2) / widthM, timing.searchS});
        linear.push_back({areaM2, timing.searchS});
    }
    return {fitLine(root), fitLine(linear)};
}

std::string chartOf(const std::vector<std::vector<AreaTiming>>& all) {
    Chart chart{
        .title = "Time of the search for the best heading",
        .note =
            "180 headings, a slanted field, swaths of 2.5 m; medians. Dashed: the law of the paper, fitted.",
        .x = {.title = "Area (ha)", .scale = AxisScale::Log},
        .y = {.title = "Time (ms)", .scale = AxisScale::Log}};
    constexpr Marks kMarks[] = {Marks::Dots, Marks::Squares, Marks::Crosses};
    const double widthM = paperMachine().operatingWidth().si();
    for (std::size_t o = 0; o < all.size(); ++o) {
        ChartSeries measured{.name = std::string{kTimedObjectives[o].words},
                             .marks = kMarks[o],
                             .colour = static_cast<int>(o)};
        ChartSeries law{.marks = Marks::None, .line = true, .dashed = true, .colour = static_cast<int>(o)};
        const Fits fits = fitsOf(all[o]);
        for (const AreaTiming& timing : all[o]) {
            const double areaM2 = 1e4 * timing.areaHa;
            const double fitted = kTimedObjectives[o].linear
                                      ? fits.linear.offset + fits.linear.slope * areaM2
                                      : fits.root.offset + fits.root.slope * std::sqrt(areaM2) / widthM;
            measured.points.push_back({timing.areaHa, 1e3 * timing.searchS});
            law.points.push_back({timing.areaHa, 1e3 * fitted});
        }
        chart.series.push_back(std::move(measured));
        chart.series.push_back(std::move(law));
    }
    return svgOf(chart);
}

std::string timingCsv(const std::vector<std::vector<AreaTiming>>& all) {
    std::string text = "objective,area_ha,search_s,total_s\n";
    for (std::size_t o = 0; o < all.size(); ++o) {
        for (const AreaTiming& timing : all[o]) {
            std::format_to(std::back_inserter(text), "{},{},{:.9f},{:.9f}\n", kTimedObjectives[o].id,
                           timing.areaHa, timing.searchS, timing.totalS);
        }
    }
    return text;
}

std::string fitsCsv(const std::vector<std::vector<AreaTiming>>& all) {
    std::string text = "objective,law,c0,c1_s,r2\n";
    for (std::size_t o = 0; o < all.size(); ++o) {
        const Fits fits = fitsOf(all[o]);
        std::format_to(std::back_inserter(text),
                       "{0},c0 * sqrt(area_m2) / width_m + c1,{1:.6g},{2:.6g},{3:.6f}\n",
                       kTimedObjectives[o].id, fits.root.slope, fits.root.offset, fits.root.r2);
        std::format_to(std::back_inserter(text), "{0},c0 * area_m2 + c1,{1:.6g},{2:.6g},{3:.6f}\n",
                       kTimedObjectives[o].id, fits.linear.slope, fits.linear.offset, fits.linear.r2);
    }
    return text;
}

std::vector<PaperStatement> timingStatements(const std::vector<std::vector<AreaTiming>>& all) {
    std::vector<PaperStatement> statements;
    for (std::size_t o = 0; o < all.size(); ++o) {
        const AreaTiming& hectare = all[o][kOneHectare];
        statements.push_back({.paper = std::format("{:.1f} s at 1 ha by {}", kTimedObjectives[o].paperS,
                                                   kTimedObjectives[o].words),
                              .found = std::format("{:.3g} ms", 1e3 * hectare.searchS),
                              .agrees = hectare.searchS <= kTimedObjectives[o].paperS});
    }
    for (std::size_t o = 0; o < all.size(); ++o) {
        const Fits fits = fitsOf(all[o]);
        const bool linear = kTimedObjectives[o].linear;
        statements.push_back(
            {.paper = std::format("Time by {} grows with the {}", kTimedObjectives[o].words,
                                  linear ? "area" : "square root of the area"),
             .found =
                 std::format("R² {:.3f} with the root, {:.3f} with the area", fits.root.r2, fits.linear.r2),
             .agrees = linear ? fits.linear.r2 >= fits.root.r2 : fits.root.r2 >= fits.linear.r2});
    }
    double least = 1.0;
    for (const std::vector<AreaTiming>& timings : all) {
        least = std::min(least, timings[kOneHectare].searchS / timings[kOneHectare].totalS);
    }
    statements.push_back({.paper = "The search takes over 80 % of the time",
                          .found = std::format("{:.0f} % at least, at 1 ha", 100.0 * least),
                          .agrees = least > 0.8});
    return statements;
}

}  // namespace

Result<PaperExperiment> paperTiming(const JobContext& job) {
    std::vector<std::vector<AreaTiming>> all(kTimedObjectives.size());
    const double steps = static_cast<double>(kTimedObjectives.size() * std::size(kAreasHa));
    double done = 0.0;
    for (std::size_t o = 0; o < kTimedObjectives.size(); ++o) {
        for (const double areaHa : kAreasHa) {
            const auto timing = timeOf(areaHa, kTimedObjectives[o], job);
            if (!timing) {
                return std::unexpected(timing.error());
            }
            all[o].push_back(*timing);
            done += 1.0;
            job.report(done / steps);
        }
    }
    return PaperExperiment{.number = 3,
                           .title = "Time against area",
                           .statements = timingStatements(all),
                           .notes = {"Times are of this computer and of what else it does; the paper's are "
                                     "of a laptop of 2017 with four "
                                     "cores."},
                           .files = {{"experiment3_times.csv", timingCsv(all)},
                                     {"experiment3_fits.csv", fitsCsv(all)},
                                     {"experiment3_times.svg", chartOf(all)}}};
}

}  // namespace furrow
