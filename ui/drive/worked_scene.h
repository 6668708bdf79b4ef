#pragma once

#include "ui/drive/worked_strips.h"
#include "ui/map/mesh_nodes.h"

#include <QSGTransformNode>

#include <memory>
#include <vector>

namespace furrow {

/// Worked land in pieces, and the piece that is being worked, opaque. Lives in the render thread.
class WorkedScene : public QSGTransformNode {
public:
    WorkedScene() { appendChildNode(begun_); }

    void setStrips(std::shared_ptr<const WorkedStrips> strips);
    /// Up to this moment.
    void setWorked(std::size_t station, const DriveState& state);
    void hide();
    void setColor(const QColor& color);

private:
    std::shared_ptr<const WorkedStrips> strips_;
    QColor color_;
    std::vector<FillNode*> pieces_;  ///< made when the drive first comes to them
    FillNode* begun_ = new FillNode;
};

}  // namespace furrow
