#include "planner/route/swath_detours.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/tolerances.h"
#include "planner/jobs/parallel.h"
#include "planner/route/line_frame.h"
#include "planner/route/route.h"
#include "planner/swaths/curved_swaths.h"
#include "planner/turns/dubins.h"
#include "planner/turns/rig.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace furrow {

namespace {

// Distance kept from an obstacle beyond the margin, for the errors of drawing and sampling a path.
constexpr double kReserveM = 0.05;
// Radii tried for leaving the track and coming back, as multiples of the smallest.
constexpr std::array kRadii{1.1, 1.5, 2.2, 3.2};
// Additions to the shift, for the swing of tail or nose.
constexpr std::array kMoreM{0.0, 0.1, 0.3, 0.7, 1.5};
// A curve longer than the straight by this factor turns round instead of changing over.
constexpr double kDetour = 1.6;
// A short straight between two arcs, so that rounding does not make them too near.
constexpr double kBetweenArcsM = 0.01;
// Largest area that may be left in one piece: less than a plan is blocked for. For a wide machine, an area
// that short passes work with less effort than a headland takes.
constexpr double kMostLeftM2 = 90.0;
constexpr double kMostLeftM = 14.0;  // for each metre of the operating width
constexpr std::size_t kMostTries = 120;

/// The extent of the machine from the middle of its implement, equal in both directions and to both sides.
struct MachineExtent {
    explicit MachineExtent(const Machine& machine) : halfLengthM{0.5 * machine.spec().implement.length.si()} {
        const Implement& implement = machine.spec().implement;
        for (const Point& corner : machine.workingFootprint()) {
            sideM = std::max(sideM, std::abs(corner.y - implement.lateralOffset.si()));
            endM = std::max(endM, std::abs(corner.x - implement.offset.si()));
        }
    }

    double sideM = 0.0;
    double endM = 0.0;
    double halfLengthM = 0.0;
};

/// A stretch of a line, and the line driven instead. At an end of the swath, the detour begins or ends beside
/// it.
struct Detour {
    double fromM = 0.0;
    double toM = 0.0;
    Curve line;
};

/// The dimensions of a detour past an obstacle.
struct Shape {
    double shiftM = 0.0;  ///< to the left
    double fromM = 0.0;   ///< full shift from here
    double toM = 0.0;
    double radiusM = 0.0;
    double changeM = 0.0;  ///< length along the line for changing over
    double leftM2 = 0.0;   ///< approximate unworked area
};

void append(Curve& line, const Curve& more) {
    if (line.pieces.empty()) {
        line.start = more.start;
    }
    line.pieces.insert(line.pieces.end(), more.pieces.begin(), more.pieces.end());
}

Curve part(const Curve& line, double fromM, double toM) {
    return partOf(line, metres(fromM), metres(toM));
}

Curve moved(const Curve& line, double leftM) {
    return movedLeft(line, metres(leftM));
}

/// One line, and ways round obstacles beside it.
class DetouredLine {
public:
    DetouredLine(const Swath& swath, const Rig& lowered, const DetourTask& task, const MachineExtent& extent)
        : swath_{swath},
          line_{lineOf(swath)},
          lengthM_{line_.length().si()},
          lowered_{lowered},
          task_{task},
          extent_{extent},
          clearM_{extent.sideM + task.margin.si() + kReserveM},
          mostLeftM2_{std::max(kMostLeftM2, kMostLeftM * swath.width.si())} {}

    /// The obstacles that the line touches, in their order along it.
    std::vector<std::size_t> touched() {
        const LineFrame beside{line_};
        std::vector<std::size_t> met;
        const double sideM = extent_.sideM + task_.margin.si() - kContactM;
        for (const Ring& obstacle : task_.obstacles) {
            extents_.push_back(beside.of(obstacle));
            const Extent& extent = extents_.back();
            if (extent.toM < -extent_.endM || extent.fromM > lengthM_ + extent_.endM) {
                continue;
            }
            const bool isInWay = extent.rightM < sideM && extent.leftM > -sideM;
            // In bends the machine takes more room than its width.
            const bool isNear = sharpestBend(line_) > Curvature{} && extent.rightM < sideM + extent_.endM &&
                                extent.leftM > -sideM - extent_.endM;
            if (isInWay || (isNear && !isClear(around(extent)))) {
                met.push_back(extents_.size() - 1);
            }
        }
        std::ranges::sort(met, {}, [&](std::size_t i) { return extents_[i].fromM; });
        return met;
    }

