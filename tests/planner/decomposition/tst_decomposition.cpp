#include "planner/decomposition/decomposition.h"

#include "planner/geometry/geos_bridge.h"
#include "planner/machine/machine_library.h"
#include "planner/swaths/methods.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QtTest/QtTest>

#include <algorithm>
#include <numeric>
#include <set>

using namespace furrow;

namespace {

const Method<Decomposer>* const kAll[] = {&kOnePieceMethod, &kTrapezoidalMethod, &kBoustrophedonCellsMethod,
                                          &kMergedCellsMethod};

Machine agbot() {
    return findMachine("agbot").value();
}

SwathSet levelSwaths(const MultiPolygon& mainland, double headingDeg) {
    Settings settings;
    settings.setText(kAngle, std::to_string(headingDeg)).value();
    return test::swathsBy(kFixedHeadingMethod, mainland, agbot(), settings).value();
}

Result<Decomposition> cellsBy(const Method<Decomposer>& method, const MultiPolygon& mainland,
                              const SwathSet& swaths, const JobContext& job = {}) {
    return method.run({.mainland = mainland, .swaths = swaths, .machine = agbot(), .settings = {}}, job);
}

}  // namespace

class DecompositionTest : public QObject {
    Q_OBJECT

private slots:
    // Counted and measured by hand, swaths running east.
    void byHand_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<int>("trapezoids");
        QTest::addColumn<int>("cells");
        QTest::newRow("a rectangle") << "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0))" << 1 << 1;
        // A corner of the outline half-way up cuts a trapezoid, but a line across meets it in one piece.
        QTest::newRow("a hexagon") << "POLYGON((0 0, 100 0, 120 30, 100 60, 0 60, -20 30, 0 0))" << 2 << 1;
        // Below, beside on both sides, above.
        QTest::newRow("a square hole")
            << "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0), (40 20, 40 40, 60 40, 60 20, 40 20))" << 4 << 4;
        QTest::newRow("a diamond hole")
            << "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0), (50 20, 40 30, 50 40, 60 30, 50 20))" << 6 << 4;
        // A U open to the north: the base and two arms.
        QTest::newRow("a U") << "POLYGON((0 0, 100 0, 100 60, 70 60, 70 20, 30 20, 30 60, 0 60, 0 0))" << 3
                             << 3;
        // An L: a line across never meets it twice.
        QTest::newRow("an L") << "POLYGON((0 0, 100 0, 100 30, 40 30, 40 60, 0 60, 0 0))" << 2 << 1;
        // Two holes side by side: below, left, between, right, above.
        QTest::newRow("two holes side by side")
            << "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0), (20 20, 20 40, 30 40, 30 20, 20 20), "
               "(70 20, 70 40, 80 40, 80 20, 70 20))"
            << 5 << 5;
        // One above the other: below, two beside, between, two beside, above.
        QTest::newRow("two holes, one above the other")
            << "POLYGON((0 0, 100 0, 100 90, 0 90, 0 0), (40 20, 40 40, 60 40, 60 20, 40 20), "
               "(40 60, 40 80, 60 80, 60 60, 40 60))"
            << 7 << 7;
        QTest::newRow("two parts")
            << "MULTIPOLYGON(((0 0, 50 0, 50 60, 0 60, 0 0)), ((60 0, 90 0, 90 60, 60 60, 60 0)))" << 2 << 2;
    }
    void byHand() {
        QFETCH(QString, wkt);
        QFETCH(int, trapezoids);
        QFETCH(int, cells);
        const MultiPolygon mainland = test::polygonsFromWkt(wkt.toStdString());
        const SwathSet swaths = levelSwaths(mainland, 0.0);
        QCOMPARE(cellsBy(kTrapezoidalMethod, mainland, swaths)->cells.size(),
                 static_cast<std::size_t>(trapezoids));
        QCOMPARE(cellsBy(kBoustrophedonCellsMethod, mainland, swaths)->cells.size(),
                 static_cast<std::size_t>(cells));
        // So few are driven in the quickest order either way: no join saves anything.
        QCOMPARE(cellsBy(kMergedCellsMethod, mainland, swaths)->cells.size(),
                 static_cast<std::size_t>(cells));
        QCOMPARE(cellsBy(kOnePieceMethod, mainland, swaths)->cells.size(), std::size_t{1});
    }

    // The headland round a square pond has round corners: along the swaths there is one cell below, one above
    // and one on either side, as of a sharp one; turned, each of its corners cuts once, as of the diamond.
    void roundedCornersAreOneCornerEach_data() {
        QTest::addColumn<double>("turnDeg");
        QTest::addColumn<double>("roundM");
        QTest::addColumn<int>("trapezoids");
        for (const double roundM : {0.0, 3.0, 15.0, 60.0}) {
            QTest::addRow("aligned, %g m", roundM) << 0.0 << roundM << 4;
            QTest::addRow("by 30 degrees, %g m", roundM) << 30.0 << roundM << 6;
            QTest::addRow("by 45 degrees, %g m", roundM) << 45.0 << roundM << 6;
        }
    }
    void roundedCornersAreOneCornerEach() {
        QFETCH(double, turnDeg);
        QFETCH(double, roundM);
        QFETCH(int, trapezoids);
        const MultiPolygon pond =
            test::moved({test::centredRectangle(40.0, 40.0)}, degrees(turnDeg), {200.0, 125.0});
        const auto around =
            roundM > 0.0 ? dilated(pond, metres(roundM), kArcTolerance, {}) : Result<MultiPolygon>{pond};
        const MultiPolygon mainland = difference({test::rectangle(400.0, 250.0)}, *around, {}).value();
        const SwathSet swaths = levelSwaths(mainland, 0.0);
        QCOMPARE(cellsBy(kTrapezoidalMethod, mainland, swaths)->cells.size(),
                 static_cast<std::size_t>(trapezoids));
        QCOMPARE(cellsBy(kBoustrophedonCellsMethod, mainland, swaths)->cells.size(), std::size_t{4});
    }

    // A round pond has no corners but where it begins and ends; turned, the rectangle around it has two more.
    void aCircleHasNoCorners() {
        const auto pond = dilated({test::centredRectangle(0.1, 0.1)}, metres(40.0), kArcTolerance, {});
        const MultiPolygon mainland = difference({test::centredRectangle(400.0, 250.0)}, *pond, {}).value();
        QCOMPARE(cellsBy(kTrapezoidalMethod, mainland, levelSwaths(mainland, 12.3))->cells.size(),
                 std::size_t{6});
        QCOMPARE(cellsBy(kTrapezoidalMethod, mainland, levelSwaths(mainland, 0.0))->cells.size(),
                 std::size_t{4});
    }

    // The square hole: 20 m below, twice 20 m beside, 20 m above.
    void altitudeByHand() {
        const MultiPolygon mainland = test::polygonsFromWkt(
            "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0), (40 20, 40 40, 60 40, 60 20, 40 20))");
        const SwathSet swaths = levelSwaths(mainland, 0.0);
        COMPARE_WITHIN(cellsBy(kBoustrophedonCellsMethod, mainland, swaths)->altitude.si(), 80.0, 1e-6);
        COMPARE_WITHIN(cellsBy(kMergedCellsMethod, mainland, swaths)->altitude.si(), 80.0, 1e-6);
        COMPARE_WITHIN(cellsBy(kOnePieceMethod, mainland, swaths)->altitude.si(), 60.0, 1e-6);
    }

    void tilesTheMainland_data() {
        QTest::addColumn<int>("shape");
        for (const test::Shape shape : test::kShapes) {
            QTest::addRow("%s", test::shapeName(shape).data()) << static_cast<int>(shape);
        }
    }
    void tilesTheMainland() {
        QFETCH(int, shape);
        constexpr std::uint64_t kSeed = 7300;
        std::mt19937_64 random{kSeed + static_cast<std::uint64_t>(shape)};
        for (int i = 0; i < 25; ++i) {
            const MultiPolygon mainland =
                test::randomPolygons(random, static_cast<test::Shape>(shape), 100.0);
            const SwathSet swaths = levelSwaths(mainland, test::uniform(random, 0.0, 180.0));
            for (const auto* method : kAll) {
                const QByteArray told = QStringLiteral("seed %1, field %2, %3")
                                            .arg(kSeed)
                                            .arg(i)
                                            .arg(QLatin1String{method->info.id.data()})
                                            .toUtf8();
                const auto found = cellsBy(*method, mainland, swaths);
                VERIFY_TOLD(found.has_value(), told);
                double sumM2 = 0.0;
                MultiPolygon all;
                std::multiset<std::size_t> dealt;
                for (const Cell& cell : found->cells) {
                    sumM2 += area(cell.outline).si();
                    std::ranges::copy(cell.outline, std::back_inserter(all));
                    dealt.insert(cell.swaths.begin(), cell.swaths.end());
                    VERIFY_TOLD(std::ranges::is_sorted(cell.swaths), told);
                }
                const double wholeM2 = area(mainland).si();
                VERIFY_TOLD(std::abs(sumM2 / wholeM2 - 1.0) < 1e-6,
                            told + QByteArray::number(sumM2 / wholeM2 - 1.0));
                // No overlap: together they are no less than one by one.
                VERIFY_TOLD(std::abs(area(unionOf(all, {}, kSnapGrid).value()).si() / wholeM2 - 1.0) < 1e-6,
                            told);
                VERIFY_TOLD(dealt.size() == swaths.swaths.size() &&
                                std::set<std::size_t>(dealt.begin(), dealt.end()).size() == dealt.size(),
                            told);
                if (method == &kOnePieceMethod) {
                    continue;
                }
                // A line along the heading meets a cell once: no two swaths of a cell are cut from one line.
                for (const Cell& cell : found->cells) {
                    std::set<int> tracks;
                    for (const std::size_t swath : cell.swaths) {
                        VERIFY_TOLD(tracks.insert(swaths.swaths[swath].track).second, told);
                    }
                }
            }
        }
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const MultiPolygon mainland = test::polygonsFromWkt(
            "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0), (40 20, 40 40, 60 40, 60 20, 40 20))");
        const SwathSet swaths = levelSwaths(mainland, 0.0);
        for (const auto* method : kAll) {
            const auto found = cellsBy(*method, mainland, swaths, {.stop = stop.get_token()});
            QVERIFY(!found);
            QCOMPARE(found.error().code, ErrorCode::Cancelled);
        }
    }
};

FURROW_TEST(DecompositionTest);
#include "tst_decomposition.moc"
