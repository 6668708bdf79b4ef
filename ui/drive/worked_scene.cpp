#include "ui/drive/worked_scene.h"

#include <utility>

namespace furrow {

void WorkedScene::setStrips(std::shared_ptr<const WorkedStrips> strips) {
    if (strips == strips_) {
        return;
    }
    strips_ = std::move(strips);
    for (FillNode* piece : pieces_) {
        removeChildNode(piece);
        delete piece;
    }
    pieces_.clear();
}

void WorkedScene::setWorked(std::size_t station, const DriveState& state) {
    const std::size_t whole = station / WorkedStrips::kStationsInPiece;
    while (pieces_.size() < whole) {
        auto* piece = new FillNode;
        piece->setMesh(strips_->piece(pieces_.size()));
        piece->setStyle(color_);
        appendChildNode(piece);
        pieces_.push_back(piece);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        pieces_[i]->setShown(i < whole);
    }
    begun_->setMesh(strips_->begun(station, state));
    begun_->setShown(true);
}

void WorkedScene::hide() {
    for (FillNode* piece : pieces_) {
        piece->setShown(false);
    }
    begun_->setShown(false);
}

void WorkedScene::setColor(const QColor& color) {
    if (color == color_) {
        return;
    }
    color_ = color;
    for (FillNode* piece : pieces_) {
        piece->setStyle(color);
    }
    begun_->setStyle(color);
}

}  // namespace furrow
