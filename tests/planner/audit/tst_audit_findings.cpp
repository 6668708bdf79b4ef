#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/planner/audit/audit_paths.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <functional>

using namespace furrow;
using namespace furrow::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr GeoPoint kCentre{9.2, 51.3};

using Segments = std::vector<PathSegment>;
using BreakPath = std::function<void(Segments&)>;

std::shared_ptr<const Plan> intactPlan() {
    static const std::shared_ptr<const Plan> plan = [] {
        auto field = Field::create(fieldSourceFromLocal({centredRectangle(160.0, 100.0)}, kCentre)).value();
        Settings mainlandOnly;
        applySetting(mainlandOnly, "headland.driven", "false").value();
        // Every second segment is a turn: these never change gear.
        applySetting(mainlandOnly, "path.method", "dubins").value();
        applySetting(mainlandOnly, "route.method", "boustrophedon").value();
        // No swath lies over its neighbour.
        applySetting(mainlandOnly, "swaths.last_pass", "spread").value();
        return makePlan({.field = std::make_shared<const Field>(std::move(field)),
                         .machine = findMachine("agbot").value(),
                         .settings = mainlandOnly})
            .value();
    }();
    return plan;
}

std::string listed(const std::vector<AuditFinding>& findings) {
    std::string all;
    for (const AuditFinding& each : findings) {
        all += std::string{kindId(each.finding)} + (each.finding.severity == Severity::Blocking ? "!" : "") +
               ": " + each.finding.text + "\n";
    }
    return all;
}

bool hasBlocking(const AuditReport& report, std::string_view kind) {
    return std::ranges::any_of(report.findings, [&](const AuditFinding& each) {
        return kindId(each.finding) == kind && each.finding.severity == Severity::Blocking;
    });
}

void moveAll(PathSegment& segment, const std::function<void(PathSample&)>& move) {
    std::ranges::for_each(segment.samples, move);
}

}  // namespace

Q_DECLARE_METATYPE(BreakPath)

class TestAuditFindings : public QObject {
    Q_OBJECT
private slots:
    void intactPlanIsDrivable() {
        const auto plan = intactPlan();
        QVERIFY(plan->swaths.swaths.size() > 20);
        for (const AuditFinding& each : plan->audit.findings) {
            QVERIFY2(each.finding.severity == Severity::Note, listed(plan->audit.findings).c_str());
        }
        QVERIFY(plan->drivable());
        COMPARE_WITHIN(plan->audit.maxPositionJump->si(), 0.0, 1e-6);
        COMPARE_WITHIN(plan->audit.maxHeadingJump->si(), 0.0, 1e-6);
        // Turns have a reserve of up to 5 % for steering.
        QVERIFY(plan->audit.maxCurvature->si() > 0.95 / 2.1 && plan->audit.maxCurvature->si() < 1.0002 / 2.1);
        COMPARE_WITHIN(plan->audit.outside->si(), 0.0, 1e-6);
        QVERIFY(plan->audit.minClearance->si() >= 0.0);
    }
    void stripIsOneNote() {
        const auto plan = intactPlan();
        QCOMPARE(std::ranges::count(plan->findings, FindingKind::HeadlandNotWorked, &Finding::kind), 1);
    }

