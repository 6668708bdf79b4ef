#include "ui/driven/track_outline_layer.h"

#include "ui/map/even_odd_fill.h"
#include "ui/map/mesh_nodes.h"

#include <QSGTransformNode>

#include <algorithm>
#include <utility>

namespace furrow {

namespace {

/// Lowest first. Lives in the render thread.
class OutlineScene : public QSGTransformNode {
public:
    OutlineScene() {
        appendChildNode(fill);
        appendChildNode(track);
        appendChildNode(casing);
        appendChildNode(line);
    }

    FillNode* const fill = new FillNode;
    LineNode* const track = new LineNode;
    LineNode* const casing = new LineNode;
    LineNode* const line = new LineNode;
    WorldPoint origin;
};

std::vector<MapPoint> mapped(const GeoRing& ring, WorldPoint origin) {
    std::vector<MapPoint> points;
    points.reserve(ring.size());
    std::ranges::transform(ring, std::back_inserter(points),
                           [origin](GeoPoint place) { return mapPoint(worldPoint(place), origin); });
    return points;
}

}  // namespace

TrackOutlineLayer::TrackOutlineLayer(QQuickItem* parent) : MapLayer{parent} {
    connect(this, &TrackOutlineLayer::styleChanged, this, &QQuickItem::update);
}

void TrackOutlineLayer::setSource(FieldFromTrack* source) {
    if (source == source_) {
        return;
    }
    if (source_ != nullptr) {
        source_->disconnect(this);
    }
    source_ = source;
    if (source_ != nullptr) {
        connect(source_, &FieldFromTrack::changed, this, [this] {
            stale_ = true;
            update();
        });
    }
    stale_ = true;
    emit sourceChanged();
    update();
}

QSGNode* TrackOutlineLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    const TrackOutline* const outline = source_ == nullptr ? nullptr : source_->outline();
    if (outline == nullptr) {
        delete old;
        return nullptr;
    }
    auto* scene = static_cast<OutlineScene*>(old);
    if (scene == nullptr) {
        scene = new OutlineScene;
        stale_ = true;
    }
    if (std::exchange(stale_, false)) {
        scene->origin = worldPoint(outline->pieces.front().outer.front());
        LineMesh edges;
        LineMesh track;
        FillMesh fill;
        for (const GeoPolygon& piece : outline->pieces) {
            std::vector<std::vector<MapPoint>> rings{mapped(piece.outer, scene->origin)};
            for (const GeoRing& hole : piece.holes) {
                rings.push_back(mapped(hole, scene->origin));
            }
            for (const auto& ring : rings) {
                edges.add(ring, true);
            }
            const FillMesh inside = evenOddTriangles(rings);
            fill.insert(fill.end(), inside.begin(), inside.end());
        }
        for (const GeoRing& line : outline->lines) {
            track.add(mapped(line, scene->origin));
        }
        scene->fill->setMesh(fill);
        scene->track->setMesh(track);
        scene->casing->setMesh(edges);
        scene->line->setMesh(edges);
    }
    scene->fill->setStyle(fillColor_);
    scene->track->setStyle({.color = trackColor_, .widthPx = 1.5 * lineFactor_});
    scene->casing->setStyle({.color = casingColor_, .widthPx = 5.0 * lineFactor_});
    scene->line->setStyle({.color = lineColor_, .widthPx = 3.0 * lineFactor_});
    scene->fill->setScale(pixelsPerUnit(), devicePixelRatio());
    for (LineNode* line : {scene->track, scene->casing, scene->line}) {
        line->setScale(pixelsPerUnit(), devicePixelRatio());
    }
    scene->setMatrix(matrixFor(scene->origin));
    return scene;
}

}  // namespace furrow
