#pragma once

#include "planner/plan/drive_course.h"
#include "ui/map/map_frame.h"
#include "ui/map/mesh.h"

#include <cstddef>
#include <vector>

namespace furrow {

/// What the implement works on a drive, as triangles in driving order. In pieces of so many stations, so that
/// only the piece that the machine is in has to be made anew with each frame.
class WorkedStrips {
public:
    WorkedStrips(const DriveCourse& course, Length width, const MapFrame& frame);

    static constexpr std::size_t kStationsInPiece = 1024;

    std::size_t pieceCount() const { return pieces_.size(); }
    const FillMesh& piece(std::size_t index) const { return pieces_[index]; }
    /// Of the piece that a station is in, the part up to this state.
    FillMesh begun(std::size_t station, const DriveState& state) const;

private:
    struct Edge {
        MapPoint left;
        MapPoint right;
    };
    Edge edgeOf(const DriveState& state) const;
    static void add(FillMesh& mesh, const Edge& from, const Edge& to);

    double halfWidthM_;
    MapFrame frame_;
    std::vector<Edge> edges_;  ///< of each station
    std::vector<bool> works_;  ///< from each station to the next
    std::vector<FillMesh> pieces_;
};

}  // namespace furrow
