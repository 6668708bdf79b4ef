// The drive over a plan: by hand on a field of one swath's turns, and what holds on every field.

#include "planner/audit/motion.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/drive_course.h"
#include "planner/plan/method_registry.h"
#include "tests/support/field_generator.h"
#include "tests/support/real_fields.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using namespace furrow;

namespace {

PlanRequest requestFor(const FieldSource& source, std::string_view machine) {
    return {.field = std::make_shared<const Field>(Field::create(source).value()),
            .machine = findMachine(machine).value(),
            .settings = {}};
}

Plan sample(std::string_view machine) {
    return **makePlan(requestFor(test::shippedFields().front(), machine));
}

/// A plan of just this path; the rest of it is of another field and says nothing of the drive.
Plan withPath(Plan plan, std::vector<PathSegment> segments) {
    plan.path.segments = std::move(segments);
    return plan;
}

PathSegment straight(double lengthM, double fromM, double fromS, double v0, double v1, bool down) {
    const double takesS = 2.0 * lengthM / (v0 + v1);
    return {.kind = SegmentKind::Swath,
            .implementDown = down,
            .samples = {{.sM = fromM, .tS = fromS, .position = {fromM, 0.0}, .speedMps = v0},
                        {.sM = fromM + lengthM,
                         .tS = fromS + takesS,
                         .position = {fromM + lengthM, 0.0},
                         .speedMps = v1}}};
}

}  // namespace

class TestDriveCourse : public QObject {
    Q_OBJECT

private slots:
    void acceleratesEvenly();
    void standsWhileItWaits();
    void reversesToTheRear();
    void steers();
    void holdsOnFields_data();
    void holdsOnFields();
    void trailedOneIsOnItsOwnTrack();
    void beginsAtEachSegment();
    void cancelled();
};

void TestDriveCourse::acceleratesEvenly() {
    // From rest to 2 m/s over 20 m: 20 s at 0.1 m/s². After 10 s it has driven 5 m and drives 1 m/s.
    const Plan plan = withPath(sample("agbot"), {straight(20.0, 0.0, 0.0, 0.0, 2.0, true)});
    const auto course = DriveCourse::of(plan);
    VERIFY_RESULT(course);
    COMPARE_WITHIN(course->duration().si(), 20.0, 1e-9);
    const DriveState half = course->at(seconds(10.0));
    COMPARE_WITHIN(half.driven.si(), 5.0, 1e-6);
    COMPARE_WITHIN(half.worked.si(), 5.0, 1e-6);
    COMPARE_WITHIN(half.position.x, 5.0, 1e-6);
    COMPARE_WITHIN(half.speed.si(), 1.0, 1e-6);
    // The implement of a mounted machine keeps its distance.
    const double offset = plan.request.machine.spec().implement.offset.si();
    COMPARE_WITHIN(half.implement.x, 5.0 + offset, 1e-6);
    // Before and after.
    COMPARE_WITHIN(course->at(seconds(-5.0)).driven.si(), 0.0, 1e-12);
    COMPARE_WITHIN(course->at(seconds(99.0)).driven.si(), 20.0, 1e-12);
}

void TestDriveCourse::standsWhileItWaits() {
    // 10 m at 1 m/s, 30 s standing, 10 m at 1 m/s with the implement up.
    PathSegment second = straight(10.0, 10.0, 40.0, 1.0, 1.0, false);
    const Plan plan =
        withPath(sample("agbot"), {straight(10.0, 0.0, 0.0, 1.0, 1.0, true), std::move(second)});
    const auto course = DriveCourse::of(plan);
    VERIFY_RESULT(course);
    COMPARE_WITHIN(course->duration().si(), 50.0, 1e-9);
    for (const double t : {10.0, 25.0, 39.9}) {
        COMPARE_WITHIN(course->at(seconds(t)).driven.si(), 10.0, 1e-6);
        COMPARE_WITHIN(course->at(seconds(t)).worked.si(), 10.0, 1e-6);
    }
    COMPARE_WITHIN(course->at(seconds(45.0)).driven.si(), 15.0, 1e-6);
    COMPARE_WITHIN(course->workedLength().si(), 10.0, 1e-6);
}

void TestDriveCourse::reversesToTheRear() {
    PathSegment back{.kind = SegmentKind::Turn,
                     .gear = Gear::Reverse,
                     .samples = {{.position = {5.0, 0.0}, .speedMps = 1.0},
                                 {.sM = 4.0, .tS = 4.0, .position = {1.0, 0.0}, .speedMps = 1.0}}};
    const Plan plan = withPath(sample("agbot"), {std::move(back)});
    const auto course = DriveCourse::of(plan);
    VERIFY_RESULT(course);
    const DriveState state = course->at(seconds(3.0));
    COMPARE_WITHIN(state.position.x, 2.0, 1e-6);
    COMPARE_WITHIN(state.heading.si(), 0.0, 1e-9);
    COMPARE_WITHIN(state.driven.si(), 3.0, 1e-6);
}

