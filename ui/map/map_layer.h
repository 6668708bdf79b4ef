#pragma once

#include "ui/map/map_camera.h"

#include <QtQml/qqmlregistration.h>
#include <QMatrix4x4>
#include <QQuickItem>

namespace furrow {

/// An item that draws over the whole map in the scene graph and follows its camera.
class MapLayer : public QQuickItem {
    Q_OBJECT
    QML_ANONYMOUS
    Q_PROPERTY(furrow::MapCamera* camera READ camera WRITE setCamera NOTIFY cameraChanged REQUIRED FINAL)

public:
    explicit MapLayer(QQuickItem* parent = nullptr);

    MapCamera* camera() const { return camera_; }
    void setCamera(MapCamera* camera);

signals:
    void cameraChanged();

protected:
    /// From units around `origin` to pixels of this item, `turns` worlds further east.
    QMatrix4x4 matrixFor(WorldPoint origin, int turns = 0) const;
    /// Pixels of this item in one unit.
    double pixelsPerUnit() const { return camera_->scale() / kUnitsPerWorld; }
    /// What is in view, in units around `origin`, with a margin of pixels.
    QRectF viewIn(WorldPoint origin, double margin) const;
    double devicePixelRatio() const;

private:
    MapCamera* camera_ = nullptr;
};

}  // namespace furrow
