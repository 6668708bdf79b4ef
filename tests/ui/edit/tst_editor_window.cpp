#include "planner/project/project_file.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"
#include "tests/ui/window/frame_clock.h"
#include "ui/edit/inspector.h"
#include "ui/plan/steps_model.h"

#include <QSignalSpy>
#include <QTemporaryDir>

#include <cmath>

using namespace furrow;
using namespace furrow::test;

/// Editing and keeping a field, as a new user does it.
class TestEditorWindow : public EditorWindowTest {
    Q_OBJECT

private slots:
    /// Without a mouse: points by typing, settings by Tab and arrows.
    void byKeyboardAlone() {
        camera()->centreOn(QGeoCoordinate{58.2515, 22.5035}, 16.0, false);
        map()->forceActiveFocus();
        key(Qt::Key_B);
        QTRY_VERIFY(shows(QStringLiteral("drawingHint")));
        editor()->leave();
        key(Qt::Key_Space);
        QTRY_COMPARE(editor()->sketchCount(), 1);
        enterWay(QStringLiteral("300"), QStringLiteral("90"));
        enterWay(QStringLiteral("200,5"), QStringLiteral("180"));
        enterWay(QStringLiteral("300"), QStringLiteral("270"));
        picture(QStringLiteral("keyboard_typed"));
        map()->forceActiveFocus();
        key(Qt::Key_Return);
        QTRY_VERIFY(session_->farm()->hasField());
        ready();
        // 300 by 200.5 m.
        QTRY_VERIFY(session_->shown()->plan() &&
                    std::abs(session_->shown()->plan()->field().area().si() - 60150.0) < 5.0);
        // The first point is chosen and moved, then a number of it is typed.
        map()->forceActiveFocus();
        key(Qt::Key_Space);
        QTRY_VERIFY(shows(QStringLiteral("inspector")));
        const GeoPoint before = source().parts.front().outer.front();
        key(Qt::Key_Left, Qt::ShiftModifier);
        QTRY_VERIFY(source().parts.front().outer.front().lonDeg < before.lonDeg);
        key(Qt::Key_Return);
        QTRY_VERIFY(item(QStringLiteral("inspector.number.0"))->hasActiveFocus());
        picture(QStringLiteral("keyboard_inspector"));
        map()->forceActiveFocus();
        key(Qt::Key_Period);
        key(Qt::Key_Delete);
        QTRY_COMPARE(source().parts.front().outer.size(), std::size_t{3});
        key(Qt::Key_Z, Qt::ControlModifier);
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_VERIFY(source().parts.front().outer.front() == before);
        key(Qt::Key_Escape);
        QTRY_VERIFY(!editor()->hasSelection());
    }
    /// Also without the pointer near them, and none where they would lie on each other.
    void handlesOfWhatIsSelectedAreSeen() {
        DRAW_FIELD();
        const auto looksLike = [this](QPoint at, const QColor& color) {
            const QColor there = window_->grabWindow().pixelColor(at);
            return std::abs(there.red() - color.red()) < 30 && std::abs(there.green() - color.green()) < 30 &&
                   std::abs(there.blue() - color.blue()) < 30;
        };
        const QColor white{0xFF, 0xFF, 0xFF};
        const QColor accent{0x1B, 0x6B, 0x43};
        QTest::mouseMove(window_, middle());
        key(Qt::Key_Escape);
        QVERIFY(!looksLike(cornerOnMap(2), white));
        key(Qt::Key_Space);
        QTRY_COMPARE(editor()->selection().kind, Selection::Kind::Vertex);
        const std::size_t chosen = editor()->selection().index;
        const QPoint other = cornerOnMap((chosen + 2) % 4);
        const QPoint edge = (other + cornerOnMap((chosen + 3) % 4)) / 2;
        QTRY_VERIFY(looksLike(other, white));
        QVERIFY(looksLike(edge, accent));
        picture(QStringLiteral("handles"));
        // The handle that is seen is the one that is dragged.
        const std::size_t points = source().parts.front().outer.size();
        drag(edge, edge + QPoint{0, edge.y() > middle().y() ? 30 : -30});
        QTRY_COMPARE(source().parts.front().outer.size(), points + 1);
        // Seen from afar the field is a speck of some 20 pixels.
        camera()->zoomAt(QPointF(map()->width() / 2, map()->height() / 2), -4.3, false);
        QTRY_VERIFY(std::abs(cornerOnMap(0).x() - cornerOnMap(1).x()) < 30);
        picture(QStringLiteral("handles_afar"));
    }
    void anEdgeIsDraggedAndItsMiddleBends() {
        DRAW_FIELD();
        const QPoint a = cornerOnMap(0);
        const QPoint b = cornerOnMap(1);
        const QPoint quarter = a + (b - a) / 4;
        const double height = std::abs(cornerOnMap(2).y() - cornerOnMap(1).y());
        const double area = session_->shown()->plan()->field().area().si();
        const QPoint out = quarter.y() < middle().y() ? QPoint{0, -40} : QPoint{0, 40};
        drag(quarter, quarter + out);
        QTRY_VERIFY_WITH_TIMEOUT(
            session_->shown()->plan() && std::abs(session_->shown()->plan()->field().area().si() / area -
                                                  (height + 40.0) / height) < 0.005,
            kPatienceMs);
        QCOMPARE(editor()->selection().kind, Selection::Kind::Edge);
        QTRY_VERIFY(shows(QStringLiteral("inspector")));
        ready();
        picture(QStringLiteral("edge"));
        const QPoint half = (cornerOnMap(0) + cornerOnMap(1)) / 2;
        drag(half, half + out);
        QTRY_COMPARE(source().parts.front().outer.size(), std::size_t{5});
        ready();
        picture(QStringLiteral("vertex"));
        key(Qt::Key_Delete);
        QTRY_COMPARE(source().parts.front().outer.size(), std::size_t{4});
    }
    void theHeadlandOfAnEdgeIsTyped() {
        DRAW_FIELD();
        const QPoint a = cornerOnMap(0);
        const QPoint b = cornerOnMap(1);
        const double before = session_->shown()->plan()->headland.mainlandRatio;
        const double elsewhere = session_->shown()->plan()->headland.width.si();
        const auto headland = [this] {
            return session_->planning()->steps()->index(2).data(StepsModel::ChoiceRole).toString();
        };
        QCOMPARE(headland(), QStringLiteral("Same width all round"));
        clickAt(a + (b - a) / 4);
        QTRY_COMPARE(editor()->selection().kind, Selection::Kind::Edge);
        enter(QStringLiteral("inspector.number.2"), QStringLiteral("60m"));
        QTRY_COMPARE(source().edgeHeadlands.size(), std::size_t{1});
        QCOMPARE(source().edgeHeadlands.front().width.si(), 60.0);
        QTRY_VERIFY_WITH_TIMEOUT(
            session_->shown()->plan() && session_->shown()->plan()->headland.mainlandRatio < before - 0.02,
            kPatienceMs);
        ready();
        picture(QStringLiteral("edge-headland"));
        // The others keep theirs.
        QVERIFY(session_->shown()->plan()->headland.width.si() > 59.0);
        QCOMPARE(headland(), QStringLiteral("Same width all round but for 1 edge"));
        const QPoint c = cornerOnMap(2);
        clickAt(b + (c - b) / 4);
        QTRY_VERIFY(item(QStringLiteral("inspector.number.2")) &&
                    item(QStringLiteral("inspector.number.2"))->property("value").toDouble() < 59.0);
        QVERIFY(std::abs(item(QStringLiteral("inspector.number.2"))->property("value").toDouble() -
                         elsewhere) < 0.01);
        clickAt(a + (b - a) / 4);
        QTRY_VERIFY(shows(QStringLiteral("inspector.headlandAsElsewhere")));
        click(QStringLiteral("inspector.headlandAsElsewhere"));
        QTRY_VERIFY(source().edgeHeadlands.empty());
        QTRY_VERIFY_WITH_TIMEOUT(
            session_->shown()->plan() &&
                std::abs(session_->shown()->plan()->headland.mainlandRatio - before) < 1e-9,
            kPatienceMs);
    }
    /// While a corner is dragged, and after it was let go until the plan is there.
    void theOutlineStaysWithTheHandle() {
        DRAW_FIELD();
        const QPoint from = cornerOnMap(1);
        const QPoint to = from + (from - middle()) / 3;
        const QPoint beside = cornerOnMap(0);
        const auto isBoundary = [](const QImage& picture, QPoint at) {
            const QColor colour = picture.pixelColor(at);
            return colour.red() > 235 && colour.green() > 185 && colour.blue() < 90;
        };
        // Beside the handle in the middle of the edge.
        const auto onEdge = [beside](QPoint corner) { return corner + (beside - corner) / 3; };
        QTest::mouseMove(window_, from);
        QTest::mousePress(window_, Qt::LeftButton, Qt::AltModifier, from);
        for (int i = 1; i <= 8; ++i) {
            QTest::mouseEvent(QTest::MouseMove, window_, Qt::NoButton, Qt::AltModifier,
                              from + (to - from) * i / 8);
        }
        for (const bool held : {true, false}) {
            const QImage picture = window_->grabWindow();
            QDir{}.mkpath(QStringLiteral(FURROW_SCREENSHOT_DIR));
            picture.save(QStringLiteral(FURROW_SCREENSHOT_DIR "/drag-%1.png")
                             .arg(held ? QStringLiteral("held") : QStringLiteral("let-go")));
            QVERIFY2(isBoundary(picture, onEdge(cornerOnMap(1))), held ? "dragged" : "let go");
            QVERIFY2(!isBoundary(picture, onEdge(from)),
                     held ? "dragged, where it was" : "let go, where it was");
            if (held) {
                QTest::mouseRelease(window_, Qt::LeftButton, Qt::AltModifier, to);
            }
        }
        ready();
        const QImage picture = window_->grabWindow();
        QVERIFY(isBoundary(picture, onEdge(cornerOnMap(1))) && !isBoundary(picture, onEdge(from)));
    }
    void theMapStillMovesBesideTheField() {
        DRAW_FIELD();
        const QGeoCoordinate centre = camera()->center();
        drag(middle() + QPoint{5, 5}, middle() + QPoint{60, 40});
        QVERIFY(camera()->center().distanceTo(centre) > 10.0);
        QVERIFY(!session_->document()->isDragging());
        QCOMPARE(session_->document()->history().steps.size(), std::size_t{1});
    }
    /// Prints how evenly frames come while a corner of a 64 ha field is dragged; how fast is not for a test.
    void draggingACornerKeepsDrawing_data() {
        QTest::addColumn<int>("sample");
        QTest::addColumn<double>("width");
        QTest::newRow("a square of 64 ha") << -1 << 12.0;
        QTest::newRow("a sample of 105 corners and over 500 swaths") << 4 << 2.5;
    }
    void draggingACornerKeepsDrawing() {
        QFETCH(int, sample);
        QFETCH(double, width);
        if (sample < 0) {
            session_->opener()->addDrawn(
                {{58.25, 22.5}, {58.25, 22.5136}, {58.2572, 22.5136}, {58.2572, 22.5}});
        } else {
            session_->opener()->openSample(sample);
        }
        QTRY_VERIFY(session_->farm()->hasField());
        session_->planning()->machine()->setNumber(0, width);
        ready();
        const std::size_t before = steps();
        const QPoint from = cornerOnMap(1);
        QSignalSpy plans{session_->shown(), &ShownPlan::planChanged};
        QTest::mouseMove(window_, from);
        QTest::mousePress(window_, Qt::LeftButton, {}, from);
        FrameClock frames{*window_};
        for (int i = 0; i < 60; ++i) {
            frames.move(from + QPoint{-i, -i / 2});
        }
        qInfo("%lld plans; %s", static_cast<long long>(plans.count()), qPrintable(frames.text()));
        QTest::mouseRelease(window_, Qt::LeftButton, {}, from + QPoint{-59, -29});
        QTRY_COMPARE_WITH_TIMEOUT(session_->shown()->plan()->field().source().parts == source().parts, true,
                                  kPatienceMs);
        QCOMPARE(steps(), before + 1);
    }
    void aSwathIsInspected() {
        DRAW_FIELD();
        const Swath& swath =
            session_->shown()->plan()->swaths.swaths[session_->shown()->plan()->swaths.swaths.size() / 2];
        clickAt(onMap(
            coordinate(session_->shown()->plan()->field().frame().toGeo(0.5 * (swath.start + swath.end)))));
        QTRY_VERIFY(shows(QStringLiteral("inspector")));
        QVERIFY(item(QStringLiteral("inspector.title"))
                    ->property("text")
                    .toString()
                    .startsWith(QStringLiteral("Swath")));
        picture(QStringLiteral("swath"));
    }
    void theMenuUndoes() {
        DRAW_FIELD();
        click(QStringLiteral("bar.Edit"));
        QTRY_VERIFY(shows(QStringLiteral("command.undo.item")));
        QTRY_VERIFY(item(QStringLiteral("command.undo.item"))
                        ->property("text")
                        .toString()
                        .contains(QStringLiteral("Add field")));
        QTRY_COMPARE(
            item(QStringLiteral("command.undo.item"))->parentItem()->parentItem()->parentItem()->opacity(),
            1.0);
        picture(QStringLiteral("menu"));
        click(QStringLiteral("command.undo.item"));
        QTRY_VERIFY(!session_->farm()->hasField());
    }
    void theUndoButtonsFollow() {
        QVERIFY(!item(QStringLiteral("undoButton"))->isEnabled());
        DRAW_FIELD();
        QTRY_VERIFY(item(QStringLiteral("undoButton"))->isEnabled());
        click(QStringLiteral("undoButton"));
        QTRY_VERIFY(!session_->farm()->hasField());
        click(QStringLiteral("redoButton"));
        QTRY_VERIFY(session_->farm()->hasField());
        ready();
    }
    /// While something is drawn, undo is about its points.
    void undoTakesTheLastPointBack() {
        camera()->centreOn(QGeoCoordinate{58.2515, 22.5035}, 16.0, false);
        key(Qt::Key_B);
        QTRY_VERIFY(shows(QStringLiteral("drawingHint")));
        QVERIFY(!shows(QStringLiteral("sketch.takingBack")));
        clickAt(middle() + QPoint{-200, -150});
        clickAt(middle() + QPoint{200, -150});
        QTRY_COMPARE(editor()->sketchCount(), 2);
        QTRY_VERIFY(shows(QStringLiteral("sketch.takingBack")));
        picture(QStringLiteral("drawing_taking_back"));
        const GeoRing drawn = editor()->sketch();
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(editor()->sketchCount(), 1);
        QTRY_VERIFY(item(QStringLiteral("undoButton"))->isEnabled());
        click(QStringLiteral("undoButton"));
        QTRY_COMPARE(editor()->sketchCount(), 0);
        QVERIFY(editor()->isDrawing());
        QVERIFY(!item(QStringLiteral("undoButton"))->isEnabled());
        // They come again in their order, until another one is drawn.
        QTRY_VERIFY(item(QStringLiteral("redoButton"))->isEnabled());
        click(QStringLiteral("redoButton"));
        QTRY_COMPARE(editor()->sketchCount(), 1);
        QVERIFY(editor()->sketch() == GeoRing(drawn.begin(), drawn.begin() + 1));
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_COMPARE(editor()->sketchCount(), 2);
        QVERIFY(editor()->sketch() == drawn);
        QVERIFY(!item(QStringLiteral("redoButton"))->isEnabled());
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(editor()->sketchCount(), 1);
        clickAt(middle() + QPoint{200, 150});
        QTRY_COMPARE(editor()->sketchCount(), 2);
        QVERIFY(!item(QStringLiteral("redoButton"))->isEnabled());
    }
    /// A length that was typed is for one point only.
    void theLengthFollowsThePointerAgain() {
        const auto follows = [this](QPoint at) {
            QTest::mouseMove(window_, at);
            QTRY_VERIFY(editor()->sketchLengthM() > 1.0);
            QTRY_COMPARE(item(QStringLiteral("sketch.length"))->property("text").toString(),
                         QString::number(editor()->sketchLengthM(), 'f', 2));
        };
        camera()->centreOn(QGeoCoordinate{58.2515, 22.5035}, 16.0, false);
        key(Qt::Key_B);
        clickAt(middle() + QPoint{-200, -150});
        follows(middle() + QPoint{-100, -120});
        enter(QStringLiteral("sketch.length"), QStringLiteral("200"));
        QTRY_COMPARE(editor()->sketchCount(), 2);
        follows(middle() + QPoint{50, 20});
        // Typed and left, it holds until there is a point.
        click(QStringLiteral("sketch.length"));
        key(Qt::Key_A, Qt::ControlModifier);
        type(QStringLiteral("150"));
        key(Qt::Key_Tab);
        QTRY_COMPARE(item(QStringLiteral("sketch.length"))->property("text").toString(),
                     QStringLiteral("150.00"));
        QTest::mouseMove(window_, middle() + QPoint{80, 60});
        QTRY_VERIFY(editor()->sketchLengthM() > 1.0);
        QCOMPARE(item(QStringLiteral("sketch.length"))->property("text").toString(),
                 QStringLiteral("150.00"));
        clickAt(middle() + QPoint{120, 100});
        QTRY_COMPARE(editor()->sketchCount(), 3);
        follows(middle() + QPoint{-60, 140});
        key(Qt::Key_Escape);
        QTRY_VERIFY(!editor()->isDrawing());
        key(Qt::Key_B);
        clickAt(middle() + QPoint{-150, -100});
        follows(middle() + QPoint{90, 40});
    }
    void commandsAreFoundByName() {
        DRAW_FIELD();
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(shows(QStringLiteral("palette.field")));
        QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
        type(QStringLiteral("draw"));
        QTRY_VERIFY(shows(QStringLiteral("palette.row.3")));
        picture(QStringLiteral("palette"));
        type(QStringLiteral(" obst"));
        key(Qt::Key_Return);
        QTRY_COMPARE(editor()->tool(), FieldEditor::Tool::Obstacle);
        key(Qt::Key_Escape);
        QTRY_COMPARE(editor()->tool(), FieldEditor::Tool::Select);
        key(Qt::Key_F1, Qt::ControlModifier);
        QTRY_VERIFY(engine_->rootObjects()
                        .first()
                        ->findChild<QObject*>(QStringLiteral("keysDialog"))
                        ->property("opened")
                        .toBool());
        picture(QStringLiteral("keys"));
        key(Qt::Key_Escape);
    }
    void aFieldHasSeveralPlans() {
        DRAW_FIELD();
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(shows(QStringLiteral("palette.field")));
        type(QStringLiteral("add a plan"));
        key(Qt::Key_Return);
        QTRY_VERIFY(shows(QStringLiteral("nameDialog.name")));
        QTRY_VERIFY(item(QStringLiteral("nameDialog.name"))->hasActiveFocus());
        type(QStringLiteral("Harvest"));
        picture(QStringLiteral("name"));
        key(Qt::Key_Return);
        QTRY_COMPARE(session_->farm()->plans().size(), 2);
        session_->planning()->machine()->setLibraryIndex(3);
        ready();
        click(QStringLiteral("planCrumb"));
        QTRY_VERIFY(shows(QStringLiteral("planCrumb.0")));
        picture(QStringLiteral("plans"));
        click(QStringLiteral("planCrumb.0"));
        QTRY_COMPARE(session_->planning()->machine()->libraryIndex(), 0);
        ready();
    }
    void closingAsks() {
        DRAW_FIELD();
        QVERIFY(!window_->close());
        QTRY_VERIFY(shows(QStringLiteral("unsaved.save")));
        picture(QStringLiteral("unsaved"));
        click(QStringLiteral("unsaved.cancel"));
        QTRY_VERIFY(!shows(QStringLiteral("unsaved.save")));
        QVERIFY(window_->isVisible());
        window_->close();
        QTRY_VERIFY(shows(QStringLiteral("unsaved.discard")));
        click(QStringLiteral("unsaved.discard"));
        QTRY_VERIFY(!window_->isVisible());
    }
    void whatACrashLeftIsShown() {
        const QTemporaryDir folder;
        {
            // What the program leaves behind when it is killed.
            Session other;
            other.keepIn(folder.path());
            other.opener()->addDrawn({{58.25, 22.5}, {58.25, 22.507}, {58.2535, 22.507}, {58.2535, 22.5}});
        }
        session_->keepIn(folder.path());
        QVERIFY(session_->files()->recover());
        QTRY_VERIFY(shows(QStringLiteral("filesNotice")));
        ready();
        picture(QStringLiteral("restored"));
        click(QStringLiteral("filesNotice.keep"));
        QTRY_VERIFY(!shows(QStringLiteral("filesNotice")));
        QVERIFY(session_->farm()->hasField());
        session_->files()->abandonChanges();
    }
    void recentProjectsAreOffered() {
        const QTemporaryDir folder;
        DRAW_FIELD();
        session_->files()->saveAs(QUrl::fromLocalFile(folder.filePath(QStringLiteral("Home farm.furrow"))));
        QTRY_VERIFY(!session_->document()->isModified());
        QTRY_COMPARE(session_->recent()->count(), 1);
        key(Qt::Key_N, Qt::ControlModifier);
        QTRY_VERIFY(!session_->farm()->hasField());
        QTRY_VERIFY(shows(QStringLiteral("empty.recent.0")));
        picture(QStringLiteral("recent"));
        click(QStringLiteral("empty.recent.0"));
        QTRY_VERIFY(session_->farm()->hasField());
        ready();
    }
};

FURROW_TEST_WITH(TestEditorWindow, QGuiApplication);
#include "tst_editor_window.moc"
