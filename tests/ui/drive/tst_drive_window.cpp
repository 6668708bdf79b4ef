// The drive-through in the window: played, dragged, stepped, and gone when the plan is another one.

#include "planner/machine/machine_library.h"
#include "planner/project/project_edits.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

#include <QSignalSpy>

#include <cmath>

using namespace furrow;

class TestDriveWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void playsToTheEnd();
    void allWorkedLandIsDrawn();
    void sliderByMouseAndKeys();
    void goesToWhatIsSelected();
    void followsTheMachine();
    void stopsWithThePlan();
    void everyMachineIsDrawn_data();
    void everyMachineIsDrawn();
    void sliderHasRoom_data();
    void sliderHasRoom();
    void barIsHiddenAndRemembered();
    void otherThemes_data();
    void otherThemes();

private:
    DriveThrough& drive() { return *session_->drive(); }
    void take(const char* machine);
};

void TestDriveWindow::init() {
    begin({1440, 900});
    openSample("Home Field");
    QTRY_VERIFY(drive().isAvailable());
}

void TestDriveWindow::cleanup() {
    end();
}

void TestDriveWindow::take(const char* machine) {
    const Project& project = *session_->document()->project();
    session_->document()->change([] { return QString{}; },
                                 withPlan(project, findMachine(machine).value(), project.plan().settings));
    QTRY_VERIFY(session_->shown()->plan()->request.machine.name() == findMachine(machine).value().name());
    QTRY_VERIFY(isFinished(session_->planning()->state()));
    QTRY_VERIFY(drive().isAvailable() && drive().plan() == session_->shown()->plan());
}

