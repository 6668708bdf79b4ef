#include "tests/planner/audit/audit_paths.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <atomic>
#include <chrono>
#include <stop_token>
#include <thread>

using namespace furrow;
using namespace furrow::test;

namespace {

constexpr double kPi = std::numbers::pi;

struct Expected {
    double covered = 0.0;
    double missed = 0.0;
    double overlap = 0.0;
    double overlapHeadland = 0.0;
};

/// Straight swaths from (x0, y) to (x1, y).
struct Lane {
    double y;
    double x0;
    double x1;
    SegmentKind kind = SegmentKind::Swath;
};

/// Lanes of 10 m to and fro, with half circles between them.
std::vector<PathSegment> weavingPath(int lanes, double length) {
    PathDrawer drawer{{0.0, 5.0}};
    for (int i = 0; i < lanes; ++i) {
        drawer.begin(SegmentKind::Swath, true, i + 1).straight(length);
        if (i + 1 < lanes) {
            drawer.begin(SegmentKind::Turn, false, i + 1).arc(5.0 * kPi, i % 2 == 0 ? 0.2 : -0.2, 8);
        }
    }
    return drawer.segments;
}

/// Trails its implement behind a hitch 1 m behind the axle.
MachineSpec trailing(double widthM, double radiusM, double offsetM) {
    MachineSpec spec = plainMachine(widthM, radiusM).spec();
    spec.implement.mounting = Mounting::Trailed;
    spec.implement.hitchOffset = metres(-1.0);
    spec.implement.offset = metres(offsetM);
    return spec;
}

AuditReport reportOf(const MultiPolygon& area, const Machine& machine,
                     const std::vector<PathSegment>& segments) {
    return audit({.workable = area, .drivable = area, .machine = machine, .segments = segments}).value();
}

}  // namespace

class TestAuditAreas : public QObject {
    Q_OBJECT
private slots:
    // A quarter turn on the spot 1.5 m beside the edge. The implement of 3 m x 1 m at work reaches hypot(1.5,
    // 0.5) m = 1.58 m round the middle, raised to 1 m 0.71 m, and the tractor of 2 m x 2 m 1.41 m. It is
    // lowered at the end of the turn; between two stretches of work it stays down.
    void turnsOnTheSpotWithTheImplementUp_data() {
        QTest::addColumn<bool>("workedBefore");
        QTest::addColumn<double>("clearanceM");
        QTest::newRow("from a way") << false << 1.5 - std::sqrt(2.0);
        QTest::newRow("from work") << true << 1.5 - std::hypot(1.5, 0.5);
    }
    void turnsOnTheSpotWithTheImplementUp() {
        QFETCH(bool, workedBefore);
        QFETCH(double, clearanceM);
        MachineSpec spec = plainMachine(3.0).spec();
        spec.tractor.canTurnInPlace = true;
        spec.implement.raisedWidth = metres(1.0);
        PathDrawer drawer{{1.5, 10.0}, 0.5 * kPi};
        drawer.begin(workedBefore ? SegmentKind::HeadlandPass : SegmentKind::Turn, workedBefore)
            .straight(20.0)
            .jumpTo({1.5, 30.0}, 0.0)
            .begin(SegmentKind::Swath, true, 1)
            .straight(50.0);
        const AuditReport report =
            reportOf({rectangle(100.0, 60.0)}, Machine::create(spec).value(), drawer.segments);
        COMPARE_WITHIN(report.minClearance->si(), clearanceM, 2e-3);
    }

