#pragma once

#include "ui/map/mesh_nodes.h"
#include "ui/map/plan_drawing.h"
#include "ui/map/plan_marks.h"
#include "ui/map/plan_view.h"

#include <QtQml/qqmlregistration.h>
#include <QSGNode>

namespace furrow {

/// Colours of a plan on the map, and what of it is shown.
class PlanStyle {
    Q_GADGET
    QML_VALUE_TYPE(planStyle)
    QML_STRUCTURED_VALUE
    Q_PROPERTY(QColor boundary MEMBER boundary FINAL)
    Q_PROPERTY(QColor casing MEMBER casing FINAL)
    Q_PROPERTY(QColor headland MEMBER headland FINAL)
    Q_PROPERTY(QColor swath MEMBER swath FINAL)
    Q_PROPERTY(QColor turn MEMBER turn FINAL)
    Q_PROPERTY(QColor finding MEMBER finding FINAL)
    Q_PROPERTY(QColor obstacle MEMBER obstacle FINAL)
    Q_PROPERTY(QColor start MEMBER start FINAL)
    Q_PROPERTY(QColor end MEMBER end FINAL)
    Q_PROPERTY(QColor ground MEMBER ground FINAL)
    Q_PROPERTY(QColor ink MEMBER ink FINAL)
    Q_PROPERTY(QColor covered MEMBER covered FINAL)
    Q_PROPERTY(QColor overlap MEMBER overlap FINAL)
    Q_PROPERTY(QColor missed MEMBER missed FINAL)
    Q_PROPERTY(QColor wheels MEMBER wheels FINAL)
    Q_PROPERTY(double lineFactor MEMBER lineFactor FINAL)
    Q_PROPERTY(bool showBoundary MEMBER showBoundary FINAL)
    Q_PROPERTY(bool showHeadland MEMBER showHeadland FINAL)
    Q_PROPERTY(bool showSwaths MEMBER showSwaths FINAL)
    Q_PROPERTY(bool showTurns MEMBER showTurns FINAL)
    Q_PROPERTY(bool showDirections MEMBER showDirections FINAL)
    Q_PROPERTY(bool showNumbers MEMBER showNumbers FINAL)
    Q_PROPERTY(bool showOrder MEMBER showOrder FINAL)
    Q_PROPERTY(bool showCoverage MEMBER showCoverage FINAL)
    Q_PROPERTY(bool showOverlap MEMBER showOverlap FINAL)
    Q_PROPERTY(bool showMissed MEMBER showMissed FINAL)
    Q_PROPERTY(bool showWheels MEMBER showWheels FINAL)
    Q_PROPERTY(bool onImagery MEMBER onImagery FINAL)
    Q_PROPERTY(bool showFindings MEMBER showFindings FINAL)
    Q_PROPERTY(int selectedFinding MEMBER selectedFinding FINAL)
    Q_PROPERTY(int selectedSegment MEMBER selectedSegment FINAL)
    Q_PROPERTY(int selectedCell MEMBER selectedCell FINAL)
    Q_PROPERTY(bool old MEMBER old FINAL)

public:
    QColor boundary;
    QColor casing;
    QColor headland;
    QColor swath;
    QColor turn;
    QColor finding;
    QColor obstacle;
    QColor start;
    QColor end;
    QColor ground;
    QColor ink;
    QColor covered;
    QColor overlap;
    QColor missed;
    QColor wheels;
    double lineFactor = 1.0;
    bool showBoundary = true;
    bool showHeadland = true;
    bool showSwaths = true;
    bool showTurns = true;
    bool showDirections = true;
    bool showNumbers = true;
    bool showOrder = false;
    bool showCoverage = false;
    bool showOverlap = false;
    bool showMissed = true;
    bool showWheels = false;
    /// Every line gets a casing, so that it is seen on any ground.
    bool onImagery = false;
    bool showFindings = true;
    int selectedFinding = -1;
    /// Of the path: drawn with a halo, the rest dimmed.
    int selectedSegment = -1;
    int selectedCell = -1;
    /// Another plan is on its way: this one is dimmed.
    bool old = false;

    /// How strongly what is not selected is drawn.
    double restAlpha() const {
        return selectedSegment >= 0 || selectedCell >= 0 ? 0.35
               : old                                     ? 0.45
               : selectedFinding >= 0                    ? 0.6
                                                         : 1.0;
    }

    /// For a plan beside the one that things are selected in.
    Q_INVOKABLE furrow::PlanStyle ofAnotherPlan() const {
        PlanStyle style = *this;
        style.selectedFinding = style.selectedSegment = style.selectedCell = -1;
        style.old = false;
        return style;
    }

    friend bool operator==(const PlanStyle&, const PlanStyle&) = default;
};

/// The nodes of a plan, lowest first. Lives in the render thread.
class PlanScene : public QSGNode {
public:
    PlanScene();

    void setGeometry(std::shared_ptr<const PlanGeometry> geometry);
    void setStyle(const PlanStyle& style);
    void setView(const PlanView& view, QQuickWindow* window);

private:
    struct ChunkNode {
        LineNode* node;
        const PathChunk* chunk;
        std::size_t level;
    };
    void styleChunk(const ChunkNode& chunk) const;
    void styleDensity();
    void showChunks(const PlanView& view);
    void showDirections(const PlanView& view);
    void showSelection();
    LineMesh selectedLines() const;
    void showMarks(const PlanView& view, QQuickWindow* window);
    void addNumbers(const PlanView& view);
    void addFindings(const PlanView& view);
    LineNode* newLine(QSGNode* parent);

    std::shared_ptr<const PlanGeometry> geometry_;
    PlanStyle style_;
    /// Of line widths: 1 where lines have room.
    double density_ = 1.0;
    /// How much of the swaths is drawn as lines; the rest as an area.
    double asLines_ = 1.0;
    /// The segment and the cell whose lines are in the selection's nodes.
    std::pair<int, int> selected_{-1, -1};
    QSGTransformNode* transform_ = new QSGTransformNode;
    FillNode* covered_ = new FillNode;
    FillNode* headland_ = new FillNode;
    FillNode* worked_ = new FillNode;
    FillNode* overlap_ = new FillNode;
    FillNode* missed_ = new FillNode;
    FillNode* wheels_ = new FillNode;
    FillNode* obstacles_ = new FillNode;
    LineNode* mainlandEdge_;
    LineNode* casing_;
    LineNode* boundary_;
    LineNode* obstacleEdges_;
    LineNode* swathCasing_;
    LineNode* swaths_;
    LineNode* beyondSwaths_;
    LineNode* tramlines_;
    QSGNode* chunkParent_ = new QSGNode;
    std::vector<LineNode*> lines_;
    std::vector<ChunkNode> chunks_;
    LineNode* directions_ = new LineNode;
    LineNode* halo_;
    LineNode* selection_;
    MarkNode* marks_ = new MarkNode;
};

/// Which numbers are drawn so that none covers another: every n-th, beginning with the first.
int numberStep(const std::vector<NumberMark>& numbers, double pixelsPerUnit);

}  // namespace furrow
