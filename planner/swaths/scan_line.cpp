#include "planner/swaths/scan_line.h"

#include "planner/swaths/clamped_integral.h"
#include "planner/turns/dubins.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace furrow {

namespace {

// Shorter stretches are rounding at a corner, not work.
constexpr double kShortestSwathM = 1e-3;
constexpr double kMostTracks = 1e6;
// A width that fits except for rounding does fit.
constexpr double kFitSlack = 1e-9;
// A guidance line comes from degrees. Within this distance it is flush with the edge, and no swath fits in
// between.
constexpr double kFlushM = 1e-3;
// Land that no swath covers costs its own time. Worked in small pieces, it costs 5 times as much.
constexpr double kPiecemealFactor = 5.0;
// Edges with a smaller slope, as a share of their height, count as upright.
constexpr double kSteep = 1e-3;
// Number of shifts tried if the shift is free.
constexpr int kShifts = 9;

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

}  // namespace

/// All data for one heading. Kept per thread, so that trying a heading allocates nothing.
struct ScanLine::Walk {
    std::vector<Point> rotated;
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

namespace {

/// Splits overlapping intervals into those covered at least once and those covered at least twice.
void countOverlaps(std::vector<Interval>& intervals, std::vector<Interval>& once,
                   std::vector<Interval>& twice) {
    if (intervals.size() == 1) {
        once.push_back(intervals.front());
        return;
    }
    std::ranges::sort(intervals, {}, &Interval::from);
    double end = -std::numeric_limits<double>::infinity();       // of the current stretch covered once
    double twiceEnd = -std::numeric_limits<double>::infinity();  // of the current stretch covered twice
    for (const Interval& interval : intervals) {
        if (interval.from < end) {
            const Interval both{std::max(interval.from, twiceEnd), std::min(interval.to, end)};
            if (both.to > both.from) {
                if (both.from == twiceEnd) {
                    twice.back().to = both.to;
                } else {
                    twice.push_back(both);
                }
                twiceEnd = both.to;
            }
            if (interval.to > end) {
                once.back().to = interval.to;
                end = interval.to;
            }
        } else {
            once.push_back(interval);
            end = interval.to;
        }
    }
}

/// A lower bound of the turn between opposite tracks, over all shifts of their ends along the track. A shift
/// can be driven straight, so the length of the curve changes by no more than the shift. The minimum over a
/// grid therefore gives a bound.
Length shortestTurnBetween(Length spacing, Length radius) {
    const Pose from{.position = {}, .heading = degrees(0.0)};
    const auto lengthAt = [&](double shiftM) {
        return dubinsLength(from, {.position = {shiftM, spacing.si()}, .heading = degrees(180.0)}, radius)
            .si();
    };
    double shortest = lengthAt(0.0);
    // A turn is longer than the shift it corrects.
    const double farthest = shortest;
    constexpr int kSteps = 100;
    const double step = farthest / kSteps;
    for (int i = -kSteps; i <= kSteps; ++i) {
        shortest = std::min(shortest, lengthAt(i * step));
    }
    return metres(shortest - 0.5 * step);
}

}  // namespace

bool SwathSpacing::isWorthASwath(Length rest) const {
    return rest.si() >= 0.5 * width.si() - kFitSlack;
}

ScanLine::ScanLine(const MultiPolygon& mainland, const SwathSpacing& spacing,
                   const std::optional<DrivingModel>& driving)
    : spacing_{spacing}, driving_{driving} {
    if (driving) {
        shortestTurn_ = shortestTurnBetween(spacing.width - spacing.overlap, driving->radius);
    }
    const Bounds box = bounds(mainland);
    origin_ = 0.5 * (box.min + box.max);
    diameterM_ = std::hypot(box.width(), box.height());
    areaM2_ = area(mainland).si();
    const auto add = [this](const Ring& ring) {
        for (const Point& point : ring) {
            vertices_.push_back(point - origin_);
        }
        ringEnds_.push_back(vertices_.size());
    };
    for (const Polygon& polygon : mainland) {
        add(polygon.outer);
        std::ranges::for_each(polygon.holes, add);
    }
}

bool ScanLine::tooManyTracks() const {
    return diameterM_ / (spacing_.width - spacing_.overlap).si() > kMostTracks;
}

void ScanLine::rotate(Angle heading, Walk& walk) const {
    const double c = std::cos(heading.si());
    const double s = std::sin(heading.si());
    walk.rotated.resize(vertices_.size());
    if (spacing_.anchor) {
        const Point anchor = *spacing_.anchor - origin_;
        walk.anchorY = c * anchor.y - s * anchor.x;
    }
    walk.lowY = std::numeric_limits<double>::infinity();
    walk.highY = -walk.lowY;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const Point p = vertices_[i];
        const Point turned{c * p.x + s * p.y, c * p.y - s * p.x};
        walk.rotated[i] = turned;
        walk.lowY = std::min(walk.lowY, turned.y);
        walk.highY = std::max(walk.highY, turned.y);
    }
}

