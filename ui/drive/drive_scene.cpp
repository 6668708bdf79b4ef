#include "ui/drive/drive_scene.h"

namespace furrow {

DriveScene::DriveScene() {
    for (QSGNode* node : std::initializer_list<QSGNode*>{
             drawbar_, implementCasing_, implement_, implementOutline_, casing_, wheels_, body_, outline_}) {
        appendChildNode(node);
    }
    hide();
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
    for (FillNode* area : {implement_, wheels_, body_}) {
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
    for (FillNode* area : {implement_, wheels_, body_}) {
        area->setScale(pixelsPerUnit, devicePixelRatio);
    }
    for (LineNode* line : {drawbar_, implementCasing_, implementOutline_, casing_, outline_}) {
        line->setScale(pixelsPerUnit, devicePixelRatio);
    }
}

}  // namespace furrow
