#pragma once

#include "planner/plan/plan.h"
#include "ui/map/mesh.h"

#include <QtQml/qqmlregistration.h>
#include <QGeoRectangle>
#include <QObject>

#include <array>
#include <memory>
#include <optional>

namespace furrow {

enum class PathKind { Work, HeadlandPass, Turn, Transfer, Reverse, Undrivable };

/// A piece of the path, drawn as one node: the unit of culling and of level of detail.
struct PathChunk {
    /// Level 0 has every point, each next one is four times as coarse.
    static constexpr std::size_t kLevels = 4;
    /// Of the first coarse level, m.
    static constexpr double kToleranceM = 0.1;

    PathKind kind = PathKind::Turn;
    QRectF box;
    std::array<LineMesh, kLevels> levels;
};

/// Where an arrow may be drawn: along a swath or at the middle of a turn.
struct DirectionMark {
    MapPoint from;
    MapPoint to;
    bool onSwath = true;
    int number = 0;  ///< of the swath
};

struct NumberMark {
    int number = 0;  ///< of the swath, as it is called everywhere
    int order = 0;   ///< in which it is driven, from 1
    MapPoint place;
    MapPoint begin;  ///< near where it begins
};

/// A segment of the path.
struct PathLine {
    PathKind kind = PathKind::Turn;
    std::vector<MapPoint> points;
};

struct FindingPlace {
    MapPoint place;
    Weight weight = Weight::Look;
};

/// A ring as it can be edited: part and ring number as in FieldSource, ring 0 is the outer one.
struct EditableRing {
    int part = 0;
    int ring = 0;
    std::vector<WorldPoint> points;
};

/// Everything the map shows of a field and its plan, converted and triangulated away from the GUI thread.
/// Immutable; lengths in units around `origin`.
struct PlanGeometry {
    WorldPoint origin;
    double unitsPerMetre = 1.0;
    QGeoRectangle bounds;
    std::vector<EditableRing> rings;
    LineMesh boundary;
    FillMesh obstacles;
    LineMesh obstacleEdges;
    FillMesh headland;
    FillMesh mainland;
    LineMesh mainlandEdge;
    FillMesh covered;  ///< worked, as the audit measured it
    FillMesh overlap;  ///< worked twice
    FillMesh missed;
    FillMesh wheels;  ///< driven over often
    LineMesh swaths;
    LineMesh beyondSwaths;  ///< ways of the machine from the end of a swath to where it lifts the implement
    LineMesh tramlines;     ///< of these, those that are driven on again
    double swathSpacing = 0.0;
    std::vector<PathChunk> chunks;
    std::vector<PathLine> segments;                         ///< of the path
    std::vector<std::vector<std::vector<MapPoint>>> cells;  ///< the rings of each
    std::vector<DirectionMark> directions;
    std::vector<NumberMark> numbers;  ///< by number
    std::optional<MapPoint> start;
    std::optional<MapPoint> end;
    std::vector<MapPoint> refillPoints;
    std::vector<FindingPlace> findings;
    std::vector<QGeoCoordinate> findingPlaces;
};

/// A boundary that could not be used, as far as it can be drawn, and where the problem is.
PlanGeometry outlineGeometry(const FieldSource& source, const std::optional<GeoPoint>& problem);
/// A field without a plan, and where the problem is.
PlanGeometry fieldGeometry(const Field& field, const std::optional<GeoPoint>& problem);
/// A field with its plan. Cost: O(n log n) for n points.
PlanGeometry planGeometry(const Plan& plan);

/// The geometry as QML passes it on.
class PlanDrawing {
    Q_GADGET
    QML_VALUE_TYPE(planDrawing)
    Q_PROPERTY(bool empty READ isEmpty FINAL)
    Q_PROPERTY(QGeoRectangle bounds READ bounds FINAL)

public:
    PlanDrawing() = default;
    explicit PlanDrawing(PlanGeometry geometry)
        : geometry_{std::make_shared<const PlanGeometry>(std::move(geometry))} {}

    bool isEmpty() const { return geometry_ == nullptr; }
    QGeoRectangle bounds() const { return geometry_ ? geometry_->bounds : QGeoRectangle{}; }
    const std::shared_ptr<const PlanGeometry>& geometry() const { return geometry_; }

    friend bool operator==(const PlanDrawing&, const PlanDrawing&) = default;

private:
    std::shared_ptr<const PlanGeometry> geometry_;
};

}  // namespace furrow
