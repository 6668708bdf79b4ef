#pragma once

#include "ui/layers/tile_store.h"

#include <QQuickWindow>
#include <QSGImageNode>
#include <QSGNode>
#include <QSGTexture>

#include <memory>
#include <unordered_map>
#include <vector>

namespace furrow {

/// Where a tile, or a part of one, is drawn.
struct PlacedTile {
    TileKey key;
    QRectF target;  ///< in the item
    QRectF source;  ///< share of the tile, in [0, 1]
};

/// Tiles of all imagery, lowest first. Lives in the render thread; has textures of what it shows only.
class TileNodes : public QSGNode {
public:
    /// Starts a frame with nothing shown.
    void begin(QQuickWindow& window);
    void beginSheet(double opacity);
    /// Gives a picture its texture. False where too many were made in this frame already.
    bool upload(const TileKey& key, const QImage& image);
    void add(const PlacedTile& tile);
    /// Removes what was not used.
    void end();

private:
    struct Sheet {
        QSGOpacityNode* node;
        std::vector<QSGImageNode*> images;
        std::size_t used = 0;
    };
    struct Texture {
        std::unique_ptr<QSGTexture> texture;
        bool used = false;
    };
    struct Hash {
        std::size_t operator()(const TileKey& key) const { return qHash(key); }
    };

    QQuickWindow* window_ = nullptr;
    std::vector<Sheet> sheets_;
    std::size_t used_ = 0;
    int uploads_ = 0;
    std::unordered_map<TileKey, Texture, Hash> textures_;
};

}  // namespace furrow
