#include "planner/audit/swept_area.h"

#include "planner/audit/depth_sweep.h"
#include "planner/audit/length.h"
#include "planner/audit/working_room.h"
#include "planner/geometry/geos_bridge.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

constexpr Length kHairWidth = metres(0.1);
// A smaller piece stays one, hairs and all: no single pass is sent to its parts.
constexpr Area kWorthSplitting = squareMetres(5.0);
// Grids on which plans that differ elsewhere leave the same pieces of land, to the last bit. What was found
// for a piece then serves all of them.
constexpr double kPieceGridM = 1e-5;
constexpr double kDirectionGridRad = 1e-12;

struct WorkingLine {
    Point right;
    Point left;
};

WorkingLine workingLine(const MotionState& state, double widthM) {
    const Point left = 0.5 * widthM * Point{-state.implementNose.y, state.implementNose.x};
    return {.right = state.implement - left, .left = state.implement + left};
}

Ring counterClockwise(Ring ring) {
    if (signedAreaM2(ring) < 0.0) {
        std::ranges::reverse(ring);
    }
    return ring;
}

/// The point of the line itself about which it turns between two places. Empty if there is none.
std::optional<Point> pivotOf(const WorkingLine& a, const WorkingLine& b) {
    const Point across = a.left - a.right;
    const Point acrossNext = b.left - b.right;
    const double turn = cross(across, acrossNext);
    if (turn == 0.0) {
        return std::nullopt;
    }
    const double t = cross(b.right - a.right, acrossNext) / turn;
    const double u = cross(b.right - a.right, across) / turn;
    return t > 0.0 && t < 1.0 && u > 0.0 && u < 1.0 ? std::optional{a.right + t * across} : std::nullopt;
}

/// The area that a line sweeps between two places: a quadrilateral, or two triangles if it turns about a
/// point of its own or is folded over.
std::vector<Ring> sweptBetween(const WorkingLine& a, const WorkingLine& b,
                               const std::optional<Point>& pivot) {
    constexpr double kNoAreaM2 = 1e-12;
    std::vector<Ring> swept;
    const auto add = [&](Ring ring) {
        if (std::abs(signedAreaM2(ring)) > kNoAreaM2) {
            swept.push_back(counterClockwise(std::move(ring)));
        }
    };
    const double right = cross(b.right - a.right, b.left - a.right);
    const double left = cross(b.left - a.right, a.left - a.right);
    if (pivot) {
        add({*pivot, a.right, b.right});
        add({*pivot, a.left, b.left});
    } else if (right * left >= 0.0) {
        add({a.right, b.right, b.left, a.left});
    } else {
        add({a.right, b.right, b.left});
        add({a.right, b.left, a.left});
    }
    return swept;
}

/// The same for many steps in a row, for layers of polygons. While a line turns about points of its own, the
/// triangles on either side form fans. Only the outlines of the fans are added, with some hundred times fewer
/// long edges.
class FanOutlines {
public:
    FanOutlines(LayeredPolygons& layers, std::size_t layer) : layers_{layers}, layer_{layer} {}
    ~FanOutlines() { close(); }
    FanOutlines(const FanOutlines&) = delete;
    FanOutlines& operator=(const FanOutlines&) = delete;

    void add(const WorkingLine& a, const WorkingLine& b) {
        const std::optional<Point> pivot = pivotOf(a, b);
        if (!pivot) {
            close();
            for (const Ring& ring : sweptBetween(a, b, pivot)) {
                layers_.addNext(layer_, ring);
            }
            return;
        }
        const bool turnsLeft = cross(a.left - a.right, b.left - b.right) > 0.0;
        if (turnsLeft != turnsLeft_) {
            close();
        }
        turnsLeft_ = turnsLeft;
        if (pivots_.empty()) {
            right_ = {a.right};
            left_ = {a.left};
        }
        pivots_.push_back(*pivot);
        right_.push_back(b.right);
        left_.push_back(b.left);
    }

private:
    // The sum of the triangles (pivot, end, next end). Sides that are driven in both directions cancel out.
    void close() {
        if (pivots_.empty()) {
            return;
        }
        for (Ring* ring : {&right_, &left_}) {
            ring->insert(ring->end(), pivots_.rbegin(), pivots_.rend());
            if (!turnsLeft_) {
                std::ranges::reverse(*ring);
            }
            layers_.add(layer_, *ring);
        }
        pivots_.clear();
    }

