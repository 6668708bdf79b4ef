#include "planner/geometry/curve_parts.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// Shorter pieces are rounding.
constexpr Length kLeastPiece = metres(1e-9);

}  // namespace

Curve partOf(const Curve& line, Length from, Length to) {
    Curve part{.type = line.type, .start = line.start, .pieces = {}};
    Pose pose = line.start;
    Length way;
    bool begun = false;
    for (const CurvePiece& piece : line.pieces) {
        const Length begin = std::clamp(from - way, Length{}, piece.length);
        const Length end = std::clamp(to - way, Length{}, piece.length);
        if (end - begin > kLeastPiece) {
            if (!begun) {
                part.start = advanced(pose, piece, begin);
                begun = true;
            }
            part.pieces.push_back({.length = end - begin,
                                   .curvature = piece.curvatureAt(begin),
                                   .endCurvature = piece.curvatureAt(end),
                                   .gear = piece.gear});
        }
        pose = advanced(pose, piece, piece.length);
        way += piece.length;
    }
    return part;
}

Curve movedLeft(const Curve& line, Length left) {
    if (left == Length{}) {
        return line;
    }
    Curve moved = line;
    const Point ahead = direction(line.start.heading.si());
    moved.start.position = line.start.position + left.si() * Point{-ahead.y, ahead.x};
    for (CurvePiece& piece : moved.pieces) {
        const double shrinks = 1.0 - piece.curvature.si() * left.si();
        piece.length = shrinks * piece.length;
        piece.curvature = piece.endCurvature = Curvature::fromSi(piece.curvature.si() / shrinks);
    }
    return moved;
}

Curve extended(const Curve& line, Length before, Length after) {
    Curve longer = line;
    if (before > Length{}) {
        longer.start.position = line.start.position - before.si() * direction(line.start.heading.si());
        longer.pieces.insert(longer.pieces.begin(), {.length = before, .curvature = {}});
    }
    if (after > Length{}) {
        longer.pieces.push_back({.length = after, .curvature = {}});
    }
    return longer;
}

std::vector<Curve> betweenTurnsOnTheSpot(const Curve& line) {
    std::vector<Curve> lines;
    Curve open{.type = line.type, .start = line.start, .pieces = {}};
    Pose pose = line.start;
    const auto close = [&] {
        if (!open.pieces.empty()) {
            lines.push_back(open);
        }
        open.start = pose;
        open.pieces.clear();
    };
    for (const CurvePiece& piece : line.pieces) {
        pose = advanced(pose, piece, piece.length);
        if (piece.onTheSpot != Angle{}) {
            close();
        } else {
            open.pieces.push_back(piece);
        }
    }
    close();
    return lines;
}

Curvature sharpestBend(const Curve& line) {
    double most = 0.0;
    for (const CurvePiece& piece : line.pieces) {
        most = std::max({most, std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si())});
    }
    return Curvature::fromSi(most);
}

}  // namespace furrow
