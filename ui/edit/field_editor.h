#pragma once

#include "planner/editing/field_shape.h"
#include "planner/editing/shape_hit.h"
#include "planner/editing/snapping.h"
#include "planner/field/outline_steps.h"
#include "planner/project/project.h"
#include "ui/edit/selection.h"
#include "ui/map/shown_plan.h"
#include "ui/project/document.h"

#include <QtQml/qqmlregistration.h>
#include <QGeoCoordinate>
#include <QList>
#include <QObject>

namespace furrow {

/// What the tools on the map do to the field: picks, drags, draws, deletes. It knows places on the earth and
/// how far a pointer reaches there; pixels are the layer's. Geometry is the planner's, changes are the
/// document's.
class FieldEditor : public QObject {
    Q_OBJECT
    QML_ELEMENT
    Q_PROPERTY(
        furrow::Document* document READ document WRITE setDocument NOTIFY documentChanged REQUIRED FINAL)
    Q_PROPERTY(furrow::ShownPlan* shown READ shown WRITE setShown NOTIFY shownChanged REQUIRED FINAL)
    Q_PROPERTY(Tool tool READ tool WRITE setTool NOTIFY toolChanged FINAL)
    Q_PROPERTY(bool drawing READ isDrawing NOTIFY toolChanged FINAL)
    /// Drawing tools trace the pointer while it is pressed.
    Q_PROPERTY(bool freehand READ isFreehand WRITE setFreehand NOTIFY freehandChanged FINAL)
    Q_PROPERTY(int sketchCount READ sketchCount NOTIFY sketchChanged FINAL)
    /// A point of the sketch was taken back, and nothing was done since.
    Q_PROPERTY(bool canDrawAgain READ canDrawAgain NOTIFY sketchChanged FINAL)
    Q_PROPERTY(int sketchNeeded READ sketchNeeded NOTIFY toolChanged FINAL)
    Q_PROPERTY(bool sketchOpen READ isDraftOpen NOTIFY toolChanged FINAL)
    /// From the last point of the sketch to the pointer; 0 without either.
    Q_PROPERTY(double sketchLengthM READ sketchLengthM NOTIFY sketchChanged FINAL)
    Q_PROPERTY(double sketchBearingDeg READ sketchBearingDeg NOTIFY sketchChanged FINAL)
    Q_PROPERTY(bool dragging READ isDragging NOTIFY draggingChanged FINAL)
    Q_PROPERTY(bool canDelete READ canDelete NOTIFY selectionChanged FINAL)
    Q_PROPERTY(bool hasSelection READ hasSelection NOTIFY selectionChanged FINAL)
    /// Of the path; -1 where something else is selected, or nothing.
    Q_PROPERTY(int selectedSegment READ selectedSegment NOTIFY selectionChanged FINAL)
    Q_PROPERTY(int selectedCell READ selectedCell NOTIFY selectionChanged FINAL)
    /// Of the field's outline, where it was traced along the pixels of an image; none without steps.
    Q_PROPERTY(int outlineSteps READ outlineSteps NOTIFY stepsChanged FINAL)
    Q_PROPERTY(double stepHeightM READ stepHeightM NOTIFY stepsChanged FINAL)
    Q_PROPERTY(QString stepsRefusal READ stepsRefusal NOTIFY stepsChanged FINAL)
    /// Fields that stayed as they are when all were made straight, by name. Empty for none.
    Q_PROPERTY(QString stepsLeft READ stepsLeft NOTIFY stepsChanged FINAL)
    Q_PROPERTY(QString fieldId READ fieldId NOTIFY stepsChanged FINAL)
    Q_PROPERTY(int selectedFinding READ selectedFinding NOTIFY selectionChanged FINAL)

public:
    enum class Tool { Select, Field, Hole, Obstacle, Guide, Split, Gate };
    Q_ENUM(Tool)

    /// Where the pointer is, how far it reaches, and whether it is to be drawn to nothing.
    struct Pointer {
        GeoPoint place;
        Length reach;
        bool free = false;
    };

    /// A traced line is kept to within this share of the pointer's reach.
    static constexpr double kTraceShare = 0.5;

