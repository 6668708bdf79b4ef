#include "tests/planner/audit/audit_paths.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;
using namespace furrow::test;

namespace {

constexpr double kPi = std::numbers::pi;

/// Lanes of 10 m side by side from x = 0 to 100, numbered from the lowest; "up" goes down across all of them.
std::vector<PathSegment> drawn(const QStringList& order) {
    PathDrawer drawer{{0.0, 0.0}};
    for (const QString& step : order) {
        if (step == "up") {
            drawer.jumpTo({50.0, 40.0}, -0.5 * kPi).begin(SegmentKind::Transfer, false).straight(50.0);
        } else {
            drawer.jumpTo({0.0, 10.0 * step.toInt() - 5.0}, 0.0)
                .begin(SegmentKind::Swath, true, step.toInt())
                .straight(100.0);
        }
    }
    return drawer.segments;
}

AuditReport reportOf(const MultiPolygon& area, const Machine& machine,
                     const std::vector<PathSegment>& segments) {
    return audit({.workable = area, .drivable = area, .machine = machine, .segments = segments}).value();
}

}  // namespace

class TestAuditTraffic : public QObject {
    Q_OBJECT
private slots:
    // The lane that the way leads from, and the one it leads to, are its own.
    void crossedLanes_data() {
        QTest::addColumn<QStringList>("order");
        QTest::addColumn<double>("worked");
        QTest::addColumn<double>("unworked");
        QTest::addColumn<bool>("told");
        QTest::newRow("no way") << QStringList{"1", "2", "3"} << 0.0 << 0.0 << false;
        QTest::newRow("after all") << QStringList{"1", "2", "3", "up"} << 20.0 << 0.0 << true;
        QTest::newRow("before all") << QStringList{"up", "1", "2", "3"} << 0.0 << 20.0 << true;
        QTest::newRow("between neighbours") << QStringList{"1", "2", "up", "3"} << 10.0 << 0.0 << false;
        QTest::newRow("worked and unworked") << QStringList{"1", "2", "up", "3", "4"} << 10.0 << 10.0 << true;
        QTest::newRow("a lane worked twice counts once")
            << QStringList{"1", "1", "2", "up", "3"} << 10.0 << 0.0 << false;
        QTest::newRow("worked before and after")
            << QStringList{"1", "2", "up", "3", "1"} << 10.0 << 0.0 << false;
    }
    void crossedLanes() {
        QFETCH(QStringList, order);
        QFETCH(double, worked);
        QFETCH(double, unworked);
        QFETCH(bool, told);
        const AuditReport report = reportOf({rectangle(100, 50)}, plainMachine(10.0), drawn(order));
        COMPARE_WITHIN(report.drivenOnWorked.si(), worked, 1e-6);
        COMPARE_WITHIN(report.drivenOnUnworked.si(), unworked, 1e-6);
        QCOMPARE(std::ranges::any_of(
                     report.findings,
                     [](const AuditFinding& each) { return each.finding.kind == FindingKind::LanesCrossed; }),
                 told);
    }

    // Wheels run 25 cm inside the sides of a tractor 2 m wide: along y = 4.25 and 5.75, 100 squares each.
    void wheelPasses_data() {
        QTest::addColumn<int>("times");
        QTest::addColumn<double>("heading");
        QTest::addColumn<double>("often");
        QTest::newRow("never") << 0 << 0.0 << 0.0;
        QTest::newRow("once") << 1 << 0.0 << 0.0;
        QTest::newRow("three times") << 3 << 0.0 << 0.0;
        QTest::newRow("four times") << 4 << 0.0 << 0.2;
        QTest::newRow("five times, the other way") << 5 << kPi << 0.2;
    }
    void wheelPasses() {
        QFETCH(int, times);
        QFETCH(double, heading);
        QFETCH(double, often);
        PathDrawer drawer{{0.0, 0.0}};
        for (int i = 0; i < times; ++i) {
            drawer.jumpTo({heading == 0.0 ? 0.5 : 99.5, 5.0}, heading)
                .begin(SegmentKind::Swath, true)
                .straight(99.0);
        }
        const AuditReport report = reportOf({rectangle(100, 10)}, plainMachine(10.0), drawer.segments);
        QCOMPARE(report.mostWheelPasses, times);
        COMPARE_WITHIN(report.oftenDrivenShare, often, 1e-9);
        double squaresM2 = 0.0;
        for (const Bounds& run : report.oftenDriven) {
            squaresM2 += run.width() * run.height();
        }
        COMPARE_WITHIN(squaresM2, often * report.workable.si(), 1e-6);
        COMPARE_WITHIN(report.wheelSquare.si(), 1.0, 0.0);
    }
    // Both wheels in one square, and a way over several segments, are one passage; coming back is another.
    void onePassage() {
        PathDrawer drawer{{1.0, 5.5}};
        drawer.begin(SegmentKind::Swath, true).straight(20.0).begin(SegmentKind::Turn, false).straight(20.0);
        QCOMPARE(reportOf({rectangle(100, 10)}, plainMachine(0.6), drawer.segments).mostWheelPasses, 1);
        drawer.begin(SegmentKind::Turn, false, 0, Gear::Reverse).straight(30.0);
        QCOMPARE(reportOf({rectangle(100, 10)}, plainMachine(0.6), drawer.segments).mostWheelPasses, 2);
    }
    void largeFieldsHaveLargerSquares() {
        PathDrawer drawer{{5.0, 5.0}};
        drawer.begin(SegmentKind::Swath, true).straight(2990.0);
        const AuditReport report = reportOf({rectangle(3000, 3000)}, plainMachine(2.0), drawer.segments);
        COMPARE_WITHIN(report.wheelSquare.si(), 3.0, 0.0);
        QCOMPARE(report.mostWheelPasses, 1);
    }
};

FURROW_TEST(TestAuditTraffic);
#include "tst_audit_traffic.moc"
