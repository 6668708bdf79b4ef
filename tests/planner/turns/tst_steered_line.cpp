#include "planner/turns/steered_line.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <cmath>

using namespace furrow;

namespace {

/// 6 m of radius, 3 m of wheelbase, 20 degrees in a second, 1.8 m/s in turns.
MachineSpec tractorSpec() {
    MachineSpec spec;
    spec.tractor.wheelbase = metres(3.0);
    spec.tractor.minTurningRadius = metres(6.0);
    spec.tractor.steeringRateRadps = 20.0 * std::numbers::pi / 180.0;
    spec.tractor.turningSpeed = metresPerSecond(1.8);
    return spec;
}

Machine made(const MachineSpec& spec) {
    return Machine::create(spec).value();
}

CurvePiece piece(double lengthM, double from, double to, Gear gear = Gear::Forward) {
    return {.length = metres(lengthM),
            .curvature = Curvature::fromSi(from),
            .endCurvature = Curvature::fromSi(to),
            .gear = gear};
}

}  // namespace

class SteeredLineTest : public QObject {
    Q_OBJECT

private slots:
    /// atan(3 / 6) = 0.4636 rad of the wheels at 0.3491 rad/s: 1.3283 s to full lock, twice that from side to
    /// side. By the curvature rate of 0.3 1/m² at 1.5 m/s: 0.45 1/m in a second.
    void timeToSteer() {
        const Machine tractor = made(tractorSpec());
        const Curvature lock = Curvature::fromSi(1.0 / 6.0);
        COMPARE_WITHIN(tractor.steeringDuration({}, lock).si(), 1.32826, 1e-4);
        COMPARE_WITHIN(tractor.steeringDuration(-lock, lock).si(), 2.65652, 1e-4);
        COMPARE_WITHIN(tractor.steeringDuration(lock, {}).si(), 1.32826, 1e-4);
        QCOMPARE(tractor.steeringDuration(lock, lock).si(), 0.0);
        MachineSpec byRate = tractorSpec();
        byRate.tractor.maxCurvatureRate = CurvatureRate::fromSi(0.3);
        byRate.tractor.turningSpeed = metresPerSecond(1.5);
        COMPARE_WITHIN(made(byRate).steeringDuration({}, Curvature::fromSi(0.09)).si(), 0.2, 1e-9);
        // Neither given: to full lock in two seconds.
        MachineSpec plain = tractorSpec();
        plain.tractor.steeringRateRadps = std::nullopt;
        COMPARE_WITHIN(made(plain).steeringDuration({}, lock).si(), 2.0, 1e-9);
    }

    /// 1.32826 s at 1.8 m/s. A slower steering is bounded by 6 cm: sqrt(24 x 0.06 x 6) = 2.939 m.
    void windowToSteer() {
        COMPARE_WITHIN(steeringWindow(made(tractorSpec())).si(), 2.39087, 1e-4);
        MachineSpec slow = tractorSpec();
        slow.tractor.steeringRateRadps = 0.1;
        COMPARE_WITHIN(steeringWindow(made(slow)).si(), 2.93939, 1e-4);
    }

    /// The radius grows by w² / 20 R = 0.0476 m, and by no more than a twentieth.
    void reserveForTurns() {
        COMPARE_WITHIN(made(tractorSpec()).withSteeringReserve().minTurningRadius().si(), 6.04764, 1e-4);
        MachineSpec slow = tractorSpec();
        slow.tractor.steeringRateRadps = 0.02;
        COMPARE_WITHIN(made(slow).withSteeringReserve().minTurningRadius().si(), 6.3, 1e-9);
    }

    void placesToEase() {
        const Machine tractor = made(tractorSpec());
        const Curve arcs{.type = {},
                         .start = {},
                         .pieces = {piece(10.0, 0.0, 0.0), piece(4.0, 0.1, 0.1), piece(10.0, 0.0, 0.0)}};
        const std::vector<LineRange> jumps = jumpsOf(arcs, tractor);
        QCOMPARE(jumps.size(), 2U);
        QCOMPARE(jumps[0].fromM, 10.0);
        QCOMPARE(jumps[0].toM, 14.0);
        // Over the window from straight to full lock; then within a quarter of it.
        const double windowM = steeringWindow(tractor).si();
        const Curve gradual{
            .type = {}, .start = {}, .pieces = {piece(5.0, 0.0, 0.0), piece(windowM, 0.0, 1.0 / 6.0)}};
        QVERIFY(jumpsOf(gradual, tractor).empty());
        const Curve steep{
            .type = {}, .start = {}, .pieces = {piece(5.0, 0.0, 0.0), piece(0.25 * windowM, 0.0, 1.0 / 6.0)}};
        QCOMPARE(jumpsOf(steep, tractor).size(), 1U);
    }

    /// A ring of four straights of 30 m and four quarter circles of 6 m, begun at the end of a bend.
    void aRingIsEasedRoundItsBeginning() {
        const Machine tractor = made(tractorSpec());
        const double bendM = 3.0 * std::numbers::pi;
        Curve ring{.type = {}, .start = {}, .pieces = {}};
        for (int i = 0; i < 4; ++i) {
            ring.pieces.push_back(piece(30.0, 0.0, 0.0));
            ring.pieces.push_back(piece(bendM, 1.0 / 6.0, 1.0 / 6.0));
        }
        const Curve steered = steeredRing(ring, tractor, [](Point) { return false; });
        QVERIFY(jumpsOf(steered, tractor).empty());
        QVERIFY(distance(steered.start.position, steered.end().position) < 1e-5);
        // One corner stays as it is, with its two jumps.
        const Curve cornered =
            steeredRing(ring, tractor, [](Point place) { return distance(place, {36.0, 0.0}) < 8.0; });
        QCOMPARE(jumpsOf(cornered, tractor).size(), 2U);
    }

    void windowsAreChangedInParts() {
        SteeringWindows windows{metres(100.0)};
        windows.set({20.0, 60.0}, metres(4.0));
        windows.widen({50.0, 80.0}, metres(2.0));
        const auto at = [&](double m) { return windows.windows().at(m); };
        QCOMPARE(at(10.0), 0.0);
        QCOMPARE(at(40.0), 4.0);
        QCOMPARE(at(55.0), 4.0);
        QCOMPARE(at(70.0), 2.0);
        // It grows by no more than the way.
        COMPARE_WITHIN(at(21.5), 1.5, 1e-12);
        windows.shrink({35.0, 45.0}, metres(4.0));
        QCOMPARE(at(40.0), 2.0);
        windows.shrink({35.0, 45.0}, metres(4.0));
        QCOMPARE(at(40.0), 1.0);
        windows.shrink({35.0, 45.0}, metres(4.0));
        QCOMPARE(at(40.0), AveragingWindows::kKeptM);
        windows.shrink({35.0, 45.0}, metres(4.0));
        QCOMPARE(at(40.0), 0.0);
        // Beyond the ends, and the wrong way round.
        windows.set({-5.0, 2.0}, metres(3.0));
        windows.set({99.0, 120.0}, metres(3.0));
        windows.set({130.0, 120.0}, metres(3.0));
        COMPARE_WITHIN(at(1.0), 1.0, 1e-12);
        COMPARE_WITHIN(at(99.5), 0.5, 1e-12);
    }
};

FURROW_TEST(SteeredLineTest);
#include "tst_steered_line.moc"
