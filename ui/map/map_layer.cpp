#include "ui/map/map_layer.h"

#include <QQuickWindow>

#include <cmath>

namespace furrow {

MapLayer::MapLayer(QQuickItem* parent) : QQuickItem{parent} {
    setFlag(ItemHasContents);
    connect(this, &QQuickItem::widthChanged, this, &QQuickItem::update);
    connect(this, &QQuickItem::heightChanged, this, &QQuickItem::update);
}

void MapLayer::setCamera(MapCamera* camera) {
    if (camera == camera_) {
        return;
    }
    if (camera_ != nullptr) {
        camera_->disconnect(this);
    }
    camera_ = camera;
    if (camera_ != nullptr) {
        connect(camera_, &MapCamera::changed, this, &QQuickItem::update);
    }
    update();
    emit cameraChanged();
}

QMatrix4x4 MapLayer::matrixFor(WorldPoint origin, int turns) const {
    const double scale = camera_->scale();
    WorldPoint way = origin - camera_->worldCenter();
    way.x += turns - std::round(way.x);
    const double unit = pixelsPerUnit();
    return QMatrix4x4{static_cast<float>(unit),
                      0.0F,
                      0.0F,
                      static_cast<float>(width() / 2.0 + way.x * scale),
                      0.0F,
                      static_cast<float>(unit),
                      0.0F,
                      static_cast<float>(height() / 2.0 + way.y * scale),
                      0.0F,
                      0.0F,
                      1.0F,
                      0.0F,
                      0.0F,
                      0.0F,
                      0.0F,
                      1.0F};
}

QRectF MapLayer::viewIn(WorldPoint origin, double margin) const {
    WorldPoint way = camera_->worldCenter() - origin;
    way.x -= std::round(way.x);
    const double unit = pixelsPerUnit();
    const double halfWidth = (width() / 2.0 + margin) / unit;
    const double halfHeight = (height() / 2.0 + margin) / unit;
    return {way.x * kUnitsPerWorld - halfWidth, way.y * kUnitsPerWorld - halfHeight, 2.0 * halfWidth,
            2.0 * halfHeight};
}

double MapLayer::devicePixelRatio() const {
    return window() != nullptr ? window()->effectiveDevicePixelRatio() : 1.0;
}

}  // namespace furrow
