#include "planner/editing/outline_edits.h"
#include "planner/field/outline_steps.h"
#include "planner/project/project_edits.h"
#include "planner/units/angle.h"
#include "ui/edit/field_editor.h"
#include "ui/map/map_frame.h"
#include "ui/text/message_text.h"
#include "ui/text/unit_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace furrow {

namespace {

constexpr Length kGateWidth = metres(6.0);

/// A boundary is no one thing to move or delete: its first vertex stands for it.
Selection::Kind wholeOf(OutlineKind kind) {
    switch (kind) {
        case OutlineKind::Hole: return Selection::Kind::Hole;
        case OutlineKind::Obstacle: return Selection::Kind::Obstacle;
        case OutlineKind::Guide: return Selection::Kind::Guide;
        case OutlineKind::Split: return Selection::Kind::Split;
        case OutlineKind::Boundary: break;
    }
    return Selection::Kind::Vertex;
}

bool isDrawnLine(const OutlineId& id) {
    return id.kind == OutlineKind::Guide || id.kind == OutlineKind::Split;
}

}  // namespace

// --- Drawing ------------------------------------------------------------------------------------------

int FieldEditor::sketchNeeded() const {
    return tool_ == Tool::Gate ? 1 : isDraftOpen() ? 2 : 3;
}

void FieldEditor::setTool(Tool tool) {
    if (tool != Tool::Select && tool != Tool::Field && !shape_) {
        return;
    }
    if (tool == tool_) {
        return;
    }
    tool_ = tool;
    sketch_.clear();
    takenBack_.clear();
    snap_.reset();
    hovered_.reset();
    frame_ = shape_ ? std::optional{shape_->frame} : std::nullopt;
    if (tool_ != Tool::Select) {
        select({});
    }
    emit toolChanged();
    emit sketchChanged();
    emit changed();
}

void FieldEditor::setFreehand(bool freehand) {
    if (freehand != freehand_) {
        freehand_ = freehand;
        emit freehandChanged();
    }
}

double FieldEditor::sketchLengthM() const {
    return sketch_.empty() || !cursor_ || !frame_ ? 0.0 : distance(local(sketch_.back()), local(*cursor_));
}

double FieldEditor::sketchBearingDeg() const {
    if (sketch_.empty() || !cursor_ || !frame_) {
        return 0.0;
    }
    const Point way = local(*cursor_) - local(sketch_.back());
    const double bearing = std::atan2(way.x, way.y) * 180.0 / std::numbers::pi;
    return bearing < 0.0 ? bearing + 360.0 : bearing;
}

std::vector<SnapLine> FieldEditor::sketchLines() const {
    std::vector<SnapLine> lines;
    if (sketch_.size() >= 2 && frame_) {
        lines = angleLines(local(sketch_.back()), local(sketch_[sketch_.size() - 2]));
        if (!isDraftOpen()) {
            // Where the closing edge meets the first one.
            std::ranges::move(angleLines(local(sketch_[0]), local(sketch_[1])), std::back_inserter(lines));
        }
    }
    return lines;
}

void FieldEditor::addPointAt(const QGeoCoordinate& place) {
    if (isDrawing() && (cursor_ || place.isValid())) {
        addPoint(cursor_ ? *cursor_ : geoPoint(place));
    }
}

void FieldEditor::addPointBy(double lengthM, double bearingDeg) {
    if (!isDrawing() || sketch_.empty() || !(lengthM > 0.0)) {
        return;
    }
    const double bearing = bearingDeg * std::numbers::pi / 180.0;
    addPoint(frame_->toGeo(local(sketch_.back()) + lengthM * Point{std::sin(bearing), std::cos(bearing)}));
}

void FieldEditor::addPoint(GeoPoint place) {
    if (!frame_) {
        const auto frame = LocalFrame::centredOn(place);
        if (!frame) {
            return;
        }
        frame_ = *frame;
    }
    if (!sketch_.empty() && distance(local(sketch_.back()), local(place)) < 1e-3) {
        return;
    }
    sketch_.push_back(place);
    takenBack_.clear();
    emit sketchChanged();
    emit changed();
    const bool straightGuide = tool_ == Tool::Guide && sketch_.size() == 2 && !canFollowCurves();
    if (grip_ != Grip::Trace && (tool_ == Tool::Gate || straightGuide)) {
        finishSketch();
    }
}

