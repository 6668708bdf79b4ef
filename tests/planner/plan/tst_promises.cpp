// What a setting says is what the plan does: margins, widths, wet spots, choices that promise time, advice.

#include "planner/io/delivery/plan_folder.h"
#include "planner/io/plan_files/plan_reader.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/advice.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/plan/quicker_choice.h"
#include "planner/plan/stage_cache.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/scratch.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.5, 51.5};
using Given = std::vector<std::pair<std::string, std::string>>;

FieldSource rectangle() {
    return test::fieldSourceFromLocal({test::centredRectangle(400.0, 250.0)}, kCentre);
}

/// With a wet spot of 40 m x 30 m in the middle.
FieldSource withWetSpot() {
    FieldSource source = rectangle();
    const auto frame = LocalFrame::centredOn(kCentre).value();
    source.obstacles.push_back({.name = "wet",
                                .outline = frame.toGeo(test::rectangle(40.0, 30.0, {-20.0, -15.0})),
                                .passable = true,
                                .buffer = {}});
    return source;
}

Result<std::shared_ptr<const Plan>> planned(const FieldSource& source, std::string_view machine,
                                            const Given& given) {
    Settings settings;
    for (const auto& [key, value] : given) {
        applySetting(settings, key, value).value();
    }
    return makePlan({.field = std::make_shared<const Field>(Field::create(source).value()),
                     .machine = findMachine(machine).value(),
                     .settings = settings});
}

Duration timeForAll(const Plan& plan) {
    return furrow::timeForAll(plan.request.machine, plan.path, plan.audit);
}

QByteArray blockingTexts(const Plan& plan) {
    QByteArray all;
    for (const Finding& finding : plan.findings) {
        if (finding.severity == Severity::Blocking) {
            all += finding.text.text() + " ";
        }
    }
    return all;
}

}  // namespace

class TestPromises : public QObject {
    Q_OBJECT

private slots:
    void marginIsGivenAway_data();
    void marginIsGivenAway();
    void writtenPlanGivesAwayTheSame();
    void wetSpotIsDrivenOverAndNotWorked_data();
    void wetSpotIsDrivenOverAndNotWorked();
    void widthHoldsItsPasses_data();
    void widthHoldsItsPasses();
    void simplerIsTakenWhereQuicker_data();
    void simplerIsTakenWhereQuicker();
    void quickestCornersAreTaken_data();
    void quickestCornersAreTaken();
    void stripBesideABroaderTractorDoesNotBlock();
    void ownOrderKeepsItsSwaths();
    void adviceMends();
};

void TestPromises::marginIsGivenAway_data() {
    QTest::addColumn<QString>("machine");
    QTest::addColumn<double>("marginM");
    QTest::addColumn<bool>("asAccuracy");
    for (const char* machine : {"agbot", "cultivator", "trailed-sprayer"}) {
        for (const double marginM : {0.1, 0.5, 2.0}) {
            QTest::addRow("%s %g", machine, marginM) << machine << marginM << false;
        }
        QTest::addRow("%s accuracy", machine) << machine << 0.5 << true;
    }
}

void TestPromises::marginIsGivenAway() {
    QFETCH(QString, machine);
    QFETCH(double, marginM);
    QFETCH(bool, asAccuracy);
    FieldSource source = rectangle();
    Given given;
    if (asAccuracy) {
        source.boundaryAccuracy = metres(marginM);
    } else {
        given.emplace_back("field.margin_m", std::to_string(marginM));
    }
    const auto plan = planned(source, machine.toStdString(), given);
    VERIFY_RESULT(plan);
    QVERIFY2((*plan)->drivable(), blockingTexts(**plan).constData());
    // A frame of 400 m x 250 m as broad as the margin; the rectangle is drawn to a millimetre.
    const double frameM2 = 2.0 * marginM * (400.0 + 250.0) - 4.0 * marginM * marginM;
    COMPARE_WITHIN((*plan)->audit.leftOnPurpose->si(), frameM2, 3.0);
    QVERIFY((*plan)->audit.minClearance->si() > marginM - 0.011);
    // As without one: nearly all that the margin leaves is worked, and nothing runs along it twice.
    const auto without = planned(rectangle(), machine.toStdString(), {});
    QVERIFY(*(*plan)->audit.coveredOfReachable > *(*without)->audit.coveredOfReachable - 0.005);
    QVERIFY((*plan)->path.duration() < 1.05 * (*without)->path.duration());
}

