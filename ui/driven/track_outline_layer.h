#pragma once

#include "ui/driven/field_from_track.h"
#include "ui/map/map_layer.h"

#include <QColor>
#include <QPointer>

namespace furrow {

/// Draws a recorded track and the field that would be made from it.
class TrackOutlineLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::FieldFromTrack* source READ source WRITE setSource NOTIFY sourceChanged REQUIRED FINAL)
    Q_PROPERTY(QColor lineColor MEMBER lineColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor casingColor MEMBER casingColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor fillColor MEMBER fillColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor trackColor MEMBER trackColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineFactor MEMBER lineFactor_ NOTIFY styleChanged FINAL)

public:
    explicit TrackOutlineLayer(QQuickItem* parent = nullptr);

    FieldFromTrack* source() const { return source_; }
    void setSource(FieldFromTrack* source);

signals:
    void sourceChanged();
    void styleChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    QPointer<FieldFromTrack> source_;
    bool stale_ = true;
    QColor lineColor_;
    QColor casingColor_;
    QColor fillColor_;
    QColor trackColor_;
    double lineFactor_ = 1.0;
};

}  // namespace furrow
