#include "planner/path/refill_pieces.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/tolerances.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

// Pieces of a cut leg, for each tank that it takes.
constexpr double kCutsPerTank = 4.0;

double usedBy(const Leg& leg, const TankWork& work) {
    return leg.implementDown ? work.perMetre * leg.line.length().si() : 0.0;
}

/// Between the end of one pass and the beginning of another.
bool mayPauseBetween(const Leg& before, const Leg& next) {
    return before.implementDown && next.implementDown &&
           distance(before.line.end().position, next.line.start.position) > kMeetM;
}

/// A leg in parts of a quarter of a tank at most.
void addCut(const Leg& leg, const TankWork& work, std::vector<RefillPiece>& pieces) {
    const double uses = usedBy(leg, work);
    const int cuts = std::max(1, static_cast<int>(std::ceil(kCutsPerTank * uses / work.capacity)));
    const Length length = leg.line.length();
    for (int i = 0; i < cuts; ++i) {
        Leg part = leg;
        part.line = partOf(leg.line, (static_cast<double>(i) / cuts) * length, ((i + 1.0) / cuts) * length);
        pieces.push_back({.legs = {std::move(part)}, .uses = uses / cuts, .goesOn = i > 0});
    }
}

/// A piece that takes more than a tank. A headland pass may be interrupted anywhere; what is driven between
/// its stretches belongs to the one before.
void cutApart(const RefillPiece& piece, const TankWork& work, bool mayCutSwaths,
              std::vector<RefillPiece>& pieces) {
    bool isOpen = false;
    for (const Leg& leg : piece.legs) {
        const bool mayCut = leg.implementDown && (leg.kind == SegmentKind::HeadlandPass || mayCutSwaths);
        if (mayCut) {
            addCut(leg, work, pieces);
            isOpen = false;
            continue;
        }
        if (!isOpen && (leg.implementDown || &leg == &piece.legs.front())) {
            pieces.emplace_back();
            isOpen = true;
        }
        pieces.back().legs.push_back(leg);
        pieces.back().uses += usedBy(leg, work);
    }
}

/// Puts together again what was cut.
void rejoin(Curve& line, const Curve& next) {
    for (const CurvePiece& piece : next.pieces) {
        CurvePiece& last = line.pieces.back();
        const bool goesOn = &piece == &next.pieces.front() && last.gear == piece.gear &&
                            last.curvature == last.endCurvature && piece.curvature == last.curvature &&
                            piece.endCurvature == last.curvature;
        if (goesOn) {
            last.length += piece.length;
        } else {
            line.pieces.push_back(piece);
        }
    }
}

}  // namespace

std::vector<RefillPiece> refillPieces(const std::vector<Leg>& legs, const TankWork& work, bool mayCutSwaths) {
    std::vector<RefillPiece> whole;
    for (std::size_t i = 0; i < legs.size(); ++i) {
        if (i == 0 || mayPauseBetween(legs[i - 1], legs[i])) {
            whole.emplace_back();
        }
        whole.back().legs.push_back(legs[i]);
        whole.back().uses += usedBy(legs[i], work);
    }
    std::vector<RefillPiece> pieces;
    for (RefillPiece& piece : whole) {
        if (piece.uses <= work.capacity) {
            pieces.push_back(std::move(piece));
            continue;
        }
        cutApart(piece, work, mayCutSwaths, pieces);
    }
    return pieces;
}

std::vector<Leg> legsWithStops(const std::vector<RefillPiece>& pieces,
                               const std::vector<std::optional<Leg>>& stops) {
    std::vector<Leg> legs;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (stops[i]) {
            legs.push_back(*stops[i]);
        }
        if (pieces[i].goesOn && !stops[i]) {
            rejoin(legs.back().line, pieces[i].legs.front().line);
            legs.insert(legs.end(), pieces[i].legs.begin() + 1, pieces[i].legs.end());
            continue;
        }
        legs.insert(legs.end(), pieces[i].legs.begin(), pieces[i].legs.end());
    }
    return legs;
}

}  // namespace furrow
