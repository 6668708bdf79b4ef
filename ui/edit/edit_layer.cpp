#include "ui/map/edit_layer.h"

#include "ui/map/mesh_nodes.h"

#include <QCursor>
#include <QLineF>
#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <cmath>

namespace furrow {

namespace {

constexpr double kReachPx = 11.0;
constexpr double kDragPx = 4.0;
/// Handles closer together than this would hide the boundary.
constexpr double kCrowdedPx = 12.0;
/// Handles are shown around the pointer only: a surveyed boundary would be all handles.
constexpr double kHandlesPx = 130.0;
/// Levels of zoom for one notch of the wheel.
constexpr double kLevelsPerNotch = 0.5;

/// Lines and discs in pixels of the item, so nothing has to follow the camera.
struct EditRoot : QSGNode {
    std::array<LineNode*, 7> nodes{};
    enum Slot { Casing, Line, Rubber, HandleEdge, HandleFace, ActiveEdge, ActiveFace };

    EditRoot() {
        for (LineNode*& node : nodes) {
            node = new LineNode;
            appendChildNode(node);
        }
    }
    void set(Slot slot, const LineMesh& mesh, const LineStyle& style, double devicePixelRatio) {
        nodes[slot]->setMesh(mesh);
        nodes[slot]->setStyle(style);
        nodes[slot]->setScale(1.0, devicePixelRatio);
    }
};

MapPoint pixelPoint(QPointF pixel) {
    return {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
}

void addDisc(LineMesh& mesh, QPointF pixel) {
    mesh.add(std::array{pixelPoint(pixel)});
}

}  // namespace

EditLayer::EditLayer(QQuickItem* parent) : MapLayer{parent} {
    setAcceptedMouseButtons(Qt::LeftButton | Qt::MiddleButton);
    setAcceptHoverEvents(true);
    connect(this, &EditLayer::styleChanged, this, &QQuickItem::update);
}

void EditLayer::setDrawing(const PlanDrawing& drawing) {
    if (drawing == drawing_) {
        return;
    }
    drawing_ = drawing;
    // While a vertex is held, what the user sees is the truth and the plan comes after.
    if (!grabbed_) {
        rings_ = drawing_.isEmpty() ? std::vector<EditableRing>{} : drawing_.geometry()->rings;
        hovered_.reset();
    }
    update();
    emit drawingChanged();
}

void EditLayer::setTool(Tool tool) {
    if (tool == tool_) {
        return;
    }
    tool_ = tool;
    draft_.clear();
    setHovered(std::nullopt);
    setCursor(tool_ == Tool::Draw ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
    emit toolChanged();
    emit draftChanged();
}

double EditLayer::draftLengthM() const {
    if (draft_.empty() || !pointerInside_) {
        return 0.0;
    }
    return coordinate(draft_.back()).distanceTo(coordinate(camera()->toWorld(pointer_)));
}

void EditLayer::finishDraft() {
    if (tool_ != Tool::Draw || draft_.size() < 3) {
        return;
    }
    QList<QGeoCoordinate> points;
    std::ranges::transform(draft_, std::back_inserter(points), [](WorldPoint p) { return coordinate(p); });
    setTool(Tool::Select);
    emit boundaryDrawn(points);
}

void EditLayer::cancelDraft() {
    setTool(Tool::Select);
}

void EditLayer::removeLastPoint() {
    if (!draft_.empty()) {
        draft_.pop_back();
        update();
        emit draftChanged();
    }
}

std::optional<EditLayer::Vertex> EditLayer::vertexAt(QPointF pixel) const {
    std::optional<Vertex> nearest;
    double reach = kReachPx;
    for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
        for (std::size_t i = 0; i < rings_[ring].points.size(); ++i) {
            const double away = QLineF{camera()->toItem(rings_[ring].points[i]), pixel}.length();
            if (away <= reach) {
                reach = away;
                nearest = Vertex{ring, i};
            }
        }
    }
    return nearest;
}

void EditLayer::setHovered(std::optional<Vertex> vertex) {
    if (vertex != hovered_) {
        hovered_ = vertex;
        setCursor(hovered_ ? Qt::SizeAllCursor : tool_ == Tool::Draw ? Qt::CrossCursor : Qt::ArrowCursor);
        update();
    }
}

void EditLayer::mousePressEvent(QMouseEvent* event) {
    forceActiveFocus(Qt::MouseFocusReason);
    pressed_ = pointer_ = event->position();
    moved_ = false;
    if (tool_ == Tool::Select && event->button() == Qt::LeftButton) {
        const std::optional<Vertex> vertex = vertexAt(pressed_);
        setHovered(vertex);
        if (vertex) {
            grabbed_ = vertex;
            setKeepMouseGrab(true);
            emit draggingChanged();
        }
    }
    event->accept();
}

void EditLayer::mouseMoveEvent(QMouseEvent* event) {
    const QPointF before = pointer_;
    pointer_ = event->position();
    if (!moved_ && QLineF{pressed_, pointer_}.length() < kDragPx) {
        pointer_ = before;
        return;
    }
    moved_ = true;
    if (grabbed_) {
        moveGrabbed(pointer_, false);
    } else {
        setCursor(Qt::ClosedHandCursor);
        camera()->panBy(pointer_.x() - before.x(), pointer_.y() - before.y());
    }
}

void EditLayer::mouseReleaseEvent(QMouseEvent* event) {
    release(event->position());
}

void EditLayer::mouseUngrabEvent() {
    if (grabbed_) {
        release(pointer_);
    }
}

void EditLayer::release(QPointF pixel) {
    setKeepMouseGrab(false);
    if (grabbed_) {
        if (moved_) {
            moveGrabbed(pixel, true);
        }
        grabbed_.reset();
        emit draggingChanged();
        update();
        return;
    }
    setCursor(tool_ == Tool::Draw ? Qt::CrossCursor : Qt::ArrowCursor);
    if (moved_) {
        return;
    }
    if (tool_ == Tool::Select) {
        emit clicked(pixel);
        return;
    }
    if (draft_.size() >= 3 && QLineF{camera()->toItem(draft_.front()), pixel}.length() <= kReachPx) {
        finishDraft();
        return;
    }
    draft_.push_back(camera()->toWorld(pixel));
    update();
    emit draftChanged();
}

void EditLayer::moveGrabbed(QPointF pixel, bool finished) {
    EditableRing& ring = rings_[grabbed_->ring];
    const WorldPoint place = camera()->toWorld(pixel);
    ring.points[grabbed_->index] = place;
    update();
    emit vertexMoved(ring.part, ring.ring, static_cast<int>(grabbed_->index), coordinate(place), finished);
}

void EditLayer::hoverMoveEvent(QHoverEvent* event) {
    pointer_ = event->position();
    pointerInside_ = true;
    if (tool_ == Tool::Draw) {
        update();
        emit draftChanged();
    } else if (!grabbed_) {
        setHovered(vertexAt(pointer_));
        if (!rings_.empty()) {
            update();
        }
    }
    event->ignore();
}

void EditLayer::hoverLeaveEvent(QHoverEvent*) {
    pointerInside_ = false;
    setHovered(std::nullopt);
    update();
}

void EditLayer::wheelEvent(QWheelEvent* event) {
    const double notches = event->angleDelta().y() / 120.0;
    camera()->zoomAt(event->position(), notches * kLevelsPerNotch, std::abs(notches) >= 0.5);
    event->accept();
}

QSGNode* EditLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* root = static_cast<EditRoot*>(old);
    if (root == nullptr) {
        root = new EditRoot;
    }
    LineMesh line;
    LineMesh rubber;
    LineMesh handles;
    LineMesh active;
    const auto toPixels = [this](const std::vector<WorldPoint>& points) {
        std::vector<MapPoint> pixels;
        std::ranges::transform(points, std::back_inserter(pixels),
                               [this](WorldPoint p) { return pixelPoint(camera()->toItem(p)); });
        return pixels;
    };
    if (tool_ == Tool::Draw) {
        const std::vector<MapPoint> pixels = toPixels(draft_);
        if (pixels.size() > 1) {
            line.add(pixels);
        }
        if (!pixels.empty() && pointerInside_) {
            std::vector<MapPoint> open{pixels.back(), pixelPoint(pointer_)};
            if (pixels.size() > 1) {
                open.push_back(pixels.front());
            }
            rubber.add(open);
        }
        for (const MapPoint pixel : pixels) {
            handles.add(std::array{pixel});
        }
        if (pixels.size() >= 3 &&
            QLineF{QPointF{double{pixels.front().x}, double{pixels.front().y}}, pointer_}.length() <= kReachPx) {
            active.add(std::array{pixels.front()});
        }
    } else {
        for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
            const std::vector<MapPoint> pixels = toPixels(rings_[ring].points);
            if (grabbed_ && grabbed_->ring == ring) {
                line.add(pixels, true);
            }
            for (std::size_t i = 0; i < pixels.size(); ++i) {
                const MapPoint next = pixels[i + 1 == pixels.size() ? 0 : i + 1];
                const MapPoint last = pixels[i == 0 ? pixels.size() - 1 : i - 1];
                const QPointF pixel{double{pixels[i].x}, double{pixels[i].y}};
                const bool crowded = std::max(std::hypot(next.x - pixels[i].x, next.y - pixels[i].y),
                                              std::hypot(last.x - pixels[i].x, last.y - pixels[i].y)) < kCrowdedPx;
                if (hovered_ == Vertex{ring, i} || grabbed_ == Vertex{ring, i}) {
                    addDisc(active, pixel);
                } else if (pointerInside_ && !crowded && QLineF{pixel, pointer_}.length() < kHandlesPx) {
                    addDisc(handles, pixel);
                }
            }
        }
    }
    const double ratio = devicePixelRatio();
    root->set(EditRoot::Casing, line, {.color = casingColor_, .widthPx = 4.6}, ratio);
    root->set(EditRoot::Line, line, {.color = lineColor_, .widthPx = 2.4}, ratio);
    root->set(EditRoot::Rubber, rubber, {.color = accentColor_, .widthPx = 1.6, .dashPx = 6.0, .periodPx = 10.0}, ratio);
    root->set(EditRoot::HandleEdge, handles, {.color = casingColor_, .widthPx = 9.0}, ratio);
    root->set(EditRoot::HandleFace, handles, {.color = handleColor_, .widthPx = 6.4}, ratio);
    root->set(EditRoot::ActiveEdge, active, {.color = handleColor_, .widthPx = 17.0}, ratio);
    root->set(EditRoot::ActiveFace, active, {.color = accentColor_, .widthPx = 13.0}, ratio);
    return root;
}

}  // namespace furrow