    // A field of 100 x 40 m, lanes of 10 m. Worked by hand.
    void lanes_data() {
        QTest::addColumn<std::vector<Lane>>("lanes");
        QTest::addColumn<Expected>("expected");
        QTest::newRow("tiled") << std::vector<Lane>{{5, 0, 100}, {15, 0, 100}, {25, 0, 100}, {35, 0, 100}}
                               << Expected{4000, 0, 0, 0};
        QTest::newRow("two swaths overlap by 2 m")
            << std::vector<Lane>{{5, 0, 100}, {13, 0, 100}} << Expected{1800, 2200, 200, 0};
        // [0,10], [4,14], [8,18]: twice or more in [4,10] and [8,14], together [4,14].
        QTest::newRow("three overlapping passes")
            << std::vector<Lane>{{5, 0, 100}, {9, 0, 100}, {13, 0, 100}} << Expected{1800, 2200, 1000, 0};
        QTest::newRow("the same lane three times")
            << std::vector<Lane>{{5, 0, 100}, {5, 0, 100}, {5, 0, 100}} << Expected{1000, 3000, 1000, 0};
        QTest::newRow("a gap of 1 m between")
            << std::vector<Lane>{{5, 0, 100}, {16, 0, 100}} << Expected{2000, 2000, 0, 0};
        QTest::newRow("begins and ends outside the field")
            << std::vector<Lane>{{5, -20, 130}, {5, -20, 130}} << Expected{1000, 3000, 1000, 0};
        QTest::newRow("driven the other way")
            << std::vector<Lane>{{5, 100, 0}, {15, 0, 100}} << Expected{2000, 2000, 0, 0};
        QTest::newRow("a headland pass under a swath")
            << std::vector<Lane>{{5, 0, 100, SegmentKind::HeadlandPass},
                                 {9, 0, 100},
                                 {19, 0, 50},
                                 {17, 0, 50}}
            << Expected{1900, 2100, 1100, 600};
    }
    void lanes() {
        QFETCH(std::vector<Lane>, lanes);
        QFETCH(Expected, expected);
        PathDrawer drawer{{0.0, 0.0}};
        for (const Lane& lane : lanes) {
            drawer.jumpTo({lane.x0, lane.y}, lane.x1 > lane.x0 ? 0.0 : kPi);
            drawer.begin(lane.kind, true).straight(std::abs(lane.x1 - lane.x0));
        }
        const AuditReport report = reportOf({rectangle(100, 40)}, plainMachine(10.0), drawer.segments);
        COMPARE_WITHIN(report.covered->si(), expected.covered, 1e-3);
        COMPARE_WITHIN(report.missed->si(), expected.missed, 1e-3);
        COMPARE_WITHIN(report.overlap->si(), expected.overlap, 1e-3);
        COMPARE_WITHIN(area(report.overlapAreas).si(), expected.overlap, 1e-2);
        COMPARE_WITHIN(report.overlapHeadland->si(), expected.overlapHeadland, 1e-3);
        COMPARE_WITHIN(*report.coveredShare, expected.covered / 4000.0, 1e-9);
    }

    /// The swath of the second lane begins 2 m late and ends 2 m early, and lies 5 cm away from the first:
    /// two pieces of 2 x 10 m, and a hair between them that nobody works.
    void aHairJoinsNoPieces() {
        PathDrawer drawer{{0.0, 0.0}};
        for (const Lane& lane :
             {Lane{5.0, 0, 100}, Lane{15.05, 2, 98}, Lane{25.0, 0, 100}, Lane{35.0, 0, 100}}) {
            drawer.jumpTo({lane.x0, lane.y}, 0.0);
            drawer.begin(lane.kind, true).straight(lane.x1 - lane.x0);
        }
        const AuditReport report = reportOf({rectangle(100, 40)}, plainMachine(10.0), drawer.segments);
        QCOMPARE(report.leftAreas.size(), std::size_t{2});
        for (const Polygon& piece : report.leftAreas) {
            COMPARE_WITHIN(area(piece).si(), 20.0, 0.3);
        }
    }

