#include "planner/audit/kinematics.h"
#include "planner/path/speed_profile.h"
#include "planner/path/steerable_legs.h"
#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"
#include "planner/turns/steered_line.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <cmath>
#include <random>

using namespace furrow;

namespace {

MachineSpec tractorSpec() {
    MachineSpec spec;
    spec.tractor.wheelbase = metres(3.0);
    spec.tractor.minTurningRadius = metres(6.0);
    spec.tractor.steeringRateRadps = 20.0 * std::numbers::pi / 180.0;
    spec.tractor.workingSpeed = metresPerSecond(3.0);
    spec.tractor.turningSpeed = metresPerSecond(1.8);
    spec.tractor.maxAcceleration = Acceleration::fromSi(0.5);
    return spec;
}

Machine tractor() {
    return Machine::create(tractorSpec()).value();
}

CurvePiece piece(double lengthM, double from, double to, Gear gear = Gear::Forward) {
    return {.length = metres(lengthM),
            .curvature = Curvature::fromSi(from),
            .endCurvature = Curvature::fromSi(to),
            .gear = gear};
}

Leg leg(SegmentKind kind, const Curve& line) {
    return {.kind = kind, .number = 1, .line = line, .implementDown = kind != SegmentKind::Turn};
}

/// Swath, turn, swath.
std::vector<Leg> legsBetween(const Pose& from, const Curve& turn, const Pose& to) {
    Curve before{.type = {}, .start = from, .pieces = {piece(30.0, 0.0, 0.0)}};
    before.start.position = from.position - 30.0 * direction(from.heading.si());
    const Curve after{.type = {}, .start = to, .pieces = {piece(30.0, 0.0, 0.0)}};
    return {leg(SegmentKind::Swath, before), leg(SegmentKind::Turn, turn), leg(SegmentKind::Swath, after)};
}

MultiPolygon wideArea() {
    return {test::centredRectangle(400.0, 400.0)};
}

/// Steps in which the steering would have to be faster, from time and curvature of the samples alone. A
/// sample has the curvature after it. Where the machine stands it steers before it goes on.
int tooFast(const Path& path, const Machine& machine) {
    int count = 0;
    const PathSample* before = nullptr;
    for (const PathSegment& segment : path.segments) {
        for (const PathSample& sample : segment.samples) {
            const bool drives = before != nullptr && sample.sM > before->sM + 1e-9;
            if (drives && before->speedMps > 0.0 && sample.speedMps > 0.0) {
                const double needsS = machine
                                          .steeringDuration(Curvature::fromSi(before->curvature1pm),
                                                            Curvature::fromSi(sample.curvature1pm))
                                          .si();
                count += needsS > 1.001 * (sample.tS - before->tS) + 1e-6 ? 1 : 0;
            }
            before = &sample;
        }
    }
    return count;
}

}  // namespace

class SteerableLegsTest : public QObject {
    Q_OBJECT

private slots:
    /// A straight and an arc on full lock: the machine stops where they meet, and steers for 1.32826 s. It
    /// brakes from 3 to 0 m/s over 9 m.
    void whereTheCurvatureJumpsTheMachineStops() {
        const Curve line{
            .type = {}, .start = {}, .pieces = {piece(30.0, 0.0, 0.0), piece(10.0, 1.0 / 6.0, 1.0 / 6.0)}};
        const std::vector<Leg> legs{leg(SegmentKind::Swath, line)};
        const Path path = withSpeeds(legs, tractor());
        const auto& samples = path.segments.front().samples;
        const auto stop = std::ranges::find_if(
            samples, [](const PathSample& sample) { return std::abs(sample.sM - 30.0) < 1e-9; });
        QVERIFY(stop != samples.end());
        QCOMPARE(stop->speedMps, 0.0);
        // Away from the stop with 0.5 m/s²: s = t² / 4.
        const PathSample& next = *(stop + 1);
        COMPARE_WITHIN(next.tS - stop->tS, 1.32826 + std::sqrt(4.0 * (next.sM - stop->sM)), 1e-3);
    }

