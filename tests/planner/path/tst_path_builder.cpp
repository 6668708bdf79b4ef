#include "planner/path/path_builder.h"
#include "planner/path/speed_profile.h"
#include "planner/route/methods.h"
#include "planner/swaths/scan_line.h"
#include "planner/turns/dubins.h"
#include "planner/turns/named_turns.h"
#include "planner/turns/straight_turn.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <cmath>
#include <numbers>
#include <stop_token>

using namespace furrow;
using test::agbot;

namespace {

constexpr double kPi = std::numbers::pi;

/// The same with the implement right at the axle and lifted in no time: numbers that can be worked out by
/// hand.
const Machine& plainRobot() {
    static const Machine machine = [] {
        MachineSpec spec = agbot().spec();
        spec.implement.offset = metres(0.0);
        spec.implement.liftTime = seconds(0.0);
        spec.implement.lowerTime = seconds(0.0);
        return Machine::create(spec).value();
    }();
    return machine;
}

struct Driven {
    SwathSet swaths;
    Route route;
    Path path;
};

Driven drive(const MultiPolygon& mainland, const Machine& machine, double headingDeg, TurnPlanner* turn) {
    Driven driven;
    driven.swaths =
        ScanLine{mainland, {.width = machine.operatingWidth(), .overlap = {}}}.swaths(degrees(headingDeg));
    driven.route = test::routeBy(kBoustrophedonMethod, driven.swaths, machine, {}, {}).value();
    driven.path = test::pathOf(driven.swaths, driven.route, machine, turn, {}).value();
    return driven;
}

/// The way between two samples of one curvature, by the chord: chord = 2 R sin(way / 2 R).
double arcLengthM(const PathSample& a, const PathSample& b) {
    const double chordM = distance(a.position, b.position);
    const double k = std::abs(a.curvature1pm);
    return k == 0.0 ? chordM : 2.0 / k * std::asin(std::min(1.0, 0.5 * chordM * k));
}

/// What the samples of a path add up to.
struct Reckoned {
    double wayM = 0.0;
    double timeS = 0.0;
    const PathSample* before = nullptr;
};

}  // namespace

class PathBuilderTest : public QObject {
    Q_OBJECT

