#include "planner/field/field.h"

#include "planner/core/place_message.h"
#include "planner/field/boundary_repair.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/segment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

constexpr double kLargestExtentM = 100e3;
constexpr std::size_t kMostVertices = 1'000'000;
constexpr Length kBufferTolerance = metres(0.01);
constexpr Length kMostOverhang = metres(100.0);
// Obstacles and repairs cut edges into parts. A part lies within this distance of its edge.
constexpr double kSameLineM = 0.01;

Error refused(const FieldSource& source, Message where, Message what, Message remedy,
              std::optional<GeoPoint> place = std::nullopt) {
    std::string from = source.origin.empty() ? source.name : source.origin;
    if (!from.empty() && !where.empty()) {
        from += ", ";
    }
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = from + where,
            .remedy = std::move(remedy),
            .place = place};
}

Result<void> checkCoordinates(const FieldSource& source, const GeoRing& ring, const std::string& ringName) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const GeoPoint point = ring[i];
        const Message where = message("{}, point {}", ringName, i + 1);
        if (!std::isfinite(point.lonDeg) || !std::isfinite(point.latDeg)) {
            return std::unexpected(refused(source, where, "a coordinate is not a number",
                                           "correct or delete this point in the file"));
        }
        if (std::abs(point.lonDeg) > 180.0 || std::abs(point.latDeg) > 90.0) {
            return std::unexpected(
                refused(source, where,
                        message("{}, {} is outside longitude -180 to 180 and latitude -90 to 90",
                                point.lonDeg, point.latDeg),
                        "check the file's coordinate system"));
        }
    }
    return {};
}

Result<void> checkCoordinates(const FieldSource& source, const GeoPolygon& polygon, const std::string& name) {
    Result<void> checked = checkCoordinates(source, polygon.outer, name);
    for (std::size_t i = 0; checked && i < polygon.holes.size(); ++i) {
        checked = checkCoordinates(source, polygon.holes[i], message("{}, hole {}", name, i + 1));
    }
    return checked;
}

/// The ring of an edge. Null if there is no such ring.
const GeoRing* ringOf(const FieldSource& source, const EdgeWidth& edge) {
    if (edge.part >= source.parts.size() || edge.ring > source.parts[edge.part].holes.size()) {
        return nullptr;
    }
    const GeoPolygon& part = source.parts[edge.part];
    return edge.ring == 0 ? &part.outer : &part.holes[edge.ring - 1];
}

Result<void> checkHasEdge(const FieldSource& source, const EdgeWidth& edge, const Message& name) {
    const GeoRing* const ring = ringOf(source, edge);
    if (ring == nullptr || edge.edge >= ring->size()) {
        return std::unexpected(refused(source, name, "the boundary has no such edge", "take it away"));
    }
    return {};
}

Result<void> checkOverhang(const FieldSource& source, Length overhang, const Message& name) {
    if (!(overhang >= Length{} && overhang <= kMostOverhang)) {
        return std::unexpected(refused(source, name, "its overhang is not a length from 0 to 100 m",
                                       "give an overhang of 0 to 100 m"));
    }
    return {};
}

Result<void> checkEdges(const FieldSource& source) {
    for (const EdgeWidth& headland : source.edgeHeadlands) {
        const Message name = message("the headland of edge {}", headland.edge + 1);
        if (!(headland.width >= metres(0.0)) || !std::isfinite(headland.width.si())) {
            return std::unexpected(
                refused(source, name, "its width is not a length", "give a width of 0 m or more"));
        }
        if (auto checked = checkHasEdge(source, headland, name); !checked) {
            return checked;
        }
    }
    for (const EdgeWidth& over : source.edgeOverhangs) {
        const Message name = message("edge {}", over.edge + 1);
        if (auto checked = checkOverhang(source, over.width, name); !checked) {
            return checked;
        }
        if (auto checked = checkHasEdge(source, over, message("the overhang of edge {}", over.edge + 1));
            !checked) {
            return checked;
        }
    }
    return {};
}

