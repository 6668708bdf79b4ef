// Why a plan came out as it did, in the window: sentences in the steps, the chart of headings, the last
// change, and findings that are stepped through and mended.

#include "planner/path/blocking.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/swaths/methods.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"
#include "ui/text/display.h"

#include <QSignalSpy>

using namespace furrow;

class TestReasonsWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void stepsSayWhy();
    void headingIsTakenByAClick();
    void headingIsTakenByKeys();
    void tradeOffsAreShown();
    void lastChangeIsTold();
    void findingIsMended();
    void findingsAreSteppedThrough();

private:
    HeadingChoice& headings() { return *session_->planning()->reasons()->headings(); }
    const Settings& settings() { return session_->planning()->settings(); }
    void openSwaths();
    void waitForPlan();
    QPoint placeOf(int point);
};

void TestReasonsWindow::init() {
    begin({1440, 900});
    openSample("Home Field");
}

void TestReasonsWindow::cleanup() {
    end();
}

void TestReasonsWindow::waitForPlan() {
    QTRY_VERIFY_WITH_TIMEOUT(isFinished(session_->planning()->state()), kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(session_->planning()->reasons()->plan() == session_->shown()->plan(),
                             kPatienceMs);
}

void TestReasonsWindow::openSwaths() {
    waitForPlan();
    click("step.swaths");
    bringIntoView("headings.chart");
}

QPoint TestReasonsWindow::placeOf(int point) {
    // The chart keeps 12 and 26 pixels round its points.
    const QQuickItem& chart = *item("headings.chart");
    const QPointF at = headings().points()[point];
    return chart
        .mapToScene({12.0 + at.x() * (chart.width() - 24.0), 26.0 + (1.0 - at.y()) * (chart.height() - 52.0)})
        .toPoint();
}

void TestReasonsWindow::stepsSayWhy() {
    waitForPlan();
    for (const char* const step : {"headland", "swaths", "decomposition", "route", "path"}) {
        click(QStringLiteral("step.%1").arg(QLatin1String{step}));
        const QString name = QStringLiteral("reason.%1").arg(QLatin1String{step});
        QTRY_VERIFY2(item(name) != nullptr && item(name)->isVisible(), step);
        QVERIFY2(!item(name)->property("text").toString().isEmpty(), step);
        bringIntoView(name);
        picture(QStringLiteral("reason_%1").arg(QLatin1String{step}));
    }
    click("step.headland");
    QTRY_VERIFY(item("reason.headland") != nullptr);
    const QString metric = item("reason.headland")->property("text").toString();
    furrow::Display::instance().setUnits(furrow::Display::Imperial);
    QTRY_VERIFY(item("reason.headland")->property("text").toString() != metric);
    QVERIFY(item("reason.headland")->property("text").toString().contains("ft"));
    furrow::Display::instance().setUnits(furrow::Display::Metric);
    // What is said of another method does not stand beside the one that is chosen.
    QCOMPARE(item("reason.headland")->opacity(), 1.0);
    session_->planning()->set("headland.method", "none");
    QCOMPARE(item("reason.headland")->opacity(), 0.0);
    waitForPlan();
    QTRY_COMPARE(item("reason.headland")->opacity(), 1.0);
    QVERIFY(item("reason.headland")->property("text").toString().startsWith("There is no headland"));
}

void TestReasonsWindow::headingIsTakenByAClick() {
    openSwaths();
    picture("headings_chart");
    QVERIFY(!headings().isByHand());
    const int other = (headings().chosen() + 60) % static_cast<int>(headings().points().size());
    const QString bearing = headings().bearingOf(other);
    QTest::mouseMove(window_, placeOf(other));
    QTRY_VERIFY(item("headings.description")->property("text").toString().startsWith(bearing));
    QTest::mouseClick(window_, Qt::LeftButton, {}, placeOf(other));
    QTRY_VERIFY(headings().isByHand());
    waitForPlan();
    QCOMPARE(headings().bearingOf(headings().chosen()), bearing);
    QVERIFY(item("reason.swaths")->property("text").toString().contains("more than the longest edge"));
    picture("headings_by_hand");
    click("headings.search");
    QTRY_VERIFY(!headings().isByHand());
    QVERIFY(!settings().isSet(kAngle));
    // Two changes, two steps back.
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(headings().isByHand());
    key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(!headings().isByHand());
    waitForPlan();
}

void TestReasonsWindow::headingIsTakenByKeys() {
    // The pointer would show another one.
    QTest::mouseMove(window_, middleOf(*map()));
    openSwaths();
    const int chosen = headings().chosen();
    item("headings.chart")->forceActiveFocus(Qt::TabFocusReason);
    key(Qt::Key_Right);
    key(Qt::Key_Right);
    key(Qt::Key_Left);
    const int next = (chosen + 1) % static_cast<int>(headings().points().size());
    const QString bearing = headings().describe(next);
    QCOMPARE(item("headings.description")->property("text").toString(), bearing);
    key(Qt::Key_Return);
    QTRY_VERIFY(headings().isByHand());
    waitForPlan();
}

void TestReasonsWindow::tradeOffsAreShown() {
    openSwaths();
    for (const char* const across : {"overlap", "missed", "turning"}) {
        click(QStringLiteral("headings.across.%1").arg(QLatin1String{across}));
        QVERIFY(!headings().tradeOffs().isEmpty());
        for (const QPointF& point : headings().points()) {
            QVERIFY(point.x() >= 0.0 && point.x() <= 1.0 && point.y() >= 0.0 && point.y() <= 1.0);
        }
        picture(QStringLiteral("headings_%1").arg(QLatin1String{across}));
    }
    // The quickest heading of all lies at the bottom of the chart, and is a trade-off.
    const QList<int> best = headings().tradeOffs();
    QVERIFY(std::ranges::any_of(best, [&](int point) { return headings().points()[point].y() < 1e-6; }));
}

void TestReasonsWindow::lastChangeIsTold() {
    waitForPlan();
    QVERIFY(session_->lastChange()->text().isEmpty());
    Settings changed = settings();
    changed.set(kOverlap, 1.0).value();
    const Project& project = *session_->document()->project();
    const Duration before = session_->shown()->plan()->path.duration();
    session_->document()->change([] { return QString{}; },
                                 withPlan(project, project.plan().machine, changed));
    waitForPlan();
    QVERIFY(session_->shown()->plan()->path.duration() > before);
    const QString told = session_->lastChange()->text();
    QVERIFY2(told.startsWith("With the last change: time +"), qPrintable(told));
    QVERIFY2(told.contains("worked twice +"), qPrintable(told));
    picture("last_change");
    key(Qt::Key_Z, Qt::ControlModifier);
    waitForPlan();
    QTRY_VERIFY(
        session_->lastChange()->text().startsWith(QStringLiteral("With the last change: time \u2212")));
    // Another field is compared with nothing.
    session_->farm()->addPlan("Other");
    waitForPlan();
}

void TestReasonsWindow::findingIsMended() {
    waitForPlan();
    // One pass leaves no room to turn: the plan is blocked, and advice says what mends it.
    Settings changed = settings();
    changed.set(**findParameter("headland.passes"), 1.0).value();
    changed.set(*stageMethod("path"), std::string{"omega"}).value();
    const Project& project = *session_->document()->project();
    session_->document()->change([] { return QString{}; },
                                 withPlan(project, project.plan().machine, changed));
    waitForPlan();
    const auto& findings = session_->shown()->plan()->findings;
    const auto mendable = std::ranges::find_if(
        findings, [](const Finding& finding) { return isBlocking(finding) && finding.change.has_value(); });
    if (mendable == findings.end()) {
        QSKIP("no finding with a change that corrects it");
    }
    const auto row = static_cast<int>(mendable - findings.begin());
    const QString button = QStringLiteral("finding.%1.apply").arg(row);
    picture("finding_to_apply");
    click(button);
    QTRY_VERIFY_WITH_TIMEOUT(!session_->findings()->outcome().isEmpty(), kPatienceMs);
    waitForPlan();
    QTRY_VERIFY(session_->shown()->plan()->drivable());
    QVERIFY2(session_->findings()->outcome().endsWith("Now: no problems."),
             qPrintable(session_->findings()->outcome()));
    picture("finding_applied");
    click("findings.outcome.close");
    QVERIFY(session_->findings()->outcome().isEmpty());
    key(Qt::Key_Z, Qt::ControlModifier);
    waitForPlan();
    QVERIFY(!session_->shown()->plan()->drivable());
}

void TestReasonsWindow::findingsAreSteppedThrough() {
    waitForPlan();
    const int count = session_->findings()->count();
    QVERIFY(count > 0);
    for (int i = 0; i < count; ++i) {
        key(Qt::Key_F8);
        QCOMPARE(window_->property("currentFinding").toInt(), i);
    }
    key(Qt::Key_F8);
    QCOMPARE(window_->property("currentFinding").toInt(), 0);
    key(Qt::Key_F8, Qt::ShiftModifier);
    QCOMPARE(window_->property("currentFinding").toInt(), count - 1);
}

FURROW_TEST_WITH(TestReasonsWindow, QGuiApplication);
#include "tst_reasons_window.moc"
