#include "planner/audit/motion.h"
#include "planner/audit/tractrix.h"
#include "planner/machine/machine_library.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;

/// A trailed implement `trailing` behind a hitch right under the reference point.
Machine trailer(double trailing) {
    MachineSpec spec;
    spec.tractor.minTurningRadius = metres(1.0);
    spec.implement.mounting = Mounting::Trailed;
    spec.implement.hitchOffset = metres(0.0);
    spec.implement.offset = metres(-trailing);
    return Machine::create(spec).value();
}

PathSegment circle(double radius, double turn, int steps) {
    PathSegment segment{.kind = SegmentKind::Turn, .turnType = {}};
    for (int i = 0; i <= steps; ++i) {
        const double angle = turn * i / steps;
        segment.samples.push_back({.sM = radius * angle,
                                   .tS = radius * angle,
                                   .position = {radius * std::sin(angle), radius * (1.0 - std::cos(angle))},
                                   .headingRad = std::fmod(angle, 2.0 * kPi),
                                   .curvature1pm = 1.0 / radius,
                                   .speedMps = 1.0});
    }
    return segment;
}

}  // namespace

class TestTractrix : public QObject {
    Q_OBJECT
private slots:
    void standsStill() { QCOMPARE(trailedHeading(radians(1.25), {0.0, 0.0}, metres(3.0)), radians(1.25)); }

    // Huygens' tractrix: pulled at a right angle along x from (0, a), the axle is at
    // x = s - a tanh(s / a), y = a / cosh(s / a) when the hitch has gone s.
    void pulledAtARightAngle_data() {
        QTest::addColumn<double>("way");
        QTest::newRow("a little") << 0.3;
        QTest::newRow("its own length") << 4.0;
        QTest::newRow("far") << 30.0;
    }
    void pulledAtARightAngle() {
        QFETCH(double, way);
        const double a = 4.0;
        for (const int steps : {1, 7}) {
            Angle heading = radians(-0.5 * kPi);
            for (int i = 0; i < steps; ++i) {
                heading = trailedHeading(heading, {way / steps, 0.0}, metres(a));
            }
            const Point axle = Point{way, 0.0} - a * direction(heading.si());
            COMPARE_WITHIN(axle.x, way - a * std::tanh(way / a), 1e-12);
            COMPARE_WITHIN(axle.y, a / std::cosh(way / a), 1e-12);
        }
    }
    void pushedBackItFoldsUp() {
        Angle heading = radians(0.01);
        heading = trailedHeading(heading, {-8.0, 0.0}, metres(4.0));
        QVERIFY(heading.si() > 0.05);
    }

    // On a circle of radius R the axle settles on sqrt(R² - d²), the hitch angle on asin(d / R).
    void circleSettles() {
        const Machine machine = trailer(3.0);
        const PathSegment segment = circle(6.0, 40.0 * kPi, 4000);
        const AuditInput input{.machine = machine, .segments = std::span{&segment, 1}};
        const auto motions = followPath(input, shapeOf(input), {});
        VERIFY_RESULT(motions);
        const MotionState& last = motions->front().states.back();
        const Point centre{0.0, 6.0};
        COMPARE_WITHIN(distance(last.implement, centre), std::sqrt(36.0 - 9.0), 2e-3);
        COMPARE_WITHIN(std::remainder(last.headingRad - last.implementHeadingRad, 2.0 * kPi),
                       std::asin(3.0 / 6.0), 1e-3);
    }
    // Finer samples of the same circle must not change where the implement is.
    void samplingDoesNotMatter() {
        const Machine machine = trailer(5.0);
        Point at[2];
        for (const int i : {0, 1}) {
            const PathSegment segment = circle(7.0, 1.5 * kPi, i == 0 ? 40 : 4000);
            const AuditInput input{.machine = machine, .segments = std::span{&segment, 1}};
            at[i] = followPath(input, shapeOf(input), {}).value().front().states.back().implement;
        }
        COMPARE_WITHIN(distance(at[0], at[1]), 0.0, 2e-3);
    }
    // After a straight pull the states between are where the closed form says, and few.
    void straightPullIsFollowedCloselyAndThenInOneStep() {
        const Machine machine = trailer(4.0);
        PathSegment turn = circle(5.0, 0.5 * kPi, 100);
        PathSegment straight{.kind = SegmentKind::Swath, .turnType = {}};
        PathSample from = turn.samples.back();
        straight.samples = {from, from};
        straight.samples[1].position = from.position + 400.0 * direction(from.headingRad);
        straight.samples[1].sM += 400.0;
        const PathSegment segments[] = {turn, straight};
        const AuditInput input{.machine = machine, .segments = segments};
        const auto motions = followPath(input, shapeOf(input), {}).value();
        const double first = motions[1].states.front().implementHeadingRad - from.headingRad;
        QVERIFY(motions[1].states.size() < 80);
        for (const MotionState& state : motions[1].states) {
            const double way = distance(state.position, from.position);
            const double expected = 2.0 * std::atan(std::tan(0.5 * first) * std::exp(-way / 4.0));
            COMPARE_WITHIN(std::remainder(state.implementHeadingRad - from.headingRad, 2.0 * kPi), expected,
                           1e-9);
        }
    }
};

FURROW_TEST(TestTractrix);
#include "tst_tractrix.moc"
