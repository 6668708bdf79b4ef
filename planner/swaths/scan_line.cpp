#include "planner/swaths/scan_line.h"

#include "planner/swaths/scan_line_walk.h"
#include "planner/turns/dubins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace furrow {

namespace {

// With fewer vertices all of them are rotated as quickly as they are searched.
constexpr std::size_t kManyVertices = 400;

Length curveLength(const Pose& from, const Pose& to, Length radius) {
    return radius > Length{} ? dubinsLength(from, to, radius) : metres(norm(to.position - from.position));
}

/// A lower bound of the turn between opposite tracks, over all shifts of their ends along the track. A shift
/// can be driven straight, so the length of the curve changes by no more than the shift. The minimum over a
/// grid therefore gives a bound.
Length shortestTurnBetween(Length spacing, Length radius) {
    const Pose from{.position = {}, .heading = degrees(0.0)};
    const auto lengthAt = [&](double shiftM) {
        return curveLength(from, {.position = {shiftM, spacing.si()}, .heading = degrees(180.0)}, radius)
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
    if (vertices_.size() >= kManyVertices) {
        tree_ = EdgeTree{vertices_, ringEnds_};
    }
}

Length ScanLine::diameter() const {
    return metres(diameterM_);
}

void ScanLine::turnTo(Angle heading, Walk& walk) const {
    walk.cosine = std::cos(heading.si());
    walk.sine = std::sin(heading.si());
    if (spacing_.anchor) {
        walk.anchorY = walk.turned(*spacing_.anchor - origin_).y;
    }
}

void ScanLine::rotate(Angle heading, Walk& walk) const {
    turnTo(heading, walk);
    walk.rotated.resize(vertices_.size());
    walk.lowY = std::numeric_limits<double>::infinity();
    walk.highY = -walk.lowY;
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
        const Point turned = walk.turned(vertices_[i]);
        walk.rotated[i] = turned;
        walk.lowY = std::min(walk.lowY, turned.y);
        walk.highY = std::max(walk.highY, turned.y);
    }
}

void ScanLine::rotateForLines(Angle heading, Walk& walk) const {
    if (tree_.empty()) {
        rotate(heading, walk);
        return;
    }
    turnTo(heading, walk);
    walk.rotated.clear();
    walk.highY = tree_.highest(vertices_, walk.cosine, walk.sine);
    walk.lowY = -tree_.highest(vertices_, -walk.cosine, -walk.sine);
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

template <class TurnLength>
Duration ScanLine::drivingTime(const Walk& walk, const TurnLength& turnLength) const {
    double swathsM = 0.0;
    double turnsM = 0.0;
    int changes = 0;
    std::optional<Pose> from;
    const auto drive = [&](double startX, double endX, double y, bool back) {
        const double lead = back ? -driving_->lead.si() : driving_->lead.si();
        const Pose to{.position = {(back ? endX : startX) + lead, y}, .heading = degrees(back ? 180.0 : 0.0)};
        if (from) {
            ++changes;
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
    return seconds(swathsM / driving_->working.si() + turnsM / driving_->turning.si()) +
           changes * driving_->change;
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
            return curveLength(from, to, driving_->radius).si();
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
    rotateForLines(heading, walk);
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