    LayeredPolygons& layers_;
    std::size_t layer_;
    bool turnsLeft_ = true;
    Ring right_;
    Ring left_;
    std::vector<Point> pivots_;
};

/// Error of the chords of a turning line's ends: two thirds of the sagitta, on both sides.
double chordErrorM2(const SegmentMotion& motion, double widthM) {
    double sum = 0.0;
    for (std::size_t i = 1; i < motion.states.size(); ++i) {
        const MotionState& a = motion.states[i - 1];
        const MotionState& b = motion.states[i];
        const double turn =
            std::abs(std::remainder(b.implementHeadingRad - a.implementHeadingRad, 2.0 * std::numbers::pi));
        const WorkingLine from = workingLine(a, widthM);
        const WorkingLine to = workingLine(b, widthM);
        for (const double chord : {lengthOf(to.left - from.left), lengthOf(to.right - from.right)}) {
            sum += 2.0 / 3.0 * chord * std::min(chord * turn / 8.0, kChordErrorM);
        }
    }
    return sum;
}

enum SweptLayer : std::size_t {
    kWorkable,
    kReach,
    kMainland,
    kLaneEnd,
    kSwath,
    kHeadlandPass,
    kWithinMargin,
    kOnPurpose
};

enum Region : std::size_t {
    kCovered,
    kTwice,
    kTwiceHeadland,
    kMissed,
    kReachable,
    kCoveredReachable,
    kDropped,
    kStrip,
    kEnds,
    kGivenAway,
    kBeyond,
    kRegionCount
};

constexpr std::uint32_t bit(Region region) {
    return 1U << region;
}

std::uint32_t regionsAt(const Depths& depths) {
    const std::int32_t passes = depths[kSwath] + depths[kHeadlandPass];
    const bool onPurpose = depths[kOnPurpose] > 0;
    if (depths[kWorkable] <= 0) {
        return onPurpose && passes == 0 ? bit(kGivenAway) : 0;
    }
    const bool givenAway = onPurpose || depths[kWithinMargin] <= 0;
    const bool reach = depths[kReach] > 0 && !givenAway;
    if (passes > 0) {
        return bit(kCovered) | (passes > 1 ? bit(kTwice) : 0) |
               (depths[kSwath] > 0 && depths[kHeadlandPass] > 0 ? bit(kTwiceHeadland) : 0) |
               (reach ? bit(kReachable) | bit(kCoveredReachable) : 0);
    }
    if (givenAway) {
        return bit(kGivenAway);
    }
    const std::uint32_t missed = bit(kMissed) | (reach ? bit(kReachable) : 0);
    if (depths[kMainland] <= 0) {
        return missed | bit(kStrip);
    }
    return !reach ? missed | bit(kBeyond) : missed | (depths[kLaneEnd] > 0 ? bit(kEnds) : bit(kDropped));
}

/// The lanes beyond the ends of the swaths, and before them by the distance of the implement from the axle.
/// If the strip beside them is kept for turning, they are worked together with it.
void addLaneEnds(const AuditInput& input, const MachineShape& shape, LayeredPolygons& layers) {
    constexpr double kSlackM = 2.0 * kChordErrorM;
    const double before = std::abs(shape.implementOffsetM) + kSlackM;
    const auto addEnd = [&](Point end, Point next, double width) {
        const Point along = (1.0 / std::max(distance(end, next), 1e-9)) * (next - end);
        const Point side = (0.5 * width + kSlackM) * Point{-along.y, along.x};
        const Point far = end - 2.0 * width * along;
        const Point near = end + std::min(before, distance(end, next)) * along;
        layers.add(kLaneEnd, Ring{far - side, near - side, near + side, far + side});
    };
    for (const PlannedPass& pass : input.passes) {
        addEnd(pass.line.front(), pass.line[1], pass.width.si());
        addEnd(pass.line.back(), pass.line[pass.line.size() - 2], pass.width.si());
    }
}

/// A ring around everything.
Ring everywhere(const AuditInput& input) {
    const Bounds box = bounds(input.workable);
    return {box.min - Point{1.0, 1.0},
            {box.max.x + 1.0, box.min.y - 1.0},
            box.max + Point{1.0, 1.0},
            {box.min.x - 1.0, box.max.y + 1.0}};
}