    explicit FieldEditor(QObject* parent = nullptr) : QObject{parent} {}

    Document* document() const { return document_; }
    void setDocument(Document* document);
    ShownPlan* shown() const { return shown_; }
    void setShown(ShownPlan* shown);
    Tool tool() const { return tool_; }
    void setTool(Tool tool);
    bool isDrawing() const { return tool_ != Tool::Select; }
    bool isFreehand() const { return freehand_; }
    void setFreehand(bool freehand);
    bool canDrawAgain() const { return !takenBack_.empty(); }
    int sketchCount() const { return static_cast<int>(sketch_.size()); }
    /// Points that what is drawn has at least.
    int sketchNeeded() const;
    /// What is drawn is a line, not an area.
    bool isDraftOpen() const { return tool_ == Tool::Guide || tool_ == Tool::Split; }
    double sketchLengthM() const;
    double sketchBearingDeg() const;
    bool isDragging() const { return grip_ != Grip::None; }
    /// The outlines are to be drawn from here: the plan's drawing is of what they were before, or will be in
    /// a moment.
    bool isAhead() const;
    bool hasSelection() const { return !selection_.isNone(); }
    bool canDelete() const;
    int outlineSteps() const { return steps_ ? steps_->count : 0; }
    double stepHeightM() const { return steps_ ? steps_->height.si() : 0.0; }
    /// Why the outline of the current field was refused with straight steps. Empty where it was not.
    QString stepsRefusal() const;
    QString stepsLeft() const;
    Q_INVOKABLE void forgetStepsLeft();
    QString fieldId() const { return QString::fromStdString(fieldId_); }
    int selectedCell() const {
        return selection_.kind == Selection::Kind::Cell ? static_cast<int>(selection_.index) : -1;
    }
    int selectedFinding() const {
        return selection_.kind == Selection::Kind::Finding ? static_cast<int>(selection_.index) : -1;
    }
    int selectedSegment() const {
        return selection_.kind == Selection::Kind::Segment ? static_cast<int>(selection_.index) : -1;
    }

    // What is shown.
    const std::optional<FieldShape>& shape() const { return shape_; }
    const GeoRing& sketch() const { return sketch_; }
    const std::optional<ShapeHit>& hovered() const { return hovered_; }
    const Selection& selection() const { return selection_; }
    const std::optional<Snap>& snap() const { return snap_; }
    /// Of the shape, or of the sketch where there is none.
    const std::optional<LocalFrame>& frame() const { return frame_; }
    /// Where the pointer is drawn to; nothing while it is not on the map.
    const std::optional<GeoPoint>& cursor() const { return cursor_; }
    /// Where a drag makes a new vertex: the middle of the edge that is hovered or selected.
    std::optional<Point> midpointHandle() const;
    /// Where the buffer of the selected obstacle is dragged.
    std::optional<Point> bufferHandle() const;

    // The pointer.
    void hover(const Pointer& pointer);
    void leave();
    /// True where something was taken hold of: otherwise a drag moves the map.
    bool press(const Pointer& pointer);
    void drag(const Pointer& pointer);
    void release(const Pointer& pointer);
    /// Ends a press that did not become a drag.
    void letGo() { endGrip(); }
    /// Pressed and let go at the same place.
    void click(const Pointer& pointer);

    void select(const Selection& selection);
    Q_INVOKABLE void selectFinding(int index);
    /// Of the path; nothing below 0.
    Q_INVOKABLE void selectSegment(int index);
    Q_INVOKABLE void clearSelection() { select({}); }
    /// Around the outline of what is selected, or the first one: `step` vertices further, or edges where one
    /// is selected.
    Q_INVOKABLE void selectNext(int step);
    /// The edge after the vertex that is selected, or after the edge.
    Q_INVOKABLE void selectEdge();
    /// The next boundary, hole, obstacle, line or gate.
    Q_INVOKABLE void selectNextShape(int step);
    Q_INVOKABLE void deleteSelection();
    /// Moves what is selected this many metres to the east and north.
    Q_INVOKABLE void nudge(double eastM, double northM);

