#include "planner/swaths/guide_line.h"

#include "planner/geometry/tolerances.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace furrow {

namespace {

// Smaller bends are straights.
constexpr double kStraightRad = 1e-9;
// A parallel is sampled in steps of these metres and radians,
constexpr double kParallelLookM = 2.0;
constexpr double kLookRad = 0.1;
// and, where its stretches do not meet, of these metres.
constexpr double kLookCloselyM = 0.02;
// Stretches of a parallel whose ends are closer than this meet.
constexpr double kMeetingM = 1e-3;
// Shorter stretches are rounding errors.
constexpr double kLeastPlace = 1e-9;
// A radius counts as kept if only rounding errors are missing.
constexpr double kRadiusSlack = 1.0 - 1e-6;

Point leftOfHeading(double headingRad) {
    return {-std::sin(headingRad), std::cos(headingRad)};
}

Point positionOn(Point from, double headingRad, const GuidePiece& piece, double share) {
    const double turnRad = piece.turnRad * share;
    if (std::abs(piece.turnRad) < kStraightRad || piece.lengthM <= 0.0) {
        return from + piece.lengthM * share * direction(headingRad);
    }
    // The chord of the arc.
    const double chordM = 2.0 * piece.lengthM / piece.turnRad * std::sin(0.5 * turnRad);
    return from + chordM * direction(headingRad + 0.5 * turnRad);
}

Bounds boxOf(Point from, Point to, const GuidePiece& piece) {
    const double turnRad = std::abs(piece.turnRad);
    double beyondM = 0.0;
    if (turnRad > kStraightRad && piece.lengthM > 0.0) {
        const double radiusM = piece.lengthM / turnRad;
        beyondM = turnRad < std::numbers::pi ? radiusM * (1.0 - std::cos(0.5 * turnRad)) : 2.0 * radiusM;
    }
    return widened(bounds(from, to), beyondM);
}

}  // namespace

GuideLine guideLineThrough(const Polyline& points, Length radius, Length tolerance) {
    const auto headingOf = [&](std::size_t edge) {
        const Point way = points[edge + 1] - points[edge];
        return std::atan2(way.y, way.x);
    };
    GuideLine line{.start = {.position = points.front(), .heading = radians(headingOf(0))}, .pieces = {}};
    double takenM = 0.0;  // of the edge, by the arc at its beginning
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double edgeM = distance(points[i], points[i + 1]);
        if (i + 2 == points.size()) {
            line.pieces.push_back({.lengthM = edgeM - takenM});
            break;
        }
        const double turnRad = wrappedAngle(radians(headingOf(i + 1) - headingOf(i))).si();
        const double nextM = distance(points[i + 1], points[i + 2]);
        // The middle of the arc is t tan(turn / 4) away from the corner.
        const double tangentM = std::min(
            {0.5 * edgeM, 0.5 * nextM, tolerance.si() / std::max(std::tan(0.25 * std::abs(turnRad)), 1e-12)});
        const double radiusM = tangentM / std::max(std::tan(0.5 * std::abs(turnRad)), 1e-12);
        const bool isArc = radiusM >= radius.si();
        if (const double straightM = edgeM - takenM - (isArc ? tangentM : 0.0); straightM > 0.0) {
            line.pieces.push_back({.lengthM = straightM});
        }
        if (std::abs(turnRad) > kStraightRad) {
            line.pieces.push_back({.lengthM = isArc ? radiusM * std::abs(turnRad) : 0.0, .turnRad = turnRad});
        } else if (isArc) {
            line.pieces.push_back({.lengthM = 2.0 * tangentM});
        }
        takenM = isArc ? tangentM : 0.0;
    }
    return line;
}

