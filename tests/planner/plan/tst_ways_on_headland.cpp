#include "planner/geometry/boundary_distance.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <memory>
#include <string>
#include <vector>

using namespace furrow;

// Ways that are to keep to the headland do so wherever it leads there: in and out, between cells, to the last
// passes.

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

/// With a gate in the lower left corner, wide enough for every machine.
std::shared_ptr<const Field> fieldOf(const char* wkt, Point gate) {
    FieldSource source = test::fieldSourceFromLocal(test::polygonsFromWkt(wkt), kCentre);
    const auto frame = LocalFrame::centredOn(kCentre).value();
    source.gates.push_back(
        {.name = "gate", .position = frame.toGeo(Ring{gate}).front(), .width = metres(15.0)});
    return std::make_shared<const Field>(Field::create(source).value());
}

/// Metres driven with the implement up over the mainland, deeper in than a turn at a swath's end gets: a
/// radius and half the machine.
double overMainlandM(const Plan& plan) {
    const Machine& machine = plan.request.machine;
    const double deepM = (machine.minTurningRadius() + 0.5 * machine.turningWidth()).si() + 1.0;
    const BoundaryDistance mainland{plan.headland.mainland, metres(deepM + 1.0)};
    double sumM = 0.0;
    for (const PathSegment& segment : plan.path.segments) {
        for (std::size_t i = segment.implementDown ? segment.samples.size() : 1; i < segment.samples.size();
             ++i) {
            const Point from = segment.samples[i - 1].position;
            const Point way = segment.samples[i].position - from;
            const int pieces = 1 + static_cast<int>(norm(way));
            for (int k = 0; k < pieces; ++k) {
                const auto insideM = mainland.insideM(from + ((k + 0.5) / pieces) * way);
                sumM += !insideM || *insideM > deepM ? norm(way) / pieces : 0.0;
            }
        }
    }
    return sumM;
}

}  // namespace

class WaysOnHeadlandTest : public QObject {
    Q_OBJECT

private slots:
    void everyOperation_data() {
        QTest::addColumn<QString>("operation");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("field");
        QTest::addColumn<double>("allowedM");
        QTest::addColumn<QString>("traversal");
        for (const char* operation : {"sowing", "spraying", "spreading", "mowing", "harvest"}) {
            for (const char* machine : {"agbot", "planter"}) {
                QTest::addRow("%s, %s, rectangle", operation, machine)
                    << operation << machine << "POLYGON((0 0, 400 0, 400 250, 0 250, 0 0))" << 20.0
                    << "headland";
                QTest::addRow("%s, %s, L", operation, machine)
                    << operation << machine << "POLYGON((0 0, 400 0, 400 120, 180 120, 180 300, 0 300, 0 0))"
                    << 20.0 << "headland";
            }
        }
        for (const char* machine : {"agbot", "planter", "cultivator"}) {
            QTest::addRow("along the boundary, %s", machine)
                << "sowing" << machine << "POLYGON((0 0, 400 0, 400 120, 180 120, 180 300, 0 300, 0 0))"
                << 20.0 << "boundary";
        }
    }
    // A headland of 18 m leads from everywhere to the gate.
    void everyOperation() {
        QFETCH(QString, operation);
        QFETCH(QString, machine);
        QFETCH(QString, field);
        QFETCH(double, allowedM);
        QFETCH(QString, traversal);
        Settings settings;
        for (const auto& [key, text] :
             {std::pair<std::string_view, std::string>{"operation.kind", operation.toStdString()},
              {"route.traversal", traversal.toStdString()},
              {"headland.width_m", "18"}}) {
            applySetting(settings, key, text).value();
        }
        const auto plan = makePlan({.field = fieldOf(qPrintable(field), {0.0, 60.0}),
                                    .machine = findMachine(machine.toStdString()).value(),
                                    .settings = settings});
        VERIFY_RESULT(plan);
        QVERIFY((*plan)->drivable());
        QVERIFY((*plan)->path.length(SegmentKind::Transfer) > metres(10.0));
        const double overM = overMainlandM(**plan);
        QVERIFY2(overM <= allowedM, qPrintable(QString::number(overM)));
    }
};

FURROW_TEST(WaysOnHeadlandTest);
#include "tst_ways_on_headland.moc"
