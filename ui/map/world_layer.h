#pragma once

#include "ui/map/map_layer.h"
#include "ui/map/world_outline.h"

#include <QColor>

namespace furrow {

/// The ground under the plan: land, sea, borders and a grid of longitude and latitude. Close to the ground
/// the outline is left out, because it is a kilometre off there.
class WorldLayer : public MapLayer {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(QColor landColor MEMBER landColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor coastColor MEMBER coastColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(QColor gridColor MEMBER gridColor_ NOTIFY styleChanged FINAL)
    Q_PROPERTY(bool loaded READ isLoaded NOTIFY loadedChanged FINAL)

public:
    explicit WorldLayer(QQuickItem* parent = nullptr);

    bool isLoaded() const { return outline_ != nullptr; }

signals:
    void styleChanged();
    void loadedChanged();

protected:
    QSGNode* updatePaintNode(QSGNode* old, UpdatePaintNodeData* data) override;

private:
    std::shared_ptr<const WorldOutline> outline_;
    QColor landColor_;
    QColor coastColor_;
    QColor gridColor_;
};

}  // namespace furrow
