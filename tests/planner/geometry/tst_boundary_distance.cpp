#include "planner/geometry/boundary_distance.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace furrow;

namespace {

/// Distance to the nearest edge, one after the other, and the side by counting crossings to the right.
double insideByBruteForce(const MultiPolygon& polygons, Point point) {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    forEachEdge(polygons, [&](Point a, Point b) {
        const Point way = b - a;
        const double t = std::clamp(dot(point - a, way) / dot(way, way), 0.0, 1.0);
        nearest = std::min(nearest, distance(point, a + t * way));
        if ((a.y > point.y) != (b.y > point.y) &&
            point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) {
            inside = !inside;
        }
    });
    return inside ? nearest : -nearest;
}

}  // namespace

class BoundaryDistanceTest : public QObject {
    Q_OBJECT

private slots:
    void byHand_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<double>("reachM");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("insideM");  // NaN where nothing is within reach inside
        const double nothing = std::numeric_limits<double>::quiet_NaN();
        const QString square = QStringLiteral("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
        QTest::newRow("inside") << square << 5.0 << 50.0 << 3.0 << 3.0;
        QTest::newRow("outside") << square << 5.0 << 50.0 << -3.0 << -3.0;
        QTest::newRow("on the edge") << square << 5.0 << 100.0 << 40.0 << 0.0;
        QTest::newRow("on a corner") << square << 5.0 << 100.0 << 100.0 << 0.0;
        QTest::newRow("nearest of two edges") << square << 5.0 << 2.0 << 4.0 << 2.0;
        QTest::newRow("outside, past a corner") << square << 6.0 << 103.0 << 104.0 << -5.0;
        QTest::newRow("outside, level with a corner") << square << 6.0 << 104.0 << 100.0 << -4.0;
        QTest::newRow("just within reach") << square << 5.0 << 50.0 << 4.999 << 4.999;
        QTest::newRow("just out of reach") << square << 5.0 << 50.0 << 5.001 << nothing;
        QTest::newRow("just out of reach outside") << square << 5.0 << 50.0 << -5.001 << -5.0;
        QTest::newRow("past a corner, out of reach") << square << 4.9 << 103.0 << 104.0 << -4.9;
        QTest::newRow("far inside") << square << 5.0 << 50.0 << 50.0 << nothing;
        QTest::newRow("far away") << square << 5.0 << -1e5 << 2e5 << -5.0;
        QTest::newRow("reach of a hundredth of a cell, inside") << square << 1e-3 << 50.02 << 0.11 << nothing;
        QTest::newRow("reach of a hundredth of a cell, outside") << square << 1e-3 << 50.02 << -0.11 << -1e-3;
        QTest::newRow("not a number") << square << 5.0 << nothing << 0.0 << -5.0;
        QTest::newRow("reach of the whole field") << square << 500.0 << 50.0 << 45.0 << 45.0;
        QTest::newRow("reach of much less than an edge") << square << 0.1 << 33.3 << 0.05 << 0.05;
        QTest::newRow("no polygons") << QStringLiteral("POLYGON EMPTY") << 5.0 << 0.0 << 0.0 << -5.0;
        const QString hole =
            QStringLiteral("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 40 60, 60 60, 60 40, 40 40))");
        QTest::newRow("beside a hole") << hole << 8.0 << 37.0 << 50.0 << 3.0;
        QTest::newRow("in a hole") << hole << 8.0 << 42.0 << 50.0 << -2.0;
        QTest::newRow("past the corner of a hole") << hole << 8.0 << 36.0 << 63.0 << 5.0;
        QTest::newRow("middle of a hole out of reach") << hole << 8.0 << 50.0 << 50.0 << -8.0;
        // A needle of 2 m over 100 m: beyond its tip both edges are behind the point.
        const QString needle = QStringLiteral("POLYGON((0 -1, 100 0, 0 1, 0 -1))");
        QTest::newRow("ahead of a needle") << needle << 5.0 << 103.0 << 0.0 << -3.0;
        QTest::newRow("ahead of a needle, to the left") << needle << 5.0 << 101.0 << 2.0 << -std::sqrt(5.0);
        QTest::newRow("ahead of a needle, to the right") << needle << 5.0 << 101.0 << -2.0 << -std::sqrt(5.0);
        // 0.01 m above the axis at 50 m; the edges are 0.5 m away from the axis there, sloping by 1 in 100.
        QTest::newRow("in a needle") << needle << 5.0 << 50.0 << 0.01
                                     << 0.49 * 100.0 / std::hypot(100.0, 1.0);
        QTest::newRow("above a needle")
            << needle << 5.0 << 50.0 << 1.5 << -1.0 * 100.0 / std::hypot(100.0, 1.0);
        // A notch as sharp, cut into a block from the left; its tip is at (100, 0).
        const QString notch =
            QStringLiteral("POLYGON((0 -50, 200 -50, 200 50, 0 50, 0 1, 100 0, 0 -1, 0 -50))");
        QTest::newRow("ahead of a notch") << notch << 5.0 << 103.0 << 0.0 << 3.0;
        QTest::newRow("ahead of a notch, to the left") << notch << 5.0 << 101.0 << 2.0 << std::sqrt(5.0);
        QTest::newRow("ahead of a notch, to the right") << notch << 5.0 << 101.0 << -2.0 << std::sqrt(5.0);
        QTest::newRow("in a notch") << notch << 5.0 << 50.0 << 0.01 << -0.49 * 100.0 / std::hypot(100.0, 1.0);
        // Two parts 4 m apart.
        const QString parts = QStringLiteral(
            "MULTIPOLYGON(((0 0, 20 0, 20 20, 0 20, 0 0)), ((24 0, 44 0, 44 20, 24 20, 24 0)))");
        QTest::newRow("between parts") << parts << 5.0 << 23.0 << 10.0 << -1.0;
        QTest::newRow("in the other part") << parts << 5.0 << 25.5 << 10.0 << 1.5;
        // The tip of a triangle lies in the bend of an L: holes that meet at (50, 50).
        const QString meeting = QStringLiteral(
            "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (50 50, 54 60, 60 54, 50 50), "
            "(20 20, 20 80, 50 80, 50 50, 80 50, 80 20, 20 20))");
        QTest::newRow("in a hole whose bend another hole touches") << meeting << 6.0 << 47.0 << 46.0 << -5.0;
        QTest::newRow("in the gap between them") << meeting << 6.0 << 54.0 << 51.0 << 0.6 / std::sqrt(1.16);
    }
    void byHand() {
        QFETCH(QString, wkt);
        QFETCH(double, reachM);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, insideM);
        const MultiPolygon polygons =
            wkt.endsWith("EMPTY") ? MultiPolygon{} : test::polygonsFromWkt(wkt.toStdString());
        // Far from the origin too, where rounding is coarser, and on both sides of 0.
        for (const Point by : {Point{}, Point{-30.0, 40.0}, Point{-2e5, 1e5}}) {
            const BoundaryDistance edges{test::moved(polygons, degrees(0.0), by), metres(reachM)};
            const auto found = edges.insideM(Point{x, y} + by);
            QCOMPARE(found.has_value(), !std::isnan(insideM));
            if (found) {
                COMPARE_WITHIN(*found, insideM, 1e-9);
            }
        }
    }

    void likeBruteForce_data() {
        QTest::addColumn<double>("reachM");
        // Cells are as large as a 500th of the polygons.
        QTest::newRow("reach of a centimetre") << 0.01;
        QTest::newRow("reach of a metre") << 1.0;
        QTest::newRow("reach of a machine") << 7.0;
        QTest::newRow("reach of half a field") << 60.0;
    }
    void likeBruteForce() {
        QFETCH(double, reachM);
        constexpr std::uint64_t kSeed = 77;
        std::mt19937_64 random{kSeed};
        int near = 0;
        for (int i = 0; i < 100; ++i) {
            const MultiPolygon polygons =
                test::randomPolygons(random, test::kShapes[static_cast<std::size_t>(i) % 5], 100.0);
            const BoundaryDistance edges{polygons, metres(reachM)};
            const Bounds box = bounds(polygons);
            for (int k = 0; k < 300; ++k) {
                const Point point{test::uniform(random, box.min.x - 20.0, box.max.x + 20.0),
                                  test::uniform(random, box.min.y - 20.0, box.max.y + 20.0)};
                const double expected = insideByBruteForce(polygons, point);
                const auto found = edges.insideM(point);
                const QByteArray said = QStringLiteral("seed %1, field %2, POINT(%3 %4): %5 m")
                                            .arg(kSeed)
                                            .arg(i)
                                            .arg(point.x, 0, 'g', 17)
                                            .arg(point.y, 0, 'g', 17)
                                            .arg(expected, 0, 'g', 12)
                                            .toUtf8();
                VERIFY_TOLD(found.has_value() == (expected <= reachM), said);
                VERIFY_TOLD(!found || std::abs(*found - std::max(expected, -reachM)) < 1e-9, said);
                near += std::abs(expected) <= reachM ? 1 : 0;
            }
        }
        QVERIFY(near > 100 || reachM < 0.1);
    }

    // A square of 10 m with an obstacle from (4, 4) to (6, 6).
    void edgesInARectangle_data() {
        QTest::addColumn<Point>("origin");
        QTest::addColumn<double>("headingDeg");
        QTest::addColumn<Bounds>("rectangle");
        QTest::addColumn<bool>("reaches");
        const Bounds long2{{0.0, -1.0}, {5.0, 1.0}};
        QTest::newRow("flush with an edge") << Point{2.0, 1.0} << 0.0 << long2 << false;
        QTest::newRow("over it by less than touching") << Point{2.0, 0.9995} << 0.0 << long2 << false;
        QTest::newRow("over it by more") << Point{2.0, 0.998} << 0.0 << long2 << true;
        QTest::newRow("beside the obstacle") << Point{2.0, 3.0} << 0.0 << long2 << false;
        QTest::newRow("its corner in the side") << Point{2.0, 3.3} << 0.0 << long2 << true;
        QTest::newRow("the obstacle all inside")
            << Point{3.0, 5.0} << 0.0 << Bounds{{0.0, -2.0}, {4.0, 2.0}} << true;
        QTest::newRow("all inside the obstacle")
            << Point{5.0, 5.0} << 30.0 << Bounds{{-0.5, -0.5}, {0.5, 0.5}} << false;
        QTest::newRow("up to the far edge") << Point{1.0, 5.0} << 90.0 << long2 << false;
        QTest::newRow("across it") << Point{1.0, 5.1} << 90.0 << long2 << true;
        QTest::newRow("no width") << Point{1.0, 5.0} << 0.0 << Bounds{{0.0, 0.0}, {8.0, 0.0}} << false;
        QTest::newRow("far away") << Point{100.0, 5.0} << 0.0 << long2 << false;
    }
    void edgesInARectangle() {
        QFETCH(Point, origin);
        QFETCH(double, headingDeg);
        QFETCH(Bounds, rectangle);
        QFETCH(bool, reaches);
        Polygon field = test::rectangle(10.0, 10.0);
        field.holes.push_back({{4.0, 4.0}, {4.0, 6.0}, {6.0, 6.0}, {6.0, 4.0}});
        const BoundaryDistance edges{{field}, metres(3.0)};
        QCOMPARE(edges.reachInto(origin, direction(degrees(headingDeg).si()), rectangle, 1e-3), reaches);
    }

    void edgesInARectangleLikeBruteForce() {
        constexpr double kTouchingM = 1e-3;
        constexpr double kStepM = 0.02;
        int in = 0;
        int out = 0;
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            std::mt19937_64 random{seed};
            const MultiPolygon polygons =
                test::randomPolygons(random, test::kShapes[seed % test::kShapes.size()], 60.0);
            const BoundaryDistance edges{polygons, metres(3.0)};
            const Bounds box = bounds(polygons);
            for (int i = 0; i < 60; ++i) {
                const Point origin{test::uniform(random, box.min.x - 5.0, box.max.x + 5.0),
                                   test::uniform(random, box.min.y - 5.0, box.max.y + 5.0)};
                const Point along = direction(test::uniform(random, 0.0, 6.3));
                const Bounds rectangle{{test::uniform(random, -3.0, 0.0), test::uniform(random, -2.0, 0.0)},
                                       {test::uniform(random, 0.0, 12.0), test::uniform(random, 0.1, 2.0)}};
                double deepest = -1.0;
                forEachEdge(polygons, [&](Point a, Point b) {
                    const auto steps = static_cast<int>(std::ceil(distance(a, b) / kStepM)) + 1;
                    for (int k = 0; k <= steps; ++k) {
                        const Point away = a + (static_cast<double>(k) / steps) * (b - a) - origin;
                        const Point at{dot(along, away), cross(along, away)};
                        deepest =
                            std::max(deepest, std::min({at.x - rectangle.min.x, rectangle.max.x - at.x,
                                                        at.y - rectangle.min.y, rectangle.max.y - at.y}));
                    }
                });
                const bool found = edges.reachInto(origin, along, rectangle, kTouchingM);
                const QByteArray said =
                    QStringLiteral("seed %1, rectangle %2: %3 m").arg(seed).arg(i).arg(deepest).toUtf8();
                if (deepest > kTouchingM) {
                    VERIFY_TOLD(found, said);
                    ++in;
                } else if (deepest < kTouchingM - kStepM) {
                    VERIFY_TOLD(!found, said);
                    ++out;
                }
            }
        }
        QVERIFY(in > 300 && out > 300);
    }
};

FURROW_TEST(BoundaryDistanceTest);
#include "tst_boundary_distance.moc"