    /// From straight to full lock over 2 m.
    void whereItChangesTheSteeringSetsTheSpeed() {
        const Curve line{
            .type = {},
            .start = {},
            .pieces = {piece(30.0, 0.0, 0.0), piece(2.0, 0.0, 1.0 / 6.0), piece(30.0, 1.0 / 6.0, 1.0 / 6.0)}};
        const std::vector<Leg> legs{leg(SegmentKind::Swath, line)};
        const Path path = withSpeeds(legs, tractor());
        double slowest = 10.0;
        for (const PathSample& sample : path.segments.front().samples) {
            if (sample.sM > 30.0 && sample.sM < 32.0) {
                slowest = std::min(slowest, sample.speedMps);
            }
        }
        // With the wheels straight 0.349066 rad/s / 3 m = 0.116355 1/m in a second, of 0.083333 1/m in a
        // metre.
        COMPARE_WITHIN(slowest, 0.116355 / 0.0833333, 0.005);
        QCOMPARE(tooFast(path, tractor()), 0);
    }

    /// Small steps of the curvature right before the machine stops to change gear: braking leaves the
    /// steering its time at each.
    void brakingAcrossSmallJumps_data() {
        QTest::addColumn<double>("lastM");
        for (const double lastM : {0.05, 0.1, 0.2, 0.27, 0.4, 1.0}) {
            QTest::addRow("%.2f m", lastM) << lastM;
        }
    }
    void brakingAcrossSmallJumps() {
        QFETCH(double, lastM);
        const Curve line{
            .type = {},
            .start = {},
            .pieces = {piece(8.0, 0.0025, 0.0025), piece(0.2, 1.0 / 48.0, 1.0 / 48.0),
                       piece(lastM, 1.0 / 24.0, 1.0 / 24.0), piece(5.0, 0.0, 0.0, Gear::Reverse)}};
        const Machine machine = tractor();
        const Path path = withSpeeds(std::vector{leg(SegmentKind::Turn, line)}, machine);
        const Kinematics found = measureKinematics(
            {.workable = wideArea(), .drivable = wideArea(), .machine = machine, .segments = path.segments});
        QCOMPARE(found.steering.count, 0);
    }

    /// Where the machine changes gear it steers standing, and that takes time.
    void aChangeOfGearTakesTheTimeOfTheSteering() {
        const Curve turn{
            .type = {},
            .start = {},
            .pieces = {piece(8.0, 1.0 / 6.0, 1.0 / 6.0), piece(8.0, -1.0 / 6.0, -1.0 / 6.0, Gear::Reverse)}};
        const std::vector<Leg> legs{leg(SegmentKind::Turn, turn)};
        const Path path = withSpeeds(legs, tractor());
        QCOMPARE(path.segments.size(), 2U);
        COMPARE_WITHIN(path.segments[1].samples.front().tS - path.segments[0].samples.back().tS, 2.65652,
                       1e-4);
    }

    void turnsAreSteerable_data() {
        QTest::addColumn<bool>("reverses");
        QTest::newRow("forwards") << false;
        QTest::newRow("with reversing") << true;
    }
    /// 200 turns of free space: the same ends, no sharper than the machine, and quicker than with a stop at
    /// each bend.
    void turnsAreSteerable() {
        QFETCH(bool, reverses);
        const Machine machine = tractor();
        const SteeringRoom room{wideArea(), machine};
        std::mt19937 random{11};
        std::uniform_real_distribution<double> place{-30.0, 30.0};
        std::uniform_real_distribution<double> heading{-3.1, 3.1};
        double steeredS = 0.0;
        double stoppingS = 0.0;
        for (int i = 0; i < 200; ++i) {
            const Pose from{{place(random), place(random)}, radians(heading(random))};
            const Pose to{{place(random), place(random)}, radians(heading(random))};
            const Length radius = machine.withSteeringReserve().minTurningRadius();
            const Curve turn = reverses ? reedsSheppTurn(from, to, radius) : dubinsTurn(from, to, radius);
            const std::vector<Leg> legs = legsBetween(from, turn, to);
            const auto steered = steerableLegs(legs, room, {});
            VERIFY_RESULT(steered);
            const QByteArray told = QByteArray::number(i);
            VERIFY_TOLD(
                distance(steered->front().line.start.position, legs.front().line.start.position) < 1e-9,
                told);
            VERIFY_TOLD(distance(steered->back().line.end().position, legs.back().line.end().position) < 1e-5,
                        told);
            for (std::size_t k = 0; k < 3; ++k) {
                VERIFY_TOLD(std::abs((*steered)[k].line.length().si() - legs[k].line.length().si()) < 5.0,
                            told);
                for (const CurvePiece& each : (*steered)[k].line.pieces) {
                    VERIFY_TOLD(std::abs(each.curvature.si()) <= 1.0001 / 6.0 + 1e-9, told);
                }
                if (k > 0) {
                    VERIFY_TOLD(distance((*steered)[k - 1].line.end().position,
                                         (*steered)[k].line.start.position) < 1e-5,
                                told);
                }
            }
            const Path path = withSpeeds(*steered, machine);
            VERIFY_TOLD(tooFast(path, machine) == 0, told);
            steeredS += path.duration().si();
            stoppingS += withSpeeds(legs, machine).duration().si();
        }
        QVERIFY2(steeredS < (reverses ? 0.95 : 0.85) * stoppingS,
                 QByteArray::number(steeredS) + " s, stopping " + QByteArray::number(stoppingS));
    }