    /// A detour past all these obstacles at once. If others beside it are in the way, past those as well.
    std::optional<Detour> past(const std::vector<std::size_t>& obstacles) const {
        Extent all = extents_[obstacles.front()];
        for (const std::size_t i : obstacles) {
            all.add(extents_[i]);
        }
        if (auto detour = firstClear({shapesPast(all, Side::Left), shapesPast(all, Side::Right)})) {
            return detour;
        }
        const Extent left = withNeighbours(all, Side::Left);
        const Extent right = withNeighbours(all, Side::Right);
        return firstClear({left == all ? std::vector<Shape>{} : shapesPast(left, Side::Left),
                           right == all ? std::vector<Shape>{} : shapesPast(right, Side::Right)});
    }

    /// The line with these detours in place of the stretches that they replace.
    Curve with(const std::vector<Detour>& detours) const {
        Curve line{.type = line_.type, .start = {}, .pieces = {}};
        double atM = 0.0;
        for (const Detour& detour : detours) {
            append(line, part(line_, atM, detour.fromM));
            append(line, detour.line);
            atM = detour.toM;
        }
        append(line, part(line_, atM, lengthM_));
        return line;
    }

    /// Whether tractor and implement stay inside in both directions of driving.
    bool isClear(const Curve& line) const {
        if (line.pieces.empty()) {
            return true;
        }
        SwathSet one;
        one.swaths = {swath_};
        one.swaths.front().curve = line;
        one.swaths.front().start = line.start.position;
        one.swaths.front().end = line.end().position;
        return std::ranges::all_of(std::array{false, true}, [&](bool reversed) {
            const Curve driven = drivenLine({.swath = 0, .reversed = reversed}, one, task_.machine);
            return lowered_.driven(Rig::inLine(driven.start), driven).has_value();
        });
    }

private:
    /// The part of the line beside an extent, with the length of the machine before and after.
    Curve around(const Extent& extent) const {
        return part(line_, std::max(0.0, extent.fromM - 2.0 * extent_.endM),
                    std::min(lengthM_, extent.toM + 2.0 * extent_.endM));
    }

    /// The detour with the line before and after it, until a trailed implement is in line again in both
    /// directions.
    Curve withLine(const Detour& detour) const {
        Curve line = part(line_, std::max(0.0, detour.fromM - 3.0 * extent_.endM), detour.fromM);
        append(line, detour.line);
        append(line, part(line_, detour.toM, std::min(lengthM_, detour.toM + 3.0 * extent_.endM)));
        return line;
    }

    enum class Side { Left, Right };

    /// The shift to the left that passes an extent on that side.
    double shiftPast(const Extent& extent, Side side) const {
        return side == Side::Left ? extent.leftM + clearM_ : extent.rightM - clearM_;
    }

    Shape shapePast(const Extent& extent, double shiftM, double aheadM, double radiusM) const {
        const double asideM = std::abs(shiftM);
        Shape shape{.shiftM = shiftM,
                    .fromM = extent.fromM - aheadM,
                    .toM = extent.toM + aheadM,
                    // Up to 60 degrees from the line.
                    .radiusM = std::max(radiusM, asideM)};
        shape.changeM = std::sqrt(4.0 * shape.radiusM * asideM - asideM * asideM) + kBetweenArcsM;
        shape.leftM2 = asideM * (std::min(shape.toM, lengthM_) - std::max(shape.fromM, 0.0) + shape.changeM);
        return shape;
    }