void FieldEditor::removeLastPoint() {
    if (!sketch_.empty()) {
        takenBack_.push_back(sketch_.back());
        sketch_.pop_back();
        emit sketchChanged();
        emit changed();
    }
}

void FieldEditor::drawAgain() {
    if (canDrawAgain()) {
        GeoRing left = std::move(takenBack_);
        const GeoPoint place = left.back();
        left.pop_back();
        addPoint(place);
        takenBack_ = std::move(left);
        emit sketchChanged();
    }
}

void FieldEditor::cancelSketch() {
    setTool(Tool::Select);
}

void FieldEditor::finishSketch() {
    if (sketchCount() < sketchNeeded()) {
        return;
    }
    finishTool(std::exchange(sketch_, {}));
}

void FieldEditor::finishTool(GeoRing points) {
    const Tool tool = tool_;
    const ProjectField* field = project().field();
    if (tool == Tool::Field) {
        const auto frame = LocalFrame::centredOn(points.front());
        points = turnedRing(std::move(points), *frame, true);
        QList<QGeoCoordinate> places;
        std::ranges::transform(points, std::back_inserter(places),
                               [](GeoPoint point) { return coordinate(point); });
        setTool(Tool::Select);
        emit fieldDrawn(places);
        return;
    }
    if (field == nullptr || !shape_) {
        setTool(Tool::Select);
        return;
    }
    const Point first = shape_->frame.toLocal(points.front());
    Selection made;
    if (tool == Tool::Hole) {
        const std::size_t part = partAt(*shape_, first).value_or(0);
        const std::size_t hole = field->source->parts[part].holes.size();
        made = {.kind = Selection::Kind::Hole, .outline = {OutlineKind::Hole, part, hole}, .index = 0};
        change(QT_TR_NOOP("Draw a hole"),
               withHole(project(), part, turnedRing(std::move(points), shape_->frame, false)));
    } else if (tool == Tool::Obstacle) {
        const std::size_t number = field->source->obstacles.size();
        made = {.kind = Selection::Kind::Obstacle, .outline = {OutlineKind::Obstacle, number, 0}, .index = 0};
        change(QT_TR_NOOP("Draw an obstacle"),
               withObstacle(
                   project(),
                   {.name = tr("Obstacle %1").arg(number + 1).toStdString(),
                    .outline = {.outer = turnedRing(std::move(points), shape_->frame, true), .holes = {}},
                    .passable = false,
                    .buffer = {}}));
    } else if (tool == Tool::Gate) {
        const std::size_t number = field->source->gates.size();
        const Point at = nearestOnBoundary(*shape_, first).value_or(first);
        made = {.kind = Selection::Kind::Gate, .outline = {}, .index = number};
        change(QT_TR_NOOP("Add a gate"),
               withGate(project(), {.name = tr("Gate %1").arg(number + 1).toStdString(),
                                    .position = shape_->frame.toGeo(at),
                                    .width = kGateWidth}));
    } else if (tool == Tool::Split) {
        std::vector<GeoRing> splits = linesOf(project()).splits;
        made = {
            .kind = Selection::Kind::Split, .outline = {OutlineKind::Split, splits.size(), 0}, .index = 0};
        splits.push_back(std::move(points));
        change(QT_TR_NOOP("Draw a split line"), withSplits(project(), splits));
    } else {
        made = {.kind = Selection::Kind::Guide, .outline = {OutlineKind::Guide, 0, 0}, .index = 0};
        change(points.size() > 2 ? QT_TR_NOOP("Draw a guidance curve") : QT_TR_NOOP("Draw an AB line"),
               withGuide(project(), points));
    }
    setTool(Tool::Select);
    select(made);
}

// --- What is selected ---------------------------------------------------------------------------------

