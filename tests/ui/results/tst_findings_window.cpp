// Many findings of one kind in the window: a row with a count, gone through with keys and mouse.

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

#include <QTemporaryDir>

using namespace furrow;

class TestFindingsWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void oneKindIsGoneThrough();
    void anAppliedChangeIsTold_data();
    void anAppliedChangeIsTold();

private:
    QString place(int finding) const {
        const QQuickItem* text = item(QStringLiteral("finding.%1.place").arg(finding));
        return text != nullptr && text->isVisible() ? text->property("text").toString() : QString{};
    }
};

void TestFindingsWindow::oneKindIsGoneThrough() {
    openSample("Home Field");
    // As a plan with many findings has them: one that blocks, six that are missed, one of another kind.
    const auto finding = [](FindingKind kind, Severity severity, const char* text) {
        return Finding{.severity = severity,
                       .kind = kind,
                       .place = {},
                       .text = text,
                       .suggestion = "Make the headland wider.",
                       .change = {},
                       .setting = {}};
    };
    std::vector<Finding> findings{
        finding(FindingKind::Outside, Severity::Blocking, "The machine leaves the field.")};
    for (const char* text : {"Missed 1", "Missed 2", "Missed 3", "Missed 4", "Missed 5", "Missed 6"}) {
        findings.push_back(finding(FindingKind::Missed, Severity::Blocking, text));
    }
    findings.push_back(finding(FindingKind::Gate, Severity::Note, "There is no gate."));
    const QGeoCoordinate first = camera()->center();
    std::vector<QGeoCoordinate> places;
    places.reserve(findings.size());
    for (std::size_t i = 0; i < findings.size(); ++i) {
        places.emplace_back(first.latitude() + 1e-4 * static_cast<double>(i), first.longitude());
    }
    session_->findings()->show(findings, places);
    QCOMPARE(session_->findings()->rowCount(), 3);
    QTRY_VERIFY(item("finding.1") != nullptr && item("finding.1")->isVisible());
    QCOMPARE(place(1), QStringLiteral("1 of 6 of this kind"));
    // With the arrows of the row.
    click("finding.1.next");
    QTRY_COMPARE(place(2), QStringLiteral("2 of 6 of this kind"));
    QCOMPARE(editor()->selectedFinding(), 2);
    picture("findings_of_a_kind");
    // By key, around the end and back.
    map()->forceActiveFocus();
    key(Qt::Key_F8, Qt::ControlModifier);
    QTRY_COMPARE(place(3), QStringLiteral("3 of 6 of this kind"));
    for (int i = 0; i < 4; ++i) {
        key(Qt::Key_F8, Qt::ControlModifier);
    }
    QTRY_COMPARE(place(1), QStringLiteral("1 of 6 of this kind"));
    key(Qt::Key_F8, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(place(6), QStringLiteral("6 of 6 of this kind"));
    // Without Ctrl to the next of all.
    key(Qt::Key_F8);
    QTRY_COMPARE(editor()->selectedFinding(), 7);
    QVERIFY(place(7).isEmpty());
    // Left and right in the row.
    item("finding.6")->forceActiveFocus();
    key(Qt::Key_Right);
    QTRY_COMPARE(place(1), QStringLiteral("1 of 6 of this kind"));
    key(Qt::Key_Left);
    QTRY_COMPARE(place(6), QStringLiteral("6 of 6 of this kind"));
}

void TestFindingsWindow::anAppliedChangeIsTold_data() {
    QTest::addColumn<int>("theme");
    QTest::addColumn<QSize>("size");
    QTest::newRow("light") << 1 << QSize{1440, 900};
    QTest::newRow("dark") << 2 << QSize{1280, 720};
}

// One pass of headland leaves the cultivator no room to turn; the finding offers to undo it.
void TestFindingsWindow::anAppliedChangeIsTold() {
    QFETCH(int, theme);
    QFETCH(QSize, size);
    QObject* const colours = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
    QVERIFY(colours != nullptr);
    colours->setProperty("forced", theme);
    const auto plain = qScopeGuard([colours] { colours->setProperty("forced", 0); });
    window_->resize(size);
    QTRY_COMPARE(window_->height(), size.height());
    openSample("Home Field");
    const Project& project = *session_->document()->project();
    Settings settings = project.plan().settings;
    settings.set(**findParameter("headland.passes"), 1.0).value();
    session_->document()->change([] { return QString{}; },
                                 withPlan(project, findMachine("cultivator").value(), settings));
    QTRY_VERIFY_WITH_TIMEOUT(session_->findings()->blocking() > 0, kPatienceMs);
    QTRY_VERIFY(item("finding.0.apply") != nullptr && item("finding.0.apply")->isVisible());
    bringIntoView("finding.0.apply");
    click("finding.0.apply");
    QTRY_VERIFY_WITH_TIMEOUT(!session_->findings()->outcome().isEmpty(), kPatienceMs);
    QCOMPARE(session_->findings()->blocking(), 0);
    const QQuickItem* told = item("findings.outcome");
    QVERIFY(told != nullptr && told->isVisible());
    QVERIFY2(
        told->property("text").toString().startsWith(QStringLiteral("Headland: Passes → auto. Before: ")),
        qPrintable(told->property("text").toString()));
    picture(QStringLiteral("findings_applied_%1").arg(QLatin1String{QTest::currentDataTag()}));
    click("findings.outcome.close");
    QTRY_VERIFY(!told->isVisible());
}

FURROW_TEST_WITH(TestFindingsWindow, QGuiApplication);
#include "tst_findings_window.moc"
