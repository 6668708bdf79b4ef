#include "tests/support/test_program.h"
#include "ui/map/even_odd_fill.h"

#include <QRandomGenerator>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace furrow;

namespace {

using MapRings = std::vector<std::vector<MapPoint>>;

double filledArea(const FillMesh& mesh) {
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.size(); i += 3) {
        const double ax = mesh[i + 1].x - mesh[i].x;
        const double ay = mesh[i + 1].y - mesh[i].y;
        const double bx = mesh[i + 2].x - mesh[i].x;
        const double by = mesh[i + 2].y - mesh[i].y;
        area += std::abs(ax * by - ay * bx) / 2.0;
    }
    return area;
}

std::vector<MapPoint> square(float x, float y, float size) {
    return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

double ringArea(const std::vector<MapPoint>& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const MapPoint a = ring[i];
        const MapPoint b = ring[(i + 1) % ring.size()];
        twice += double{a.x} * double{b.y} - double{b.x} * double{a.y};
    }
    return std::abs(twice) / 2.0;
}

}  // namespace

class TestEvenOddFill : public QObject {
    Q_OBJECT

private slots:
    // Areas worked by hand.
    void fills_data() {
        QTest::addColumn<MapRings>("rings");
        QTest::addColumn<double>("area");
        QTest::newRow("nothing") << MapRings{} << 0.0;
        QTest::newRow("one point") << MapRings{{{1, 1}}} << 0.0;
        QTest::newRow("flat ring") << MapRings{{{0, 1}, {5, 1}, {9, 1}}} << 0.0;
        QTest::newRow("square") << MapRings{square(0, 0, 10)} << 100.0;
        QTest::newRow("triangle on its tip") << MapRings{{{0, 0}, {10, 0}, {5, 8}}} << 40.0;
        QTest::newRow("square with a hole") << MapRings{square(0, 0, 10), square(2, 3, 4)} << 84.0;
        QTest::newRow("island in a hole")
            << MapRings{square(0, 0, 10), square(2, 2, 6), square(4, 4, 2)} << 68.0;
        QTest::newRow("two squares that share an edge")
            << MapRings{square(0, 0, 10), square(10, 0, 10)} << 200.0;
        QTest::newRow("hole on the boundary") << MapRings{square(0, 0, 10), square(0, 3, 4)} << 84.0;
        QTest::newRow("the same ring twice") << MapRings{square(0, 0, 10), square(0, 0, 10)} << 0.0;
        QTest::newRow("bend") << MapRings{{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}}} << 64.0;
        QTest::newRow("comb") << MapRings{{{0, 0},
                                           {7, 0},
                                           {7, 5},
                                           {6, 5},
                                           {6, 1},
                                           {4, 1},
                                           {4, 5},
                                           {3, 5},
                                           {3, 1},
                                           {1, 1},
                                           {1, 5},
                                           {0, 5}}}
                              << 7.0 + 3 * 4.0;
    }
    void fills() {
        QFETCH(MapRings, rings);
        QFETCH(double, area);
        QCOMPARE(filledArea(evenOddTriangles(rings)), area);
        // Ring directions do not matter.
        for (auto& ring : rings) {
            std::ranges::reverse(ring);
        }
        QCOMPARE(filledArea(evenOddTriangles(rings)), area);
    }
    void starsKeepTheirArea() {
        QRandomGenerator random{4711};
        for (int round = 0; round < 50; ++round) {
            std::vector<MapPoint> star;
            const int corners = 5 + random.bounded(400);
            for (int i = 0; i < corners; ++i) {
                const double angle = 2.0 * std::numbers::pi * i / corners;
                const double radius = 200.0 + 800.0 * random.generateDouble();
                star.push_back({static_cast<float>(radius * std::cos(angle)),
                                static_cast<float>(radius * std::sin(angle))});
            }
            const double expected = ringArea(star);
            const double filled = filledArea(evenOddTriangles({star}));
            QVERIFY2(std::abs(filled - expected) < 1e-4 * expected,
                     qPrintable(QStringLiteral("round %1: %2 of %3").arg(round).arg(filled).arg(expected)));
        }
    }
    void keepsFewTriangles() {
        std::vector<MapPoint> circle;
        for (int i = 0; i < 10000; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 10000;
            circle.push_back(
                {static_cast<float>(1e4 * std::cos(angle)), static_cast<float>(1e4 * std::sin(angle))});
        }
        QVERIFY(evenOddTriangles({circle}).size() <= 6 * 10000);
    }
};

FURROW_TEST(TestEvenOddFill);
#include "tst_even_odd_fill.moc"
