#include "planner/turns/steered_line.h"

#include "planner/geometry/curve_parts.h"
#include "planner/geometry/eased_line.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace furrow {

namespace {

/// Where the least window is averaged over, an arc on full lock needs this much more to end where it did.
constexpr double kLockSlack = 1.0001;
/// A change of curvature that is rounding.
constexpr double kNoJump = 1e-9;
/// Shares of the window, tried in this order; then the least window, and none.
constexpr std::array kShares{1.0, 0.5, 0.25};
/// The rate may be larger by this factor: for changes from one side to the other, driven more slowly.
constexpr double kSteepest = 2.01;

constexpr double kEqualSidesM = 0.5;

/// The same closed line from the middle of its longest straight.
Curve fromLongestStraight(const Curve& ring) {
    const auto straightM = [](const CurvePiece& piece) {
        return piece.curvature == Curvature{} && piece.endCurvature == Curvature{} ? piece.length.si() : 0.0;
    };
    double mostM = 0.0;
    for (const CurvePiece& piece : ring.pieces) {
        mostM = std::max(mostM, straightM(piece));
    }
    if (mostM == 0.0) {
        return ring;
    }
    // Of sides that are about equal the first, however they are rounded.
    const auto first = std::ranges::find_if(
        ring.pieces, [&](const CurvePiece& piece) { return straightM(piece) > mostM - kEqualSidesM; });
    const auto longest = static_cast<std::size_t>(first - ring.pieces.begin());
    Length way;
    for (std::size_t i = 0; i < longest; ++i) {
        way += ring.pieces[i].length;
    }
    way += 0.5 * ring.pieces[longest].length;
    Curve turned = partOf(ring, way, ring.length());
    const Curve rest = partOf(ring, {}, way);
    turned.pieces.insert(turned.pieces.end(), rest.pieces.begin(), rest.pieces.end());
    return turned;
}

}  // namespace

Curvature fullLock(const Machine& machine) {
    return Curvature::fromSi(1.0 / machine.minTurningRadius().si());
}

Curvature sharpestSteered(const Machine& machine) {
    return kLockSlack * fullLock(machine);
}

Length steeringWindow(const Machine& machine) {
    const double steeredM =
        machine.steeringDuration({}, fullLock(machine)).si() * machine.turningSpeed().si();
    // Over a way w to the curvature k, an arc moves by k w² / 24.
    return metres(std::min(steeredM, std::sqrt(24.0 * kMostAside.si() / fullLock(machine).si())));
}

std::vector<LineRange> jumpsOf(const Curve& line, const Machine& machine) {
    const double perM = kSteepest * fullLock(machine).si() / steeringWindow(machine).si();
    std::vector<LineRange> places;
    const CurvePiece* before = nullptr;
    double m = 0.0;
    const auto arcM = [](const CurvePiece& piece) {
        return piece.curvature == piece.endCurvature && piece.curvature != Curvature{} ? piece.length.si()
                                                                                       : 0.0;
    };
    for (const CurvePiece& piece : line.pieces) {
        const double endM = m + piece.length.si();
        if (before != nullptr && std::abs((piece.curvature - before->endCurvature).si()) > kNoJump) {
            places.push_back({m - arcM(*before), m + arcM(piece)});
        }
        if (std::abs((piece.endCurvature - piece.curvature).si()) > perM * piece.length.si() + kNoJump) {
            places.push_back({m, endM});
        }
        m = endM;
        before = &piece;
    }
    return places;
}

std::span<SteeringWindows::Stretch> SteeringWindows::within(const LineRange& range) {
    // The index of the stretch that begins there.
    const auto cut = [this](double m) -> std::size_t {
        if (m >= endM_) {
            return stretches_.size();
        }
        const auto after = std::ranges::upper_bound(stretches_, m, {}, &Stretch::fromM);
        const auto index = static_cast<std::size_t>(after - stretches_.begin());
        if ((after - 1)->fromM == m) {
            return index - 1;
        }
        stretches_.insert(after, {m, (after - 1)->mostM});
        return index;
    };
    const std::size_t from = cut(std::max(0.0, range.fromM));
    const std::size_t to = cut(std::max(0.0, range.toM));
    return std::span{stretches_}.subspan(from, std::max(from, to) - from);
}

void SteeringWindows::set(const LineRange& range, Length window) {
    for (Stretch& stretch : within(range)) {
        stretch.mostM = window.si();
    }
}

void SteeringWindows::widen(const LineRange& range, Length window) {
    for (Stretch& stretch : within(range)) {
        stretch.mostM = std::max(stretch.mostM, window.si());
    }
}

void SteeringWindows::shrink(const LineRange& range, Length whole) {
    for (Stretch& stretch : within(range)) {
        const auto* const share = std::ranges::find_if(
            kShares, [&](double each) { return each * whole.si() < stretch.mostM * (1.0 - kNoJump); });
        stretch.mostM = share != kShares.end()                     ? *share * whole.si()
                        : stretch.mostM > AveragingWindows::kKeptM ? AveragingWindows::kKeptM
                                                                   : 0.0;
    }
}

AveragingWindows SteeringWindows::windows() const {
    std::vector<double> fromM;
    std::vector<double> mostM;
    for (const Stretch& stretch : stretches_) {
        fromM.push_back(stretch.fromM);
        mostM.push_back(stretch.mostM);
    }
    return {fromM, mostM, endM_};
}

Curve steeredRing(const Curve& ring, const Machine& machine, const std::function<bool(Point)>& stays) {
    const Curve turned = fromLongestStraight(ring);
    const Length window = steeringWindow(machine);
    SteeringWindows windows{turned.length()};
    windows.set({0.0, turned.length().si()}, window);
    double m = 0.0;
    Pose pose = turned.start;
    for (const CurvePiece& piece : turned.pieces) {
        const Pose end = advanced(pose, piece, piece.length);
        if (stays(pose.position) && stays(end.position)) {
            windows.set({m, m + piece.length.si()}, {});
        }
        m += piece.length.si();
        pose = end;
    }
    LineEasing easing{{&turned, 1}, sharpestSteered(machine)};
    EasedLine averaged = easing.with(windows.windows());
    // In the end such bends stay as they are.
    while (!averaged.failed.empty()) {
        for (const LineRange& range : averaged.failed) {
            windows.shrink(range, window);
        }
        averaged = easing.with(windows.windows());
    }
    if (averaged.pieces.empty()) {
        return ring;
    }
    Curve steered{.type = ring.type, .start = averaged.pieces.front().start, .pieces = {}};
    for (const EasedPiece& piece : averaged.pieces) {
        steered.pieces.push_back(piece.piece);
    }
    return steered;
}

}  // namespace furrow
