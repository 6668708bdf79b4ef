#include "planner/headland/inner_passes.h"

#include "planner/geometry/boundary_distance.h"
#include "planner/geometry/curve_parts.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/corner_manoeuvres.h"
#include "planner/headland/smooth_ring.h"
#include "planner/turns/allowed_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace furrow {

namespace {

// Largest area that rounding may leave at one corner between two passes: a share of the square of the width,
// and never more than 10 m².
constexpr double kUncutShare = 0.1;
constexpr Area kMostUncut = squareMetres(10.0);
// Largest move of the line where corners are merged, as a share of the width.
constexpr double kMergeShare = 0.05;
constexpr double kInnerLookM = 0.1;
// Step to find the place where a pass enters another strip.
constexpr double kCutM = 0.5;
// Shorter parts, in widths, belong to the join with the pass around the corner.
constexpr double kLeastPart = 0.5;
// From the middle of a pass, as a share of its width.
constexpr double kAlmostHalfPass = 0.45;
// Stretches shorter than this share of the width are not worth lowering the implement for.
constexpr double kShortest = 0.2;
// Strips smaller than this share of the square of the width, or narrower than this, are left.
constexpr double kLeastStripShare = 0.3;
constexpr double kNarrowestStripM = 0.25;
constexpr int kMostParts = 64;
// Shorter sides give no direction for a strip.
constexpr double kShortestSideM = 1e-3;

/// The edges that passes may not cross, and the machine.
struct Room {
    Room(const PassTask& task)
        : machine{task.machine},
          working{task.drivable, task.machine, task.machine.workingFootprint(),
                  task.machine.workingFootprintWidth() + task.machine.spec().tractor.length} {}

    const Machine& machine;
    RigidRoom working;

    bool isFreeAt(const Pose& from, double aheadM) const {
        return working.isInside(
            {.position = from.position + aheadM * direction(from.heading.si()), .heading = from.heading});
    }

