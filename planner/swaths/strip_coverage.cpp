#include "planner/swaths/strip_coverage.h"

#include "planner/jobs/parallel.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace furrow {

namespace {

constexpr std::size_t kLines = 2048;
constexpr std::size_t kLinesAtOnce = 32;

/// An edge turned so that `along` is level: x along, y across.
struct TurnedEdge {
    Point from;
    Point to;
    std::size_t owner = 0;  ///< 0 for the mainland, then the strips
};

struct Crossing {
    std::size_t owner = 0;
    double across = 0.0;
};

struct Lengths {
    double insideM = 0.0;
    double coveredM = 0.0;
    double sumM = 0.0;
};

/// Lengths on one line: inside the mainland, covered there, and covered with multiplicity.
Lengths measured(std::vector<Crossing>& crossings) {
    std::ranges::sort(crossings, [](const Crossing& a, const Crossing& b) {
        return a.owner != b.owner ? a.owner < b.owner : a.across < b.across;
    });
    // Crossings of every owner alternate between beginning and end.
    struct Step {
        double across;
        int inside;
        int depth;
    };
    std::vector<Step> steps;
    bool begins = true;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        begins = i == 0 || crossings[i].owner != crossings[i - 1].owner || !begins;
        const int change = begins ? 1 : -1;
        const bool isMainland = crossings[i].owner == 0;
        steps.push_back({crossings[i].across, isMainland ? change : 0, isMainland ? 0 : change});
    }
    std::ranges::sort(steps, {}, &Step::across);
    Lengths lengths;
    int inside = 0;
    int depth = 0;
    for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
        inside += steps[i].inside;
        depth += steps[i].depth;
        if (inside > 0) {
            const double lengthM = steps[i + 1].across - steps[i].across;
            lengths.insideM += lengthM;
            lengths.coveredM += depth > 0 ? lengthM : 0.0;
            lengths.sumM += depth * lengthM;
        }
    }
    return lengths;
}

}  // namespace

Result<StripCoverage> coverageOf(const MultiPolygon& strips, const MultiPolygon& mainland, Angle along,
                                 const JobContext& job) {
    const Point ahead = direction(along.si());
    std::vector<TurnedEdge> edges;
    const auto add = [&](const MultiPolygon& polygons, std::size_t owner) {
        forEachEdge(polygons, [&](Point from, Point to) {
            edges.push_back(
                {{dot(ahead, from), cross(ahead, from)}, {dot(ahead, to), cross(ahead, to)}, owner});
        });
    };
    add(mainland, 0);
    if (edges.empty()) {
        return StripCoverage{};
    }
    double low = edges.front().from.x;
    double high = low;
    for (const TurnedEdge& edge : edges) {
        low = std::min(low, edge.from.x);
        high = std::max(high, edge.from.x);
    }
    for (std::size_t i = 0; i < strips.size(); ++i) {
        add({strips[i]}, i + 1);
    }
    const double apartM = (high - low) / kLines;
    const auto sums = parallelMap<Lengths>(
        kLines / kLinesAtOnce,
        [&](std::size_t block) {
            std::vector<std::vector<Crossing>> lines(kLinesAtOnce);
            const double first = low + (static_cast<double>(block * kLinesAtOnce) + 0.5) * apartM;
            for (const TurnedEdge& edge : edges) {
                // Lines from the lower end inclusive to the upper end exclusive: every end counts once.
                const double from = (std::min(edge.from.x, edge.to.x) - first) / apartM;
                const double to = (std::max(edge.from.x, edge.to.x) - first) / apartM;
                if (to < 0.0 || from > kLinesAtOnce) {
                    continue;
                }
                for (double k = std::max(0.0, std::ceil(from)); k < std::min<double>(to, kLinesAtOnce);
                     k += 1.0) {
                    const double share = (first + k * apartM - edge.from.x) / (edge.to.x - edge.from.x);
                    lines[static_cast<std::size_t>(k)].push_back(
                        {edge.owner, edge.from.y + share * (edge.to.y - edge.from.y)});
                }
            }
            Lengths sum;
            for (std::vector<Crossing>& line : lines) {
                const Lengths lengths = measured(line);
                sum.insideM += lengths.insideM;
                sum.coveredM += lengths.coveredM;
                sum.sumM += lengths.sumM;
            }
            return sum;
        },
        job);
    if (!sums) {
        return std::unexpected(sums.error());
    }
    Lengths all;
    for (const Lengths& lengths : *sums) {
        all.insideM += lengths.insideM;
        all.coveredM += lengths.coveredM;
        all.sumM += lengths.sumM;
    }
    return StripCoverage{.share = all.insideM > 0.0 ? std::clamp(all.coveredM / all.insideM, 0.0, 1.0) : 0.0,
                         .overlap = squareMetres(std::max(0.0, all.sumM - all.coveredM) * apartM)};
}

}  // namespace furrow