void TestPromises::writtenPlanGivesAwayTheSame() {
    for (const auto& [source, given] :
         {std::pair{rectangle(), Given{{"field.margin_m", "2"}}}, std::pair{withWetSpot(), Given{}}}) {
        const auto plan = planned(source, "cultivator", given);
        VERIFY_RESULT(plan);
        const test::Scratch scratch;
        VERIFY_RESULT(
            writePlanFolder(**plan, scratch.path("plan"), std::array<std::string_view, 2>{"geojson", "csv"}));
        const auto read = readPlan(scratch.path("plan"));
        VERIFY_RESULT(read);
        const auto report = audit(auditInput(*read));
        VERIFY_RESULT(report);
        QVERIFY((*plan)->audit.leftOnPurpose->si() > 1000.0);
        // Places in files are rounded, along 1.3 km of margin.
        COMPARE_WITHIN(report->leftOnPurpose->si(), (*plan)->audit.leftOnPurpose->si(), 0.3);
        COMPARE_WITHIN(report->missed->si(), (*plan)->audit.missed->si(), 0.3);
        QVERIFY(std::ranges::none_of(report->findings, [](const AuditFinding& found) {
            return found.finding.severity == Severity::Blocking;
        }));
    }
}

void TestPromises::wetSpotIsDrivenOverAndNotWorked_data() {
    QTest::addColumn<QString>("machine");
    for (const char* machine : {"agbot", "cultivator", "trailed-sprayer"}) {
        QTest::addRow("%s", machine) << machine;
    }
}

void TestPromises::wetSpotIsDrivenOverAndNotWorked() {
    QFETCH(QString, machine);
    const auto plan = planned(withWetSpot(), machine.toStdString(), {});
    VERIFY_RESULT(plan);
    QVERIFY2((*plan)->drivable(), blockingTexts(**plan).constData());
    QCOMPARE((*plan)->cells.cells.size(), std::size_t{1});
    const auto dry = planned(rectangle(), machine.toStdString(), {});
    VERIFY_RESULT(dry);
    // No headland round it, no swath more than without it.
    QCOMPARE((*plan)->swaths.swaths.size(), (*dry)->swaths.swaths.size());
    QCOMPARE((*plan)->headland.drivenPasses.size(), (*dry)->headland.drivenPasses.size());
    QCOMPARE((*plan)->path.turnCount(), (*dry)->path.turnCount());
    // With the implement down its middle never gets into it, and with it up it is driven through.
    const double offsetM = (*plan)->request.machine.spec().implement.offset.si();
    int over = 0;
    for (const PathSegment& segment : (*plan)->path.segments) {
        for (std::size_t i = 1; i < segment.samples.size(); ++i) {
            const PathSample& a = segment.samples[i - 1];
            const PathSample& b = segment.samples[i];
            const int steps = 1 + static_cast<int>(distance(a.position, b.position));
            for (int k = 0; k <= steps; ++k) {
                const Point axle = a.position + (static_cast<double>(k) / steps) * (b.position - a.position);
                const Point place = axle + offsetM * direction(a.headingRad);
                const bool inside = std::abs(place.x) < 19.9 && std::abs(place.y) < 14.9;
                QVERIFY(!(inside && segment.implementDown));
                over += inside ? 1 : 0;
            }
        }
    }
    QVERIFY(over > 0);
    // The spot and what is left beside it, at most an operating width and the spot's length on two sides.
    const double widthM = (*plan)->request.machine.operatingWidth().si();
    const double leftM2 = (*plan)->audit.leftOnPurpose->si();
    QVERIFY2(leftM2 > 1199.0 && leftM2 < 1200.0 + 2.0 * 42.0 * widthM,
             QByteArray::number(leftM2).constData());
}