    /// The distance that the machine can drive on (back if the sign is -1), at most `wantedM`. A negative
    /// result, down to `leastM`, means that it has to stop before the given place.
    double farthest(const Pose& from, double sign, double wantedM, double leastM = 0.0) const {
        double best = std::min(0.0, wantedM);
        while (best > leastM && !isFreeAt(from, sign * best)) {
            best -= kInnerLookM;
        }
        for (double m = best + kInnerLookM; m <= wantedM + 1e-9 && isFreeAt(from, sign * m);
             m += kInnerLookM) {
            best = m;
        }
        return std::max(best, leastM);
    }
};

/// The line extended before its start and past its end. A negative length shortens it.
Curve extended(Curve line, double beforeM, double pastM) {
    const auto change = [](CurvePiece& piece, double by) {
        piece.length = metres(std::max(0.0, piece.length.si() + by));
    };
    const bool startsStraight = line.pieces.front().curvature == Curvature{};
    if (beforeM > 0.0 || startsStraight) {
        const double byM = std::max(beforeM, -line.pieces.front().length.si());
        line.start.position = line.start.position - byM * direction(line.start.heading.si());
        if (startsStraight) {
            change(line.pieces.front(), byM);
        } else {
            line.pieces.insert(line.pieces.begin(), {.length = metres(byM), .curvature = {}});
        }
    }
    if (line.pieces.back().curvature == Curvature{}) {
        change(line.pieces.back(), pastM);
    } else if (pastM > 0.0) {
        line.pieces.push_back({.length = metres(pastM), .curvature = {}});
    }
    std::erase_if(line.pieces, [](const CurvePiece& piece) { return piece.length <= metres(0.0); });
    return line;
}

double turnBetween(const Curve& before, const Curve& after) {
    const Point in = direction(before.end().heading.si());
    const Point out = direction(after.start.heading.si());
    return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

HeadlandPass passOf(std::vector<Curve> lines, bool closed, int ring, const Room& room) {
    HeadlandPass pass{
        .ring = ring, .width = room.machine.operatingWidth(), .closed = closed, .stretches = {}};
    const double widthM = pass.width.si();
    // The distance of the implement behind the vehicle's reference point.
    const double leadM = -room.machine.spec().implement.offset.si();
    const double noseM = (room.machine.spec().tractor.length - room.machine.spec().tractor.rearOverhang).si();
    // Outer rings run counter-clockwise. Their corners turn left except those that point into the field.
    const auto turnsInward = [](const std::vector<Curve>& all, std::size_t i) {
        const Curve& before = all[(i + all.size() - 1) % all.size()];
        const double turn = cross(direction(before.end().heading.si()), direction(all[i].start.heading.si()));
        return turn > 0.0;
    };
    const auto beyondM = [&](const Curve& before, const Curve& after) {
        return std::min(0.5 * widthM * std::tan(0.5 * turnBetween(before, after)),
                        kMostWidthsOnward * widthM);
    };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        Curve line = lines[i];
        if (!closed) {
            // The pass outside ends where its nose meets the edge. This pass also works the land that its
            // implement leaves there.
            const double fromEdgeM =
                ring * widthM < noseM + leadM && turnsInward(lines, i) ? ring * widthM : 0.0;
            const double backM =
                beyondM(lines[(i + lines.size() - 1) % lines.size()], line) + fromEdgeM - leadM;
            const double onM = beyondM(line, lines[(i + 1) % lines.size()]) + leadM;
            // The straights at both ends may shrink if the machine is longer than the room.
            const auto straightM = [](const CurvePiece& piece) {
                return piece.curvature == Curvature{} ? piece.length.si() : 0.0;
            };
            const double share = line.pieces.size() == 1 ? 0.5 : 1.0;
            // Beside the edge the machine reverses into its lane and needs its run-in again.
            const double runInM = room.machine.runIn().si();
            const double before =
                room.farthest(line.start, -1.0, backM + runInM, -share * straightM(line.pieces.front())) -
                runInM;
            const double past = room.farthest(line.end(), 1.0, onM, -share * straightM(line.pieces.back()));
            line = extended(std::move(line), before, past);
        }
        if (line.length().si() > kShortest * widthM) {
            pass.stretches.push_back({.line = std::move(line)});
        }
    }
    return pass;
}

/// The stretches of a line whose points belong, as from and to, each at least `least` long.
std::vector<std::pair<Length, Length>> belonging(const Curve& line, const std::function<bool(Point)>& belongs,
                                                 Length least) {
    std::vector<std::pair<Length, Length>> stretches;
    const Length whole = line.length();
    const int steps = std::max(1, static_cast<int>(std::ceil(whole.si() / kCutM)));
    bool inside = false;
    Pose begins = line.start;
    Length gone;
    std::size_t piece = 0;
    for (int i = 0; i <= steps; ++i) {
        const Length at = whole * (static_cast<double>(i) / steps);
        while (piece + 1 < line.pieces.size() && at - gone > line.pieces[piece].length) {
            begins = advanced(begins, line.pieces[piece], line.pieces[piece].length);
            gone += line.pieces[piece++].length;
        }
        const bool now = belongs(advanced(begins, line.pieces[piece], at - gone).position);
        if (now && !inside) {
            stretches.emplace_back(at, at);
        } else if (now) {
            stretches.back().second = at;
        }
        inside = now;
    }
    std::erase_if(stretches, [least](const auto& stretch) { return stretch.second - stretch.first < least; });
    return stretches;
}

/// Removes arcs at the ends that bend more than this: they lead round a corner that the part does not take.
Curve withoutBentEnds(Curve line, double sharpestPerM) {
    const auto isBent = [sharpestPerM](const CurvePiece& piece) {
        return std::abs(piece.curvature.si()) > sharpestPerM;
    };
    while (!line.pieces.empty() && isBent(line.pieces.back())) {
        line.pieces.pop_back();
    }
    while (!line.pieces.empty() && isBent(line.pieces.front())) {
        line.start = advanced(line.start, line.pieces.front(), line.pieces.front().length);
        line.pieces.erase(line.pieces.begin());
    }
    return line;
}

/// A rectangle around a ring.
struct Extent {
    Point origin;
    Point along;  ///< unit vector
    double fromM = 0.0;
    double toM = 0.0;
    double rightM = 0.0;
    double leftM = 0.0;

    double lengthM() const { return toM - fromM; }
    double widthM() const { return leftM - rightM; }
    Point at(double alongM, double asideM) const {
        return origin + alongM * along + asideM * Point{-along.y, along.x};
    }
};

Extent extentOf(const Ring& ring, Point along) {
    Extent extent{.origin = ring.front(), .along = along};
    for (const Point& point : ring) {
        const Point way = point - extent.origin;
        extent.fromM = std::min(extent.fromM, dot(along, way));
        extent.toM = std::max(extent.toM, dot(along, way));
        extent.rightM = std::min(extent.rightM, cross(along, way));
        extent.leftM = std::max(extent.leftM, cross(along, way));
    }
    return extent;
}

/// The narrowest rectangle around a ring. One of its sides lies along a side of the ring.
Extent narrowestExtent(const Ring& ring) {
    std::optional<Extent> narrowest;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point side = ring[(i + 1) % ring.size()] - ring[i];
        const double lengthM = norm(side);
        if (lengthM < kShortestSideM) {
            continue;
        }
        const Extent extent = extentOf(ring, (1.0 / lengthM) * side);
        if (!narrowest || extent.widthM() < narrowest->widthM()) {
            narrowest = extent;
        }
    }
    return narrowest.value_or(extentOf(ring, {1.0, 0.0}));
}

