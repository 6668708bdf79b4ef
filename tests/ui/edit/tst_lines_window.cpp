#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"

#include <QRegularExpression>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

using namespace furrow;
using namespace furrow::test;

/// Lines that the mainland is cut along, drawn and changed on the map.
class TestLinesWindow : public EditorWindowTest {
    Q_OBJECT

    std::vector<GeoRing> splits() const { return linesOf(*session_->document()->project()).splits; }
    QPoint pointOnMap(std::size_t line, std::size_t point) const {
        const GeoPoint place = splits()[line][point];
        return onMap(QGeoCoordinate{place.latDeg, place.lonDeg});
    }
    QString title() const { return item(QStringLiteral("inspector.title"))->property("text").toString(); }

private slots:
    // No coordinates need be typed: a place is clicked, lines are drawn.
    void placesAndLinesArePicked() {
        DRAW_FIELD();
        item(QStringLiteral("stepsPanel"))->setProperty("openStep", QStringLiteral("route"));
        click(QStringLiteral("route.start.pick"));
        QTRY_VERIFY(shows(QStringLiteral("picker.hint")));
        picture(QStringLiteral("picking_start"));
        const QPoint at = middle() + QPoint{-150, 100};
        const QGeoCoordinate place = camera()->coordinateAt(map()->mapFromScene(at));
        clickAt(at);
        const Parameter& parameter = **findParameter("route.start");
        const auto chosen = [&] { return settingText(session_->planning()->settings().value(parameter)); };
        QTRY_VERIFY(!chosen().empty());
        ready();
        const std::string start = chosen();
        QVERIFY2(start.starts_with("POINT"), start.c_str());
        const QStringList parts =
            QString::fromStdString(start).split(QRegularExpression{QStringLiteral("[ ()]+")});
        QVERIFY2(std::abs(parts.value(1).toDouble() - place.longitude()) < 1e-4 &&
                     std::abs(parts.value(2).toDouble() - place.latitude()) < 1e-4,
                 qPrintable(QStringLiteral("%1; clicked %2 %3")
                                .arg(QString::fromStdString(start))
                                .arg(place.longitude())
                                .arg(place.latitude())));
        // Escape ends it without a place.
        click(QStringLiteral("route.end.pick"));
        QTRY_VERIFY(shows(QStringLiteral("picker.hint")));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("picker.hint")));
        // A split line is drawn.
        item(QStringLiteral("stepsPanel"))->setProperty("openStep", QStringLiteral("decomposition"));
        click(QStringLiteral("decomposition.split.pick"));
        QTRY_COMPARE(editor()->tool(), FieldEditor::Tool::Split);
        key(Qt::Key_Escape);
        key(Qt::Key_V);
        // The centre of a pivot is a place.
        session_->planning()->set(QStringLiteral("swaths.method"), QStringLiteral("pivot"));
        item(QStringLiteral("stepsPanel"))->setProperty("openStep", QStringLiteral("swaths"));
        click(QStringLiteral("swaths.line.pick"));
        QTRY_VERIFY(shows(QStringLiteral("picker.hint")));
        clickAt(middle());
        ready();
        QVERIFY(session_->shown()->plan()->swaths.swaths.size() > 3);
        picture(QStringLiteral("picked_pivot"));
    }
    // An outline along pixels: the card offers a straight one, for all fields of the farm.
    void stepsAreMadeStraight() {
        session_->opener()->openUrls(
            {QUrl::fromLocalFile(QStringLiteral(FURROW_SOURCE_DIR "/tests/data/stepped/one.geojson"))});
        QTRY_VERIFY(shows(QStringLiteral("outlineSteps")));
        QVERIFY(item(QStringLiteral("outlineSteps.text"))
                    ->property("text")
                    .toString()
                    .contains(QStringLiteral("1.5 m")));
        QVERIFY(!shows(QStringLiteral("outlineSteps.all")));
        picture(QStringLiteral("outline_steps"));
        const std::size_t points = source().parts.front().outer.size();
        click(QStringLiteral("outlineSteps.straighten"));
        QTRY_VERIFY(!shows(QStringLiteral("outlineSteps")));
        QVERIFY(points > 100 && source().parts.front().outer.size() < 17);
        ready();
        picture(QStringLiteral("outline_straight"));
        // Undone, it is offered again; closed, it is not, and the menu still has it.
        session_->document()->undo();
        QTRY_VERIFY(shows(QStringLiteral("outlineSteps")));
        QCOMPARE(source().parts.front().outer.size(), points);
        click(QStringLiteral("outlineSteps.close"));
        QTRY_VERIFY(!shows(QStringLiteral("outlineSteps")));
        QVERIFY(QMetaObject::invokeMethod(
            window_->findChild<QObject*>(QStringLiteral("command.straightenSteps")), "trigger"));
        QVERIFY(source().parts.front().outer.size() < 17);
    }
    // The shaft lies in the half of a step that a straight outline leaves out.
    void stepsThatStayAreTold() {
        session_->opener()->openUrls(
            {QUrl::fromLocalFile(QStringLiteral(FURROW_SOURCE_DIR "/tests/data/stepped/shaft.geojson"))});
        QTRY_VERIFY(shows(QStringLiteral("outlineSteps")));
        const std::size_t before = steps();
        click(QStringLiteral("outlineSteps.straighten"));
        QCOMPARE(item(QStringLiteral("outlineSteps"))->property("remedy").toString(),
                 QStringLiteral("Made straight, it would be refused: a hole lies outside the boundary; move "
                                "or delete it."));
        QVERIFY(shows(QStringLiteral("outlineSteps")));
        QCOMPARE(steps(), before);
        picture(QStringLiteral("outline_steps_refused"));
        click(QStringLiteral("outlineSteps.close"));
        QTRY_VERIFY(!shows(QStringLiteral("outlineSteps")));
        // By the menu it fails again, and says so again.
        QVERIFY(QMetaObject::invokeMethod(
            window_->findChild<QObject*>(QStringLiteral("command.straightenSteps")), "trigger"));
        QTRY_VERIFY(shows(QStringLiteral("outlineSteps")));
    }
    // One of two fields stays as it is: the card says which.
    void fieldsThatStayAreNamed() {
        session_->opener()->openUrls(
            {QUrl::fromLocalFile(QStringLiteral(FURROW_SOURCE_DIR "/tests/data/stepped/one.geojson"))});
        QTRY_VERIFY(shows(QStringLiteral("outlineSteps")));
        const auto shaft = readBoundaries(FURROW_SOURCE_DIR "/tests/data/stepped/shaft.geojson");
        QVERIFY(shaft.has_value());
        FieldSource other = shaft->front();
        other.id = "other";
        other.name = "Shaft Field";
        session_->document()->change([] { return QString{}; },
                                     showing(withFields(*session_->document()->project(), {other}), 0, 0));
        QTRY_VERIFY(shows(QStringLiteral("outlineSteps.all")));
        click(QStringLiteral("outlineSteps.all"));
        QTRY_VERIFY(!shows(QStringLiteral("outlineSteps.all")));
        QVERIFY(shows(QStringLiteral("outlineSteps")));
        QCOMPARE(item(QStringLiteral("outlineSteps"))->property("text").toString(),
                 QStringLiteral("1 field stays as it is: Shaft Field."));
        picture(QStringLiteral("outline_steps_left"));
        click(QStringLiteral("outlineSteps.close"));
        QTRY_VERIFY(!shows(QStringLiteral("outlineSteps")));
    }
    void stepsOfAllFieldsAreMadeStraight() {
        session_->opener()->openUrls(
            {QUrl::fromLocalFile(QStringLiteral(FURROW_SOURCE_DIR "/tests/data/stepped/farm.geojson"))});
        QTRY_COMPARE(session_->planning()->state(), PlanState::Choosing);
        session_->opener()->chooseAll();
        QTRY_VERIFY(shows(QStringLiteral("outlineSteps")));
        const std::size_t before = steps();
        click(QStringLiteral("outlineSteps.all"));
        QTRY_VERIFY(!shows(QStringLiteral("outlineSteps")));
        const Project& project = *session_->document()->project();
        QCOMPARE(project.fields.size(), 3U);
        for (const auto& field : project.fields) {
            QVERIFY(field->source->parts.front().outer.size() < 17);
        }
        QCOMPARE(steps(), before + 1);
    }
    // Two clicks are two refill points: the plan drives to them, and shows them. A click on one removes it,
    // and all of it can be undone.
    void refillPointsArePicked() {
        DRAW_FIELD();
        const auto machines = machineLibrary();
        session_->planning()->machine()->setLibraryIndex(static_cast<int>(
            std::ranges::find(machines, std::string{"mounted-drill"}, &Machine::id) - machines.begin()));
        ready();
        QCOMPARE(session_->shown()->plan()->path.refillCount(), 0);
        item(QStringLiteral("stepsPanel"))->setProperty("openStep", QStringLiteral("route"));
        click(QStringLiteral("route.refill.pick"));
        QTRY_VERIFY(shows(QStringLiteral("placesPicker.hint")));
        const auto points = [&] { return session_->planning()->pointsOf(QStringLiteral("route.refill")); };
        const QPoint first = middle() + QPoint{-185, 40};
        const QGeoCoordinate place = camera()->coordinateAt(map()->mapFromScene(first));
        clickAt(first);
        QTRY_COMPARE(points().size(), 1);
        QVERIFY(points().front().value<QGeoCoordinate>().distanceTo(place) < 0.5);
        clickAt(middle() + QPoint{185, -40});
        QTRY_COMPARE(points().size(), 2);
        QTRY_VERIFY(shows(QStringLiteral("placesPicker.place.1")));
        picture(QStringLiteral("refill1_picking"));
        click(QStringLiteral("placesPicker.done"));
        QTRY_VERIFY(!shows(QStringLiteral("placesPicker.hint")));
        ready();
        const auto plan = session_->shown()->plan();
        QVERIFY(plan->path.refillCount() > 0);
        QCOMPARE(plan->refill->points.size(), std::size_t{2});
        QVERIFY2(plan->drivable(), plan->findings.empty() ? "" : plan->findings.front().text.c_str());
        // In words; as text, too, for those who want it.
        const QString refill = QStringLiteral("route.refill");
        QTRY_COMPARE(item(refill + QStringLiteral(".picked"))->property("text").toString(),
                     QStringLiteral("2 places on the map"));
        QVERIFY(!shows(refill));
        picture(QStringLiteral("refill2_planned"));
        click(refill + QStringLiteral(".asText"));
        QTRY_VERIFY(shows(refill) && item(refill)->hasActiveFocus());
        // Above what stands at the foot of the panel.
        const auto edgeOf = [&](const QString& name, double share) {
            return item(name)->mapToScene({0.0, share * item(name)->height()}).y();
        };
        QTRY_VERIFY(edgeOf(refill, 1.0) < edgeOf(QStringLiteral("steps.bestPlan"), 0.0));
        QVERIFY(item(refill)->property("text").toString().startsWith(QStringLiteral("MULTIPOINT")));
        picture(QStringLiteral("refill2_as_text"));
        click(refill + QStringLiteral(".asText"));
        QTRY_VERIFY(!shows(refill));
        // A trip is clicked on, and the drive stands at its point.
        const auto& segments = plan->path.segments;
        const auto stop =
            static_cast<int>(std::ranges::find(segments, true, &PathSegment::refills) - segments.begin());
        session_->drive()->setTime(segments[static_cast<std::size_t>(stop)].samples.back().tS + 150.0);
        QTRY_VERIFY2(session_->drive()->figuresText().contains(QStringLiteral("tank")),
                     qPrintable(session_->drive()->figuresText()));
        editor()->selectSegment(stop);
        QTRY_COMPARE(title(), QStringLiteral("Way to refill"));
        picture(QStringLiteral("refill3_driven"));
        session_->drive()->setTime(0.0);
        // A click on a place removes it.
        click(QStringLiteral("route.refill.pick"));
        QTRY_VERIFY(shows(QStringLiteral("placesPicker.place.0")));
        click(QStringLiteral("placesPicker.place.0"));
        QTRY_COMPARE(points().size(), 1);
        key(Qt::Key_Escape);
        QTRY_VERIFY(!shows(QStringLiteral("placesPicker.hint")));
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(points().size(), 2);
        // All of them at once.
        click(refill + QStringLiteral(".remove"));
        QTRY_COMPARE(points().size(), 0);
        QTRY_VERIFY(!shows(refill + QStringLiteral(".remove")));
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(points().size(), 2);
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(points().size(), 1);
        key(Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(points().size(), 0);
        ready();
        QCOMPARE(session_->shown()->plan()->path.refillCount(), 0);
    }
    void aFieldIsCutByMouse() {
        DRAW_FIELD();
        const std::size_t cells = session_->shown()->plan()->cells.cells.size();
        click(QStringLiteral("splitTool"));
        QTRY_VERIFY(shows(QStringLiteral("drawingHint")));
        clickAt(middle() + QPoint{-40, -180});
        clickAt(middle() + QPoint{30, 0});
        QTest::mouseMove(window_, middle() + QPoint{-20, 150});
        picture(QStringLiteral("split1_drawing"));
        clickAt(middle() + QPoint{-20, 180});
        click(QStringLiteral("finishDrawing"));
        QTRY_COMPARE(splits().size(), std::size_t{1});
        QCOMPARE(splits()[0].size(), std::size_t{3});
        QTRY_VERIFY(shows(QStringLiteral("inspector")));
        QCOMPARE(title(), QStringLiteral("Split line 1"));
        ready();
        QVERIFY(session_->shown()->plan()->cells.cells.size() > cells);
        picture(QStringLiteral("split2_drawn"));

        // Its middle point is dragged, as one change.
        const std::size_t steps = session_->document()->history().steps.size();
        drag(pointOnMap(0, 1), pointOnMap(0, 1) + QPoint{60, 20}, Qt::AltModifier);
        QCOMPARE(session_->document()->history().steps.size(), steps + 1);
        QVERIFY((pointOnMap(0, 1) - (middle() + QPoint{90, 20})).manhattanLength() <= 2);
        ready();
        picture(QStringLiteral("split3_moved"));
        const auto moved = *session_->document()->project();

        // It is kept in the project.
        const QTemporaryDir folder;
        session_->files()->saveAs(QUrl::fromLocalFile(folder.filePath(QStringLiteral("cut.furrow"))));
        QTRY_VERIFY(!session_->document()->isModified());
        session_->opener()->startNew();
        session_->opener()->open(folder.filePath(QStringLiteral("cut.furrow")));
        QTRY_VERIFY(session_->farm()->hasField());
        QVERIFY(*session_->document()->project() == moved);
        ready();

        // A click selects it, Delete deletes it, and all of that can be undone and redone.
        clickAt(pointOnMap(0, 0) + (pointOnMap(0, 1) - pointOnMap(0, 0)) / 3 + QPoint{2, 0});
        QTRY_VERIFY(shows(QStringLiteral("inspector")));
        QTRY_COMPARE(title(), QStringLiteral("Edge 1 of the split line"));
        key(Qt::Key_Delete);
        QVERIFY(splits().empty());
        key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(splits().size(), std::size_t{1});
        key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(splits().empty());
        ready();
        QCOMPARE(session_->shown()->plan()->cells.cells.size(), cells);
    }
    void byKeysAlone() {
        DRAW_FIELD();
        map()->forceActiveFocus();
        key(Qt::Key_S);
        QTRY_VERIFY(shows(QStringLiteral("drawingHint")));
        // From 250 m west of the middle of the map, where the first point goes, straight through to the east.
        editor()->leave();
        camera()->panBy(200.0, 0.0);
        key(Qt::Key_Space);
        QTRY_COMPARE(editor()->sketchCount(), 1);
        enterWay(QStringLiteral("600"), QStringLiteral("90"));
        map()->forceActiveFocus();
        key(Qt::Key_Return);
        QTRY_COMPARE(splits().size(), std::size_t{1});
        key(Qt::Key_Escape);
        QTRY_VERIFY(!editor()->hasSelection());
        // The boundary comes first, then the line; back at the line it is moved and deleted.
        key(Qt::Key_PageDown);
        QCOMPARE(editor()->selection().kind, Selection::Kind::Vertex);
        key(Qt::Key_PageDown);
        QCOMPARE(editor()->selection().kind, Selection::Kind::Split);
        const double before = splits()[0][0].latDeg;
        key(Qt::Key_Up, Qt::ShiftModifier);
        QTRY_VERIFY(splits()[0][0].latDeg > before);
        ready();
        picture(QStringLiteral("split4_keys"));
        key(Qt::Key_Delete);
        QVERIFY(splits().empty());
        key(Qt::Key_K, Qt::ControlModifier);
        QTRY_VERIFY(item(QStringLiteral("palette.field"))->hasActiveFocus());
        type(QStringLiteral("split"));
        // What would be undone is no command of that name; settings come after the command.
        QTRY_VERIFY(shows(QStringLiteral("palette.row.0")) && shows(QStringLiteral("palette.row.1")));
        QVERIFY(!item(QStringLiteral("palette.row.1"))->property("text").toString().startsWith("Undo"));
        key(Qt::Key_Return);
        QTRY_COMPARE(editor()->tool(), FieldEditor::Tool::Split);
        key(Qt::Key_Escape);
        QTRY_COMPARE(editor()->tool(), FieldEditor::Tool::Select);
    }
};

FURROW_TEST_WITH(TestLinesWindow, QGuiApplication);
#include "tst_lines_window.moc"
