#include "planner/geometry/polygon.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace furrow;

class TestPolygon : public QObject {
    Q_OBJECT
private slots:
    /// A square of 4 m with a hole of 2 m, in steps of 1 m: 16 places less those 4 in the hole.
    void placesInsideByHand() {
        const Polygon square{.outer = {{10, 20}, {14, 20}, {14, 24}, {10, 24}},
                             .holes = {{{11, 21}, {11, 23}, {13, 23}, {13, 21}}}};
        const std::vector<Point> places = placesInside(square, 1.0);
        QCOMPARE(places.size(), std::size_t{12});
        QVERIFY(places.front() == (Point{10.5, 20.5}));
        QVERIFY(places.back() == (Point{13.5, 23.5}));
        QVERIFY(!std::ranges::contains(places, Point{11.5, 21.5}));
        QVERIFY(placesInside({}, 1.0).empty());
    }
    /// The same places as point by point.
    void placesInsideOfFields() {
        std::mt19937_64 random{20261127};
        for (int i = 0; i < 60; ++i) {
            const Polygon field =
                test::randomPolygons(random, test::kShapes[i % test::kShapes.size()], 150.0).front();
            const Bounds box = bounds(field);
            const double stepM = 0.021 * (box.width() + box.height());
            std::vector<Point> expected;
            for (double y = box.min.y + 0.5 * stepM; y < box.max.y; y += stepM) {
                for (double x = box.min.x + 0.5 * stepM; x < box.max.x; x += stepM) {
                    if (isInside(field, {x, y})) {
                        expected.push_back({x, y});
                    }
                }
            }
            QVERIFY(!expected.empty());
            QVERIFY(placesInside(field, stepM) == expected);
        }
    }

    void withoutHolesByHand() {
        const Polygon square{.outer = {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
                             .holes = {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};
        const Polygon triangle{.outer = {{10, 0}, {14, 0}, {10, 3}}, .holes = {}};
        const MultiPolygon filled = withoutHoles({square, triangle});
        QCOMPARE(filled.size(), std::size_t{2});
        QVERIFY(filled[0].holes.empty());
        COMPARE_WITHIN(area({square, triangle}).si(), 12.0 + 6.0, 1e-12);
        COMPARE_WITHIN(area(filled).si(), 16.0 + 6.0, 1e-12);
        QVERIFY(withoutHoles({}).empty());
    }
};

FURROW_TEST(TestPolygon);
#include "tst_polygon.moc"
