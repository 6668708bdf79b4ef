#include "planner/benchmarks/paired_timing.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;

class PairedTimingTest : public QObject {
    Q_OBJECT

private slots:
    // A machine that is three times slower for a while: times differ, the ratio does not.
    void aSlowMachineSlowsBoth() {
        double nowS = 0.0;
        int turns = 0;
        const auto slowness = [&turns] { return turns >= 4 && turns < 8 ? 3.0 : 1.0; };
        const auto ours = [&] { nowS += 0.03 * slowness(); };
        const auto yardstick = [&] {
            nowS += 0.3 * slowness();
            ++turns;
        };
        const PairedTiming timing = timedInTurn(ours, yardstick, [&nowS] { return nowS; });
        QCOMPARE(turns, 7);
        QCOMPARE(timing.ours.runs, 7);
        QVERIFY(qAbs(timing.ours.least.si() - 0.03) < 1e-12);
        QVERIFY(qAbs(timing.ours.median.si() - 0.03) < 1e-12);
        QVERIFY(qAbs(timing.yardstick.value().median.si() - 0.3) < 1e-12);
        QVERIFY(qAbs(timing.ratio.value() - 10.0) < 1e-9);
    }

    // 1 ms of work is repeated 20 times in a turn.
    void shortWorkIsRepeated() {
        int runs = 0;
        double nowS = 0.0;
        const PairedTiming timing = timedInTurn(
            [&] {
                ++runs;
                nowS += 1.0 / 1024.0;
            },
            {}, [&nowS] { return nowS; });
        QCOMPARE(runs, 7 * 21);  // 20 / 1024 s are less than 20 ms
        QCOMPARE(timing.ours.runs, runs);
        QCOMPARE(timing.ours.median.si(), 1.0 / 1024.0);
        QVERIFY(!timing.yardstick.has_value());
        QVERIFY(!timing.ratio.has_value());
    }

    void clocksGoOn() {
        const double cpu = processorSeconds();
        const double wall = wallSeconds();
        volatile double sum = 0.0;
        while (processorSeconds() < cpu + 0.01) {
            sum = sum + 1.0;
        }
        QVERIFY(wallSeconds() >= wall + 0.009);
    }
};

FURROW_TEST(PairedTimingTest);
#include "tst_paired_timing.moc"