/// Adds the swept area, with its error bound.
void addPasses(const AuditInput& input, const MachineShape& shape, const std::vector<SegmentMotion>& motions,
               LayeredPolygons& layers, SweptArea& result) {
    const double widthM = shape.operatingWidthM;
    double errorM2 = 1e-9 * area(input.workable).si();
    double lengthM = 0.0;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        if (!input.segments[i].implementDown) {
            continue;
        }
        const std::vector<MotionState>& states = motions[i].states;
        errorM2 += chordErrorM2(motions[i], widthM);
        FanOutlines outlines{layers,
                             input.segments[i].kind == SegmentKind::HeadlandPass ? kHeadlandPass : kSwath};
        for (std::size_t k = 1; k < states.size(); ++k) {
            const WorkingLine from = workingLine(states[k - 1], widthM);
            const WorkingLine to = workingLine(states[k], widthM);
            outlines.add(from, to);
            for (Ring& ring : sweptBetween(from, to, pivotOf(from, to))) {
                result.pieces.push_back({std::move(ring), i});
            }
            lengthM += lengthOf(states[k].implement - states[k - 1].implement);
        }
    }
    // A rounded coordinate moves both sides of a pass.
    result.error = squareMetres(errorM2 + 2.0 * lengthM * input.positionRounding.si());
}

/// Pieces joined by less than a hand's width are separate. Strips of millimetres along the boundary join the
/// corners that a pass leaves. They can also be as wide as the distance that the vehicle keeps the implement
/// away from the boundary.
Length hairWidth(const AuditInput& input) {
    return kHairWidth +
           (input.machine ? 0.5 * (input.machine->workingFootprintWidth() - input.machine->operatingWidth())
                          : Length{});
}

double onGrid(double value, double step) {
    return step * std::round(value / step);
}

Ring onGrid(const Ring& ring) {
    Ring rounded;
    for (const Point& point : ring) {
        const Point there{onGrid(point.x, kPieceGridM), onGrid(point.y, kPieceGridM)};
        if (rounded.empty() || rounded.back() != there) {
            rounded.push_back(there);
        }
    }
    while (rounded.size() > 1 && rounded.back() == rounded.front()) {
        rounded.pop_back();
    }
    return rounded;
}

/// Pieces on the grid, where that leaves them valid.
Result<MultiPolygon> onGrid(MultiPolygon pieces, const JobContext& job) {
    for (Polygon& piece : pieces) {
        Polygon rounded{.outer = onGrid(piece.outer), .holes = {}};
        std::ranges::transform(piece.holes, std::back_inserter(rounded.holes),
                               [](const Ring& hole) { return onGrid(hole); });
        std::erase_if(rounded.holes, [](const Ring& hole) { return hole.size() < 3; });
        if (rounded.outer.size() < 3) {
            continue;
        }
        const auto invalid = findInvalidPlace({rounded}, job);
        if (!invalid) {
            return std::unexpected(invalid.error());
        }
        if (!*invalid) {
            piece = std::move(rounded);
        }
    }
    return pieces;
}

Result<MultiPolygon> withoutHairs(MultiPolygon pieces, Length hair, KnownPieces& known,
                                  const JobContext& job) {
    MultiPolygon kept;
    for (Polygon& piece : pieces) {
        if (area(piece) < kWorthSplitting) {
            kept.push_back(std::move(piece));
            continue;
        }
        auto parts = known.get(piece, [&](const Polygon& whole) {
            return eroded({whole}, 0.5 * hair, kArcTolerance, job).and_then([&](const MultiPolygon& cores) {
                return dilated(cores, 0.5 * hair, kArcTolerance, job);
            });
        });
        if (!parts) {
            return parts;
        }
        std::ranges::move(*parts, std::back_inserter(kept));
    }
    std::ranges::stable_sort(kept, std::ranges::greater{}, [](const Polygon& piece) { return area(piece); });
    return kept;
}

bool liesIn(const Polygon& part, const Polygon& whole) {
    const Bounds inner = bounds(part);
    const Bounds outer = bounds(whole);
    return contains(outer, inner.min) && contains(outer, inner.max);
}