/// Cuts a strip into pieces that one straight pass can cover. A strip that bends is cut across in the middle.
Result<std::vector<Polygon>> straightParts(const Polygon& strip, double widthM, const JobContext& job) {
    std::vector<Polygon> open{strip};
    std::vector<Polygon> straight;
    while (!open.empty()) {
        Polygon part = std::move(open.back());
        open.pop_back();
        const Extent extent = narrowestExtent(part.outer);
        const double lengthM = extent.lengthM();
        if (extent.widthM() <= 1.05 * widthM || lengthM < 2.0 * widthM ||
            straight.size() + open.size() > static_cast<std::size_t>(kMostParts)) {
            straight.push_back(std::move(part));
            continue;
        }
        const double middleM = 0.5 * (extent.fromM + extent.toM);
        const double reachM = lengthM + extent.widthM();
        for (const double side : {-1.0, 1.0}) {
            const double farM = middleM + side * reachM;
            Ring half{extent.at(middleM, -2.0 * reachM), extent.at(farM, -2.0 * reachM),
                      extent.at(farM, 2.0 * reachM), extent.at(middleM, 2.0 * reachM)};
            if (side < 0.0) {
                std::ranges::reverse(half);
            }
            auto cut = intersection({part}, {{.outer = std::move(half), .holes = {}}}, job);
            if (!cut) {
                return std::unexpected(cut.error());
            }
            std::ranges::move(*cut, std::back_inserter(open));
        }
    }
    return straight;
}

/// The line along the middle of a straight strip.
Curve lineAlong(const Polygon& part) {
    const Extent extent = narrowestExtent(part.outer);
    const Point start = extent.at(extent.fromM, 0.5 * (extent.leftM + extent.rightM));
    const Point along = extent.along;
    return {.type = {},
            .start = {.position = start, .heading = radians(std::atan2(along.y, along.x))},
            .pieces = {{.length = metres(extent.lengthM()), .curvature = {}}}};
}

}  // namespace

std::vector<HeadlandPass> passesOn(const MultiPolygon& region, const PassTask& task, int ring,
                                   Length gentle) {
    const Room room{task};
    const Length width = task.machine.operatingWidth();
    const Area mostUncut = std::min(kMostUncut, squareMetres(kUncutShare * width.si() * width.si()));
    std::vector<HeadlandPass> passes;
    const auto add = [&](const Ring& each) {
        SmoothStretches smooth = smoothStretches(each, {.radius = task.machine.minTurningRadius(),
                                                        .tolerance = kMergeShare * width,
                                                        .gentle = gentle,
                                                        .width = width,
                                                        .mostUncut = mostUncut});
        if (!smooth.lines.empty()) {
            HeadlandPass pass = passOf(std::move(smooth.lines), smooth.closed, ring, room);
            if (!pass.stretches.empty()) {
                passes.push_back(std::move(pass));
            }
        }
    };
    for (const Polygon& polygon : region) {
        add(polygon.outer);
        std::ranges::for_each(polygon.holes, add);
    }
    return passes;
}

Result<std::vector<HeadlandPass>> innerPasses(const PassTask& task, Length inset, int ring,
                                              const JobContext& job) {
    return erodedSharp(task.workable, inset, job).transform([&](const MultiPolygon& region) {
        return passesOn(region, task, ring, {});
    });
}