    /// All possible shapes on one side.
    std::vector<Shape> shapesPast(const Extent& extent, Side side) const {
        const double leastM = swathRadius(task_.machine).si();
        const double endM = extent_.endM;
        const std::array aheads{
            extent_.halfLengthM,  0.5 * (extent_.halfLengthM + endM), endM, endM + 0.5 * extent_.sideM,
            endM + extent_.sideM, 2.0 * endM + extent_.sideM};
        const double shiftM = shiftPast(extent, side);
        std::vector<Shape> shapes;
        for (const double aheadM : aheads) {
            for (const double radii : kRadii) {
                for (const double moreM : kMoreM) {
                    const Shape shape =
                        shapePast(extent, shiftM + std::copysign(moreM, shiftM), aheadM, radii * leastM);
                    if (shape.leftM2 <= mostLeftM2_) {
                        shapes.push_back(shape);
                    }
                }
            }
        }
        return shapes;
    }

    /// The first clear detour, in order of the area that it leaves.
    std::optional<Detour> firstClear(std::array<std::vector<Shape>, 2> sides) const {
        std::vector<Shape> shapes = std::move(sides[0]);
        shapes.insert(shapes.end(), sides[1].begin(), sides[1].end());
        std::ranges::stable_sort(shapes, {}, &Shape::leftM2);
        shapes.resize(std::min(shapes.size(), kMostTries));
        for (const Shape& shape : shapes) {
            auto detour = driven(shape);
            if (detour && isClear(withLine(*detour))) {
                return detour;
            }
        }
        return std::nullopt;
    }

    /// The extent with all obstacles that are in the way of passing it on that side.
    Extent withNeighbours(Extent extent, Side side) const {
        const double leastM = kRadii.front() * swathRadius(task_.machine).si();
        for (bool grows = true; grows;) {
            grows = false;
            const Shape shape = shapePast(extent, shiftPast(extent, side), extent_.endM, leastM);
            for (const Extent& other : extents_) {
                const bool isAlong =
                    other.toM > shape.fromM - shape.changeM && other.fromM < shape.toM + shape.changeM;
                const bool isInWay =
                    other.rightM < shape.shiftM + clearM_ && other.leftM > shape.shiftM - clearM_;
                Extent both = extent;
                both.add(other);
                if (isAlong && isInWay && both != extent && shape.leftM2 < mostLeftM2_) {
                    extent = both;
                    grows = true;
                    break;
                }
            }
        }
        return extent;
    }

    Pose poseAt(double alongM, double leftM) const {
        const Curve rest = part(line_, alongM, lengthM_);
        Pose pose = rest.pieces.empty() ? line_.end() : rest.start;
        const Point ahead = direction(pose.heading.si());
        pose.position = pose.position + leftM * Point{-ahead.y, ahead.x};
        return pose;
    }

    /// The curve from one place beside the line to another that is farther on.
    std::optional<Curve> change(double fromM, double fromLeftM, double toM, double toLeftM,
                                double radiusM) const {
        Curve turn = dubinsTurn(poseAt(fromM, fromLeftM), poseAt(toM, toLeftM), metres(radiusM));
        if (turn.length().si() > kDetour * (toM - fromM)) {
            return std::nullopt;
        }
        return turn;
    }

    std::optional<Detour> driven(const Shape& shape) const {
        Detour detour{.fromM = shape.fromM - shape.changeM, .toM = shape.toM + shape.changeM, .line = {}};
        const bool beginsBeside = detour.fromM < 0.0;
        const bool endsBeside = detour.toM > lengthM_;
        if ((beginsBeside || endsBeside) && swath_.isClosed()) {
            return std::nullopt;
        }
        detour.fromM = std::max(detour.fromM, 0.0);
        detour.toM = std::min(detour.toM, lengthM_);
        const double plateauFromM = beginsBeside ? 0.0 : shape.fromM;
        const double plateauToM = endsBeside ? lengthM_ : shape.toM;
        if (!beginsBeside) {
            const auto out = change(detour.fromM, 0.0, plateauFromM, shape.shiftM, shape.radiusM);
            if (!out) {
                return std::nullopt;
            }
            append(detour.line, *out);
        }
        const Curve beside = part(line_, plateauFromM, plateauToM);
        for (const CurvePiece& piece : beside.pieces) {
            // No shift to the inner side of a bend that it would make too sharp.
            const double radiusM = piece.curvature == Curvature{} ? std::numeric_limits<double>::infinity()
                                                                  : 1.0 / piece.curvature.si();
            if (radiusM * shape.shiftM > 0.0 &&
                std::abs(radiusM) - std::abs(shape.shiftM) < swathRadius(task_.machine).si()) {
                return std::nullopt;
            }
        }
        append(detour.line, moved(beside, shape.shiftM));
        if (!endsBeside) {
            const auto back = change(plateauToM, shape.shiftM, detour.toM, 0.0, shape.radiusM);
            if (!back) {
                return std::nullopt;
            }
            append(detour.line, *back);
        }
        return detour;
    }

