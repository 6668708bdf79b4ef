#include "ui/map/cell_layer.h"

#include "ui/map/mesh_nodes.h"

#include <QSGTransformNode>

namespace furrow {

namespace {

/// Lowest first: fills, then lines over a casing. Lives in the render thread.
class CellScene : public QSGTransformNode {
public:
    CellScene() {
        for (QSGNode* node : std::initializer_list<QSGNode*>{fill_, joined_, casing_, edges_, joinedEdges_}) {
            appendChildNode(node);
        }
    }
    void setGeometry(std::shared_ptr<const CellGeometry> geometry) {
        if (geometry == geometry_) {
            return;
        }
        geometry_ = std::move(geometry);
        static const CellGeometry none;
        const CellGeometry& shown = geometry_ ? *geometry_ : none;
        fill_->setMesh(shown.cells);
        joined_->setMesh(shown.joined);
        casing_->setMesh(shown.edges);
        edges_->setMesh(shown.edges);
        joinedEdges_->setMesh(shown.joinedEdges);
    }
    void setStyle(const QColor& color, QColor fill, const QColor& casing, const QColor& joined,
                  double factor) {
        casing_->setStyle({.color = casing, .widthPx = 4.4 * factor});
        edges_->setStyle({.color = color, .widthPx = 2.0 * factor});
        joinedEdges_->setStyle({.color = joined, .widthPx = 3.0 * factor, .dashPx = 8.0, .periodPx = 13.0});
        joined_->setStyle(joined, 7.0);
        fill.setAlphaF(0.16F);
        fill_->setStyle(fill);
    }
    void setScale(double pixelsPerUnit, double devicePixelRatio) {
        for (FillNode* fill : {fill_, joined_}) {
            fill->setScale(pixelsPerUnit, devicePixelRatio);
        }
        for (LineNode* line : {casing_, edges_, joinedEdges_}) {
            line->setScale(pixelsPerUnit, devicePixelRatio);
        }
    }

private:
    std::shared_ptr<const CellGeometry> geometry_;
    FillNode* fill_ = new FillNode;
    FillNode* joined_ = new FillNode;
    LineNode* casing_ = new LineNode;
    LineNode* edges_ = new LineNode;
    LineNode* joinedEdges_ = new LineNode;
};

}  // namespace

CellLayer::CellLayer(QQuickItem* parent) : MapLayer{parent} {
    connect(this, &CellLayer::styleChanged, this, &QQuickItem::update);
}

void CellLayer::setDrawing(const CellDrawing& drawing) {
    if (drawing == drawing_) {
        return;
    }
    drawing_ = drawing;
    update();
    emit drawingChanged();
}

QSGNode* CellLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* scene = static_cast<CellScene*>(old);
    if (scene == nullptr) {
        scene = new CellScene;
    }
    scene->setGeometry(drawing_.geometry());
    scene->setStyle(color_, fillColor_, casingColor_, joinedColor_, lineFactor_);
    scene->setMatrix(matrixFor(drawing_.geometry() ? drawing_.geometry()->origin : WorldPoint{}));
    scene->setScale(pixelsPerUnit(), devicePixelRatio());
    return scene;
}

}  // namespace furrow