/// If too much was dropped, keeps only the parts with room for the machine to work. A trailed implement can
/// work from more than a straight line, and is judged by its disc only.
Result<void> keepWithRoom(const AuditInput& input, const AuditedLand& land, const JobContext& job,
                          SweptArea& swept) {
    const bool tooMuch =
        swept.droppedArea > kMissedShare * area(input.workable) ||
        std::ranges::any_of(swept.dropped, [](const Polygon& piece) { return area(piece) > kMissedPiece; });
    if (!land.room || !tooMuch) {
        return {};
    }
    auto kept =
        partsWithRoom(swept.dropped, *land.room, input.machine->operatingWidth(), job, land.withRoom.get());
    if (!kept) {
        return std::unexpected(kept.error());
    }
    const Area noRoom = area(swept.dropped) - area(*kept);
    swept.droppedArea = swept.droppedArea - noRoom;
    swept.beyondReachArea += noRoom;
    // A large piece that was taken out is reported at its place.
    for (const Polygon& piece : swept.dropped) {
        if (area(piece) > kMissedPiece &&
            std::ranges::none_of(*kept, [&](const Polygon& left) { return liesIn(left, piece); })) {
            swept.beyondReach.push_back(piece);
        }
    }
    std::ranges::stable_sort(swept.beyondReach, std::ranges::greater{},
                             [](const Polygon& piece) { return area(piece); });
    swept.dropped = std::move(*kept);
    return {};
}

}  // namespace

Point mainDirection(const std::vector<SegmentMotion>& motions) {
    double longest = 0.0;
    Point along{1.0, 0.0};
    for (const SegmentMotion& motion : motions) {
        for (std::size_t i = 1; i < motion.states.size(); ++i) {
            const Point way = motion.states[i].implement - motion.states[i - 1].implement;
            if (dot(way, way) > longest * longest) {
                longest = lengthOf(way);
                along = (1.0 / longest) * way;
            }
        }
    }
    // Which way round it is driven, and its rounding, make no difference.
    const double turned = onGrid(std::atan2(along.y, along.x), kDirectionGridRad);
    const Point rounded{std::cos(turned), std::sin(turned)};
    return rounded.y < 0.0 || (rounded.y == 0.0 && rounded.x < 0.0) ? -1.0 * rounded : rounded;
}

Result<SweptArea> measureSweptArea(const AuditInput& input, const AuditedLand& land,
                                   const MachineShape& shape, const std::vector<SegmentMotion>& motions,
                                   const JobContext& job) {
    SweptArea result;
    LayeredPolygons layers;
    layers.add(kWorkable, input.workable);
    addPasses(input, shape, motions, layers, result);
    layers.add(kWithinMargin, input.margin > Length{}
                                  ? land.withinMargin
                                  : MultiPolygon{{.outer = everywhere(input), .holes = {}}});
    layers.add(kOnPurpose, input.leftOnPurpose);
    if (land.reach) {
        layers.add(kReach, *land.reach);
    } else {
        layers.add(kReach, everywhere(input));
    }
    if (input.mainland) {
        layers.add(kMainland, *input.mainland);
        addLaneEnds(input, shape, layers);
    } else {
        layers.add(kMainland, everywhere(input));
    }
    auto measured =
        measureRegions(layers, mainDirection(motions),
                       {.at = regionsAt,
                        .count = kRegionCount,
                        .traced = bit(kMissed) | bit(kDropped) | bit(kStrip) | bit(kTwice) | bit(kBeyond)},
                       job);
    if (!measured) {
        return std::unexpected(measured.error());
    }
    std::vector<MeasuredRegion>& regions = *measured;
    result.covered = regions[kCovered].area;
    result.overlap = regions[kTwice].area;
    result.overlapAreas = std::move(regions[kTwice].polygons);
    result.overlapHeadland = regions[kTwiceHeadland].area;
    result.missedArea = regions[kMissed].area;
    result.missed = std::move(regions[kMissed].polygons);
    if (const Area all = regions[kReachable].area; input.machine && all > squareMetres(0.0)) {
        result.coveredOfReachable = std::clamp(regions[kCoveredReachable].area / all, 0.0, 1.0);
    }
    result.droppedArea = regions[kDropped].area;
    result.beyondReachArea = regions[kBeyond].area;
    result.beyondReach = std::move(regions[kBeyond].polygons);
    auto pieces = onGrid(std::move(regions[kDropped].polygons), job).and_then([&](MultiPolygon&& dropped) {
        return withoutHairs(std::move(dropped), hairWidth(input), *land.withoutHairs, job);
    });
    if (!pieces) {
        return std::unexpected(pieces.error());
    }
    result.dropped = std::move(*pieces);
    if (auto kept = keepWithRoom(input, land, job, result); !kept) {
        return std::unexpected(kept.error());
    }
    result.stripArea = regions[kStrip].area;
    result.strip = std::move(regions[kStrip].polygons);
    result.laneEnds = regions[kEnds].area;
    result.leftOnPurpose = regions[kGivenAway].area;
    return result;
}

}  // namespace furrow
