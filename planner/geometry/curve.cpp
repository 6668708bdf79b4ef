#include "planner/geometry/curve.h"

#include "planner/units/angle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace furrow {

namespace {

// Nodes and weights of the Gauss-Legendre rule with ten points on [-1, 1], the positive half
// (Abramowitz & Stegun 1964, table 25.4).
constexpr double kNodes[] = {0.1488743389816312108848260, 0.4333953941292471907992659,
                             0.6794095682990244062343274, 0.8650633666889845107320967,
                             0.9739065285171717200779640};
constexpr double kWeights[] = {0.2955242247147528701738930, 0.2692667193099963550912269,
                               0.2190863625159820439955349, 0.1494513491505805931457763,
                               0.0666713443086881375935688};
// For exp(i x) over a stretch with at most this turn, the rule's error is below rounding.
constexpr double kPanelRad = 1.5;
// Up to this angle the series of `directionNear` is exact to rounding.
constexpr double kSeriesRad = 1.0;

constexpr std::size_t kAtOnce = 2 * std::size(kNodes);
// Pairs of factors from one term of both series to the next, the last one first.
constexpr std::array kSeriesFactors = [] {
    std::array<std::array<double, 2>, 9> factors{};
    for (std::size_t i = 0; i < factors.size(); ++i) {
        const auto term = static_cast<int>(2 * (factors.size() - i));
        factors[i] = {-(1.0 / (term * (term - 1))), -(1.0 / (term * (term + 1)))};
    }
    return factors;
}();

/// The directions of some small angles, by their power series: some five times as quick as sine and cosine,
/// and most of a clothoid's cost. The next terms are below 1e-18. Each angle is worked out by itself, so they
/// can be worked out together.
void directionsNear(const std::array<double, kAtOnce>& angles, std::array<double, kAtOnce>& cosines,
                    std::array<double, kAtOnce>& sines) {
    std::array<double, kAtOnce> squares;
    for (std::size_t i = 0; i < kAtOnce; ++i) {
        squares[i] = angles[i] * angles[i];
        cosines[i] = 0.0;
        sines[i] = 0.0;
    }
    for (const auto& [even, odd] : kSeriesFactors) {
        for (std::size_t i = 0; i < kAtOnce; ++i) {
            cosines[i] = even * squares[i] * (1.0 + cosines[i]);
            sines[i] = odd * squares[i] * (1.0 + sines[i]);
        }
    }
    for (std::size_t i = 0; i < kAtOnce; ++i) {
        cosines[i] = 1.0 + cosines[i];
        sines[i] = angles[i] * (1.0 + sines[i]);
    }
}

/// The displacement in the frame of the start over `way` (negative in reverse), with the curvature k + rate
/// s.
Point clothoidDisplacement(double way, double k, double rate) {
    const double largest = std::max(std::abs(k), std::abs(k + rate * way));
    const int panels = std::max(1, static_cast<int>(std::ceil(largest * std::abs(way) / kPanelRad)));
    const double half = 0.5 * way / panels;
    const bool isSmall = largest * std::abs(way) <= kSeriesRad;
    const auto angleAt = [&](double s) { return s * (k + 0.5 * rate * s); };
    std::array<double, kAtOnce> angles;
    std::array<double, kAtOnce> cosines;
    std::array<double, kAtOnce> sines;
    Point sum;
    for (int panel = 0; panel < panels; ++panel) {
        const double middle = (2 * panel + 1) * half;
        for (std::size_t i = 0; i < std::size(kNodes); ++i) {
            angles[2 * i] = angleAt(middle - half * kNodes[i]);
            angles[2 * i + 1] = angleAt(middle + half * kNodes[i]);
        }
        if (isSmall) {
            directionsNear(angles, cosines, sines);
        } else {
            for (std::size_t i = 0; i < kAtOnce; ++i) {
                const Point towards = direction(angles[i]);
                cosines[i] = towards.x;
                sines[i] = towards.y;
            }
        }
        for (std::size_t i = 0; i < std::size(kNodes); ++i) {
            const Point before{cosines[2 * i], sines[2 * i]};
            const Point after{cosines[2 * i + 1], sines[2 * i + 1]};
            sum = sum + kWeights[i] * (before + after);
        }
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
