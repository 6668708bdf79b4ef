#include "ui/edit/edit_layer.h"

#include "ui/map/mesh_nodes.h"

#include <QCursor>
#include <QLineF>
#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace furrow {

namespace {

constexpr double kReachPx = 11.0;
constexpr double kDragPx = 4.0;
/// Handles closer together than this would hide the boundary.
constexpr double kCrowdedPx = 12.0;
/// Of outlines that are not selected, handles are shown around the pointer only.
constexpr double kHandlesPx = 130.0;
/// Of the selected outline at all times, but no more than this many, and not closer together than this: a
/// surveyed boundary would be all handles.
constexpr std::size_t kMostHandles = 160;
constexpr double kRoomyPx = 16.0;
/// An edge has room for the handle in its middle from here on.
constexpr double kEdgeWithMiddlePx = 52.0;
/// Beyond the border of the map.
constexpr double kBorderPx = 12.0;

/// Lines and discs in pixels of the item, so nothing has to follow the camera.
struct EditRoot : QSGNode {
    std::array<LineNode*, 16> nodes{};
    enum Slot {
        GuideCasing,
        Guide,
        SplitCasing,
        Split,
        Obstacles,
        Casing,
        Line,
        Rubber,
        Snap,
        HandleEdge,
        HandleFace,
        AddEdge,
        AddFace,
        MiddleFace,
        ActiveEdge,
        ActiveFace
    };

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

struct EditLayer::Marks {
    LineMesh guide;
    LineMesh split;
    LineMesh obstacles;
    LineMesh line;
    LineMesh rubber;
    LineMesh snap;
    LineMesh handles;
    LineMesh adds;  ///< in the middle of edges, to be dragged to a new vertex
    LineMesh middles;
    LineMesh active;
};

EditLayer::EditLayer(QQuickItem* parent) : MapLayer{parent} {
    setActiveFocusOnTab(true);
    setAcceptedMouseButtons(Qt::LeftButton | Qt::MiddleButton);
    setAcceptHoverEvents(true);
    connect(this, &EditLayer::styleChanged, this, &QQuickItem::update);
}

void EditLayer::setEditor(FieldEditor* editor) {
    editor_ = editor;
    connect(editor_, &FieldEditor::changed, this, [this] {
        convert();
        showCursor();
        update();
    });
    convert();
    emit editorChanged();
}

double EditLayer::traceTolerance() const {
    // Asked for before it has a camera, while the window is made.
    return camera() == nullptr ? 0.0 : FieldEditor::kTraceShare * kReachPx * camera()->metresPerPixel();
}

void EditLayer::convert() {
    world_.clear();
    if (!editor_->shape()) {
        return;
    }
    for (const Outline& outline : editor_->shape()->outlines) {
        std::vector<WorldPoint>& points = world_.emplace_back();
        points.reserve(outline.places.size());
        std::ranges::transform(outline.places, std::back_inserter(points),
                               [](GeoPoint place) { return worldPoint(place); });
    }
}

FieldEditor::Pointer EditLayer::pointerAt(QPointF pixel, Qt::KeyboardModifiers modifiers) const {
    return {.place = geoPoint(camera()->toWorld(pixel)),
            .reach = metres(kReachPx * camera()->metresPerPixel()),
            .free = modifiers.testFlag(Qt::AltModifier)};
}

QPointF EditLayer::pixelOf(Point place) const {
    return camera()->toItem(worldPoint(editor_->frame()->toGeo(place)));
}

QPointF EditLayer::pixelOf(const Outline& outline, std::size_t vertex) const {
    return camera()->toItem(worldPoint(outline.places[vertex]));
}

void EditLayer::showCursor() {
    const auto& hovered = editor_->hovered();
    setCursor(editor_->isDrawing()                      ? Qt::CrossCursor
              : !hovered                                ? Qt::ArrowCursor
              : hovered->kind == ShapeHit::Kind::Inside ? Qt::PointingHandCursor
              : hovered->kind == ShapeHit::Kind::Edge   ? Qt::OpenHandCursor
                                                        : Qt::SizeAllCursor);
}

void EditLayer::mousePressEvent(QMouseEvent* event) {
    forceActiveFocus(Qt::MouseFocusReason);
    pressed_ = pointer_ = event->position();
    moved_ = false;
    grabbed_ = event->button() == Qt::LeftButton && editor_->press(pointerAt(pressed_, event->modifiers()));
    setKeepMouseGrab(grabbed_);
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
        editor_->drag(pointerAt(pointer_, event->modifiers()));
    } else {
        setCursor(Qt::ClosedHandCursor);
        camera()->panBy(pointer_.x() - before.x(), pointer_.y() - before.y());
    }
}

void EditLayer::mouseReleaseEvent(QMouseEvent* event) {
    setKeepMouseGrab(false);
    const FieldEditor::Pointer pointer = pointerAt(event->position(), event->modifiers());
    if (std::exchange(grabbed_, false)) {
        moved_ ? editor_->release(pointer) : editor_->letGo();
        return;
    }
    showCursor();
    if (moved_) {
        return;
    }
    handled_ = false;
    if (!editor_->isDrawing()) {
        emit clicked(event->position());
    }
    if (!handled_) {
        editor_->click(pointer);
    }
}

void EditLayer::mouseDoubleClickEvent(QMouseEvent* event) {
    if (editor_->isDrawing() && editor_->sketchCount() >= editor_->sketchNeeded()) {
        editor_->finishSketch();
        // Its release is no click of its own.
        moved_ = true;
    }
    event->accept();
}

void EditLayer::mouseUngrabEvent() {
    if (std::exchange(grabbed_, false)) {
        editor_->letGo();
    }
}

void EditLayer::hoverMoveEvent(QHoverEvent* event) {
    pointer_ = event->position();
    pointerInside_ = true;
    if (!grabbed_) {
        editor_->hover(pointerAt(pointer_, event->modifiers()));
        update();
    }
    event->ignore();
}

void EditLayer::hoverLeaveEvent(QHoverEvent*) {
    pointerInside_ = false;
    editor_->leave();
}

void EditLayer::wheelEvent(QWheelEvent* event) {
    camera()->turnWheel(event->position(), event->angleDelta().y());
    event->accept();
}

void EditLayer::addSketch(Marks& marks) const {
    std::vector<MapPoint> pixels;
    for (const GeoPoint place : editor_->sketch()) {
        pixels.push_back(pixelPoint(camera()->toItem(worldPoint(place))));
    }
    if (pixels.size() > 1) {
        LineMesh& mesh = editor_->tool() == FieldEditor::Tool::Split   ? marks.split
                         : editor_->tool() == FieldEditor::Tool::Guide ? marks.guide
                                                                       : marks.line;
        mesh.add(pixels);
    }
    if (editor_->cursor()) {
        const QPointF cursor = camera()->toItem(worldPoint(*editor_->cursor()));
        if (!pixels.empty()) {
            std::vector<MapPoint> open{pixels.back(), pixelPoint(cursor)};
            if (pixels.size() > 1 && !editor_->isDraftOpen()) {
                open.push_back(pixels.front());
            }
            marks.rubber.add(open);
        }
        if (editor_->snap() && editor_->snap()->isSnapped()) {
            addDisc(marks.active, cursor);
        }
    }
    for (const MapPoint pixel : pixels) {
        marks.handles.add(std::array{pixel});
    }
}

void EditLayer::addHandles(Marks& marks, const std::vector<MapPoint>& pixels, bool closed) const {
    const auto isInView = [this](MapPoint pixel) {
        return pixel.x > -kBorderPx && pixel.y > -kBorderPx && pixel.x < width() + kBorderPx &&
               pixel.y < height() + kBorderPx;
    };
    const auto distance = [](MapPoint a, MapPoint b) { return std::hypot(b.x - a.x, b.y - a.y); };
    std::vector<std::size_t> shown;
    for (double apart = kRoomyPx; shown.empty() || shown.size() > kMostHandles; apart *= 1.5) {
        shown.clear();
        for (std::size_t k = 0; k < pixels.size(); ++k) {
            const bool isRoomy = shown.empty() || (distance(pixels[shown.back()], pixels[k]) >= apart &&
                                                   distance(pixels[shown.front()], pixels[k]) >= apart);
            if (isInView(pixels[k]) && isRoomy) {
                shown.push_back(k);
            }
        }
        if (shown.empty()) {
            break;
        }
    }
    for (const std::size_t k : shown) {
        marks.handles.add(std::array{pixels[k]});
    }
    const std::size_t edges = closed ? pixels.size() : pixels.size() - 1;
    std::size_t middles = 0;
    for (std::size_t k = 0; k < edges && middles < kMostHandles; ++k) {
        const MapPoint next = pixels[k + 1 == pixels.size() ? 0 : k + 1];
        const MapPoint middle{(pixels[k].x + next.x) / 2.0F, (pixels[k].y + next.y) / 2.0F};
        if (isInView(middle) && distance(pixels[k], next) >= kEdgeWithMiddlePx) {
            marks.adds.add(std::array{middle});
            ++middles;
        }
    }
}

void EditLayer::addVertices(Marks& marks, const OutlineId& id, const std::vector<MapPoint>& pixels) const {
    const Selection& chosen = editor_->selection();
    const auto& hovered = editor_->hovered();
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        const QPointF pixel{double{pixels[k].x}, double{pixels[k].y}};
        const bool isChosen = chosen.isOf(Selection::Kind::Vertex, id, k);
        const bool isHovered = hovered && hovered->kind == ShapeHit::Kind::Vertex && hovered->outline == id &&
                               hovered->index == k;
        if (isChosen || isHovered) {
            addDisc(marks.active, pixel);
            continue;
        }
        const MapPoint next = pixels[k + 1 == pixels.size() ? 0 : k + 1];
        const MapPoint last = pixels[k == 0 ? pixels.size() - 1 : k - 1];
        const bool crowded = std::max(std::hypot(next.x - pixels[k].x, next.y - pixels[k].y),
                                      std::hypot(last.x - pixels[k].x, last.y - pixels[k].y)) < kCrowdedPx;
        if (pointerInside_ && !crowded && QLineF{pixel, pointer_}.length() < kHandlesPx) {
            addDisc(marks.handles, pixel);
        }
    }
}