void TestDriveWindow::playsToTheEnd() {
    QVERIFY(!drive().isUnderWay());
    drive().setPace(64);
    key(Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(drive().isPlaying());
    QTRY_VERIFY(drive().time() > 60.0);
    QVERIFY(item("drive.figures")->property("text").toString().contains("ha done"));
    click("drive.play");
    QVERIFY(!drive().isPlaying());
    const double stopped = drive().time();
    // It has stopped by itself at the end, and begins again from the start.
    drive().setTime(drive().duration() - 5.0);
    QVERIFY(drive().time() > stopped);
    click("drive.play");
    QTRY_VERIFY(!drive().isPlaying());
    QCOMPARE(drive().time(), drive().duration());
    picture("drive_end");
    click("drive.play");
    QVERIFY(drive().time() < drive().duration());
    click("drive.play");
}

// As it plays, and at once, as the slider goes.
void TestDriveWindow::allWorkedLandIsDrawn() {
    end();
    begin({1440, 900});
    openSample("Slanted Field");
    QTRY_VERIFY(drive().isAvailable());
    take("trailed-sprayer");
    // Handles of the outline show where the pointer is near.
    QTest::mouseMove(window_, middleOf(*item("drive.play")));
    const double endS = drive().duration();
    drive().setTime(0.5 * endS);
    drive().setTime(endS);
    const auto mapPicture = [this] {
        return window_->grabWindow().copy(
            QRect{map()->mapToScene({}).toPoint(), map()->size().toSize()}.marginsRemoved({80, 80, 80, 80}));
    };
    const QImage atOnce = mapPicture();
    drive().setTime(0.0);
    QVERIFY(mapPicture() != atOnce);
    drive().setPace(64);
    click("drive.play");
    QTRY_VERIFY_WITH_TIMEOUT(!drive().isPlaying(), 120'000);
    QCOMPARE(drive().time(), endS);
    QCOMPARE(mapPicture(), atOnce);
}

void TestDriveWindow::sliderByMouseAndKeys() {
    QQuickItem* const slider = item("drive.slider");
    const QPoint middle = middleOf(*slider);
    QTest::mouseClick(window_, Qt::LeftButton, {}, middle);
    QTRY_VERIFY(std::abs(drive().time() / drive().duration() - 0.5) < 0.03);
    picture("drive_middle");
    QTest::mousePress(window_, Qt::LeftButton, {}, middle);
    QTest::mouseMove(window_, middle + QPoint{slider->property("width").toInt() / 4, 0});
    QTest::mouseRelease(window_, Qt::LeftButton, {},
                        middle + QPoint{slider->property("width").toInt() / 4, 0});
    QTRY_VERIFY(drive().time() / drive().duration() > 0.65);
    slider->forceActiveFocus(Qt::TabFocusReason);
    double before = drive().time();
    key(Qt::Key_Right);
    QVERIFY(std::abs(drive().time() - before - 10.0) < 1e-6);
    before = drive().time();
    key(Qt::Key_Left);
    QVERIFY(std::abs(drive().time() - before + 10.0) < 1e-6);
    const int segment = drive().segment();
    key(Qt::Key_PageDown);
    QCOMPARE(drive().segment(), segment + 1);
    key(Qt::Key_PageUp);
    QCOMPARE(drive().segment(), segment);
    key(Qt::Key_Home);
    QCOMPARE(drive().time(), 0.0);
    QVERIFY(!drive().isUnderWay());
    key(Qt::Key_End);
    QCOMPARE(drive().time(), drive().duration());
    const int pace = drive().pace();
    click("drive.pace");
    QCOMPARE(drive().pace(), pace * 2);
    key(Qt::Key_Down);
    QCOMPARE(drive().pace(), pace);
}

void TestDriveWindow::goesToWhatIsSelected() {
    const auto& segments = session_->shown()->plan()->path.segments;
    const auto swath = std::ranges::find_if(segments, [](const PathSegment& segment) {
        return segment.kind == SegmentKind::Swath && segment.number > 5;
    });
    const auto index = static_cast<int>(swath - segments.begin());
    editor()->selectSegment(index);
    click("inspector.drive");
    QCOMPARE(drive().segment(), index);
    QVERIFY(drive().stateText().startsWith(QStringLiteral("Swath %1,").arg(swath->number)));
    QVERIFY(drive().stateText().contains("implement down"));
}

void TestDriveWindow::followsTheMachine() {
    click("drive.follow");
    camera()->zoomBy(3.0);
    drive().setTime(0.4 * drive().duration());
    QTRY_VERIFY(drive().place().distanceTo(camera()->center()) < 1.0);
    picture("drive_near");
    drive().setTime(0.6 * drive().duration());
    QTRY_VERIFY(drive().place().distanceTo(camera()->center()) < 1.0);
}

void TestDriveWindow::stopsWithThePlan() {
    click("drive.play");
    QTRY_VERIFY(drive().isUnderWay());
    take("cultivator");
    QVERIFY(!drive().isPlaying());
    QCOMPARE(drive().time(), 0.0);
    drive().setTime(100.0);
    session_->document()->undo();
    QTRY_VERIFY(isFinished(session_->planning()->state()));
    QTRY_COMPARE(drive().time(), 0.0);
}

void TestDriveWindow::everyMachineIsDrawn_data() {
    QTest::addColumn<QByteArray>("machine");
    for (const char* machine : {"agbot", "cultivator", "trailed-sprayer"}) {
        QTest::newRow(machine) << QByteArray{machine};
    }
}

void TestDriveWindow::everyMachineIsDrawn() {
    QFETCH(QByteArray, machine);
    take(machine.constData());
    click("drive.follow");
    const auto& segments = session_->shown()->plan()->path.segments;
    // In the middle of a turn, where a trailed implement swings out.
    const auto turn = std::ranges::find(segments, SegmentKind::Turn, &PathSegment::kind);
    QVERIFY(turn != segments.end());
    drive().setTime(0.5 * (turn->samples.front().tS + turn->samples.back().tS));
    camera()->centreOn(drive().place(), 19.0, false);
    picture(QStringLiteral("drive_turn_%1").arg(QLatin1String{machine}));
    const QImage there = window_->grabWindow();
    drive().setTime(0.0);
    const QImage gone = window_->grabWindow();
    // The machine is in the middle of the map, and it is gone at the start.
    const QPoint middle = middleOf(*map());
    QVERIFY(there.copy(QRect{middle - QPoint{40, 40}, QSize{80, 80}}) !=
            gone.copy(QRect{middle - QPoint{40, 40}, QSize{80, 80}}));
}

void TestDriveWindow::sliderHasRoom_data() {
    QTest::addColumn<QSize>("size");
    QTest::newRow("1920") << QSize{1920, 1080};
    QTest::newRow("1440") << QSize{1440, 900};
    QTest::newRow("1366") << QSize{1366, 768};
    QTest::newRow("1280, low") << QSize{1280, 660};
    QTest::newRow("1000, both panels") << QSize{1000, 700};
}

void TestDriveWindow::sliderHasRoom() {
    QFETCH(QSize, size);
    window_->resize(size);
    QTRY_COMPARE(window_->size(), size);
    nextFrame();
    if (!item("resultsPanel")->isVisible()) {
        key(Qt::Key_F9);
    }
    if (!item("stepsPanel")->isVisible()) {
        key(Qt::Key_F7);
    }
    QTRY_VERIFY(item("resultsPanel")->isVisible() && item("stepsPanel")->isVisible());
    drive().setTime(drive().duration() / 3.0);
    waitForRest(*item("drive.slider"));
    picture(QString{"drive_room_%1"}.arg(size.width()));
    const auto placeOf = [this](const char* name) {
        return item(name)->mapRectToScene({{}, item(name)->size()});
    };
    QVERIFY2(item("drive.slider")->width() >= 160.0,
             qPrintable(QString::number(item("drive.slider")->width())));
    for (const char* other :
         {"drive.play", "drive.time", "drive.whole", "drive.pace", "drive.follow", "drive.state",
          "drive.figures", "drive.stateBelow", "drive.figuresBelow", "drive.hide"}) {
        if (item(other)->isVisible()) {
            QVERIFY2(!placeOf(other).intersects(placeOf("drive.slider")), other);
            QVERIFY2(placeOf("driveBar").contains(placeOf(other)), other);
        }
    }
    QVERIFY(item("drive.state")->isVisible() || item("drive.stateBelow")->isVisible());
}

void TestDriveWindow::barIsHiddenAndRemembered() {
    QVERIFY(item("driveBar")->isVisible());
    const double height = map()->height();
    click("drive.hide");
    QTRY_VERIFY(!item("driveBar")->isVisible());
    QVERIFY(map()->height() > height);
    // The key brings it back and plays.
    key(Qt::Key_Space, Qt::ControlModifier);
    QTRY_VERIFY(item("driveBar")->isVisible());
    QTRY_VERIFY(drive().isPlaying());
}

void TestDriveWindow::otherThemes_data() {
    QTest::addColumn<int>("theme");
    QTest::addColumn<QSize>("size");
    QTest::newRow("dark") << 2 << QSize{1440, 900};
    QTest::newRow("sunlight") << 3 << QSize{1440, 900};
    QTest::newRow("small") << 1 << QSize{1000, 640};
}

void TestDriveWindow::otherThemes() {
    QFETCH(int, theme);
    QFETCH(QSize, size);
    QObject* const colours = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
    QVERIFY(colours != nullptr);
    colours->setProperty("forced", theme);
    window_->resize(size);
    QTRY_COMPARE(window_->height(), size.height());
    take("trailed-sprayer");
    drive().setTime(0.55 * drive().duration());
    QTRY_VERIFY(item("drive.play")->isVisible());
    picture(QStringLiteral("drive_%1").arg(QLatin1String{QTest::currentDataTag()}));
    colours->setProperty("forced", 0);
}

FURROW_TEST_WITH(TestDriveWindow, QGuiApplication);
#include "tst_drive_window.moc"
