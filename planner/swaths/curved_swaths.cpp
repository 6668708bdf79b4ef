#include "planner/swaths/curved_swaths.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/curve_sampling.h"
#include "planner/jobs/parallel.h"
#include "planner/swaths/heading_search.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace furrow {

namespace {

// Slightly more than the machine's radius, so that rounding stays within the limit.
constexpr double kRadiusReserve = 1.0 + 1e-6;
// Tracks within this distance are flush.
constexpr double kFlushTrackM = 1e-3;
// Largest distance of strips from their chords when their area is measured.
constexpr Length kStripChord = metres(0.002);
// Largest turn of one strip.
constexpr double kMostTurnedRad = 0.5 * std::numbers::pi;
// A ring whose end is this close to its start is closed.
constexpr double kClosedM = 1e-6;

MultiPolygon stripsOf(const SwathSet& set) {
    MultiPolygon strips;
    for (const Swath& swath : set.swaths) {
        addStrips(lineOf(swath), swath.width, strips);
    }
    return strips;
}

/// The mean heading of all stretches, weighted by length. Opposite directions are equal.
Angle meanHeading(const std::vector<Swath>& swaths) {
    Point sum;
    for (const Swath& swath : swaths) {
        const Polyline line = middleLine(swath, metres(0.1));
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Point way = line[i + 1] - line[i];
            sum = sum + norm(way) * direction(2.0 * std::atan2(way.y, way.x));
        }
    }
    return normalisedSwathHeading(radians(0.5 * std::atan2(sum.y, sum.x)));
}

/// What lies within half the width of a line.
Polygon stripAlong(const Curve& line, double halfM) {
    Ring left;
    Ring right;
    for (const CurveSample& sample : sampled(line, kStripChord)) {
        const Point ahead = direction(sample.pose.heading.si());
        const Point side{-ahead.y, ahead.x};
        left.push_back(sample.pose.position + halfM * side);
        right.push_back(sample.pose.position - halfM * side);
    }
    std::ranges::reverse(left);
    right.insert(right.end(), left.begin(), left.end());
    const CurvePiece& first = line.pieces.front();
    if (std::abs(first.curvature.si()) * halfM >= 1.0) {
        // A sector about a centre inside the strip.
        const Point ahead = direction(line.start.heading.si());
        const double radiusM = 1.0 / first.curvature.si();
        const Point centre = line.start.position + radiusM * Point{-ahead.y, ahead.x};
        const double outerM = std::abs(radiusM) + halfM;
        std::erase_if(right, [&](Point point) { return distance(point, centre) < 0.5 * outerM; });
        right.push_back(centre);
    }
    if (signedAreaM2(right) < 0.0) {
        std::ranges::reverse(right);
    }
    return {.outer = std::move(right), .holes = {}};
}

}  // namespace

// No strip turns far enough to come back to itself. Where the line bends more tightly than half the width,
// every arc is a strip of its own.
void addStrips(const Curve& whole, Length width, MultiPolygon& strips) {
    const double halfM = 0.5 * width.si();
    Curve open{.type = {}, .start = whole.start, .pieces = {}};
    double turnedRad = 0.0;
    Pose at = whole.start;
    const auto close = [&] {
        if (!open.pieces.empty()) {
            strips.push_back(stripAlong(open, halfM));
        }
        open = {.type = {}, .start = at, .pieces = {}};
        turnedRad = 0.0;
    };
    for (const CurvePiece& piece : whole.pieces) {
        const double bend = std::abs(piece.curvature.si());
        const auto parts =
            std::max(1, static_cast<int>(std::ceil(bend * piece.length.si() / kMostTurnedRad)));
        CurvePiece part = piece;
        part.length = piece.length / parts;
        const bool isSector = bend * halfM >= 1.0;
        for (int k = 0; k < parts; ++k) {
            if (isSector || turnedRad + bend * part.length.si() > kMostTurnedRad * (1.0 + 1e-9)) {
                close();
            }
            open.pieces.push_back(part);
            turnedRad += bend * part.length.si();
            at = advanced(at, part, part.length);
            if (isSector) {
                close();
            }
        }
    }
    close();
}

Length swathRadius(const Machine& machine) {
    const Length aside = machine.spec().implement.lateralOffset;
    return kRadiusReserve * (machine.minTurningRadius() + std::max(aside, -aside));
}

