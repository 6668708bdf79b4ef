#pragma once

#include "planner/audit/boundary_index.h"
#include "planner/audit/footprint.h"
#include "planner/audit/known_pieces.h"
#include "planner/audit/motion.h"

#include <vector>

namespace furrow {

/// The room of a machine with a mounted implement to work. With the implement down, no part of it is outside
/// the drivable area, neither there nor on the way that led there. That way is as long as the run-in,
/// straight or on full lock.
class WorkingRoom {
public:
    WorkingRoom(const MultiPolygon& drivable, const Machine& machine, const MachineShape& shape);

    /// Whether the working line can lie over a place from a pose with room. Headings are tested in steps of
    /// 7.5 degrees, along the edges near the place and across them. The position across the heading is solved
    /// exactly. O(headings x edges within the machine's reach).
    bool reaches(Point place) const {
        Hint none;
        return reaches(place, none);
    }

    /// The heading and the way that had room at the place before: tried first, since neighbours mostly have
    /// room alike. It changes no answer.
    struct Hint {
        Point nose;
        std::size_t sweep = 0;
    };
    bool reaches(Point place, Hint& hint) const;

private:
    /// A convex ring and the box around it.
    struct Part {
        Ring ring;
        Bounds box;
    };
    /// The areas that the parts of the machine sweep on one way, around the middle of the working line at its
    /// end, nose to +x.
    using Sweep = std::vector<Part>;

    bool reachesAhead(Point place, Point nose, const std::vector<Edge>& edges, const Sweep& sweep) const;

    BoundaryIndex edges_;
    std::vector<Sweep> sweeps_;
    double halfWidthM_ = 0.0;
    double lookM_ = 0.0;  ///< largest distance of any part from a worked place
};

/// The parts of polygons within reach in this sense, largest first. They are tested in squares of a quarter
/// of a metre to one and a half; larger pieces have larger squares. Pieces larger than 1,000 m², and all
/// pieces after 2 ha of smaller ones, stay unchanged.
/// @param known  pieces that were looked at before, with this room; may be null
/// O(area x cost of one place). Cancelled.
Result<MultiPolygon> partsWithRoom(const MultiPolygon& polygons, const WorkingRoom& room,
                                   Length operatingWidth, const JobContext& job,
                                   KnownPieces* known = nullptr);

}  // namespace furrow
