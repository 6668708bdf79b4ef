#pragma once

#include "ui/drive/machine_shape_drawing.h"
#include "ui/drive/worked_strips.h"
#include "ui/map/mesh_nodes.h"

#include <QSGTransformNode>

#include <memory>
#include <vector>

namespace furrow {

/// How the drive looks.
struct DriveStyle {
    QColor worked;
    QColor body;
    QColor wheels;
    QColor implement;
    QColor casing;

    friend bool operator==(const DriveStyle&, const DriveStyle&) = default;
};

/// Lowest first: worked land in pieces, the piece that is being worked, the machine. Lives in the render
/// thread.
class DriveScene : public QSGTransformNode {
public:
    DriveScene();

    void setStrips(std::shared_ptr<const WorkedStrips> strips);
    /// Worked land up to this moment.
    void setWorked(std::size_t station, const DriveState& state);
    void setMachine(const MachineShapeDrawing& drawing, Carried carried);
    void hide();
    void setStyle(const DriveStyle& style);
    void setScale(double pixelsPerUnit, double devicePixelRatio);

private:
    void styleMachine();

    std::shared_ptr<const WorkedStrips> strips_;
    DriveStyle style_;
    Carried carried_ = Carried::Up;
    QSGNode* ground_ = new QSGNode;
    std::vector<FillNode*> pieces_;  ///< made when the drive first comes to them
    FillNode* begun_ = new FillNode;
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
