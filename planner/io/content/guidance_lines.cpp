#include "planner/io/content/guidance_lines.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/segment.h"
#include "planner/plan/plan.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <format>
#include <limits>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

// Lines whose directions differ by less than this (1 cm over 100 m) are one direction to a terminal.
constexpr double kSameDirectionRad = 1e-4;
// Curves are written as chords that stay this close to them,
constexpr Length kGuideChord = metres(0.02);
// and stand for those beside them, which may be off by so much.
constexpr double kBesideM = 0.15;
constexpr Length kDrawnOut = metres(5000.0);
constexpr Length kShortestAb = metres(20.0);
// A line is compared with a guide at so many places.
constexpr double kAsked = 100.0;

double directionRad(const Swath& swath) {
    const Point along = swath.end - swath.start;
    return normalisedSwathHeading(radians(std::atan2(along.y, along.x))).si();
}

/// A swath in its own direction is straight, too.
bool isBent(const Swath& swath) {
    return sharpestBend(swath.curve) > Curvature{};
}

/// For each direction the longest swath of its first track, in the order in which directions first come.
std::vector<const Swath*> straightGuides(const SwathSet& set) {
    std::vector<const Swath*> chosen;
    for (const Swath& swath : set.swaths) {
        if (swath.isCurved()) {
            continue;
        }
        const double direction = directionRad(swath);
        const auto same = std::ranges::find_if(chosen, [direction](const Swath* other) {
            return std::abs(std::remainder(directionRad(*other) - direction, std::numbers::pi)) <
                   kSameDirectionRad;
        });
        if (same == chosen.end()) {
            chosen.push_back(&swath);
        } else if (swath.track == (*same)->track && swath.length() > (*same)->length()) {
            *same = &swath;
        }
    }
    return chosen;
}

double toLineM(Point point, const Polyline& line) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        nearest = std::min(nearest, distanceToSegment(point, line[i], line[i + 1]));
    }
    return nearest;
}

/// Evenly along a line: bends have more points than straights.
std::vector<Point> evenly(const Polyline& line) {
    const double stepM = lengthM(line) / kAsked;
    std::vector<Point> points;
    double nextM = 0.5 * stepM;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const double edgeM = distance(line[i], line[i + 1]);
        for (; nextM <= edgeM; nextM += stepM) {
            points.push_back(line[i] + (nextM / edgeM) * (line[i + 1] - line[i]));
        }
        nextM -= edgeM;
    }
    return points;
}

/// Whether a terminal that moves the guide beside itself gets the line, but for what is rounded.
bool isBeside(const Polyline& line, const Polyline& guide) {
    std::vector<double> distances;
    for (const Point& point : evenly(line)) {
        distances.push_back(toLineM(point, guide));
    }
    std::ranges::sort(distances);
    const std::size_t rounded = distances.size() / 4;
    return distances.empty() || distances[distances.size() - 1 - rounded] - distances.front() < kBesideM;
}

/// Of lines of their own that lie beside each other the one that was given, or the longest; rings are one
/// pivot, which the outermost stands for.
std::vector<const Swath*> curvedGuides(const SwathSet& set) {
    std::vector<const Swath*> longest;
    for (const Swath& swath : set.swaths) {
        // Those beside one that goes round an obstacle have none to go round.
        if (swath.isCurved() && !swath.goesRound) {
            longest.push_back(&swath);
        }
    }
    // The line that was given before its parallels, which may have lost a bend that it has.
    std::ranges::stable_sort(longest, [](const Swath* a, const Swath* b) {
        const auto stepsOf = [](const Swath& swath) {
            return swath.lane ? std::abs(*swath.lane) : std::numeric_limits<int>::max();
        };
        // A straight end of a curve's parallel is no guide of its own.
        if (isBent(*a) != isBent(*b)) {
            return isBent(*a);
        }
        return stepsOf(*a) != stepsOf(*b) ? stepsOf(*a) < stepsOf(*b) : a->length() > b->length();
    });
    std::vector<const Swath*> chosen;
    std::vector<Polyline> lines;
    for (const Swath* swath : longest) {
        const Polyline line = middleLine(*swath, kGuideChord);
        if (std::ranges::none_of(lines, [&](const Polyline& guide) { return isBeside(line, guide); })) {
            chosen.push_back(swath);
            // Terminals draw curves out at both ends.
            lines.push_back(
                swath->isClosed()
                    ? line
                    : middleLine({.curve = extended(swath->curve, kDrawnOut, kDrawnOut)}, kGuideChord));
        }
    }
    return chosen;
}

