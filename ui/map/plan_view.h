#pragma once

#include "ui/map/mesh.h"

#include <QMatrix4x4>
#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace furrow {

/// Where the camera is, as the layers of a plan need it.
struct PlanView {
    QMatrix4x4 matrix;
    QRectF visible;  ///< in units
    QSizeF size;     ///< of the item
    double pixelsPerUnit = 1.0;
    double devicePixelRatio = 1.0;

    QPointF toItem(MapPoint place) const {
        return {double{matrix(0, 3)} + double{place.x} * pixelsPerUnit,
                double{matrix(1, 3)} + double{place.y} * pixelsPerUnit};
    }
    bool shows(MapPoint place) const { return visible.contains(QPointF{double{place.x}, double{place.y}}); }
};

}  // namespace furrow