    void whatIsMissedIsAPolygon() {
        PathDrawer drawer{{0.0, 5.0}};
        drawer.begin(SegmentKind::Swath, true).straight(100.0);
        drawer.jumpTo({0.0, 16.0}, 0.0).begin(SegmentKind::Swath, true).straight(100.0);
        const AuditReport report = reportOf({rectangle(100, 21)}, plainMachine(10.0), drawer.segments);
        QCOMPARE(report.missedAreas.size(), std::size_t{1});
        COMPARE_WITHIN(area(report.missedAreas.front()).si(), 100.0, 1e-4);
        const Bounds box = bounds(report.missedAreas);
        COMPARE_WITHIN(box.min.y, 10.0, 1e-6);
        COMPARE_WITHIN(box.max.y, 11.0, 1e-6);
    }

    void implementUpWorksNothing() {
        PathDrawer drawer{{0.0, 5.0}};
        drawer.begin(SegmentKind::Swath, false).straight(100.0);
        const AuditReport report = reportOf({rectangle(100, 10)}, plainMachine(10.0), drawer.segments);
        COMPARE_WITHIN(report.covered->si(), 0.0, 1e-9);
    }

    // The working line is 3 m behind and 0.5 m to the left: it works from x = -3 to 97, y from 0.5 to 10.5.
    void implementIsWhereItIs() {
        MachineSpec spec = plainMachine(10.0).spec();
        spec.implement.offset = metres(-3.0);
        spec.implement.lateralOffset = metres(0.5);
        PathDrawer drawer{{0.0, 5.0}};
        drawer.begin(SegmentKind::Swath, true).straight(100.0);
        const AuditReport report =
            reportOf({rectangle(100, 10)}, Machine::create(spec).value(), drawer.segments);
        COMPARE_WITHIN(report.covered->si(), 97.0 * 9.5, 1e-3);
    }

    // A full ring around (0, 0): pi ((R + w/2)² - (R - w/2)²) = 2 pi R w.
    void ringWithinItsErrorBound_data() {
        QTest::addColumn<double>("radius");
        QTest::addColumn<int>("samples");
        QTest::newRow("wide") << 20.0 << 90;
        QTest::newRow("tight") << 3.0 << 40;
        QTest::newRow("few samples") << 20.0 << 12;
    }
    void ringWithinItsErrorBound() {
        QFETCH(double, radius);
        QFETCH(int, samples);
        PathDrawer drawer{{0.0, -radius}};
        drawer.begin(SegmentKind::HeadlandPass, true).arc(2.0 * kPi * radius, 1.0 / radius, samples);
        const AuditReport report = reportOf({centredRectangle(100, 100)}, plainMachine(4.0), drawer.segments);
        const double exact = 2.0 * kPi * radius * 4.0;
        COMPARE_WITHIN(report.covered->si(), exact, report.areaError.si());
        // The bound is worth something.
        QVERIFY2(report.areaError.si() < 0.006 * exact, qPrintable(QString::number(report.areaError.si())));
    }

    // The inner end stands still or goes back: a whole disc, not a ring with a negative hole.
    void turningAboutAPointOfTheImplement() {
        PathDrawer drawer{{0.0, -1.0}};
        drawer.begin(SegmentKind::HeadlandPass, true).arc(2.0 * kPi, 1.0, 60);
        const AuditReport report =
            reportOf({centredRectangle(100, 100)}, plainMachine(4.0, 1.0), drawer.segments);
        COMPARE_WITHIN(report.covered->si(), kPi * 9.0, 0.5);
    }

