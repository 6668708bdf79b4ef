#pragma once

#include "planner/core/result.h"
#include "planner/geodesy/local_frame.h"
#include "planner/geometry/polygon.h"
#include "planner/jobs/job.h"

#include <span>
#include <string>
#include <vector>

namespace furrow {

/// Something inside a field that is not worked.
struct Obstacle {
    std::string name;
    GeoPolygon outline;
    bool passable = false;  ///< may be driven, not worked (a wet spot)
    Length buffer;          ///< kept free around it
    /// How far the implement may stand over it, from the edge of what is kept free, its sections there
    /// switched off. The tractor and all wheels keep off. 0 to 100 m.
    Length overhang;

    friend bool operator==(const Obstacle&, const Obstacle&) = default;
};

/// A place on the boundary where the machine may enter and leave.
struct Gate {
    std::string name;
    GeoPoint position;
    Length width;

    friend bool operator==(const Gate&, const Gate&) = default;
};

/// A width given for one edge of the boundary.
struct EdgeWidth {
    std::size_t part = 0;
    std::size_t ring = 0;  ///< 0 for the outer one, 1 for the first hole
    std::size_t edge = 0;  ///< from this point of the ring to the next
    Length width;          ///< across the edge

    friend bool operator==(const EdgeWidth&, const EdgeWidth&) = default;
};

/// A field as given by a file or a user, not yet checked.
struct FieldSource {
    std::string id;
    std::string name;
    std::string origin;  ///< its source, for messages: "fields.gpkg, feature 12"
    std::vector<GeoPolygon> parts;
    std::vector<Obstacle> obstacles;
    std::vector<Gate> gates;
    std::vector<EdgeWidth> edgeHeadlands;  ///< from the edge to the mainland
    /// How far the implement may stand over an edge, outwards, its sections there switched off. The tractor
    /// and all wheels stay inside. 0 to 100 m.
    std::vector<EdgeWidth> edgeOverhangs;
    Length boundaryAccuracy;
    std::vector<Note> repairs;  ///< repairs made while it was read

    friend bool operator==(const FieldSource&, const FieldSource&) = default;
};

/// An edge in metres and the given width of its headland.
struct WideEdge {
    Point from;
    Point to;
    Length width;
};

/// The last of these edges that holds another one, which repairs or obstacles may have cut from it. Null if
/// there is none.
const WideEdge* edgeWith(std::span<const WideEdge> edges, Point from, Point to);

/// An obstacle that may not be driven on, in metres.
struct ImpassableObstacle {
    MultiPolygon outline;  ///< with its buffer
    Length overhang;       ///< of implements, from that outline inwards
};

/// A field that can be planned: boundaries valid, outer rings counter-clockwise, holes clockwise.
/// Immutable; share it by pointer.
class Field {
public:
    /// Checks and repairs. Repaired, with a note: duplicate points, spikes, ring direction, rings that touch
    /// themselves, slivers. InputRefused, with the place: fewer than 3 different points, self-crossing,
    /// coordinates that are not finite or outside WGS84, widths or overhangs out of range, no area, over 100
    /// km across, over a million points, obstacles outside the field. Cost: O(n log n) for n points.
    /// Cancelled.
    static Result<Field> create(const FieldSource& source, const JobContext& job = {});

    const std::string& id() const { return source_.id; }
    const std::string& name() const { return source_.name; }
    /// The source after repairs.
    const FieldSource& source() const { return source_; }
    /// Repairs while it was read and here.
    const std::vector<Note>& repairs() const { return repairs_; }
    const LocalFrame& frame() const { return frame_; }

    /// Boundary and holes, in metres.
    const MultiPolygon& boundary() const { return boundary_; }
    /// The boundary less every obstacle with its buffer: the area to be worked.
    const MultiPolygon& workable() const { return workable_; }
    /// The boundary less the obstacles that may not be driven on, with their buffers. Headland and swaths are
    /// laid over this area.
    const MultiPolygon& drivable() const { return drivable_; }
    /// The area that may be driven on and is not worked: passable obstacles with their buffers.
    const MultiPolygon& passable() const { return passable_; }
    /// Edges with a given width of headland, as they were before repairs.
    const std::vector<WideEdge>& edgeHeadlands() const { return edgeHeadlands_; }
    /// Edges that implements may stand over, as they were before repairs.
    const std::vector<WideEdge>& edgeOverhangs() const { return edgeOverhangs_; }
    /// In the order of the source.
    const std::vector<ImpassableObstacle>& impassable() const { return impassable_; }
    /// The area of the boundary on the ellipsoid, without holes and obstacles.
    Area area() const { return area_; }
    std::size_t vertexCount() const;
    std::size_t holeCount() const;

private:
    Field(FieldSource source, LocalFrame frame) : source_{std::move(source)}, frame_{frame} {}
    Result<void> leaveOut(const MultiPolygon& outline, const Obstacle& obstacle, const Message& name,
                          const JobContext& job);

    FieldSource source_;
    LocalFrame frame_;
    std::vector<Note> repairs_;
    MultiPolygon boundary_;
    MultiPolygon workable_;
    MultiPolygon drivable_;
    MultiPolygon passable_;
    std::vector<WideEdge> edgeHeadlands_;
    std::vector<WideEdge> edgeOverhangs_;
    std::vector<ImpassableObstacle> impassable_;
    Area area_;
};

}  // namespace furrow