int ScanLine::trackCount(Length height) const {
    const Length rest = height - spacing_.width;
    if (rest <= metres(0.0)) {
        return 1;
    }
    const Length step = spacing_.width - spacing_.overlap;
    const double steps = rest / step;
    if (spacing_.lastPass != LastPass::Gap) {
        return 1 + static_cast<int>(std::ceil(steps - kFitSlack));
    }
    const double whole = std::floor(steps + kFitSlack);
    return 1 + static_cast<int>(whole) + (spacing_.isWorthASwath(rest - whole * step) ? 1 : 0);
}

Length ScanLine::heightAcross(Angle heading) const {
    const Point across{-std::sin(heading.si()), std::cos(heading.si())};
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Point& vertex : vertices_) {
        low = std::min(low, dot(across, vertex));
        high = std::max(high, dot(across, vertex));
    }
    return metres(high - low);
}

int ScanLine::layoutCount(const Walk& walk) const {
    if (walk.highY - walk.lowY <= spacing_.width.si() || spacing_.anchor) {
        return 1;
    }
    switch (spacing_.lastPass) {
        case LastPass::Overlap: return 2;
        case LastPass::Spread: return 1;
        case LastPass::Gap: return movesBack(walk) ? 2 : kShifts;
    }
    return 1;
}

/// Whether an extra swath is laid that may not reach beyond the edge.
bool ScanLine::movesBack(const Walk& walk) const {
    const Length height = metres(walk.highY - walk.lowY);
    const Length needed = (trackCount(height) - 1) * (spacing_.width - spacing_.overlap) + spacing_.width;
    return spacing_.lastPass == LastPass::Gap && !spacing_.overEdge && (needed - height).si() > kFitSlack;
}

void ScanLine::lay(int layout, Walk& walk) const {
    const double width = spacing_.width.si();
    const double height = walk.highY - walk.lowY;
    const double lowest = walk.lowY + 0.5 * width;
    const double highest = walk.highY - 0.5 * width;
    const auto count = static_cast<std::size_t>(trackCount(metres(height)));
    const auto last = static_cast<double>(count - 1);
    const double step = spacing_.lastPass == LastPass::Spread && count > 1
                            ? (highest - lowest) / last
                            : (spacing_.width - spacing_.overlap).si();
    walk.tracks.clear();
    if (spacing_.anchor) {
        layThroughAnchor(walk);
    } else if (height <= width) {
        walk.tracks.push_back(0.5 * (walk.lowY + walk.highY));
    } else if (spacing_.lastPass == LastPass::Gap && !movesBack(walk)) {
        // From flush with one edge to flush with the other, within them or beyond.
        const double free = highest - lowest - last * step;
        const double first = lowest + free * layout / (kShifts - 1);
        for (std::size_t i = 0; i < count; ++i) {
            walk.tracks.push_back(first + static_cast<double>(i) * step);
        }
    } else {
        // Layout 0 moves the last swath back, layout 1 the first.
        for (std::size_t i = 0; i < count; ++i) {
            walk.tracks.push_back(layout == 0 ? lowest + static_cast<double>(i) * step
                                              : highest - (last - static_cast<double>(i)) * step);
        }
        // The outermost swaths are exactly flush with the mainland's edges.
        walk.tracks.front() = lowest;
        walk.tracks.back() = highest;
    }
    findCrossings(walk);
}

