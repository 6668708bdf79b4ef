#include "planner/geometry/convex_hull.h"
#include "planner/jobs/parallel.h"
#include "planner/swaths/edge_preference.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

namespace furrow {

namespace {

constexpr double kGridDeg = 0.1;
// Edges with a smaller difference of direction count as one.
constexpr double kSameDirectionDeg = 1e-4;
// If a boundary has more edges, only the hull's and the longest are tried.
constexpr std::size_t kMostSearchedEdges = 2000;
// The refinement stops at a step that moves the end of a kilometre by 2 cm.
constexpr double kFinestDeg = 1e-3;
// Least distance between headings to choose from, and the number measured for that choice.
constexpr double kMeasuredApartDeg = 1.0;
constexpr std::size_t kMostPromising = 6;

Angle headingOf(Point edge) {
    return normalisedSwathHeading(radians(std::atan2(edge.y, edge.x)));
}

void addEdgeHeadings(const Ring& ring, std::vector<Angle>& headings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        headings.push_back(headingOf(ring[(i + 1) % ring.size()] - ring[i]));
    }
}

void sortAndThin(std::vector<Angle>& headings) {
    std::ranges::sort(headings);
    const auto same = [](Angle a, Angle b) { return inDegrees(b - a) < kSameDirectionDeg; };
    headings.erase(std::unique(headings.begin(), headings.end(), same), headings.end());
}

std::vector<Point> outerPoints(const MultiPolygon& mainland) {
    std::vector<Point> points;
    for (const Polygon& polygon : mainland) {
        points.insert(points.end(), polygon.outer.begin(), polygon.outer.end());
    }
    return points;
}

/// The directions of the hull's edges and of all edges at least one width long. Shorter ones are pieces of
/// curves.
std::vector<Angle> edgeHeadings(const MultiPolygon& mainland, const Ring& hull, Length width) {
    std::vector<Angle> headings;
    addEdgeHeadings(hull, headings);
    std::vector<Point> edges;
    forEachEdge(mainland, [&](Point from, Point to) {
        if (distance(from, to) >= width.si()) {
            edges.push_back(to - from);
        }
    });
    if (edges.size() > kMostSearchedEdges) {
        std::ranges::stable_sort(edges, std::ranges::greater{}, norm);
        edges.resize(kMostSearchedEdges);
    }
    std::ranges::transform(edges, std::back_inserter(headings), headingOf);
    sortAndThin(headings);
    return headings;
}

struct Search {
    const ScanLine& scanLine;
    SwathObjective objective;
    int tried = 0;
    std::vector<BestHeading> promising;  // by time: the best by their bounds, apart from each other

    Result<BestHeading> best(const std::vector<Angle>& headings, const JobContext& job) {
        tried += static_cast<int>(headings.size());
        return bestHeading(scanLine, headings, objective, job);
    }

    /// The same by time. Only headings whose bound can still win are driven in full. The time of the most
    /// promising of the first headings makes the bounds of all others cheaper.
    Result<BestHeading> quickest(const std::vector<Angle>& headings, std::size_t first,
                                 const JobContext& job) {
        tried += static_cast<int>(headings.size());
        const auto boundsOf = [&](std::size_t count, Duration enough, const JobContext& part) {
            return parallelMap<Duration>(
                count, [&](std::size_t i) { return scanLine.timeBound(headings[i], enough); }, part);
        };
        const auto quickestOf = [&](const std::vector<Duration>& bounds) {
            return headings[static_cast<std::size_t>(std::ranges::min_element(bounds) - bounds.begin())];
        };
        const auto timeOf = [&](Angle heading) {
            return scanLine.figures(heading, SwathObjective::Time).time;
        };
        const auto few =
            boundsOf(first, seconds(std::numeric_limits<double>::infinity()), job.part(0.0, 0.1));
        if (!few) {
            return std::unexpected(few.error());
        }
        const Duration reached = timeOf(quickestOf(*few));
        const auto bounds = boundsOf(headings.size(), reached, job.part(0.1, 0.7));
        if (!bounds) {
            return std::unexpected(bounds.error());
        }
        std::vector<Angle> left{quickestOf(*bounds)};
        const Duration known = std::min(reached, timeOf(left.front()));
        for (std::size_t i = 0; i < headings.size(); ++i) {
            if ((*bounds)[i] <= known) {
                left.push_back(headings[i]);
            }
        }
        findPromising(headings, *bounds);
        return bestHeading(scanLine, left, objective, job.part(0.7, 1.0));
    }

