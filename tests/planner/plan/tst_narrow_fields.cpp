// Fields in which a single pass of headland takes nearly all of the land.

#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <memory>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};
// Samples of the outline that the audit measures with.
constexpr double kOutsideM2 = 0.01;

PlanRequest requestFor(double lengthM, double breadthM, std::string_view machine) {
    const FieldSource source =
        test::fieldSourceFromLocal({test::centredRectangle(lengthM, breadthM)}, kCentre);
    return {.field = std::make_shared<const Field>(Field::create(source).value()),
            .machine = findMachine(machine).value(),
            .settings = {}};
}

}  // namespace

class NarrowFieldsTest : public QObject {
    Q_OBJECT

private slots:
    void plans_data() {
        QTest::addColumn<double>("breadthM");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<int>("passes");
        QTest::addColumn<int>("swaths");
        // The boom is 24 m wide. Between two passes of it, 12 m are left in a field of 60 m, and nothing in
        // one of 44 m. In a field of 72 m a swath fits.
        QTest::newRow("one swath fits") << 72.0 << "trailed-sprayer" << 1 << 1;
        QTest::newRow("half a swath is left") << 60.0 << "trailed-sprayer" << 1 << 1;
        QTest::newRow("nothing is left") << 44.0 << "trailed-sprayer" << 1 << 0;
    }
    void plans() {
        QFETCH(double, breadthM);
        QFETCH(QString, machine);
        const auto plan = makePlan(requestFor(200.0, breadthM, machine.toStdString()));
        VERIFY_RESULT(plan);
        QTEST((*plan)->headland.passes, "passes");
        QTEST(static_cast<int>((*plan)->swaths.swaths.size()), "swaths");
        QVERIFY((*plan)->drivable());
        COMPARE_WITHIN((*plan)->audit.outside.value().si(), 0.0, kOutsideM2);
        // Four corners outside a circle of 19 m are out of reach of a boom on a bend of 7 m, and the trailed
        // boom cuts bends by some metres more.
        QVERIFY((*plan)->audit.coveredShare.value() > 0.95);
    }

    // 24 m of boom fit in between the sides, but have no room for a bend: one swath, and no headland.
    void noRoomForABend() {
        const auto plan = makePlan(requestFor(200.0, 26.0, "trailed-sprayer"));
        VERIFY_RESULT(plan);
        QCOMPARE((*plan)->headland.passes, 0);
        QVERIFY(!(*plan)->swaths.swaths.empty());
    }

    // Where a pass all round works less than swaths without a headland, it is not planned.
    void aPassAllRoundIsNeverTheSlowerChoice() {
        PlanRequest request = requestFor(120.0, 7.0, "agbot");
        const auto plan = makePlan(request);
        request.settings.set(kHeadlandPasses, 0.0).value();
        const auto without = makePlan(request);
        VERIFY_RESULT(plan);
        VERIFY_RESULT(without);
        QVERIFY((*plan)->blockingCount() <= (*without)->blockingCount());
        if ((*plan)->blockingCount() == (*without)->blockingCount()) {
            QVERIFY((*plan)->path.duration() <= 1.005 * (*without)->path.duration());
        }
    }

    void everyChoiceWithoutSwaths_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        for (const Parameter* parameter : allParameters()) {
            for (const Choice& choice : parameter->choices) {
                QTest::addRow("%s=%s", std::string{parameter->key}.c_str(), std::string{choice.id}.c_str())
                    << QString::fromStdString(std::string{parameter->key})
                    << QString::fromStdString(std::string{choice.id});
            }
        }
    }
    void everyChoiceWithoutSwaths() {
        QFETCH(QString, key);
        QFETCH(QString, value);
        PlanRequest request = requestFor(110.0, 44.0, "trailed-sprayer");
        // Comparing corners and finishing passes belong to other rows.
        request.settings.set(kHeadlandCorner, std::string{kRoundedCorner}).value();
        applySetting(request.settings, "headland.finish", "false").value();
        applySetting(request.settings, key.toStdString(), value.toStdString()).value();
        const auto plan = makePlan(request);
        if (!plan) {
            QVERIFY(!std::string{plan.error().what}.empty());
            return;
        }
        if ((*plan)->swaths.swaths.empty()) {
            QVERIFY((*plan)->headland.isPerimeterOnly);
            QVERIFY(!(*plan)->path.segments.empty());
        }
    }
};

FURROW_TEST(NarrowFieldsTest);
#include "tst_narrow_fields.moc"