/// Lays tracks at the full spacing from the anchor. The last pass decides about the rest at each edge.
void ScanLine::layThroughAnchor(Walk& walk) const {
    const double width = spacing_.width.si();
    const double step = (spacing_.width - spacing_.overlap).si();
    const double lowest = walk.lowY + 0.5 * width;
    const double highest = walk.highY - 0.5 * width;
    const double slack = std::min(kFlushM, 0.01 * step);
    // The whole number of steps that brings the anchor's line to its lowest place inside the mainland.
    const double first = walk.anchorY - step * std::floor((walk.anchorY - lowest + slack) / step);
    if (walk.highY - walk.lowY <= width) {
        const double nearest =
            walk.anchorY + step * std::round((0.5 * (lowest + highest) - walk.anchorY) / step);
        const bool crosses = nearest > walk.lowY && nearest < walk.highY;
        walk.tracks.push_back(crosses ? nearest : 0.5 * (lowest + highest));
        return;
    }
    if (spacing_.lastPass == LastPass::Spread && walk.anchorY > lowest - slack &&
        walk.anchorY < highest + slack) {
        // As many as needed on each side of the anchor, evenly.
        const auto spread = [&](double from, double to) {
            if (to - from <= slack) {
                return;
            }
            const auto steps = static_cast<int>(std::max(1.0, std::ceil((to - from - slack) / step)));
            for (int i = 0; i < steps; ++i) {
                walk.tracks.push_back(from + (to - from) * i / steps);
            }
        };
        spread(lowest, walk.anchorY);
        spread(walk.anchorY, highest);
        walk.tracks.push_back(highest - walk.anchorY <= slack ? walk.anchorY : highest);
        return;
    }
    const bool isGap = spacing_.lastPass == LastPass::Gap;
    if (!isGap && first > lowest + slack) {
        walk.tracks.push_back(lowest);
    } else if (isGap && first <= highest + slack && spacing_.isWorthASwath(metres(first - lowest))) {
        walk.tracks.push_back(spacing_.overEdge ? first - step : lowest);
    }
    for (int i = 0; first + i * step <= highest + slack; ++i) {
        walk.tracks.push_back(first + i * step);
    }
    if (!isGap && (walk.tracks.empty() || walk.tracks.back() < highest - slack)) {
        walk.tracks.push_back(highest);
    } else if (isGap && !walk.tracks.empty() &&
               spacing_.isWorthASwath(metres(highest - walk.tracks.back()))) {
        walk.tracks.push_back(spacing_.overEdge ? walk.tracks.back() + step : highest);
    }
    if (walk.tracks.empty()) {
        walk.tracks.push_back(0.5 * (lowest + highest));
    }
}

/// Finds the crossings of every edge with every centre line, sorted into tracks by counting.
void ScanLine::findCrossings(Walk& walk) const {
    const std::size_t trackCount = walk.tracks.size();
    const Ladder ladder{walk.tracks};
    walk.tracksBelow.resize(walk.rotated.size());
    for (std::size_t i = 0; i < walk.rotated.size(); ++i) {
        walk.tracksBelow[i] = static_cast<std::uint32_t>(ladder.below(walk.rotated[i].y));
    }
    // Half-open: a vertex on a centre line counts for one of its two edges.
    const auto forEachEdge = [&](auto&& visit) {
        std::size_t begin = 0;
        for (const std::size_t end : ringEnds_) {
            std::size_t a = end - 1;
            for (std::size_t b = begin; b < end; a = b++) {
                const auto [low, high] = std::minmax(walk.tracksBelow[a], walk.tracksBelow[b]);
                if (low < high) {
                    visit(low, high, walk.rotated[a], walk.rotated[b]);
                }
            }
            begin = end;
        }
    };
    // An edge adds one crossing at its lowest track and removes it after its highest.
    walk.added.assign(trackCount + 1, 0);
    forEachEdge([&](std::size_t low, std::size_t high, Point, Point) {
        ++walk.added[low];
        --walk.added[high];
    });
    walk.firstInterval.resize(trackCount + 1);
    std::size_t sum = 0;
    std::ptrdiff_t onTrack = 0;
    for (std::size_t k = 0; k < trackCount; ++k) {
        walk.firstInterval[k] = sum;
        onTrack += walk.added[k];
        sum += static_cast<std::size_t>(onTrack);
    }
    walk.firstInterval.back() = sum;
    walk.crossings.resize(sum);
    forEachEdge([&](std::size_t low, std::size_t high, Point a, Point b) {
        const double slope = (b.x - a.x) / (b.y - a.y);
        for (std::size_t k = low; k < high; ++k) {
            walk.crossings[walk.firstInterval[k]++] = a.x + (walk.tracks[k] - a.y) * slope;
        }
    });
    // Filling moved every entry to the beginning of the next track.
    std::ranges::move_backward(walk.firstInterval.begin(), walk.firstInterval.end() - 1,
                               walk.firstInterval.end());
    walk.firstInterval.front() = 0;
    for (std::size_t k = 0; k < trackCount; ++k) {
        double* const first = walk.crossings.data() + walk.firstInterval[k];
        double* const last = walk.crossings.data() + walk.firstInterval[k + 1];
        if (last - first == 2) {
            if (first[1] < first[0]) {
                std::swap(first[0], first[1]);
            }
        } else {
            std::sort(first, last);
        }
    }
}

