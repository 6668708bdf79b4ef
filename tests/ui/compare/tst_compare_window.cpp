// Two plans of a field in the window: a variant is kept, the other plan is planned beside it, drawn over it
// while a key is held, and taken.

#include "planner/plan/method_registry.h"
#include "planner/project/project_edits.h"
#include "planner/swaths/methods.h"
#include "tests/support/test_program.h"
#include "tests/ui/window/window_test.h"
#include "ui/map/plan_layer.h"

#include <QWheelEvent>

#include <cmath>

using namespace furrow;

class TestCompareWindow : public test::WindowTest {
    Q_OBJECT

private slots:
    void init();
    void cleanup();
    void withTheStandardSettings();
    void withAVariant();
    void onTwoMaps();
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
    void waitForStill() {
        double zoom = 0.0;
        int still = 0;
        const auto isStill = [&] {
            still = std::exchange(zoom, camera()->zoomLevel()) == camera()->zoomLevel() ? still + 1 : 0;
            return still >= 4;
        };
        QTRY_VERIFY(isStill());
    }
    static QRect sceneRect(const QQuickItem& of) {
        return QRectF{of.mapToScene({0.0, 0.0}), of.size()}.toRect().adjusted(1, 1, -2, -2);
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
    QTRY_COMPARE(figure("Time").value("better").toInt(), 1);
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
    QTRY_COMPARE(figure("Time").value("better").toInt(), -1);
    QVERIFY(!session_->document()->undoText().contains("standard"));
    window_->resize(1000, 640);
    QTRY_COMPARE(map()->width(), 1000.0 - 348.0 - 340.0);
    picture("compare_small");
}

namespace {

/// Of a picture, in a rectangle: pixels that are nearly of this colour.
int pixelsOf(const QImage& image, const QColor& color, const QRect& within) {
    int count = 0;
    for (int y = within.top(); y <= within.bottom(); ++y) {
        for (int x = within.left(); x <= within.right(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            count += std::abs(pixel.red() - color.red()) + std::abs(pixel.green() - color.green()) +
                                 std::abs(pixel.blue() - color.blue()) <
                             24
                         ? 1
                         : 0;
        }
    }
    return count;
}

}  // namespace

void TestCompareWindow::onTwoMaps() {
    // Nothing is compared yet: the key opens both.
    const QGeoCoordinate centreBefore = camera()->center();
    const double zoomBefore = camera()->zoomLevel();
    const double widthBefore = map()->width();
    setOverlap(0.5);
    map()->forceActiveFocus();
    key(Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY(item("comparePanel")->isVisible());
    waitForOther();
    QTRY_VERIFY(item("otherMap.map") != nullptr && item("other.planLayer") != nullptr);
    const QQuickItem* const other = item("otherMap.map");
    QVERIFY(!item("compare.hold")->isVisible());
    QVERIFY(item("firstName")->isVisible() && item("other.name")->isVisible());
    // The same size to a pixel, so that one camera is right for both; beside each other, nothing between.
    QTRY_VERIFY(std::abs(other->width() - map()->width()) <= 1.0);
    QCOMPARE(other->height(), map()->height());
    QCOMPARE(other->mapToScene({0.0, 0.0}).x(), map()->mapToScene({map()->width(), 0.0}).x());
    // Each has its own plan.
    const auto* const first = qobject_cast<const PlanLayer*>(item("planLayer"));
    const auto* const second = qobject_cast<const PlanLayer*>(item("other.planLayer"));
    QCOMPARE(second->drawing(), comparison().drawing());
    QVERIFY(first->drawing() != second->drawing());
    QVERIFY(first->drawing().geometry()->numbers.size() != second->drawing().geometry()->numbers.size());
    QCOMPARE(first->camera(), second->camera());
    // All of the field is in view.
    const QGeoRectangle field = session_->shown()->drawing().bounds();
    QTRY_VERIFY(
        QRectF(0.0, 0.0, map()->width(), map()->height())
            .contains(QRectF{camera()->position(field.topLeft()), camera()->position(field.bottomRight())}));
    picture("compare_two_maps");
    // Dragged by the mouse, the other map moves the first one by as much; and the other way round.
    const QGeoCoordinate corner = field.topLeft();
    QPointF before = camera()->position(corner);
    const QPoint on = middleOf(*other);
    drag(on, on + QPoint{48, 32});
    QTRY_VERIFY((camera()->position(corner) - before - QPointF(48, 32)).manhattanLength() < 8.0);
    before = camera()->position(corner);
    // Beside the field, so that nothing of it is taken hold of.
    const QPoint edge = map()->mapToScene({map()->width() - 20.0, 0.6 * map()->height()}).toPoint();
    drag(edge, edge - QPoint{40, 0});
    QTRY_VERIFY((camera()->position(corner) - before - QPointF(-40, 0)).manhattanLength() < 8.0);
    // The wheel on the other map zooms about the pointer there.
    const QPoint at = on + QPoint{60, -50};
    const QPointF pixel = other->mapFromScene(at);
    const QGeoCoordinate under = camera()->coordinateAt(pixel);
    const double zoom = camera()->zoomLevel();
    QWheelEvent turn{
        at,   window_->mapToGlobal(at), {}, QPoint{0, 120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
        false};
    QGuiApplication::sendEvent(window_, &turn);
    QTRY_COMPARE(camera()->zoomLevel(), zoom + 0.5);
    QVERIFY(under.distanceTo(camera()->coordinateAt(pixel)) < 0.5);
    key(Qt::Key_F);
    waitForStill();
    // What only one plan has is coloured on its own map: green is the one's, magenta the other's.
    auto* const theme = engine_->singletonInstance<QObject*>("Furrow.Controls", "Theme");
    theme->setProperty("forced", 1);
    const QImage image = window_->grabWindow();
    const QColor green = theme->property("accent").value<QColor>();
    const QColor magenta = theme->property("finding").value<QColor>();
    QVERIFY(pixelsOf(image, green, sceneRect(*map())) > 1000);
    QVERIFY(pixelsOf(image, magenta, sceneRect(*other)) > 1000);
    QVERIFY(pixelsOf(image, green, sceneRect(*other)) < 100);
    // In a small window, in all colours.
    window_->resize(1000, 640);
    QTRY_COMPARE(item("comparePanel")->mapToScene({0.0, 0.0}).x(), 660.0);
    for (const auto& [name, mode] : {std::pair{"light", 1}, {"dark", 2}, {"sunlight", 3}}) {
        theme->setProperty("forced", mode);
        QTRY_VERIFY(std::abs(other->width() - map()->width()) <= 1.0 &&
                    std::abs(other->height() - map()->height()) <= 1.0);
        key(Qt::Key_F);
        waitForStill();
        // Beside the tools, which stand in two columns.
        const QQuickItem& tools = *item("mapToolBar");
        QCOMPARE_GE(camera()->position(field.topLeft()).x(), tools.x() + tools.width());
        picture(QStringLiteral("compare_two_maps_small_%1").arg(QLatin1String{name}));
    }
    theme->setProperty("forced", 0);
    window_->resize(1440, 900);
    // The box closes the other map only, and the view is as it was before.
    click("compare.twoMaps");
    QTRY_VERIFY(item("otherMap.map") == nullptr);
    QVERIFY(item("comparePanel")->isVisible());
    QTRY_VERIFY(item("compare.hold")->isVisible());
    QTRY_VERIFY(centreBefore.distanceTo(camera()->center()) < 0.5);
    QCOMPARE(camera()->zoomLevel(), zoomBefore);
    click("compare.twoMaps");
    QTRY_VERIFY(item("otherMap.map") != nullptr);
    key(Qt::Key_Escape);
    QTRY_VERIFY(!item("comparePanel")->isVisible() && item("otherMap.map") == nullptr);
    QTRY_VERIFY(item("stepsPanel")->isVisible());
    QTRY_COMPARE(map()->width(), widthBefore);
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