void EditLayer::addSelection(Marks& marks) const {
    const Selection& chosen = editor_->selection();
    const auto& hovered = editor_->hovered();
    const auto& outlines = editor_->shape()->outlines;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const Outline& outline = outlines[i];
        std::vector<MapPoint> pixels;
        std::ranges::transform(world_[i], std::back_inserter(pixels),
                               [this](WorldPoint p) { return pixelPoint(camera()->toItem(p)); });
        if (outline.id.kind == OutlineKind::Guide) {
            marks.guide.add(pixels);
        } else if (outline.id.kind == OutlineKind::Split) {
            marks.split.add(pixels);
        }
        if (chosen.outline == outline.id &&
            (chosen.kind == Selection::Kind::Guide || chosen.kind == Selection::Kind::Split)) {
            marks.snap.add(pixels);
        }
        const bool whole = chosen.outline == outline.id &&
                           (chosen.kind == Selection::Kind::Hole || chosen.kind == Selection::Kind::Obstacle);
        if (whole || (editor_->isAhead() && outline.closed)) {
            LineMesh& mesh =
                !whole && outline.id.kind == OutlineKind::Obstacle ? marks.obstacles : marks.line;
            mesh.add(pixels, outline.closed);
        }
        const auto edgeOf = [&](std::size_t edge) {
            return std::array{pixels[edge], pixels[edge + 1 == pixels.size() ? 0 : edge + 1]};
        };
        if (chosen.outline == outline.id && chosen.kind == Selection::Kind::Edge &&
            chosen.index < outline.edgeCount()) {
            marks.snap.add(edgeOf(chosen.index));
        } else if (hovered && hovered->outline == outline.id && hovered->kind == ShapeHit::Kind::Edge &&
                   !editor_->isDragging()) {
            marks.snap.add(edgeOf(hovered->index));
        }
        const bool isSelected = chosen.outline == outline.id && chosen.isOutline();
        if (isSelected && !pixels.empty()) {
            addHandles(marks, pixels, outline.closed);
        }
        addVertices(marks, outline.id, pixels);
    }
    if (const auto middle = editor_->midpointHandle()) {
        addDisc(marks.middles, pixelOf(*middle));
    }
    if (const auto buffer = editor_->bufferHandle()) {
        addDisc(marks.middles, pixelOf(*buffer));
    }
    for (std::size_t gate = 0; gate < editor_->shape()->gates.size(); ++gate) {
        const bool active = chosen.isOf(Selection::Kind::Gate, chosen.outline, gate) ||
                            (hovered && hovered->kind == ShapeHit::Kind::Gate && hovered->index == gate);
        addDisc(active ? marks.active : marks.middles, pixelOf(editor_->shape()->gates[gate]));
    }
    if (editor_->snap() && editor_->isDragging()) {
        for (const Point from : editor_->snap()->from) {
            marks.rubber.add(
                std::array{pixelPoint(pixelOf(from)), pixelPoint(pixelOf(editor_->snap()->place))});
        }
    }
}

