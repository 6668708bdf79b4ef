#pragma once

#include "ui/drive/drive_scene.h"
#include "ui/drive/drive_through.h"
#include "ui/map/map_layer.h"

#include <QPointer>

namespace furrow {

/// Draws the machine on its drive.
class DriveLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::DriveThrough* drive READ drive WRITE setDrive NOTIFY driveChanged REQUIRED FINAL)
    Q_PROPERTY(QColor bodyColor MEMBER bodyColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor wheelColor MEMBER wheelColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor implementColor MEMBER implementColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor casingColor MEMBER casingColor_ NOTIFY styleChanged FINAL)

public:
    explicit DriveLayer(QQuickItem* parent = nullptr);

    DriveThrough* drive() const { return drive_; }
    void setDrive(DriveThrough* drive);

signals:
    void driveChanged();
    void styleChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    QPointer<DriveThrough> drive_;
    QColor bodyColor_;
    QColor wheelColor_;
    QColor implementColor_;
    QColor casingColor_;
};

}  // namespace furrow
