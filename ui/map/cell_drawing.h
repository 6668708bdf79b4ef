#pragma once

#include "planner/geodesy/local_frame.h"
#include "planner/geometry/polygon.h"
#include "ui/map/mesh.h"

#include <QtQml/qqmlregistration.h>
#include <QObject>

#include <memory>

namespace furrow {

/// Cells of the mainland at one step of a decomposition, triangulated; lengths in units around `origin`.
/// Immutable.
struct CellGeometry {
    WorldPoint origin;
    FillMesh cells;
    LineMesh edges;
    FillMesh joined;  ///< the two that have just become one
    LineMesh joinedEdges;
};

CellGeometry cellGeometry(const LocalFrame& frame, const std::vector<MultiPolygon>& cells,
                          const std::vector<MultiPolygon>& joined);

/// The geometry as QML passes it on.
class CellDrawing {
    Q_GADGET
    QML_VALUE_TYPE(cellDrawing)

public:
    CellDrawing() = default;
    explicit CellDrawing(CellGeometry geometry)
        : geometry_{std::make_shared<const CellGeometry>(std::move(geometry))} {}

    const std::shared_ptr<const CellGeometry>& geometry() const { return geometry_; }

    friend bool operator==(const CellDrawing&, const CellDrawing&) = default;

private:
    std::shared_ptr<const CellGeometry> geometry_;
};

}  // namespace furrow
