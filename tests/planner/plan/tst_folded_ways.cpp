// Ways that only a folded machine can drive: two rooms of 60 m by 60 m, joined by a lane of 30 m that is 5 m
// broad. The cultivator's frame is 6 m broad, and 3 m on the road.

#include "planner/io/delivery/plan_folder.h"
#include "planner/io/plan_files/plan_reader.h"
#include "planner/machine/machine_library.h"
#include "planner/path/folded_stretches.h"
#include "planner/path/speed_profile.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace furrow;

namespace {

constexpr double kFoldS = 40.0;
constexpr std::string_view kRooms =
    "POLYGON ((0 0, 60 0, 60 27.5, 90 27.5, 90 0, 150 0, 150 60, 90 60, 90 32.5, 60 32.5, 60 60, 0 60))";

Machine folding(Duration time, std::string_view id = "cultivator") {
    MachineSpec spec = findMachine(id).value().spec();
    spec.implement.timeToFold = time;
    return Machine::create(spec).value();
}

Machine rigid() {
    MachineSpec spec = findMachine("cultivator").value().spec();
    spec.implement.transportWidth.reset();
    return Machine::create(spec).value();
}

Result<std::shared_ptr<const Plan>> planned(std::string_view outline, const Machine& machine) {
    const FieldSource source = test::fieldSourceFromLocal(test::polygonsFromWkt(outline), {9.2, 51.3});
    return makePlan({.field = std::make_shared<const Field>(Field::create(source).value()),
                     .machine = machine,
                     .settings = {}});
}

std::vector<Finding> foldedIn(const std::vector<Finding>& findings) {
    std::vector<Finding> found;
    std::ranges::copy_if(findings, std::back_inserter(found),
                         [](const Finding& finding) { return finding.kind == FindingKind::Folded; });
    return found;
}

/// The audit of a plan whose path was changed.
template <typename Change>
AuditReport audited(const Plan& plan, const Change& change) {
    std::vector<PathSegment> segments = plan.path.segments;
    change(segments, foldedStretches(segments).front());
    AuditInput input = auditInput(plan);
    input.segments = segments;
    return audit(input).value();
}

bool blocks(const AuditReport& report, FindingKind kind) {
    return std::ranges::any_of(report.findings, [kind](const AuditFinding& found) {
        return found.finding.severity == Severity::Blocking && found.finding.kind == kind;
    });
}

/// 40 m of work, 40 m of way and 40 m of work, straight on.
Path straightOn(bool folded, const Machine& machine) {
    std::vector<Leg> legs;
    for (int i = 0; i < 3; ++i) {
        legs.push_back({.kind = i == 1 ? SegmentKind::Transfer : SegmentKind::Swath,
                        .number = i + 1,
                        .line = {.type = {},
                                 .start = {.position = {40.0 * i, 0.0}, .heading = {}},
                                 .pieces = {{.length = metres(40.0), .curvature = {}}}},
                        .implementDown = i != 1,
                        .folded = folded && i == 1});
    }
    return withSpeeds(legs, machine);
}

}  // namespace

class FoldedWaysTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        const auto made = planned(kRooms, folding(seconds(kFoldS)));
        VERIFY_RESULT(made);
        plan_ = *made;
    }

    // At each end of the way it brakes, folds or unfolds, and sets off again. A stop from speed v costs
    // v / 2a for braking and as much for setting off.
    void foldingTakesItsTime_data() {
        QTest::addColumn<double>("foldS");
        QTest::newRow("at once") << 0.0;
        QTest::newRow("40 s") << 40.0;
    }
    void foldingTakesItsTime() {
        QFETCH(double, foldS);
        MachineSpec spec = folding(seconds(foldS)).spec();
        spec.tractor.workingSpeed = metresPerSecond(2.0);
        spec.tractor.transferSpeed = metresPerSecond(2.0);
        spec.tractor.maxAcceleration = Acceleration::fromSi(0.5);
        const Machine machine = Machine::create(spec).value();
        const Path raised = straightOn(false, machine);
        const Path folded = straightOn(true, machine);
        COMPARE_WITHIN((folded.duration() - raised.duration()).si(), 2.0 * (foldS + 2.0 / 0.5), 1e-9);
        const PathSegment& way = folded.segments[1];
        QVERIFY(way.folded && !folded.segments[0].folded && !folded.segments[2].folded);
        QCOMPARE(way.samples.front().speedMps, 0.0);
        QCOMPARE(way.samples.back().speedMps, 0.0);
        COMPARE_WITHIN(way.samples.front().tS - folded.segments[0].samples.back().tS, foldS, 1e-9);
        COMPARE_WITHIN(folded.segments[2].samples.front().tS - way.samples.back().tS, foldS, 1e-9);
        COMPARE_WITHIN(foldingTime(folded.segments, machine).si(), 2.0 * foldS, 0.0);
        QVERIFY(foldedStretches(folded.segments) == (std::vector<FoldedStretch>{{1, 1}}));
        QVERIFY(foldedStretches(raised.segments).empty());
    }

    // Both rooms are worked, the lane is crossed once and folded.
    void aLaneIsDrivenFolded() {
        QVERIFY2(plan_->drivable(), plan_->findings.front().text.c_str());
        const auto stretches = foldedStretches(plan_->path.segments);
        QCOMPARE(stretches.size(), std::size_t{1});
        const Bounds box = bounds(plan_->field().drivable());
        const auto isEast = [&](const PathSegment* work) {
            return work->samples.front().position.x > 0.5 * (box.min.x + box.max.x);
        };
        QVERIFY(isEast(plan_->path.workBefore(stretches.front().first)) !=
                isEast(plan_->path.workAfter(stretches.front().last)));
        const std::vector<Finding> notes = foldedIn(plan_->findings);
        QCOMPARE(notes.size(), std::size_t{1});
        QVERIFY(notes.front().severity == Severity::Note);
        QVERIFY(notes.front().place ==
                plan_->path.segments[stretches.front().first].samples.front().position);
        QVERIFY(notes.front().text.starts_with("The implement is folded on the way from "));
        COMPARE_WITHIN(plan_->audit.outside->si(), 0.0, 0.5);
    }

    // A trailed boom of 24 m, 3 m on the road. Its finishing passes are reached folded, too.
    void aWideBoomIsFoldedForTheLane() {
        MachineSpec spec = folding(seconds(kFoldS), "trailed-sprayer").spec();
        spec.implement.transportWidth = metres(3.0);
        const auto made = planned(kRooms, Machine::create(spec).value());
        VERIFY_RESULT(made);
        const Plan& plan = **made;
        QVERIFY2(plan.drivable(), plan.findings.front().text.c_str());
        const auto stretches = foldedStretches(plan.path.segments);
        QVERIFY(!stretches.empty());
        QCOMPARE(foldedIn(plan.findings).size(), stretches.size());
        COMPARE_WITHIN(foldingTime(plan.path.segments, plan.request.machine).si(),
                       2.0 * kFoldS * static_cast<double>(stretches.size()), 1e-9);
        spec.implement.transportWidth.reset();
        const auto rigid = planned(kRooms, Machine::create(spec).value());
        VERIFY_RESULT(rigid);
        QVERIFY(!(*rigid)->drivable());
    }

    // 60 s more to fold are 120 s more of the same drive.
    void slowerFoldingOnlyTakesLonger() {
        const auto slower = planned(kRooms, folding(seconds(kFoldS + 60.0)));
        VERIFY_RESULT(slower);
        COMPARE_WITHIN(((*slower)->path.duration() - plan_->path.duration()).si(), 120.0, 1e-6);
        QCOMPARE((*slower)->path.length().si(), plan_->path.length().si());
    }

    void withoutATransportWidthItStaysBlocked() {
        const auto blocked = planned(kRooms, rigid());
        VERIFY_RESULT(blocked);
        QVERIFY(!(*blocked)->drivable());
        QVERIFY(foldedStretches((*blocked)->path.segments).empty());
        QVERIFY(std::ranges::any_of((*blocked)->findings, [](const Finding& finding) {
            return finding.severity == Severity::Blocking && finding.kind == FindingKind::Outside;
        }));
    }

    // A lane of 12 m lets the raised frame through, and nothing is folded.
    void nothingIsFoldedWhereARaisedWayLeads() {
        const auto made = planned(
            "POLYGON ((0 0, 60 0, 60 24, 90 24, 90 0, 150 0, 150 60, 90 60, 90 36, 60 36, 60 60, 0 60))",
            folding(seconds(kFoldS)));
        VERIFY_RESULT(made);
        QVERIFY(foldedStretches((*made)->path.segments).empty());
        QVERIFY(foldedIn((*made)->findings).empty());
    }

    void theAuditWantsItToStand() {
        const AuditReport intact = audited(*plan_, [](auto&, FoldedStretch) {});
        QVERIFY(!blocks(intact, FindingKind::Folded) && !blocks(intact, FindingKind::Outside));
        // Everything after the way is a second earlier.
        const AuditReport hasty = audited(*plan_, [](std::vector<PathSegment>& segments, FoldedStretch way) {
            for (std::size_t i = way.last + 1; i < segments.size(); ++i) {
                for (PathSample& sample : segments[i].samples) {
                    sample.tS -= 1.0;
                }
            }
        });
        QVERIFY(blocks(hasty, FindingKind::Folded));
        const AuditReport rolling =
            audited(*plan_, [](std::vector<PathSegment>& segments, FoldedStretch way) {
                segments[way.first].samples.front().speedMps = 0.1;
            });
        QVERIFY(blocks(rolling, FindingKind::Folded));
    }

    // Said to be raised, the same way leaves the field.
    void theAuditMeasuresTheFoldedWidth() {
        const AuditReport raised = audited(*plan_, [](std::vector<PathSegment>& segments, FoldedStretch way) {
            for (std::size_t i = way.first; i <= way.last; ++i) {
                segments[i].folded = false;
            }
        });
        QVERIFY(blocks(raised, FindingKind::Outside));
    }

    void filesKeepIt() {
        const QTemporaryDir folder;
        VERIFY_RESULT(writePlanFolder(*plan_, folder.path().toStdString(), standardPlanFormats()));
        const auto read = readPlan(folder.path().toStdString());
        VERIFY_RESULT(read);
        QVERIFY(foldedStretches(read->segments) == foldedStretches(plan_->path.segments));
        const auto report = audit(auditInput(*read));
        VERIFY_RESULT(report);
        QVERIFY(!blocks(*report, FindingKind::Outside) && !blocks(*report, FindingKind::Folded));
    }

private:
    std::shared_ptr<const Plan> plan_;
};

FURROW_TEST(FoldedWaysTest);
#include "tst_folded_ways.moc"
