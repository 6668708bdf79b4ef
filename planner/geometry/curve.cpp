#include "planner/geometry/curve.h"

#include "planner/units/angle.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace furrow {

namespace {

/// Values at the nodes, in pairs for the processor. The last one stands for nothing.
using AtNodes = Eigen::Array<double, 6, 1>;
using NodeValues = Eigen::Map<const AtNodes, Eigen::Aligned16>;

// Nodes and weights of the Gauss-Legendre rule with ten points on [-1, 1], the positive half
// (Abramowitz & Stegun 1964, table 25.4).
alignas(16) constexpr double kNodes[] = {0.1488743389816312108848260, 0.4333953941292471907992659,
                                         0.6794095682990244062343274, 0.8650633666889845107320967,
                                         0.9739065285171717200779640, 0.0};
alignas(16) constexpr double kWeights[] = {0.2955242247147528701738930, 0.2692667193099963550912269,
                                           0.2190863625159820439955349, 0.1494513491505805931457763,
                                           0.0666713443086881375935688, 0.0};
// For exp(i x) over a stretch with at most this turn, the rule's error is below rounding.
constexpr double kPanelRad = 1.5;

/// Factors of the powers of the squared angle, the highest one first: of the cosine for `first` 0, of the
/// sine divided by its angle for `first` 1.
template <std::size_t kTerms>
constexpr std::array<double, kTerms> seriesFactors(int first) {
    std::array<double, kTerms> factors{};
    double factor = 1.0;
    for (std::size_t i = 0; i < kTerms; ++i) {
        factors[kTerms - 1 - i] = factor;
        const int power = first + 2 * static_cast<int>(i);
        factor /= -(power + 1) * (power + 2);
    }
    return factors;
}

/// Such a series of some angles, given by their squares: several times as quick as sine and cosine.
template <std::size_t kTerms>
AtNodes seriesOf(const std::array<double, kTerms>& factors, const AtNodes& squares) {
    AtNodes sums = AtNodes::Zero();
    for (const double factor : factors) {
        sums = factor + squares * sums;
    }
    return sums;
}

// The first terms left out are below 2e-17 for half the turn of a panel, and for the largest change of the
// middle's direction within one, a quarter of its turn.
constexpr auto kCosineFactors = seriesFactors<9>(0);
constexpr auto kSmallCosineFactors = seriesFactors<7>(0);
constexpr auto kSmallSineFactors = seriesFactors<7>(1);

/// The displacement in the frame of the start over `way` (negative in reverse), with the curvature k + rate
/// s.
///
/// Beside the middle of a panel, the direction differs by the same even part before and behind it, and by an
/// odd part that turns against it: both directions together are one, turned by the even part, as long as
/// twice the cosine of the odd one.
Point clothoidDisplacement(double way, double k, double rate) {
    const double largest = std::max(std::abs(k), std::abs(k + rate * way));
    const double mostTurn = largest * std::abs(way);
    const int panels = mostTurn <= kPanelRad ? 1 : static_cast<int>(std::ceil(mostTurn / kPanelRad));
    const double half = panels == 1 ? 0.5 * way : 0.5 * way / panels;
    const NodeValues weights{kWeights};
    const AtNodes squares = (half * NodeValues{kNodes}).square();
    const AtNodes even = 0.5 * rate * squares;
    const AtNodes evenSquares = even.square();
    const AtNodes along = weights * seriesOf(kSmallCosineFactors, evenSquares);
    const AtNodes aside = weights * even * seriesOf(kSmallSineFactors, evenSquares);
    Point sum;
    for (int panel = 0; panel < panels; ++panel) {
        const double middle = (2 * panel + 1) * half;
        const double curvature = k + rate * middle;
        const AtNodes odd = seriesOf(kCosineFactors, curvature * curvature * squares);
        const double x = 2.0 * (along * odd).sum();
        const double y = 2.0 * (aside * odd).sum();
        const Point ahead = direction(middle * (k + 0.5 * rate * middle));
        sum = sum + x * ahead + y * Point{-ahead.y, ahead.x};
    }
    return half * sum;
}

}  // namespace

Curvature CurvePiece::curvatureAt(Length way) const {
    // A piece without length has only its beginning.
    return length.si() > 0.0 ? curvature + (endCurvature - curvature) * (way / length) : curvature;
}

Length Curve::length() const {
    Length sum;
    for (const CurvePiece& piece : pieces) {
        sum += piece.length;
    }
    return sum;
}

Pose Curve::end() const {
    Pose pose = start;
    for (const CurvePiece& piece : pieces) {
        pose = advanced(pose, piece, piece.length);
    }
    return pose;
}

Pose advanced(const Pose& from, const CurvePiece& piece, Length way) {
    if (piece.onTheSpot != Angle{}) {
        return {.position = from.position, .heading = normalisedPoseHeading(from.heading + piece.onTheSpot)};
    }
    const double signedWay = piece.gear == Gear::Forward ? way.si() : -way.si();
    if (piece.endCurvature != piece.curvature && piece.length.si() > 0.0) {
        const double k = piece.curvature.si();
        const double change = (piece.endCurvature - piece.curvature).si() / piece.length.si();
        const double rate = piece.gear == Gear::Forward ? change : -change;
        const Point moved = clothoidDisplacement(signedWay, k, rate);
        const Point ahead = direction(from.heading.si());
        const Point left{-ahead.y, ahead.x};
        return {.position = from.position + moved.x * ahead + moved.y * left,
                .heading =
                    normalisedPoseHeading(from.heading + radians(signedWay * (k + 0.5 * rate * signedWay)))};
    }
    const double turned = signedWay * piece.curvature.si();
    // The chord of an arc leaves at half its angle. sin(x)/x keeps flat arcs exact.
    const double half = 0.5 * turned;
    const double chord = std::abs(half) < 1e-9 ? signedWay : signedWay * std::sin(half) / half;
    return {.position = from.position + chord * direction(from.heading.si() + half),
            .heading = normalisedPoseHeading(from.heading + radians(turned))};
}

}  // namespace furrow