Result<void> checkSource(const FieldSource& source) {
    std::size_t vertices = 0;
    for (std::size_t i = 0; i < source.parts.size(); ++i) {
        if (auto checked = checkCoordinates(source, source.parts[i], message("part {}", i + 1)); !checked) {
            return checked;
        }
        vertices += source.parts[i].outer.size();
        for (const GeoRing& hole : source.parts[i].holes) {
            vertices += hole.size();
        }
    }
    for (std::size_t i = 0; i < source.obstacles.size(); ++i) {
        const Message name = message("obstacle {}", i + 1);
        if (auto checked = checkCoordinates(source, source.obstacles[i].outline, name); !checked) {
            return checked;
        }
        vertices += source.obstacles[i].outline.outer.size();
        if (!(source.obstacles[i].buffer >= metres(0.0)) || !std::isfinite(source.obstacles[i].buffer.si())) {
            return std::unexpected(
                refused(source, name, "its buffer is not a length", "give a buffer of 0 m or more"));
        }
        if (auto checked = checkOverhang(source, source.obstacles[i].overhang, name); !checked) {
            return checked;
        }
    }
    for (std::size_t i = 0; i < source.gates.size(); ++i) {
        if (auto checked =
                checkCoordinates(source, GeoRing{source.gates[i].position}, message("gate {}", i + 1));
            !checked) {
            return checked;
        }
        if (!(source.gates[i].width >= metres(0.0)) || !std::isfinite(source.gates[i].width.si())) {
            return std::unexpected(refused(source, message("gate {}", i + 1), "its width is not a length",
                                           "give a width of 0 m or more"));
        }
    }
    if (auto checked = checkEdges(source); !checked) {
        return checked;
    }
    if (!(source.boundaryAccuracy >= metres(0.0)) || !std::isfinite(source.boundaryAccuracy.si())) {
        return std::unexpected(
            refused(source, "boundary accuracy", "it is not a length", "give 0 m or more"));
    }
    if (vertices > kMostVertices) {
        return std::unexpected(refused(source, "", message("the boundary has {} points", vertices),
                                       "simplify it to at most a million"));
    }
    if (source.parts.empty() || source.parts.front().outer.empty()) {
        return std::unexpected(
            refused(source, "", "there is no boundary", "draw one or open a file that has one"));
    }
    return {};
}

/// The point of the boundary that is farthest from the mean of all points, through the earth. If one point is
/// astray, it is this one.
struct FarPoint {
    std::size_t part = 0;
    std::size_t index = 0;
};

FarPoint farthestPoint(const FieldSource& source) {
    using Vector = std::array<double, 3>;
    const auto vectorOf = [](GeoPoint point) {
        const double lon = degrees(point.lonDeg).si();
        const double lat = degrees(point.latDeg).si();
        return Vector{std::cos(lat) * std::cos(lon), std::cos(lat) * std::sin(lon), std::sin(lat)};
    };
    Vector sum{};
    double count = 0.0;
    for (const GeoPolygon& part : source.parts) {
        for (const GeoPoint& point : part.outer) {
            const Vector at = vectorOf(point);
            std::ranges::transform(sum, at, sum.begin(), std::plus{});
            count += 1.0;
        }
    }
    FarPoint farthest;
    double largest = -1.0;
    for (std::size_t i = 0; i < source.parts.size(); ++i) {
        for (std::size_t k = 0; k < source.parts[i].outer.size(); ++k) {
            const Vector at = vectorOf(source.parts[i].outer[k]);
            const double apart =
                std::hypot(at[0] - sum[0] / count, at[1] - sum[1] / count, at[2] - sum[2] / count);
            if (apart > largest) {
                largest = apart;
                farthest = {.part = i, .index = k};
            }
        }
    }
    return farthest;
}

Result<void> checkExtent(const FieldSource& source, const LocalFrame& frame) {
    for (const GeoPolygon& part : source.parts) {
        for (const Point& point : frame.toLocal(part.outer)) {
            // Half the extent on either side of the centre. Far points are not finite in the plane.
            if (std::abs(point.x) <= 0.5 * kLargestExtentM && std::abs(point.y) <= 0.5 * kLargestExtentM) {
                continue;
            }
            const FarPoint far = farthestPoint(source);
            const GeoPoint place = source.parts[far.part].outer[far.index];
            return std::unexpected(
                refused(source, message("part {}, point {}", far.part + 1, far.index + 1),
                        message("the field is more than 100 km across; {} is farthest from the others",
                                placeMessage(place)),
                        "check the coordinate system, correct this point, or split the field", place));
        }
    }
    return {};
}

/// Edges with a given width, in metres.
std::vector<WideEdge> wideEdgesOf(const std::vector<EdgeWidth>& given, const FieldSource& source,
                                  const LocalFrame& frame) {
    std::vector<WideEdge> edges;
    for (const EdgeWidth& edge : given) {
        const GeoRing& ring = *ringOf(source, edge);
        edges.push_back(
            {frame.toLocal(ring[edge.edge]), frame.toLocal(ring[(edge.edge + 1) % ring.size()]), edge.width});
    }
    return edges;
}

