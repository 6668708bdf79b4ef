#include "ui/map/plan_drawing.h"

#include "ui/map/even_odd_fill.h"
#include "ui/map/simplify.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace furrow {

namespace {

/// Points of a chunk: large enough to be drawn from its own buffer, small enough to be culled.
constexpr std::size_t kChunkPoints = 4000;

using MapRings = std::vector<std::vector<MapPoint>>;

MapRings ringsOf(const MapFrame& frame, const MultiPolygon& polygons) {
    MapRings rings;
    for (const Polygon& polygon : polygons) {
        rings.push_back(frame.map(polygon.outer));
        for (const Ring& hole : polygon.holes) {
            rings.push_back(frame.map(hole));
        }
    }
    return rings;
}

void addRings(LineMesh& mesh, const MapRings& rings) {
    for (const auto& ring : rings) {
        mesh.add(ring, true);
    }
}

QGeoRectangle geoBounds(const MapFrame& frame, const Bounds& box) {
    const GeoPoint topLeft = frame.geo({box.min.x, box.max.y});
    const GeoPoint bottomRight = frame.geo({box.max.x, box.min.y});
    return QGeoRectangle{coordinate(topLeft), coordinate(bottomRight)};
}

std::vector<EditableRing> editableRings(const FieldSource& source) {
    std::vector<EditableRing> rings;
    const auto add = [&rings](int part, int ring, const GeoRing& points) {
        EditableRing editable{part, ring, {}};
        std::ranges::transform(points, std::back_inserter(editable.points),
                               [](const GeoPoint& point) { return worldPoint(point); });
        rings.push_back(std::move(editable));
    };
    for (int part = 0; part < static_cast<int>(source.parts.size()); ++part) {
        const GeoPolygon& polygon = source.parts[static_cast<std::size_t>(part)];
        add(part, 0, polygon.outer);
        for (int hole = 0; hole < static_cast<int>(polygon.holes.size()); ++hole) {
            add(part, hole + 1, polygon.holes[static_cast<std::size_t>(hole)]);
        }
    }
    return rings;
}

MapRings obstacleRings(const MapFrame& frame, const Field& field) {
    MapRings rings;
    for (const Obstacle& obstacle : field.source().obstacles) {
        rings.push_back(frame.map(field.frame().toLocal(obstacle.outline.outer)));
    }
    return rings;
}

/// Collects segments of one kind until a chunk is full.
class ChunkBuilder {
public:
    ChunkBuilder(PlanGeometry& geometry, PathKind kind) : geometry_{geometry} { chunk_.kind = kind; }

