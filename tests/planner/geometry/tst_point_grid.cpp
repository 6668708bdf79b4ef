// Against looking at every point.

#include "planner/geometry/point_grid.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>

using namespace furrow;

class PointGridTest : public QObject {
    Q_OBJECT

private slots:
    void asEveryPoint_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("heightM");
        QTest::newRow("one") << 1 << 0.0 << 0.0;
        QTest::newRow("all at one place") << 20 << 0.0 << 0.0;
        QTest::newRow("on a line") << 200 << 500.0 << 0.0;
        QTest::newRow("a strip") << 300 << 500.0 << 2.0;
        QTest::newRow("all over") << 400 << 300.0 << 200.0;
    }
    void asEveryPoint() {
        QFETCH(int, count);
        QFETCH(double, widthM);
        QFETCH(double, heightM);
        std::mt19937_64 random{23};
        std::vector<Point> points;
        for (int i = 0; i < count; ++i) {
            points.push_back({test::uniform(random, 0.0, widthM), test::uniform(random, 0.0, heightM)});
        }
        PointGrid grid{points};
        std::vector<bool> isThere(points.size(), true);
        for (int left = count; left >= 0; --left) {
            const Point place{test::uniform(random, -100.0, widthM + 100.0),
                              test::uniform(random, -100.0, heightM + 100.0)};
            std::optional<std::size_t> nearest;
            double leastM = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < points.size(); ++i) {
                if (isThere[i] && distance(points[i], place) < leastM) {
                    leastM = distance(points[i], place);
                    nearest = i;
                }
            }
            QCOMPARE(grid.nearest(place), nearest);
            QCOMPARE(grid.anyNearer(place, leastM), false);
            QCOMPARE(grid.anyNearer(place, leastM + 1e-9), nearest.has_value());
            if (nearest) {
                grid.takeOut(*nearest);
                grid.takeOut(*nearest);
                isThere[*nearest] = false;
            }
        }
    }
    void empty() {
        QVERIFY(!PointGrid{}.nearest({}));
        QVERIFY(!PointGrid{std::vector<Point>{}}.anyNearer({}, 1e9));
    }
};

FURROW_TEST(PointGridTest);
#include "tst_point_grid.moc"
