#include "ui/farm/farm_layer.h"

#include "ui/map/even_odd_fill.h"
#include "ui/map/mesh_nodes.h"

#include <QSGTransformNode>

namespace furrow {

namespace {

/// Lowest first. Lives in the render thread.
class FarmScene : public QSGTransformNode {
public:
    FarmScene() {
        for (QSGNode* node : std::initializer_list<QSGNode*>{fill, casing, lines, selectedLines}) {
            appendChildNode(node);
        }
    }
    void setScale(double pixelsPerUnit, double devicePixelRatio) const {
        fill->setScale(pixelsPerUnit, devicePixelRatio);
        for (LineNode* line : {casing, lines, selectedLines}) {
            line->setScale(pixelsPerUnit, devicePixelRatio);
        }
    }

    FillNode* const fill = new FillNode;
    LineNode* const casing = new LineNode;
    LineNode* const lines = new LineNode;
    LineNode* const selectedLines = new LineNode;
};

std::vector<std::vector<MapPoint>> ringsOf(const FieldSource& source, WorldPoint origin) {
    std::vector<std::vector<MapPoint>> rings;
    const auto add = [&](const GeoRing& ring) {
        auto& points = rings.emplace_back();
        for (const GeoPoint& point : ring) {
            points.push_back(mapPoint(worldPoint(point), origin));
        }
    };
    for (const GeoPolygon& part : source.parts) {
        add(part.outer);
        std::ranges::for_each(part.holes, add);
    }
    return rings;
}

}  // namespace

FarmLayer::FarmLayer(QQuickItem* parent) : MapLayer{parent} {
    connect(this, &FarmLayer::styleChanged, this, &QQuickItem::update);
}

void FarmLayer::setFields(FarmList* fields) {
    if (fields == fields_) {
        return;
    }
    if (fields_ != nullptr) {
        fields_->disconnect(this);
    }
    fields_ = fields;
    if (fields_ != nullptr) {
        connect(fields_, &QAbstractItemModel::dataChanged, this, &FarmLayer::draw);
        connect(fields_, &QAbstractItemModel::modelReset, this, &FarmLayer::draw);
    }
    draw();
    emit fieldsChanged();
}

void FarmLayer::draw() {
    outlines_ = {};
    selectedOutlines_ = {};
    selected_.clear();
    stale_ = true;
    const int count = fields_ == nullptr ? 0 : fields_->count();
    for (int row = 0; row < count; ++row) {
        const FieldSource& source = *fields_->field(row).source;
        if (row == 0) {
            origin_ = source.parts.empty() || source.parts.front().outer.empty()
                          ? WorldPoint{}
                          : worldPoint(source.parts.front().outer.front());
        }
        const bool selected = fields_->isSelected(row);
        if (!selected && row == fields_->rowOfCurrent()) {
            continue;  // the plan has it
        }
        const auto rings = ringsOf(source, origin_);
        for (const auto& ring : rings) {
            (selected ? selectedOutlines_ : outlines_).add(ring, true);
        }
        if (selected) {
            const FillMesh fill = evenOddTriangles(rings);
            selected_.insert(selected_.end(), fill.begin(), fill.end());
        }
    }
    update();
}

QSGNode* FarmLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* scene = static_cast<FarmScene*>(old);
    if (scene == nullptr) {
        scene = new FarmScene;
        stale_ = true;
    }
    if (std::exchange(stale_, false)) {
        scene->casing->setMesh(outlines_);
        scene->lines->setMesh(outlines_);
        scene->selectedLines->setMesh(selectedOutlines_);
        scene->fill->setMesh(selected_);
    }
    QColor fill = selectionColor_;
    fill.setAlphaF(0.22F);
    scene->fill->setStyle(fill);
    scene->casing->setStyle({.color = casingColor_, .widthPx = 3.2 * lineFactor_});
    scene->lines->setStyle({.color = lineColor_, .widthPx = 1.4 * lineFactor_});
    scene->selectedLines->setStyle({.color = selectionColor_, .widthPx = 2.6 * lineFactor_});
    scene->fill->setShown(showSelection_);
    scene->selectedLines->setShown(showSelection_);
    scene->setMatrix(matrixFor(origin_));
    scene->setScale(pixelsPerUnit(), devicePixelRatio());
    return scene;
}

}  // namespace furrow