bool FieldEditor::canDelete() const {
    switch (selection_.kind) {
        case Selection::Kind::Vertex: {
            const Outline* outline = selectedOutline();
            return outline != nullptr &&
                   (isDrawnLine(outline->id) || withoutVertex(*outline, selection_.index).has_value());
        }
        case Selection::Kind::Hole:
        case Selection::Kind::Obstacle:
        case Selection::Kind::Gate:
        case Selection::Kind::Guide:
        case Selection::Kind::Split: return true;
        case Selection::Kind::Edge: return isDrawnLine(selection_.outline);
        case Selection::Kind::None:
        case Selection::Kind::Segment:
        case Selection::Kind::Cell:
        case Selection::Kind::Finding: break;
    }
    return false;
}

void FieldEditor::deleteSelection() {
    if (!canDelete()) {
        return;
    }
    const Selection chosen = selection_;
    if (chosen.kind == Selection::Kind::Vertex) {
        if (auto places = withoutVertex(*selectedOutline(), chosen.index)) {
            setOutline(QT_TR_NOOP("Delete a point"), chosen.outline, std::move(*places),
                       Document::Follows::Nothing);
            return;
        }
        // A line without one of its two ends is none.
    }
    select({});
    if (chosen.kind == Selection::Kind::Hole) {
        change(QT_TR_NOOP("Delete a hole"), withoutHole(project(), chosen.outline.item, chosen.outline.hole));
    } else if (chosen.kind == Selection::Kind::Obstacle) {
        change(QT_TR_NOOP("Delete an obstacle"), withoutObstacle(project(), chosen.outline.item));
    } else if (chosen.kind == Selection::Kind::Gate) {
        change(QT_TR_NOOP("Delete a gate"), withoutGate(project(), chosen.index));
    } else if (chosen.outline.kind == OutlineKind::Split) {
        std::vector<GeoRing> splits = linesOf(project()).splits;
        splits.erase(splits.begin() + static_cast<std::ptrdiff_t>(chosen.outline.item));
        change(QT_TR_NOOP("Delete a split line"), withSplits(project(), splits));
    } else {
        change(QT_TR_NOOP("Delete the guidance line"), withGuide(project(), {}));
    }
}

void FieldEditor::straightenSteps(bool all) {
    std::vector<std::size_t> fields{project().currentField};
    if (all) {
        fields.resize(project().fields.size());
        std::iota(fields.begin(), fields.end(), std::size_t{0});
    }
    // Asked for again, a refusal is told again.
    stepsError_.reset();
    stepsLeft_.clear();
    emit stepsChanged();
    change(QT_TR_NOOP("Make steps straight"), withStraightSteps(project(), fields));
    for (const std::size_t index : fields) {
        const FieldSource& source = *project().fields[index]->source;
        // The current one says its reason, too.
        if (all && stepsOf(source) && !withStraightSteps(source)) {
            stepsLeft_ << fromStd(source.name);
        }
    }
    if (steps_) {
        if (const auto straight = withStraightSteps(*project().field()->source); !straight) {
            stepsError_ = straight.error();
        }
    }
    emit stepsChanged();
}

QString FieldEditor::stepsLeft() const {
    constexpr qsizetype kMost = 6;
    if (stepsLeft_.isEmpty()) {
        return {};
    }
    QString names = stepsLeft_.first(std::min(kMost, stepsLeft_.size())).join(QStringLiteral(", "));
    if (stepsLeft_.size() > kMost) {
        names += QStringLiteral(" …");
    }
    return tr("%n field(s) stay as they are: %1.", nullptr, static_cast<int>(stepsLeft_.size())).arg(names);
}

void FieldEditor::forgetStepsLeft() {
    if (!stepsLeft_.isEmpty()) {
        stepsLeft_.clear();
        emit stepsChanged();
    }
}

QString FieldEditor::stepsRefusal() const {
    return stepsError_ ? tr("Made straight, it would be refused: %1; %2.")
                             .arg(furrow::shown(stepsError_->what), furrow::shown(stepsError_->remedy))
                       : QString{};
}

