#include "planner/machine/machine_library.h"
#include "planner/path/path_builder.h"
#include "planner/route/methods.h"
#include "planner/swaths/scan_line.h"
#include "planner/turns/dubins.h"
#include "planner/turns/straight_turn.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"

#include <cmath>
#include <numbers>
#include <stop_token>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;

const Machine& agbot() {
    static const Machine machine = findMachine("agbot").value();
    return machine;
}

struct Driven {
    SwathSet swaths;
    Route route;
    Path path;
};

Driven drive(const MultiPolygon& mainland, const Machine& machine, double headingDeg, TurnPlanner* turn) {
    Driven driven;
    driven.swaths = ScanLine{mainland, {.width = machine.operatingWidth(), .overlap = {}}}.swaths(degrees(headingDeg));
    driven.route = kBoustrophedonMethod.run(driven.swaths, machine, {}, {}).value();
    driven.path = buildPath(driven.swaths, driven.route, machine, turn, {}).value();
    return driven;
}

/// The way between two samples of one curvature, by the chord: chord = 2 R sin(way / 2 R).
double arcLengthM(const PathSample& a, const PathSample& b) {
    const double chordM = distance(a.position, b.position);
    const double k = std::abs(a.curvature1pm);
    return k == 0.0 ? chordM : 2.0 / k * std::asin(std::min(1.0, 0.5 * chordM * k));
}

}  // namespace

