// What an implement sweeps beyond the edges that it may stand over. The drivable area is a rectangle of 100
// by 50 m; the implement moves 60 m along its lower edge.

#include "tests/planner/audit/audit_paths.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace furrow;
using namespace furrow::test;

namespace {

constexpr double kWayM = 60.0;
// The implement is 1 m long.
constexpr double kSweptM = kWayM + 1.0;

/// 12 m wide; the tractor 2 m.
Machine machine(bool trailed) {
    MachineSpec spec = plainMachine(12.0).spec();
    spec.implement.hitchOffset = metres(-1.0);
    spec.implement.offset = metres(trailed ? -4.0 : 0.0);
    spec.implement.mounting = trailed ? Mounting::Trailed : Mounting::Mounted;
    return Machine::create(spec).value();
}

AuditReport audited(const Machine& machine, double aboveEdgeM, std::optional<double> overhangM, bool down) {
    PathDrawer drawer{{-30.0, -25.0 + aboveEdgeM}};
    drawer.begin(SegmentKind::Swath, down, 1).straight(kWayM);
    AuditInput input{.workable = {centredRectangle(100, 50)},
                     .drivable = {centredRectangle(100, 50)},
                     .machine = machine,
                     .segments = drawer.segments};
    if (overhangM) {
        input.overhung = {centredRectangle(100.0 + 2.0 * *overhangM, 50.0 + 2.0 * *overhangM)};
    }
    return audit(input).value();
}

std::optional<Severity> severityOf(const AuditReport& report, FindingKind kind) {
    const auto found =
        std::ranges::find(report.findings, kind, [](const AuditFinding& each) { return each.finding.kind; });
    return found == report.findings.end() ? std::nullopt : std::optional{found->finding.severity};
}

}  // namespace

class OverhangAuditTest : public QObject {
    Q_OBJECT

private slots:
    void figures_data() {
        QTest::addColumn<bool>("trailed");
        QTest::addColumn<bool>("down");
        QTest::newRow("mounted, at work") << false << true;
        QTest::newRow("mounted, raised") << false << false;
        QTest::newRow("trailed, at work") << true << true;
    }
    void figures() {
        QFETCH(bool, trailed);
        QFETCH(bool, down);
        // 2 of the 6 m to its right lie outside.
        const AuditReport report = audited(machine(trailed), 4.0, 5.0, down);
        COMPARE_WITHIN(report.overhang.si(), 2.0, 1e-6);
        COMPARE_WITHIN(report.overhangArea.si(), 2.0 * kSweptM, 1e-3);
        COMPARE_WITHIN(report.outside->si(), 0.0, 1e-6);
        // From the implement to the edge of what it may stand over; the tractor is 3 m from its own.
        COMPARE_WITHIN(report.minClearance->si(), 3.0, 1e-6);
        QVERIFY(severityOf(report, FindingKind::Overhang) == Severity::Note);
        QVERIFY(!severityOf(report, FindingKind::Outside));
    }

    void beyondTheOverhangBlocks() {
        const AuditReport report = audited(machine(false), 4.0, 0.5, true);
        COMPARE_WITHIN(report.overhang.si(), 2.0, 1e-6);
        COMPARE_WITHIN(report.overhangArea.si(), 2.0 * kSweptM, 1e-3);
        COMPARE_WITHIN(report.outside->si(), 1.5 * kSweptM, 1e-3);
        COMPARE_WITHIN(report.minClearance->si(), -1.5, 1e-6);
        QVERIFY(severityOf(report, FindingKind::Outside) == Severity::Blocking);
    }

    // Half a metre of the tractor or of the wheels of a trailed implement, 2 m wide, lies outside.
    void wheelsBlock_data() {
        QTest::addColumn<bool>("trailed");
        QTest::addColumn<double>("sweptM");
        QTest::newRow("mounted") << false << kWayM + 2.0;
        // The implement is 4 m behind; it and the tractor sweep one area.
        QTest::newRow("trailed") << true << kWayM + 5.5;
    }
    void wheelsBlock() {
        QFETCH(bool, trailed);
        QFETCH(double, sweptM);
        const AuditReport report = audited(machine(trailed), 0.5, 20.0, true);
        COMPARE_WITHIN(report.outside->si(), 0.5 * sweptM, 1e-3);
        COMPARE_WITHIN(report.minClearance->si(), -0.5, 1e-6);
        COMPARE_WITHIN(report.overhang.si(), 5.5, 1e-6);
        QVERIFY(severityOf(report, FindingKind::Outside) == Severity::Blocking);
    }

    void noneIsNone() {
        const AuditReport report = audited(machine(false), 4.0, std::nullopt, true);
        COMPARE_WITHIN(report.outside->si(), 2.0 * kSweptM, 1e-3);
        COMPARE_WITHIN(report.overhang.si(), 0.0, 0.0);
        COMPARE_WITHIN(report.overhangArea.si(), 0.0, 0.0);
        QVERIFY(severityOf(report, FindingKind::Outside) == Severity::Blocking);
        QVERIFY(!severityOf(report, FindingKind::Overhang));
    }
};

FURROW_TEST(OverhangAuditTest);
#include "tst_overhang.moc"
