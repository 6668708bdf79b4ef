#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/ring_clipping.h"
#include "planner/geometry/strip_area.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <numbers>
#include <random>

using namespace furrow;

class StripAreaTest : public QObject {
    Q_OBJECT

private slots:
    void byHand_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<double>("areaM2");
        // The strip goes from (0, 0) to (10, 0), 1 m to either side.
        QTest::newRow("inside") << "POLYGON((2 -0.5, 4 -0.5, 4 0.5, 2 0.5, 2 -0.5))" << 2.0;
        QTest::newRow("beside") << "POLYGON((2 1.5, 4 1.5, 4 3, 2 3, 2 1.5))" << 0.0;
        QTest::newRow("behind") << "POLYGON((-4 -0.5, -2 -0.5, -2 0.5, -4 0.5, -4 -0.5))" << 0.0;
        QTest::newRow("over all of it") << "POLYGON((-5 -5, 15 -5, 15 5, -5 5, -5 -5))" << 20.0;
        QTest::newRow("over its end") << "POLYGON((8 0, 12 0, 12 4, 8 4, 8 0))" << 2.0;
        // Half of it, cut off along a slanting edge.
        QTest::newRow("slanting") << "POLYGON((0 -1, 10 1, 10 9, 0 9, 0 -1))" << 10.0;
        QTest::newRow("with a hole")
            << "POLYGON((-5 -5, 15 -5, 15 5, -5 5, -5 -5), (4 -0.5, 4 4, 6 4, 6 -0.5, 4 -0.5))" << 17.0;
    }
    void byHand() {
        QFETCH(QString, wkt);
        QFETCH(double, areaM2);
        const Strip strip{.from = {0, 0}, .along = {1, 0}, .lengthM = 10.0, .halfWidthM = 1.0};
        COMPARE_WITHIN(areaInM2(test::polygonsFromWkt(wkt.toStdString()).front(), strip), areaM2, 1e-12);
    }
    void asGeosHasIt() {
        std::mt19937_64 random{7};
        RingClipping clipping;
        for (int i = 0; i < 500; ++i) {
            const MultiPolygon land = test::randomPolygons(
                random, test::kShapes[static_cast<std::size_t>(i) % test::kShapes.size()], 100.0);
            const double angle = test::uniform(random, 0.0, 2.0 * std::numbers::pi);
            const Bounds box = bounds(land);
            const Strip strip{.from = {test::uniform(random, box.min.x, box.max.x),
                                       test::uniform(random, box.min.y, box.max.y)},
                              .along = {std::cos(angle), std::sin(angle)},
                              .lengthM = test::uniform(random, 1.0, 150.0),
                              .halfWidthM = test::uniform(random, 0.1, 20.0)};
            const Point side = strip.halfWidthM * Point{-strip.along.y, strip.along.x};
            const Point end = strip.from + strip.lengthM * strip.along;
            const MultiPolygon rectangle{
                {.outer = {strip.from - side, end - side, end + side, strip.from + side}, .holes = {}}};
            double sumM2 = 0.0;
            double clippedM2 = 0.0;
            for (const Polygon& polygon : land) {
                sumM2 += areaInM2(polygon, strip);
                clippedM2 += signedAreaM2(clipping.clipped(polygon.outer, rectangle.front().outer));
                for (const Ring& hole : polygon.holes) {
                    clippedM2 += signedAreaM2(clipping.clipped(hole, rectangle.front().outer));
                }
            }
            const auto common = intersection(land, rectangle, {});
            QVERIFY(common.has_value());
            COMPARE_WITHIN(sumM2, area(*common).si(), 1e-6);
            COMPARE_WITHIN(clippedM2, area(*common).si(), 1e-6);
        }
    }
    void clippedByHand() {
        RingClipping clipping;
        const Ring square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
        const Ring inside{{2, 2}, {4, 2}, {3, 5}};
        QCOMPARE(clipping.clipped(inside, square), inside);
        QVERIFY(clipping.clipped({{12, 2}, {14, 2}, {13, 5}}, square).empty());
        QVERIFY(clipping.clipped({}, square).empty());
        // A corner that juts out to the right, and one to the right and upwards.
        QCOMPARE(clipping.clipped({{8, 4}, {12, 6}, {8, 8}}, square),
                 (Ring{{8, 4}, {10, 5}, {10, 7}, {8, 8}}));
        COMPARE_WITHIN(signedAreaM2(clipping.clipped({{8, 8}, {14, 8}, {14, 14}, {8, 14}}, square)), 4.0,
                       1e-12);
    }
};

FURROW_TEST(StripAreaTest);
#include "tst_strip_area.moc"
