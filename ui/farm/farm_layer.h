#pragma once

#include "ui/farm/farm_list.h"
#include "ui/map/map_layer.h"
#include "ui/map/mesh.h"

#include <QColor>
#include <QPointer>

namespace furrow {

/// Draws the outlines of the farm's fields but for the one that is worked on, and fills those that are
/// selected.
class FarmLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::FarmList* fields READ fields WRITE setFields NOTIFY fieldsChanged REQUIRED FINAL)
    /// With what is selected, as while the list is in view.
    Q_PROPERTY(bool showSelection MEMBER showSelection_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor lineColor MEMBER lineColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor casingColor MEMBER casingColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor selectionColor MEMBER selectionColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineFactor MEMBER lineFactor_ NOTIFY styleChanged FINAL)

public:
    explicit FarmLayer(QQuickItem* parent = nullptr);

    FarmList* fields() const { return fields_; }
    void setFields(FarmList* fields);

signals:
    void fieldsChanged();
    void styleChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    /// What is drawn has changed.
    void draw();

    QPointer<FarmList> fields_;
    WorldPoint origin_;
    LineMesh outlines_;
    LineMesh selectedOutlines_;
    FillMesh selected_;
    bool stale_ = true;
    bool showSelection_ = false;
    QColor lineColor_;
    QColor casingColor_;
    QColor selectionColor_;
    double lineFactor_ = 1.0;
};

}  // namespace furrow
