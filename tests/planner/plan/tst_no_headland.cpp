#include "planner/geometry/segment.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>

using namespace furrow;

// No headland, and a machine that may leave the field to turn: it works to the edge and goes round obstacles.

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

Result<std::shared_ptr<const Plan>> planOf(const MultiPolygon& polygons, std::string_view machine,
                                           std::string_view turns) {
    Settings settings;
    for (const auto& [key, text] : {std::pair<std::string_view, std::string_view>{"headland.method", "none"},
                                    {"path.stay_inside", "false"},
                                    {"path.method", turns}}) {
        applySetting(settings, key, text).value();
    }
    auto field =
        std::make_shared<const Field>(Field::create(test::fieldSourceFromLocal(polygons, kCentre)).value());
    return makePlan(
        {.field = std::move(field), .machine = findMachine(machine).value(), .settings = settings});
}

double coveredShare(const Plan& plan) {
    return plan.audit.covered.value() / plan.audit.workable;
}

/// How near the middle of the axle comes to an obstacle on ways with the implement up; negative inside it.
double nearestM(const Plan& plan, const Ring& obstacle) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const PathSegment& segment : plan.path.segments) {
        for (std::size_t i = segment.implementDown ? segment.samples.size() : 1; i < segment.samples.size();
             ++i) {
            const Point from = segment.samples[i - 1].position;
            const Point to = segment.samples[i].position;
            for (double share = 0.0; share <= 1.0; share += 0.125) {
                const Point at = from + share * (to - from);
                double awayM = std::numeric_limits<double>::infinity();
                bool inside = false;
                for (std::size_t k = 0; k < obstacle.size(); ++k) {
                    const Point a = obstacle[k];
                    const Point b = obstacle[(k + 1) % obstacle.size()];
                    awayM = std::min(awayM, distanceToSegment(at, a, b));
                    if ((a.y > at.y) != (b.y > at.y) &&
                        at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)) {
                        inside = !inside;
                    }
                }
                nearest = std::min(nearest, inside ? -awayM : awayM);
            }
        }
    }
    return nearest;
}

}  // namespace

