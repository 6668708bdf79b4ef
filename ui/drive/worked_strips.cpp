#include "ui/drive/worked_strips.h"

#include <algorithm>
#include <cmath>

namespace furrow {

WorkedStrips::WorkedStrips(const DriveCourse& course, Length width, const MapFrame& frame)
    : halfWidthM_{0.5 * width.si()}, frame_{frame} {
    const auto stations = course.stations();
    edges_.reserve(stations.size());
    works_.reserve(stations.size());
    for (std::size_t i = 0; i < stations.size(); ++i) {
        edges_.push_back(edgeOf(stations[i]));
        works_.push_back(course.worksAfter(i));
    }
    pieces_.resize((stations.size() + kStationsInPiece - 1) / kStationsInPiece);
    for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
        if (works_[i]) {
            add(pieces_[i / kStationsInPiece], edges_[i], edges_[i + 1]);
        }
    }
}

WorkedStrips::Edge WorkedStrips::edgeOf(const DriveState& state) const {
    const double heading = state.implementHeading.si();
    const Point aside = halfWidthM_ * Point{-std::sin(heading), std::cos(heading)};
    return {frame_.map(state.implement + aside), frame_.map(state.implement - aside)};
}

void WorkedStrips::add(FillMesh& mesh, const Edge& from, const Edge& to) {
    for (const MapPoint corner : {from.left, from.right, to.left, to.left, from.right, to.right}) {
        mesh.push_back(corner);
    }
}

FillMesh WorkedStrips::begun(std::size_t station, const DriveState& state) const {
    FillMesh mesh;
    for (std::size_t i = station / kStationsInPiece * kStationsInPiece; i < station; ++i) {
        if (works_[i]) {
            add(mesh, edges_[i], edges_[i + 1]);
        }
    }
    if (works_[station]) {
        add(mesh, edges_[station], edgeOf(state));
    }
    return mesh;
}

}  // namespace furrow
