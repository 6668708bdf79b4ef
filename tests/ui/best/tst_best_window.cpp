#include "planner/plan/method_registry.h"
#include "planner/plan/quicker_choice.h"
#include "planner/project/project_edits.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

using namespace furrow;

// A search plans some hundred times.
constexpr int kSearchMs = 3 * kPatienceMs;

/// The search for the best plan in the whole window, with real mouse and keys.
class TestBestWindow : public test::WindowTest {
    Q_OBJECT

private:
    bool shown(const char* name) const { return item(name) != nullptr && item(name)->isVisible(); }
    BestSearch& search() const { return *session_->bestSearch(); }
    const Settings& settings() const { return session_->document()->project()->plan().settings; }
    const Plan& plan() const { return *session_->shown()->plan(); }
    void openField() {
        click("empty.sample.0");
        QTRY_VERIFY_WITH_TIMEOUT(session_->planning()->state() == PlanState::Ready, kPatienceMs);
    }

private slots:
    void theBestPlanIsTakenAsOneChange() {
        openField();
        const double before = timeForAll(plan().request.machine, plan().path, plan().audit).si();
        click("steps.bestPlan");
        QTRY_VERIFY(shown("best.start"));
        waitForRest(*item("best.start"));
        picture(QStringLiteral("best-choices"));
        QTRY_VERIFY(item("best.start")->hasActiveFocus());
        QTest::keyClick(window_, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(search().state(), BestSearch::State::Done, kSearchMs);
        QVERIFY(search().table()->rowCount() > 0);
        for (int row = 0; row < search().table()->rowCount(); ++row) {
            const QModelIndex index = search().table()->index(row);
            const bool isSame = index.data(ChoiceTableModel::WorthRole) == QStringLiteral("the same time");
            QVERIFY(!isSame || index.data(ChoiceTableModel::ShareRole).toDouble() == 0.0);
        }
        QVERIFY(search().alternatives() > 10);
        QVERIFY(search().isBetter());
        QTRY_VERIFY(shown("best.take"));
        waitForRest(*item("best.take"));
        picture(QStringLiteral("best-table"));
        // Nothing has changed until it is taken.
        QCOMPARE(settings(), Settings{});
        QTRY_VERIFY(item("best.take")->hasActiveFocus());
        QTest::keyClick(window_, Qt::Key_Return);
        QTRY_VERIFY(!shown("best.take"));
        QVERIFY(!(settings() == Settings{}));
        QTRY_VERIFY_WITH_TIMEOUT(session_->planning()->state() == PlanState::Ready, kPatienceMs);
        const double after = timeForAll(plan().request.machine, plan().path, plan().audit).si();
        QVERIFY2(after < 0.999 * before, qPrintable(QStringLiteral("%1 %2").arg(before).arg(after)));
        QTest::keyClick(window_, Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(settings(), Settings{});
    }

    // Pictures to look at: every state, in a small window and dark.
    void fitsASmallWindow() {
        constexpr QSize kSmall{1000, 640};
        window_->resize(kSmall);
        QTRY_COMPARE(window_->width(), kSmall.width());
        QObject* const colours = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
        colours->setProperty("forced", 2);
        openField();
        QTest::keyClick(window_, Qt::Key_B, Qt::ControlModifier);
        QTRY_VERIFY(shown("best.start"));
        waitForRest(*item("best.start"));
        picture(QStringLiteral("best-choices-dark"));
        click("best.start");
        QTRY_VERIFY_WITH_TIMEOUT(search().isBetter(), kPatienceMs);
        picture(QStringLiteral("best-search-dark"));
        QTRY_COMPARE_WITH_TIMEOUT(search().state(), BestSearch::State::Done, kSearchMs);
        QTRY_VERIFY(item("best.take")->hasActiveFocus());
        waitForRest(*item("best.take"));
        // What has the keys is in view, however long the table is.
        QVERIFY(QRect(QPoint{}, kSmall).contains(middleOf(*item("best.take"))));
        picture(QStringLiteral("best-table-dark"));
        colours->setProperty("forced", 0);
    }

    void whatIsUntickedOrSetByHandStays() {
        openField();
        Settings given;
        given.set(**findParameter("headland.passes"), 5.0).value();
        session_->document()->change([] { return QString{}; },
                                     withPlan(*session_->document()->project(),
                                              session_->document()->project()->plan().machine, given));
        QTRY_VERIFY_WITH_TIMEOUT(session_->planning()->state() == PlanState::Ready, kPatienceMs);
        QTest::keyClick(window_, Qt::Key_B, Qt::ControlModifier);
        QTRY_VERIFY(shown("best.start"));
        // The headland was set: it is not ticked. The others are; the heading is taken out.
        QVERIFY(!item("best.choice.0")->property("checked").toBool());
        for (int i = 1; i < 8; ++i) {
            QVERIFY(item(QStringLiteral("best.choice.%1").arg(i))->property("checked").toBool());
        }
        click("best.choice.1");
        click("best.start");
        QTRY_COMPARE_WITH_TIMEOUT(search().state(), BestSearch::State::Done, kSearchMs);
        for (int row = 0; row < search().table()->rowCount(); ++row) {
            const QString choice = search().table()->index(row).data(ChoiceTableModel::ChoiceRole).toString();
            QVERIFY2(choice != QStringLiteral("Headland") && choice != QStringLiteral("Heading"),
                     qPrintable(choice));
        }
        QTest::keyClick(window_, Qt::Key_Escape);
        QTRY_VERIFY(!shown("best.close"));
        QCOMPARE(settings(), given);
    }

    void aSearchIsStoppedAndKeptOrForgotten() {
        openField();
        QTest::keyClick(window_, Qt::Key_B, Qt::ControlModifier);
        click("best.start");
        QTRY_COMPARE(search().state(), BestSearch::State::Searching);
        QTest::keyClick(window_, Qt::Key_Escape);
        QTRY_COMPARE(search().state(), BestSearch::State::Idle);
        QTRY_VERIFY(!shown("best.close"));
        QCOMPARE(settings(), Settings{});

        QTest::keyClick(window_, Qt::Key_B, Qt::ControlModifier);
        click("best.start");
        QTRY_VERIFY_WITH_TIMEOUT(search().isBetter(), kPatienceMs);
        QVERIFY(!search().course().isEmpty());
        // As the button does; the search may have ended by now, which keeps the plan as well.
        search().take();
        QCOMPARE(search().state(), BestSearch::State::Idle);
        QVERIFY(!(settings() == Settings{}));
    }
};

FURROW_TEST_WITH(TestBestWindow, QGuiApplication);
#include "tst_best_window.moc"
