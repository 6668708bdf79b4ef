#include "ui/drive/worked_layer.h"

#include "ui/drive/worked_scene.h"

namespace furrow {

WorkedLayer::WorkedLayer(QQuickItem* parent) : MapLayer{parent} {
    connect(this, &WorkedLayer::styleChanged, this, &QQuickItem::update);
}

void WorkedLayer::setDrive(DriveThrough* drive) {
    if (drive == drive_) {
        return;
    }
    if (drive_ != nullptr) {
        drive_->disconnect(this);
    }
    drive_ = drive;
    if (drive_ != nullptr) {
        connect(drive_, &DriveThrough::moved, this, &QQuickItem::update);
    }
    emit driveChanged();
    update();
}

QSGNode* WorkedLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* scene = static_cast<WorkedScene*>(old);
    if (scene == nullptr) {
        scene = new WorkedScene;
    }
    if (drive_ == nullptr || !drive_->isUnderWay()) {
        scene->hide();
        return scene;
    }
    scene->setStrips(drive_->strips());
    scene->setColor(color_);
    scene->setWorked(drive_->course()->stationBefore(drive_->state().time), drive_->state());
    scene->setMatrix(matrixFor(MapFrame{drive_->plan()->field().frame()}.origin()));
    return scene;
}

}  // namespace furrow
