#pragma once

#include "ui/map/map_layer.h"
#include "ui/map/plan_drawing.h"

#include <QColor>

#include <optional>

namespace furrow {

/// Takes the mouse on the map: pans and zooms, draws a boundary by clicking, drags its vertices. Draws what is
/// being edited; the plan follows in its own layer.
class EditLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::PlanDrawing drawing READ drawing WRITE setDrawing NOTIFY drawingChanged FINAL)
    Q_PROPERTY(Tool tool READ tool WRITE setTool NOTIFY toolChanged FINAL)
    Q_PROPERTY(int draftCount READ draftCount NOTIFY draftChanged FINAL)
    Q_PROPERTY(double draftLengthM READ draftLengthM NOTIFY draftChanged FINAL)
    Q_PROPERTY(bool dragging READ isDragging NOTIFY draggingChanged FINAL)
    Q_PROPERTY(QColor lineColor MEMBER lineColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor casingColor MEMBER casingColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor handleColor MEMBER handleColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor accentColor MEMBER accentColor_ NOTIFY styleChanged FINAL)

public:
    enum class Tool { Select, Draw };
    Q_ENUM(Tool)

    explicit EditLayer(QQuickItem* parent = nullptr);

    const PlanDrawing& drawing() const { return drawing_; }
    void setDrawing(const PlanDrawing& drawing);
    Tool tool() const { return tool_; }
    void setTool(Tool tool);
    int draftCount() const { return static_cast<int>(draft_.size()); }
    /// From the last point of the draft to the pointer.
    double draftLengthM() const;
    bool isDragging() const { return grabbed_.has_value(); }

    /// Ends drawing: with three points or more the boundary is handed over, otherwise nothing happens.
    Q_INVOKABLE void finishDraft();
    Q_INVOKABLE void cancelDraft();
    Q_INVOKABLE void removeLastPoint();

signals:
    void drawingChanged();
    void toolChanged();
    void draftChanged();
    void draggingChanged();
    void styleChanged();
    /// A click that met no vertex.
    void clicked(QPointF pixel);
    /// A new boundary, in the order of its clicks.
    void boundaryDrawn(const QList<QGeoCoordinate>& points);
    /// A vertex is (or was, when finished) dragged. Part and ring as in FieldSource.
    void vertexMoved(int part, int ring, int vertex, const QGeoCoordinate& place, bool finished);

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseUngrabEvent() override;
    void hoverMoveEvent(QHoverEvent* event) override;
    void hoverLeaveEvent(QHoverEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    struct Vertex {
        std::size_t ring;
        std::size_t index;
        friend bool operator==(const Vertex&, const Vertex&) = default;
    };
    std::optional<Vertex> vertexAt(QPointF pixel) const;
    void setHovered(std::optional<Vertex> vertex);
    void moveGrabbed(QPointF pixel, bool finished);
    void release(QPointF pixel);

    PlanDrawing drawing_;
    Tool tool_ = Tool::Select;
    std::vector<EditableRing> rings_;
    std::vector<WorldPoint> draft_;
    std::optional<Vertex> hovered_;
    std::optional<Vertex> grabbed_;
    /// Whether the mouse moved far enough to be a drag.
    bool moved_ = false;
    QPointF pressed_;
    QPointF pointer_;
    bool pointerInside_ = false;
    QColor lineColor_;
    QColor casingColor_;
    QColor handleColor_;
    QColor accentColor_;
};

}  // namespace furrow
