#include "ui/drive/drive_layer.h"

namespace furrow {

namespace {

// A machine is seen from afar, too.
constexpr double kLeastPx = 22.0;

}  // namespace

DriveLayer::DriveLayer(QQuickItem* parent) : MapLayer{parent} {
    connect(this, &DriveLayer::styleChanged, this, &QQuickItem::update);
}

void DriveLayer::setDrive(DriveThrough* drive) {
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

QSGNode* DriveLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* scene = static_cast<DriveScene*>(old);
    if (scene == nullptr) {
        scene = new DriveScene;
    }
    if (drive_ == nullptr || !drive_->isUnderWay()) {
        scene->hide();
        return scene;
    }
    const MapFrame frame{drive_->plan()->field().frame()};
    scene->setStyle(
        {.body = bodyColor_, .wheels = wheelColor_, .implement = implementColor_, .casing = casingColor_});
    const DriveState& state = drive_->state();
    const double metresPerPixel = 1.0 / (pixelsPerUnit() * frame.unitsPerMetre());
    scene->setMachine(machineDrawing(drive_->plan()->request.machine, state, drive_->carried(), frame,
                                     metres(kLeastPx * metresPerPixel)),
                      drive_->carried());
    scene->setMatrix(matrixFor(frame.origin()));
    scene->setScale(pixelsPerUnit(), devicePixelRatio());
    return scene;
}

}  // namespace furrow
