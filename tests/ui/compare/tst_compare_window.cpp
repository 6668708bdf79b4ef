// Two plans of a field in the window: a variant is kept, the other plan is planned beside it, drawn over it
// while a key is held, and taken.

#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/swaths/methods.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

using namespace furrow;

class TestCompareWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void withTheStandardSettings();
    void withAVariant();
    void aPlanThatCannotBeMade();

private:
    PlanComparison& comparison() { return *session_->comparison(); }
    void waitForPlan() { QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs); }
    void waitForOther() { QTRY_VERIFY_WITH_TIMEOUT(comparison().isReady(), kPatienceMs); }
    void setOverlap(double overlap) {
        const Project& project = *session_->document()->project();
        Settings settings = project.plan().settings;
        settings.set(kOverlap, overlap).value();
        session_->document()->change([] { return QString{}; },
                                     withPlan(project, project.plan().machine, settings));
        waitForPlan();
    }
    QVariantMap figure(const QString& label) {
        for (const QVariant& row : comparison().figures()) {
            if (row.toMap().value("label").toString() == label) {
                return row.toMap();
            }
        }
        return {};
    }
};

void TestCompareWindow::init() {
    begin({1440, 900});
    openSample("Home Field");
}

void TestCompareWindow::cleanup() {
    end();
}

void TestCompareWindow::withTheStandardSettings() {
    click("compareButton");
    QTRY_VERIFY(item("comparePanel")->isVisible());
    waitForOther();
    // There is one plan with the standard settings: nothing differs.
    QVERIFY(comparison().settings().isEmpty());
    QCOMPARE(figure("Time").value("better").toInt(), 0);
    QVERIFY(comparison().difference()->onlyInSecond.empty());
    // Half a metre of overlap: more swaths, more time, and the standard is better.
    setOverlap(0.5);
    QTRY_VERIFY(comparison().isReady() && comparison().settings().size() == 1);
    QCOMPARE(figure("Time").value("better").toInt(), 1);
    QVERIFY(figure("Time").value("difference").toString().startsWith(QChar(0x2212)));
    QVERIFY(!comparison().difference()->onlyInSecond.empty());
    picture("compare_standard");
    // One step, and it is undone as one.
    click("compare.take");
    waitForPlan();
    QCOMPARE(session_->planning()->settings(), Settings{});
    key(Qt::Key_Z, Qt::ControlModifier);
    waitForPlan();
    QCOMPARE(session_->planning()->settings().value(kOverlap), SettingValue{0.5});
    key(Qt::Key_Escape);
    QTRY_VERIFY(!item("comparePanel")->isVisible());
}

void TestCompareWindow::withAVariant() {
    key(Qt::Key_D, Qt::ControlModifier);
    QTRY_VERIFY(item("comparePanel")->isVisible());
    click("compare.variant");
    QTRY_VERIFY(item("nameDialog.name") != nullptr && item("nameDialog.name")->isVisible());
    type("Overlap");
    key(Qt::Key_Return);
    QTRY_COMPARE(session_->farm()->plans().size(), 2);
    QTRY_COMPARE(session_->farm()->currentPlan(), 1);
    setOverlap(0.5);
    waitForOther();
    QCOMPARE(comparison().choices().size(), 2);
    QCOMPARE(comparison().chosen(), 0);
    QTRY_VERIFY(comparison().isReady() && comparison().settings().size() == 1);
    // Held, the other plan is on the map.
    const QQuickItem* const page = item("mapPage");
    map()->forceActiveFocus();
    QTest::keyPress(window_, Qt::Key_X);
    QTRY_VERIFY(page->property("showOther").toBool());
    picture("compare_other");
    QTest::keyRelease(window_, Qt::Key_X);
    QTRY_VERIFY(!page->property("showOther").toBool());
    const QPoint button = middleOf(*item("compare.hold"));
    QTest::mousePress(window_, Qt::LeftButton, {}, button);
    QTRY_VERIFY(page->property("showOther").toBool());
    QTest::mouseRelease(window_, Qt::LeftButton, {}, button);
    QTRY_VERIFY(!page->property("showOther").toBool());
    picture("compare_variant");
    // A comment is written in the results: they come back.
    key(Qt::Key_M, Qt::ControlModifier);
    QTRY_VERIFY(item("resultsPanel")->isVisible() && !item("comparePanel")->isVisible());
    key(Qt::Key_Escape);
    key(Qt::Key_D, Qt::ControlModifier);
    waitForOther();
    click("compare.take");
    QTRY_COMPARE(session_->farm()->currentPlan(), 0);
    waitForPlan();
    waitForOther();
    QCOMPARE(figure("Time").value("better").toInt(), -1);
    QVERIFY(!session_->document()->undoText().contains("standard"));
    window_->resize(1000, 640);
    QTRY_COMPARE(map()->width(), 1000.0 - 348.0 - 340.0);
    picture("compare_small");
}

void TestCompareWindow::aPlanThatCannotBeMade() {
    // A variant without room inside its headland.
    session_->farm()->addPlan("Wide");
    const Project& project = *session_->document()->project();
    Settings settings = project.plan().settings;
    QVERIFY(applySetting(settings, "headland.method", "constant").has_value());
    QVERIFY(applySetting(settings, "headland.width_m", "400").has_value());
    session_->document()->change([] { return QString{}; },
                                 withPlan(project, project.plan().machine, settings));
    session_->farm()->setCurrentPlan(0);
    waitForPlan();
    key(Qt::Key_D, Qt::ControlModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!comparison().isBusy(), kPatienceMs);
    QVERIFY(comparison().isReady() || !comparison().trouble().isEmpty());
    picture("compare_trouble");
}

FURROW_TEST_WITH(TestCompareWindow, QGuiApplication);
#include "tst_compare_window.moc"