std::vector<double> trackPlaces(double lowM, double highM, const SwathSpacing& spacing, bool anchored) {
    const double widthM = spacing.width.si();
    const double stepM = (spacing.width - spacing.overlap).si();
    const double lowest = lowM + 0.5 * widthM;
    const double highest = highM - 0.5 * widthM;
    const double slack = std::min(kFlushTrackM, 0.01 * stepM);
    std::vector<double> places;
    if (highest - lowest <= slack) {
        const double nearest =
            anchored ? stepM * std::round(0.5 * (lowM + highM) / stepM) : 0.5 * (lowM + highM);
        places.push_back(nearest > lowM && nearest < highM ? nearest : 0.5 * (lowM + highM));
        return places;
    }
    const auto spread = [&](double from, double to) {
        const auto steps = static_cast<int>(std::ceil((to - from - slack) / stepM));
        for (int i = 0; i < steps; ++i) {
            places.push_back(from + (to - from) * i / steps);
        }
    };
    const bool isInside = anchored && lowest < -slack && highest > slack;
    if (spacing.lastPass == LastPass::Spread && (isInside || !anchored)) {
        spread(lowest, isInside ? 0.0 : highest);
        if (isInside) {
            spread(0.0, highest);
        }
        places.push_back(highest);
        return places;
    }
    const double first = anchored ? stepM * std::ceil((lowest - slack) / stepM) : lowest;
    const bool isGap = spacing.lastPass == LastPass::Gap;
    if (!isGap && first > lowest + slack) {
        places.push_back(lowest);
    } else if (isGap && first <= highest + slack && spacing.isWorthASwath(metres(first - lowest))) {
        places.push_back(spacing.overEdge ? first - stepM : lowest);
    }
    for (int i = 0; first + i * stepM <= highest + slack; ++i) {
        places.push_back(first + i * stepM);
    }
    if (!isGap && (places.empty() || places.back() < highest - slack)) {
        places.push_back(highest);
    } else if (isGap && !places.empty() && spacing.isWorthASwath(metres(highest - places.back()))) {
        places.push_back(spacing.overEdge ? places.back() + stepM : highest);
    }
    if (places.empty()) {
        places.push_back(0.5 * (lowest + highest));
    }
    return places;
}

Result<std::vector<SwathLine>> parallelSwathLines(const GuideLine& guide, const SwathSpacing& spacing,
                                                  bool anchored, const SwathTask& task,
                                                  const JobContext& job) {
    const ParallelLines parallels{guide};
    const MainlandEdges edges{task.mainland};
    double lowM = std::numeric_limits<double>::infinity();
    double highM = -lowM;
    for (const Point& point : edges.pointsAlong(std::max(metres(1.0), 0.25 * spacing.width))) {
        const double leftM = parallels.leftOf(point);
        lowM = std::min(lowM, leftM);
        highM = std::max(highM, leftM);
    }
    if (const auto checked = checkTrackCount(spacing, metres(highM - lowM)); !checked) {
        return std::unexpected(checked.error());
    }
    const std::vector<double> places = trackPlaces(lowM, highM, spacing, anchored);
    const Length radius = swathRadius(task.machine);
    const auto beside = parallelMap<std::vector<Curve>>(
        places.size(),
        [&](std::size_t i) {
            std::vector<Curve> parts;
            const std::vector<GuideLine> lines = parallels.at(places[i], radius);
            for (const GuideLine& line : lines) {
                for (Curve& part : edges.partsInside(drivable(line))) {
                    // Shorter parts are remains of a bend that is too tight to be followed.
                    if (lines.size() == 1 || part.length() >= spacing.width) {
                        parts.push_back(std::move(part));
                    }
                }
            }
            return parts;
        },
        job);
    if (!beside) {
        return std::unexpected(beside.error());
    }
    std::vector<SwathLine> lines;
    const double stepM = (spacing.width - spacing.overlap).si();
    for (std::size_t i = 0; i < beside->size(); ++i) {
        const double steps = std::round(places[i] / stepM);
        const bool isOnLane = anchored && std::abs(places[i] - steps * stepM) < kFlushTrackM;
        for (const Curve& part : (*beside)[i]) {
            lines.push_back({static_cast<int>(i), part,
                             isOnLane ? std::optional{static_cast<int>(steps)} : std::nullopt});
        }
    }
    return lines;
}

Result<SwathSet> swathsOnLines(const std::vector<SwathLine>& lines, const SwathTask& task,
                               const JobContext& job) {
    SwathSet set;
    for (const auto& [track, line, lane] : lines) {
        const Point end = line.end().position;
        const bool closes = distance(end, line.start.position) < kClosedM;
        set.swaths.push_back({.start = line.start.position,
                              .end = closes ? line.start.position : end,
                              .number = static_cast<int>(set.swaths.size()) + 1,
                              .track = track,
                              .width = task.machine.operatingWidth(),
                              .lane = lane,
                              .curve = line});
        set.totalLength += line.length();
    }
    if (set.swaths.empty()) {
        return std::unexpected(noSwathFits());
    }
    set.heading = meanHeading(set.swaths);
    const auto covered = coverageOf(set, task.mainland, job);
    if (!covered) {
        return std::unexpected(covered.error());
    }
    set.coverage = covered->share;
    set.overlap = covered->overlap;
    return set;
}

Result<StripCoverage> coverageOf(const SwathSet& set, const MultiPolygon& mainland, const JobContext& job) {
    return coverageOf(stripsOf(set), mainland, set.heading, job);
}

}  // namespace furrow