    /// Adds a point where the pointer is, or at this place where it is not on the map.
    Q_INVOKABLE void addPointAt(const QGeoCoordinate& place);
    /// Adds a point this far from the last one, in this direction clockwise from north.
    Q_INVOKABLE void addPointBy(double lengthM, double bearingDeg);
    /// Ends drawing: with enough points what was drawn is made, otherwise nothing happens.
    Q_INVOKABLE void finishSketch();
    Q_INVOKABLE void cancelSketch();
    Q_INVOKABLE void removeLastPoint();
    /// The point that was taken back last, if it can.
    Q_INVOKABLE void drawAgain();
    /// Stops the innermost of what was begun: drag, drawing, selection. False where nothing was.
    Q_INVOKABLE bool escape();

    // What is typed in the inspector.
    void setVertex(GeoPoint place);
    void setEdgeLength(Length length);
    void setEdgeHeading(Angle heading);
    void setEdgeHeadland(Length width);
    /// As wide as elsewhere again.
    Q_INVOKABLE void clearEdgeHeadland();
    /// None with 0.
    void setEdgeOverhang(Length overhang);
    void setBuffer(Length buffer);
    void setObstacleOverhang(Length overhang);
    void setPassable(bool passable);
    void setGateWidth(Length width);
    void setName(const QString& name);
    /// Makes the steps of the outline straight, of the current field or of all. An outline that would be
    /// refused then stays.
    Q_INVOKABLE void straightenSteps(bool all);
    /// Lets the swaths follow the selected edge.
    Q_INVOKABLE void guideAlongEdge();

signals:
    void documentChanged();
    void shownChanged();
    /// A boundary of a field that is not there yet.
    void fieldDrawn(const QList<QGeoCoordinate>& boundary);
    void toolChanged();
    void freehandChanged();
    void sketchChanged();
    void draggingChanged();
    void stepsChanged();
    void selectionChanged();
    /// A segment of the path, on the map.
    void segmentClicked(int index);
    /// Anything that is drawn.
    void changed();

private:
    enum class Grip { None, Vertex, Edge, Inside, Gate, Buffer, Trace };

    const Project& project() const;
    const Outline* selectedOutline() const;
    Point local(GeoPoint place) const { return frame_->toLocal(place); }
    void follow();
    void findSteps();
    /// Another plan is shown.
    void followPlan();
    void pickFromPlan(const Pointer& pointer);
    /// Where the pointer is drawn to: `beside` are the vertices that angles are taken at.
    Point snappedTo(const Pointer& pointer, std::span<const SnapLine> lines,
                    std::optional<std::pair<OutlineId, std::size_t>> except = std::nullopt);
    std::vector<SnapLine> linesAt(const Outline& outline, std::size_t vertex) const;
    std::vector<SnapLine> sketchLines() const;
    void moveGrip(const Pointer& pointer, Document::Follows follows);
    void endGrip();
    // Each `text` is marked for translation.
    void setOutline(const char* text, const OutlineId& id, GeoRing places, Document::Follows follows);
    void changeSource(const char* text, FieldSource source, Document::Follows follows);
    void change(const char* text, Project after, Document::Follows follows = Document::Follows::Nothing);
    void addPoint(GeoPoint place);
    void finishTool(GeoRing points);

    Document* document_ = nullptr;
    ShownPlan* shown_ = nullptr;
    std::shared_ptr<const Plan> plan_;  ///< that was shown last
    Tool tool_ = Tool::Select;
    bool freehand_ = false;
    std::string fieldId_;
    std::optional<LocalFrame> frame_;
    std::optional<FieldShape> shape_;
    std::shared_ptr<const FieldSource> stepsOf_;  ///< whose steps are known
    std::optional<OutlineSteps> steps_;
    std::optional<Error> stepsError_;
    QStringList stepsLeft_;
    GeoRing sketch_;
    GeoRing takenBack_;  ///< points of the sketch, the last one first to come again
    std::optional<GeoPoint> cursor_;
    std::optional<ShapeHit> hovered_;
    std::optional<Snap> snap_;
    Selection selection_;
    Grip grip_ = Grip::None;
    /// When it was taken hold of.
    Point pressed_;
    std::optional<FieldShape> before_;
    std::optional<FieldSource> sourceBefore_;
};

}  // namespace furrow