void FieldEditor::nudge(double eastM, double northM) {
    const Point way{eastM, northM};
    const Outline* outline = selectedOutline();
    const ProjectField* field = project().field();
    if (selection_.kind == Selection::Kind::Gate && field != nullptr) {
        FieldSource source = *field->source;
        source.gates[selection_.index].position = frame_->toGeo(shape_->gates[selection_.index] + way);
        changeSource(QT_TR_NOOP("Move a gate"), std::move(source), Document::Follows::Nothing);
    } else if (outline == nullptr) {
        return;
    } else if (selection_.kind == Selection::Kind::Vertex) {
        setOutline(QT_TR_NOOP("Move a point"), outline->id,
                   withVertexAt(*outline, *frame_, selection_.index, outline->points[selection_.index] + way),
                   Document::Follows::Nothing);
    } else if (selection_.kind == Selection::Kind::Edge) {
        const Point along = outline->to(selection_.index) - outline->from(selection_.index);
        setOutline(QT_TR_NOOP("Move an edge"), outline->id,
                   withEdgeMoved(*outline, *frame_, selection_.index,
                                 metres(cross(along, way) / std::max(norm(along), 1e-9))),
                   Document::Follows::Nothing);
    } else {
        setOutline(QT_TR_NOOP("Move"), outline->id, withAllMoved(*outline, *frame_, way),
                   Document::Follows::Nothing);
    }
}

void FieldEditor::selectNext(int step) {
    if (!shape_ || shape_->outlines.empty()) {
        return;
    }
    const Outline* outline = selectedOutline();
    if (outline == nullptr) {
        select({.kind = Selection::Kind::Vertex, .outline = shape_->outlines.front().id, .index = 0});
        return;
    }
    const bool isEdge = selection_.kind == Selection::Kind::Edge;
    const bool goesOn = isEdge || selection_.kind == Selection::Kind::Vertex;
    const auto count = static_cast<int>(isEdge ? outline->edgeCount() : outline->points.size());
    const int next = goesOn ? (static_cast<int>(selection_.index) + step % count + count) % count
                            : static_cast<int>(selection_.index);
    select({.kind = isEdge ? Selection::Kind::Edge : Selection::Kind::Vertex,
            .outline = outline->id,
            .index = static_cast<std::size_t>(next)});
}

void FieldEditor::selectEdge() {
    if (selectedOutline() == nullptr) {
        selectNext(1);
    }
    const Outline* const outline = selectedOutline();
    if (outline == nullptr || outline->edgeCount() == 0) {
        return;
    }
    if (selection_.kind == Selection::Kind::Edge) {
        selectNext(1);
        return;
    }
    const std::size_t after = selection_.kind == Selection::Kind::Vertex ? selection_.index : 0;
    select({.kind = Selection::Kind::Edge,
            .outline = outline->id,
            .index = std::min(after, outline->edgeCount() - 1)});
}

void FieldEditor::selectNextShape(int step) {
    if (!shape_) {
        return;
    }
    const auto outlines = static_cast<int>(shape_->outlines.size());
    const int count = outlines + static_cast<int>(shape_->gates.size());
    if (count == 0) {
        return;
    }
    const Outline* outline = selectedOutline();
    const int now = outline != nullptr ? static_cast<int>(outline - shape_->outlines.data())
                    : selection_.kind == Selection::Kind::Gate ? outlines + static_cast<int>(selection_.index)
                    : step > 0                                 ? -1
                                                               : 0;
    const auto next = static_cast<std::size_t>((now + step % count + count) % count);
    if (next >= shape_->outlines.size()) {
        select({.kind = Selection::Kind::Gate, .outline = {}, .index = next - shape_->outlines.size()});
    } else {
        const OutlineId id = shape_->outlines[next].id;
        select({.kind = wholeOf(id.kind), .outline = id, .index = 0});
    }
}

void FieldEditor::setVertex(GeoPoint place) {
    if (const Outline* outline = selectedOutline();
        outline != nullptr && selection_.kind == Selection::Kind::Vertex) {
        GeoRing places = outline->places;
        places[selection_.index] = place;
        setOutline(QT_TR_NOOP("Move a point"), outline->id, std::move(places), Document::Follows::Nothing);
    }
}

void FieldEditor::setEdgeLength(Length length) {
    if (const Outline* outline = selectedOutline(); outline != nullptr && length > metres(0.0)) {
        setOutline(QT_TR_NOOP("Change a length"), outline->id,
                   withEdgeLength(*outline, *frame_, selection_.index, length), Document::Follows::Nothing);
    }
}

void FieldEditor::setEdgeHeading(Angle heading) {
    if (const Outline* outline = selectedOutline()) {
        setOutline(QT_TR_NOOP("Change a direction"), outline->id,
                   withEdgeHeading(*outline, *frame_, selection_.index, heading), Document::Follows::Nothing);
    }
}

