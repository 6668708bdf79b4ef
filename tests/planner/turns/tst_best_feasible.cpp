// The quickest turn that fits: never slower than what it is chosen from, and inside where there is little
// room.

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace furrow;

namespace {

constexpr double kForwardMps = 1.5;
constexpr double kReverseMps = 1.0;
constexpr double kAccelerationMps2 = 0.5;

/// 2.5 m wide, 3 m ahead of its axle, the implement 2 m behind it.
MachineSpec specOf(double radiusM) {
    MachineSpec spec;
    spec.tractor.width = metres(2.0);
    spec.tractor.length = metres(4.0);
    spec.tractor.rearOverhang = metres(1.0);
    spec.tractor.minTurningRadius = metres(radiusM);
    spec.tractor.turningSpeed = metresPerSecond(kForwardMps);
    spec.tractor.reverseSpeed = metresPerSecond(kReverseMps);
    spec.tractor.maxAcceleration = Acceleration::fromSi(kAccelerationMps2);
    spec.tractor.maxLateralAcceleration = Acceleration::fromSi(20.0);
    spec.implement.operatingWidth = metres(2.5);
    spec.implement.offset = metres(-2.0);
    spec.implement.length = metres(1.0);
    return spec;
}

Machine machineOf(double radiusM, bool reverses = true) {
    MachineSpec spec = specOf(radiusM);
    spec.tractor.canReverse = reverses;
    return Machine::create(spec).value();
}

/// By hand: way by speed, and for each change of gear what is lost by braking from the one speed and speeding
/// up to the other: v / a for a way that takes half of that at full speed.
double secondsOf(const Curve& turn) {
    double sum = 0.0;
    for (std::size_t i = 0; i < turn.pieces.size(); ++i) {
        const CurvePiece& piece = turn.pieces[i];
        sum += piece.length.si() / (piece.gear == Gear::Forward ? kForwardMps : kReverseMps);
        if (i > 0 && turn.pieces[i - 1].gear != piece.gear) {
            sum += (kForwardMps + kReverseMps) / (2.0 * kAccelerationMps2);
        }
    }
    return sum;
}

bool reverses(const Curve& turn) {
    return std::ranges::any_of(turn.pieces,
                               [](const CurvePiece& piece) { return piece.gear == Gear::Reverse; });
}

/// Whether the raised machine stays inside, give or take a centimetre, looked at every 5 cm.
bool fits(const Curve& turn, const MultiPolygon& inside, const Machine& machine) {
    const PreparedArea area{dilated(inside, metres(0.01), metres(0.001), {}).value()};
    Pose pose = turn.start;
    for (const CurvePiece& piece : turn.pieces) {
        const int steps = 1 + static_cast<int>(piece.length.si() / 0.05);
        for (int i = 0; i <= steps; ++i) {
            Ring outline = placed(machine.turningFootprint(),
                                  advanced(pose, piece, piece.length * (static_cast<double>(i) / steps)));
            outline.push_back(outline.front());
            if (!area.covers({outline})) {
                return false;
            }
        }
        pose = advanced(pose, piece, piece.length);
    }
    return true;
}

}  // namespace

