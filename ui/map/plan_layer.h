#pragma once

#include "ui/map/map_layer.h"
#include "ui/map/plan_scene.h"

namespace furrow {

/// Draws a field and its plan over the map: everything of it in one item.
class PlanLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::PlanDrawing drawing READ drawing WRITE setDrawing NOTIFY drawingChanged FINAL)
    Q_PROPERTY(furrow::PlanStyle style READ style WRITE setStyle NOTIFY styleChanged FINAL)

public:
    explicit PlanLayer(QQuickItem* parent = nullptr) : MapLayer{parent} {}

    const PlanDrawing& drawing() const { return drawing_; }
    void setDrawing(const PlanDrawing& drawing);
    const PlanStyle& style() const { return style_; }
    void setStyle(const PlanStyle& style);

    /// The finding under this place of the item, or -1.
    Q_INVOKABLE int findingAt(QPointF pixel) const;

signals:
    void drawingChanged();
    void styleChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    PlanView view() const;

    PlanDrawing drawing_;
    PlanStyle style_;
};

}  // namespace furrow