    void brokenPlans_data() {
        QTest::addColumn<BreakPath>("breakPath");
        QTest::addColumn<QByteArray>("kind");
        const auto row = [](const char* name, const char* kind, BreakPath breakPath) {
            QTest::newRow(name) << std::move(breakPath) << QByteArray{kind};
        };
        row("a point of a turn moved by 1 m", "jump",
            [](Segments& path) { path[5].samples[path[5].samples.size() / 2].position.x += 1.0; });
        row("the end of a swath moved by 1 m", "jump",
            [](Segments& path) { path[6].samples.back().position.y += 1.0; });
        row("a whole swath moved by 1 m", "jump",
            [](Segments& path) { moveAll(path[6], [](PathSample& at) { at.position.y += 1.0; }); });
        row("a swath left out", "dropped-swath", [](Segments& path) { path.erase(path.begin() + 6); });
        row("the last swath left out", "dropped-swath", [](Segments& path) {
            while (path.back().kind != SegmentKind::Swath) {
                path.pop_back();
            }
            path.pop_back();
        });
        row("a swath driven with the implement up", "dropped-swath",
            [](Segments& path) { path[6].implementDown = false; });
        row("a heading flipped", "heading", [](Segments& path) {
            double& heading = path[5].samples[path[5].samples.size() / 2].headingRad;
            heading = std::fmod(heading + kPi, 2.0 * kPi);
        });
        row("all headings of a swath flipped", "heading", [](Segments& path) {
            moveAll(path[6],
                    [](PathSample& at) { at.headingRad = std::fmod(at.headingRad + kPi, 2.0 * kPi); });
        });
        row("the gear of a turn wrong", "heading", [](Segments& path) { path[5].gear = Gear::Reverse; });
        // Half as large around its start: every curve at half the radius.
        row("a turn too tight", "curvature", [](Segments& path) {
            const PathSample start = path[5].samples.front();
            moveAll(path[5], [&](PathSample& at) {
                at.position = start.position + 0.5 * (at.position - start.position);
                at.sM = start.sM + 0.5 * (at.sM - start.sM);
                at.curvature1pm *= 2.0;
            });
        });
        row("a turn outside the field", "outside", [](Segments& path) {
            moveAll(path[5], [&](PathSample& at) { at.position = 1.6 * at.position; });
        });
        row("a swath that runs out of the field", "outside", [](Segments& path) {
            PathSample& end = path[6].samples.back();
            end.position = end.position + 60.0 * direction(end.headingRad);
        });
        row("two segments swapped", "missing-turn", [](Segments& path) { std::swap(path[4], path[8]); });
        row("a turn left out", "missing-turn", [](Segments& path) { path.erase(path.begin() + 5); });
        row("a turn on the spot", "heading-jump", [](Segments& path) {
            PathSegment& turn = path[5];
            turn.samples = {path[4].samples.back(), path[4].samples.back()};
            turn.samples.back().headingRad += 1.0;
        });
        row("half of the swaths left out", "missed", [](Segments& path) { path.resize(path.size() / 2); });
    }
    void brokenPlans() {
        QFETCH(BreakPath, breakPath);
        QFETCH(QByteArray, kind);
        const auto plan = intactPlan();
        Segments path = plan->path.segments;
        breakPath(path);
        AuditInput input = auditInput(*plan);
        input.segments = path;
        const auto report = audit(input);
        VERIFY_RESULT(report);
        QVERIFY2(hasBlocking(*report, kind.toStdString()), listed(report->findings).c_str());
        for (const AuditFinding& each : report->findings) {
            QVERIFY(!each.finding.text.empty());
        }
    }
    void acrossAnObstacle() {
        const auto plan = intactPlan();
        AuditInput input = auditInput(*plan);
        const Point middle = 0.5 * (plan->path.segments[6].samples.front().position +
                                    plan->path.segments[6].samples.back().position);
        input.drivable.front().holes.push_back({middle + Point{-0.5, -0.5}, middle + Point{-0.5, 0.5},
                                                middle + Point{0.5, 0.5}, middle + Point{0.5, -0.5}});
        const auto report = audit(input);
        VERIFY_RESULT(report);
        QVERIFY2(hasBlocking(*report, "obstacle"), listed(report->findings).c_str());
        QVERIFY(distance(report->findings.front().finding.place, middle) < 3.0);
        QVERIFY(report->outside->si() > 0.9);
        // Allowed, it is told and measured all the same.
        input.mayLeaveField = true;
        const auto allowed = audit(input);
        VERIFY_RESULT(allowed);
        QVERIFY2(!hasBlocking(*allowed, "obstacle"), listed(allowed->findings).c_str());
        QVERIFY2(std::ranges::any_of(
                     allowed->findings,
                     [](const AuditFinding& each) { return each.finding.kind == FindingKind::Outside; }),
                 listed(allowed->findings).c_str());
        QVERIFY(allowed->outside == report->outside && allowed->minClearance == report->minClearance);
    }

