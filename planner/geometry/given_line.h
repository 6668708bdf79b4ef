#pragma once

#include "planner/geometry/curve.h"

#include <cstddef>
#include <span>
#include <vector>

namespace furrow {

/// Places nearer to each other are one.
inline constexpr double kSamePlaceM = 1e-7;
/// A smaller window leaves the curvature as it is.
inline constexpr double kNoWindowM = 1e-9;

/// Lines that follow one another, with their places in metres from the start, poses, and the integral of the
/// curvature.
class GivenLine {
public:
    explicit GivenLine(std::span<const Curve> lines);

    bool isEmpty() const { return pieces_.empty(); }
    double lengthM() const { return placesM_.back(); }
    const std::vector<CurvePiece>& pieces() const { return pieces_; }
    /// Where each line begins.
    const std::vector<double>& joints() const { return joints_; }
    double endM(std::size_t piece) const { return placesM_[piece + 1]; }

    /// O(log pieces), as all below.
    Pose poseAt(double m) const;
    Gear gearAt(double m) const { return pieces_[pieceAt(m)].gear; }
    /// The curvature before or after a place, or its mean over a window.
    double meanCurvature(double m, double windowM, bool before) const;
    /// The mean over a window of the integral of the curvature since `m`.
    double meanTurn(double m, double windowM) const;

private:
    std::size_t pieceAt(double m) const;
    double turnedTo(double m) const;

    std::vector<CurvePiece> pieces_;
    std::vector<double> joints_;
    std::vector<double> placesM_;
    std::vector<Pose> poses_;
    std::vector<double> turned_;
};

}  // namespace furrow
