#include "ui/map/world_layer.h"

#include "ui/map/mesh_nodes.h"

#include <QFutureWatcher>
#include <QtConcurrent>

#include <algorithm>
#include <array>
#include <cmath>

namespace furrow {

namespace {

/// The outline fades out between these two zooms.
constexpr double kFadeZoom = 9.0;
constexpr double kGoneZoom = 11.0;

/// Distances of the grid, degrees.
constexpr std::array kGridSteps{30.0,      15.0,      10.0,       5.0,        2.0,        1.0,
                                0.5,       1.0 / 6,   1.0 / 12,   1.0 / 30,   1.0 / 60,   1.0 / 120,
                                1.0 / 360, 1.0 / 720, 1.0 / 1800, 1.0 / 3600, 1.0 / 7200, 1.0 / 36000};

/// One copy of the world, made of pieces that are shown where they are in view.
class WorldNode : public QSGTransformNode {
public:
    template <class Node>
    struct Piece {
        QRectF box;
        Node* node;
    };

    WorldNode(const WorldLevel& level, const QColor& land, const QColor& coast) {
        for (const auto& piece : level.land) {
            auto* node = new FillNode;
            node->setMesh(piece.mesh);
            node->setStyle(land);
            appendChildNode(node);
            fills_.push_back({piece.box, node});
        }
        const auto addLines = [this](const std::vector<WorldLevel::Lines>& pieces, const LineStyle& style) {
            for (const auto& piece : pieces) {
                auto* node = new LineNode;
                node->setMesh(piece.mesh);
                node->setStyle(style);
                appendChildNode(node);
                lines_.push_back({piece.box, node});
            }
        };
        QColor border = coast;
        border.setAlphaF(0.65F);
        addLines(level.borders, {.color = border, .widthPx = 0.8, .dashPx = 4.0, .periodPx = 7.0});
        addLines(level.coasts, {.color = coast, .widthPx = 1.0});
    }
    void show(const QRectF& view, double pixelsPerUnit, double devicePixelRatio) {
        for (const auto& [box, node] : fills_) {
            node->setShown(box.intersects(view));
            node->setScale(pixelsPerUnit, devicePixelRatio);
        }
        for (const auto& [box, node] : lines_) {
            node->setShown(box.intersects(view));
            node->setScale(pixelsPerUnit, devicePixelRatio);
        }
    }

private:
    std::vector<Piece<FillNode>> fills_;
    std::vector<Piece<LineNode>> lines_;
};

struct WorldRoot : QSGNode {
    QSGOpacityNode* outline = new QSGOpacityNode;
    LineNode* grid = new LineNode;
    std::vector<WorldNode*> copies;
    std::size_t level = 99;
    QColor land;
    QColor coast;

    WorldRoot() {
        appendChildNode(outline);
        appendChildNode(grid);
    }
};

/// Lines of longitude and latitude in pixels of the item, some 90 to 200 pixels apart.
LineMesh gridMesh(const MapCamera& camera, double width, double height) {
    const double pixelsPerDegree = camera.scale() / 360.0;
    const auto step =
        std::ranges::find_if(kGridSteps, [&](double degrees) { return degrees * pixelsPerDegree < 200.0; });
    const double stepDeg = step == kGridSteps.end() ? kGridSteps.back() : *step;
    LineMesh mesh;
    const auto line = [&mesh](double x1, double y1, double x2, double y2) {
        mesh.add(std::array{MapPoint{static_cast<float>(x1), static_cast<float>(y1)},
                            MapPoint{static_cast<float>(x2), static_cast<float>(y2)}});
    };
    const double west = (camera.worldCenter().x - width / 2.0 / camera.scale()) * 360.0 - 180.0;
    const double firstLon = std::ceil(west / stepDeg) * stepDeg;
    for (double lon = firstLon; (lon - west) * pixelsPerDegree <= width; lon += stepDeg) {
        const double x = std::round((lon - west) * pixelsPerDegree) + 0.5;
        line(x, 0.0, x, height);
    }
    const double south = geoPoint(camera.toWorld({0.0, height})).latDeg;
    for (double lat = std::ceil(south / stepDeg) * stepDeg; lat < 85.0; lat += stepDeg) {
        const double y =
            std::round(camera.toItem(worldPoint(GeoPoint{.lonDeg = 0.0, .latDeg = lat})).y()) + 0.5;
        if (y < 0.0) {
            break;
        }
        line(0.0, y, width, y);
    }
    return mesh;
}

}  // namespace

WorldLayer::WorldLayer(QQuickItem* parent) : MapLayer{parent} {
    connect(this, &WorldLayer::styleChanged, this, &QQuickItem::update);
    auto* watcher = new QFutureWatcher<std::shared_ptr<const WorldOutline>>{this};
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher] {
        outline_ = watcher->result();
        watcher->deleteLater();
        update();
        emit loadedChanged();
    });
    watcher->setFuture(QtConcurrent::run(readWorldOutline));
}

QSGNode* WorldLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* root = static_cast<WorldRoot*>(old);
    if (root == nullptr) {
        root = new WorldRoot;
    }
    const double zoom = camera()->zoomLevel();
    const double visible = std::clamp((kGoneZoom - zoom) / (kGoneZoom - kFadeZoom), 0.0, 1.0);
    root->outline->setOpacity(visible);

    const std::size_t level = zoom < 4.0 ? 0 : zoom < 7.0 ? 1 : 2;
    if (outline_ && !outline_->levels.empty() && visible > 0.0 &&
        (root->level != level || root->land != landColor_ || root->coast != coastColor_)) {
        while (QSGNode* child = root->outline->firstChild()) {
            root->outline->removeChildNode(child);
            delete child;
        }
        root->copies.clear();
        for (int turns = -1; turns <= 1; ++turns) {
            root->copies.push_back(new WorldNode{outline_->levels[level], landColor_, coastColor_});
            root->outline->appendChildNode(root->copies.back());
        }
        root->level = level;
        root->land = landColor_;
        root->coast = coastColor_;
    }
    if (visible > 0.0) {
        const WorldPoint middle{};
        for (int copy = 0; copy < static_cast<int>(root->copies.size()); ++copy) {
            WorldNode* node = root->copies[static_cast<std::size_t>(copy)];
            const int turns = copy - 1;
            node->setMatrix(matrixFor(middle, turns));
            node->show(viewIn(middle, 4.0).translated(-turns * kUnitsPerWorld, 0.0), pixelsPerUnit(),
                       devicePixelRatio());
        }
    }
    root->grid->setMesh(gridMesh(*camera(), width(), height()));
    root->grid->setStyle({.color = gridColor_, .widthPx = 1.0});
    root->grid->setScale(1.0, devicePixelRatio());
    return root;
}

}  // namespace furrow
