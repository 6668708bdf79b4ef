#include "planner/field/drivable_area.h"
#include "planner/field/overhung_land.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <format>
#include <limits>
#include <numbers>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};
// Chords of arcs, and the plane of the field.
constexpr double kCloseM2 = 0.5;

FieldSource rectangle() {
    return test::fieldSourceFromLocal({test::centredRectangle(100.0, 50.0)}, kCentre);
}

/// Of 20 by 10 m in the middle.
Obstacle pond(double overhangM) {
    return {
        .name = "Pond",
        .outline = test::fieldSourceFromLocal({test::centredRectangle(20.0, 10.0)}, kCentre).parts.front(),
        .overhang = metres(overhangM)};
}

/// Six edges; the third runs west to the inward corner at (40, 40), the fourth north from there.
FieldSource bent() {
    return test::fieldSourceFromLocal(
        {{.outer = {{0, 0}, {100, 0}, {100, 40}, {40, 40}, {40, 100}, {0, 100}}, .holes = {}}}, kCentre);
}

EdgeWidth over(std::size_t edge, double widthM) {
    return {.part = 0, .ring = 0, .edge = edge, .width = metres(widthM)};
}

}  // namespace

class OverhungLandTest : public QObject {
    Q_OBJECT

private:
    static double areaOf(const FieldSource& source, double leastM = 0.0) {
        const Field field = Field::create(source).value();
        return area(*overhungLand(field, metres(leastM), {}).value()).si();
    }

private slots:
    void noneWithoutAnOverhang() {
        FieldSource source = rectangle();
        source.obstacles = {pond(0.0)};
        const Field field = Field::create(source).value();
        QVERIFY(!overhungLand(field, {}, {}).value().has_value());
        const AllowedAreas areas = allowedAreas(field, std::nullopt, metres(1.0), {}).value();
        QVERIFY(!areas.hasOverhang());
        QVERIFY(areas.tractor() == drivableArea(field, metres(1.0), {}).value());
        QVERIFY(areas.implement() == areas.tractor());
    }

    void ofEveryEdge() {
        // 6 m beside 300 m of edge, and a quarter of a disc at each corner.
        COMPARE_WITHIN(areaOf(rectangle(), 6.0), 5000.0 + 300.0 * 6.0 + std::numbers::pi * 36.0, kCloseM2);
    }

    void ofOneEdge_data() {
        QTest::addColumn<double>("leastM");
        QTest::addColumn<double>("areaM2");
        const double pi = std::numbers::pi;
        // The ends lie beyond the corners, not in front of the other edges.
        QTest::newRow("none elsewhere") << 0.0 << 5000.0 + 100.0 * 4.0 + 2.0 * pi * 16.0 / 4.0;
        QTest::newRow("1 m elsewhere")
            << 1.0 << 5000.0 + 100.0 * 4.0 + 200.0 + 2.0 * pi * 16.0 / 4.0 + 2.0 * pi / 4.0;
        QTest::newRow("more elsewhere") << 6.0 << 5000.0 + 1800.0 + pi * 36.0;
    }
    void ofOneEdge() {
        QFETCH(double, leastM);
        QFETCH(double, areaM2);
        FieldSource source = rectangle();
        source.edgeOverhangs = {over(0, 4.0)};
        COMPARE_WITHIN(areaOf(source, leastM), areaM2, kCloseM2);
    }

    void anInwardCornerKeepsTheLandInFrontOfItsOtherEdge() {
        FieldSource source = bent();
        source.edgeOverhangs = {over(2, 6.0)};
        // 60 m of edge less the 6 m in front of the other one, and the end at the outward corner.
        const double strip = 6.0 * 54.0 + std::numbers::pi * 36.0 / 4.0;
        COMPARE_WITHIN(areaOf(source), 6400.0 + strip, kCloseM2);
        // With both, their land is one.
        source.edgeOverhangs.push_back(over(3, 6.0));
        COMPARE_WITHIN(areaOf(source), 6400.0 + 2.0 * strip + 36.0, kCloseM2);
    }

    void obstacles_data() {
        QTest::addColumn<double>("overhangM");
        QTest::addColumn<double>("leastM");
        QTest::addColumn<double>("forbiddenM2");
        QTest::newRow("its own") << 3.0 << 0.0 << 14.0 * 4.0;
        QTest::newRow("that of all is more") << 1.0 << 3.0 << 14.0 * 4.0;
        QTest::newRow("its own is more") << 3.0 << 2.0 << 14.0 * 4.0;
        QTest::newRow("all of it") << 5.5 << 0.0 << 0.0;
    }
    void obstacles() {
        QFETCH(double, overhangM);
        QFETCH(double, leastM);
        QFETCH(double, forbiddenM2);
        FieldSource source = rectangle();
        const double around = leastM > 0.0 ? areaOf(source, leastM) : 5000.0;
        source.obstacles = {pond(overhangM)};
        COMPARE_WITHIN(areaOf(source, leastM), around - forbiddenM2, kCloseM2);
    }

    void aLowObstacleBelowAHighOneIsHigh() {
        FieldSource source = rectangle();
        source.obstacles = {pond(8.0), pond(0.0)};
        COMPARE_WITHIN(areaOf(source), 5000.0 - 200.0, kCloseM2);
    }

    void theMarginHoldsForBoth() {
        const Field field = Field::create(rectangle()).value();
        const auto land = overhungLand(field, metres(6.0), {}).value();
        const AllowedAreas areas = allowedAreas(field, land, metres(1.0), {}).value();
        COMPARE_WITHIN(area(areas.tractor()).si(), 98.0 * 48.0, kCloseM2);
        COMPARE_WITHIN(area(areas.implement()).si(), 5000.0 + 300.0 * 5.0 + std::numbers::pi * 25.0,
                       kCloseM2);
    }

    void refused_data() {
        QTest::addColumn<double>("overhangM");
        QTest::addColumn<int>("edge");
        QTest::newRow("negative") << -1.0 << 0;
        QTest::newRow("no number") << std::numeric_limits<double>::quiet_NaN() << 0;
        QTest::newRow("too much") << 100.5 << 0;
        QTest::newRow("no such edge") << 4.0 << 4;
    }
    void refused() {
        QFETCH(double, overhangM);
        QFETCH(int, edge);
        FieldSource source = rectangle();
        source.edgeOverhangs = {over(static_cast<std::size_t>(edge), overhangM)};
        const auto field = Field::create(source);
        QVERIFY(!field.has_value());
        QCOMPARE(field.error().code, ErrorCode::InputRefused);
        QVERIFY2(field.error().line().contains(std::format("edge {}", edge + 1)),
                 field.error().line().c_str());
        if (edge == 0) {
            source = rectangle();
            source.obstacles = {pond(overhangM)};
            const auto other = Field::create(source);
            QVERIFY(!other.has_value());
            QVERIFY2(other.error().line().contains("obstacle 1"), other.error().line().c_str());
        }
    }
};

FURROW_TEST(OverhungLandTest);
#include "tst_overhung_land.moc"
