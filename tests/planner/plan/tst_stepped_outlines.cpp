// Fields with an outline in steps, as a raster of a satellite image gives it. Headland passes cut the steps
// off. Short passes work them as far as the machine gets into them.

#include "planner/audit/swept_area.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>

using namespace furrow;

namespace {

/// A parallelogram whose left and right sides go up in steps to the right.
Polygon steppedParallelogram(int steps, Point step, double widthM) {
    Polygon polygon;
    const auto side = [&](double x, int first, int way) {
        for (int i = 0; i < steps; ++i) {
            const int here = first + way * i;
            polygon.outer.push_back({x + here * step.x, (way > 0 ? here : here + 1) * step.y});
            polygon.outer.push_back({x + here * step.x, (way > 0 ? here + 1 : here) * step.y});
        }
    };
    side(widthM, 0, 1);
    side(0.0, steps - 1, -1);
    return polygon;
}

}  // namespace

class SteppedOutlinesTest : public QObject {
    Q_OBJECT

private slots:
    void theParallelogram() {
        // Two steps of 1 m by 2 m, by hand.
        const Ring outer{{10.0, 0.0}, {10.0, 2.0}, {11.0, 2.0}, {11.0, 4.0},
                         {1.0, 4.0},  {1.0, 2.0},  {0.0, 2.0},  {0.0, 0.0}};
        QVERIFY(steppedParallelogram(2, {1.0, 2.0}, 10.0).outer == outer);
    }

    void areWorked_data() {
        QTest::addColumn<int>("steps");
        QTest::addColumn<double>("asideM");
        QTest::addColumn<double>("upM");
        QTest::addColumn<double>("widthM");
        QTest::newRow("0.18 ha") << 12 << 1.3 << 4.2 << 36.0;
        QTest::newRow("0.25 ha") << 12 << 1.3 << 4.2 << 50.0;
        QTest::newRow("0.34 ha") << 16 << 1.3 << 4.2 << 50.0;
        QTest::newRow("0.3 ha, longer steps") << 12 << 1.6 << 5.0 << 50.0;
    }
    void areWorked() {
        QFETCH(const int, steps);
        QFETCH(const double, asideM);
        QFETCH(const double, upM);
        QFETCH(const double, widthM);
        const FieldSource source =
            test::fieldSourceFromLocal({steppedParallelogram(steps, {asideM, upM}, widthM)}, {9.0, 51.0});
        PlanRequest request{.field = std::make_shared<const Field>(Field::create(source).value()),
                            .machine = findMachine("cultivator").value(),
                            .settings = {}};
        VERIFY_RESULT(applySetting(request.settings, "route.compare", "blocked"));
        const auto plan = makePlan(request);
        VERIFY_RESULT(plan);
        QVERIFY2((*plan)->drivable(),
                 (*plan)->findings.empty() ? "" : (*plan)->findings.front().text.key().c_str());
        QVERIFY((*plan)->audit.left <= kMissedShare * (*plan)->audit.workable);
        // Without the short passes the plan is blocked: the field is one that needs them.
        VERIFY_RESULT(applySetting(request.settings, "headland.finish", "false"));
        const auto unfinished = makePlan(request);
        VERIFY_RESULT(unfinished);
        QVERIFY(!(*unfinished)->drivable());
    }
};

FURROW_TEST(SteppedOutlinesTest);
#include "tst_stepped_outlines.moc"
