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
                for (std::size_t k = 0; k < obstacle.size(); ++k) {
                    awayM = std::min(awayM,
                                     distanceToSegment(at, obstacle[k], obstacle[(k + 1) % obstacle.size()]));
                }
                const Bounds box = bounds({{.outer = obstacle, .holes = {}}});
                const bool inside =
                    at.x > box.min.x && at.x < box.max.x && at.y > box.min.y && at.y < box.max.y;
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
