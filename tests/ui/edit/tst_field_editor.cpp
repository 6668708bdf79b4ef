#include "planner/decomposition/decomposition.h"
#include "planner/editing/outline_edits.h"
#include "planner/geometry/segment.h"
#include "planner/project/project_edits.h"
#include "tests/support/patience.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "ui/edit/field_editor.h"
#include "ui/edit/inspector.h"
#include "ui/shell/session.h"
#include "ui/text/display.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace furrow;

namespace {

// Plans take seconds where the machine has other things to do.
const OutlineId kOuter{OutlineKind::Boundary, 0, 0};
constexpr Length kReach = metres(5.0);

/// A session with a field of some 400 by 390 m, and its editor.
struct Bench {
    Session session;
    FieldEditor editor;
    Inspector inspector;

    Bench() {
        editor.setDocument(session.document());
        editor.setShown(session.shown());
        QObject::connect(&editor, &FieldEditor::fieldDrawn, session.opener(), &FieldOpener::addDrawn);
        inspector.setEditor(&editor);
        session.opener()->addDrawn({{58.25, 22.5}, {58.25, 22.507}, {58.2535, 22.507}, {58.2535, 22.5}});
    }
    const FieldSource& source() { return *session.document()->project()->field()->source; }
    Point corner(std::size_t i) { return editor.shape()->find(kOuter)->points[i]; }
    FieldEditor::Pointer at(Point place, bool free = false) {
        return {.place = editor.frame()->toGeo(place), .reach = kReach, .free = free};
    }
    void drag(Point from, Point to, bool free = false) {
        editor.hover(at(from));
        QVERIFY(editor.press(at(from)));
        for (int i = 1; i <= 4; ++i) {
            editor.drag(at(from + (i / 4.0) * (to - from), free));
        }
        editor.release(at(to, free));
    }
    void draw(FieldEditor::Tool tool, std::initializer_list<Point> points) {
        editor.setTool(tool);
        for (const Point point : points) {
            editor.click(at(point, true));
        }
        editor.finishSketch();
    }
    void click(Point place) {
        editor.hover(at(place));
        if (editor.press(at(place))) {
            editor.letGo();
        } else {
            editor.click(at(place));
        }
    }
    std::size_t steps() { return session.document()->history().steps.size(); }
    int row(const QString& label) const {
        for (int i = 0; i < inspector.rowCount(); ++i) {
            if (inspector.data(inspector.index(i), Inspector::LabelRole).toString() == label) {
                return i;
            }
        }
        return -1;
    }
};

}  // namespace

