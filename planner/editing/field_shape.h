#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"

#include <compare>
#include <optional>
#include <vector>

namespace furrow {

/// The owner of a line that can be grabbed.
enum class OutlineKind {
    Boundary,  ///< outer ring of a part
    Hole,
    Obstacle,
    Guide,  ///< the guidance line of the swaths: open
    Split,  ///< a line that the mainland is cut along: open
};

/// Lines drawn across a field that belong to its plan.
struct DrawnLines {
    GeoRing guide;  ///< empty for none
    std::vector<GeoRing> splits;
};

struct OutlineId {
    OutlineKind kind = OutlineKind::Boundary;
    std::size_t item = 0;  ///< part, obstacle or split line
    std::size_t hole = 0;  ///< of the part

    friend auto operator<=>(const OutlineId&, const OutlineId&) = default;
};

/// A ring or a line for editing: in WGS84 as stored, and in metres.
struct Outline {
    OutlineId id;
    bool closed = true;
    GeoRing places;
    std::vector<Point> points;  ///< the same in the shape's frame

    std::size_t edgeCount() const { return closed || points.empty() ? points.size() : points.size() - 1; }
    Point from(std::size_t edge) const { return points[edge]; }
    Point to(std::size_t edge) const { return points[edge + 1 == points.size() ? 0 : edge + 1]; }
};

/// Everything of a field that can be edited on a map, in one plane in metres. It need not be valid.
struct FieldShape {
    LocalFrame frame;
    std::vector<Outline> outlines;
    std::vector<Point> gates;

    /// @param before  the shape before a change: its frame is kept, and unmoved points are not converted
    /// again
    /// @return InputRefused: no point to put the frame's centre at. Cost: O(n) for n points.
    static Result<FieldShape> of(const FieldSource& source, const DrawnLines& lines,
                                 const FieldShape* before = nullptr);

    const Outline* find(const OutlineId& id) const;
};

/// What an edge may have of its own: FieldSource::edgeHeadlands or FieldSource::edgeOverhangs.
using EdgeWidths = std::vector<EdgeWidth> FieldSource::*;

/// The own width of an edge of the boundary or of a hole. Null if it has none, and for other outlines.
const EdgeWidth* findEdgeWidth(const FieldSource& source, EdgeWidths widths, const OutlineId& id,
                               std::size_t edge);
/// The source with this width at the edge. Without a width, the edge is as elsewhere.
FieldSource withEdgeWidth(FieldSource source, EdgeWidths widths, const OutlineId& id, std::size_t edge,
                          std::optional<Length> width);

/// The source with other points in one outline. Drawn lines are not part of it and leave it unchanged.
FieldSource withOutline(FieldSource source, const OutlineId& id, GeoRing places);

}  // namespace furrow
