// A farm of 30 fields in the window: the list, the map, planning all of them, with the mouse and with keys
// only.

#include "planner/io/import/field_reader.h"
#include "planner/machine/machine_library.h"
#include "tests/support/test_program.h"
#include "tests/ui/farm/farm_samples.h"
#include "tests/ui/window/window_test.h"

#include <QFile>
#include <QTemporaryDir>

using namespace furrow;

class TestFarmWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void listAndMap();
    void plannedStoppedAndGoneOnWith();
    void filteredFieldsAreMeant();
    void notPlannedAgain();
    void exportedTogether();
    void exportStopped();
    void exportedToAStick();
    void byKeys();
    void fitsSmallWindows();

private:
    FarmList& list() { return *session_->farmList(); }
    FarmPlans& plans() { return *session_->farmPlans(); }
    ExportModel& exporter() { return *session_->exporter(); }
    /// Three fields that can be planned, and one that is too small.
    void beginWithASmallOne() {
        FieldSource small =
            test::fieldSourceFromLocal({test::rectangle(3.0, 3.0)}, {.lonDeg = 22.54, .latDeg = 58.25});
        small.id = "small";
        small.name = "Corner";
        session_->document()->begin(History{
            .base = std::make_shared<const Project>(showing(withFields(test::farmOf(3), {small}), 0, 0))});
        waitForPlan();
    }
    void openExport() {
        key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(item("farmPanel")->isVisible());
        click("farm.selection");
        click("farm.export");
        QTRY_VERIFY(item("export.write") != nullptr && item("export.write")->isVisible());
    }
    void enterFolder(const QString& folder) {
        click("export.inFolder");
        click("export.folder");
        QTRY_VERIFY(item("export.folder")->hasActiveFocus());
        key(Qt::Key_A, Qt::ControlModifier);
        type(folder);
    }
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

void TestFarmWindow::filteredFieldsAreMeant() {
    key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(item("farmPanel")->isVisible());
    click("farm.filter");
    type("field 2");
    QCOMPARE(list().count(), 12);
    QTRY_VERIFY(item("farm.totals")->property("text").toString().startsWith("12 of 30 fields"));
    QVERIFY2(item("farm.plan")->property("text").toString().contains("12"),
             qPrintable(item("farm.plan")->property("text").toString()));
    click("farm.export");
    QTRY_VERIFY(item("export.write") != nullptr && item("export.write")->isVisible());
    QCOMPARE(exporter().chosen().size(), 12);
    QVERIFY(!exporter().chosen().contains(QStringLiteral("field-3")));
    key(Qt::Key_Escape);
}