    void add(const std::vector<MapPoint>& line) {
        box_ = points_ == 0 ? boxOf(line) : box_.united(boxOf(line));
        points_ += line.size();
        float tolerance = static_cast<float>(PathChunk::kToleranceM * geometry_.unitsPerMetre);
        chunk_.levels[0].add(line);
        for (std::size_t level = 1; level < PathChunk::kLevels; ++level) {
            chunk_.levels[level].add(simplified(line, tolerance));
            tolerance *= 4.0F;
        }
        if (points_ >= kChunkPoints) {
            flush();
        }
    }
    void flush() {
        if (points_ == 0) {
            return;
        }
        chunk_.box = box_;
        const PathKind kind = chunk_.kind;
        geometry_.chunks.push_back(std::move(chunk_));
        chunk_ = {};
        chunk_.kind = kind;
        points_ = 0;
    }

private:
    PlanGeometry& geometry_;
    PathChunk chunk_;
    QRectF box_;
    std::size_t points_ = 0;
};

PathKind kindOf(const PathSegment& segment) {
    if (!segment.drivable) {
        return PathKind::Undrivable;
    }
    switch (segment.kind) {
        case SegmentKind::Swath: return PathKind::Work;
        case SegmentKind::HeadlandPass: return PathKind::HeadlandPass;
        case SegmentKind::Turn: return segment.gear == Gear::Reverse ? PathKind::Reverse : PathKind::Turn;
        case SegmentKind::Transfer:
        case SegmentKind::Refill:
        case SegmentKind::Wait: break;
    }
    return segment.gear == Gear::Reverse ? PathKind::Reverse : PathKind::Transfer;
}

MapPoint between(MapPoint a, MapPoint b, float share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

void addPath(PlanGeometry& geometry, const MapFrame& frame, const Path& path) {
    std::vector<ChunkBuilder> builders;
    for (const PathKind kind : {PathKind::Work, PathKind::HeadlandPass, PathKind::Turn, PathKind::Transfer,
                                PathKind::Reverse, PathKind::Undrivable}) {
        builders.emplace_back(geometry, kind);
    }
    int order = 0;
    Ring points;
    for (const PathSegment& segment : path.segments) {
        points.clear();
        std::ranges::transform(segment.samples, std::back_inserter(points), &PathSample::position);
        const PathKind kind = kindOf(segment);
        const std::vector<MapPoint>& line = geometry.segments.emplace_back(kind, frame.map(points)).points;
        builders[static_cast<std::size_t>(kind)].add(line);
        if (segment.kind == SegmentKind::Swath) {
            ++order;
            geometry.directions.push_back({line.front(), line.back(), true, segment.number});
            const bool westFirst = line.front().x <= line.back().x;
            geometry.numbers.push_back({segment.number, order,
                                        between(line.front(), line.back(), westFirst ? 0.16F : 0.84F),
                                        between(line.front(), line.back(), 0.05F)});
        } else if (line.size() >= 2) {
            const std::size_t middle = line.size() / 2;
            geometry.directions.push_back({line[middle - 1], line[middle], false, 0});
        }
    }
    // So that every n-th one lies beside the one before it.
    std::ranges::stable_sort(geometry.numbers, {}, &NumberMark::number);
    for (ChunkBuilder& builder : builders) {
        builder.flush();
    }
    if (!path.segments.empty()) {
        geometry.start = frame.map(path.segments.front().samples.front().position);
        geometry.end = frame.map(path.segments.back().samples.back().position);
    }
}

/// A towed implement is at the end of its swath when the machine is some way farther: that way, so that the
/// turn begins where the swath is drawn to.
void addWaysBeyondSwaths(PlanGeometry& geometry, const MapFrame& frame, const Plan& plan) {
    std::map<int, const Swath*> swaths;
    for (const Swath& swath : plan.swaths.swaths) {
        swaths.emplace(swath.number, &swath);
    }
    for (const PathSegment& segment : plan.path.segments) {
        const auto swath = swaths.find(segment.number);
        if (segment.kind != SegmentKind::Swath || swath == swaths.end()) {
            continue;
        }
        const Point last = segment.samples.back().position;
        const Polyline line = middleLine(*swath->second);
        const Point end =
            distance(line.front(), last) < distance(line.back(), last) ? line.front() : line.back();
        // Back from the last one: a circle passes its end at its begin, too.
        auto here = segment.samples.end() - 1;
        while (here != segment.samples.begin() &&
               distance((here - 1)->position, end) < distance(here->position, end)) {
            --here;
        }
        Polyline beyond{end};
        std::transform(here + 1, segment.samples.end(), std::back_inserter(beyond),
                       [](const PathSample& sample) { return sample.position; });
        if (beyond.size() > 1) {
            geometry.beyondSwaths.add(frame.map(beyond));
        }
    }
}

void addProblem(PlanGeometry& geometry, const std::optional<GeoPoint>& problem) {
    if (problem) {
        geometry.findings.push_back({mapPoint(worldPoint(*problem), geometry.origin), Weight::Blocks});
        geometry.findingPlaces.push_back(coordinate(*problem));
    }
}

PlanGeometry boundaryGeometry(const Field& field, const MapFrame& frame) {
    PlanGeometry geometry;
    geometry.origin = frame.origin();
    geometry.unitsPerMetre = frame.unitsPerMetre();
    geometry.bounds = geoBounds(frame, bounds(field.boundary()));
    geometry.rings = editableRings(field.source());
    addRings(geometry.boundary, ringsOf(frame, field.boundary()));

    MapRings left = ringsOf(frame, field.boundary());
    const MapRings workable = ringsOf(frame, field.workable());
    left.insert(left.end(), workable.begin(), workable.end());
    geometry.obstacles = evenOddTriangles(left);
    MapRings holes;
    for (const Polygon& polygon : field.boundary()) {
        for (const Ring& hole : polygon.holes) {
            holes.push_back(frame.map(hole));
        }
    }
    const FillMesh holeFill = evenOddTriangles(holes);
    geometry.obstacles.insert(geometry.obstacles.end(), holeFill.begin(), holeFill.end());
    addRings(geometry.obstacleEdges, obstacleRings(frame, field));
    return geometry;
}

/// What the audit found on the ground; nothing of a draft, which is not measured.
void addMeasured(PlanGeometry& geometry, const MapFrame& frame, const Plan& plan) {
    if (!plan.audit.coveredShare) {
        return;
    }
    const MapRings missed = ringsOf(frame, plan.audit.missedAreas);
    MapRings covered = ringsOf(frame, plan.field().workable());
    covered.insert(covered.end(), missed.begin(), missed.end());
    geometry.covered = evenOddTriangles(covered);
    geometry.missed = evenOddTriangles(missed);
    geometry.overlap = evenOddTriangles(ringsOf(frame, plan.audit.overlapAreas));
    for (const Bounds& run : plan.audit.oftenDriven) {
        const std::array corners{run.min, Point{run.max.x, run.min.y}, run.max, Point{run.min.x, run.max.y}};
        const auto at = frame.map(corners);
        geometry.wheels.insert(geometry.wheels.end(), {at[0], at[1], at[2], at[0], at[2], at[3]});
    }
}

}  // namespace

PlanGeometry outlineGeometry(const FieldSource& source, const std::optional<GeoPoint>& problem) {
    PlanGeometry geometry;
    geometry.rings = editableRings(source);
    std::erase_if(geometry.rings, [](const EditableRing& ring) {
        return ring.points.size() < 2 || !std::ranges::all_of(
                                             ring.points,
                                             [](WorldPoint point) {
                                                 return std::isfinite(point.x) && std::isfinite(point.y) &&
                                                        point.x >= 0.0 && point.x <= 1.0;
                                             });
    });
    if (geometry.rings.empty()) {
        return geometry;
    }
    geometry.origin = geometry.rings.front().points.front();
    WorldPoint low = geometry.origin;
    WorldPoint high = geometry.origin;
    for (const EditableRing& ring : geometry.rings) {
        std::vector<MapPoint> line;
        for (const WorldPoint point : ring.points) {
            line.push_back(mapPoint(point, geometry.origin));
            low = {std::min(low.x, point.x), std::min(low.y, point.y)};
            high = {std::max(high.x, point.x), std::max(high.y, point.y)};
        }
        geometry.boundary.add(line, true);
    }
    geometry.bounds = QGeoRectangle{coordinate(low), coordinate(high)};
    addProblem(geometry, problem);
    return geometry;
}

PlanGeometry fieldGeometry(const Field& field, const std::optional<GeoPoint>& problem) {
    PlanGeometry geometry = boundaryGeometry(field, MapFrame{field.frame()});
    addProblem(geometry, problem);
    return geometry;
}

PlanGeometry planGeometry(const Plan& plan) {
    const MapFrame frame{plan.field().frame()};
    PlanGeometry geometry = boundaryGeometry(plan.field(), frame);

    MapRings strip = ringsOf(frame, plan.field().workable());
    const MapRings mainland = ringsOf(frame, plan.headland.mainland);
    if (plan.headland.width.si() > 0.0) {
        addRings(geometry.mainlandEdge, mainland);
        strip.insert(strip.end(), mainland.begin(), mainland.end());
        geometry.headland = evenOddTriangles(strip);
    }
    geometry.mainland = evenOddTriangles(mainland);
    addMeasured(geometry, frame, plan);
    geometry.swathSpacing = plan.request.machine.operatingWidth().si() * geometry.unitsPerMetre;
    for (const Swath& swath : plan.swaths.swaths) {
        std::vector<MapPoint> line;
        for (const Point& point : middleLine(swath)) {
            line.push_back(frame.map(point));
        }
        geometry.swaths.add(line);
        if (swath.tramline) {
            geometry.tramlines.add(line);
        }
    }
    addWaysBeyondSwaths(geometry, frame, plan);
    addPath(geometry, frame, plan.path);
    if (plan.refill) {
        geometry.refillPoints = frame.map(plan.refill->points);
    }
    for (const Cell& cell : plan.cells.cells) {
        geometry.cells.push_back(ringsOf(frame, MultiPolygon{cell.outline}));
    }
    for (const Finding& finding : plan.findings) {
        geometry.findings.push_back({frame.map(finding.place), weightOf(finding)});
        geometry.findingPlaces.push_back(coordinate(frame.geo(finding.place)));
    }
    return geometry;
}

}  // namespace furrow