    static void checkLimits(const PathSample& sample, SegmentKind kind, const QByteArray& told) {
        VERIFY_TOLD(std::abs(sample.curvature1pm) <= 1.0 / 2.1 + 1e-12, told);
        VERIFY_TOLD(sample.headingRad >= 0.0 && sample.headingRad < 2.0 * kPi, told);
        VERIFY_TOLD(sample.speedMps >= 0.0 && sample.speedMps <= (kind == SegmentKind::Swath ? 2.5 : 1.5),
                    told);
        VERIFY_TOLD(sample.speedMps * sample.speedMps * std::abs(sample.curvature1pm) <= 2.0 + 1e-9, told);
    }
    /// Where one segment ends the next begins.
    static void checkJoint(const PathSample& before, const PathSample& sample, const QByteArray& told) {
        VERIFY_TOLD(distance(before.position, sample.position) < 1e-9, told);
        VERIFY_TOLD(std::abs(std::remainder(before.headingRad - sample.headingRad, 2.0 * kPi)) < 1e-9, told);
        VERIFY_TOLD(std::abs(before.sM - sample.sM) < 1e-9 && std::abs(before.tS - sample.tS) < 1e-9, told);
    }
    static void checkStep(const PathSample& last, const PathSample& sample, double stepM,
                          const QByteArray& told) {
        const double squares = sample.speedMps * sample.speedMps - last.speedMps * last.speedMps;
        VERIFY_TOLD(std::abs(squares) <= 2.0 * 0.5 * stepM * (1.0 + 1e-6) + 1e-9, told);
        VERIFY_TOLD(sample.sM > last.sM && sample.tS > last.tS, told);
        // Headings follow the curvature, places the headings.
        VERIFY_TOLD(std::abs(std::remainder(sample.headingRad - last.headingRad - stepM * last.curvature1pm,
                                            2.0 * kPi)) < 1e-6,
                    told);
        const Point way = sample.position - last.position;
        const double middle = last.headingRad + 0.5 * stepM * last.curvature1pm;
        VERIFY_TOLD(std::abs(cross(way, direction(middle))) < 1e-6 && dot(way, direction(middle)) > 0.0,
                    told);
    }
    /// Alone, and beside the one before it.
    static void checkSegment(const PathSegment& segment, bool isSwath, Reckoned& reckoned,
                             const QByteArray& told) {
        VERIFY_TOLD(segment.samples.size() >= 2, told);
        VERIFY_TOLD((segment.kind == SegmentKind::Swath) == isSwath, told);
        VERIFY_TOLD(segment.implementDown == (segment.kind == SegmentKind::Swath), told);
        VERIFY_TOLD(segment.gear == Gear::Forward && segment.drivable && segment.reason.empty(), told);
        VERIFY_TOLD((segment.turnType == "dubins") == (segment.kind == SegmentKind::Turn), told);
        for (std::size_t k = 0; k < segment.samples.size(); ++k) {
            const PathSample& sample = segment.samples[k];
            checkLimits(sample, segment.kind, told);
            if (k == 0 && reckoned.before != nullptr) {
                checkJoint(*reckoned.before, sample, told);
            } else if (k > 0) {
                const PathSample& last = segment.samples[k - 1];
                const double stepM = arcLengthM(last, sample);
                reckoned.wayM += stepM;
                reckoned.timeS += 2.0 * stepM / (last.speedMps + sample.speedMps);
                checkStep(last, sample, stepM, told);
            }
            if (QTest::currentTestFailed()) {
                return;
            }
            VERIFY_TOLD(std::abs(sample.sM - reckoned.wayM) < 1e-6 * (1.0 + reckoned.wayM), told);
            VERIFY_TOLD(std::abs(sample.tS - reckoned.timeS) < 1e-6 * (1.0 + reckoned.timeS), told);
            reckoned.before = &sample;
        }
    }

private slots:
    // 100 m x 10 m, four swaths of 2.5 m, omega turns: R (pi + 4 acos((2 R + w) / 4 R)) each.
    void aRectangleByHand() {
        const double r = 2.1;
        const double w = 2.5;
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, plainRobot(), 0.0, kDubinsMethod.run);
        QCOMPARE(driven.path.segments.size(), std::size_t{7});
        const double turnM = r * (kPi + 4.0 * std::acos((2.0 * r + w) / (4.0 * r)));
        COMPARE_WITHIN(driven.path.length().si(), 400.0 + 3.0 * turnM, 1e-6);
        COMPARE_WITHIN(driven.path.length(SegmentKind::Turn).si(), 3.0 * turnM, 1e-6);
        COMPARE_WITHIN(driven.path.length(SegmentKind::Swath).si(), 400.0, 1e-6);
        QCOMPARE(driven.path.turnCount(), 3);
        QCOMPARE(driven.path.undrivableCount(), 0);
        // 2.5 m/s on swaths, 1.5 m/s on turns: 2 m/s² sideways would allow sqrt(2 x 2.1) = 2.05 m/s.
        // At 0.5 m/s²: 5 s and 6.25 m from a stop to 2.5 m/s, 2 s and 4 m between 1.5 and 2.5 m/s. Two swaths
        // have one of each at their ends, two have twice the second.
        const double outerS = 5.0 + (100.0 - 6.25 - 4.0) / 2.5 + 2.0;
        const double innerS = 2.0 + (100.0 - 8.0) / 2.5 + 2.0;
        COMPARE_WITHIN(driven.path.duration().si(), 2.0 * outerS + 2.0 * innerS + 3.0 * turnM / 1.5, 1e-6);
        COMPARE_WITHIN(driven.path.duration(SegmentKind::Turn).si(), 3.0 * turnM / 1.5, 1e-6);
    }

    void lateralAccelerationSlowsTurns() {
        MachineSpec spec = agbot().spec();
        spec.tractor.maxLateralAcceleration = Acceleration::fromSi(0.5);
        const Machine careful = Machine::create(spec).value();
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, careful, 0.0, kDubinsMethod.run);
        for (const PathSegment& segment : driven.path.segments) {
            for (const PathSample& sample : segment.samples) {
                QVERIFY(sample.speedMps * sample.speedMps * std::abs(sample.curvature1pm) <= 0.5 + 1e-9);
            }
        }
    }

    void isContinuous_data() {
        QTest::addColumn<int>("shape");
        for (const test::Shape shape : test::kShapes) {
            QTest::addRow("%s", std::string{test::shapeName(shape)}.c_str()) << static_cast<int>(shape);
        }
    }
    void isContinuous() {
        QFETCH(int, shape);
        const std::uint64_t seed = 31 + static_cast<std::uint64_t>(shape);
        std::mt19937_64 random{seed};
        for (int i = 0; i < 20; ++i) {
            const MultiPolygon mainland = test::randomPolygons(random, static_cast<test::Shape>(shape), 80.0);
            const Driven driven =
                drive(mainland, agbot(), test::uniform(random, 0.0, 180.0), kDubinsMethod.run);
            const QByteArray told = QStringLiteral("seed %1, field %2").arg(seed).arg(i).toUtf8();
            const auto& segments = driven.path.segments;
            VERIFY_TOLD(segments.size() == 2 * driven.swaths.swaths.size() - 1, told);
            Reckoned reckoned;
            for (std::size_t s = 0; s < segments.size(); ++s) {
                checkSegment(segments[s], s % 2 == 0, reckoned, told);
                if (QTest::currentTestFailed()) {
                    return;
                }
            }
            VERIFY_TOLD(std::abs(driven.path.length().si() - reckoned.wayM) < 1e-6 * reckoned.wayM, told);
            VERIFY_TOLD(std::abs(driven.path.duration().si() - reckoned.timeS) < 1e-6 * reckoned.timeS, told);
        }
    }

    void straightTurnsJump() {
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, plainRobot(), 0.0, kStraightMethod.run);
        QCOMPARE(driven.path.segments.size(), std::size_t{7});
        COMPARE_WITHIN(driven.path.length().si(), 400.0 + 3.0 * 2.5, 1e-9);
        COMPARE_WITHIN(driven.path.length().si(), driven.route.lengthInPlace.si(), 1e-9);
        for (std::size_t s = 1; s < driven.path.segments.size(); ++s) {
            const PathSample& end = driven.path.segments[s - 1].samples.back();
            const PathSample& start = driven.path.segments[s].samples.front();
            COMPARE_WITHIN(distance(end.position, start.position), 0.0, 1e-9);
            COMPARE_WITHIN(std::abs(std::remainder(end.headingRad - start.headingRad, 2.0 * kPi)), 0.5 * kPi,
                           1e-9);
        }
    }

    // A quarter turn on the spot takes the outer wheel, 1 m from the middle, over pi / 2 m. It speeds up and
    // brakes with 0.5 m/s² and does not reach 1 m/s, which would take it 2 m: 2 sqrt(way / 0.5) seconds. The
    // implement is lifted and lowered meanwhile.
    void turnsOnTheSpotTakeTime_data() {
        QTest::addColumn<double>("handlingS");
        QTest::newRow("lifted at once") << 0.0;
        QTest::newRow("lifted meanwhile") << 3.0;
    }
    void turnsOnTheSpotTakeTime() {
        QFETCH(double, handlingS);
        MachineSpec spec = plainRobot().spec();
        spec.tractor.width = metres(2.0);
        spec.tractor.turningSpeed = metresPerSecond(1.0);
        spec.tractor.maxAcceleration = Acceleration::fromSi(0.5);
        spec.implement.liftTime = seconds(handlingS);
        spec.implement.lowerTime = seconds(handlingS);
        const Machine robot = Machine::create(spec).value();
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, robot, 0.0, kStraightMethod.run);
        const double quarterS = 2.0 * std::sqrt(0.5 * kPi / 0.5);
        // 2.5 m from stop to stop: speeding up to 1 m/s and braking take 1 m each and 2 s each.
        const double acrossS = 2.0 + 2.0 + 0.5;
        for (std::size_t s = 1; s < driven.path.segments.size(); ++s) {
            const PathSegment& segment = driven.path.segments[s];
            COMPARE_WITHIN(segment.samples.front().tS - driven.path.segments[s - 1].samples.back().tS,
                           quarterS, 1e-9);
            if (segment.kind == SegmentKind::Turn) {
                COMPARE_WITHIN(segment.samples.back().tS - segment.samples.front().tS, acrossS, 1e-9);
            }
        }
    }

    // 10 m, a quarter turn on the spot of q = 2 sqrt(pi) s, and 10 m: one turn, a segment for each line.
    // Lifting and lowering take h = 30 s in all; the turn on the spot is one part of it, and 20 m at v = 20 /
    // (h - q) the other. Braking to the turn on the spot and getting under way again take v / a more.
    void aWayThatTurnsOnTheSpotInBetween() {
        MachineSpec spec = plainRobot().spec();
        spec.tractor.width = metres(2.0);
        spec.tractor.turningSpeed = metresPerSecond(1.0);
        spec.tractor.maxAcceleration = Acceleration::fromSi(0.5);
        spec.implement.liftTime = seconds(10.0);
        spec.implement.lowerTime = seconds(20.0);
        const Machine robot = Machine::create(spec).value();
        const auto swath = [](Point from, double headingDeg) {
            return Leg{.kind = SegmentKind::Swath,
                       .number = 1,
                       .line = {.type = {},
                                .start = {.position = from, .heading = degrees(headingDeg)},
                                .pieces = {{.length = metres(50.0), .curvature = {}}}}};
        };
        const auto round = [](const Leg& leaving, const Leg&, const JobContext&) {
            return WayBetween{.line = {.type = "combined",
                                       .start = leaving.line.end(),
                                       .pieces = {{.length = metres(10.0), .curvature = {}},
                                                  {.length = {}, .curvature = {}, .onTheSpot = degrees(90.0)},
                                                  {.length = metres(10.0), .curvature = {}}}}};
        };
        const std::vector<Leg> swaths{swath({-50.0, 0.0}, 0.0), swath({10.0, 10.0}, 90.0)};
        const auto legs = joinedLegs(swaths, robot, round, {});
        VERIFY_RESULT(legs);
        QCOMPARE(legs->size(), std::size_t{4});
        QVERIFY((*legs)[1].kind == SegmentKind::Turn && (*legs)[2].kind == SegmentKind::Turn);
        QVERIFY(!(*legs)[1].implementDown && !(*legs)[2].implementDown);
        COMPARE_WITHIN((*legs)[2].line.start.heading.si(), 0.5 * kPi, 1e-12);
        const Path path = withSpeeds(*legs, robot);
        QCOMPARE(path.turnCount(), 1);
        const double quarterS = 2.0 * std::sqrt(0.5 * kPi / 0.5);
        const double mps = 20.0 / (30.0 - quarterS);
        COMPARE_WITHIN(path.segments[3].samples.front().tS - path.segments[0].samples.back().tS,
                       30.0 + mps / 0.5, 1e-6);
    }

    // The tractor is 2.1 m ahead of the middle of the implement, whichever way it drives.
    void theImplementIsOnTheSwath() {
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, agbot(), 0.0, kDubinsMethod.run);
        for (const PathSegment& segment : driven.path.segments) {
            if (segment.kind == SegmentKind::Swath) {
                const double sign = std::cos(segment.samples.front().headingRad);
                COMPARE_WITHIN(segment.samples.front().position.x, (sign > 0.0 ? 0.0 : 100.0) + sign * 2.1,
                               1e-9);
                COMPARE_WITHIN(segment.samples.back().position.x, (sign > 0.0 ? 100.0 : 0.0) + sign * 2.1,
                               1e-9);
            }
        }
    }

    // Out of line to the right by 0.4 m: the tractor drives 0.4 m to the left of the swath, both ways.
    void anImplementToTheSide() {
        MachineSpec spec = plainRobot().spec();
        spec.implement.lateralOffset = metres(-0.4);
        const Driven driven =
            drive({test::rectangle(100.0, 10.0)}, Machine::create(spec).value(), 0.0, kDubinsMethod.run);
        for (const PathSegment& segment : driven.path.segments) {
            if (segment.kind == SegmentKind::Swath) {
                const double sign = std::cos(segment.samples.front().headingRad);
                const double swathY = 1.25 + 2.5 * (segment.number - 1);
                COMPARE_WITHIN(segment.samples.front().position.y, swathY + sign * 0.4, 1e-9);
                COMPARE_WITHIN(segment.samples.back().position.y, swathY + sign * 0.4, 1e-9);
            }
        }
    }

    // 25 s are more than any of these turns takes by itself.
    void turnsLastUntilTheImplementIsDown() {
        MachineSpec spec = plainRobot().spec();
        spec.implement.liftTime = seconds(10.0);
        spec.implement.lowerTime = seconds(15.0);
        const Driven driven =
            drive({test::rectangle(100.0, 10.0)}, Machine::create(spec).value(), 0.0, kDubinsMethod.run);
        for (const PathSegment& segment : driven.path.segments) {
            if (segment.kind == SegmentKind::Turn) {
                COMPARE_WITHIN(segment.duration().si(), 25.0, 1e-6);
            }
        }
    }

    // 3 m of straight way before each swath but the first.
    void runInsAreStraight() {
        MachineSpec spec = plainRobot().spec();
        spec.implement.runIn = metres(3.0);
        const Driven driven =
            drive({test::rectangle(100.0, 10.0)}, Machine::create(spec).value(), 0.0, kDubinsMethod.run);
        for (std::size_t s = 1; s < driven.path.segments.size(); s += 2) {
            const std::vector<PathSample>& samples = driven.path.segments[s].samples;
            const PathSample& last = samples.back();
            for (const PathSample& sample : samples) {
                if (last.sM - sample.sM < 3.0 - 1e-9) {
                    COMPARE_WITHIN(std::abs(std::remainder(sample.headingRad - last.headingRad, 2.0 * kPi)),
                                   0.0, 1e-9);
                }
            }
        }
    }

    // Gears change at a stop.
    void gearsChangeAtAStop() {
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, agbot(), 0.0, kFishtailMethod.run);
        int changes = 0;
        for (std::size_t s = 1; s < driven.path.segments.size(); ++s) {
            const PathSegment& before = driven.path.segments[s - 1];
            const PathSegment& after = driven.path.segments[s];
            if (before.gear != after.gear) {
                ++changes;
                QCOMPARE(before.samples.back().speedMps, 0.0);
                QCOMPARE(after.samples.front().speedMps, 0.0);
            }
            if (after.gear == Gear::Reverse) {
                for (const PathSample& sample : after.samples) {
                    QVERIFY(sample.speedMps <= agbot().spec().tractor.reverseSpeed.si() + 1e-12);
                }
            }
        }
        QCOMPARE(changes, 6);
    }

    void noSwathsNoPath() {
        const auto path = test::pathOf({}, {}, agbot(), kDubinsMethod.run, {});
        VERIFY_RESULT(path);
        QVERIFY(path->segments.empty());
        QCOMPARE(path->length().si(), 0.0);
        QCOMPARE(path->duration().si(), 0.0);
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, agbot(), 0.0, kDubinsMethod.run);
        const auto path =
            test::pathOf(driven.swaths, driven.route, agbot(), kDubinsMethod.run, {.stop = stop.get_token()});
        QVERIFY(!path);
        QCOMPARE(path.error().code, ErrorCode::Cancelled);
    }
};

FURROW_TEST(PathBuilderTest);
#include "tst_path_builder.moc"
