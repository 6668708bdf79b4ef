// A farm of 30 fields in the window: the list, the map, planning all of them, with the mouse and with keys
// only.

#include "planner/machine/machine_library.h"
#include "tests/support/test_program.h"
#include "tests/ui/farm/farm_samples.h"
#include "tests/ui/window/window_test.h"

using namespace furrow;

class TestFarmWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void listAndMap();
    void plannedStoppedAndGoneOnWith();
    void byKeys();
    void fitsSmallWindows();

private:
    FarmList& list() { return *session_->farmList(); }
    FarmPlans& plans() { return *session_->farmPlans(); }
    void waitForPlan() { QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs); }
};

void TestFarmWindow::init() {
    begin({1440, 900});
    session_->document()->begin(
        History{.base = std::make_shared<const Project>(test::farmOf(30, 50.0, 1.0))});
    waitForPlan();
}

void TestFarmWindow::cleanup() {
    end();
}

void TestFarmWindow::listAndMap() {
    click("farmButton");
    QTRY_VERIFY(item("farmPanel")->isVisible());
    QCOMPARE(list().stateOf(0), FarmList::Drivable);
    QTRY_VERIFY(item("farm.field.3") != nullptr);
    click("farm.field.3");
    QCOMPARE(list().chosen(), std::vector<std::size_t>{3});
    clickAt(middleOf(*item("farm.field.6")), Qt::ShiftModifier);
    QCOMPARE(list().selectedCount(), 4);
    clickAt(middleOf(*item("farm.field.4")), Qt::ControlModifier);
    QCOMPARE(list().selectedCount(), 3);
    picture("farm_selected");
    // On the map, too.
    waitForRest(*item("farm.name.17"));
    const auto bounds = list().index(17).data(FarmList::BoundsRole).value<QGeoRectangle>();
    clickAt(onMap(bounds.center()));
    QTRY_COMPARE(list().chosen(), std::vector<std::size_t>{17});
    click("farm.sort.area");
    click("farm.sort.area");
    QCOMPARE(list().index(0).data(FarmList::NameRole).toString(), QStringLiteral("Field 30"));
    click("farm.filter");
    type("field 2");
    QCOMPARE(list().count(), 12);
    picture("farm_filtered");
    QTRY_VERIFY(item("farm.field.0") != nullptr);
    QTest::mouseDClick(window_, Qt::LeftButton, {}, middleOf(*item("farm.field.0")));
    QTRY_VERIFY(!item("farmPanel")->isVisible());
    QCOMPARE(session_->farm()->fieldName(), QStringLiteral("Field 29"));
    waitForPlan();
    picture("farm_neighbours");
}

void TestFarmWindow::plannedStoppedAndGoneOnWith() {
    // Of the same kind for all, in one step; then all of them.
    session_->document()->change([] { return QString{}; },
                                 withPlan(*session_->document()->project(), machineLibrary()[1], {}));
    waitForPlan();
    key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    click("farm.selection");
    QCOMPARE(list().selectedCount(), 30);
    click("farm.alike");
    QCOMPARE(session_->document()->project()->planOf(29).machine, machineLibrary()[1]);
    click("farm.plan");
    QTRY_VERIFY_WITH_TIMEOUT(list().toPlan() < 25, kPatienceMs);
    QVERIFY(plans().isBusy());
    picture("farm_planning");
    click("farm.stop");
    QTRY_VERIFY(!plans().isBusy());
    QVERIFY(list().toPlan() > 0);
    picture("farm_stopped");
    click("farm.plan");
    // The window goes on meanwhile.
    key(Qt::Key_Escape);
    QTRY_VERIFY(!item("farmPanel")->isVisible());
    QVERIFY(plans().isBusy());
    QTRY_VERIFY_WITH_TIMEOUT(!plans().isBusy(), 4 * kPatienceMs);
    key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(list().toPlan(), 0);
    picture("farm_planned");
    // Those of the list are printed.
    list().selectNone();
    list().pick(0, FarmList::Toggle);
    list().pick(1, FarmList::Toggle);
    click("farm.print");
    QTRY_VERIFY_WITH_TIMEOUT(session_->printing()->state() == Printing::State::Ready, kPatienceMs);
    QCOMPARE(session_->printing()->fieldCount(), 2);
    QVERIFY(session_->printing()->isWholeFarm());
    picture("farm_print");
}

void TestFarmWindow::byKeys() {
    key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(item("farm.list")->hasActiveFocus());
    key(Qt::Key_Down);
    key(Qt::Key_Space);
    QCOMPARE(list().chosen(), std::vector<std::size_t>{1});
    key(Qt::Key_Down, Qt::ShiftModifier);
    QCOMPARE(list().chosen(), (std::vector<std::size_t>{1, 2}));
    key(Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(list().selectedCount(), 30);
    key(Qt::Key_End);
    key(Qt::Key_Return);
    QTRY_COMPARE(session_->farm()->fieldName(), QStringLiteral("Field 30"));
    QVERIFY(!item("farmPanel")->isVisible());
}

void TestFarmWindow::fitsSmallWindows() {
    window_->resize(1000, 640);
    key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(item("farmPanel")->isVisible());
    QTRY_VERIFY(item("farm.field.1") != nullptr);
    click("farm.field.1");
    waitForRest(*item("farm.field.1"));
    QVERIFY(map()->width() > 200.0);
    // The buttons are all inside.
    for (const char* name : {"farm.plan", "farm.alike", "farm.addPlans", "farm.print"}) {
        const QQuickItem* const button = item(QLatin1String{name});
        QVERIFY(button->mapToScene({button->width(), button->height()}).x() <= item("farmPanel")->width());
        QVERIFY(button->mapToScene({0.0, button->height()}).y() <= window_->height());
    }
    picture("farm_small");
}

FURROW_TEST_WITH(TestFarmWindow, QGuiApplication);
#include "tst_farm_window.moc"
