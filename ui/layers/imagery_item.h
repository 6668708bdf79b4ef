#pragma once

#include "ui/layers/imagery_model.h"
#include "ui/map/map_layer.h"

namespace furrow {

/// Draws the project's imagery under the map. While a tile is read, the part of a coarser one that lies there
/// is shown in its place.
class ImageryItem : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(
        furrow::ImageryModel* imagery READ imagery WRITE setImagery NOTIFY imageryChanged REQUIRED FINAL)

public:
    explicit ImageryItem(QQuickItem* parent = nullptr) : MapLayer{parent} {}

    ImageryModel* imagery() const { return imagery_; }
    void setImagery(ImageryModel* imagery);

signals:
    void imageryChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    ImageryModel* imagery_ = nullptr;
};

}  // namespace furrow