    // Around a field of 100 x 60 m, 4 m wide, 2 m from the boundary: length times width, as the corners are
    // wider than half the pass. A swath of 4 m that runs 3 m into it at either end.
    void headlandPassWithRoundedCorners() {
        constexpr double kRadius = 5.0;
        PathDrawer drawer{{2.0 + kRadius, 2.0}};
        drawer.begin(SegmentKind::HeadlandPass, true);
        for (const double side : {96.0, 56.0, 96.0, 56.0}) {
            drawer.straight(side - 2.0 * kRadius).arc(0.5 * kPi * kRadius, 1.0 / kRadius, 20);
        }
        drawer.jumpTo({1.0, 30.0}, 0.0).begin(SegmentKind::Swath, true).straight(98.0);
        const AuditReport report = reportOf({rectangle(100, 60)}, plainMachine(4.0), drawer.segments);
        const double pass = 4.0 * (2.0 * (86.0 + 46.0) + 2.0 * kPi * kRadius);
        COMPARE_WITHIN(report.covered->si(), pass + 4.0 * (98.0 - 6.0), report.areaError.si() + 1e-6);
        COMPARE_WITHIN(report.overlap->si(), 24.0, 1e-6);
        COMPARE_WITHIN(report.overlapHeadland->si(), 24.0, 1e-6);
        QVERIFY(report.areaError.si() < 1.0);
    }
    // Turning at right angles about a point of its own, the line comes over one square metre before and
    // after.
    void overlapWithinOneSegment() {
        PathDrawer drawer{{-20.0, 0.0}};
        drawer.begin(SegmentKind::HeadlandPass, true).straight(20.0).arc(0.5 * kPi, 1.0, 40).straight(20.0);
        const AuditReport report =
            reportOf({centredRectangle(100, 100)}, plainMachine(4.0, 1.0), drawer.segments);
        COMPARE_WITHIN(report.overlap->si(), 1.0, 1e-6);
        COMPARE_WITHIN(report.overlapHeadland->si(), 0.0, 1e-6);
    }

    void holesAreNotCovered() {
        MultiPolygon field{rectangle(100, 10)};
        field.front().holes.push_back({{40, 2}, {40, 8}, {60, 8}, {60, 2}});
        PathDrawer drawer{{0.0, 5.0}};
        drawer.begin(SegmentKind::Swath, true).straight(100.0);
        const AuditReport report = reportOf(field, plainMachine(10.0), drawer.segments);
        COMPARE_WITHIN(report.covered->si(), 1000.0 - 120.0, 1e-3);
        COMPARE_WITHIN(report.missed->si(), 0.0, 1e-3);
    }

    // Driving area 30 x 30, disc of 5 m: the opening lacks (4 - pi) 25 m² at the corners. A lane covers 120
    // m². What cannot reverse gets round a corner on full lock, its implement's outer end on a circle of 4 +
    // 5 m; pulled 3 m behind the axle, of sqrt(4² - 3²) + 5 m.
    void coveredOfReachableLeavesCornersOut_data() {
        QTest::addColumn<bool>("reverses");
        QTest::addColumn<double>("behindM");
        QTest::addColumn<double>("radiusM");
        QTest::newRow("reverses") << true << 0.0 << 5.0;
        QTest::newRow("forwards only") << false << 0.0 << 9.0;
        QTest::newRow("forwards only, trailed") << false << 3.0 << 5.0 + std::sqrt(7.0);
        QTest::newRow("trailed, does not reverse what it pulls") << true << 3.0 << 5.0 + std::sqrt(7.0);
    }
    void coveredOfReachableLeavesCornersOut() {
        QFETCH(bool, reverses);
        QFETCH(double, behindM);
        QFETCH(double, radiusM);
        PathDrawer drawer{{9.0 + behindM, 15.0}};
        drawer.begin(SegmentKind::Swath, true).straight(12.0);
        MachineSpec spec = plainMachine(10.0, 4.0).spec();
        spec.tractor.canReverse = reverses;
        if (behindM > 0.0) {
            spec.implement.mounting = Mounting::Trailed;
            spec.implement.canReverse = false;
            spec.implement.hitchOffset = metres(0.0);
            spec.implement.offset = metres(-behindM);
        }
        const AuditReport report =
            reportOf({rectangle(30, 30)}, Machine::create(spec).value(), drawer.segments);
        const double reachable = 900.0 - (4.0 - kPi) * radiusM * radiusM;
        COMPARE_WITHIN(*report.coveredOfReachable, 120.0 / reachable, 5e-4);  // its corners are drawn to 2 cm
        COMPARE_WITHIN(*report.coveredShare, 120.0 / 900.0, 1e-6);
    }

