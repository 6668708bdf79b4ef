#pragma once

#include "ui/map/cell_drawing.h"
#include "ui/map/map_layer.h"

#include <QColor>

namespace furrow {

/// Draws cells over the plan: each with its outline and a soft fill, two that have just become one hatched.
class CellLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::CellDrawing drawing READ drawing WRITE setDrawing NOTIFY drawingChanged FINAL)
    Q_PROPERTY(QColor color MEMBER color_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor fillColor MEMBER fillColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor casingColor MEMBER casingColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor joinedColor MEMBER joinedColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineFactor MEMBER lineFactor_ NOTIFY styleChanged FINAL)

public:
    explicit CellLayer(QQuickItem* parent = nullptr);

    const CellDrawing& drawing() const { return drawing_; }
    void setDrawing(const CellDrawing& drawing);

signals:
    void drawingChanged();
    void styleChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    CellDrawing drawing_;
    QColor color_;
    QColor fillColor_;
    QColor casingColor_;
    QColor joinedColor_;
    double lineFactor_ = 1.0;
};

}  // namespace furrow
