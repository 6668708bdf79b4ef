#pragma once

#include "planner/swaths/clamped_integral.h"
#include "planner/swaths/scan_line.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace furrow {

// Internal to the scan line: what is known of one heading.

// A width that fits except for rounding does fit.
inline constexpr double kFitSlack = 1e-9;

// Shorter stretches are rounding at a corner, not work.
inline constexpr double kShortestSwathM = 1e-3;

// Edges with a smaller slope, as a share of their height, count as upright.
inline constexpr double kSteep = 1e-3;

/// Rising numbers at nearly even distances. The place of a value is guessed, then corrected by a step or two.
class Ladder {
public:
    explicit Ladder(const std::vector<double>& rungs)
        : rungs_{rungs},
          perMetre_{rungs.size() > 1 ? static_cast<double>(rungs.size() - 1) / (rungs.back() - rungs.front())
                                     : 0.0} {}

    /// The number of rungs below a value.
    std::size_t below(double value) const {
        const std::size_t size = rungs_.size();
        if (size == 0 || value <= rungs_.front()) {
            return 0;
        }
        auto at = std::min(size, static_cast<std::size_t>((value - rungs_.front()) * perMetre_) + 1);
        while (at < size && rungs_[at] < value) {
            ++at;
        }
        while (at > 0 && rungs_[at - 1] >= value) {
            --at;
        }
        return at;
    }

private:
    const std::vector<double>& rungs_;
    double perMetre_;
};

/// All data for one heading. Kept per thread, so that trying a heading allocates nothing.
struct ScanLine::Walk {
    /// An edge, and the tracks from `low` to before `high` that cross it.
    struct Crossed {
        std::uint32_t low = 0;
        std::uint32_t high = 0;
        Point from;
        Point to;
    };

    double cosine = 1.0;
    double sine = 0.0;
    std::vector<Point> rotated;  ///< empty where only lines are asked for and there is a tree of edges
    std::vector<Crossed> crossed;
    double lowY = 0.0;
    double highY = 0.0;
    double anchorY = 0.0;
    std::vector<double> tracks;              // y of each centre line, rising
    std::vector<std::uint32_t> tracksBelow;  // of each vertex
    std::vector<std::int32_t> added;         // crossings that start at each track, less those that end before
                                             // it
    std::vector<std::size_t> firstInterval;  // of track i; one more entry than tracks
    std::vector<double> crossings;           // sorted within a track: pairs are intervals
    // Slabs: stretches of y that are covered by the same tracks.
    std::vector<double> slabEdges;
    std::vector<std::size_t> firstCovered;  // of slab i, into covered; one more entry than slabs
    std::vector<Interval> covered;          // by one swath or more, disjoint
    std::vector<std::size_t> firstDoubled;
    std::vector<Interval> doubled;  // by two or more, disjoint
    std::vector<Interval> scratch;

    Point turned(Point p) const { return {cosine * p.x + sine * p.y, cosine * p.y - sine * p.x}; }

    /// The integrals of clamp(x) dy up an edge, over the area covered once and twice.
    std::pair<double, double> coveredBeside(Point low, Point high, const Ladder& edgeLadder) const {
        const double dx = high.x - low.x;
        const double dy = high.y - low.y;
        // If x hardly changes, differences of areas lose all precision.
        if (std::abs(dx) < kSteep * dy) {
            return integrate(low, high, edgeLadder, clampedIntegral);
        }
        const auto [once, twice] =
            integrate(low, high, edgeLadder, [](Point from, Point to, Interval interval) {
                const double span = interval.to - interval.from;
                return clampedArea(to.x - interval.from, span) - clampedArea(from.x - interval.from, span);
            });
        return {once * (dy / dx), twice * (dy / dx)};
    }

private:
    template <class Integral>
    std::pair<double, double> integrate(Point low, Point high, const Ladder& edgeLadder,
                                        Integral&& integral) const {
        const double slope = (high.x - low.x) / (high.y - low.y);
        const auto at = [&](double y) {
            return y <= low.y ? low : y >= high.y ? high : Point{low.x + slope * (y - low.y), y};
        };
        const std::size_t edgesBelow = edgeLadder.below(low.y);
        std::size_t slab = edgesBelow > 0 ? edgesBelow - 1 : 0;
        double once = 0.0;
        double twice = 0.0;
        Point to = at(slabEdges[slab]);
        for (; slab + 1 < slabEdges.size() && slabEdges[slab] < high.y; ++slab) {
            const Point from = to;
            to = at(slabEdges[slab + 1]);
            for (std::size_t i = firstCovered[slab]; i < firstCovered[slab + 1]; ++i) {
                once += integral(from, to, covered[i]);
            }
            for (std::size_t i = firstDoubled[slab]; i < firstDoubled[slab + 1]; ++i) {
                twice += integral(from, to, doubled[i]);
            }
        }
        return {once, twice};
    }
};

}  // namespace furrow