std::vector<HeadlandPass> partsOf(const std::vector<HeadlandPass>& passes,
                                  const std::function<bool(Point)>& belongs,
                                  const std::function<bool(Point)>& isLeft, const PassTask& task) {
    const Room room{task};
    const double widthM = task.machine.operatingWidth().si();
    const double leadM = -task.machine.spec().implement.offset.si();
    const double runInM = task.machine.runIn().si();
    // The distance over which part of its width is still left to work.
    const auto leftM = [&](const Pose& from, double sign) {
        const Point ahead = direction(from.heading.si());
        const auto isLeftAt = [&](double m) {
            return std::ranges::any_of(std::array{-kAlmostHalfPass, 0.0, kAlmostHalfPass}, [&](double side) {
                return isLeft(from.position + sign * m * ahead + side * widthM * Point{-ahead.y, ahead.x});
            });
        };
        double m = 0.0;
        while (m < kMostWidthsOnward * widthM && isLeftAt(m + kInnerLookM)) {
            m += kInnerLookM;
        }
        return m;
    };
    const auto drawnOut = [&](Curve line) {
        const double leastM = -0.5 * line.length().si();
        const double backM =
            room.farthest(line.start, -1.0, leftM(line.start, -1.0) - leadM + runInM, leastM) - runInM;
        const double onM = room.farthest(line.end(), 1.0, leftM(line.end(), 1.0) + leadM, leastM);
        return extended(std::move(line), backM, onM);
    };
    std::vector<HeadlandPass> parts;
    for (const HeadlandPass& pass : passes) {
        bool isWhole = true;
        HeadlandPass part{.ring = pass.ring, .width = pass.width, .closed = false, .stretches = {}};
        for (const PassStretch& stretch : pass.stretches) {
            for (const auto& [from, to] :
                 belonging(stretch.line, belongs, kLeastPart * task.machine.operatingWidth())) {
                if (from <= Length{} && to >= stretch.line.length()) {
                    part.stretches.push_back(stretch);
                    continue;
                }
                isWhole = false;
                Curve piece = withoutBentEnds(partOf(stretch.line, from, to),
                                              0.5 / task.machine.minTurningRadius().si());
                if (piece.pieces.empty()) {
                    continue;
                }
                Curve drawn = drawnOut(std::move(piece));
                if (drawn.length().si() > kShortest * widthM) {
                    part.stretches.push_back({.line = std::move(drawn), .working = stretch.working});
                }
            }
            isWhole = isWhole && !part.stretches.empty();
        }
        part.closed = pass.closed && isWhole && part.stretches.size() == pass.stretches.size();
        if (!part.stretches.empty()) {
            parts.push_back(std::move(part));
        }
    }
    return parts;
}

Result<std::vector<HeadlandPass>> passesAlongStrips(const PassTask& task, Length inset, int ring,
                                                    const JobContext& job) {
    const Length width = task.machine.operatingWidth();
    const Length half = 0.5 * width;
    const auto inside = eroded(task.workable, inset, kArcTolerance, job);
    if (!inside) {
        return std::unexpected(inside.error());
    }
    // The area that the next pass covers if it drives into its corners. The opening uses slightly less than
    // half a width.
    const auto strips =
        erodedSharp(*inside, 0.999 * half, job)
            .and_then([&](const MultiPolygon& core) { return dilated(core, 1.5 * half, kArcTolerance, job); })
            .and_then([&](const MultiPolygon& covered) { return difference(*inside, covered, job); });
    if (!strips) {
        return std::unexpected(strips.error());
    }
    const Room room{task};
    const double leadM = -task.machine.spec().implement.offset.si();
    std::vector<HeadlandPass> passes;
    for (const Polygon& strip : *strips) {
        if (area(strip) < squareMetres(kLeastStripShare * width.si() * width.si())) {
            continue;
        }
        const auto parts = straightParts({.outer = strip.outer, .holes = {}}, width.si(), job);
        if (!parts) {
            return std::unexpected(parts.error());
        }
        for (const Polygon& part : *parts) {
            Curve line = lineAlong(part);
            if (area(part).si() < kNarrowestStripM * line.length().si() ||
                line.length() < kShortest * width) {
                continue;
            }
            // Only as far as the machine fits, from the middle outwards.
            const Pose middle = advanced(line.start, line.pieces.front(), 0.5 * line.length());
            if (!room.working.isInside(middle)) {
                continue;
            }
            const double halfM = 0.5 * line.length().si();
            const double onM = room.farthest(middle, 1.0, halfM + leadM);
            const double backM = room.farthest(middle, -1.0, std::max(0.0, halfM - leadM));
            line.start.position = middle.position - backM * direction(middle.heading.si());
            line.pieces.front().length = metres(backM + onM);
            if (line.length() > kShortest * width) {
                passes.push_back(
                    {.ring = ring, .width = width, .closed = false, .stretches = {{.line = line}}});
            }
        }
    }
    return passes;
}

}  // namespace furrow