    // A tractor of 8 m, its axle 3 m before its rear, in front of it and behind it broader than the implement
    // of 10 m: that stays off every edge by half the difference, or by what the tractor reaches beyond it.
    void narrowImplementKeepsOffTheEdge_data() {
        QTest::addColumn<double>("tractorM");
        QTest::addColumn<double>("offsetM");
        QTest::addColumn<double>("keptAwayM");
        QTest::newRow("as broad") << 10.0 << 0.0 << 0.0;
        QTest::newRow("broader by 0.6 m") << 10.6 << 0.0 << 0.3;
        QTest::newRow("broader by 2 m") << 12.0 << 0.0 << 1.0;
        QTest::newRow("implement half a metre behind the rear") << 12.0 << -3.0 << 0.5;
    }
    void narrowImplementKeepsOffTheEdge() {
        QFETCH(double, tractorM);
        QFETCH(double, offsetM);
        QFETCH(double, keptAwayM);
        MachineSpec spec = plainMachine(10.0, 4.0).spec();
        spec.tractor.width = metres(tractorM);
        spec.tractor.length = metres(8.0);
        spec.tractor.rearOverhang = metres(3.0);
        spec.implement.offset = metres(offsetM);
        PathDrawer drawer{{9.0 - offsetM, 15.0}};
        drawer.begin(SegmentKind::Swath, true).straight(12.0);
        const AuditReport report =
            reportOf({rectangle(30, 30)}, Machine::create(spec).value(), drawer.segments);
        const double inside = 30.0 - 2.0 * keptAwayM;
        const double cornerM = 0.5 * tractorM - keptAwayM;
        const double reachable = inside * inside - (4.0 - kPi) * cornerM * cornerM;
        COMPARE_WITHIN(*report.coveredOfReachable, 120.0 / reachable, 5e-4);
    }