Curve drivable(const GuideLine& line) {
    Curve turn{.type = {}, .start = line.start, .pieces = {}};
    for (const GuidePiece& piece : line.pieces) {
        if (piece.lengthM <= 0.0) {
            continue;
        }
        const Curvature curvature =
            Curvature::fromSi(std::abs(piece.turnRad) < kStraightRad ? 0.0 : piece.turnRad / piece.lengthM);
        if (!turn.pieces.empty() && turn.pieces.back().curvature == curvature) {
            turn.pieces.back().length += metres(piece.lengthM);
        } else {
            turn.pieces.push_back({.length = metres(piece.lengthM), .curvature = curvature});
        }
    }
    return turn;
}

ParallelLines::ParallelLines(GuideLine line) : line_{std::move(line)} {
    Point at = line_.start.position;
    double headingRad = line_.start.heading.si();
    std::vector<Bounds> boxes;
    for (const GuidePiece& piece : line_.pieces) {
        placed_.push_back({piece, at, headingRad});
        const Point next = positionOn(at, headingRad, piece, 1.0);
        boxes.push_back(boxOf(at, next, piece));
        at = next;
        headingRad += piece.turnRad;
    }
    tree_ = BoxTree{boxes};
}

/// A place is the index of a piece plus the share along it. Headings continue past half a turn.
Pose ParallelLines::on(double place, double leftM) const {
    const auto index = std::min(static_cast<std::size_t>(place), placed_.size() - 1);
    const Placed& placed = placed_[index];
    const double share = place - static_cast<double>(index);
    const double headingRad = placed.headingRad + share * placed.piece.turnRad;
    return {.position = positionOn(placed.from, placed.headingRad, placed.piece, share) +
                        leftM * leftOfHeading(headingRad),
            .heading = radians(headingRad)};
}

double ParallelLines::distanceM(Point point, std::size_t piece) const {
    const Placed& placed = placed_[piece];
    const Point to = positionOn(placed.from, placed.headingRad, placed.piece, 1.0);
    const double turnRad = placed.piece.turnRad;
    const double endsM = std::min(distance(point, placed.from), distance(point, to));
    if (placed.piece.lengthM <= 0.0) {
        return endsM;
    }
    if (std::abs(turnRad) < kStraightRad) {
        const Point ahead = direction(placed.headingRad);
        const double along = dot(ahead, point - placed.from);
        return along > 0.0 && along < placed.piece.lengthM ? std::abs(cross(ahead, point - placed.from))
                                                           : endsM;
    }
    const double radiusM = placed.piece.lengthM / turnRad;  // negative to the right
    const Point centre = placed.from + radiusM * leftOfHeading(placed.headingRad);
    const Point arm = placed.from - centre;
    const Point reached = point - centre;
    double angleRad = std::copysign(1.0, turnRad) * std::atan2(cross(arm, reached), dot(arm, reached));
    if (angleRad < 0.0) {
        angleRad += 2.0 * std::numbers::pi;
    }
    if (angleRad > std::abs(turnRad)) {
        return endsM;
    }
    // |reached| - |radius|, without the difference of two large numbers for a nearly straight arc.
    const Point off = point - placed.from;
    return std::abs(2.0 * dot(arm, off) + dot(off, off)) / (norm(reached) + std::abs(radiusM));
}

bool ParallelLines::isFree(double place, double leftM) const {
    const Point point = on(place, leftM).position;
    const double limitM = std::abs(leftM) - kOffsetRoundingM;
    return !tree_.any([&](const Bounds& box) { return furrow::distanceM(point, box) < limitM; },
                      [&](std::size_t piece) { return distanceM(point, piece) < limitM; });
}

