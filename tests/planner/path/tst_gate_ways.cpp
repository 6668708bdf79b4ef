// In and out by a gate: a square field of 120 m with a gate in the middle of its west side, and the places
// along it.

#include "planner/geometry/geos_bridge.h"
#include "planner/machine/machine_library.h"
#include "planner/path/gate_ways.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <format>

using namespace furrow;

namespace {

std::shared_ptr<const Field> fieldWithGate(Length width) {
    FieldSource source = test::fieldSourceFromLocal({test::rectangle(120.0, 120.0)}, {9.2, 51.3});
    // Corners run from the origin to the east: the west side is the last.
    const GeoRing& outer = source.parts.front().outer;
    const GeoPoint low = outer[0];
    const GeoPoint high = outer[3];
    source.gates.push_back({.name = "West",
                            .position = {0.5 * (low.lonDeg + high.lonDeg), 0.5 * (low.latDeg + high.latDeg)},
                            .width = width});
    return std::make_shared<const Field>(Field::create(source).value());
}

Result<std::shared_ptr<const Plan>> planned(
    const std::shared_ptr<const Field>& field,
    std::initializer_list<std::pair<const char*, const char*>> given = {},
    std::string_view machine = "agbot") {
    Settings settings;
    for (const auto& [key, value] : given) {
        applySetting(settings, key, value).value();
    }
    return makePlan({.field = field, .machine = findMachine(machine).value(), .settings = settings});
}

}  // namespace

class GateWaysTest : public QObject {
    Q_OBJECT

private slots:
    void beginsAndEndsThere_data() {
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("mostM");  // of the axle from the gate
        // 6 m: a disc of 3 m holds tail (1.2 m) and implement (2.7 m behind the axle) only partly.
        QTest::newRow("wide") << 8.0 << 0.05;
        QTest::newRow("as wide as most") << 5.0 << 3.0;
        // The whole machine is inside: its implement ends 2.7 m behind the axle.
        QTest::newRow("without a width") << 0.0 << 2.9;
    }
    void beginsAndEndsThere() {
        QFETCH(double, widthM);
        QFETCH(double, mostM);
        const auto field = fieldWithGate(metres(widthM));
        const auto plan = planned(field);
        VERIFY_RESULT(plan);
        const Point gate = field->frame().toLocal(field->source().gates.front().position);
        const std::vector<PathSegment>& segments = (*plan)->path.segments;
        QCOMPARE(segments.front().kind, SegmentKind::Transfer);
        QCOMPARE(segments.back().kind, SegmentKind::Transfer);
        QCOMPARE_LT(distance(segments.front().samples.front().position, gate), mostM);
        QVERIFY(!segments.front().implementDown);
        // Beside the edge passes touch it to less than a millimetre.
        QCOMPARE_LT((*plan)->audit.outside.value().si(), 1e-2);
        for (const Finding& finding : (*plan)->findings) {
            QVERIFY2(finding.severity == Severity::Note || finding.kind == FindingKind::Missed,
                     finding.text.c_str());
        }
    }

    // A gate of 4 m, a drill of 12 m that is folded to 3 m. Its tail ends 3.5 m behind the axle, and the disc
    // of 2 m that is open at the gate holds its corners, 1.5 m aside, sqrt(2² - 1.5²) m beyond the
    // boundary: 2.18 m are left. As wide as it is raised it would have to be inside as a whole.
    void foldsForTheGate() {
        const auto field = fieldWithGate(metres(4.0));
        const auto plan = planned(field, {}, "mounted-drill");
        VERIFY_RESULT(plan);
        QVERIFY2((*plan)->drivable(), (*plan)->findings.front().text.c_str());
        const Point gate = field->frame().toLocal(field->source().gates.front().position);
        const std::vector<PathSegment>& segments = (*plan)->path.segments;
        QCOMPARE_LT(distance(segments.front().samples.front().position, gate), 2.3);
        QCOMPARE_GT(distance(segments.front().samples.front().position, gate), 2.1);
        QCOMPARE_LT((*plan)->audit.outside.value().si(), 1e-2);
    }

    // The cultivator is folded to 3 m: a gate of 2.5 m is told with both numbers, once, and nothing about
    // headlands.
    void aGateThatIsTooNarrow() {
        const auto plan = planned(fieldWithGate(metres(2.5)), {}, "cultivator");
        VERIFY_RESULT(plan);
        int told = 0;
        for (const Finding& finding : (*plan)->findings) {
            if (finding.severity == Severity::Blocking) {
                QCOMPARE(finding.kind, FindingKind::Gate);
                QCOMPARE(std::string{finding.text},
                         std::string{"West is 2.50 m wide; this machine is 3.00 m wide for transport."});
                QVERIFY(!std::string{finding.suggestion}.contains("headland"));
                ++told;
            }
        }
        QCOMPARE(told, 1);
    }

    void byNameOrPoint() {
        const auto field = fieldWithGate(metres(8.0));
        const auto named = planned(field, {{"route.start", "West"}});
        VERIFY_RESULT(named);
        const GeoPoint middle = field->frame().toGeo(Point{0.0, 0.0});
        const std::string point = std::format("POINT ({:.9f} {:.9f})", middle.lonDeg, middle.latDeg);
        const auto inside = planned(field, {{"route.start", point.c_str()}});
        VERIFY_RESULT(inside);
        QCOMPARE_LT(norm((*inside)->path.segments.front().samples.front().position), 0.01);
        const auto unknown = planned(field, {{"route.start", "East"}});
        QVERIFY(!unknown);
        QCOMPARE(unknown.error().code, ErrorCode::Usage);
        QVERIFY(unknown.error().remedy.contains("West"));
        const auto outside = planned(field, {{"route.end", "POINT (9 50)"}});
        QVERIFY(!outside);
        QCOMPARE(outside.error().code, ErrorCode::Usage);
    }

    void noGateNoWay() {
        const auto field = std::make_shared<const Field>(
            Field::create(test::fieldSourceFromLocal({test::rectangle(120.0, 120.0)}, {9.2, 51.3})).value());
        const auto plan = planned(field);
        VERIFY_RESULT(plan);
        QVERIFY((*plan)->path.segments.front().kind != SegmentKind::Transfer);
    }
};

FURROW_TEST(GateWaysTest);
#include "tst_gate_ways.moc"
