#include "ui/compare/difference_layer.h"

#include "planner/geometry/curve_sampling.h"
#include "ui/map/mesh_nodes.h"

#include <QSGTransformNode>

#include <array>
#include <utility>

namespace furrow {

namespace {

/// Lowest first. Lives in the render thread.
class DifferenceScene : public QSGTransformNode {
public:
    DifferenceScene() {
        for (LineNode* node : all()) {
            appendChildNode(node);
        }
    }
    std::array<LineNode*, 5> all() const { return {casing, firstDriven, secondDriven, first, second}; }

    LineNode* const casing = new LineNode;
    LineNode* const firstDriven = new LineNode;
    LineNode* const secondDriven = new LineNode;
    LineNode* const first = new LineNode;
    LineNode* const second = new LineNode;
};

LineMesh meshOf(const Plan& plan, const std::vector<std::size_t>& swaths, const MapFrame& frame) {
    const Length tolerance = metres(0.05);
    LineMesh mesh;
    for (const std::size_t index : swaths) {
        std::vector<MapPoint> line;
        for (const CurveSample& sample : sampled(lineOf(plan.swaths.swaths[index]), tolerance)) {
            line.push_back(frame.map(sample.pose.position));
        }
        mesh.add(line);
    }
    return mesh;
}

LineMesh meshOf(const std::vector<DifferentStretch>& stretches, const MapFrame& frame) {
    LineMesh mesh;
    for (const DifferentStretch& stretch : stretches) {
        mesh.add(frame.map(stretch.line));
    }
    return mesh;
}

}  // namespace

DifferenceLayer::DifferenceLayer(QQuickItem* parent) : MapLayer{parent} {
    connect(this, &DifferenceLayer::styleChanged, this, &QQuickItem::update);
}

void DifferenceLayer::setComparison(PlanComparison* comparison) {
    if (comparison == comparison_) {
        return;
    }
    if (comparison_ != nullptr) {
        comparison_->disconnect(this);
    }
    comparison_ = comparison;
    if (comparison_ != nullptr) {
        connect(comparison_, &PlanComparison::changed, this, [this] {
            stale_ = true;
            update();
        });
    }
    stale_ = true;
    emit comparisonChanged();
    update();
}

QSGNode* DifferenceLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    if (comparison_ == nullptr || !comparison_->isActive() || !comparison_->isReady()) {
        delete old;
        return nullptr;
    }
    auto* scene = static_cast<DifferenceScene*>(old);
    if (scene == nullptr) {
        scene = new DifferenceScene;
        stale_ = true;
    }
    const MapFrame frame{comparison_->first()->field().frame()};
    if (std::exchange(stale_, false)) {
        const PlanDifference& difference = *comparison_->difference();
        const LineMesh first = meshOf(*comparison_->first(), difference.onlyInFirst, frame);
        scene->casing->setMesh(first);
        scene->first->setMesh(first);
        scene->second->setMesh(meshOf(*comparison_->second(), difference.onlyInSecond, frame));
        scene->firstDriven->setMesh(meshOf(difference.drivenOnlyInFirst, frame));
        scene->secondDriven->setMesh(meshOf(difference.drivenOnlyInSecond, frame));
    }
    const double swathPx = 2.2 * lineFactor_;
    // Turns are many and short: thinner than what is worked.
    const double drivenPx = 1.6 * lineFactor_;
    scene->casing->setStyle({.color = casingColor_, .widthPx = 4.0 * lineFactor_});
    scene->first->setStyle({.color = firstColor_, .widthPx = swathPx});
    scene->firstDriven->setStyle({.color = firstColor_, .widthPx = drivenPx});
    scene->second->setStyle({.color = secondColor_, .widthPx = swathPx, .dashPx = 7.0, .periodPx = 12.0});
    scene->secondDriven->setStyle(
        {.color = secondColor_, .widthPx = drivenPx, .dashPx = 5.0, .periodPx = 9.0});
    for (LineNode* line : {scene->casing, scene->first, scene->firstDriven}) {
        line->setShown(showFirst_);
    }
    for (LineNode* line : {scene->second, scene->secondDriven}) {
        line->setShown(showSecond_);
    }
    scene->setMatrix(matrixFor(frame.origin()));
    for (LineNode* line : scene->all()) {
        line->setScale(pixelsPerUnit(), devicePixelRatio());
    }
    return scene;
}

}  // namespace furrow
