#include "ui/drive/drive_scene.h"

#include <utility>

namespace furrow {

namespace {

constexpr float kWorkedOpacity = 0.32F;

QColor withAlpha(QColor color, float alpha) {
    color.setAlphaF(alpha);
    return color;
}

}  // namespace

DriveScene::DriveScene() {
    appendChildNode(ground_);
    for (QSGNode* node :
         std::initializer_list<QSGNode*>{begun_, drawbar_, implementCasing_, implement_, implementOutline_,
                                         casing_, wheels_, body_, outline_}) {
        appendChildNode(node);
    }
    hide();
}

void DriveScene::setStrips(std::shared_ptr<const WorkedStrips> strips) {
    if (strips == strips_) {
        return;
    }
    strips_ = std::move(strips);
    for (FillNode* piece : pieces_) {
        ground_->removeChildNode(piece);
        delete piece;
    }
    pieces_.clear();
}

void DriveScene::setWorked(std::size_t station, const DriveState& state) {
    const std::size_t whole = station / WorkedStrips::kStationsInPiece;
    while (pieces_.size() < whole) {
        auto* piece = new FillNode;
        piece->setMesh(strips_->piece(pieces_.size()));
        piece->setStyle(withAlpha(style_.worked, kWorkedOpacity));
        ground_->appendChildNode(piece);
        pieces_.push_back(piece);
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        pieces_[i]->setShown(i < whole);
    }
    begun_->setMesh(strips_->begun(station, state));
    begun_->setShown(true);
}

void DriveScene::setMachine(const MachineShapeDrawing& drawing, Carried carried) {
    body_->setMesh(drawing.body);
    wheels_->setMesh(drawing.wheels);
    outline_->setMesh(drawing.outline);
    casing_->setMesh(drawing.outline);
    implement_->setMesh(drawing.implement);
    implementOutline_->setMesh(drawing.implementOutline);
    implementCasing_->setMesh(drawing.implementOutline);
    drawbar_->setMesh(drawing.drawbar);
    for (LineNode* line : {drawbar_, implementCasing_, implementOutline_, casing_, outline_}) {
        line->setShown(true);
    }
    for (FillNode* area : {wheels_, body_}) {
        area->setShown(true);
    }
    // Up: only its outline.
    implement_->setShown(carried == Carried::Down);
    carried_ = carried;
    styleMachine();
}

void DriveScene::hide() {
    for (FillNode* piece : pieces_) {
        piece->setShown(false);
    }
    for (FillNode* area : {begun_, implement_, wheels_, body_}) {
        area->setShown(false);
    }
    for (LineNode* line : {drawbar_, implementCasing_, implementOutline_, casing_, outline_}) {
        line->setShown(false);
    }
}

void DriveScene::styleMachine() {
    const bool down = carried_ == Carried::Down;
    implementOutline_->setStyle({.color = style_.implement,
                                 .widthPx = 2.0,
                                 .dashPx = down ? 0.0 : 5.0,
                                 .periodPx = down ? 0.0 : 8.0});
}

void DriveScene::setStyle(const DriveStyle& style) {
    style_ = style;
    for (FillNode* piece : pieces_) {
        piece->setStyle(withAlpha(style.worked, kWorkedOpacity));
    }
    begun_->setStyle(withAlpha(style.worked, kWorkedOpacity));
    body_->setStyle(style.body);
    wheels_->setStyle(style.wheels);
    implement_->setStyle(style.implement);
    casing_->setStyle({.color = style.casing, .widthPx = 4.0});
    implementCasing_->setStyle({.color = style.casing, .widthPx = 5.0});
    outline_->setStyle({.color = style.wheels, .widthPx = 1.2});
    drawbar_->setStyle({.color = style.wheels, .widthPx = 2.0});
    styleMachine();
}

void DriveScene::setScale(double pixelsPerUnit, double devicePixelRatio) {
    for (FillNode* piece : pieces_) {
        piece->setScale(pixelsPerUnit, devicePixelRatio);
    }
    for (FillNode* area : {begun_, implement_, wheels_, body_}) {
        area->setScale(pixelsPerUnit, devicePixelRatio);
    }
    for (LineNode* line : {drawbar_, implementCasing_, implementOutline_, casing_, outline_}) {
        line->setScale(pixelsPerUnit, devicePixelRatio);
    }
}

}  // namespace furrow
