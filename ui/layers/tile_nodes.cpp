#include "ui/layers/tile_nodes.h"

namespace furrow {

namespace {
/// More would be felt as a jerk while the map moves.
constexpr int kUploadsPerFrame = 8;
}  // namespace

void TileNodes::begin(QQuickWindow& window) {
    window_ = &window;
    used_ = 0;
    uploads_ = 0;
    for (auto& [key, texture] : textures_) {
        texture.used = false;
    }
}

void TileNodes::beginSheet(double opacity) {
    if (used_ == sheets_.size()) {
        sheets_.push_back({new QSGOpacityNode, {}, 0});
        appendChildNode(sheets_.back().node);
    }
    Sheet& sheet = sheets_[used_++];
    sheet.used = 0;
    sheet.node->setOpacity(opacity);
}

bool TileNodes::upload(const TileKey& key, const QImage& image) {
    if (textures_.contains(key)) {
        return true;
    }
    if (uploads_ >= kUploadsPerFrame) {
        return false;
    }
    ++uploads_;
    const bool opaque = image.format() == QImage::Format_RGBX8888;
    std::unique_ptr<QSGTexture> texture{window_->createTextureFromImage(
        image, opaque ? QQuickWindow::TextureIsOpaque : QQuickWindow::TextureHasAlphaChannel)};
    textures_[key] = {std::move(texture), false};
    return true;
}

void TileNodes::add(const PlacedTile& tile) {
    Sheet& sheet = sheets_[used_ - 1];
    if (sheet.used == sheet.images.size()) {
        QSGImageNode* image = window_->createImageNode();
        image->setOwnsTexture(false);
        image->setFiltering(QSGTexture::Linear);
        sheet.node->appendChildNode(image);
        sheet.images.push_back(image);
    }
    QSGImageNode& image = *sheet.images[sheet.used++];
    Texture& texture = textures_[tile.key];
    texture.used = true;
    const QSizeF size = texture.texture->textureSize();
    const QRectF source{tile.source.x() * size.width(), tile.source.y() * size.height(),
                        tile.source.width() * size.width(), tile.source.height() * size.height()};
    if (image.texture() != texture.texture.get()) {
        image.setTexture(texture.texture.get());
    }
    image.setSourceRect(source);
    image.setRect(tile.target);
}

void TileNodes::end() {
    for (std::size_t i = 0; i < sheets_.size(); ++i) {
        Sheet& sheet = sheets_[i];
        const std::size_t used = i < used_ ? sheet.used : 0;
        while (sheet.images.size() > used) {
            sheet.node->removeChildNode(sheet.images.back());
            delete sheet.images.back();
            sheet.images.pop_back();
        }
    }
    while (sheets_.size() > used_) {
        removeChildNode(sheets_.back().node);
        delete sheets_.back().node;
        sheets_.pop_back();
    }
    std::erase_if(textures_, [](const auto& entry) { return !entry.second.used; });
}

}  // namespace furrow