class PathBuilderTest : public QObject {
    Q_OBJECT

private slots:
    // 100 m x 10 m, four swaths of 2.5 m, omega turns: R (pi + 4 acos((2 R + w) / 4 R)) each.
    void aRectangleByHand() {
        const double r = 2.1;
        const double w = 2.5;
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, agbot(), 0.0, kDubinsMethod.run);
        QCOMPARE(driven.path.segments.size(), std::size_t{7});
        const double turnM = r * (kPi + 4.0 * std::acos((2.0 * r + w) / (4.0 * r)));
        COMPARE_WITHIN(driven.path.length().si(), 400.0 + 3.0 * turnM, 1e-6);
        COMPARE_WITHIN(driven.path.length(SegmentKind::Turn).si(), 3.0 * turnM, 1e-6);
        COMPARE_WITHIN(driven.path.length(SegmentKind::Swath).si(), 400.0, 1e-6);
        QCOMPARE(driven.path.turnCount(), 3);
        QCOMPARE(driven.path.undrivableCount(), 0);
        // 2.5 m/s on swaths, 1.5 m/s on turns: 2 m/s² sideways would allow sqrt(2 x 2.1) = 2.05 m/s.
        COMPARE_WITHIN(driven.path.duration().si(), 400.0 / 2.5 + 3.0 * turnM / 1.5, 1e-6);
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
            QTest::addRow("%s", test::shapeName(shape).data()) << static_cast<int>(shape);
        }
    }
    void isContinuous() {
        QFETCH(int, shape);
        const std::uint64_t seed = 31 + static_cast<std::uint64_t>(shape);
        std::mt19937_64 random{seed};
        for (int i = 0; i < 20; ++i) {
            const MultiPolygon mainland = test::randomPolygons(random, static_cast<test::Shape>(shape), 80.0);
            const Driven driven = drive(mainland, agbot(), test::uniform(random, 0.0, 180.0), kDubinsMethod.run);
            const QByteArray told = QStringLiteral("seed %1, field %2").arg(seed).arg(i).toUtf8();
            const auto& segments = driven.path.segments;
            VERIFY_TOLD(segments.size() == 2 * driven.swaths.swaths.size() - 1, told);
            double wayM = 0.0;
            double timeS = 0.0;
            const PathSample* before = nullptr;
            for (std::size_t s = 0; s < segments.size(); ++s) {
                const PathSegment& segment = segments[s];
                VERIFY_TOLD(segment.samples.size() >= 2, told);
                VERIFY_TOLD((segment.kind == SegmentKind::Swath) == (s % 2 == 0), told);
                VERIFY_TOLD(segment.implementDown == (segment.kind == SegmentKind::Swath), told);
                VERIFY_TOLD(segment.gear == Gear::Forward && segment.drivable && segment.reason.empty(), told);
                VERIFY_TOLD((segment.turnType == "dubins") == (segment.kind == SegmentKind::Turn), told);
                for (std::size_t k = 0; k < segment.samples.size(); ++k) {
                    const PathSample& sample = segment.samples[k];
                    VERIFY_TOLD(std::abs(sample.curvature1pm) <= 1.0 / 2.1 + 1e-12, told);
                    VERIFY_TOLD(sample.headingRad >= 0.0 && sample.headingRad < 2.0 * kPi, told);
                    VERIFY_TOLD(sample.speedMps == (segment.kind == SegmentKind::Swath ? 2.5 : 1.5), told);
                    if (k == 0 && before != nullptr) {
                        // Where one segment ends the next begins.
                        VERIFY_TOLD(distance(before->position, sample.position) < 1e-9, told);
                        VERIFY_TOLD(std::abs(std::remainder(before->headingRad - sample.headingRad, 2.0 * kPi)) < 1e-9, told);
                        VERIFY_TOLD(std::abs(before->sM - sample.sM) < 1e-9 && std::abs(before->tS - sample.tS) < 1e-9, told);
                    } else if (k > 0) {
                        const PathSample& last = segment.samples[k - 1];
                        const double stepM = arcLengthM(last, sample);
                        wayM += stepM;
                        timeS += stepM / last.speedMps;
                        VERIFY_TOLD(sample.sM > last.sM && sample.tS > last.tS, told);
                        // Headings follow the curvature, places the headings.
                        VERIFY_TOLD(std::abs(std::remainder(sample.headingRad - last.headingRad - stepM * last.curvature1pm, 2.0 * kPi)) < 1e-6, told);
                        const Point way = sample.position - last.position;
                        const double middle = last.headingRad + 0.5 * stepM * last.curvature1pm;
                        VERIFY_TOLD(std::abs(cross(way, direction(middle))) < 1e-6 && dot(way, direction(middle)) > 0.0, told);
                    }
                    VERIFY_TOLD(std::abs(sample.sM - wayM) < 1e-6 * (1.0 + wayM), told);
                    VERIFY_TOLD(std::abs(sample.tS - timeS) < 1e-6 * (1.0 + timeS), told);
                    before = &sample;
                }
            }
            VERIFY_TOLD(std::abs(driven.path.length().si() - wayM) < 1e-6 * wayM, told);
            VERIFY_TOLD(std::abs(driven.path.duration().si() - timeS) < 1e-6 * timeS, told);
        }
    }

    void straightTurnsJump() {
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, agbot(), 0.0, kStraightMethod.run);
        QCOMPARE(driven.path.segments.size(), std::size_t{7});
        COMPARE_WITHIN(driven.path.length().si(), 400.0 + 3.0 * 2.5, 1e-9);
        COMPARE_WITHIN(driven.path.length().si(), driven.route.lengthInPlace.si(), 1e-9);
        for (std::size_t s = 1; s < driven.path.segments.size(); ++s) {
            const PathSample& end = driven.path.segments[s - 1].samples.back();
            const PathSample& start = driven.path.segments[s].samples.front();
            COMPARE_WITHIN(distance(end.position, start.position), 0.0, 1e-9);
            COMPARE_WITHIN(std::abs(std::remainder(end.headingRad - start.headingRad, 2.0 * kPi)), 0.5 * kPi, 1e-9);
        }
    }

    void noSwathsNoPath() {
        const auto path = buildPath({}, {}, agbot(), kDubinsMethod.run, {});
        VERIFY_RESULT(path);
        QVERIFY(path->segments.empty());
        QCOMPARE(path->length().si(), 0.0);
        QCOMPARE(path->duration().si(), 0.0);
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const Driven driven = drive({test::rectangle(100.0, 10.0)}, agbot(), 0.0, kDubinsMethod.run);
        const auto path = buildPath(driven.swaths, driven.route, agbot(), kDubinsMethod.run, {.stop = stop.get_token()});
        QVERIFY(!path);
        QCOMPARE(path.error().code, ErrorCode::Cancelled);
    }
};

QTEST_APPLESS_MAIN(PathBuilderTest)
#include "tst_path_builder.moc"