    const Swath& swath_;
    Curve line_;
    double lengthM_;
    const Rig& lowered_;
    const DetourTask& task_;
    const MachineExtent& extent_;
    double clearM_;
    double mostLeftM2_;
    std::vector<Extent> extents_;
};

/// The changed line, or the obstacles that it does not get round.
struct DetouredSwath {
    Curve line;
    std::vector<std::size_t> refused;
};

DetouredSwath detoured(const Swath& swath, const Rig& lowered, const DetourTask& task,
                       const MachineExtent& extent) {
    DetouredLine line{swath, lowered, task, extent};
    DetouredSwath result;
    struct Passed {
        std::vector<std::size_t> obstacles;
        Detour detour;
    };
    std::vector<Passed> all;
    const std::vector<std::size_t> touched = line.touched();
    for (const std::size_t obstacle : touched) {
        std::vector<std::size_t> group{obstacle};
        auto detour = line.past(group);
        // Too close to the detour before: one detour for both.
        while (detour && !all.empty() && all.back().detour.toM > detour->fromM) {
            group.insert(group.begin(), all.back().obstacles.begin(), all.back().obstacles.end());
            all.pop_back();
            detour = line.past(group);
        }
        if (detour) {
            all.push_back({std::move(group), std::move(*detour)});
        } else {
            result.refused.insert(result.refused.end(), group.begin(), group.end());
        }
    }
    if (all.empty()) {
        return result;
    }
    std::vector<Detour> detours;
    for (Passed& passed : all) {
        detours.push_back(std::move(passed.detour));
    }
    result.line = line.with(detours);
    // Between two detours a trailed implement may not be in line yet.
    if (result.refused.empty() && detours.size() > 1 &&
        !line.isClear(part(result.line, detours.front().fromM, result.line.length().si()))) {
        result.refused = touched;
    }
    return result;
}

}  // namespace

Result<std::vector<std::size_t>> addDetours(SwathSet& set, const DetourTask& task, const JobContext& job) {
    std::vector<std::size_t> refused;
    if (task.obstacles.empty()) {
        return refused;
    }
    const Rig lowered{task.drivable, task.machine, ImplementAt::Lowered};
    const MachineExtent extent{task.machine};
    const auto lines = parallelMap<DetouredSwath>(
        set.swaths.size(), [&](std::size_t i) { return detoured(set.swaths[i], lowered, task, extent); },
        job);
    if (!lines) {
        return std::unexpected(lines.error());
    }
    for (std::size_t i = 0; i < lines->size(); ++i) {
        const DetouredSwath& line = (*lines)[i];
        refused.insert(refused.end(), line.refused.begin(), line.refused.end());
        if (line.line.pieces.empty() || !line.refused.empty()) {
            continue;
        }
        Swath& swath = set.swaths[i];
        const bool isClosed = swath.isClosed();
        set.totalLength += line.line.length() - swath.length();
        swath.curve = line.line;
        swath.start = line.line.start.position;
        swath.end = isClosed ? swath.start : line.line.end().position;
        swath.goesRound = true;
    }
    std::ranges::sort(refused);
    refused.erase(std::ranges::unique(refused).begin(), refused.end());
    return refused;
}

}  // namespace furrow