/// Finds the slabs between the edges of all strips, and the area that the active strips cover in each.
void ScanLine::findSlabs(Walk& walk) const {
    const std::size_t trackCount = walk.tracks.size();
    const double half = 0.5 * spacing_.width.si();
    walk.slabEdges.clear();
    std::size_t starts = 0;
    for (std::size_t ends = 0; ends < trackCount;) {
        const double start =
            starts < trackCount ? walk.tracks[starts] - half : std::numeric_limits<double>::infinity();
        const double end = walk.tracks[ends] + half;
        const double next = std::min(start, end);
        starts += start <= end ? 1 : 0;
        ends += end <= start ? 1 : 0;
        // The end of one strip and the start of the next are one edge, in spite of rounding.
        if (walk.slabEdges.empty() || next > walk.slabEdges.back() + kFitSlack) {
            walk.slabEdges.push_back(next);
        }
    }
    walk.covered.clear();
    walk.doubled.clear();
    walk.firstCovered.assign(1, 0);
    walk.firstDoubled.assign(1, 0);
    std::size_t firstActive = 0;
    for (std::size_t slab = 0; slab + 1 < walk.slabEdges.size(); ++slab) {
        const double middle = 0.5 * (walk.slabEdges[slab] + walk.slabEdges[slab + 1]);
        while (firstActive < trackCount && walk.tracks[firstActive] + half < middle) {
            ++firstActive;
        }
        std::size_t beyondActive = firstActive;
        while (beyondActive < trackCount && walk.tracks[beyondActive] - half < middle) {
            ++beyondActive;
        }
        // The swaths of one track do not overlap each other.
        const bool isOne = beyondActive - firstActive == 1;
        std::vector<Interval>& into = isOne ? walk.covered : walk.scratch;
        walk.scratch.clear();
        for (std::size_t i = walk.firstInterval[firstActive]; i + 1 < walk.firstInterval[beyondActive];
             i += 2) {
            if (walk.crossings[i + 1] - walk.crossings[i] >= kShortestSwathM) {
                into.push_back({walk.crossings[i], walk.crossings[i + 1]});
            }
        }
        if (!isOne) {
            countOverlaps(walk.scratch, walk.covered, walk.doubled);
        }
        walk.firstCovered.push_back(walk.covered.size());
        walk.firstDoubled.push_back(walk.doubled.size());
    }
}