/// A and B of a line; of a short swath drawn out both ways, so that places to the centimetre still give its
/// bearing.
std::pair<Point, Point> endsOf(const Swath& swath) {
    const Point along = swath.end - swath.start;
    const double lengthM = norm(along);
    const double outM = std::max(0.0, 0.5 * (kShortestAb.si() - lengthM));
    const Point step = lengthM > 0.0 ? (outM / lengthM) * along : Point{};
    return {swath.start - step, swath.end + step};
}

GuidanceLine abLine(const Swath& swath, const Plan& plan) {
    const auto [a, b] = endsOf(swath);
    const Point along = b - a;
    const double eastDeg = inDegrees(radians(std::atan2(along.y, along.x)));
    // From A to B, so in the full circle; what is rounded up to 360 is north again.
    const double bearingDeg = std::fmod(std::round((450.0 - eastDeg) * 1e4) / 1e4, 360.0);
    const LocalFrame& frame = plan.field().frame();
    return {.kind = GuidanceKind::AbLine,
            .name = std::format("AB {:.1f}", bearingDeg),
            .points = {frame.toGeo(a), frame.toGeo(b)},
            .bearing = degrees(bearingDeg),
            .width = plan.request.machine.operatingWidth()};
}

GuidanceLine pivot(const Swath& ring, const Plan& plan) {
    const double radiusM = 1.0 / ring.curve.pieces.front().curvature.si();
    const Point ahead = direction(ring.curve.start.heading.si());
    const Point centre = ring.start + radiusM * Point{-ahead.y, ahead.x};
    return {.kind = GuidanceKind::Pivot,
            .points = {plan.field().frame().toGeo(centre)},
            .radius = metres(std::abs(radiusM)),
            .width = plan.request.machine.operatingWidth()};
}

GuidanceLine lineFor(const Swath& swath, const Plan& plan, std::size_t number) {
    if (!isBent(swath)) {
        return abLine(swath, plan);
    }
    const bool isPivot = swath.isClosed() && !swath.goesRound;
    GuidanceLine line =
        isPivot ? pivot(swath, plan)
                : GuidanceLine{.kind = GuidanceKind::Curve,
                               .points = plan.field().frame().toGeo(middleLine(swath, kGuideChord)),
                               .width = plan.request.machine.operatingWidth()};
    line.name = std::format("{} {}", isPivot ? "Pivot" : "Curve", number);
    return line;
}

}  // namespace

std::vector<GuidanceLine> guidanceLines(const Plan& plan) {
    std::vector<GuidanceLine> lines;
    // Curves before what has become straight beside them.
    for (const auto& guides : {curvedGuides(plan.swaths), straightGuides(plan.swaths)}) {
        for (std::size_t i = 0; i < guides.size(); ++i) {
            lines.push_back(lineFor(*guides[i], plan, i + 1));
        }
    }
    for (const Swath& swath : plan.swaths.swaths) {
        if (swath.goesRound && !swath.tramline) {
            lines.push_back(lineFor(swath, plan, 0));
            lines.back().name = std::format("Swath {}", swath.number);
            lines.back().repeats = false;
        }
    }
    int tramline = 0;
    for (const Swath& swath : plan.swaths.swaths) {
        if (swath.tramline) {
            lines.push_back(lineFor(swath, plan, 0));
            lines.back().name = std::format("Tramline {}", ++tramline);
            lines.back().repeats = false;
        }
    }
    return lines;
}

}  // namespace furrow
