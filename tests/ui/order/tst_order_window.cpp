#include "planner/plan/method_registry.h"
#include "planner/route/methods.h"
#include "planner/route/order_edits.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"

using namespace furrow;

/// The order of swaths, changed by hand in the whole window, with real mouse and keys.
class TestOrderWindow : public test::WindowTest {
    Q_OBJECT

private:
    bool shown(const char* name) const { return item(name) != nullptr && item(name)->isVisible(); }
    SwathOrder& order() const { return *session_->planning()->order(); }
    const Settings& settings() const { return session_->document()->project()->plan().settings; }
    const Plan& plan() const { return *session_->shown()->plan(); }
    void waitForPlan() {
        QTRY_VERIFY_WITH_TIMEOUT(session_->planning()->state() == PlanState::Ready ||
                                     session_->planning()->state() == PlanState::Problems,
                                 kPatienceMs);
    }
    std::vector<std::size_t> swathsInOrder() const {
        std::vector<std::size_t> swaths;
        for (const RouteStep& step : plan().route.steps) {
            swaths.push_back(step.swath);
        }
        return swaths;
    }
    /// A field with the list of its swaths open.
    void openList() {
        openSample(QStringLiteral("Home Field"));
        waitForPlan();
        item("stepsPanel")->setProperty("openStep", QStringLiteral("route"));
        QTRY_VERIFY(item("order.begin") != nullptr);
        click("order.begin");
        QTRY_VERIFY(shown("order.row.3"));
        waitForRest(*item("order.row.3"));
    }
    QPoint middleOfSwath(std::size_t swath) const {
        const Swath& at = plan().swaths.swaths[swath];
        const GeoPoint place = plan().field().frame().toGeo(0.5 * (at.start + at.end));
        return onMap({place.latDeg, place.lonDeg});
    }

private slots:
    void aRowIsDraggedToItsPlace() {
        openList();
        const std::vector<std::size_t> before = swathsInOrder();
        QCOMPARE(order().rowCount(), static_cast<int>(before.size()));
        picture(QStringLiteral("order-list"));
        drag(middleOf(*item("order.handle.0")), middleOf(*item("order.handle.3")));
        waitForPlan();
        std::vector<std::size_t> wanted = before;
        std::rotate(wanted.begin(), wanted.begin() + 1, wanted.begin() + 4);
        QTRY_COMPARE(swathsInOrder(), wanted);
        QCOMPARE(settings().choice(*stageMethod("route")), std::string{"custom"});
        QCOMPARE(order().current(), 3);
        picture(QStringLiteral("order-dragged"));
        QObject* const colours = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
        for (const auto& [theme, name] : {std::pair{2, "order-dark"}, std::pair{3, "order-sunlight"}}) {
            colours->setProperty("forced", theme);
            picture(QString::fromLatin1(name));
        }
        colours->setProperty("forced", 0);
        // Back in one step.
        QTest::keyClick(window_, Qt::Key_Z, Qt::ControlModifier);
        QTRY_COMPARE(settings(), Settings{});
        QTRY_COMPARE(swathsInOrder(), before);
    }

    void keysMoveAndTurnARow() {
        openList();
        const std::vector<std::size_t> before = swathsInOrder();
        QTest::keyClick(window_, Qt::Key_Down);
        QTest::keyClick(window_, Qt::Key_Down);
        QCOMPARE(order().current(), 1);
        QTest::keyClick(window_, Qt::Key_Up, Qt::AltModifier);
        waitForPlan();
        std::vector<std::size_t> wanted = before;
        std::swap(wanted[0], wanted[1]);
        QTRY_COMPARE(swathsInOrder(), wanted);
        const bool reversed = plan().route.steps[0].reversed;
        QTest::keyClick(window_, Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(session_->shown()->plan() && !session_->shown()->isDraft() &&
                                     plan().route.steps[0].reversed != reversed,
                                 kPatienceMs);
        QCOMPARE(swathsInOrder(), wanted);
        // The search takes over again.
        click("order.searchAll");
        QTRY_COMPARE(settings(), Settings{});
        QTRY_COMPARE(swathsInOrder(), before);
        click("order.done");
        QTRY_VERIFY(!shown("order.list"));
    }

    void swathsAreClickedOnTheMap() {
        openList();
        // Three swaths far apart: each comes after the one before.
        const std::vector<std::size_t> clicked{3, 20, 9};
        for (const std::size_t swath : clicked) {
            waitForPlan();
            clickAt(middleOfSwath(swath));
        }
        waitForPlan();
        QCOMPARE(order().pointedCount(), 3);
        const auto at = [&](std::size_t swath) {
            const auto steps = swathsInOrder();
            return std::ranges::find(steps, swath) - steps.begin();
        };
        QTRY_COMPARE(at(20), at(3) + 1);
        QTRY_COMPARE(at(9), at(20) + 1);
        picture(QStringLiteral("order-clicked"));
        // The order of the others is searched, and these stay together.
        click("order.searchOthers");
        QTRY_COMPARE(settings().choice(*stageMethod("route")), std::string{"optimised"});
        QCOMPARE(settings().numbers(kLocked).size(), std::size_t{3});
        waitForPlan();
        QTRY_COMPARE(std::abs(at(20) - at(3)), std::ptrdiff_t{1});
        QTRY_COMPARE(std::abs(at(9) - at(20)), std::ptrdiff_t{1});
        // Without the field there is nothing to search.
        QCOMPARE(order().pointedCount(), 3);
        session_->farm()->removeField();
        QTRY_COMPARE(order().rowCount(), 0);
        QCOMPARE(order().pointedCount(), 0);
    }
};

FURROW_TEST_WITH(TestOrderWindow, QGuiApplication);
#include "tst_order_window.moc"
