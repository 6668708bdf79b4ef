#include "planner/decomposition/decomposition.h"
#include "planner/decomposition/history.h"
#include "planner/decomposition/joining.h"
#include "planner/geometry/geos_bridge.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QtTest/QtTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace furrow;

namespace {

const Machine& sprayer() {
    static const Machine machine = findMachine("trailed-sprayer").value();
    return machine;
}

/// A square with so many square holes in each row and column, 40 m apart.
MultiPolygon sieve(int holes) {
    MultiPolygon mainland{test::rectangle(40.0 * holes + 20.0, 40.0 * holes + 20.0)};
    for (int row = 0; row < holes; ++row) {
        for (int column = 0; column < holes; ++column) {
            // Not level with each other: each cuts by itself.
            Ring hole =
                test::rectangle(16.0, 16.0, {20.0 + 40.0 * column, 20.0 + 40.0 * row + 3.0 * column}).outer;
            std::ranges::reverse(hole);
            mainland.front().holes.push_back(std::move(hole));
        }
    }
    return mainland;
}

bool holds(const Polygon& polygon, Point point) {
    bool inside = false;
    forEachEdge({polygon}, [&](Point a, Point b) {
        if ((a.y > point.y) != (b.y > point.y) &&
            point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            inside = !inside;
        }
    });
    return inside;
}

Decomposition merged(const MultiPolygon& mainland, const SwathSet& swaths) {
    return kMergedCellsMethod
        .run({.mainland = mainland, .swaths = swaths, .machine = test::agbot(), .settings = {}}, {})
        .value();
}

}  // namespace

