// By hand.

#include "planner/geometry/bounds.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <vector>

using namespace furrow;

class BoundsTest : public QObject {
    Q_OBJECT

private slots:
    void aroundPoints() {
        const std::vector<Point> points{{3, -1}, {-2, 5}, {0, 7}, {1, 1}};
        QVERIFY(bounds(points) == (Bounds{{-2, -1}, {3, 7}}));
        QCOMPARE(bounds(points).width(), 5.0);
        QCOMPARE(bounds(points).height(), 8.0);
        QVERIFY(bounds(std::array{Point{-4, 9}}) == (Bounds{{-4, 9}, {-4, 9}}));
        QVERIFY(bounds(std::vector<Point>{}) == Bounds{});
        QVERIFY(bounds({8, 1}, {2, 6}) == (Bounds{{2, 1}, {8, 6}}));
    }
    void joinedAndWidened() {
        QVERIFY(joined({{0, 0}, {1, 1}}, {{-3, 4}, {-2, 6}}) == (Bounds{{-3, 0}, {1, 6}}));
        QVERIFY(widened({{0, 1}, {4, 2}}, 0.5) == (Bounds{{-0.5, 0.5}, {4.5, 2.5}}));
    }
    void sharedPoints() {
        const Bounds box{{0, 0}, {4, 2}};
        QVERIFY(meet(box, {{1, 1}, {2, 1.5}}));
        QVERIFY(meet(box, {{4, 2}, {9, 9}}));  // a corner
        QVERIFY(!meet(box, {{4.1, 0}, {9, 2}}));
        QVERIFY(!meet(box, {{0, -3}, {4, -0.1}}));
        QVERIFY(contains(box, {4, 1}));
        QVERIFY(!contains(box, {2, 2.01}));
    }
    void distances() {
        const Bounds box{{0, 0}, {4, 2}};
        QCOMPARE(distanceM({1, 1}, box), 0.0);
        QCOMPARE(distanceM({-2, 1}, box), 2.0);
        QCOMPARE(distanceM({7, 6}, box), 5.0);
    }
};

FURROW_TEST(BoundsTest);
#include "tst_bounds.moc"
