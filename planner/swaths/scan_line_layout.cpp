// Where the tracks of a heading lie, and what they cross.

#include "planner/swaths/scan_line_walk.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow {

namespace {

// A guidance line comes from degrees. Within this distance it is flush with the edge, and no swath fits in
// between.
constexpr double kFlushLaneM = 1e-3;
// Number of shifts tried if the shift is free.
constexpr int kShifts = 9;
// A place is guessed so often before what is left is halved.
constexpr int kGuesses = 8;

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

}  // namespace

bool SwathSpacing::isWorthASwath(Length rest) const {
    return rest.si() >= 0.5 * width.si() - kFitSlack;
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
    const double slack = std::min(kFlushLaneM, 0.01 * step);
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

/// The same for a run that rises or falls all along: each track crosses one edge, which is searched from the
/// one before.
template <class Visit>
void ScanLine::forEachCrossedEdgeOf(const EdgeTree::Run& run, EdgeTree::Trend trend, const Walk& walk,
                                    const Ladder& ladder, const Visit& visit) const {
    const auto pointAt = [&](std::uint32_t i) { return walk.turned(vertices_[run.vertex(i)]); };
    const bool rises = trend == EdgeTree::Trend::Rises;
    // Counted from the lower end.
    const auto fromBelow = [&](std::uint32_t i) { return pointAt(rises ? i : run.size() - i); };
    const double topY = fromBelow(run.size()).y;
    std::uint32_t at = 0;
    double atY = fromBelow(at).y;
    double perMetre = run.size() / (topY - atY);
    const std::size_t last = ladder.below(topY);
    for (std::size_t track = ladder.below(atY); track < last;) {
        const double trackY = walk.tracks[track];
        const std::uint32_t begin = at;
        const double beginY = atY;
        // `at` lies at or below the track, `above` above it. Edges are about as long as the last ones.
        std::uint32_t above = run.size();
        double aboveY = topY;
        double place = at + (trackY - atY) * perMetre;
        for (int tried = 0; above - at > 1; ++tried) {
            const auto probe = tried < kGuesses
                                   ? static_cast<std::uint32_t>(std::clamp(place, at + 1.0, above - 1.0))
                                   : at + (above - at) / 2;
            const double y = fromBelow(probe).y;
            place = probe + (trackY - y) * perMetre;
            if (y > trackY) {
                above = probe;
                aboveY = y;
            } else {
                at = probe;
                atY = y;
                place += 1.0;
            }
        }
        const Point low = fromBelow(at);
        const Point high = fromBelow(above);
        const std::size_t next = std::max(track + 1, ladder.below(high.y));
        visit(track, next, rises ? low : high, rises ? high : low);
        track = next;
        perMetre = (above - begin) / (aboveY - beginY);
    }
}

/// Calls visit(low, high, from, to) for every edge that tracks from `low` to before `high` cross. Half-open:
/// a vertex on a centre line counts for one of its two edges.
template <class Visit>
void ScanLine::forEachCrossedEdge(Walk& walk, const Visit& visit) const {
    const Ladder ladder{walk.tracks};
    const auto offer = [&visit](std::size_t belowA, std::size_t belowB, Point a, Point b) {
        const auto [low, high] = std::minmax(belowA, belowB);
        if (low < high) {
            visit(low, high, a, b);
        }
    };
    if (walk.rotated.empty()) {
        const auto isCrossed = [&ladder](double low, double high) {
            return ladder.below(low) != ladder.below(high);
        };
        // Runs of one trend that follow on each other are searched as one.
        EdgeTree::Run waiting;
        EdgeTree::Trend waitingTrend = EdgeTree::Trend::Mixed;
        const auto searchWaiting = [&] {
            if (waiting.size() > 0) {
                forEachCrossedEdgeOf(waiting, waitingTrend, walk, ladder, visit);
            }
        };
        const auto look = [&](const EdgeTree::Run& run, EdgeTree::Trend trend) {
            if (trend != EdgeTree::Trend::Mixed) {
                if (trend == waitingTrend && run.before + 1 == waiting.end && run.first == waiting.end) {
                    waiting.end = run.end;
                } else {
                    searchWaiting();
                    waiting = run;
                    waitingTrend = trend;
                }
                return;
            }
            Point a = walk.turned(vertices_[run.before]);
            for (std::uint32_t i = run.first; i < run.end; ++i) {
                const Point b = walk.turned(vertices_[i]);
                offer(ladder.below(a.y), ladder.below(b.y), a, b);
                a = b;
            }
        };
        tree_.visitRuns(walk.cosine, walk.sine, isCrossed, look);
        searchWaiting();
        return;
    }
    walk.tracksBelow.resize(walk.rotated.size());
    for (std::size_t i = 0; i < walk.rotated.size(); ++i) {
        walk.tracksBelow[i] = static_cast<std::uint32_t>(ladder.below(walk.rotated[i].y));
    }
    std::size_t begin = 0;
    for (const std::size_t end : ringEnds_) {
        std::size_t a = end - 1;
        for (std::size_t b = begin; b < end; a = b++) {
            offer(walk.tracksBelow[a], walk.tracksBelow[b], walk.rotated[a], walk.rotated[b]);
        }
        begin = end;
    }
}

/// Finds the crossings of every edge with every centre line, sorted into tracks by counting.
void ScanLine::findCrossings(Walk& walk) const {
    const std::size_t trackCount = walk.tracks.size();
    walk.crossed.clear();
    // An edge adds one crossing at its lowest track and removes it after its highest.
    walk.added.assign(trackCount + 1, 0);
    forEachCrossedEdge(walk, [&](std::size_t low, std::size_t high, Point from, Point to) {
        walk.crossed.push_back({static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high), from, to});
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
    for (const auto& [low, high, a, b] : walk.crossed) {
        const double slope = (b.x - a.x) / (b.y - a.y);
        for (std::size_t k = low; k < high; ++k) {
            walk.crossings[walk.firstInterval[k]++] = a.x + (walk.tracks[k] - a.y) * slope;
        }
    }
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

}  // namespace furrow