void TestPromises::widthHoldsItsPasses_data() {
    QTest::addColumn<double>("widthM");
    QTest::addColumn<int>("passes");
    QTest::addColumn<double>("laidM");
    // A cultivator 6 m wide whose tractor is narrower.
    QTest::newRow("two and a half") << 15.0 << 2 << 12.0;
    QTest::newRow("three") << 18.0 << 3 << 18.0;
    QTest::newRow("one and a half") << 9.0 << 1 << 6.0;
}

void TestPromises::widthHoldsItsPasses() {
    QFETCH(double, widthM);
    QFETCH(int, passes);
    QFETCH(double, laidM);
    const auto plan = planned(rectangle(), "cultivator", {{"headland.width_m", std::to_string(widthM)}});
    VERIFY_RESULT(plan);
    QCOMPARE((*plan)->headland.passes, passes);
    COMPARE_WITHIN((*plan)->headland.width.si(), laidM, 1e-6);
    // Passes that finish a corner are short and may lie anywhere.
    const auto ofRing = [&](int ring) {
        return std::ranges::count_if((*plan)->headland.drivenPasses, [ring](const HeadlandPass& pass) {
            return pass.ring == ring && pass.length() > metres(100.0);
        });
    };
    QVERIFY(ofRing(passes - 1) >= 1);
    QCOMPARE(ofRing(passes), 0);
    // The 4,636 m² that a third ring worked twice.
    QVERIFY((*plan)->audit.overlap->si() < 2500.0);
}

void TestPromises::simplerIsTakenWhereQuicker_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("chosen");
    QTest::addColumn<QString>("simpler");
    QTest::addColumn<QString>("machine");
    for (const char* machine : {"agbot", "cultivator"}) {
        QTest::addRow("per-edge %s", machine) << "headland.method" << "per-edge" << "constant" << machine;
        QTest::addRow("per-cell %s", machine) << "decomposition.heading" << "per-cell" << "common" << machine;
    }
}

void TestPromises::simplerIsTakenWhereQuicker() {
    QFETCH(QString, key);
    QFETCH(QString, chosen);
    QFETCH(QString, simpler);
    QFETCH(QString, machine);
    // An L: two arms, 60 m broad.
    const MultiPolygon arms{
        {.outer = {{0, 0}, {250, 0}, {250, 60}, {60, 60}, {60, 220}, {0, 220}}, .holes = {}}};
    for (const FieldSource& source : {rectangle(), test::fieldSourceFromLocal(arms, kCentre)}) {
        const auto asked =
            planned(source, machine.toStdString(), {{key.toStdString(), chosen.toStdString()}});
        const auto plain =
            planned(source, machine.toStdString(), {{key.toStdString(), simpler.toStdString()}});
        VERIFY_RESULT(asked);
        VERIFY_RESULT(plain);
        QVERIFY(timeForAll(**asked) <= 1.005 * timeForAll(**plain));
        const bool isNoted = std::ranges::contains((*asked)->findings, FindingKind::Instead, &Finding::kind);
        QCOMPARE(isNoted, std::ranges::contains((*asked)->instead, key.toStdString(), &SettingChange::key));
    }
}

// Numbers of an order are those of the swaths that these choices lay, also where others would be quicker.
void TestPromises::quickestCornersAreTaken_data() {
    QTest::addColumn<QString>("machine");
    for (const char* machine : {"agbot", "cultivator", "mounted-drill", "combine"}) {
        QTest::newRow(machine) << machine;
    }
}

