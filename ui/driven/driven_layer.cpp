#include "ui/driven/driven_layer.h"

#include "ui/map/even_odd_fill.h"
#include "ui/map/mesh_nodes.h"

#include <QSGTransformNode>

#include <array>
#include <utility>

namespace furrow {

namespace {

constexpr std::array kWidthsPx{2.0, 3.0, 4.2, 5.6, 2.4};
static_assert(kWidthsPx.size() == DrivenTrack::kClasses);

/// Lowest first. Lives in the render thread.
class DrivenScene : public QSGTransformNode {
public:
    DrivenScene() {
        appendChildNode(missed);
        appendChildNode(casing);
        for (LineNode*& line : lines) {
            line = new LineNode;
            appendChildNode(line);
        }
    }

    FillNode* const missed = new FillNode;
    LineNode* const casing = new LineNode;
    std::array<LineNode*, DrivenTrack::kClasses> lines{};
};

FillMesh fillOf(const MultiPolygon& polygons, const MapFrame& frame) {
    FillMesh fill;
    for (const Polygon& polygon : polygons) {
        std::vector<std::vector<MapPoint>> rings{frame.map(polygon.outer)};
        for (const Ring& hole : polygon.holes) {
            rings.push_back(frame.map(hole));
        }
        const FillMesh piece = evenOddTriangles(rings);
        fill.insert(fill.end(), piece.begin(), piece.end());
    }
    return fill;
}

}  // namespace

DrivenLayer::DrivenLayer(QQuickItem* parent) : MapLayer{parent} {
    connect(this, &DrivenLayer::styleChanged, this, &QQuickItem::update);
}

void DrivenLayer::setTrack(DrivenTrack* track) {
    if (track == track_) {
        return;
    }
    if (track_ != nullptr) {
        track_->disconnect(this);
    }
    track_ = track;
    if (track_ != nullptr) {
        connect(track_, &DrivenTrack::changed, this, [this] {
            stale_ = true;
            update();
        });
    }
    stale_ = true;
    emit trackChanged();
    update();
}

QSGNode* DrivenLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    if (track_ == nullptr || !track_->isReady()) {
        delete old;
        return nullptr;
    }
    auto* scene = static_cast<DrivenScene*>(old);
    if (scene == nullptr) {
        scene = new DrivenScene;
        stale_ = true;
    }
    const MapFrame frame{track_->plan()->field().frame()};
    if (std::exchange(stale_, false)) {
        std::array<LineMesh, DrivenTrack::kClasses> meshes;
        LineMesh all;
        for (const DrivenTrack::Line& line : track_->lines()) {
            const std::vector<MapPoint> points = frame.map(line.points);
            meshes[line.step].add(points);
            all.add(points);
        }
        scene->casing->setMesh(all);
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            scene->lines[i]->setMesh(meshes[i]);
        }
        scene->missed->setMesh(fillOf(track_->missed(), frame));
    }
    scene->missed->setStyle(missedColor_, 6.0);
    scene->missed->setScale(pixelsPerUnit(), devicePixelRatio());
    scene->casing->setStyle({.color = casingColor_, .widthPx = 4.0 * lineFactor_});
    scene->casing->setScale(pixelsPerUnit(), devicePixelRatio());
    for (std::size_t i = 0; i < scene->lines.size(); ++i) {
        const bool off = i + 1 == scene->lines.size();
        scene->lines[i]->setStyle({.color = colors_.value(static_cast<qsizetype>(i)),
                                   .widthPx = kWidthsPx[i] * lineFactor_,
                                   .dashPx = off ? 4.0 : 0.0,
                                   .periodPx = off ? 8.0 : 0.0});
        scene->lines[i]->setScale(pixelsPerUnit(), devicePixelRatio());
    }
    scene->setMatrix(matrixFor(frame.origin()));
    return scene;
}

}  // namespace furrow
