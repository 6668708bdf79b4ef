// The exact search is never worse than brute force at 0.1 degree, and what it calls proved is.

#include "planner/geometry/convex_hull.h"
#include "planner/machine/machine_library.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"
#include "tests/support/stages.h"
#include "tests/support/field_generator.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace furrow;

namespace {

constexpr std::uint64_t kSeed = 4711;

Settings byObjective(const char* id) {
    Settings settings;
    [[maybe_unused]] const auto applied = settings.setText(kObjective, id);
    return settings;
}

/// Every heading at 0.1 degree, one after the other.
HeadingFigures bruteForceAtATenth(const ScanLine& scanLine, SwathObjective objective) {
    HeadingFigures best;
    for (int i = 0; i < 1800; ++i) {
        const HeadingFigures figures = scanLine.figures(degrees(0.1 * i), objective);
        if (i == 0 || isBetter(objective, figures, best)) {
            best = figures;
        }
    }
    return best;
}

}  // namespace

class TestExactSearch : public QObject {
    Q_OBJECT

private slots:
    void neverWorseThanATenthOfADegree_data() {
        QTest::addColumn<QString>("objective");
        for (const char* id : {"time", "swath-count", "swath-length", "coverage", "overlap"}) {
            QTest::newRow(id) << QString{id};
        }
    }
    void neverWorseThanATenthOfADegree() {
        QFETCH(QString, objective);
        const Machine& machine = machineLibrary().front();
        const Settings settings = byObjective(qPrintable(objective));
        const SwathObjective by = objectiveOf(settings);
        std::mt19937_64 random{kSeed};
        for (std::size_t i = 0; i < 25; ++i) {
            const MultiPolygon mainland = test::randomPolygons(random, test::kShapes[i % 5], 60.0);
            const auto exact = test::swathsBy(kExactMethod, mainland, machine, settings, {});
            QVERIFY(exact.has_value());
            const auto scanLine = scanLineFor({test::anyField(), mainland, machine, settings});
            QVERIFY(scanLine.has_value());
            const HeadingFigures brute = bruteForceAtATenth(*scanLine, by);
            const HeadingFigures ours = scanLine->figures(exact->heading, by);
            QVERIFY2(!isBetter(by, brute, ours) || (by == SwathObjective::Count && brute.count == ours.count),
                     qPrintable(QStringLiteral("seed %1, field %2").arg(kSeed).arg(i)));
            QCOMPARE(static_cast<int>(exact->swaths.size()), ours.count);
        }
    }

    // A convex field needs as many swaths as its least width holds (rotating calipers), and no fewer.
    void convexCountIsProved() {
        const Machine& machine = machineLibrary().front();
        std::mt19937_64 random{kSeed + 1};
        for (int i = 0; i < 50; ++i) {
            const MultiPolygon mainland = test::randomPolygons(random, test::Shape::Convex, 80.0);
            const auto exact = test::swathsBy(kExactMethod, mainland, machine, byObjective("swath-count"), {});
            QVERIFY(exact.has_value());
            QVERIFY(exact->proved);
            // Worked out apart from the search: the least height over ten thousand directions.
            double narrowest = 1e9;
            for (int k = 0; k < 10'000; ++k) {
                const double angle = std::numbers::pi * k / 10'000.0;
                double low = 1e9;
                double high = -1e9;
                for (const Point& point : mainland[0].outer) {
                    const double y = std::cos(angle) * point.y - std::sin(angle) * point.x;
                    low = std::min(low, y);
                    high = std::max(high, y);
                }
                narrowest = std::min(narrowest, high - low);
            }
            const int atLeast = static_cast<int>(std::ceil(narrowest / 2.5 - 1e-3));
            const auto count = static_cast<int>(exact->swaths.size());
            QVERIFY(count <= atLeast);
            QVERIFY(count >= atLeast - 1);
        }
    }

    void otherObjectivesAreNotCalledProved() {
        const MultiPolygon field{test::rectangle(100.0, 60.0)};
        const auto byLength = test::swathsBy(kExactMethod, field, machineLibrary().front(), byObjective("swath-length"), {});
        QVERIFY(byLength.has_value());
        QVERIFY(!byLength->proved);
    }

    void rectangleIsWorkedAlongItsLongSide() {
        const MultiPolygon field{test::rectangle(100.0, 60.0)};
        const auto exact = test::swathsBy(kExactMethod, field, machineLibrary().front(), byObjective("swath-count"), {});
        QVERIFY(exact.has_value());
        // 60 m / 2.5 m
        QCOMPARE(exact->swaths.size(), std::size_t{24});
        QCOMPARE(inDegrees(exact->heading), 0.0);
        QVERIFY(exact->proved);
    }

    void hullAndItsWidth_data() {
        QTest::addColumn<QList<QPointF>>("points");
        QTest::addColumn<int>("corners");
        QTest::addColumn<double>("width");
        QTest::newRow("square with points inside and on edges")
            << QList<QPointF>{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {2, 3}} << 4 << 4.0;
        // Height on the hypotenuse of 3-4-5: 12/5.
        QTest::newRow("right triangle") << QList<QPointF>{{0, 0}, {4, 0}, {0, 3}} << 3 << 2.4;
        QTest::newRow("rectangle aslant") << QList<QPointF>{{0, 0}, {6, 8}, {2, 11}, {-4, 3}} << 4 << 5.0;
    }
    void hullAndItsWidth() {
        QFETCH(QList<QPointF>, points);
        QFETCH(int, corners);
        QFETCH(double, width);
        Ring ring;
        for (const QPointF& point : points) {
            ring.push_back({point.x(), point.y()});
        }
        const Ring hull = convexHull(ring);
        QCOMPARE(static_cast<int>(hull.size()), corners);
        QVERIFY(isConvex(hull));
        QCOMPARE(minimumWidth(hull).si(), width);
    }

    void stopsWhenAsked() {
        std::stop_source stop;
        stop.request_stop();
        const auto set = test::swathsBy(kExactMethod, {test::rectangle(100.0, 60.0)}, machineLibrary().front(), {},
                                          {.stop = stop.get_token()});
        QVERIFY(!set.has_value());
        QCOMPARE(set.error().code, ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(TestExactSearch)
#include "tst_exact_search.moc"
