#include "planner/decomposition/history.h"
#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/editor_window_test.h"
#include "ui/map/cell_layer.h"
#include "ui/text/display.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <cmath>
#include <numbers>

using namespace furrow;
using namespace furrow::test;

/// The steps from the mainland as it was cut to the cells that are driven, gone through in the window.
class TestCellsWindow : public EditorWindowTest {
    Q_OBJECT

    CellSteps& cells() const { return *session_->planning()->cells(); }
    QString text(const char* name) const { return item(QLatin1String{name})->property("text").toString(); }
    const CellGeometry* drawn() const {
        return item(QStringLiteral("cellLayer"))->property("drawing").value<CellDrawing>().geometry().get();
    }

    /// 230 m wide, with nine ponds in slanting rows that cut it in 28.
    static QByteArray ponds() {
        const auto ring = [](std::initializer_list<std::pair<double, double>> corners) {
            constexpr double kDegrees = 1.0 / 111320.0;
            QJsonArray points;
            for (const auto& [x, y] : corners) {
                points << QJsonArray{22.5 + x * kDegrees / std::cos(58.25 * std::numbers::pi / 180.0),
                                     58.25 + y * kDegrees};
            }
            points << points.first();
            return points;
        };
        QJsonArray rings{ring({{0, 0}, {230, 0}, {230, 230}, {0, 230}})};
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) {
                const double x = 40.0 + 60.0 * column + 7.0 * row;
                const double y = 40.0 + 60.0 * row + 4.0 * column;
                rings << ring({{x, y}, {x, y + 14}, {x + 14, y + 14}, {x + 14, y}});
            }
        }
        return QJsonDocument{
            QJsonObject{
                {QStringLiteral("type"), QStringLiteral("Feature")},
                {QStringLiteral("properties"),
                 QJsonObject{{QStringLiteral("name"), QStringLiteral("Nine ponds")}}},
                {QStringLiteral("geometry"), QJsonObject{{QStringLiteral("type"), QStringLiteral("Polygon")},
                                                         {QStringLiteral("coordinates"), rings}}}}}
            .toJson();
    }
    void openPonds(const char* method) {
        const QTemporaryDir folder;
        QFile file{folder.filePath(QStringLiteral("ponds.geojson"))};
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(ponds()) > 0);
        file.close();
        session_->opener()->open(file.fileName());
        QTRY_VERIFY_WITH_TIMEOUT(session_->farm()->hasField(), kPatienceMs);
        Settings settings = session_->planning()->settings();
        QVERIFY(applySetting(settings, "headland.driven", "false") &&
                applySetting(settings, "decomposition.method", method));
        session_->document()->change(
            [] { return QStringLiteral("Settings"); },
            withPlan(*session_->document()->project(), session_->planning()->machine()->machine(), settings));
        ready();
    }
    /// The panel brings what has the focus into view.
    void clickStep() {
        item(QStringLiteral("step.decomposition"))->forceActiveFocus(Qt::TabFocusReason);
        waitForRest(*item(QStringLiteral("step.decomposition")));
        click(QStringLiteral("step.decomposition"));
    }
    void openStep() {
        clickStep();
        QTRY_VERIFY(shows(QStringLiteral("cells.summary")));
        waitForRest(*item(QStringLiteral("cells.show")));
    }

    const DecompositionHistory& history() const { return session_->shown()->plan()->cells.history; }
    int stepCount() const { return static_cast<int>(history().steps.size()); }
    QString cellsAfter(int step) const {
        return QStringLiteral("%1 blocks").arg(history().steps[static_cast<std::size_t>(step)].cells);
    }
    /// The first step that saves something: what has no swath goes to a neighbour before anything is joined.
    int firstJoin() const {
        const auto& all = history().steps;
        int first = 1;
        while (first < stepCount() &&
               !(all[static_cast<std::size_t>(first)].cost < all[static_cast<std::size_t>(first) - 1].cost)) {
            ++first;
        }
        return first;
    }
    static QString pictureName(const char* what) {
        return QStringLiteral("cells%1_%2").arg(QLatin1String{what}, QLatin1String{QTest::currentDataTag()});
    }

    void summaryIsTold() {
        const int count = stepCount();
        QVERIFY(count >= 3);
        openStep();
        QVERIFY(text("cells.summary").startsWith(QStringLiteral("Cut: ") + cellsAfter(0)));
        QVERIFY(text("cells.summary").contains(QStringLiteral("joined: ") + cellsAfter(count - 1)));
        QVERIFY(!item(QStringLiteral("cellLayer"))->isVisible());
        picture(pictureName("1_summary"));
    }
    /// As cut, then on to the first join.
    void goneThroughByMouse() {
        const int count = stepCount();
        const int first = firstJoin();
        click(QStringLiteral("cells.show"));
        QTRY_VERIFY(item(QStringLiteral("cellLayer"))->isVisible());
        QCOMPARE(
            text("cells.current"),
            QStringLiteral("Step 1 of %1: ").arg(count) +
                text("cells.summary").section(QStringLiteral(": "), 1).section(QStringLiteral(" →"), 0, 0));
        QCOMPARE(text("cells.join"), QStringLiteral("As cut."));
        QVERIFY(drawn() != nullptr && drawn()->joined.empty());
        picture(pictureName("2_cut"));
        QVERIFY(!item(QStringLiteral("cells.previous"))->isEnabled());
        QVERIFY(first + 1 < count);
        for (int step = 1; step <= first; ++step) {
            click(QStringLiteral("cells.next"));
            QCOMPARE(cells().current(), step);
        }
        QVERIFY(text("cells.current").contains(cellsAfter(first)));
        QVERIFY(
            text("cells.join").startsWith(QStringLiteral("The two marked blocks become one: that saves ")));
        QVERIFY(!drawn()->joined.empty());
        picture(pictureName("3_joined"));
    }
    /// The slider, the buttons, and Escape.
    void goneThroughByKeys() {
        const int count = stepCount();
        const int first = firstJoin();
        item(QStringLiteral("cells.slider"))->forceActiveFocus(Qt::TabFocusReason);
        key(Qt::Key_Right);
        QCOMPARE(cells().current(), first + 1);
        for (int step = cells().current(); step + 1 < count; ++step) {
            key(Qt::Key_Right);
        }
        QCOMPARE(cells().current(), count - 1);
        QVERIFY(text("cells.current").contains(cellsAfter(count - 1)));
        QVERIFY(!item(QStringLiteral("cells.next"))->isEnabled());
        picture(pictureName("4_last"));
        key(Qt::Key_Backtab);
        QVERIFY(item(QStringLiteral("cells.previous"))->hasActiveFocus());
        key(Qt::Key_Space);
        QCOMPARE(cells().current(), count - 2);
        key(Qt::Key_Escape);
        QCOMPARE(cells().current(), -1);
        QTRY_VERIFY(!item(QStringLiteral("cellLayer"))->isVisible());
        QVERIFY(item(QStringLiteral("cells.show"))->hasActiveFocus());
    }
    /// The keyboard begins again; another plan, and closing the step, show the plan.
    void left() {
        key(Qt::Key_Space);
        QCOMPARE(cells().current(), 0);
        session_->planning()->planAgain();
        QTRY_COMPARE_WITH_TIMEOUT(cells().current(), -1, kPatienceMs);
        ready();
        click(QStringLiteral("cells.show"));
        QCOMPARE(cells().current(), 0);
        click(QStringLiteral("cells.done"));
        QCOMPARE(cells().current(), -1);
        click(QStringLiteral("cells.show"));
        clickStep();
        QTRY_COMPARE(cells().current(), -1);
    }

