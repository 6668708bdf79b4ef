// Plans in which the implement may stand over the edges of the field or an obstacle.

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <format>
#include <memory>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};
// Samples of the outline that the audit measures with.
constexpr double kOutsideM2 = 0.01;

FieldSource rectangle(double lengthM, double breadthM) {
    return test::fieldSourceFromLocal({test::centredRectangle(lengthM, breadthM)}, kCentre);
}

std::shared_ptr<const Plan> planned(const FieldSource& source, std::string_view machine,
                                    const std::string& overhangM = "0") {
    PlanRequest request{.field = std::make_shared<const Field>(Field::create(source).value()),
                        .machine = findMachine(machine).value(),
                        .settings = {}};
    applySetting(request.settings, "field.overhang_m", overhangM).value();
    return makePlan(request).value();
}

}  // namespace

class OverhangPlansTest : public QObject {
    Q_OBJECT

private slots:
    void aNarrowFieldBecomesDrivable_data() {
        QTest::addColumn<double>("breadthM");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<double>("overhangM");
        QTest::newRow("a boom of 24 m") << 20.0 << "trailed-sprayer" << 6.0;
        QTest::newRow("4 m of it on either side") << 16.0 << "trailed-sprayer" << 4.0;
        QTest::newRow("no room to turn 6 m") << 12.0 << "cultivator" << 3.0;
    }
    void aNarrowFieldBecomesDrivable() {
        QFETCH(double, breadthM);
        QFETCH(QString, machine);
        QFETCH(double, overhangM);
        const FieldSource source = rectangle(150.0, breadthM);
        const auto without = planned(source, machine.toStdString());
        QVERIFY(!without->drivable());
        QVERIFY(without->audit.outside.value().si() > 1.0);
        QCOMPARE(without->audit.overhang.si(), 0.0);
        const auto with = planned(source, machine.toStdString(), std::format("{}", overhangM));
        QVERIFY(with->drivable());
        COMPARE_WITHIN(with->audit.outside.value().si(), 0.0, kOutsideM2);
        QVERIFY(with->audit.overhang.si() > 0.5 && with->audit.overhang.si() <= overhangM + 0.01);
        QVERIFY(with->audit.overhangArea.si() > 1.0);
        QVERIFY(std::ranges::contains(with->findings, FindingKind::Overhang, &Finding::kind));
    }

    // The boom is 4 m broader than the field: 2 m on either side, which 1 m does not allow.
    void lessThanItTakesStillBlocks() {
        const auto plan = planned(rectangle(150.0, 20.0), "trailed-sprayer", "1");
        QVERIFY(!plan->drivable());
        QVERIFY(plan->audit.overhang.si() > 1.5);
        QVERIFY(plan->audit.outside.value().si() > 1.0);
    }

    void theLongEdgesAreEnough() {
        FieldSource source = rectangle(150.0, 20.0);
        // From (-75, -10) counter-clockwise.
        source.edgeOverhangs = {{.part = 0, .ring = 0, .edge = 0, .width = metres(3.0)},
                                {.part = 0, .ring = 0, .edge = 2, .width = metres(3.0)}};
        QVERIFY(planned(source, "trailed-sprayer")->drivable());
        source.edgeOverhangs.pop_back();
        QVERIFY(!planned(source, "trailed-sprayer")->drivable());
    }

    void wherePlansAreDrivableTurnsGetShorter() {
        const FieldSource source = rectangle(200.0, 40.0);
        const auto without = planned(source, "trailed-sprayer");
        const auto with = planned(source, "trailed-sprayer", "6");
        QVERIFY(without->drivable());
        QVERIFY(with->drivable());
        QVERIFY(with->path.duration() < 0.8 * without->path.duration());
    }

    // A plan without an overhang says nothing of it.
    void noneIsAsBefore() {
        const auto plan = planned(rectangle(150.0, 60.0), "cultivator");
        QVERIFY(!plan->overhung.has_value());
        QVERIFY(!std::ranges::contains(plan->findings, FindingKind::Overhang, &Finding::kind));
    }
};

FURROW_TEST(OverhangPlansTest);
#include "tst_overhang_plans.moc"