class CellCostTest : public QObject {
    Q_OBJECT

private slots:
    // Swaths 24 m apart running east. All turns lead to the neighbour, from an end right beside its own: half
    // a circle in two arcs, and between these what their middles are apart. The tractor is ahead of the
    // implement, so it turns in from twice that way farther.
    void byHand_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<int>("cells");
        QTest::addColumn<int>("turns");
        QTest::newRow("four swaths of a rectangle") << "POLYGON((0 0, 300 0, 300 96, 0 96, 0 0))" << 1 << 3;
        // Begun at the right: the step between long and short swaths is at the left, where they end together.
        QTest::newRow("an L") << "POLYGON((0 0, 300 0, 300 48, 150 48, 150 96, 0 96, 0 0))" << 1 << 3;
        // One below, two beside on each side, one above: west along the lowest, up on the left, east along
        // the highest, down on the right.
        QTest::newRow("round a square hole")
            << "POLYGON((0 0, 300 0, 300 96, 0 96, 0 0), (100 24, 100 72, 200 72, 200 24, 100 24))" << 4 << 5;
    }
    void byHand() {
        QFETCH(QString, wkt);
        QFETCH(int, cells);
        QFETCH(int, turns);
        const MultiPolygon mainland = test::polygonsFromWkt(wkt.toStdString());
        const SwathSet swaths = test::swathsOf(mainland, 24.0, 0.0);
        const auto cut = kBoustrophedonCellsMethod.run(
            {.mainland = mainland, .swaths = swaths, .machine = sprayer(), .settings = {}}, {});
        QCOMPARE(cut->cells.size(), static_cast<std::size_t>(cells));
        const double radius = sprayer().minTurningRadius().si();
        QVERIFY(24.0 > 2.0 * radius);
        const double turnM = std::numbers::pi * radius +
                             std::hypot(24.0 - 2.0 * radius, 2.0 * sprayer().spec().implement.offset.si()) +
                             sprayer().runIn().si();
        COMPARE_WITHIN(cut->history.steps.front().cost.si(), turns * turnM / sprayer().turningSpeed().si(),
                       1e-6);
    }

    // Nothing is saved by joining what is driven one after the other anyway: the freedom to drive it
    // otherwise is kept.
    void whatSavesNothingIsNotJoined() {
        const MultiPolygon mainland = test::polygonsFromWkt(
            "POLYGON((0 0, 300 0, 300 96, 0 96, 0 0), (100 24, 100 72, 200 72, 200 24, 100 24))");
        const SwathSet swaths = test::swathsOf(mainland, 24.0, 0.0);
        const auto found = kMergedCellsMethod.run(
            {.mainland = mainland, .swaths = swaths, .machine = sprayer(), .settings = {}}, {});
        QCOMPARE(found->cells.size(), std::size_t{4});
        QCOMPARE(found->history.steps.size(), std::size_t{1});
        QCOMPARE(found->history.pieces.size(), std::size_t{4});
    }

    void joiningPaysOff_data() {
        QTest::addColumn<MultiPolygon>("mainland");
        QTest::addColumn<double>("headingDeg");
        constexpr std::uint64_t kSeed = 9100;
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 12; ++i) {
            QTest::addRow("seed %llu, field %d", static_cast<unsigned long long>(kSeed), i)
                << test::randomPolygons(random, test::Shape::Holes, 150.0)
                << test::uniform(random, 0.0, 180.0);
        }
        QTest::newRow("nine holes") << sieve(3) << 0.0;
        QTest::newRow("sixteen holes, level") << sieve(4) << 0.0;
        QTest::newRow("sixteen holes, slanted") << sieve(4) << 31.0;
    }
    // Each step is quicker than the one before, its cells tile the mainland, and no further join would be
    // quicker.
    void joiningPaysOff() {
        QFETCH(MultiPolygon, mainland);
        QFETCH(double, headingDeg);
        const SwathSet swaths = test::swathsOf(mainland, 2.5, headingDeg);
        const Decomposition found = merged(mainland, swaths);
        const std::vector<DecompositionStep>& steps = found.history.steps;
        const double wholeM2 = area(mainland).si();
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (i > 0) {
                // Only what has no swaths is given away for nothing.
                const bool saves = steps[i].cost < steps[i - 1].cost;
                QVERIFY(saves || std::abs((steps[i].cost - steps[i - 1].cost).si()) < 1e-9);
                QCOMPARE(joinedAt(found.history, i, {})->size(), saves ? std::size_t{2} : std::size_t{0});
                QCOMPARE(steps[i].cells, steps[i - 1].cells - steps[i].joins.size());
            }
            const auto cells = outlinesAt(found.history, i, {});
            QCOMPARE(cells->size(), steps[i].cells);
            double sumM2 = 0.0;
            MultiPolygon all;
            for (const MultiPolygon& cell : *cells) {
                sumM2 += area(cell).si();
                std::ranges::copy(cell, std::back_inserter(all));
            }
            COMPARE_WITHIN(sumM2 / wholeM2, 1.0, 1e-6);
            COMPARE_WITHIN(area(unionOf(all, {}, kSnapGrid).value()).si() / wholeM2, 1.0, 1e-6);
        }
        QVERIFY(steps.back().cost <= steps.front().cost);
        QCOMPARE(steps.back().cells, found.cells.size());
        QCOMPARE(steps.back().altitude.si(), found.altitude.si());

        // Any two of the cells that have no line in common, as one.
        const Groups groups = cellsAt(found.history, steps.size() - 1);
        const MultiPolygon level = test::moved(found.history.pieces, -swaths.heading, {});
        std::vector<std::vector<std::size_t>> dealt(level.size());
        std::vector<std::set<int>> tracks(level.size());
        for (std::size_t swath = 0; swath < swaths.swaths.size(); ++swath) {
            const Swath& each = swaths.swaths[swath];
            const auto home = std::ranges::find_if(found.history.pieces, [&](const Polygon& piece) {
                return holds(piece, 0.5 * (each.start + each.end));
            });
            QVERIFY(home != found.history.pieces.end());
            const auto piece = static_cast<std::size_t>(home - found.history.pieces.begin());
            dealt[piece].push_back(swath);
            tracks[groups[piece]].insert(each.track);
        }
        const CellCost cost{swaths, test::agbot(), dealt};
        COMPARE_WITHIN(cost.of(groups).si(), steps.back().cost.si(), 1e-6);
        for (const Border& border : bordersOf(level)) {
            const std::size_t below = groups[border.below];
            const std::size_t above = groups[border.above];
            const bool areApart =
                below != above && !tracks[below].empty() && !tracks[above].empty() &&
                std::ranges::none_of(tracks[below], [&](int track) { return tracks[above].contains(track); });
            if (areApart) {
                Groups joined = groups;
                apply({.kept = std::min(below, above), .gone = std::max(below, above)}, joined);
                QVERIFY2(cost.of(joined).si() > steps.back().cost.si() - 2e-3,
                         qPrintable(QStringLiteral("%1 %2").arg(border.below).arg(border.above)));
            }
        }
    }

    void manyHolesAreJoined() {
        const MultiPolygon mainland = sieve(4);
        const Decomposition found = merged(mainland, test::swathsOf(mainland, 2.5, 0.0));
        // Every hole ends one cell and begins three: 1 + 3 × 16.
        QCOMPARE(found.history.pieces.size(), std::size_t{49});
        QVERIFY(found.cells.size() < 49);
        QVERIFY(found.history.steps.size() > 2);
        QVERIFY(found.history.steps.back().cost < found.history.steps.front().cost);
    }
};

FURROW_TEST(CellCostTest);
#include "tst_cell_cost.moc"