void TestDriveCourse::steers() {
    const Machine machine = findMachine("cultivator").value();
    const double wheelbase = machine.spec().tractor.wheelbase.si();
    // On a radius as long as the wheelbase the wheels stand at 45 degrees.
    COMPARE_WITHIN(inDegrees(steeringAngle(machine, Curvature::fromSi(1.0 / wheelbase))), 45.0, 1e-9);
    COMPARE_WITHIN(inDegrees(steeringAngle(machine, Curvature::fromSi(-1.0 / wheelbase))), -45.0, 1e-9);
}

void TestDriveCourse::holdsOnFields_data() {
    QTest::addColumn<QString>("machine");
    for (const char* machine : {"agbot", "cultivator", "trailed-sprayer"}) {
        QTest::newRow(machine) << machine;
    }
}

void TestDriveCourse::holdsOnFields() {
    QFETCH(QString, machine);
    const std::vector<FieldSource> fields = test::shippedFields();
    for (std::size_t i = 0; i < 4; ++i) {
        const auto plan = makePlan(requestFor(fields[i], machine.toStdString()));
        if (!plan) {
            continue;
        }
        const auto course = DriveCourse::of(**plan);
        VERIFY_RESULT(course);
        const Path& path = (*plan)->path;
        COMPARE_WITHIN(course->duration().si(), path.duration().si(), 1e-6);
        COMPARE_WITHIN(course->length().si(), path.length().si(), 1e-6);
        COMPARE_WITHIN(course->workedLength().si(), path.workedLength().si(), 1e-3);
        DriveState last = course->at({});
        const int steps = 2000;
        for (int k = 1; k <= steps; ++k) {
            const DriveState state = course->at(course->duration() * (static_cast<double>(k) / steps));
            QVERIFY(state.driven >= last.driven && state.worked >= last.worked);
            QVERIFY(state.segment >= last.segment);
            // No faster than it says, but for chords: at most a centimetre beside the curve.
            QVERIFY(distance(state.position, last.position) <= (state.driven - last.driven).si() + 0.03);
            last = state;
        }
        // At each sample it is where the path says, when it says so.
        for (const PathSegment& segment : path.segments) {
            for (std::size_t k = 0; k < segment.samples.size(); k += 7) {
                const PathSample& there = segment.samples[k];
                QVERIFY(distance(course->at(seconds(there.tS)).position, there.position) < 0.02);
            }
        }
    }
}

void TestDriveCourse::trailedOneIsOnItsOwnTrack() {
    const Plan plan = sample("trailed-sprayer");
    const auto course = DriveCourse::of(plan);
    VERIFY_RESULT(course);
    const Implement& implement = plan.request.machine.spec().implement;
    const double trailing = (implement.hitchOffset - implement.offset).si();
    double most = 0.0;
    for (const DriveState& state : course->stations()) {
        const Point nose{std::cos(state.heading.si()), std::sin(state.heading.si())};
        const Point hitch = state.position + implement.hitchOffset.si() * nose;
        // Always the drawbar's length behind the hitch.
        QVERIFY(std::abs(distance(hitch, state.implement) - trailing) < 1e-6);
        most = std::max(most, std::abs(std::remainder((state.heading - state.implementHeading).si(),
                                                      2.0 * std::numbers::pi)));
    }
    COMPARE_WITHIN(most, plan.audit.maxHitchAngle->si(), 1e-9);
}

void TestDriveCourse::beginsAtEachSegment() {
    const Plan plan = sample("cultivator");
    const auto course = DriveCourse::of(plan);
    VERIFY_RESULT(course);
    QCOMPARE(course->segmentCount(), plan.path.segments.size());
    for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
        const PathSegment& segment = plan.path.segments[i];
        COMPARE_WITHIN(course->startOf(i).si(), segment.samples.front().tS, 1e-12);
        const double middleS = 0.5 * (segment.samples.front().tS + segment.samples.back().tS);
        QCOMPARE(course->at(seconds(middleS)).segment, i);
    }
}

void TestDriveCourse::cancelled() {
    std::stop_source stop;
    stop.request_stop();
    const auto course = DriveCourse::of(sample("agbot"), {.stop = stop.get_token()});
    QVERIFY(!course);
    QCOMPARE(course.error().code, ErrorCode::Cancelled);
}

FURROW_TEST(TestDriveCourse);
#include "tst_drive_course.moc"
