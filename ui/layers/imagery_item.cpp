#include "ui/layers/imagery_item.h"

#include "ui/layers/tile_nodes.h"

#include <algorithm>
#include <cmath>

namespace furrow {

namespace {

/// Tiles of one raster in view; with more, as where a folder has only fine ones, nothing is shown.
constexpr int kMostTiles = 600;
/// Zooms by which the tiles are coarser that are read first and shown meanwhile.
constexpr int kCoarser = 3;
/// Tiles are drawn between 0.6 and 1.2 times their size: sharp, and not many more than there are pixels.
constexpr double kSharper = 0.25;

/// Tiles of one zoom, columns counted on beyond the edge of the world.
struct TileRange {
    int zoom = 0;
    int west = 0;
    int east = -1;
    int north = 0;
    int south = -1;

    int count() const { return std::max(0, east - west + 1) * std::max(0, south - north + 1); }
    TileId wrapped(int column, int row) const {
        const int all = 1 << zoom;
        return {zoom, ((column % all) + all) % all, row};
    }
};

/// The world of a place in view that its imagery is nearest to.
TileRange rangeOf(const MapCamera& camera, QSizeF size, const ImageryFacts& facts, int zoom) {
    const double tiles = std::exp2(zoom);
    const WorldPoint middle = camera.worldCenter();
    const double halfWidth = 0.5 * size.width() / camera.scale();
    const double halfHeight = 0.5 * size.height() / camera.scale();
    WorldPoint low = worldPoint(GeoPoint{facts.southWest.lonDeg, facts.northEast.latDeg});
    WorldPoint high = worldPoint(GeoPoint{facts.northEast.lonDeg, facts.southWest.latDeg});
    const double turns = std::round(middle.x - 0.5 * (low.x + high.x));
    const auto tile = [tiles](double share) { return static_cast<int>(std::floor(share * tiles)); };
    // What ends at an edge of a tile does not reach into the next one.
    constexpr double kLess = 1e-9;
    return {.zoom = zoom,
            .west = tile(std::max(low.x + turns, middle.x - halfWidth)),
            .east = tile(std::min(high.x + turns - kLess, middle.x + halfWidth)),
            .north = std::max(0, tile(std::max(low.y, middle.y - halfHeight))),
            .south = std::min((1 << zoom) - 1, tile(std::min(high.y - kLess, middle.y + halfHeight)))};
}

/// A tile that is there in place of one that is not: itself, or the part of the nearest coarser one.
struct Stand {
    TileKey key;
    QRectF source;
    const QImage* image = nullptr;
};

Stand standFor(const TileStore& store, const TileKey& key, int coarsest, TileNodes& nodes, bool& more) {
    for (int up = 0; key.id.zoom - up >= coarsest && up <= 8; ++up) {
        const TileKey other{key.sheet, {key.id.zoom - up, key.id.column >> up, key.id.row >> up}};
        const QImage* image = store.find(other);
        // A folder of tiles may have fine ones in some places only.
        if (image == nullptr || image->isNull()) {
            continue;
        }
        if (!nodes.upload(other, *image)) {
            more = true;
            continue;
        }
        const double share = 1.0 / (1 << up);
        const int within = (1 << up) - 1;
        return {
            other, {(key.id.column & within) * share, (key.id.row & within) * share, share, share}, image};
    }
    return {};
}

/// Of a range. Looking for a tile also keeps it: what was not looked for longest is forgotten first.
void addMissing(std::vector<TileKey>& missing, const TileStore& store, const ImagerySheet& sheet,
                const TileRange& range) {
    for (int row = range.north; row <= range.south; ++row) {
        for (int column = range.west; column <= range.east; ++column) {
            const TileKey key{sheet.number, range.wrapped(column, row)};
            if (store.find(key) == nullptr) {
                missing.push_back(key);
            }
        }
    }
}

}  // namespace

void ImageryItem::setImagery(ImageryModel* imagery) {
    if (imagery == imagery_) {
        return;
    }
    if (imagery_ != nullptr) {
        imagery_->disconnect(this);
    }
    imagery_ = imagery;
    if (imagery_ != nullptr) {
        connect(imagery_, &ImageryModel::sheetsChanged, this, &QQuickItem::update);
        connect(&imagery_->store(), &TileStore::tilesChanged, this, &QQuickItem::update);
    }
    update();
    emit imageryChanged();
}

QSGNode* ImageryItem::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* nodes = static_cast<TileNodes*>(old);
    if (nodes == nullptr) {
        nodes = new TileNodes;
    }
    nodes->begin(*window());
    const MapCamera& shown = *camera();
    TileStore& store = imagery_->store();
    std::vector<TileKey> wanted;
    std::vector<TileKey> first;
    std::size_t room = 0;
    bool more = false;
    for (const ImagerySheet& sheet : imagery_->sheets()) {
        const Imagery* imagery = store.imagery(sheet.number);
        if (imagery == nullptr || sheet.opacity <= 0.0) {
            continue;
        }
        const ImageryFacts& facts = imagery->facts();
        const int fitting =
            static_cast<int>(std::ceil(shown.zoomLevel() + std::log2(devicePixelRatio()) - kSharper));
        const TileRange range =
            rangeOf(shown, size(), facts, std::clamp(fitting, facts.coarsestZoom, facts.finestZoom));
        if (range.count() == 0 || range.count() > kMostTiles) {
            continue;
        }
        nodes->beginSheet(sheet.opacity);
        const double tileWorld = std::exp2(-range.zoom);
        for (int row = range.north; row <= range.south; ++row) {
            for (int column = range.west; column <= range.east; ++column) {
                const TileKey key{sheet.number, range.wrapped(column, row)};
                if (store.find(key) == nullptr) {
                    wanted.push_back(key);
                }
                const Stand stand = standFor(store, key, facts.coarsestZoom, *nodes, more);
                if (stand.image != nullptr) {
                    const double side = tileWorld * shown.scale();
                    nodes->add({stand.key,
                                {width() / 2.0 + (column * tileWorld - shown.worldCenter().x) * shown.scale(),
                                 height() / 2.0 + (row * tileWorld - shown.worldCenter().y) * shown.scale(),
                                 side, side},
                                stand.source});
                }
            }
        }
        const TileRange coarse =
            rangeOf(shown, size(), facts, std::max(range.zoom - kCoarser, facts.coarsestZoom));
        if (coarse.zoom < range.zoom) {
            addMissing(first, store, sheet, coarse);
        }
        room += static_cast<std::size_t>(range.count() + coarse.count());
    }
    nodes->end();
    first.insert(first.end(), wanted.begin(), wanted.end());
    store.want(std::move(first), room);
    if (more) {
        QMetaObject::invokeMethod(this, &QQuickItem::update, Qt::QueuedConnection);
    }
    return nodes;
}

}  // namespace furrow