    void findPromising(const std::vector<Angle>& headings, const std::vector<Duration>& bounds) {
        std::vector<std::size_t> order(headings.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return bounds[i]; });
        for (const std::size_t i : order) {
            const auto isNear = [&](const BestHeading& other) {
                return inDegrees(angleBetweenLines(other.heading, headings[i])) < kMeasuredApartDeg;
            };
            if (std::ranges::none_of(promising, isNear)) {
                promising.push_back({headings[i], scanLine.figures(headings[i], SwathObjective::Time)});
            }
            if (promising.size() == kMostPromising) {
                break;
            }
        }
    }

    /// Halves the step around the best heading down to the finest useful step.
    Result<BestHeading> refined(BestHeading from, const JobContext& caller) {
        const BestHeading first = from;
        // A few dozen headings finish before a progress bar could move.
        const JobContext job{.stop = caller.stop, .progress = {}, .threads = caller.threads};
        for (double stepDeg = 0.5 * kGridDeg; stepDeg > kFinestDeg; stepDeg *= 0.5) {
            const auto next = best({from.heading, normalisedSwathHeading(from.heading - degrees(stepDeg)),
                                    normalisedSwathHeading(from.heading + degrees(stepDeg))},
                                   job);
            if (!next) {
                return next;
            }
            from = *next;
        }
        // Differences of rounding count as equal, so many such steps may lead back.
        return isBetter(objective, first.figures, from.figures) ? first : from;
    }
};

Result<SwathSet> exactSearch(const SwathTask& task, const JobContext& job) {
    const MultiPolygon& mainland = task.mainland;
    const auto scanLine = scanLineFor(task);
    if (!scanLine) {
        return std::unexpected(scanLine.error());
    }
    Search search{.scanLine = *scanLine, .objective = objectiveOf(task.settings)};
    const bool byCount = search.objective == SwathObjective::Count;
    const bool onePiece = mainland.size() == 1;
    const Ring hull = convexHull(outerPoints(mainland));
    // Every track crosses a mainland in one piece, and its height in any heading is at least the hull's
    // width.
    const int fewestTracks = scanLine->trackCount(minimumWidth(hull));
    const bool gap = task.settings.choice(kLastPass) == "gap";

    Result<BestHeading> best;
    if (search.objective == SwathObjective::Time) {
        std::vector<Angle> headings = edgeHeadings(mainland, hull, task.machine.operatingWidth());
        const std::size_t edges = headings.size();
        for (int i = 0; i * kGridDeg < 180.0 - 1e-9; ++i) {
            headings.push_back(degrees(i * kGridDeg));
        }
        best = search.quickest(headings, std::max<std::size_t>(1, edges), job.part(0.0, 0.95));
        if (best) {
            best = search.refined(*best, job);
        }
    } else if (byCount && onePiece && !gap && mainland[0].holes.empty() && isConvex(mainland[0].outer)) {
        std::vector<Angle> headings;
        addEdgeHeadings(hull, headings);
        sortAndThin(headings);
        best = search.best(headings, job);
    } else {
        // The directions of edges come first. Their result makes the grid cheaper.
        best = search.best(edgeHeadings(mainland, hull, task.machine.operatingWidth()), job.part(0.0, 0.3));
        if (!best) {
            return std::unexpected(best.error());
        }
        std::vector<Angle> headings{best->heading};
        for (int i = 0; i * kGridDeg < 180.0 - 1e-9; ++i) {
            const Angle heading = degrees(i * kGridDeg);
            const bool hopeless = byCount && onePiece && !gap &&
                                  scanLine->trackCount(scanLine->heightAcross(heading)) > best->figures.count;
            if (!hopeless) {
                headings.push_back(heading);
            }
        }
        best = search.best(headings, job.part(0.3, 0.95));
        if (best && !byCount) {
            best = search.refined(*best, job);
        }
    }
    if (!best) {
        return std::unexpected(best.error());
    }
    auto set = swathsOfBest(*scanLine, task, search.objective, *best, std::move(search.promising), job);
    if (set) {
        set->headingsTried = search.tried;
        set->proved = byCount && onePiece && !gap && best->figures.count == fewestTracks;
    }
    return set;
}

constexpr const Parameter* kExactSearchParameters[] = {&kObjective, &kPreferEdge};

}  // namespace

const Method<SwathGenerator> kExactMethod{
    .info = {.id = "exact",
             .name = "Best heading",
             .description =
                 "Edge directions and every tenth of a degree, refined; says when nothing better exists.",
             .parameters = kExactSearchParameters},
    .run = exactSearch,
    .traits = {.searchesHeadings = true}};

}  // namespace furrow
