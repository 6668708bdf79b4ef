#pragma once

#include "ui/driven/driven_track.h"
#include "ui/map/map_layer.h"

#include <QColor>
#include <QList>
#include <QPointer>

namespace furrow {

/// Draws a recorded track over the plan: the farther from it, the thicker and in another colour; dashed where
/// it is off the plan. Missed land is hatched.
class DrivenLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(furrow::DrivenTrack* track READ track WRITE setTrack NOTIFY trackChanged REQUIRED FINAL)
    /// One for each step of the track.
    Q_PROPERTY(QList<QColor> colors MEMBER colors_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor casingColor MEMBER casingColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor missedColor MEMBER missedColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(double lineFactor MEMBER lineFactor_ NOTIFY styleChanged FINAL)

public:
    explicit DrivenLayer(QQuickItem* parent = nullptr);

    DrivenTrack* track() const { return track_; }
    void setTrack(DrivenTrack* track);

signals:
    void trackChanged();
    void styleChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    QPointer<DrivenTrack> track_;
    bool stale_ = true;
    QList<QColor> colors_;
    QColor casingColor_;
    QColor missedColor_;
    double lineFactor_ = 1.0;
};

}  // namespace furrow