    // 10 m wide, lane from x = 0 to 100 at y = 3 in a field that begins at y = 0: 2 m stick out.
    void outsideIsMeasured() {
        PathDrawer drawer{{10.0, 3.0}};
        drawer.begin(SegmentKind::Swath, true).straight(80.0);
        const AuditReport report = reportOf({rectangle(100, 40)}, plainMachine(10.0), drawer.segments);
        // The implement is 1 m long: swept from 9.5 to 90.5.
        COMPARE_WITHIN(report.outside->si(), 81.0 * 2.0, 1e-3);
        COMPARE_WITHIN(report.minClearance->si(), -2.0, 1e-6);
    }
    void clearanceInside_data() {
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("expected");
        QTest::newRow("touching") << 5.0 << 0.0;
        QTest::newRow("half a metre") << 5.5 << 0.5;
        QTest::newRow("far from the edge") << 200.0 << 195.0;
    }
    void clearanceInside() {
        QFETCH(double, y);
        QFETCH(double, expected);
        PathDrawer drawer{{1000.0, y}};
        drawer.begin(SegmentKind::Swath, true).straight(80.0);
        const AuditReport report = reportOf({rectangle(2000, 400)}, plainMachine(10.0), drawer.segments);
        COMPARE_WITHIN(report.outside->si(), 0.0, 1e-3);
        COMPARE_WITHIN(report.minClearance->si(), expected, 1e-6);
    }
    // A pole of 0.4 m between the wheels: no corner of the footprint is in it.
    void somethingSmallUnderTheMachine() {
        MultiPolygon field{rectangle(100, 40)};
        field.front().holes.push_back({{50, 20}, {50, 20.4}, {50.4, 20.4}, {50.4, 20}});
        PathDrawer drawer{{10.0, 20.0}};
        drawer.begin(SegmentKind::Swath, true, 1).straight(80.0);
        const AuditReport report = reportOf(field, plainMachine(10.0), drawer.segments);
        COMPARE_WITHIN(report.outside->si(), 0.16, 1e-4);
        QVERIFY(report.minClearance->si() < 0.0);
        QCOMPARE(report.findings.front().finding.kind, FindingKind::Obstacle);
    }
    // A wedge lies in what is swept, from the side to the corner where it ends: no corner of either is within
    // the other. The circle in it has a radius of (6 + 2 - sqrt 40) / 2 = 0.84 m.
    void aWedgeFromSideToCorner() {
        MultiPolygon field{rectangle(100, 40)};
        field.front().holes.push_back({{21, 21}, {21, 19}, {15, 19}});
        PathDrawer drawer{{10.0, 20.0}};
        drawer.begin(SegmentKind::Swath, true, 1).straight(10.0);
        const AuditReport report = reportOf(field, plainMachine(2.0), drawer.segments);
        COMPARE_WITHIN(report.outside->si(), 6.0, 1e-3);
        QVERIFY2(report.minClearance->si() < -0.4, qPrintable(QString::number(report.minClearance->si())));
        QCOMPARE(report.findings.front().finding.kind, FindingKind::Obstacle);
    }
    // Through a gate 12 m wide the machine may leave the field.
    void gatesAreOpen() {
        PathDrawer drawer{{50.0, 20.0}, -0.5 * kPi};
        drawer.begin(SegmentKind::Transfer, false).straight(18.0);
        AuditInput input{.workable = {rectangle(100, 40)}, .drivable = {rectangle(100, 40)}};
        input.machine = plainMachine(2.0);
        input.segments = drawer.segments;
        QVERIFY(audit(input).value().outside->si() == 0.0);
        PathDrawer out{{50.0, 20.0}, -0.5 * kPi};
        out.begin(SegmentKind::Transfer, false).straight(22.0);
        input.segments = out.segments;
        QVERIFY(audit(input).value().outside->si() > 1.0);
        input.gates = {{{50.0, 0.0}, metres(12.0)}};
        COMPARE_WITHIN(audit(input).value().outside->si(), 0.0, 1e-6);
    }
    // 6 m behind the hitch on a circle of 8 m. Rigid, its rear corner is hypot(7.5, 10) m from the centre;
    // trailed, it stays inside the circle of the hitch.
    void trailedImplementIsWhereItsTrackIs() {
        MachineSpec spec = trailing(4.0, 8.0, -7.0);
        PathDrawer drawer{{80.0, 20.0}};
        drawer.begin(SegmentKind::Turn, false).straight(20.0).arc(12.0 * kPi, 0.125, 90);
        const auto clearance = [&](Mounting mounting) {
            spec.implement.mounting = mounting;
            return reportOf({rectangle(200, 100)}, Machine::create(spec).value(), drawer.segments);
        };
        COMPARE_WITHIN(clearance(Mounting::Mounted).minClearance->si(), 28.0 - std::hypot(7.5, 10.0), 0.02);
        QVERIFY(clearance(Mounting::Mounted).minClearance->si() <
                clearance(Mounting::Trailed).minClearance->si());
        QVERIFY(clearance(Mounting::Trailed).maxHitchAngle->si() > 0.5);
        QVERIFY(!clearance(Mounting::Mounted).maxHitchAngle);
    }
    // Out of a bend to the left and 500 m along an edge on the right, 12.02 m from it: the boom of 24 m comes
    // in from the left. The little that its hitch is bent after 20 m was taken for an arc over all the rest,
    // 2 cm outside.
    void straightForLongAfterABend() {
        PathDrawer drawer{{10.0, 20.0}};
        drawer.begin(SegmentKind::HeadlandPass, true)
            .straight(30.0)
            .arc(3.5 * kPi, 1.0 / 7.0, 20)
            .straight(500.0);
        const AuditReport report = reportOf(
            {rectangle(59.02, 600)}, Machine::create(trailing(24.0, 7.0, -6.2)).value(), drawer.segments);
        COMPARE_WITHIN(report.minClearance->si(), 0.02, 0.01);
        COMPARE_WITHIN(report.outside->si(), 0.0, 1e-6);
    }
    // Round a pond on 8 m, 4 m wide: its inner side passes 6 m from the middle, 1 cm from the water. Between
    // two samples, 0.16 rad apart, the straight hull of that side would be 2 cm nearer.
    void roundAPondByACentimetre() {
        constexpr int kSides = 720;
        MultiPolygon field{rectangle(100, 60)};
        Ring& pond = field.front().holes.emplace_back();
        for (int i = 0; i < kSides; ++i) {
            pond.push_back(Point{50.0, 30.0} + 5.99 * direction(-2.0 * kPi * i / kSides));
        }
        PathDrawer drawer{{50.0, 22.0}};
        drawer.begin(SegmentKind::Turn, true).arc(15.0 * kPi, 0.125, 37);
        const AuditReport report = reportOf(field, plainMachine(4.0, 8.0), drawer.segments);
        COMPARE_WITHIN(report.minClearance->si(), 0.01, 1e-3);
        COMPARE_WITHIN(report.outside->si(), 0.0, 1e-6);
    }
    void cancels() {
        PathDrawer drawer{{0.0, 5.0}};
        drawer.begin(SegmentKind::Swath, true).straight(100.0);
        std::stop_source source;
        source.request_stop();
        JobContext job;
        job.stop = source.get_token();
        const auto report = audit({.workable = {rectangle(100, 10)},
                                   .drivable = {rectangle(100, 10)},
                                   .machine = plainMachine(10.0),
                                   .segments = drawer.segments},
                                  job);
        QVERIFY(!report);
        QCOMPARE(report.error().code, ErrorCode::Cancelled);
    }
    void cancelsAtAnyReport_data() {
        QTest::addColumn<int>("threads");
        QTest::newRow("one thread") << 1;
        QTest::newRow("four threads") << 4;
    }
    void cancelsAtAnyReport() {
        QFETCH(int, threads);
        const std::vector<PathSegment> segments = weavingPath(40, 200.0);
        const AuditInput input{.workable = {rectangle(200, 400)},
                               .drivable = {rectangle(200, 400)},
                               .machine = plainMachine(10.0, 5.0),
                               .segments = segments};
        int count = 0;
        QVERIFY(audit(input, {.progress = [&](double) { ++count; }, .threads = 1}));
        QVERIFY(count > 20);
        for (int k = 1; k < count; k += 5) {
            std::stop_source source;
            std::atomic<int> reports = 0;
            const JobContext job{.stop = source.get_token(),
                                 .progress =
                                     [&](double share) {
                                         if (++reports == k && share < 1.0) {
                                             source.request_stop();
                                         }
                                     },
                                 .threads = threads};
            const auto report = audit(input, job);
            QVERIFY2(!report || !source.stop_requested(), qPrintable(QString::number(k)));
        }
    }
    // The answer comes within milliseconds, wherever the request comes in; 250 are for a busy computer.
    void cancelsSoon() {
        const std::vector<PathSegment> segments = weavingPath(3000, 3000.0);
        const AuditInput input{.workable = {rectangle(3000, 30000)},
                               .drivable = {rectangle(3000, 30000)},
                               .machine = plainMachine(10.0, 5.0),
                               .segments = segments};
        using Clock = std::chrono::steady_clock;
        double slowest = 0.0;
        for (const int afterMs : {1, 5, 10, 20, 40, 60, 80, 120, 160, 200}) {
            std::stop_source source;
            std::atomic<Clock::time_point> asked{};
            std::jthread asker{[&] {
                std::this_thread::sleep_for(std::chrono::milliseconds{afterMs});
                asked = Clock::now();
                source.request_stop();
            }};
            const auto report = audit(input, {.stop = source.get_token()});
            if (!report) {
                slowest = std::max(
                    slowest, std::chrono::duration<double, std::milli>(Clock::now() - asked.load()).count());
            }
        }
        qInfo("answered within %.1f ms", slowest);
        QVERIFY(slowest < 250.0);
    }
};

FURROW_TEST(TestAuditAreas);
#include "tst_audit_areas.moc"
