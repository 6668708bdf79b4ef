#include "planner/benchmarks/paper.h"
#include "planner/benchmarks/paper_settings.h"
#include "planner/report/chart.h"
#include "planner/report/map_picture.h"
#include "planner/swaths/heading_search.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <format>
#include <iterator>
#include <numbers>

namespace furrow {

namespace {

constexpr Length kWidth = metres(2.5);
constexpr int kHeadings = 180;

struct Shape {
    std::string_view name;
    Polygon outline;
};

struct HeadingObjective {
    SwathObjective objective;
    std::string_view name;
    std::string_view words;
};
constexpr std::array kHeadingObjectives = {
    HeadingObjective{SwathObjective::Count, "swath-count", "fewest swaths"},
    HeadingObjective{SwathObjective::Length, "swath-length", "least swath length"},
    HeadingObjective{SwathObjective::Coverage, "coverage", "most area covered"},
};

struct Best {
    Angle heading;
    HeadingFigures figures;
    SwathSet swaths;
};

struct ShapeResult {
    std::string_view name;
    Polygon outline;
    std::array<Best, kHeadingObjectives.size()> best;
    std::array<std::vector<HeadingFigures>, kHeadingObjectives.size()> byHeading;

    const Best& by(SwathObjective objective) const {
        const auto found = std::ranges::find(kHeadingObjectives, objective, &HeadingObjective::objective);
        return best[static_cast<std::size_t>(found - kHeadingObjectives.begin())];
    }
};

Result<ShapeResult> examine(const Shape& shape, const JobContext& job) {
    const ScanLine scanLine{{shape.outline}, {.width = kWidth, .overlap = {}, .lastPass = LastPass::Gap}};
    std::vector<Angle> headings;
    for (int i = 0; i < kHeadings; ++i) {
        headings.push_back(degrees(i));
    }
    ShapeResult result{.name = shape.name, .outline = shape.outline, .best = {}, .byHeading = {}};
    for (std::size_t i = 0; i < kHeadingObjectives.size(); ++i) {
        const SwathObjective objective = kHeadingObjectives[i].objective;
        const auto best = bestHeading(scanLine, headings, objective, job);
        if (!best) {
            return std::unexpected(best.error());
        }
        result.best[i] = {best->heading, best->figures, scanLine.swaths(best->heading, objective)};
        for (const Angle heading : headings) {
            result.byHeading[i].push_back(scanLine.figures(heading, objective));
        }
    }
    return result;
}

int turns(const Best& best) {
    return best.figures.count - 1;
}

/// The smallest angle between a heading and an edge of a shape or its perpendicular.
Angle fromEdges(Angle heading, const Polygon& outline) {
    double nearest = 1e9;
    forEachEdge({outline}, [&](Point from, Point to) {
        const double edge = std::atan2(to.y - from.y, to.x - from.x);
        nearest = std::min(nearest, std::abs(std::remainder(heading.si() - edge, 0.5 * std::numbers::pi)));
    });
    return radians(nearest);
}

std::vector<PaperStatement> headingStatements(const std::vector<ShapeResult>& results) {
    std::vector<PaperStatement> statements;
    const auto turnStatement = [&](std::size_t shape, SwathObjective objective, int wanted,
                                   std::string paper) {
        const int found = turns(results[shape].by(objective));
        statements.push_back(
            {.paper = std::move(paper), .found = std::to_string(found), .agrees = found == wanted});
    };
    constexpr std::size_t kCircle = 1;
    constexpr std::size_t kSlanted = 2;
    turnStatement(kCircle, SwathObjective::Count, 1, "By number of swaths, CIR_B needs one turn");
    turnStatement(kSlanted, SwathObjective::Count, 1, "By number of swaths, SAL_B needs one turn");
    turnStatement(kCircle, SwathObjective::Coverage, 7, "By coverage, CIR_B needs seven turns");
    turnStatement(kSlanted, SwathObjective::Coverage, 5, "By coverage, SAL_B needs five turns");

    std::string angles;
    bool alongEdges = true;
    for (const ShapeResult& result : results) {
        const double off = inDegrees(fromEdges(result.by(SwathObjective::Coverage).heading, result.outline));
        angles += std::format("{}{} {:.1f}°", angles.empty() ? "" : ", ", result.name, off);
        alongEdges = alongEdges && off <= 1.0;
    }
    statements.push_back({.paper = "The best coverage lies along or across an edge",
                          .found = "away from it: " + angles,
                          .agrees = alongEdges});

    std::string lengths;
    bool manyShort = true;
    for (const ShapeResult& result : results) {
        const HeadingFigures& byLength = result.by(SwathObjective::Length).figures;
        const HeadingFigures& byCount = result.by(SwathObjective::Count).figures;
        lengths += std::format("{}{} {} of {:.1f} m (by number {} of {:.1f} m)", lengths.empty() ? "" : ", ",
                               result.name, byLength.count, byLength.length.si() / byLength.count,
                               byCount.count, byCount.length.si() / byCount.count);
        manyShort = manyShort && byLength.count > byCount.count;
    }
    statements.push_back(
        {.paper = "By swath length there are many short swaths", .found = lengths, .agrees = manyShort});
    return statements;
}

std::string bestCsv(const std::vector<ShapeResult>& results) {
    std::string text = "shape,objective,heading_deg,swaths,turns,swath_length_m,coverage\n";
    for (const ShapeResult& result : results) {
        for (std::size_t i = 0; i < kHeadingObjectives.size(); ++i) {
            const Best& best = result.best[i];
            std::format_to(std::back_inserter(text), "{},{},{:.0f},{},{},{:.3f},{:.6f}\n", result.name,
                           kHeadingObjectives[i].name, inDegrees(best.heading), best.figures.count,
                           turns(best), best.figures.length.si(), best.figures.coverage);
        }
    }
    return text;
}

std::string headingsCsv(const std::vector<ShapeResult>& results) {
    std::string text = "shape,heading_deg,swaths,swath_length_m,coverage\n";
    for (const ShapeResult& result : results) {
        for (std::size_t h = 0; h < static_cast<std::size_t>(kHeadings); ++h) {
            std::format_to(std::back_inserter(text), "{},{},{},{:.3f},{:.6f}\n", result.name, h,
                           result.byHeading[0][h].count, result.byHeading[1][h].length.si(),
                           result.byHeading[2][h].coverage);
        }
    }
    return text;
}

std::string picturesSvg(const std::vector<ShapeResult>& results) {
    std::vector<MapPicture> pictures;
    for (const ShapeResult& result : results) {
        for (std::size_t i = 0; i < kHeadingObjectives.size(); ++i) {
            const Best& best = result.best[i];
            MapLayer swaths{.stroke = "#0072b2", .width = 1.6, .arrows = true};
            MapLayer strips{.fill = "#cfe3f1", .stroke = "#9cc4e0", .width = 0.6};
            for (const Swath& swath : best.swaths.swaths) {
                const Point along = (1.0 / swath.length().si()) * (swath.end - swath.start);
                const Point side = 0.5 * swath.width.si() * Point{-along.y, along.x};
                strips.areas.push_back(
                    {.outer = {swath.start - side, swath.end - side, swath.end + side, swath.start + side},
                     .holes = {}});
                // To and fro.
                swaths.lines.push_back(swath.number % 2 == 1 ? Polyline{swath.start, swath.end}
                                                             : Polyline{swath.end, swath.start});
            }
            pictures.push_back(
                {.title = std::format("{}, {}", result.name, kHeadingObjectives[i].words),
                 .note =
                     std::format("{:.0f}° · {} swaths, {:.1f} m · {:.1f} % covered", inDegrees(best.heading),
                                 best.figures.count, best.figures.length.si(), 100.0 * best.figures.coverage),
                 .layers = {{.areas = {result.outline}, .fill = "#f4f1e8", .stroke = "#8d7b4f"},
                            std::move(strips),
                            std::move(swaths)},
                 .width = 360.0,
                 .largestHeight = 200.0});
        }
    }
    return svgOf(
        pictures, static_cast<int>(kHeadingObjectives.size()), "Best heading by each objective",
        "Fields of 100 m², no headland, swaths of 2.5 m, every whole degree; what does not fit a whole swath "
        "stays uncovered. Headings counter-clockwise from east.");
}

std::string chartsSvg(const std::vector<ShapeResult>& results) {
    std::vector<Chart> charts;
    const auto chart = [&](std::string title, std::string axis, auto value) {
        Chart made{.title = std::move(title),
                   .note = {},
                   .x = {.title = "Heading, degrees counter-clockwise from east",
                         .min = 0.0,
                         .max = 180.0,
                         .step = 30.0},
                   .y = {.title = std::move(axis)},
                   .width = 560.0,
                   .height = 330.0};
        for (std::size_t r = 0; r < results.size(); ++r) {
            ChartSeries series{.name = std::string{results[r].name},
                               .marks = Marks::None,
                               .line = true,
                               .colour = static_cast<int>(r)};
            for (std::size_t h = 0; h < static_cast<std::size_t>(kHeadings); ++h) {
                series.points.push_back({static_cast<double>(h), value(results[r], h)});
            }
            made.series.push_back(std::move(series));
        }
        charts.push_back(std::move(made));
    };
    chart("Number of swaths", "Swaths",
          [](const ShapeResult& r, std::size_t h) { return static_cast<double>(r.byHeading[0][h].count); });
    chart("Length of all swaths", "Length (m)",
          [](const ShapeResult& r, std::size_t h) { return r.byHeading[1][h].length.si(); });
    chart("Area covered", "Share of the field (%)",
          [](const ShapeResult& r, std::size_t h) { return 100.0 * r.byHeading[2][h].coverage; });
    return svgOf(charts, 1, "The objectives over the heading",
                 "The same fields; each heading with its best shift.");
}

}  // namespace

Result<PaperExperiment> paperHeadings(const JobContext& job) {
    const Shape shapes[] = {{"REC_A", paperRectangle()}, {"CIR_B", paperCircle()}, {"SAL_B", paperSlanted()}};
    std::vector<ShapeResult> results;
    for (const Shape& shape : shapes) {
        auto result = examine(shape, job);
        if (!result) {
            return std::unexpected(result.error());
        }
        results.push_back(std::move(*result));
    }
    return PaperExperiment{
        .number = 1,
        .title = "Best heading by each objective",
        .statements = headingStatements(results),
        .notes =
            {"The paper's outlines are not public; these are a rectangle, an ellipse of 20 corners and a "
             "parallelogram of 100 m², as long as its numbers of turns suggest for swaths of 2.5 m.",
             "Here swaths are shifted as the objective likes best: least length then means leaving much "
             "uncovered, not many short swaths."},
        .files = {{"experiment1_best.csv", bestCsv(results)},
                  {"experiment1_headings.csv", headingsCsv(results)},
                  {"experiment1_best.svg", picturesSvg(results)},
                  {"experiment1_headings.svg", chartsSvg(results)}}};
}

}  // namespace furrow