    // A path that leads a million kilometres away took all memory there is: it was looked at every 6 m.
    void farAway_data() {
        QTest::addColumn<int>("segment");
        QTest::addColumn<double>("turnRad");
        QTest::newRow("with the implement up") << 7 << 0.0;
        QTest::newRow("with the implement down") << 6 << 0.0;
        QTest::newRow("across all lanes, up") << 7 << 0.5 * kPi;
        QTest::newRow("across all lanes, down") << 6 << 0.5 * kPi;
    }
    void farAway() {
        QFETCH(int, segment);
        QFETCH(double, turnRad);
        const auto plan = intactPlan();
        AuditInput input = auditInput(*plan);
        Segments segments = plan->path.segments;
        std::vector<PathSample>& samples = segments[static_cast<std::size_t>(segment)].samples;
        PathSample far = samples.front();
        far.headingRad += turnRad;
        far.position = far.position + 1e9 * direction(far.headingRad);
        samples.insert(samples.begin() + 1, far);
        input.segments = segments;
        const auto report = audit(input);
        VERIFY_RESULT(report);
        QVERIFY2(hasBlocking(*report, "outside"), listed(report->findings).c_str());
        // There and back, about as wide as it is.
        QVERIFY2(report->outside->si() > 1e9 && report->outside->si() < 1e10,
                 QByteArray::number(report->outside->si()).constData());
    }

    // What the planner has said is not said twice, and what it has not found counts all the same.
    void undrivableConnectionsAreToldOnce() {
        Settings settings;
        auto field = Field::create(fieldSourceFromLocal({centredRectangle(120.0, 80.0)}, kCentre)).value();
        // Too little room for its turns.
        VERIFY_RESULT(applySetting(settings, "headland.passes", "1"));
        VERIFY_RESULT(applySetting(settings, "headland.driven", "false"));
        const auto plan = makePlan({.field = std::make_shared<const Field>(std::move(field)),
                                    .machine = findMachine("cultivator").value(),
                                    .settings = settings});
        VERIFY_RESULT(plan);
        QVERIFY((*plan)->path.undrivableCount() > 0);
        const auto outside = std::ranges::count_if((*plan)->findings, [](const Finding& each) {
            // Swaths that leave it are told, too.
            return (each.kind == FindingKind::Outside || each.kind == FindingKind::Undrivable) &&
                   !each.text.text().starts_with("Swath");
        });
        QCOMPARE(outside, (*plan)->path.undrivableCount());
        // The audit itself names every one of them.
        std::size_t named = 0;
        for (const AuditFinding& each : (*plan)->audit.findings) {
            named += each.segment && !(*plan)->path.segments[*each.segment].drivable;
        }
        // A way in several gears has several segments.
        QVERIFY(static_cast<int>(named) >= (*plan)->path.undrivableCount());
    }