Error withOrigin(Error error, const FieldSource& source) {
    if (!source.origin.empty() && !error.where.empty()) {
        error.where = source.origin + ", " + error.where;
    }
    return error;
}

}  // namespace

Result<Field> Field::create(const FieldSource& source, const JobContext& job) {
    if (auto checked = checkSource(source); !checked) {
        return std::unexpected(checked.error());
    }
    const auto frame = LocalFrame::centredOn(middleOf(source.parts));
    if (!frame) {
        return std::unexpected(frame.error());
    }
    if (auto checked = checkExtent(source, *frame); !checked) {
        return std::unexpected(checked.error());
    }
    Field field{source, *frame};
    auto boundary = repairBoundary(source.parts, *frame, "the boundary", job);
    if (!boundary) {
        return std::unexpected(withOrigin(boundary.error(), source));
    }
    field.source_.parts = std::move(boundary->geo);
    field.boundary_ = std::move(boundary->local);
    field.repairs_ = std::exchange(field.source_.repairs, {});
    std::ranges::move(boundary->repairs, std::back_inserter(field.repairs_));
    field.edgeHeadlands_ = wideEdgesOf(source.edgeHeadlands, source, *frame);
    field.edgeOverhangs_ = wideEdgesOf(source.edgeOverhangs, source, *frame);
    field.workable_ = field.boundary_;
    field.drivable_ = field.boundary_;
    for (std::size_t i = 0; i < source.obstacles.size(); ++i) {
        const Obstacle& obstacle = source.obstacles[i];
        const Message name =
            obstacle.name.empty() ? message("obstacle {}", i + 1) : message("obstacle '{}'", obstacle.name);
        auto outline = repairObstacle(obstacle.outline, *frame, name, job);
        if (!outline) {
            return std::unexpected(withOrigin(outline.error(), source));
        }
        std::ranges::move(outline->repairs, std::back_inserter(field.repairs_));
        if (auto cut = field.leaveOut(outline->local, obstacle, name, job); !cut) {
            return std::unexpected(cut.error());
        }
    }
    if (std::ranges::any_of(source.obstacles, &Obstacle::passable)) {
        auto passable = difference(field.drivable_, field.workable_, job);
        if (!passable) {
            return std::unexpected(passable.error());
        }
        field.passable_ = std::move(*passable);
    }
    if (field.workable_.empty()) {
        return std::unexpected(
            refused(source, "", "the obstacles leave nothing of the field", "delete some of them"));
    }
    for (const GeoPolygon& part : field.source_.parts) {
        field.area_ += geodesicArea(part);
    }
    if (!source.obstacles.empty()) {
        // The share that the obstacles take in the plane also holds on the ellipsoid: they differ by parts in
        // a million.
        field.area_ = field.area_ * (furrow::area(field.workable_) / furrow::area(field.boundary_));
    }
    return field;
}

Result<void> Field::leaveOut(const MultiPolygon& outline, const Obstacle& obstacle, const Message& name,
                             const JobContext& job) {
    const auto kept = dilated(outline, obstacle.buffer, kBufferTolerance, job);
    const auto inside = kept ? intersection(boundary_, *kept, job) : kept;
    if (!inside) {
        return std::unexpected(inside.error());
    }
    if (inside->empty()) {
        return std::unexpected(refused(source_, name, "it lies outside the field", "move or delete it",
                                       obstacle.outline.outer.front()));
    }
    for (MultiPolygon* land : {&workable_, &drivable_}) {
        if (land == &drivable_ && obstacle.passable) {
            continue;
        }
        auto rest = difference(*land, *kept, job);
        if (!rest) {
            return std::unexpected(rest.error());
        }
        *land = std::move(*rest);
    }
    if (!obstacle.passable) {
        impassable_.push_back({*kept, obstacle.overhang});
    }
    return {};
}

const WideEdge* edgeWith(std::span<const WideEdge> edges, Point from, Point to) {
    const WideEdge* last = nullptr;
    for (const WideEdge& edge : edges) {
        if (distanceToSegment(from, edge.from, edge.to) < kSameLineM &&
            distanceToSegment(to, edge.from, edge.to) < kSameLineM) {
            last = &edge;
        }
    }
    return last;
}

std::size_t Field::vertexCount() const {
    return furrow::vertexCount(boundary_);
}

std::size_t Field::holeCount() const {
    std::size_t count = 0;
    for (const Polygon& polygon : boundary_) {
        count += polygon.holes.size();
    }
    return count;
}

}  // namespace furrow
