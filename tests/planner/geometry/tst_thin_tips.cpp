#include "planner/geometry/thin_tips.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <numbers>

using namespace furrow;

class ThinTipsTest : public QObject {
    Q_OBJECT

private slots:
    void byHand_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("areaM2");
        QTest::addColumn<int>("points");
        QTest::newRow("square") << "POLYGON((0 0, 10 0, 10 10, 0 10, 0 0))" << 1.0 << 100.0 << 4;
        // A spike 20 m long, 0.4 m wide at its root: all of it is narrow.
        QTest::newRow("spike") << "POLYGON((0 0, 10 0, 10 4.8, 30 5, 10 5.2, 10 10, 0 10, 0 0))" << 0.5
                               << 100.0 << 6;
        // The same is cut where it is 0.2 m wide, halfway: the tip has a quarter of its 4 m2.
        QTest::newRow("half of a spike")
            << "POLYGON((0 0, 10 0, 10 4.8, 30 5, 10 5.2, 10 10, 0 10, 0 0))" << 0.2 << 103.0 << 8;
        // Its lower side is shorter: the square's own edge is a side of the spike's rest.
        QTest::newRow("sides of different length")
            << "POLYGON((0 0, 20 0, 20 4.8, 30 5, 10 5.2, 10 10, 0 10, 0 0))" << 0.5 << 151.5 << 7;
        // A hole with a spike into the field is no tip of the field.
        QTest::newRow("hole's spike")
            << "POLYGON((0 0, 40 0, 40 40, 0 40, 0 0), (5 5, 5 15, 15 15, 15 10.2, 35 10, 15 9.8, 15 5, 5 5))"
            << 0.5 << 1600.0 - 104.0 << 11;
    }
    void byHand() {
        QFETCH(QString, wkt);
        QFETCH(double, widthM);
        QFETCH(double, areaM2);
        QFETCH(int, points);
        const Polygon left =
            withoutThinTips(test::polygonsFromWkt(wkt.toStdString()).front(), metres(widthM));
        COMPARE_WITHIN(area(left).si(), areaM2, 0.2);
        QCOMPARE(static_cast<int>(vertexCount({left})), points);
    }

    // A disc of 125 m is left of 50,000 spikes.
    void star() {
        Ring ring;
        for (int i = 0; i < 100'000; ++i) {
            ring.push_back((i % 2 == 0 ? 250.0 : 125.0) * direction(2.0 * std::numbers::pi * i / 100'000));
        }
        const Polygon left = withoutThinTips({.outer = ring, .holes = {}}, metres(0.2));
        QCOMPARE(left.outer.size(), std::size_t{50'000});
        COMPARE_WITHIN(area(left).si(), std::numbers::pi * 125.0 * 125.0, 1.0);
    }
};

FURROW_TEST(ThinTipsTest);
#include "tst_thin_tips.moc"