private slots:
    void theStepsAreGoneThrough_data() {
        QTest::addColumn<int>("colours");
        QTest::newRow("light") << 1;
        QTest::newRow("dark") << 2;
    }
    void theStepsAreGoneThrough() {
        QFETCH(int, colours);
        furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric);
        engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme")->setProperty("forced", colours);
        openPonds("merged");
        summaryIsTold();
        if (QTest::currentTestFailed()) {
            return;
        }
        goneThroughByMouse();
        if (QTest::currentTestFailed()) {
            return;
        }
        goneThroughByKeys();
        if (QTest::currentTestFailed()) {
            return;
        }
        left();
    }

    // Cells that are not joined can be looked at all the same.
    void whatIsNotJoinedIsShown() {
        furrow::Display::instance().force(QStringLiteral("en"), furrow::Display::Metric);
        openPonds("boustrophedon");
        QCOMPARE(cells().count(), 1);
        openStep();
        QVERIFY(!text("cells.summary").contains(QStringLiteral("joined")));
        click(QStringLiteral("cells.show"));
        QTRY_VERIFY(item(QStringLiteral("cellLayer"))->isVisible());
        QVERIFY(!shows(QStringLiteral("cells.slider")));
        key(Qt::Key_Escape);
        QTRY_VERIFY(!item(QStringLiteral("cellLayer"))->isVisible());
    }

    // One piece has nothing to show.
    void aFieldInOnePieceHasNoSteps() {
        DRAW_FIELD();
        QCOMPARE(cells().count(), 0);
        clickStep();
        QTRY_VERIFY(shows(QStringLiteral("decomposition.method")));
        QVERIFY(!shows(QStringLiteral("cells.summary")));
    }
};

FURROW_TEST_WITH(TestCellsWindow, QGuiApplication);
#include "tst_cells_window.moc"