class BestFeasibleTest : public QObject {
    Q_OBJECT

private slots:
    void inTheOpen_data() {
        QTest::addColumn<bool>("reverses");
        QTest::addColumn<bool>("swaths");
        for (const bool reverses : {false, true}) {
            for (const bool swaths : {false, true}) {
                QTest::addRow("%s, %s", reverses ? "both gears" : "forwards", swaths ? "swaths" : "any poses")
                    << reverses << swaths;
            }
        }
    }
    void inTheOpen() {
        QFETCH(bool, reverses);
        QFETCH(bool, swaths);
        const MultiPolygon open{test::centredRectangle(4000.0, 4000.0)};
        constexpr std::uint64_t kSeed = 8100;
        std::mt19937_64 random{kSeed};
        int backwards = 0;
        for (int i = 0; i < 300; ++i) {
            const test::PosePair pair = swaths ? test::swathPair(random) : test::randomPair(random);
            const QByteArray told = test::told(kSeed, i, pair);
            const Machine machine = machineOf(pair.radiusM, reverses);
            const auto quickestBy = [&](Length radius) {
                const double forwardsS = secondsOf(dubinsTurn(pair.from, pair.to, radius));
                return reverses ? std::min(forwardsS, secondsOf(reedsSheppTurn(pair.from, pair.to, radius)))
                                : forwardsS;
            };
            const std::pair<Curve, double> turns[] = {
                {kBestFeasibleMethod.run(pair.from, pair.to, machine), quickestBy(metres(pair.radiusM))},
                // With the reserve for steering.
                {feasibleConnection(Rig{open, machine}, pair.from, pair.to, {}, {}),
                 quickestBy(machine.withSteeringReserve().minTurningRadius())}};
            for (const auto& [turn, quickestS] : turns) {
                const Pose end = test::driven(turn);
                VERIFY_TOLD(distance(turn.start.position, pair.from.position) < 1e-9, told);
                VERIFY_TOLD(
                    distance(end.position, pair.to.position) < 1e-6 && test::headingGap(end, pair.to) < 1e-6,
                    told);
                VERIFY_TOLD(secondsOf(turn) <= quickestS + 1e-6,
                            told + " " + turn.type.data() + " " + QByteArray::number(secondsOf(turn)) +
                                " s, not " + QByteArray::number(quickestS));
                VERIFY_TOLD(reverses || !::reverses(turn), told);
                backwards += ::reverses(turn) ? 1 : 0;
            }
        }
        QCOMPARE(backwards > 0, reverses);
    }

    // From one swath to the next, 2.5 m beside it, in a strip of a width between the swaths' ends and the
    // edge.
    void inANarrowHeadland_data() {
        QTest::addColumn<double>("depthM");
        QTest::addColumn<bool>("reverses");
        QTest::addColumn<bool>("dubinsFits");
        // Dubins' turn between swaths 2.5 m apart with a radius of 4 m is a bulb: the middle of its large arc
        // lies sqrt(8² - (4 + 1.25)²) = 6.04 m ahead, and the nose's outer corner goes round it at hypot(3, 4
        // + 1) = 5.83 m.
        QTest::newRow("wide") << 12.0 << true << true;
        QTest::newRow("wide, forwards") << 12.0 << false << true;
        QTest::newRow("too narrow for a bulb") << 10.0 << true << false;
        QTest::newRow("one and a half radii") << 7.0 << true << false;
        QTest::newRow("hardly more than a radius") << 5.5 << true << false;
    }
    void inANarrowHeadland() {
        QFETCH(double, depthM);
        QFETCH(bool, reverses);
        QFETCH(bool, dubinsFits);
        const Machine machine = machineOf(4.0, reverses);
        const MultiPolygon inside{test::rectangle(60.0, 50.0)};
        const Rig rig{inside, machine};
        const Pose from = test::pose(30.0, 50.0 - depthM, 90.0);
        const Pose to = test::pose(32.5, 50.0 - depthM, -90.0);
        QCOMPARE(fits(dubinsTurn(from, to, metres(4.0)), inside, machine), dubinsFits);
        const Curve turn = feasibleConnection(rig, from, to, {}, {});
        const Pose end = test::driven(turn);
        QVERIFY(distance(end.position, to.position) < 1e-6 && test::headingGap(end, to) < 1e-6);
        QVERIFY2(fits(turn, inside, machine), turn.type.data());
        QVERIFY(reverses || !::reverses(turn));
        QCOMPARE(feasibleConnection(rig, from, to, {}, {}), turn);
    }

    // What cannot reverse and has no room leaves the field: the quickest turn of free space, so that it can
    // be told.
    void whereNothingFits() {
        const Machine machine = machineOf(4.0, false);
        const MultiPolygon strip{test::rectangle(40.0, 6.0)};
        const Pose from = test::pose(20.0, 2.0, 0.0);
        const Pose to = test::pose(20.0, 4.0, 180.0);
        const Curve turn = feasibleConnection(Rig{strip, machine}, from, to, {}, {});
        QVERIFY(!fits(turn, strip, machine));
        QVERIFY(secondsOf(turn) <= secondsOf(dubinsTurn(from, to, metres(4.0))) + 1e-6);
    }