class TestFieldEditor : public QObject {
    Q_OBJECT

private slots:
    void aVertexIsDraggedAsOneChange() {
        Bench bench;
        const Point before = bench.corner(1);
        const std::size_t steps = bench.steps();
        bench.drag(before, before + Point{30, -20}, true);
        QVERIFY(distance(bench.corner(1), before + Point{30, -20}) < 1e-3);
        QCOMPARE(bench.steps(), steps + 1);
        bench.session.document()->undo();
        QVERIFY(distance(bench.corner(1), before) < 1e-6);
    }
    /// Dragged to 2 m beside the line on which its corner is right: there it catches, but not while Alt is
    /// held.
    void aDraggedVertexCatchesRightAngles() {
        Bench bench;
        const Point from = bench.corner(1);
        const Point anchor = bench.corner(0);
        const Point beyond = bench.corner(3);
        const Point left = (1.0 / distance(anchor, beyond)) * Point{anchor.y - beyond.y, beyond.x - anchor.x};
        const Point on = anchor + (std::abs(dot(from - anchor, left)) + 40.0) *
                                      (dot(from - anchor, left) > 0 ? left : -1.0 * left);
        const Point aside = on + (2.0 / distance(anchor, beyond)) * (beyond - anchor);
        bench.drag(from, aside);
        QVERIFY(distance(bench.corner(1), on) < 0.01);
        bench.drag(bench.corner(1), aside, true);
        QVERIFY(distance(bench.corner(1), aside) < 1e-3);
    }
    void anEdgeIsDraggedSideways() {
        Bench bench;
        const Point a = bench.corner(0);
        const Point b = bench.corner(1);
        const Point middle = a + 0.3 * (b - a);
        const Point out = (25.0 / distance(a, b)) * Point{(b - a).y, -(b - a).x};
        bench.drag(middle, middle + out);
        const Point moved = bench.corner(1) - bench.corner(0);
        QVERIFY2(std::abs(cross(moved, b - a)) / norm(moved) / norm(b - a) < 1e-6,
                 "it is parallel to what it was");
        COMPARE_WITHIN(distanceToSegment(middle, bench.corner(0), bench.corner(1)), 25.0, 1e-3);
        QCOMPARE(bench.editor.selection().kind, Selection::Kind::Edge);
    }
    void theMiddleOfAnEdgeMakesAVertex() {
        Bench bench;
        const Point middle = 0.5 * (bench.corner(0) + bench.corner(1));
        const std::size_t steps = bench.steps();
        bench.drag(middle, middle + Point{0, -40}, true);
        QCOMPARE(bench.source().parts.front().outer.size(), std::size_t{5});
        QVERIFY(distance(bench.corner(1), middle + Point{0, -40}) < 1e-3);
        QCOMPARE(bench.steps(), steps + 1);
        QVERIFY(bench.editor.canDelete());
        bench.editor.deleteSelection();
        QCOMPARE(bench.source().parts.front().outer.size(), std::size_t{4});
    }
    void whatCanBeUndoneIsSaidInTheLanguageOfTheMoment() {
        Bench bench;
        furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric);
        bench.drag(bench.corner(1), bench.corner(1) + Point{30, -20}, true);
        QCOMPARE(bench.session.document()->undoText(), QStringLiteral("Move a point"));
        QSignalSpy told{bench.session.document(), &Document::historyChanged};
        furrow::Display::instance().force(QStringLiteral("de"), furrow::Display::Metric);
        QVERIFY(told.count() > 0);
        QCOMPARE(bench.session.document()->undoText(), QStringLiteral("Punkt verschieben"));
        bench.session.document()->undo();
        QCOMPARE(bench.session.document()->redoText(), QStringLiteral("Punkt verschieben"));
        QCOMPARE(bench.session.document()->undoText(), QStringLiteral("Schlag Field 1 hinzufügen"));
        furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric);
    }
    void aClickAloneMovesNothing() {
        Bench bench;
        const std::size_t steps = bench.steps();
        bench.click(bench.corner(1) + Point{2, 2});
        QCOMPARE(bench.editor.selection().kind, Selection::Kind::Vertex);
        QCOMPARE(bench.steps(), steps);
    }
    void escapeTakesADragBack() {
        Bench bench;
        const Point before = bench.corner(2);
        bench.editor.hover(bench.at(before));
        QVERIFY(bench.editor.press(bench.at(before)));
        bench.editor.drag(bench.at(before + Point{50, 50}));
        QVERIFY(bench.editor.escape());
        QVERIFY(distance(bench.corner(2), before) < 1e-6);
        QVERIFY(!bench.editor.isDragging());
        QVERIFY2(bench.editor.escape(), "then the selection goes");
        QVERIFY(!bench.editor.escape());
    }
    void holesObstaclesGatesAndLinesAreDrawn() {
        Bench bench;
        bench.draw(FieldEditor::Tool::Hole, {{-100, -100}, {-60, -100}, {-80, -60}});
        QCOMPARE(bench.source().parts.front().holes.size(), std::size_t{1});
        QCOMPARE(bench.editor.selection().kind, Selection::Kind::Hole);
        bench.draw(FieldEditor::Tool::Obstacle, {{60, 60}, {100, 60}, {80, 100}});
        QCOMPARE(bench.source().obstacles.size(), std::size_t{1});
        QCOMPARE(bench.editor.tool(), FieldEditor::Tool::Select);
        bench.editor.setTool(FieldEditor::Tool::Gate);
        bench.editor.click(bench.at(0.5 * (bench.corner(0) + bench.corner(1)) + Point{0, 3}));
        QCOMPARE(bench.source().gates.size(), std::size_t{1});
        QVERIFY2(
            distanceToSegment(bench.editor.shape()->gates.front(), bench.corner(0), bench.corner(1)) < 1e-3,
            "a gate lies on the boundary");
        bench.draw(FieldEditor::Tool::Guide, {{-100, -50}, {100, 50}});
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.shown()->plan() &&
                                     bench.session.shown()->plan()->field().source().gates.size() == 1,
                                 kPatienceMs);
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.planning()->state(), PlanState::Ready, kPatienceMs);
        // 200 m to the east and 100 m to the north.
        QTRY_VERIFY_WITH_TIMEOUT(
            std::abs(bench.session.shown()->plan()->swaths.heading.si() - std::atan2(100.0, 200.0)) < 1e-3,
            kPatienceMs);
        QCOMPARE(bench.session.shown()->plan()->field().source().obstacles.size(), std::size_t{1});
        bench.editor.select(
            {.kind = Selection::Kind::Guide, .outline = {OutlineKind::Guide, 0, 0}, .index = 0});
        bench.editor.deleteSelection();
        QVERIFY(bench.editor.shape()->find({OutlineKind::Guide, 0, 0}) == nullptr);
        for (int i = 0; i < 5; ++i) {
            bench.session.document()->undo();
        }
        QVERIFY(bench.source().obstacles.empty() && bench.source().gates.empty() &&
                bench.source().parts.front().holes.empty());
    }
    void splitLinesAreDrawnMovedAndDeleted() {
        Bench bench;
        const auto lines = [&bench] { return linesOf(*bench.session.document()->project()).splits; };
        const OutlineId first{OutlineKind::Split, 0, 0};
        const OutlineId second{OutlineKind::Split, 1, 0};
        bench.draw(FieldEditor::Tool::Split, {{-10, -400}, {10, 400}});
        QCOMPARE(lines().size(), std::size_t{1});
        QCOMPARE(bench.editor.selection().kind, Selection::Kind::Split);
        bench.draw(FieldEditor::Tool::Split, {{-400, 50}, {0, 60}, {400, 50}});
        QCOMPARE(lines().size(), std::size_t{2});
        QCOMPARE(bench.inspector.title(), QStringLiteral("Split line 2"));
        const std::size_t steps = bench.steps();
        bench.drag({0, 60}, {0, 90}, true);
        QCOMPARE(bench.steps(), steps + 1);
        QVERIFY(distance(bench.editor.shape()->find(second)->points[1], {0, 90}) < 1e-3);
        // The field is 412 m wide: what is planned is cut in four.
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.session.shown()->plan() && !bench.session.shown()->isDraft() &&
                bench.session.shown()->plan()->request.settings == bench.session.planning()->settings(),
            kPatienceMs);
        QVERIFY(bench.session.shown()->plan()->cells.cells.size() >= 4);
        // A point of three can go, then the line goes with either end.
        bench.editor.deleteSelection();
        QCOMPARE(lines()[1].size(), std::size_t{2});
        bench.editor.select({.kind = Selection::Kind::Vertex, .outline = second, .index = 0});
        bench.editor.deleteSelection();
        QCOMPARE(lines().size(), std::size_t{1});
        bench.click({-5, -200});
        QCOMPARE(bench.inspector.title(), QStringLiteral("Split line 1"));
        QVERIFY(bench.editor.canDelete());
        bench.editor.deleteSelection();
        QVERIFY(lines().empty());
        QVERIFY(!bench.session.planning()->settings().isSet(kSplit));
        for (int i = 0; i < 4; ++i) {
            bench.session.document()->undo();
        }
        QCOMPARE(lines().size(), std::size_t{2});
        QVERIFY(distance(bench.editor.shape()->find(second)->points[1], {0, 60}) < 1e-3);
        QVERIFY(bench.editor.shape()->find(first) != nullptr);
    }
    void everythingIsReachedByKeys() {
        Bench bench;
        bench.draw(FieldEditor::Tool::Obstacle, {{60, 60}, {100, 60}, {80, 100}});
        bench.draw(FieldEditor::Tool::Guide, {{-100, -50}, {100, 50}});
        bench.draw(FieldEditor::Tool::Split, {{-10, -400}, {10, 400}});
        bench.editor.setTool(FieldEditor::Tool::Gate);
        bench.editor.click(bench.at(0.5 * (bench.corner(0) + bench.corner(1))));
        bench.editor.clearSelection();
        using Kind = Selection::Kind;
        for (const Kind kind :
             {Kind::Vertex, Kind::Obstacle, Kind::Guide, Kind::Split, Kind::Gate, Kind::Vertex}) {
            bench.editor.selectNextShape(1);
            QCOMPARE(bench.editor.selection().kind, kind);
        }
        for (const Kind kind : {Kind::Gate, Kind::Split, Kind::Guide, Kind::Obstacle, Kind::Vertex}) {
            bench.editor.selectNextShape(-1);
            QCOMPARE(bench.editor.selection().kind, kind);
        }
    }
    void aLineThatIsLetGoIsPlannedWhole() {
        Bench bench;
        bench.draw(FieldEditor::Tool::Guide, {{-100, -50}, {100, 50}});
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.planning()->state(), PlanState::Ready, kPatienceMs);
        bench.drag({100, 50}, {100, 80}, true);
        QTRY_VERIFY_WITH_TIMEOUT(
            !bench.session.shown()->isDraft() && std::abs(bench.session.shown()->plan()->swaths.heading.si() -
                                                          std::atan2(130.0, 200.0)) < 1e-3,
            kPatienceMs);
    }
    void theSwathsFollowAnEdge() {
        Bench bench;
        const Point way = bench.corner(2) - bench.corner(1);
        bench.click(bench.corner(1) + 0.3 * way);
        QVERIFY(bench.inspector.isEdge());
        bench.editor.guideAlongEdge();
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.shown()->plan() &&
                                     std::abs(std::sin(bench.session.shown()->plan()->swaths.heading.si() -
                                                       std::atan2(way.y, way.x))) < 1e-6,
                                 kPatienceMs);
    }
    void drawnByHand() {
        Session session;
        FieldEditor editor;
        editor.setDocument(session.document());
        editor.setShown(session.shown());
        QObject::connect(&editor, &FieldEditor::fieldDrawn, session.opener(), &FieldOpener::addDrawn);
        editor.setTool(FieldEditor::Tool::Field);
        editor.setFreehand(true);
        const LocalFrame frame = *LocalFrame::centredOn({22.5, 58.25});
        const auto at = [&](double turn) {
            return FieldEditor::Pointer{.place = frame.toGeo(150.0 * direction(turn)), .reach = metres(4.0)};
        };
        QVERIFY(editor.press(at(0.0)));
        for (int i = 1; i < 200; ++i) {
            editor.drag(at(i * 0.0312));
        }
        editor.release(at(199 * 0.0312));
        QVERIFY(session.farm()->hasField());
        const std::size_t points = session.document()->project()->field()->source->parts.front().outer.size();
        QVERIFY2(points > 10 && points < 60, "as many as two metres of tolerance need");
        QTRY_COMPARE_WITH_TIMEOUT(session.planning()->state(), PlanState::Ready, kPatienceMs);
        COMPARE_WITHIN(session.shown()->plan()->field().area().si(), std::numbers::pi * 150.0 * 150.0,
                       2000.0);
    }
    void edgesAreTyped() {
        Bench bench;
        bench.editor.setTool(FieldEditor::Tool::Obstacle);
        bench.editor.click(bench.at({0, 0}, true));
        bench.editor.addPointBy(40.0, 90.0);
        bench.editor.addPointBy(30.0, 180.0);
        bench.editor.finishSketch();
        const Outline* made = bench.editor.shape()->find({OutlineKind::Obstacle, 0, 0});
        QVERIFY(made != nullptr);
        // Drawn clockwise, kept the other way round.
        QVERIFY(distance(made->points[0], {40, -30}) < 1e-3);
        QVERIFY(distance(made->points[1], {40, 0}) < 1e-3);
        QVERIFY(distance(made->points[2], {0, 0}) < 1e-3);
    }
    void theInspectorTypes() {
        Bench bench;
        QAbstractItemModelTester tester{&bench.inspector};
        QVERIFY(!bench.inspector.isShown());
        bench.click(bench.corner(0) + 0.3 * (bench.corner(1) - bench.corner(0)));
        QVERIFY(bench.inspector.isShown());
        QVERIFY(bench.inspector.title().startsWith(QStringLiteral("Edge 1")));
        bench.inspector.setNumber(bench.row(QStringLiteral("Length")), 250.0);
        COMPARE_WITHIN(distance(bench.corner(0), bench.corner(1)), 250.0, 1e-3);
        bench.inspector.setNumber(bench.row(QStringLiteral("Direction")), 100.0);
        const Point way = bench.corner(1) - bench.corner(0);
        COMPARE_WITHIN(std::atan2(way.x, way.y) * 180.0 / std::numbers::pi, 100.0, 1e-4);
        bench.click(bench.corner(2));
        bench.inspector.setNumber(bench.row(QStringLiteral("Latitude")), 58.254);
        QCOMPARE(bench.source().parts.front().outer[2].latDeg, 58.254);
        bench.draw(FieldEditor::Tool::Obstacle, {{20, 20}, {60, 20}, {40, 60}});
        QVERIFY(bench.inspector.hasPassable());
        bench.inspector.setPassable(true);
        QVERIFY(bench.source().obstacles.front().passable);
        bench.inspector.setNumber(bench.row(QStringLiteral("Buffer")), 7.5);
        QCOMPARE(bench.source().obstacles.front().buffer.si(), 7.5);
        bench.inspector.setText(bench.row(QStringLiteral("Name")), QStringLiteral("Wet spot"));
        QCOMPARE(bench.inspector.title(), QStringLiteral("Wet spot"));
    }
    void anEdgeHasAHeadlandOfItsOwn() {
        Bench bench;
        bench.click(bench.corner(0) + 0.3 * (bench.corner(1) - bench.corner(0)));
        QVERIFY(!bench.inspector.hasOwnHeadland());
        bench.editor.setEdgeHeadland(metres(18.0));
        QVERIFY(bench.inspector.hasOwnHeadland());
        const int row = bench.row(QStringLiteral("Headland"));
        QCOMPARE(bench.inspector.data(bench.inspector.index(row), Inspector::NumberRole).toDouble(), 18.0);
        bench.inspector.setNumber(row, 24.0);
        QCOMPARE(bench.source().edgeHeadlands.size(), std::size_t{1});
        QVERIFY(bench.source().edgeHeadlands.front() ==
                (EdgeWidth{.part = 0, .ring = 0, .edge = 0, .width = metres(24.0)}));
        bench.session.document()->undo();
        QCOMPARE(bench.source().edgeHeadlands.front().width.si(), 18.0);
        bench.editor.clearEdgeHeadland();
        QVERIFY(bench.source().edgeHeadlands.empty());
        QVERIFY(!bench.inspector.hasOwnHeadland());
    }
    void edgesAndObstaclesHaveOverhangs() {
        Bench bench;
        bench.click(bench.corner(0) + 0.3 * (bench.corner(1) - bench.corner(0)));
        const int row = bench.row(QStringLiteral("Overhang"));
        QCOMPARE(bench.inspector.data(bench.inspector.index(row), Inspector::NumberRole).toDouble(), 0.0);
        bench.inspector.setNumber(row, 6.0);
        QCOMPARE(bench.source().edgeOverhangs.size(), std::size_t{1});
        QVERIFY(bench.source().edgeOverhangs.front() ==
                (EdgeWidth{.part = 0, .ring = 0, .edge = 0, .width = metres(6.0)}));
        QVERIFY(bench.source().edgeHeadlands.empty());
        bench.inspector.setNumber(bench.row(QStringLiteral("Overhang")), 0.0);
        QVERIFY(bench.source().edgeOverhangs.empty());
        bench.session.document()->undo();
        QCOMPARE(bench.source().edgeOverhangs.size(), std::size_t{1});
        bench.draw(FieldEditor::Tool::Obstacle, {{20, 20}, {60, 20}, {40, 60}});
        bench.inspector.setNumber(bench.row(QStringLiteral("Overhang")), 4.5);
        QCOMPARE(bench.source().obstacles.front().overhang.si(), 4.5);
        bench.session.document()->undo();
        QCOMPARE(bench.source().obstacles.front().overhang.si(), 0.0);
    }
    void theBufferHasAHandle() {
        Bench bench;
        bench.draw(FieldEditor::Tool::Obstacle, {{20, 20}, {60, 20}, {40, 60}});
        QVERIFY(bench.editor.bufferHandle().has_value());
        QVERIFY(distance(*bench.editor.bufferHandle(), {60, 20}) < 1e-3);
        bench.drag({60, 20}, {68, 25}, true);
        COMPARE_WITHIN(bench.source().obstacles.front().buffer.si(), 8.0, 1e-3);
        QVERIFY(distance(*bench.editor.bufferHandle(), {68, 20}) < 1e-3);
    }
    void thePlanIsInspected() {
        Bench bench;
        QTRY_COMPARE_WITH_TIMEOUT(bench.session.planning()->state(), PlanState::Ready, kPatienceMs);
        const Plan& plan = *bench.session.shown()->plan();
        QSet<QString> seen;
        for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
            bench.editor.select({.kind = Selection::Kind::Segment, .outline = {}, .index = i});
            QVERIFY(!bench.inspector.title().isEmpty());
            QVERIFY(!bench.inspector.sentence().isEmpty());
            seen << bench.inspector.title().section(QLatin1Char(' '), 0, 0);
        }
        QVERIFY(seen.contains(QStringLiteral("Swath")) && seen.contains(QStringLiteral("Turn")) &&
                seen.contains(QStringLiteral("Headland")));
        // Clicking on a swath finds it.
        const Swath& swath = plan.swaths.swaths[plan.swaths.swaths.size() / 2];
        const Point middle =
            bench.editor.frame()->toLocal(plan.field().frame().toGeo(0.5 * (swath.start + swath.end)));
        bench.editor.hover({.place = bench.editor.frame()->toGeo(middle), .reach = metres(0.5)});
        bench.editor.click({.place = bench.editor.frame()->toGeo(middle), .reach = metres(0.5)});
        QCOMPARE(bench.inspector.title(), QStringLiteral("Swath %1").arg(swath.number));
        bench.editor.selectFinding(0);
        // Its row in the list of findings says all of it.
        QVERIFY(!bench.inspector.isShown());
        QCOMPARE(bench.editor.selectedFinding(), 0);
    }
    void undoingWhatIsSelectedDeselects() {
        Bench bench;
        bench.draw(FieldEditor::Tool::Obstacle, {{20, 20}, {60, 20}, {40, 60}});
        QVERIFY(bench.editor.hasSelection());
        bench.session.document()->undo();
        QVERIFY(!bench.editor.hasSelection());
        QVERIFY(!bench.inspector.isShown());
    }
    void keysReachEveryPoint() {
        Bench bench;
        bench.editor.selectNext(1);
        QVERIFY(bench.editor.selection().isOf(Selection::Kind::Vertex, kOuter, 0));
        bench.editor.selectNext(-1);
        QVERIFY(bench.editor.selection().isOf(Selection::Kind::Vertex, kOuter, 3));
        const Point before = bench.corner(3);
        bench.editor.nudge(-2.0, 1.0);
        QVERIFY(distance(bench.corner(3), before + Point{-2, 1}) < 1e-3);
    }
};

FURROW_TEST(TestFieldEditor);
#include "tst_field_editor.moc"
