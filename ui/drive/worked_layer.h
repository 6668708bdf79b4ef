#pragma once

#include "ui/drive/drive_through.h"
#include "ui/map/map_layer.h"

#include <QColor>
#include <QPointer>

namespace furrow {

/// Draws the land that the drive has worked. Opaque, so that what is worked twice, or crossed by the boom as
/// it swings back in a turn, looks as what is worked once: a picture of the item is what may be transparent.
class WorkedLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::DriveThrough* drive READ drive WRITE setDrive NOTIFY driveChanged REQUIRED FINAL)
    Q_PROPERTY(QColor color MEMBER color_ NOTIFY styleChanged FINAL)

public:
    explicit WorkedLayer(QQuickItem* parent = nullptr);

    DriveThrough* drive() const { return drive_; }
    void setDrive(DriveThrough* drive);

signals:
    void driveChanged();
    void styleChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    QPointer<DriveThrough> drive_;
    QColor color_;
};

}  // namespace furrow
