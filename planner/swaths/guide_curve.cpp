#include "planner/swaths/guide_curve.h"

#include "planner/geometry/box_tree.h"
#include "planner/geometry/simplify.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

namespace furrow {

namespace {

constexpr double kSamePointM = 0.01;
constexpr Length kSimplified = metres(0.05);
// Largest distance of an arc from the gentle corner that it replaces.
constexpr Length kGentle = metres(0.1);
// An extended line ends this far before it meets itself.
constexpr double kApartM = 1.0;
// A curve that turns on and on within a machine's length has so many corners near each other that working out
// where it could be followed has no end. A machine can turn by the length over its radius; rounding takes
// some of the corners away.
constexpr double kTurnsSpared = 4.0 * std::numbers::pi;
constexpr double kTurnsRounded = 3.0;
// A sharper bend is a turn back.
constexpr Angle kSharpest = degrees(175.0);

Polyline withoutCloseOnes(std::span<const Point> line) {
    Polyline kept;
    for (const Point& point : line) {
        if (kept.empty() || distance(kept.back(), point) >= kSamePointM) {
            kept.push_back(point);
        }
    }
    return kept;
}

/// The share of a to b at which it meets c to d. Empty if they do not meet.
std::optional<double> meeting(Point a, Point b, Point c, Point d) {
    const Point u = b - a;
    const Point v = d - c;
    const double area = cross(u, v);
    if (std::abs(area) < 1e-12) {
        return std::nullopt;
    }
    const double s = cross(c - a, v) / area;
    const double t = cross(c - a, u) / area;
    return s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0 ? std::optional{s} : std::nullopt;
}

/// The place at which a line crosses itself. Empty if there is none.
std::optional<Point> crossingOf(const Polyline& line) {
    std::vector<Bounds> boxes;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        boxes.push_back(bounds(line[i], line[i + 1]));
    }
    const BoxTree tree{boxes};
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        std::optional<Point> place;
        tree.any([&](const Bounds& box) { return meet(box, boxes[i]); },
                 [&](std::size_t k) {
                     if (k > i + 1) {
                         if (const auto share = meeting(line[i], line[i + 1], line[k], line[k + 1])) {
                             place = line[i] + *share * (line[i + 1] - line[i]);
                         }
                     }
                     return place.has_value();
                 });
        if (place) {
            return place;
        }
    }
    return std::nullopt;
}

/// The length of a ray from the end of the line before it meets the line.
double reachBefore(const Polyline& line, Point end, Point ahead, double reachM, std::size_t ownEdge) {
    double shortestM = reachM;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        if (i != ownEdge) {
            if (const auto share = meeting(end, end + reachM * ahead, line[i], line[i + 1])) {
                shortestM = std::min(shortestM, *share * reachM - kApartM);
            }
        }
    }
    return std::max(0.0, shortestM);
}

Polyline drawnOut(Polyline line, double reachM) {
    const std::size_t last = line.size() - 1;
    const auto aheadOf = [](Point from, Point to) { return (1.0 / distance(from, to)) * (to - from); };
    const Point back = aheadOf(line[1], line[0]);
    const Point ahead = aheadOf(line[last - 1], line[last]);
    double beforeM = reachBefore(line, line[0], back, reachM, 0);
    double afterM = reachBefore(line, line[last], ahead, reachM, last - 1);
    const Point first = line.front();
    const Point end = line.back();
    if (const auto share = meeting(first, first + beforeM * back, end, end + afterM * ahead)) {
        const Point at = first + *share * beforeM * back;
        beforeM = std::max(0.0, distance(first, at) - kApartM);
        afterM = std::max(0.0, distance(end, at) - kApartM);
    }
    if (beforeM > 0.0) {
        line.front() = first + beforeM * back;
    }
    if (afterM > 0.0) {
        line.back() = end + afterM * ahead;
    }
    return line;
}

/// Bends to the left are rounded first, then bends to the right. The second step does not change the first.
std::vector<GuideLine> rounded(const GuideLine& line, Length radius, Angle sharpest) {
    std::vector<GuideLine> result;
    for (GuideLine& part : ParallelLines{line}.at(0.0, radius, sharpest)) {
        for (GuideLine& finished : ParallelLines{std::move(part)}.at(-0.0, radius, sharpest)) {
            result.push_back(std::move(finished));
        }
    }
    return result;
}

/// How far a line turns, to either side, in all.
double turnedRad(const Polyline& line) {
    double sum = 0.0;
    for (std::size_t i = 2; i < line.size(); ++i) {
        const Point in = line[i - 1] - line[i - 2];
        const Point out = line[i] - line[i - 1];
        sum += std::abs(std::atan2(cross(in, out), dot(in, out)));
    }
    return sum;
}

Error tooSharp(Length radius, std::string_view where) {
    return {.code = ErrorCode::InputRefused,
            .what = message("the curve bends more sharply than this machine can follow ({:.1f} m of radius)",
                            radius.si()),
            .where = std::string{where},
            .remedy = "give a gentler curve, or one without a turn back"};
}

}  // namespace

Result<GuideLine> guideCurve(const Polyline& points, Length radius, Length reach, std::string_view where) {
    const Polyline line = simplified(withoutCloseOnes(points), kSimplified);
    if (line.size() < 2) {
        return std::unexpected(
            Error{.code = ErrorCode::Usage,
                  .what = "a curve needs at least two points that differ",
                  .where = std::string{where},
                  .remedy = "give it as WKT in WGS84, such as LINESTRING (4.1 52.0, 4.2 52.0, 4.3 52.1)"});
    }
    if (const auto crossing = crossingOf(line)) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = message("the curve crosses itself, {:.0f} m from its start",
                                                     distance(*crossing, line.front())),
                                     .where = std::string{where},
                                     .remedy = "give a curve that does not, or plan its parts apart"});
    }
    if (turnedRad(line) > kTurnsSpared + kTurnsRounded * lengthM(line) / radius.si()) {
        return std::unexpected(tooSharp(radius, where));
    }
    std::vector<GuideLine> result =
        rounded(guideLineThrough(drawnOut(line, reach.si()), radius, kGentle), radius, kSharpest);
    if (result.size() != 1) {
        return std::unexpected(tooSharp(radius, where));
    }
    return std::move(result.front());
}

std::vector<GuideLine> followedLine(const Polyline& points, Length radius) {
    const Polyline line = simplified(withoutCloseOnes(points), kSimplified);
    return line.size() < 2 ? std::vector<GuideLine>{}
                           : rounded(guideLineThrough(line, radius, kGentle), radius, kSharpestBend);
}

}  // namespace furrow
