// Work that grows with the square of something has a bound: fields that would take minutes without it.

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan_course.h"
#include "planner/plan/plan_to_beat.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <memory>
#include <random>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.0, 51.0};

PlanRequest requestFor(const MultiPolygon& polygons) {
    return {.field = std::make_shared<const Field>(
                Field::create(test::fieldSourceFromLocal(polygons, kCentre)).value()),
            .machine = findMachine("cultivator").value(),
            .settings = {}};
}

}  // namespace

class TestLimits : public QObject {
    Q_OBJECT

private slots:
    // Squares of 20 m, 5 m apart. No way leads from one to the next, and a cultivator of 6 m hardly turns in
    // them: nothing mends that.
    void manyPartsWithoutAWay() {
        MultiPolygon squares;
        for (int i = 0; i < 30; ++i) {
            squares.push_back(test::rectangle(20.0, 20.0, {25.0 * (i % 6), 25.0 * (i / 6)}));
        }
        int compared = 0;
        const auto plan =
            makePlan(requestFor(squares), {}, nullptr,
                     {.firstPlan = {}, .compared = [&](std::size_t, std::size_t) { ++compared; }});
        VERIFY_RESULT(plan);
        QVERIFY(lastingCount((*plan)->findings) > 25);
        QCOMPARE(compared, 0);
        // No short passes over what is left.
        PlanRequest unfinished = requestFor(squares);
        applySetting(unfinished.settings, "headland.finish", "false").value();
        const auto other = makePlan(unfinished, {});
        VERIFY_RESULT(other);
        QVERIFY((*plan)->path == (*other)->path);
    }

    // Poles of 2 m, a pole in each square of 25 m. Each is gone round, or has a headland that leaves others
    // no room to be gone round.
    void manyPoles() {
        MultiPolygon land{test::rectangle(125.0, 125.0)};
        std::mt19937_64 random{25};
        for (int i = 0; i < 25; ++i) {
            const double x = 25.0 * (i % 5) + test::uniform(random, 7.0, 16.0);
            const double y = 25.0 * (i / 5) + test::uniform(random, 7.0, 16.0);
            land.front().holes.push_back({{x, y}, {x, y + 2.0}, {x + 2.0, y + 2.0}, {x + 2.0, y}});
        }
        const auto plan = makePlan(requestFor(land), {});
        VERIFY_RESULT(plan);
        QVERIFY((*plan)->audit.coveredShare.value() > 0.95);
        QCOMPARE(lastingCount((*plan)->findings), 0);
    }
};

FURROW_TEST(TestLimits);
#include "tst_limits.moc"