double ParallelLines::leftOf(Point point) const {
    double nearestM = std::numeric_limits<double>::infinity();
    std::size_t nearest = 0;
    tree_.any([&](const Bounds& box) { return furrow::distanceM(point, box) < nearestM; },
              [&](std::size_t piece) {
                  if (const double hereM = distanceM(point, piece); hereM < nearestM) {
                      nearestM = hereM;
                      nearest = piece;
                  }
                  return false;
              });
    const Placed& placed = placed_[nearest];
    const double turnRad = placed.piece.turnRad;
    if (std::abs(turnRad) > kStraightRad && placed.piece.lengthM > 0.0) {
        const double radiusM = placed.piece.lengthM / turnRad;
        const Point centre = placed.from + radiusM * leftOfHeading(placed.headingRad);
        const bool isWithin = distance(point, centre) < std::abs(radiusM);
        return (isWithin == (radiusM > 0.0) ? 1.0 : -1.0) * nearestM;
    }
    return cross(direction(placed.headingRad + 0.5 * turnRad), point - placed.from) >= 0.0 ? nearestM
                                                                                           : -nearestM;
}

std::vector<double> ParallelLines::placesBetween(double from, double to, double leftM, double apartM) const {
    std::vector<double> places{from};
    for (auto i = static_cast<std::size_t>(from); i < placed_.size() && static_cast<double>(i) < to; ++i) {
        const GuidePiece& piece = placed_[i].piece;
        const double beside = std::abs(piece.lengthM - leftM * piece.turnRad);
        // Corners are passed in steps, too.
        const auto steps = static_cast<int>(
            std::ceil(std::max({2.0, std::max(piece.lengthM, beside) / apartM,
                                std::abs(piece.turnRad) / (kLookRad * apartM / kParallelLookM)})));
        for (int k = 1; k <= steps; ++k) {
            const double place = static_cast<double>(i) + static_cast<double>(k) / steps;
            if (place > places.back() && place < to) {
                places.push_back(place);
            }
        }
    }
    places.push_back(to);
    return places;
}

std::vector<ParallelLines::Interval> ParallelLines::freeAmong(const std::vector<double>& places,
                                                              double leftM) const {
    // The last place with the same state as `same`.
    const auto border = [&](double same, double other, bool free) {
        for (int round = 0; round < 60 && std::abs(other - same) > 1e-15; ++round) {
            const double middle = 0.5 * (same + other);
            (isFree(middle, leftM) == free ? same : other) = middle;
        }
        return same;
    };
    std::vector<Interval> stretches;
    bool wasFree = false;
    for (std::size_t k = 0; k < places.size(); ++k) {
        const bool free = isFree(places[k], leftM);
        if (free && !wasFree) {
            stretches.push_back({k == 0 ? places[k] : border(places[k], places[k - 1], true), places[k]});
        } else if (!free && wasFree) {
            stretches.back().to = border(places[k - 1], places[k], true);
        } else if (free) {
            stretches.back().to = places[k];
        }
        wasFree = free;
    }
    std::erase_if(stretches, [](const Interval& stretch) { return stretch.to - stretch.from < kLeastPlace; });
    return stretches;
}

std::vector<ParallelLines::Interval> ParallelLines::freeStretches(double leftM) const {
    const auto end = static_cast<double>(placed_.size());
    const std::vector<Interval> seen = freeAmong(placesBetween(0.0, end, leftM, kParallelLookM), leftM);
    std::vector<Interval> stretches;
    for (const Interval& stretch : seen) {
        // Between stretches that do not meet lies a stretch too short for the first sampling, or an end of
        // the line.
        if (!stretches.empty() &&
            distance(on(stretches.back().to, leftM).position, on(stretch.from, leftM).position) > kMeetingM) {
            const Interval gap{stretches.back().to, stretch.from};
            for (const Interval& small :
                 freeAmong(placesBetween(gap.from, gap.to, leftM, kLookCloselyM), leftM)) {
                const bool isEnd = small.to <= gap.from + kLeastPlace || small.from >= gap.to - kLeastPlace;
                if (!isEnd) {
                    stretches.push_back(small);
                }
            }
        }
        stretches.push_back(stretch);
    }
    return stretches;
}

