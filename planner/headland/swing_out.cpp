#include "planner/headland/swing_out.h"

#include "planner/geometry/segment.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace furrow {

namespace {

// Corners with gentler rounding or smaller turns lose little.
constexpr double kTightRadii = 1.5;
constexpr double kLeastTurnRad = 0.3;
// Beyond this the two sides hardly meet.
constexpr double kMostTurnRad = 2.6;
// Angles by which the tractor turns too far, the largest first.
constexpr std::array kSwingsDeg{45.0, 35.0, 28.0, 20.0, 12.0};
constexpr Length kLookStep = metres(0.3);
// After the corner the implement comes into line within 3 of its own lengths.
constexpr double kLengthsAfter = 3.0;
constexpr double kLeastStraightM = 0.01;
// A straight longer than 1.5 radii separates two corners.
constexpr double kLongRadii = 1.5;

bool isStraight(const CurvePiece& piece) {
    return piece.curvature == Curvature{} && piece.endCurvature == Curvature{};
}

/// Bends in the same direction with little between them, from one straight to another, mirrored to turn left.
struct SwingCorner {
    std::size_t last = 0;  ///< piece
    double turnRad = 0.0;
    double side = 1.0;    ///< 1 to the left
    double entryM = 0.0;  ///< from the start of the bends to the meeting point of the two sides
    double exitM = 0.0;   ///< from there to their end
};

/// The corner that begins after a straight. Empty if it is not worth a swing.
std::optional<SwingCorner> cornerAfter(const std::vector<CurvePiece>& pieces, std::size_t straight,
                                       const Pose& begins, double radiusM) {
    SwingCorner corner;
    double turnRad = 0.0;
    double lengthM = 0.0;
    double arcsM = 0.0;
    bool isTight = false;
    std::size_t i = straight + 1;
    for (; i < pieces.size(); ++i) {
        const CurvePiece& piece = pieces[i];
        if (isStraight(piece)) {
            if (piece.length.si() > kLongRadii * radiusM) {
                break;
            }
        } else if (piece.curvature != piece.endCurvature || turnRad * piece.curvature.si() < 0.0) {
            break;
        } else {
            turnRad += piece.length.si() * piece.curvature.si();
            corner.last = i;
            arcsM += piece.length.si();
            isTight = isTight || std::abs(piece.curvature.si()) * kTightRadii * radiusM > 1.0;
        }
        lengthM += piece.length.si();
    }
    corner.turnRad = std::abs(turnRad);
    corner.side = turnRad > 0.0 ? 1.0 : -1.0;
    const bool wide = lengthM > 2.0 * arcsM + kLongRadii * radiusM;
    if (!isTight || wide || corner.turnRad < kLeastTurnRad || corner.turnRad > kMostTurnRad ||
        corner.last + 1 >= pieces.size() || !isStraight(pieces[corner.last + 1])) {
        return std::nullopt;
    }
    Pose ends = begins;
    for (std::size_t k = straight + 1; k <= corner.last; ++k) {
        ends = advanced(ends, pieces[k], pieces[k].length);
    }
    std::tie(corner.entryM, corner.exitM) = toMeeting(begins.position, direction(begins.heading.si()),
                                                      ends.position, direction(ends.heading.si()));
    return corner;
}

/// A corner that is driven too far and back, with the lengths it takes from the two sides.
struct Swing {
    double beforeM = 0.0;
    double afterM = 0.0;
    std::array<CurvePiece, 2> arcs;
};

Swing swingOf(const SwingCorner& corner, double overRad, double radiusM) {
    const double farthest = corner.turnRad + overRad;
    // Left by `farthest`, then right by `overRad`, from the origin along x.
    const double endX = radiusM * (2.0 * std::sin(farthest) - std::sin(corner.turnRad));
    const double endY = radiusM * (1.0 - 2.0 * std::cos(farthest) + std::cos(corner.turnRad));
    const double afterM = endY / std::sin(corner.turnRad);
    const Curvature curvature = Curvature::fromSi(corner.side / radiusM);
    return {.beforeM = endX - afterM * std::cos(corner.turnRad),
            .afterM = afterM,
            .arcs = {{{.length = metres(radiusM * farthest), .curvature = curvature},
                      {.length = metres(radiusM * overRad),
                       .curvature = -1.0 * curvature,
                       .endCurvature = -1.0 * curvature}}}};
}

}  // namespace

Curve swungOut(const Curve& line, const Rig& rig) {
    const double radiusM = rig.machine().minTurningRadius().si();
    const Implement& implement = rig.machine().spec().implement;
    const Length afterwards = kLengthsAfter * (implement.hitchOffset - implement.offset);
    Curve swung = line;
    std::vector<CurvePiece>& pieces = swung.pieces;
    // Start in the middle of a straight, so that no corner lies across the ends.
    if (const auto straight = std::ranges::find_if(pieces, isStraight); straight != pieces.end()) {
        for (auto piece = pieces.begin(); piece != straight; ++piece) {
            swung.start = advanced(swung.start, *piece, piece->length);
        }
        const Length half = 0.5 * straight->length;
        swung.start = advanced(swung.start, *straight, half);
        std::ranges::rotate(pieces, straight);
        pieces.push_back({.length = half, .curvature = {}});
        pieces.front().length = half;
    }
    Pose pose = swung.start;
    for (std::size_t i = 0; i + 2 < pieces.size(); ++i) {
        const Pose begins = advanced(pose, pieces[i], pieces[i].length);
        const auto corner = isStraight(pieces[i]) ? cornerAfter(pieces, i, begins, radiusM) : std::nullopt;
        for (const double degreesOver : corner ? std::span{kSwingsDeg} : std::span<const double>{}) {
            const Swing swing = swingOf(*corner, degrees(degreesOver).si(), radiusM);
            CurvePiece& next = pieces[corner->last + 1];
            const Length before = pieces[i].length + metres(corner->entryM - swing.beforeM);
            const Length after = next.length + metres(corner->exitM - swing.afterM);
            if (before.si() < kLeastStraightM || after.si() < kLeastStraightM) {
                continue;
            }
            std::optional<RigState> state = Rig::inLine(advanced(pose, pieces[i], before));
            const CurvePiece on{.length = std::min(after, afterwards), .curvature = {}};
            for (const CurvePiece& piece : {swing.arcs[0], swing.arcs[1], on}) {
                state = state ? rig.follow(*state, piece, kLookStep,
                                           [&](const RigState& at) { return rig.outsideM(at) <= kContactM; })
                              : state;
            }
            if (!state) {
                continue;
            }
            pieces[i].length = before;
            next.length = after;
            const auto first = pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1;
            const auto past = pieces.begin() + static_cast<std::ptrdiff_t>(corner->last) + 1;
            pieces.insert(pieces.erase(first, past), swing.arcs.begin(), swing.arcs.end());
            break;
        }
        pose = advanced(pose, pieces[i], pieces[i].length);
    }
    return swung;
}

}  // namespace furrow