EditLayer::Marks EditLayer::marks() const {
    Marks marks;
    if (editor_->isDrawing()) {
        addSketch(marks);
    } else if (editor_->shape() && world_.size() == editor_->shape()->outlines.size()) {
        addSelection(marks);
    }
    return marks;
}

QSGNode* EditLayer::updatePaintNode(QSGNode* old, UpdatePaintNodeData*) {
    auto* root = static_cast<EditRoot*>(old);
    if (root == nullptr) {
        root = new EditRoot;
    }
    const Marks shown = marks();
    const double ratio = devicePixelRatio();
    root->set(EditRoot::GuideCasing, shown.guide, {.color = casingColor_, .widthPx = 4.4}, ratio);
    root->set(EditRoot::Guide, shown.guide, {.color = guideColor_, .widthPx = 2.4}, ratio);
    root->set(EditRoot::SplitCasing, shown.split, {.color = handleColor_, .widthPx = 4.4}, ratio);
    root->set(EditRoot::Split, shown.split,
              {.color = splitColor_, .widthPx = 2.2, .dashPx = 9.0, .periodPx = 14.0}, ratio);
    // As the plan's layer draws them, so that nothing jumps when it takes over.
    root->set(EditRoot::Obstacles, shown.obstacles, {.color = obstacleColor_, .widthPx = 1.6 * lineFactor_},
              ratio);
    root->set(EditRoot::Casing, shown.line, {.color = casingColor_, .widthPx = 4.6 * lineFactor_}, ratio);
    root->set(EditRoot::Line, shown.line, {.color = lineColor_, .widthPx = 2.4 * lineFactor_}, ratio);
    root->set(EditRoot::Rubber, shown.rubber,
              {.color = accentColor_, .widthPx = 1.6, .dashPx = 6.0, .periodPx = 10.0}, ratio);
    root->set(EditRoot::Snap, shown.snap, {.color = accentColor_, .widthPx = 4.0}, ratio);
    root->set(EditRoot::HandleEdge, shown.handles, {.color = casingColor_, .widthPx = 9.0}, ratio);
    root->set(EditRoot::HandleFace, shown.handles, {.color = handleColor_, .widthPx = 6.4}, ratio);
    root->set(EditRoot::AddEdge, shown.adds, {.color = casingColor_, .widthPx = 7.4}, ratio);
    root->set(EditRoot::AddFace, shown.adds, {.color = accentColor_, .widthPx = 5.0}, ratio);
    root->set(EditRoot::MiddleFace, shown.middles, {.color = accentColor_, .widthPx = 9.0}, ratio);
    root->set(EditRoot::ActiveEdge, shown.active, {.color = handleColor_, .widthPx = 17.0}, ratio);
    root->set(EditRoot::ActiveFace, shown.active, {.color = accentColor_, .widthPx = 13.0}, ratio);
    return root;
}

}  // namespace furrow