template <class TurnLength>
Duration ScanLine::drivingTime(const Walk& walk, const TurnLength& turnLength) const {
    double swathsM = 0.0;
    double turnsM = 0.0;
    std::optional<Pose> from;
    const auto drive = [&](double startX, double endX, double y, bool back) {
        const double lead = back ? -driving_->lead.si() : driving_->lead.si();
        const Pose to{.position = {(back ? endX : startX) + lead, y}, .heading = degrees(back ? 180.0 : 0.0)};
        if (from) {
            // Pieces of one track lie straight ahead of each other.
            turnsM +=
                from->position.y == y ? std::abs(to.position.x - from->position.x) : turnLength(*from, to);
        }
        swathsM += endX - startX;
        from = Pose{.position = {(back ? startX : endX) + lead, y}, .heading = to.heading};
    };
    for (std::size_t k = 0; k < walk.tracks.size(); ++k) {
        const bool back = k % 2 == 1;
        const std::size_t begin = walk.firstInterval[k];
        const std::size_t pairs = (walk.firstInterval[k + 1] - begin) / 2;
        for (std::size_t i = 0; i < pairs; ++i) {
            const std::size_t at = begin + 2 * (back ? pairs - 1 - i : i);
            if (walk.crossings[at + 1] - walk.crossings[at] >= kShortestSwathM) {
                drive(walk.crossings[at], walk.crossings[at + 1], walk.tracks[k], back);
            }
        }
    }
    return seconds(swathsM / driving_->working.si() + turnsM / driving_->turning.si());
}

HeadingFigures ScanLine::measureLines(const Walk& walk) const {
    HeadingFigures figures;
    for (std::size_t k = 0; k < walk.tracks.size(); ++k) {
        for (std::size_t i = walk.firstInterval[k]; i + 1 < walk.firstInterval[k + 1]; i += 2) {
            const double length = walk.crossings[i + 1] - walk.crossings[i];
            if (length >= kShortestSwathM) {
                ++figures.count;
                figures.length += metres(length);
            }
        }
    }
    return figures;
}

// Green's theorem on the part of the mainland inside each rectangle: the integral of clamp(x) dy around every
// ring, edge by edge, slab by slab.
std::pair<double, double> ScanLine::coveredAreas(const Walk& walk) const {
    double coveredM2 = 0.0;
    double doubledM2 = 0.0;
    const Ladder ladder{walk.slabEdges};
    std::size_t begin = 0;
    for (const std::size_t end : ringEnds_) {
        Point a = walk.rotated[end - 1];
        for (std::size_t i = begin; i < end; ++i) {
            const Point b = walk.rotated[i];
            if (a.y != b.y) {
                const auto [covered, doubled] =
                    a.y < b.y ? walk.coveredBeside(a, b, ladder) : walk.coveredBeside(b, a, ladder);
                const double sign = a.y < b.y ? 1.0 : -1.0;
                coveredM2 += sign * covered;
                doubledM2 += sign * doubled;
            }
            a = b;
        }
        begin = end;
    }
    return {coveredM2, doubledM2};
}

HeadingFigures ScanLine::measure(SwathObjective objective, Walk& walk) const {
    findSlabs(walk);
    HeadingFigures figures = measureLines(walk);
    const auto [coveredM2, doubledM2] = coveredAreas(walk);
    figures.coverage = areaM2_ > 0.0 ? std::clamp(coveredM2 / areaM2_, 0.0, 1.0) : 0.0;
    figures.overlap = squareMetres(std::max(0.0, doubledM2));
    figures.missed = metres((1.0 - figures.coverage) * areaM2_ / spacing_.width.si());
    if (objective == SwathObjective::Time && driving_) {
        const auto curve = [this](const Pose& from, const Pose& to) {
            return dubinsLength(from, to, driving_->radius).si();
        };
        figures.time = drivingTime(walk, curve) + missedTime(figures);
    }
    return figures;
}

Duration ScanLine::missedTime(const HeadingFigures& figures) const {
    return seconds(kPiecemealFactor * figures.missed.si() / driving_->working.si());
}

Duration ScanLine::timeBound(Angle heading, Duration enough) const {
    if (vertices_.empty() || !driving_) {
        return {};
    }
    thread_local Walk walk;
    rotate(heading, walk);
    Duration least = seconds(std::numeric_limits<double>::infinity());
    const int layouts = layoutCount(walk);
    for (int layout = 0; layout < layouts; ++layout) {
        lay(layout, walk);
        // Neighbours at the full spacing have a known least turn. No turn is shorter than the straight line.
        const auto atLeast = [this](const Pose& from, const Pose& to) {
            const Point way = to.position - from.position;
            const bool spaced = std::abs(way.y) >= (spacing_.width - spacing_.overlap).si() - kFitSlack;
            const double turning = spaced ? shortestTurn_.si() : std::numbers::pi * driving_->radius.si();
            const double square = dot(way, way);
            return square > turning * turning ? std::sqrt(square) : turning;
        };
        const Duration driven = drivingTime(walk, atLeast);
        // Swaths cover at most their length times width. This needs no areas.
        HeadingFigures figures = measureLines(walk);
        const double mostM2 = figures.length.si() * spacing_.width.si();
        figures.missed = metres(std::max(0.0, areaM2_ - mostM2) / spacing_.width.si());
        Duration bound = driven + missedTime(figures);
        if (bound <= enough) {
            bound = driven + missedTime(measure(SwathObjective::Length, walk));
        }
        least = std::min(least, bound);
    }
    return least;
}