    // A machine that can turns on the spot where that is quicker. Its outer wheel is 1 m from the middle: a
    // quarter turn takes 2 sqrt(pi / 2 / 0.5) = 3.54 s. To a swath 2.5 m beside it takes 7.09 + 2.5 / 1.5 =
    // 8.76 s, a bulb of 26.2 m at 1.5 m/s 17.5 s. To one 20 m away it takes 20.4 s, a U of 24.6 m 16.4 s.
    void onTheSpot_data() {
        QTest::addColumn<double>("awayM");
        QTest::addColumn<bool>("can");
        QTest::addColumn<bool>("trailed");
        QTest::addColumn<bool>("turns");
        QTest::newRow("next swath") << 2.5 << true << false << true;
        QTest::newRow("far swath") << 20.0 << true << false << false;
        QTest::newRow("cannot") << 2.5 << false << false << false;
        QTest::newRow("pulls an implement") << 2.5 << true << true << false;
    }
    void onTheSpot() {
        QFETCH(double, awayM);
        QFETCH(bool, can);
        QFETCH(bool, trailed);
        QFETCH(bool, turns);
        MachineSpec spec = specOf(4.0);
        spec.tractor.canTurnInPlace = can;
        if (trailed) {
            spec.implement.mounting = Mounting::Trailed;
            spec.implement.hitchOffset = metres(-1.5);
            spec.implement.offset = metres(-4.0);
        }
        const Machine machine = Machine::create(spec).value();
        const MultiPolygon open{test::centredRectangle(400.0, 400.0)};
        const Pose from = test::pose(0.0, 0.0, 90.0);
        const Pose to = test::pose(awayM, 0.0, -90.0);
        QCOMPARE(kBestFeasibleMethod.run(from, to, machine).type == "straight", turns);
        const Curve turn = feasibleConnection(Rig{open, machine}, from, to, {}, {});
        QCOMPARE(turn.type == "straight", turns);
        QVERIFY(distance(turn.end().position, to.position) < 1e-6);
    }

    // The nose's corners go round at hypot(3, 1) = 3.16 m.
    void roomToTurnOnTheSpot_data() {
        QTest::addColumn<double>("depthM");
        QTest::addColumn<bool>("turns");
        QTest::newRow("corners swing out") << 3.1 << false;
        QTest::newRow("corners pass") << 3.2 << true;
    }
    void roomToTurnOnTheSpot() {
        QFETCH(double, depthM);
        QFETCH(bool, turns);
        MachineSpec spec = specOf(4.0);
        spec.tractor.canTurnInPlace = true;
        const Machine machine = Machine::create(spec).value();
        const MultiPolygon inside{test::rectangle(60.0, 50.0)};
        const Pose from = test::pose(30.0, 50.0 - depthM, 90.0);
        const Pose to = test::pose(32.5, 50.0 - depthM, -90.0);
        const Curve turn = feasibleConnection(Rig{inside, machine}, from, to, {}, {});
        QCOMPARE(turn.type == "straight", turns);
    }

    // Round a block in the way, and straight on for the implement's run-in before it is lowered.
    void roundABlockWithARunIn() {
        MachineSpec spec = specOf(4.0);
        spec.implement.runIn = metres(3.0);
        const Machine machine = Machine::create(spec).value();
        MultiPolygon inside{test::rectangle(80.0, 60.0)};
        inside.front().holes.push_back({{30, 20}, {30, 40}, {50, 40}, {50, 20}});
        const Pose from = test::pose(20.0, 30.0, 0.0);
        const Pose to = test::pose(65.0, 30.0, 0.0);
        const Curve turn = feasibleConnection(Rig{inside, machine}, from, to, {}, {});
        QCOMPARE(turn.type, kCombinedTurn);
        QVERIFY(fits(turn, inside, machine));
        const Pose end = test::driven(turn);
        QVERIFY(distance(end.position, to.position) < 1e-6 && test::headingGap(end, to) < 1e-6);
        const CurvePiece& last = turn.pieces.back();
        QVERIFY(last.curvature == Curvature{} && last.gear == Gear::Forward && last.length >= metres(3.0));
    }
};

FURROW_TEST(BestFeasibleTest);
#include "tst_best_feasible.moc"