    // Curvature from the points: arcs exactly, clothoids between the values of their ends, both gears.
    void curvatureIsReDerived_data() {
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<int>("gear");
        QTest::newRow("arc to the left") << 0.2 << 0.2 << 1;
        QTest::newRow("arc to the right") << -0.2 << -0.2 << 1;
        QTest::newRow("arc in reverse") << 0.2 << 0.2 << -1;
        QTest::newRow("clothoid") << 0.0 << 0.2 << 1;
        QTest::newRow("clothoid through straight") << -0.2 << 0.2 << 1;
        QTest::newRow("clothoid in reverse") << 0.0 << -0.2 << -1;
    }
    void curvatureIsReDerived() {
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(int, gear);
        PathDrawer drawer{{0.0, 0.0}};
        drawer.begin(SegmentKind::Turn, false, 1, gear > 0 ? Gear::Forward : Gear::Reverse)
            .clothoid(10.0, from, to, 20);
        const auto report = audit({.workable = {centredRectangle(100, 100)},
                                   .drivable = {centredRectangle(100, 100)},
                                   .machine = plainMachine(2.0, 4.9),
                                   .segments = drawer.segments})
                                .value();
        // The last of 20 intervals has the mean of its ends.
        const double largest = std::max(std::abs(from), std::abs(to)) - std::abs(to - from) / 40.0;
        COMPARE_WITHIN(report.maxCurvature->si(), largest, 1e-4);
        COMPARE_WITHIN(report.maxCurvatureMismatch->si(), 0.0, 1e-4);
        COMPARE_WITHIN(report.maxCurvatureRate->si(), std::abs(to - from) / 10.0, 1e-4);
        COMPARE_WITHIN(report.maxPositionJump->si(), 0.0, 1e-4);
        COMPARE_WITHIN(report.maxHeadingJump->si(), 0.0, 1e-3);
        COMPARE_WITHIN(report.reversed.si(), gear < 0 ? 10.0 : 0.0, 0.01);
        QVERIFY2(!hasBlocking(report, "curvature") && !hasBlocking(report, "heading"),
                 listed(report.findings).c_str());
    }
    void steering_data() {
        QTest::addColumn<double>("rampM");
        QTest::addColumn<double>("steeringRadps");
        QTest::addColumn<bool>("fast");
        // atan(2.6 m x 0.2 / m) = 0.4795 rad of the wheels. At 1 m/s a ramp of 3 m has 3 s for it.
        QTest::newRow("a jump") << 0.0 << 0.2 << true;
        QTest::newRow("a ramp that is too short") << 3.0 << 0.14 << true;
        QTest::newRow("a ramp that is long enough") << 3.0 << 0.2 << false;
        QTest::newRow("a jump, and a machine without a stated rate") << 0.0 << 0.0 << false;
    }
    /// A straight in one step, a ramp and an arc at 1 m/s.
    void steering() {
        QFETCH(double, rampM);
        QFETCH(double, steeringRadps);
        QFETCH(bool, fast);
        PathDrawer drawer{{-30.0, 0.0}};
        drawer.begin(SegmentKind::Turn, false, 1).straight(20.0);
        if (rampM > 0.0) {
            drawer.clothoid(rampM, 0.0, 0.2, 10);
        }
        drawer.arc(6.0, 0.2);
        MachineSpec spec = plainMachine(2.0, 4.9).spec();
        if (steeringRadps > 0.0) {
            spec.tractor.steeringRateRadps = steeringRadps;
        }
        const auto report = audit({.workable = {centredRectangle(100, 100)},
                                   .drivable = {centredRectangle(100, 100)},
                                   .machine = Machine::create(spec).value(),
                                   .segments = drawer.segments})
                                .value();
        QCOMPARE(hasBlocking(report, "curvature-rate"), fast);
        for (const auto& [finding, segment] : report.findings) {
            if (finding.kind == FindingKind::CurvatureRate) {
                const double x = finding.place.x;
                QVERIFY2(x > -11.0 && x < -6.5, QByteArray::number(x));
                // 1 m/s x 3 s x 0.14 rad/s / 0.4795 rad = 0.876 m/s for the ramp as a whole; with the wheels
                // straight 0.14 / 2.6 = 0.0538 1/m in a second, 0.81 m/s.
                QVERIFY2(rampM == 0.0 || finding.text.contains("0.81 m/s"), finding.text.c_str());
            }
        }
    }
    void reverseForWhatCannot() {
        PathDrawer drawer{{0.0, 0.0}};
        drawer.begin(SegmentKind::Turn, false, 1, Gear::Reverse).straight(5.0);
        MachineSpec spec = plainMachine(2.0).spec();
        spec.tractor.canReverse = false;
        const auto report = audit({.workable = {centredRectangle(100, 100)},
                                   .drivable = {centredRectangle(100, 100)},
                                   .machine = Machine::create(spec).value(),
                                   .segments = drawer.segments})
                                .value();
        QVERIFY(hasBlocking(report, "reverse"));
    }
    void sameForAnyThreadCount() {
        const auto plan = intactPlan();
        for (const int threads : {1, 2, 8}) {
            JobContext job;
            job.threads = threads;
            QVERIFY(audit(auditInput(*plan), job).value() == plan->audit);
        }
    }
};

FURROW_TEST(TestAuditFindings);
#include "tst_audit_findings.moc"
