// Which places are dear by each rule: a field of 200 m with a mainland 40 m in, and a machine of 2.5 m.

#include "planner/machine/machine_library.h"
#include "planner/path/travel_rule.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;

class TravelRuleTest : public QObject {
    Q_OBJECT

private slots:
    void places_data() {
        QTest::addColumn<int>("rule");
        QTest::addColumn<double>("x");
        QTest::addColumn<bool>("dear");
        const int headland = static_cast<int>(Traversal::Headland);
        const int boundary = static_cast<int>(Traversal::Boundary);
        QTest::newRow("headland: in the strip") << headland << 20.0 << false;
        // 2.1 m of radius and half of 2.5 m are left for the turn.
        QTest::newRow("headland: at a swath's end") << headland << 42.0 << false;
        QTest::newRow("headland: beyond that") << headland << 45.5 << true;
        QTest::newRow("headland: in the middle") << headland << 100.0 << true;
        QTest::newRow("headland: on the other side") << headland << 190.0 << false;
        // Half as much again as the 2.5 m of the outermost pass.
        QTest::newRow("boundary: along it") << boundary << 2.0 << false;
        QTest::newRow("boundary: the next pass") << boundary << 6.0 << true;
        QTest::newRow("boundary: in the middle") << boundary << 100.0 << true;
        QTest::newRow("boundary: outside") << boundary << -10.0 << false;
    }
    void places() {
        QFETCH(int, rule);
        QFETCH(double, x);
        QFETCH(bool, dear);
        const MultiPolygon field{test::rectangle(200.0, 200.0)};
        const MultiPolygon mainland{
            {.outer = {{40.0, 40.0}, {160.0, 40.0}, {160.0, 160.0}, {40.0, 160.0}}, .holes = {}}};
        const auto travel = travelRule(
            static_cast<Traversal>(rule),
            {.workable = field, .mainland = mainland, .machine = findMachine("agbot").value(), .margin = {}},
            {});
        VERIFY_RESULT(travel);
        QCOMPARE((*travel)({x, 100.0}) > 1.0, dear);
    }

    void anywhere() {
        const MultiPolygon field{test::rectangle(200.0, 200.0)};
        const auto travel = travelRule(
            Traversal::Interior,
            {.workable = field, .mainland = field, .machine = findMachine("agbot").value(), .margin = {}},
            {});
        VERIFY_RESULT(travel);
        QVERIFY(!*travel);
    }
};

FURROW_TEST(TravelRuleTest);
#include "tst_travel_rule.moc"