    /// Beside walls at any distance the machine stays inside, more slowly where it must.
    void nothingLeavesTheArea() {
        const Machine machine = tractor();
        const Pose from{{0.0, 0.0}, {}};
        const Pose to{{0.0, 14.0}, radians(std::numbers::pi)};
        const Curve turn = dubinsTurn(from, to, metres(7.0));
        Duration last;
        for (const double spareM : {0.5, 0.1, 0.02, 0.0}) {
            // The nose of 3.5 m at the end of the straight of 7 m radius; the corner of tractor and
            // implement.
            double farM = 0.0;
            for (const Point& corner : machine.turningFootprint()) {
                farM = std::max(farM, std::hypot(corner.x, 7.0 - corner.y));
            }
            const double x = farM + spareM;
            const MultiPolygon area{
                {.outer = {{-80.0, -8.0}, {x, -8.0}, {x, 24.0}, {-80.0, 24.0}}, .holes = {}}};
            const SteeringRoom room{area, machine};
            const auto steered = steerableLegs(legsBetween(from, turn, to), room, {});
            VERIFY_RESULT(steered);
            for (const Leg& each : *steered) {
                QVERIFY(room.raised.driven(Rig::inLine(each.line.start), each.line).has_value());
            }
            const Path path = withSpeeds(*steered, machine);
            QCOMPARE(tooFast(path, machine), 0);
            QVERIFY(path.duration() >= last);
            last = path.duration() - seconds(0.05);
        }
    }

    /// Straights stay where they are, except for the rounding of the start.
    void swathsStayStraight() {
        const Machine machine = tractor();
        const Pose from{{0.0, 0.0}, {}};
        const Pose to{{0.0, 13.0}, radians(std::numbers::pi)};
        const auto legs = legsBetween(from, dubinsTurn(from, to, metres(6.1)), to);
        const auto steered = steerableLegs(legs, SteeringRoom{wideArea(), machine}, {});
        VERIFY_RESULT(steered);
        const CurvePiece& first = steered->front().line.pieces.front();
        QVERIFY(first.curvature == Curvature{} && first.endCurvature == Curvature{});
        QVERIFY2(first.length > metres(27.0), QByteArray::number(first.length.si()));
        const Pose start = steered->front().line.start;
        COMPARE_WITHIN(distance(start.position, legs.front().line.start.position), 0.0, 1e-9);
        COMPARE_WITHIN(start.heading.si(), legs.front().line.start.heading.si(), 1e-12);
    }

    void stopped() {
        std::stop_source source;
        source.request_stop();
        const Machine machine = tractor();
        const Pose from{{0.0, 0.0}, {}};
        const Pose to{{0.0, 13.0}, radians(std::numbers::pi)};
        const auto steered = steerableLegs(legsBetween(from, dubinsTurn(from, to, metres(6.1)), to),
                                           SteeringRoom{wideArea(), machine}, {.stop = source.get_token()});
        QVERIFY(!steered);
        QVERIFY(steered.error().code == ErrorCode::Cancelled);
    }
};

FURROW_TEST(SteerableLegsTest);
#include "tst_steerable_legs.moc"