void TestPromises::quickestCornersAreTaken() {
    QFETCH(QString, machine);
    const auto plan = planned(rectangle(), machine.toStdString(), {});
    VERIFY_RESULT(plan);
    const auto taken = std::ranges::find((*plan)->instead, "headland.corner", &SettingChange::key);
    QVERIFY(taken != (*plan)->instead.end());
    for (const char* corner : {"rounded", "loop", "reverse"}) {
        const auto other = planned(rectangle(), machine.toStdString(), {{"headland.corner", corner}});
        VERIFY_RESULT(other);
        // Each decides the rest for itself, one after the other, and need not end up with the same.
        const bool isNoBetter = !(*other)->drivable() || timeForAll(**plan) <= 1.005 * timeForAll(**other);
        QVERIFY2(isNoBetter, corner);
    }
}

// The robot is 1.8 m broad and works 1.5 m: the 15 cm along the boundary are 1.2 % of this field.
void TestPromises::stripBesideABroaderTractorDoesNotBlock() {
    const auto plan = planned(test::fieldSourceFromLocal({test::rectangle(60.0, 42.0)}, kCentre),
                              "field-robot", {{"headland.corner", "rounded"}});
    VERIFY_RESULT(plan);
    QVERIFY((*plan)->audit.missed->si() > 0.01 * 60.0 * 42.0);
    QVERIFY2((*plan)->drivable(), (*plan)->findings.front().text.text().c_str());
}

void TestPromises::ownOrderKeepsItsSwaths() {
    Given given{{"headland.method", "per-edge"}};
    Settings settings;
    applySetting(settings, "headland.method", "per-edge").value();
    StageCache cache;
    const auto asked =
        StageRunner{cache}.run({.field = std::make_shared<const Field>(Field::create(rectangle()).value()),
                                .machine = findMachine("cultivator").value(),
                                .settings = settings},
                               {}, {});
    VERIFY_RESULT(asked);
    const std::vector<Swath>& swaths = asked->laidOut.laid->swaths.swaths;
    const auto quicker = planned(rectangle(), "cultivator", given);
    VERIFY_RESULT(quicker);
    QVERIFY(std::ranges::contains((*quicker)->instead, "headland.method", &SettingChange::key));
    std::string order;
    for (const Swath& swath : swaths) {
        order += (order.empty() ? "" : ",") + std::to_string(swath.number);
    }
    given.emplace_back("route.method", "custom");
    given.emplace_back("route.order", order);
    const auto plan = planned(rectangle(), "cultivator", given);
    VERIFY_RESULT(plan);
    QVERIFY(std::ranges::all_of((*plan)->instead,
                                [](const SettingChange& change) { return change.key == "headland.corner"; }));
    QCOMPARE((*plan)->swaths.swaths, swaths);
}

void TestPromises::adviceMends() {
    // Without a headland a cultivator has no room to turn in.
    const FieldSource small = test::fieldSourceFromLocal({test::centredRectangle(100.0, 70.0)}, kCentre);
    const auto plan = planned(small, "cultivator", {{"swaths.ends", "centre"}, {"headland.method", "none"}});
    VERIFY_RESULT(plan);
    QVERIFY(!(*plan)->drivable());
    const auto advised = withAdvice(*plan);
    VERIFY_RESULT(advised);
    std::size_t given = 0;
    for (const Finding& finding : (*advised)->findings) {
        if (!finding.change) {
            continue;
        }
        ++given;
        Given changed{{"swaths.ends", "centre"}, {"headland.method", "none"}};
        std::erase_if(changed, [&](const auto& each) { return each.first == finding.change->key; });
        changed.emplace_back(finding.change->key, finding.change->value);
        const auto mended = planned(small, "cultivator", changed);
        VERIFY_RESULT(mended);
        QVERIFY(std::ranges::none_of((*mended)->findings, [&](const Finding& other) {
            return other.severity == Severity::Blocking && other.kind == finding.kind &&
                   distance(other.place, finding.place) < 12.0;
        }));
    }
    QVERIFY(given > 0);
}

FURROW_TEST(TestPromises);
#include "tst_promises.moc"
