#include "ui/edit/field_editor.h"

#include "planner/editing/outline_edits.h"
#include "planner/geometry/simplify.h"
#include "planner/plan/plan_hit.h"
#include "planner/project/project_edits.h"

#include <algorithm>
#include <array>
#include <utility>

namespace furrow {

namespace {

/// An edge that is shorter than this many reaches of the pointer is all ends: there is nothing to hold it by.
constexpr double kLeastEdgeReaches = 4.0;

Selection::Kind kindOf(ShapeHit::Kind kind, OutlineKind of) {
    switch (kind) {
        case ShapeHit::Kind::Vertex: return Selection::Kind::Vertex;
        case ShapeHit::Kind::Edge: return Selection::Kind::Edge;
        case ShapeHit::Kind::Gate: return Selection::Kind::Gate;
        case ShapeHit::Kind::Inside: break;
    }
    return of == OutlineKind::Hole ? Selection::Kind::Hole : Selection::Kind::Obstacle;
}

Point middleOf(const Outline& outline, std::size_t edge) {
    return 0.5 * (outline.from(edge) + outline.to(edge));
}

}  // namespace

const Project& FieldEditor::project() const {
    return *document_->project();
}

void FieldEditor::setDocument(Document* document) {
    document_ = document;
    connect(document_, &Document::projectChanged, this, &FieldEditor::follow);
    follow();
    emit documentChanged();
}

void FieldEditor::setShown(ShownPlan* shown) {
    shown_ = shown;
    connect(shown_, &ShownPlan::drawingChanged, this, &FieldEditor::changed);
    connect(shown_, &ShownPlan::planChanged, this, &FieldEditor::followPlan);
    emit shownChanged();
}

void FieldEditor::followPlan() {
    const auto before = std::exchange(plan_, shown_->plan());
    if (selection_.kind < Selection::Kind::Segment) {
        return;
    }
    // Segments, cells and findings of another plan are other ones. Where it is only better than a first one,
    // the stretch that the user looks at is mostly in it, too.
    std::optional<std::size_t> same;
    if (before && plan_ && before->request.draft && selection_.kind == Selection::Kind::Segment &&
        selection_.index < before->path.segments.size()) {
        same = sameStretch(before->path.segments[selection_.index], plan_->path);
    }
    selectSegment(same ? static_cast<int>(*same) : -1);
}

bool FieldEditor::isAhead() const {
    return isDragging() || (shown_ != nullptr && shown_->isBehind());
}

void FieldEditor::findSteps() {
    const ProjectField* const field = project().field();
    const auto source = field == nullptr ? nullptr : field->source;
    // While a point is dragged nobody looks for steps.
    if (source == stepsOf_ || isDragging()) {
        return;
    }
    stepsOf_ = source;
    if (project().fields.size() < 2) {
        stepsLeft_.clear();
    }
    steps_ = source == nullptr ? std::nullopt : stepsOf(*source);
    stepsError_.reset();
    emit stepsChanged();
}

void FieldEditor::follow() {
    const ProjectField* field = project().field();
    const std::string id = field == nullptr ? std::string{} : field->id;
    const bool same = id == fieldId_ && shape_;
    if (field != nullptr) {
        auto shape = FieldShape::of(*field->source, linesOf(project()), same ? &*shape_ : nullptr);
        shape_ = shape ? std::optional{std::move(*shape)} : std::nullopt;
    } else {
        shape_.reset();
    }
    fieldId_ = id;
    if (shape_) {
        frame_ = shape_->frame;
    } else if (sketch_.empty()) {
        frame_.reset();
    }
    if (canDrawAgain()) {
        takenBack_.clear();
        emit sketchChanged();
    }
    findSteps();
    hovered_.reset();
    // What was selected may be gone, as after undoing.
    const bool ofShape = selection_.kind < Selection::Kind::Segment;
    const Outline* outline = selectedOutline();
    const bool isOutline = selection_.kind != Selection::Kind::Gate;
    const bool gone = !same || !shape_ ||
                      (isOutline ? outline == nullptr : selection_.index >= shape_->gates.size()) ||
                      (outline != nullptr && selection_.index >= outline->points.size());
    if (ofShape && gone && !selection_.isNone()) {
        select({});
    } else {
        emit selectionChanged();
    }
    emit changed();
}

const Outline* FieldEditor::selectedOutline() const {
    const bool isOutline = selection_.kind >= Selection::Kind::Vertex &&
                           selection_.kind <= Selection::Kind::Split &&
                           selection_.kind != Selection::Kind::Gate;
    return isOutline && shape_ ? shape_->find(selection_.outline) : nullptr;
}

std::optional<Point> FieldEditor::midpointHandle() const {
    if (!shape_ || isDrawing()) {
        return std::nullopt;
    }
    const bool overEdge = hovered_ && hovered_->kind == ShapeHit::Kind::Edge;
    const bool edgeSelected = selection_.kind == Selection::Kind::Edge;
    if (!overEdge && !edgeSelected) {
        return std::nullopt;
    }
    const Outline* outline = shape_->find(overEdge ? hovered_->outline : selection_.outline);
    const std::size_t edge = overEdge ? hovered_->index : selection_.index;
    return outline != nullptr && edge < outline->edgeCount() ? std::optional{middleOf(*outline, edge)}
                                                             : std::nullopt;
}

std::optional<Point> FieldEditor::bufferHandle() const {
    const Outline* outline = selection_.kind == Selection::Kind::Obstacle ? selectedOutline() : nullptr;
    const ProjectField* field = project().field();
    if (outline == nullptr || field == nullptr || outline->points.empty()) {
        return std::nullopt;
    }
    const Point east = *std::ranges::max_element(outline->points, {}, &Point::x);
    return east + Point{field->source->obstacles[outline->id.item].buffer.si(), 0.0};
}

void FieldEditor::hover(const Pointer& pointer) {
    cursor_ = pointer.place;
    if (isDrawing()) {
        if (frame_) {
            cursor_ = frame_->toGeo(snappedTo(pointer, sketchLines()));
        }
        emit sketchChanged();
        emit changed();
        return;
    }
    if (!shape_) {
        return;
    }
    const Point place = local(pointer.place);
    auto hit = hitAt(*shape_, place, pointer.reach);
    if (hit && hit->kind == ShapeHit::Kind::Edge) {
        const Outline& outline = *shape_->find(hit->outline);
        if (distance(outline.from(hit->index), outline.to(hit->index)) <
            kLeastEdgeReaches * pointer.reach.si()) {
            hit.reset();
        }
    }
    hovered_ = hit;
    emit changed();
}

void FieldEditor::leave() {
    cursor_.reset();
    hovered_.reset();
    snap_.reset();
    emit sketchChanged();
    emit changed();
}

bool FieldEditor::press(const Pointer& pointer) {
    if (isDrawing()) {
        if (freehand_ && tool_ != Tool::Gate) {
            grip_ = Grip::Trace;
            addPoint(pointer.place);
            emit draggingChanged();
            return true;
        }
        return false;
    }
    if (!shape_) {
        return false;
    }
    const Point place = local(pointer.place);
    auto middle = midpointHandle();
    const auto buffer = bufferHandle();
    hover(pointer);
    if (!middle && hovered_ && selection_.isOutline() && selection_.outline == hovered_->outline) {
        // A finger hovers over nothing before; the handles of what is selected are there for it to see.
        middle = midpointHandle();
    }
    const auto within = [&](const std::optional<Point>& handle) {
        return handle && distance(*handle, place) <= pointer.reach.si();
    };
    before_ = shape_;
    sourceBefore_ = *project().field()->source;
    pressed_ = place;
    if (within(buffer)) {
        grip_ = Grip::Buffer;
    } else if (!hovered_) {
        return false;
    } else if (hovered_->kind == ShapeHit::Kind::Edge && within(middle)) {
        const ShapeHit edge = *hovered_;
        setOutline(QT_TR_NOOP("Add a point"), edge.outline,
                   withVertexOn(*shape_->find(edge.outline), *frame_, edge.index, place),
                   Document::Follows::More);
        select({.kind = Selection::Kind::Vertex, .outline = edge.outline, .index = edge.index + 1});
        before_ = shape_;
        grip_ = Grip::Vertex;
    } else {
        const Selection hit{.kind = kindOf(hovered_->kind, hovered_->outline.kind),
                            .outline = hovered_->outline,
                            .index = hovered_->index};
        const bool was = hit == selection_;
        // A large obstacle must not keep the map from being moved: it is moved once it is selected.
        if (hovered_->kind == ShapeHit::Kind::Inside && !was) {
            return false;
        }
        select(hit);
        grip_ = hovered_->kind == ShapeHit::Kind::Vertex ? Grip::Vertex
                : hovered_->kind == ShapeHit::Kind::Edge ? Grip::Edge
                : hovered_->kind == ShapeHit::Kind::Gate ? Grip::Gate
                                                         : Grip::Inside;
    }
    emit draggingChanged();
    return true;
}

void FieldEditor::drag(const Pointer& pointer) {
    if (grip_ == Grip::Trace) {
        addPoint(pointer.place);
    } else if (grip_ != Grip::None) {
        moveGrip(pointer, Document::Follows::More);
    }
}

void FieldEditor::release(const Pointer& pointer) {
    if (grip_ == Grip::Trace) {
        // Half the reach of the pointer is what a hand cannot do better anyway.
        const Polyline line = simplified(frame_->toLocal(sketch_), kTraceShare * pointer.reach);
        sketch_ = frame_->toGeo(line);
        endGrip();
        emit sketchChanged();
        finishSketch();
        return;
    }
    if (grip_ != Grip::None) {
        moveGrip(pointer, Document::Follows::Nothing);
        endGrip();
    }
}

void FieldEditor::endGrip() {
    if (grip_ == Grip::None) {
        return;
    }
    grip_ = Grip::None;
    before_.reset();
    sourceBefore_.reset();
    snap_.reset();
    document_->endDrag();
    emit draggingChanged();
    emit changed();
}

void FieldEditor::click(const Pointer& pointer) {
    if (isDrawing()) {
        // Closing where it began: the first point is caught like any other.
        if (sketch_.size() >= 3 && tool_ != Tool::Guide && frame_ &&
            distance(local(sketch_.front()), local(pointer.place)) <= pointer.reach.si()) {
            finishSketch();
            return;
        }
        GeoPoint place = pointer.place;
        if (frame_) {
            place = frame_->toGeo(snappedTo(pointer, sketchLines()));
        }
        addPoint(place);
        return;
    }
    if (hovered_) {
        select({.kind = kindOf(hovered_->kind, hovered_->outline.kind),
                .outline = hovered_->outline,
                .index = hovered_->index});
        return;
    }
    pickFromPlan(pointer);
}

void FieldEditor::pickFromPlan(const Pointer& pointer) {
    const auto& plan = shown_->plan();
    if (!plan) {
        select({});
        return;
    }
    const Point place = plan->field().frame().toLocal(pointer.place);
    if (const auto segment = segmentAt(*plan, place, pointer.reach)) {
        select({.kind = Selection::Kind::Segment, .outline = {}, .index = *segment});
        emit segmentClicked(static_cast<int>(*segment));
    } else if (const auto cell = cellAt(*plan, place); cell && plan->cells.cells.size() > 1) {
        select({.kind = Selection::Kind::Cell, .outline = {}, .index = *cell});
    } else {
        select({});
    }
}

std::vector<SnapLine> FieldEditor::linesAt(const Outline& outline, std::size_t vertex) const {
    std::vector<SnapLine> lines;
    const std::size_t count = outline.points.size();
    for (const int side : {-1, 1}) {
        const auto at = [&](int steps) -> std::optional<Point> {
            const int index = static_cast<int>(vertex) + side * steps;
            if (!outline.closed && (index < 0 || index >= static_cast<int>(count))) {
                return std::nullopt;
            }
            return outline.points[static_cast<std::size_t>((index + 2 * static_cast<int>(count)) %
                                                           static_cast<int>(count))];
        };
        if (const auto anchor = at(1), beyond = at(2); anchor && beyond && count > 3) {
            std::ranges::move(angleLines(*anchor, *beyond), std::back_inserter(lines));
        }
    }
    return lines;
}

Point FieldEditor::snappedTo(const Pointer& pointer, std::span<const SnapLine> lines,
                             std::optional<std::pair<OutlineId, std::size_t>> except) {
    const Point place = local(pointer.place);
    snap_.reset();
    if (pointer.free) {
        return place;
    }
    static const std::vector<Outline> none;
    const FieldShape alone{.frame = *frame_, .outlines = none, .gates = {}};
    snap_ = snapped(shape_ ? *shape_ : alone, place, pointer.reach, lines, except);
    return snap_->place;
}

void FieldEditor::moveGrip(const Pointer& pointer, Document::Follows follows) {
    if (!before_ || !sourceBefore_) {
        return;
    }
    const Outline* outline = before_->find(selection_.outline);
    const Point place = local(pointer.place);
    const Point way = place - pressed_;
    snap_.reset();
    switch (grip_) {
        case Grip::Vertex:
            if (outline != nullptr && selection_.index < outline->points.size()) {
                const Point to = snappedTo(pointer, linesAt(*outline, selection_.index),
                                           std::pair{outline->id, selection_.index});
                setOutline(QT_TR_NOOP("Move a point"), outline->id,
                           withVertexAt(*outline, *frame_, selection_.index, to), follows);
            }
            break;
        case Grip::Edge:
            if (outline != nullptr && selection_.index < outline->edgeCount()) {
                const Point along = outline->to(selection_.index) - outline->from(selection_.index);
                const double sideways = cross(along, way) / std::max(norm(along), 1e-9);
                setOutline(QT_TR_NOOP("Move an edge"), outline->id,
                           withEdgeMoved(*outline, *frame_, selection_.index, metres(sideways)), follows);
            }
            break;
        case Grip::Inside:
            if (outline != nullptr) {
                setOutline(outline->id.kind == OutlineKind::Hole ? QT_TR_NOOP("Move a hole")
                                                                 : QT_TR_NOOP("Move an obstacle"),
                           outline->id, withAllMoved(*outline, *frame_, way), follows);
            }
            break;
        case Grip::Gate: {
            FieldSource source = *sourceBefore_;
            const auto at = nearestOnBoundary(*before_, place);
            source.gates[selection_.index].position = frame_->toGeo(at && !pointer.free ? *at : place);
            changeSource(QT_TR_NOOP("Move a gate"), std::move(source), follows);
            break;
        }
        case Grip::Buffer: {
            FieldSource source = *sourceBefore_;
            Length& buffer = source.obstacles[selection_.outline.item].buffer;
            buffer = metres(std::clamp(buffer.si() + way.x, 0.0, 1000.0));
            changeSource(QT_TR_NOOP("Change the buffer"), std::move(source), follows);
            break;
        }
        case Grip::None:
        case Grip::Trace: break;
    }
}

void FieldEditor::setOutline(const char* text, const OutlineId& id, GeoRing places,
                             Document::Follows follows) {
    if (id.kind == OutlineKind::Guide) {
        change(text, withGuide(project(), places), follows);
    } else if (id.kind == OutlineKind::Split) {
        std::vector<GeoRing> splits = linesOf(project()).splits;
        splits.at(id.item) = std::move(places);
        change(text, withSplits(project(), splits), follows);
    } else if (const ProjectField* field = project().field()) {
        changeSource(text, withOutline(*field->source, id, std::move(places)), follows);
    }
}

void FieldEditor::changeSource(const char* text, FieldSource source, Document::Follows follows) {
    change(text, withSource(project(), std::move(source)), follows);
}

void FieldEditor::change(const char* text, Project after, Document::Follows follows) {
    document_->change([text] { return tr(text); }, std::move(after),
                      isDragging() || follows == Document::Follows::More ? QStringLiteral("grip") : QString{},
                      follows);
}

void FieldEditor::select(const Selection& selection) {
    if (selection == selection_) {
        return;
    }
    selection_ = selection;
    emit selectionChanged();
    emit changed();
}

void FieldEditor::selectSegment(int index) {
    select(index < 0 ? Selection{}
                     : Selection{.kind = Selection::Kind::Segment,
                                 .outline = {},
                                 .index = static_cast<std::size_t>(index)});
}

void FieldEditor::selectFinding(int index) {
    select({.kind = Selection::Kind::Finding, .outline = {}, .index = static_cast<std::size_t>(index)});
}

bool FieldEditor::escape() {
    if (isDragging()) {
        // Back to where it was: the drag becomes no change at all.
        if (grip_ != Grip::Trace && sourceBefore_) {
            document_->endDrag();
            document_->undo();
        }
        sketch_.clear();
        endGrip();
        emit sketchChanged();
        return true;
    }
    if (isDrawing()) {
        cancelSketch();
        return true;
    }
    if (hasSelection()) {
        clearSelection();
        return true;
    }
    return false;
}

}  // namespace furrow