void FieldEditor::setEdgeHeadland(Length width) {
    if (const ProjectField* field = project().field();
        field != nullptr && selection_.kind == Selection::Kind::Edge) {
        changeSource(QT_TR_NOOP("Change the headland of an edge"),
                     withEdgeWidth(*field->source, &FieldSource::edgeHeadlands, selection_.outline,
                                   selection_.index, width),
                     Document::Follows::Nothing);
    }
}

void FieldEditor::clearEdgeHeadland() {
    if (const ProjectField* field = project().field();
        field != nullptr && selection_.kind == Selection::Kind::Edge) {
        changeSource(QT_TR_NOOP("Headland of an edge as elsewhere"),
                     withEdgeWidth(*field->source, &FieldSource::edgeHeadlands, selection_.outline,
                                   selection_.index, std::nullopt),
                     Document::Follows::Nothing);
    }
}

void FieldEditor::setEdgeOverhang(Length overhang) {
    if (const ProjectField* field = project().field();
        field != nullptr && selection_.kind == Selection::Kind::Edge) {
        changeSource(
            QT_TR_NOOP("Change the overhang of an edge"),
            withEdgeWidth(*field->source, &FieldSource::edgeOverhangs, selection_.outline, selection_.index,
                          overhang > Length{} ? std::optional{overhang} : std::nullopt),
            Document::Follows::Nothing);
    }
}

void FieldEditor::setBuffer(Length buffer) {
    if (const ProjectField* field = project().field();
        field != nullptr && selection_.kind == Selection::Kind::Obstacle) {
        FieldSource source = *field->source;
        source.obstacles[selection_.outline.item].buffer = buffer;
        changeSource(QT_TR_NOOP("Change the buffer"), std::move(source), Document::Follows::Nothing);
    }
}

void FieldEditor::setObstacleOverhang(Length overhang) {
    if (const ProjectField* field = project().field();
        field != nullptr && selection_.kind == Selection::Kind::Obstacle) {
        FieldSource source = *field->source;
        source.obstacles[selection_.outline.item].overhang = overhang;
        changeSource(QT_TR_NOOP("Change the overhang of an obstacle"), std::move(source),
                     Document::Follows::Nothing);
    }
}

void FieldEditor::setPassable(bool passable) {
    if (const ProjectField* field = project().field();
        field != nullptr && selection_.kind == Selection::Kind::Obstacle) {
        FieldSource source = *field->source;
        source.obstacles[selection_.outline.item].passable = passable;
        changeSource(
            passable ? QT_TR_NOOP("Let the obstacle be driven on") : QT_TR_NOOP("Keep off the obstacle"),
            std::move(source), Document::Follows::Nothing);
    }
}

void FieldEditor::setGateWidth(Length width) {
    if (const ProjectField* field = project().field();
        field != nullptr && selection_.kind == Selection::Kind::Gate) {
        FieldSource source = *field->source;
        source.gates[selection_.index].width = width;
        changeSource(QT_TR_NOOP("Change the gate"), std::move(source), Document::Follows::Nothing);
    }
}

void FieldEditor::setName(const QString& name) {
    const ProjectField* field = project().field();
    if (field == nullptr) {
        return;
    }
    FieldSource source = *field->source;
    if (selection_.kind == Selection::Kind::Obstacle) {
        source.obstacles[selection_.outline.item].name = name.trimmed().toStdString();
    } else if (selection_.kind == Selection::Kind::Gate) {
        source.gates[selection_.index].name = name.trimmed().toStdString();
    } else {
        return;
    }
    changeSource(QT_TR_NOOP("Rename"), std::move(source), Document::Follows::Nothing);
}

void FieldEditor::guideAlongEdge() {
    const Outline* outline = selectedOutline();
    if (outline != nullptr && selection_.kind == Selection::Kind::Edge) {
        const std::size_t next = selection_.index + 1 == outline->places.size() ? 0 : selection_.index + 1;
        change(QT_TR_NOOP("AB line along an edge"),
               withGuide(project(), {outline->places[selection_.index], outline->places[next]}));
    }
}

}  // namespace furrow
