#include "planner/decomposition/ledges.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace furrow {

namespace {

// A larger turn at one point is a corner there, not part of a bend.
constexpr double kSharpRad = 35.0 * std::numbers::pi / 180.0;
constexpr double kLeastCornerRad = 5.0 * std::numbers::pi / 180.0;

/// A level run of points that starts at `first`. Indices may continue beyond the ring's end.
struct Level {
    std::size_t first = 0;
    std::size_t last = 0;
    Ledge ledge;
};

std::vector<Level> levelsOf(const Ring& ring) {
    std::vector<Level> levels;
    const std::size_t size = ring.size();
    const auto level = [](Point a, Point b) { return std::abs(a.y - b.y) < kLevelM; };
    std::size_t first = 0;
    while (first < size && level(ring[first], ring[(first + size - 1) % size])) {
        ++first;
    }
    for (std::size_t i = first; i < first + size;) {
        std::size_t last = i;
        while (last + 1 < first + size && level(ring[last % size], ring[(last + 1) % size])) {
            ++last;
        }
        const Point before = ring[(i + size - 1) % size];
        const Point begin = ring[i % size];
        const Point end = ring[last % size];
        const Point after = ring[(last + 1) % size];
        const bool fromAbove = before.y > begin.y;
        const bool toAbove = after.y > end.y;
        Ledge ledge{.left = begin.x < end.x ? begin : end,
                    .right = begin.x < end.x ? end : begin,
                    .isValley = fromAbove && toAbove,
                    .isPeak = !fromAbove && !toAbove};
        if (begin == end) {
            ledge.isInward = cross(begin - before, after - begin) < 0.0;
        } else {
            // The mainland lies to the left of the direction, so above a ledge that runs to the right.
            const bool isAbove = end.x > begin.x;
            ledge.isInward = ledge.isValley ? !isAbove : isAbove;
        }
        levels.push_back({i, last, ledge});
        i = last + 1;
    }
    return levels;
}

/// A run of points that is one corner, starting at `first`. Indices may continue beyond the ring's end.
struct Bend {
    std::size_t first = 0;
    std::size_t last = 0;
    std::size_t middle = 0;  ///< half of the bend is turned here
    double turnRad = 0.0;
};

std::vector<Bend> bendsOf(const Ring& ring, Length shortEdge) {
    const std::size_t size = ring.size();
    std::vector<double> turnRad(size);
    for (std::size_t i = 0; i < size; ++i) {
        const Point in = ring[i] - ring[(i + size - 1) % size];
        const Point out = ring[(i + 1) % size] - ring[i];
        turnRad[i] = std::atan2(cross(in, out), dot(in, out));
    }
    const auto goesOn = [&](std::size_t i) {
        const double here = turnRad[i % size];
        const double next = turnRad[(i + 1) % size];
        return std::max(std::abs(here), std::abs(next)) < kSharpRad && here * next >= 0.0 &&
               distance(ring[i % size], ring[(i + 1) % size]) < shortEdge.si();
    };
    std::size_t begin = 0;
    while (begin + 1 < size && goesOn(begin)) {
        ++begin;
    }
    std::vector<Bend> bends;
    for (std::size_t first = begin + 1; first <= begin + size;) {
        Bend bend{.first = first, .last = first, .middle = first, .turnRad = turnRad[first % size]};
        while (bend.last < begin + size && goesOn(bend.last)) {
            ++bend.last;
            bend.turnRad += turnRad[bend.last % size];
        }
        double turned = turnRad[first % size];
        while (bend.middle < bend.last && std::abs(turned) < 0.5 * std::abs(bend.turnRad)) {
            ++bend.middle;
            turned += turnRad[bend.middle % size];
        }
        first = bend.last + 1;
        bends.push_back(bend);
    }
    return bends;
}

}  // namespace

std::vector<Ledge> ledgesOf(const Ring& ring, Length bend) {
    std::vector<Level> levels = levelsOf(ring);
    const std::size_t size = ring.size();
    std::vector<std::size_t> levelAt(size);
    for (std::size_t k = 0; k < levels.size(); ++k) {
        for (std::size_t i = levels[k].first; i <= levels[k].last; ++i) {
            levelAt[i % size] = k;
        }
    }
    for (const Bend& corner : bendsOf(ring, bend)) {
        if (std::abs(corner.turnRad) < kLeastCornerRad) {
            continue;
        }
        std::size_t at = levelAt[corner.middle % size];
        const Level* best = nullptr;
        for (std::size_t i = corner.first; i <= corner.last; ++i) {
            const Level& level = levels[levelAt[i % size]];
            const bool isExtreme = level.ledge.isValley || level.ledge.isPeak;
            const bool isLong = level.last > level.first;
            if (isExtreme || (isLong && best == nullptr)) {
                best = &level;
                at = levelAt[i % size];
            }
            if (isExtreme) {
                break;
            }
        }
        levels[at].ledge.isCorner = true;
    }
    std::vector<Ledge> ledges;
    std::ranges::transform(levels, std::back_inserter(ledges), &Level::ledge);
    return ledges;
}

}  // namespace furrow