void TestFarmWindow::notPlannedAgain() {
    const QTemporaryDir folder;
    session_->document()->begin(History{.base = std::make_shared<const Project>(test::farmOf(4))});
    waitForPlan();
    std::size_t again = 0;
    const auto count = [&again](const auto& plans) { again += plans.size(); };
    QObject::connect(session_->printing(), &Printing::planned, session_->printing(), count);
    QObject::connect(&exporter(), &ExportModel::planned, &exporter(), count);
    // One without a plan is planned for the pages, and is planned then.
    key(Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(item("farm.field.3") != nullptr);
    click("farm.field.3");
    click("farm.print");
    QTRY_COMPARE_WITH_TIMEOUT(session_->printing()->state(), Printing::State::Ready, kPatienceMs);
    QCOMPARE(again, std::size_t{1});
    QCOMPARE(list().stateOf(3), FarmList::Drivable);
    key(Qt::Key_Escape);
    again = 0;
    click("farm.selection");
    QTRY_COMPARE(list().toPlan(), 2);
    click("farm.plan");
    QTRY_VERIFY_WITH_TIMEOUT(list().toPlan() == 0 && !plans().isBusy(), kPatienceMs);
    click("farm.print");
    QTRY_COMPARE_WITH_TIMEOUT(session_->printing()->state(), Printing::State::Ready, kPatienceMs);
    QCOMPARE(session_->printing()->fieldCount(), 4);
    key(Qt::Key_Escape);
    QTRY_VERIFY(!session_->printing()->isOpen());
    click("farm.export");
    QTRY_VERIFY(item("export.write") != nullptr && item("export.write")->isVisible());
    enterFolder(folder.filePath("farm"));
    click("export.write");
    QTRY_COMPARE_WITH_TIMEOUT(exporter().state(), ExportModel::State::Done, kPatienceMs);
    QCOMPARE(again, std::size_t{0});
}

void TestFarmWindow::exportedTogether() {
    const QTemporaryDir folder;
    beginWithASmallOne();
    openExport();
    QCOMPARE(exporter().chosen().size(), 4);
    enterFolder(folder.filePath("farm"));
    picture("farm_export");
    click("export.write");
    QTRY_VERIFY_WITH_TIMEOUT(exporter().state() == ExportModel::State::Done, kPatienceMs);
    // The small one is told, the others are there: a folder each, one set of task data with the three.
    QCOMPARE(exporter().failures().size(), 1);
    QVERIFY2(exporter().failures().front().startsWith("Corner: "), qPrintable(exporter().failures().front()));
    QVERIFY2(exporter().failures().front().contains("field. Choose"),
             qPrintable(exporter().failures().front()));
    QVERIFY2(exporter().message().startsWith("3 fields written"), qPrintable(exporter().message()));
    QCOMPARE(exporter().problems(), QStringList{});
    QVERIFY(exporter().checks() > 5);
    for (const char* name : {"Field 1", "Field 2", "Field 3"}) {
        QVERIFY(QFile::exists(folder.filePath("farm/%1/plan.geojson").arg(QLatin1String{name})));
        QVERIFY(QFile::exists(folder.filePath("farm/%1/path.csv").arg(QLatin1String{name})));
        QVERIFY(QFile::exists(folder.filePath("farm/%1/summary.json").arg(QLatin1String{name})));
    }
    const auto read = readFields(folder.filePath("farm/TASKDATA").toStdU16String());
    QVERIFY(read.has_value());
    QCOMPARE(read->fields.size(), std::size_t{3});
    // What was planned on the way is planned.
    QCOMPARE(list().stateOf(1), FarmList::Drivable);
    QCOMPARE(list().stateOf(2), FarmList::Drivable);
    QTRY_VERIFY(item("export.failures")->isVisible());
    waitForRest(*item("export.write"));
    // It is seen without scrolling.
    const QQuickItem& told = *item("export.failures");
    QTRY_VERIFY(told.mapToScene({0.0, told.height()}).y() <=
                item("export.write")->mapToScene({0.0, 0.0}).y());
    picture("farm_export_done");
    key(Qt::Key_Escape);
    QTRY_VERIFY(item("export.write") == nullptr || !item("export.write")->isVisible());
    // The plan of the window is exported alone again.
    key(Qt::Key_Escape);
    key(Qt::Key_E, Qt::ControlModifier);
    QTRY_VERIFY(item("export.heading") != nullptr && item("export.heading")->isVisible());
    QVERIFY(!exporter().isSeveral());
    QVERIFY(item("export.heading")->property("text").toString().startsWith("Field 1"));
}

void TestFarmWindow::exportStopped() {
    const QTemporaryDir folder;
    openExport();
    QCOMPARE(exporter().chosen().size(), 30);
    enterFolder(folder.path());
    window_->resize(1000, 640);
    click("export.write");
    QTRY_VERIFY_WITH_TIMEOUT(QDir{folder.path()}.entryList(QDir::Dirs | QDir::NoDotAndDotDot).size() >= 2,
                             kPatienceMs);
    QCOMPARE(exporter().state(), ExportModel::State::Writing);
    QVERIFY(item("export.progress")->isVisible());
    picture("farm_export_writing");
    // Esc does not close what is being written; the button stops it.
    key(Qt::Key_Escape);
    QVERIFY(item("export.write")->isVisible());
    click("export.close");
    QTRY_COMPARE(exporter().state(), ExportModel::State::Failed);
    QVERIFY(!exporter().remedy().isEmpty());
    // Not one file of task data with some of the fields.
    QVERIFY(!QFile::exists(folder.filePath("TASKDATA")));
    waitForRest(*item("export.write"));
    picture("farm_export_stopped");
}

void TestFarmWindow::exportedToAStick() {
    const QTemporaryDir folder;
    const QString path = folder.path();
    StickExport& stick = *exporter().stick();
    stick.setLister([path]() -> std::vector<StickExport::Stick> {
        return {{path, QStringLiteral("FIELDS"), QStringLiteral("%1 · FAT32").arg(path)}};
    });
    stick.setTerminal(static_cast<int>(stick.terminalNames().indexOf("Another ISOBUS terminal")));
    beginWithASmallOne();
    openExport();
    click("export.onStick");
    QTRY_VERIFY(item("stick.row.0") != nullptr && item("stick.row.0")->isVisible());
    QTRY_VERIFY(item("export.write")->isEnabled());
    click("export.write");
    QTRY_VERIFY_WITH_TIMEOUT(stick.state() == StickExport::State::Done, kPatienceMs);
    QCOMPARE(stick.failures().size(), 1);
    QVERIFY(stick.message().startsWith("Safe to unplug"));
    QVERIFY2(stick.message().contains("these"), qPrintable(stick.message()));
    // The field that is not on the stick is not among them.
    QCOMPARE(stick.writtenPlan(), QStringLiteral("Field 1, Field 2, Field 3"));
    QCOMPARE(readFields(folder.filePath("TASKDATA").toStdU16String())->fields.size(), std::size_t{3});
    waitForRest(*item("export.write"));
    picture("farm_export_stick");
    // Once more: what is there is seen before the fields are planned again.
    click("export.close");
    click("farm.export");
    click("export.onStick");
    QTRY_VERIFY(item("stick.conflict") != nullptr && item("stick.conflict")->isVisible());
    QVERIFY(!item("export.write")->isEnabled());
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
    for (const char* name : {"farm.plan", "farm.alike", "farm.addPlans", "farm.print", "farm.export"}) {
        const QQuickItem* const button = item(QLatin1String{name});
        QVERIFY(button->mapToScene({button->width(), button->height()}).x() <= item("farmPanel")->width());
        QVERIFY(button->mapToScene({0.0, button->height()}).y() <= window_->height());
    }
    picture("farm_small");
}

FURROW_TEST_WITH(TestFarmWindow, QGuiApplication);
#include "tst_farm_window.moc"
