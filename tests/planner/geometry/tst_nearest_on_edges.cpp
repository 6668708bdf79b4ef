#include "planner/geometry/nearest_on_edges.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;

class TestNearestOnEdges : public QObject {
    Q_OBJECT
private slots:
    void byHand_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("nearestX");
        QTest::addColumn<double>("nearestY");
        QTest::newRow("outside, beside a side") << 5.0 << -3.0 << 5.0 << 0.0;
        QTest::newRow("outside, at a corner") << 13.0 << 14.0 << 10.0 << 10.0;
        QTest::newRow("inside, near the outer ring") << 1.0 << 5.0 << 0.0 << 5.0;
        QTest::newRow("inside, near the hole") << 3.5 << 5.0 << 4.0 << 5.0;
        QTest::newRow("in the hole") << 5.9 << 5.0 << 6.0 << 5.0;
    }
    void byHand() {
        QFETCH(double, x);
        QFETCH(double, y);
        const MultiPolygon ring{
            {.outer = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, .holes = {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}}};
        const auto nearest = nearestOnEdges(ring, {x, y});
        QVERIFY(nearest.has_value());
        QTEST(nearest->x, "nearestX");
        QTEST(nearest->y, "nearestY");
    }
    void nothing() { QVERIFY(!nearestOnEdges({}, {1.0, 2.0})); }
};

FURROW_TEST(TestNearestOnEdges);
#include "tst_nearest_on_edges.moc"
