#pragma once

#include "planner/geometry/curve.h"
#include "planner/units/angle.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"

#include <cmath>
#include <complex>
#include <numbers>

/// What tests of turns share: pairs of poses, and a drive along the pieces that has nothing in common with
/// the planner's own.
namespace furrow::test {

inline Pose pose(double x, double y, double headingDeg) {
    return {.position = {x, y}, .heading = degrees(headingDeg)};
}

inline Pose mirrored(const Pose& p) {
    return {.position = {p.position.x, -p.position.y}, .heading = -p.heading};
}

/// Where one ends that drives the pieces: arcs by rotating around their centre, clothoids by Simpson's rule
/// over short steps with a known heading (error below 1e-9 of the length).
inline Pose driven(const Curve& turn) {
    std::complex<double> place{turn.start.position.x, turn.start.position.y};
    double heading = turn.start.heading.si();
    for (const CurvePiece& piece : turn.pieces) {
        const double sign = piece.gear == Gear::Forward ? 1.0 : -1.0;
        const double length = piece.length.si();
        const double k0 = piece.curvature.si();
        const double k1 = piece.endCurvature.si();
        if (k0 == k1 && k0 == 0.0) {
            place += sign * length * std::polar(1.0, heading);
        } else if (k0 == k1) {
            const std::complex<double> toCentre =
                std::complex<double>{0.0, 1.0 / k0} * std::polar(1.0, heading);
            heading += sign * length * k0;
            place += toCentre - std::complex<double>{0.0, 1.0 / k0} * std::polar(1.0, heading);
        } else {
            const auto headingAt = [&](double s) {
                return heading + sign * s * (k0 + 0.5 * (k1 - k0) * s / length);
            };
            const double turned = std::max(std::abs(k0), std::abs(k1)) * length;
            const int steps = 16 + 2 * static_cast<int>(40.0 * turned);
            const double h = length / steps;
            std::complex<double> sum;
            for (int i = 0; i < steps; ++i) {
                sum += std::polar(1.0, headingAt(i * h)) + 4.0 * std::polar(1.0, headingAt((i + 0.5) * h)) +
                       std::polar(1.0, headingAt((i + 1) * h));
            }
            place += sign * h / 6.0 * sum;
            heading = headingAt(length);
        }
    }
    return {{place.real(), place.imag()}, radians(heading)};
}

struct PosePair {
    Pose from;
    Pose to;
    double radiusM;
};

/// Half of them near enough for three arcs to matter.
inline PosePair randomPair(std::mt19937_64& random) {
    const double radiusM = uniform(random, 0.5, 12.0);
    const double reachM = radiusM * (random() % 2 == 0 ? 2.0 : 12.0);
    const auto randomPose = [&] {
        const double x = uniform(random, -reachM, reachM);
        const double y = uniform(random, -reachM, reachM);
        return Pose{.position = {x, y}, .heading = radians(uniform(random, 0.0, 2.0 * std::numbers::pi))};
    };
    const Pose from = randomPose();
    const Pose to = randomPose();
    return {from, to, radiusM};
}

/// From the end of one swath to the start of another that runs back beside it, 0.5 to 40 m on, at a field
/// edge that crosses the swaths at 30 to 150 degrees.
inline PosePair swathPair(std::mt19937_64& random) {
    const double radiusM = uniform(random, 1.5, 12.0);
    const double offsetM = uniform(random, 0.5, 40.0) * (random() % 2 == 0 ? 1.0 : -1.0);
    const double edge = degrees(uniform(random, 30.0, 150.0)).si();
    const double heading = uniform(random, 0.0, 2.0 * std::numbers::pi);
    const Point ahead = direction(heading);
    const Point right{ahead.y, -ahead.x};
    const Pose from{.position = {uniform(random, -100.0, 100.0), uniform(random, -100.0, 100.0)},
                    .heading = radians(heading)};
    const Point to = from.position + offsetM * right + (offsetM / std::tan(edge)) * ahead;
    return {from, {.position = to, .heading = radians(heading + std::numbers::pi)}, radiusM};
}

inline QByteArray told(std::uint64_t seed, int i, const PosePair& pair) {
    return QStringLiteral("seed %1, pair %2: (%3, %4, %5) to (%6, %7, %8), radius %9")
        .arg(seed)
        .arg(i)
        .arg(pair.from.position.x, 0, 'g', 17)
        .arg(pair.from.position.y, 0, 'g', 17)
        .arg(pair.from.heading.si(), 0, 'g', 17)
        .arg(pair.to.position.x, 0, 'g', 17)
        .arg(pair.to.position.y, 0, 'g', 17)
        .arg(pair.to.heading.si(), 0, 'g', 17)
        .arg(pair.radiusM, 0, 'g', 17)
        .toUtf8();
}

inline double headingGap(const Pose& a, const Pose& b) {
    return std::abs(std::remainder(a.heading.si() - b.heading.si(), 2.0 * std::numbers::pi));
}

}  // namespace furrow::test