std::pair<int, HeadingFigures> ScanLine::best(Angle heading, SwathObjective objective, Walk& walk) const {
    rotate(heading, walk);
    std::pair<int, HeadingFigures> chosen;
    const int layouts = layoutCount(walk);
    // Areas take most of the time. If lines decide, only layouts with the best lines are measured.
    const bool linesDecide = layouts > 1 && isOfLines(objective);
    const HeadingFigures bestLines = linesDecide ? linesOf(objective, walk) : HeadingFigures{};
    bool first = true;
    for (int layout = 0; layout < layouts; ++layout) {
        lay(layout, walk);
        if (linesDecide && !isAsGood(objective, measureLines(walk), bestLines)) {
            continue;
        }
        const HeadingFigures figures = measure(objective, walk);
        // Of equal layouts the one with less overlap is taken, then the first.
        const bool better = isBetter(objective, figures, chosen.second) ||
                            (!isBetter(objective, chosen.second, figures) &&
                             isBetter(SwathObjective::Overlap, figures, chosen.second));
        if (first || better) {
            chosen = {layout, figures};
        }
        first = false;
    }
    return chosen;
}

HeadingFigures ScanLine::linesOf(SwathObjective objective, Walk& walk) const {
    HeadingFigures best;
    const int layouts = layoutCount(walk);
    for (int layout = 0; layout < layouts; ++layout) {
        lay(layout, walk);
        const HeadingFigures figures = measureLines(walk);
        if (layout == 0 || isBetter(objective, figures, best)) {
            best = figures;
        }
    }
    return best;
}

HeadingFigures ScanLine::lineFigures(Angle heading, SwathObjective objective) const {
    if (vertices_.empty()) {
        return {};
    }
    thread_local Walk walk;
    rotate(heading, walk);
    return linesOf(objective, walk);
}

HeadingFigures ScanLine::figures(Angle heading, SwathObjective objective) const {
    if (vertices_.empty()) {
        return {};
    }
    thread_local Walk walk;
    return best(heading, objective, walk).second;
}

SwathSet ScanLine::swaths(Angle heading, SwathObjective objective) const {
    SwathSet set;
    set.heading = heading;
    if (vertices_.empty()) {
        return set;
    }
    thread_local Walk walk;
    const auto [layout, figures] = best(heading, objective, walk);
    lay(layout, walk);
    set.totalLength = figures.length;
    set.coverage = figures.coverage;
    set.overlap = figures.overlap;
    set.shift = metres(walk.tracks.front() - walk.lowY) - 0.5 * spacing_.width;
    if (spacing_.lastPass == LastPass::Gap) {
        set.restRight = std::max(Length{}, set.shift);
        set.restLeft = std::max(Length{}, metres(walk.highY - walk.tracks.back()) - 0.5 * spacing_.width);
    }
    const Point along = direction(heading.si());
    const Point left{-along.y, along.x};
    for (std::size_t k = 0; k < walk.tracks.size(); ++k) {
        for (std::size_t i = walk.firstInterval[k]; i + 1 < walk.firstInterval[k + 1]; i += 2) {
            if (walk.crossings[i + 1] - walk.crossings[i] < kShortestSwathM) {
                continue;
            }
            const Point track = origin_ + walk.tracks[k] * left;
            set.swaths.push_back({.start = track + walk.crossings[i] * along,
                                  .end = track + walk.crossings[i + 1] * along,
                                  .number = static_cast<int>(set.swaths.size()) + 1,
                                  .track = static_cast<int>(k),
                                  .width = spacing_.width});
        }
    }
    return set;
}

}  // namespace furrow