class NoHeadlandTest : public QObject {
    Q_OBJECT

private slots:
    // A parallelogram of 300 x 200 m whose ends slant at 45 degrees: swaths that stop at their middle lines
    // leave a triangle of w²/8 at each end and with it one in w / 2 / 200 m of a side of 283 m, some tenths
    // of a per cent.
    void slantingEndsAreWorked_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("turns");
        QTest::newRow("robot") << "agbot" << "dubins";
        QTest::newRow("cultivator") << "cultivator" << "best-feasible";
        QTest::newRow("drill") << "mounted-drill" << "omega";
        QTest::newRow("on the spot") << "field-robot" << "straight";
    }
    void slantingEndsAreWorked() {
        QFETCH(QString, machine);
        QFETCH(QString, turns);
        const MultiPolygon field = test::polygonsFromWkt("POLYGON((0 0, 300 0, 500 200, 200 200, 0 0))");
        const auto plan = planOf(field, machine.toStdString(), turns.toStdString());
        VERIFY_RESULT(plan);
        QVERIFY((*plan)->drivable());
        COMPARE_WITHIN(coveredShare(**plan), 1.0, 5e-4);
    }

    // Inside the field all the time: swaths end where a machine can turn that turns on the spot, its ways
    // lead straight round obstacles, and what the ends leave is finished. Four blocks at odd angles in 100 x
    // 80 m, as buildings stand.
    void insideTheFieldOnTheSpot_data() {
        QTest::addColumn<double>("implementM");
        QTest::addColumn<double>("overhangM");
        QTest::addColumn<QString>("turns");
        QTest::newRow("a weeder") << 1.5 << 0.0 << "best-feasible";
        QTest::newRow("a weeder, straight ways") << 1.5 << 0.0 << "straight";
        QTest::newRow("wider than the robot") << 3.0 << 0.0 << "best-feasible";
        QTest::newRow("a camera's view over the edge") << 3.0 << 3.0 << "best-feasible";
    }
    void insideTheFieldOnTheSpot() {
        QFETCH(double, implementM);
        QFETCH(double, overhangM);
        QFETCH(QString, turns);
        Polygon field = test::rectangle(100.0, 80.0);
        for (const auto& [x, y, turned] :
             {std::array{25.0, 25.0, 20.0}, {70.0, 20.0, -35.0}, {30.0, 60.0, 50.0}, {72.0, 58.0, 10.0}}) {
            const MultiPolygon block =
                test::moved({test::centredRectangle(14.0, 9.0)}, degrees(turned), {x, y});
            field.holes.push_back({block.front().outer.rbegin(), block.front().outer.rend()});
        }
        MachineSpec spec = findMachine("field-robot")->spec();
        spec.tractor.width = metres(0.6);
        spec.tractor.length = metres(0.8);
        spec.tractor.rearOverhang = metres(0.4);
        spec.tractor.minTurningRadius = metres(0.5);
        spec.implement.operatingWidth = metres(implementM);
        spec.implement.raisedWidth = metres(0.6);
        spec.implement.offset = metres(0.0);
        spec.implement.length = metres(0.1);
        spec.implement.runIn = metres(0.0);
        Settings settings;
        for (const auto& [key, text] : {std::pair<std::string, std::string>{"headland.method", "none"},
                                        {"path.method", turns.toStdString()},
                                        {"field.overhang_m", std::to_string(overhangM)}}) {
            applySetting(settings, key, text).value();
        }
        const auto plan = makePlan({.field = std::make_shared<const Field>(
                                        Field::create(test::fieldSourceFromLocal({field}, kCentre)).value()),
                                    .machine = Machine::create(spec).value(),
                                    .settings = settings});
        VERIFY_RESULT(plan);
        for (const Finding& finding : (*plan)->findings) {
            QVERIFY2(finding.severity != Severity::Blocking, std::string{finding.text}.c_str());
        }
        QVERIFY2(coveredShare(**plan) > 0.99, qPrintable(QString::number(coveredShare(**plan))));
        for (const Ring& hole : (*plan)->field().boundary().front().holes) {
            QVERIFY(nearestM(**plan, hole) > 0.3 - 0.01);
        }
    }

    // A pond of 50 x 50 m in 400 x 250 m.
    void obstaclesAreGoneRound_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("turns");
        QTest::newRow("robot, forward curves") << "agbot" << "dubins";
        QTest::newRow("cultivator, the best") << "cultivator" << "best-feasible";
        QTest::newRow("cultivator, three-point") << "cultivator" << "three-point";
        QTest::newRow("drill, omega") << "mounted-drill" << "omega";
        QTest::newRow("on the spot") << "field-robot" << "straight";
    }
    void obstaclesAreGoneRound() {
        QFETCH(QString, machine);
        QFETCH(QString, turns);
        const Polygon pond = test::rectangle(50.0, 50.0, {180.0, 100.0});
        Polygon field = test::rectangle(400.0, 250.0);
        field.holes.push_back({pond.outer.rbegin(), pond.outer.rend()});
        const auto plan = planOf({field}, machine.toStdString(), turns.toStdString());
        VERIFY_RESULT(plan);
        for (const Finding& finding : (*plan)->findings) {
            QVERIFY2(finding.severity != Severity::Blocking, std::string{finding.text}.c_str());
        }
        QVERIFY2(coveredShare(**plan) > 0.99, qPrintable(QString::number(coveredShare(**plan))));
        // Beside the pond the axle is half a tractor away; tail first it comes as near as its overhang is
        // long.
        const Tractor tractor = findMachine(machine.toStdString()).value().spec().tractor;
        const double nearM = std::min(0.5 * tractor.width, tractor.rearOverhang).si();
        // As the field has it: projected, and no ring of the drawing.
        const Ring& hole = (*plan)->field().boundary().front().holes.front();
        QVERIFY2(nearestM(**plan, hole) > nearM - 0.01, qPrintable(QString::number(nearestM(**plan, hole))));
    }
};

FURROW_TEST(NoHeadlandTest);
#include "tst_no_headland.moc"
