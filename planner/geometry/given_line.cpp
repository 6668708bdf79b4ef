#include "planner/geometry/given_line.h"

#include <algorithm>

namespace furrow {

namespace {

constexpr int kTurnLooks = 16;

}  // namespace

GivenLine::GivenLine(std::span<const Curve> lines) {
    Pose pose;
    double m = 0.0;
    double turned = 0.0;
    for (const Curve& line : lines) {
        pose = line.start;
        joints_.push_back(m);
        for (const CurvePiece& piece : line.pieces) {
            pieces_.push_back(piece);
            placesM_.push_back(m);
            poses_.push_back(pose);
            turned_.push_back(turned);
            m += piece.length.si();
            turned += 0.5 * piece.length.si() * (piece.curvature + piece.endCurvature).si();
            pose = advanced(pose, piece, piece.length);
        }
    }
    placesM_.push_back(m);
    poses_.push_back(pose);
    turned_.push_back(turned);
}

Pose GivenLine::poseAt(double m) const {
    const std::size_t i = pieceAt(m);
    return advanced(poses_[i], pieces_[i], metres(std::clamp(m - placesM_[i], 0.0, pieces_[i].length.si())));
}

double GivenLine::meanCurvature(double m, double windowM, bool before) const {
    if (windowM > kNoWindowM) {
        return (turnedTo(m + 0.5 * windowM) - turnedTo(m - 0.5 * windowM)) / windowM;
    }
    const std::size_t i = pieceAt(before ? m - kSamePlaceM : m + kSamePlaceM);
    return pieces_[i].curvatureAt(metres(std::clamp(m - placesM_[i], 0.0, pieces_[i].length.si()))).si();
}

double GivenLine::meanTurn(double m, double windowM) const {
    const double here = turnedTo(m);
    double sum = 0.0;
    for (int i = 0; i < kTurnLooks; ++i) {
        sum += turnedTo(m + windowM * ((i + 0.5) / kTurnLooks - 0.5)) - here;
    }
    return sum / kTurnLooks;
}

std::size_t GivenLine::pieceAt(double m) const {
    const auto after = std::upper_bound(placesM_.begin() + 1, placesM_.end() - 1, m);
    return static_cast<std::size_t>(after - placesM_.begin()) - 1;
}

double GivenLine::turnedTo(double m) const {
    const std::size_t i = pieceAt(m);
    const double inM = std::clamp(m - placesM_[i], 0.0, pieces_[i].length.si());
    return turned_[i] + 0.5 * inM * (pieces_[i].curvature + pieces_[i].curvatureAt(metres(inM))).si();
}

}  // namespace furrow