std::vector<ParallelLines::Interval> ParallelLines::withoutTight(const std::vector<Interval>& stretches,
                                                                 double leftM, double radiusM) const {
    std::vector<Interval> kept;
    for (const Interval& stretch : stretches) {
        bool open = false;
        for (auto i = static_cast<std::size_t>(stretch.from);
             i < placed_.size() && static_cast<double>(i) < stretch.to; ++i) {
            const GuidePiece& piece = placed_[i].piece;
            const double besideM = piece.lengthM - leftM * piece.turnRad;
            const bool isTight = std::abs(piece.turnRad) > kStraightRad &&
                                 besideM < kRadiusSlack * radiusM * std::abs(piece.turnRad);
            const double to = std::min(stretch.to, static_cast<double>(i + 1));
            if (isTight) {
                open = false;
            } else if (open) {
                kept.back().to = to;
            } else {
                kept.push_back({std::max(stretch.from, static_cast<double>(i)), to});
                open = true;
            }
        }
    }
    return kept;
}

void ParallelLines::append(GuideLine& line, Interval stretch, double leftM) const {
    if (line.pieces.empty()) {
        line.start = on(stretch.from, leftM);
    }
    for (auto i = static_cast<std::size_t>(stretch.from);
         i < placed_.size() && static_cast<double>(i) < stretch.to; ++i) {
        const double from = std::max(stretch.from, static_cast<double>(i));
        const double to = std::min(stretch.to, static_cast<double>(i + 1));
        const GuidePiece& piece = placed_[i].piece;
        const double share = to - from;
        const GuidePiece beside{.lengthM = share * (piece.lengthM - leftM * piece.turnRad),
                                .turnRad = share * piece.turnRad};
        if (beside.lengthM > 0.0 || std::abs(beside.turnRad) > kStraightRad) {
            line.pieces.push_back(beside);
        }
    }
}

std::vector<GuideLine> ParallelLines::at(double leftM, Length radius, Angle sharpest) const {
    const double side = std::signbit(leftM) ? -1.0 : 1.0;
    const double farM = leftM + side * radius.si();
    const std::vector<Interval> wide = freeStretches(farM);
    std::vector<GuideLine> lines;
    // The stretches that can be followed at the distance itself, for places that the disc does not reach.
    std::optional<std::vector<Interval>> near;
    const auto fill = [&](double from, double to, bool joinsBefore) {
        if (to - from < kLeastPlace) {
            return joinsBefore;
        }
        if (!near) {
            near = withoutTight(freeStretches(leftM), leftM, radius.si());
        }
        bool joinsAfter = false;
        for (const Interval& stretch : *near) {
            const Interval part{std::max(stretch.from, from), std::min(stretch.to, to)};
            if (part.to - part.from < kLeastPlace) {
                continue;
            }
            if (!(joinsBefore && part.from <= from)) {
                lines.emplace_back();
            }
            append(lines.back(), part, leftM);
            joinsAfter = part.to >= to;
        }
        return joinsAfter;
    };
    const auto end = static_cast<double>(placed_.size());
    bool open = fill(0.0, wide.empty() ? end : wide.front().from, false);
    for (std::size_t k = 0; k < wide.size(); ++k) {
        if (!open) {
            lines.emplace_back();
        }
        append(lines.back(), wide[k], leftM);
        open = true;
        if (k + 1 == wide.size()) {
            fill(wide[k].to, end, true);
            break;
        }
        const Pose before = on(wide[k].to, farM);
        const Pose after = on(wide[k + 1].from, farM);
        const double bendRad = wrappedAngle(after.heading - before.heading).si();
        const bool meet = distance(before.position, after.position) < kMeetingM;
        if (meet && side * bendRad >= 0.0 && std::abs(bendRad) <= sharpest.si()) {
            if (std::abs(bendRad) > kStraightRad) {
                lines.back().pieces.push_back(
                    {.lengthM = radius.si() * std::abs(bendRad), .turnRad = bendRad});
            }
        } else {
            open = fill(wide[k].to, wide[k + 1].from, true);
        }
    }
    std::erase_if(lines, [](const GuideLine& line) { return line.pieces.empty(); });
    return lines;
}

}  // namespace furrow
