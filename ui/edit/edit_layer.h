#pragma once

#include "ui/edit/field_editor.h"
#include "ui/map/map_layer.h"

#include <QColor>

#include <vector>

namespace furrow {

/// Takes the mouse on the map: moves and zooms it, and hands places to the editor. Draws what is being
/// edited; the plan follows in its own layer.
class EditLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::FieldEditor* editor READ editor WRITE setEditor NOTIFY editorChanged REQUIRED FINAL)
    Q_PROPERTY(QColor lineColor MEMBER lineColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor casingColor MEMBER casingColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor handleColor MEMBER handleColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor accentColor MEMBER accentColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor guideColor MEMBER guideColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor obstacleColor MEMBER obstacleColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineFactor MEMBER lineFactor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor splitColor MEMBER splitColor_ NOTIFY styleChanged FINAL)

public:
    explicit EditLayer(QQuickItem* parent = nullptr);

    FieldEditor* editor() const { return editor_; }
    void setEditor(FieldEditor* editor);
    /// What was clicked is dealt with: the editor need not look for it.
    Q_INVOKABLE void accept() { handled_ = true; }
    /// How near a traced line is kept to at this zoom, m.
    Q_INVOKABLE double traceTolerance() const;

signals:
    void editorChanged();
    void styleChanged();
    /// A click in the select tool, before the editor looks what it met.
    void clicked(QPointF pixel);

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseUngrabEvent() override;
    void hoverMoveEvent(QHoverEvent* event) override;
    void hoverLeaveEvent(QHoverEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    /// The marks of what is edited, in pixels of the item.
    struct Marks;
    Marks marks() const;
    void addSelection(Marks& marks) const;
    /// Vertices and middles of edges of the outline that is selected.
    void addHandles(Marks& marks, const std::vector<MapPoint>& pixels, bool closed) const;
    /// Those of one outline that are selected or near the pointer.
    void addVertices(Marks& marks, const OutlineId& id, const std::vector<MapPoint>& pixels) const;
    void addSketch(Marks& marks) const;
    QPointF pixelOf(Point place) const;
    QPointF pixelOf(const Outline& outline, std::size_t vertex) const;
    FieldEditor::Pointer pointerAt(QPointF pixel, Qt::KeyboardModifiers modifiers) const;
    void showCursor();
    void convert();

    FieldEditor* editor_ = nullptr;
    /// Of the shape's outlines, converted once for each change.
    std::vector<std::vector<WorldPoint>> world_;
    bool handled_ = false;
    bool grabbed_ = false;
    /// Whether the mouse moved far enough to be a drag.
    bool moved_ = false;
    bool pointerInside_ = false;
    QPointF pressed_;
    QPointF pointer_;
    QColor lineColor_;
    QColor casingColor_;
    QColor handleColor_;
    QColor accentColor_;
    QColor guideColor_;
    QColor obstacleColor_;
    QColor splitColor_;
    double lineFactor_ = 1.0;
};

}  // namespace furrow
