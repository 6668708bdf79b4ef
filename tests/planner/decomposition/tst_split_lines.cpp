#include "planner/decomposition/split_lines.h"

#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QtTest/QtTest>

using namespace furrow;

class SplitLinesTest : public QObject {
    Q_OBJECT

private slots:
    // Across 60 m, from 10 m below: 8 m short of the upper edge.
    void aLineThatFallsShortIsDrawnOnOrTold_data() {
        QTest::addColumn<double>("mostM");
        QTest::addColumn<bool>("isDrawnOn");
        QTest::newRow("within an operating width") << 8.5 << true;
        QTest::newRow("by more") << 7.5 << false;
    }
    void aLineThatFallsShortIsDrawnOnOrTold() {
        QFETCH(double, mostM);
        QFETCH(bool, isDrawnOn);
        const Polyline line{{50.0, -10.0}, {50.0, 52.0}};
        const SplitLines made = drawnThrough({line}, {test::rectangle(100.0, 60.0)}, metres(mostM));
        if (isDrawnOn) {
            QVERIFY(made.faults.empty());
            QCOMPARE(made.lines.front().front(), line.front());
            COMPARE_WITHIN(made.lines.front().back().x, 50.0, 1e-9);
            COMPARE_WITHIN(made.lines.front().back().y, 60.0, 0.01);
            QVERIFY(made.lines.front().back().y > 60.0);
        } else {
            QCOMPARE(made.lines.front(), line);
            QCOMPARE(made.faults.size(), std::size_t{1});
            QCOMPARE(made.faults.front().place, line.back());
            COMPARE_WITHIN(made.faults.front().missing->si(), 8.0, 1e-9);
        }
    }

    // Both ends inside, 20 m from the lower edge and 30 m from the upper one: the longer way is told.
    void theFartherEndIsTold() {
        const SplitLines made =
            drawnThrough({{{50.0, 20.0}, {50.0, 30.0}}}, {test::rectangle(100.0, 60.0)}, metres(6.0));
        QCOMPARE(made.faults.size(), std::size_t{1});
        COMPARE_WITHIN(made.faults.front().missing->si(), 30.0, 1e-9);
    }

    // Slanting, the way is along the line: 3-4-5.
    void theWayIsAlongTheLine() {
        const SplitLines made =
            drawnThrough({{{10.0, -4.0}, {25.0, 16.0}}}, {test::rectangle(100.0, 20.0)}, metres(1.0));
        QCOMPARE(made.faults.size(), std::size_t{1});
        COMPARE_WITHIN(made.faults.front().missing->si(), 5.0, 1e-9);
    }

    void aLineOutsideIsTold() {
        const SplitLines made = drawnThrough({{{-50.0, 70.0}, {150.0, 70.0}}, {{50.0, -10.0}, {50.0, 70.0}}},
                                             {test::rectangle(100.0, 60.0)}, metres(6.0));
        QCOMPARE(made.faults.size(), std::size_t{1});
        QCOMPARE(made.faults.front().line, std::size_t{0});
        QVERIFY(!made.faults.front().missing);
    }

    // The second one ends 3 m before the first, or on it.
    void linesMayEndOnEachOther() {
        const Polyline through{{50.0, -10.0}, {50.0, 70.0}};
        const SplitLines near = drawnThrough({through, {{-10.0, 30.0}, {47.0, 30.0}}},
                                             {test::rectangle(100.0, 60.0)}, metres(6.0));
        QVERIFY(near.faults.empty());
        COMPARE_WITHIN(near.lines[1].back().x, 50.0, 0.01);
        const SplitLines on = drawnThrough({through, {{-10.0, 30.0}, {50.0, 30.0}}},
                                           {test::rectangle(100.0, 60.0)}, metres(6.0));
        QVERIFY(on.faults.empty());
        QCOMPARE(on.lines[1].size(), std::size_t{2});
    }

    // A ring inside cuts out an island.
    void aRingIsWhole() {
        const SplitLines made = drawnThrough({{{40.0, 20.0}, {60.0, 20.0}, {60.0, 40.0}, {40.0, 20.0}}},
                                             {test::rectangle(100.0, 60.0)}, metres(6.0));
        QVERIFY(made.faults.empty());
    }
};

FURROW_TEST(SplitLinesTest);
#include "tst_split_lines.moc"
