#pragma once

#include "ui/drive/machine_shape_drawing.h"
#include "ui/map/mesh_nodes.h"

#include <QSGTransformNode>

namespace furrow {

/// How the drive looks.
struct DriveStyle {
    QColor body;
    QColor wheels;
    QColor implement;
    QColor casing;

    friend bool operator==(const DriveStyle&, const DriveStyle&) = default;
};

/// The machine. Lives in the render thread.
class DriveScene : public QSGTransformNode {
public:
    DriveScene();

    void setMachine(const MachineShapeDrawing& drawing, Carried carried);
    void hide();
    void setStyle(const DriveStyle& style);
    void setScale(double pixelsPerUnit, double devicePixelRatio);

private:
    void styleMachine();

    DriveStyle style_;
    Carried carried_ = Carried::Up;
    LineNode* drawbar_ = new LineNode;
    FillNode* implement_ = new FillNode;
    LineNode* implementCasing_ = new LineNode;
    LineNode* implementOutline_ = new LineNode;
    LineNode* casing_ = new LineNode;
    FillNode* wheels_ = new FillNode;
    FillNode* body_ = new FillNode;
    LineNode* outline_ = new LineNode;
};

}  // namespace furrow
