#include "ui/map/plan_layer.h"

#include "ui/map/finding_marks.h"

namespace furrow {

void PlanLayer::setDrawing(const PlanDrawing& drawing) {
    if (drawing == drawing_) {
        return;
    }
    drawing_ = drawing;
    update();
    emit drawingChanged();
}

void PlanLayer::setStyle(const PlanStyle& style) {
    if (style == style_) {
        return;
    }
    style_ = style;
    update();
    emit styleChanged();
}

PlanView PlanLayer::view() const {
    const WorldPoint origin = drawing_.isEmpty() ? WorldPoint{} : drawing_.geometry()->origin;
    return {.matrix = matrixFor(origin),
            .visible = viewIn(origin, 24.0),
            .size = size(),
            .pixelsPerUnit = pixelsPerUnit(),
            .devicePixelRatio = devicePixelRatio()};
}

int PlanLayer::findingAt(QPointF pixel) const {
    if (drawing_.isEmpty() || !style_.showFindings) {
        return -1;
    }
    return furrow::findingAt(findingMarks(*drawing_.geometry(), view(), style_.selectedFinding), pixel);
}

QSGNode* PlanLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* scene = static_cast<PlanScene*>(old);
    if (scene == nullptr) {
        scene = new PlanScene;
    }
    scene->setGeometry(drawing_.geometry());
    scene->setStyle(style_);
    scene->setView(view(), window());
    return scene;
}

}  // namespace furrow
