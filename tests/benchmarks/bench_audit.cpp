#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace furrow;
using namespace furrow::test;

namespace {

/// A bent round field of 100 corners with five round ponds.
MultiPolygon roundField(double hectares) {
    Ring outer;
    for (int i = 0; i < 100; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 100.0;
        const double radius = 1.0 + 0.12 * std::sin(2.0 * angle + 1.0) + 0.06 * std::sin(3.0 * angle);
        outer.push_back({1.25 * radius * std::cos(angle), 0.8 * radius * std::sin(angle)});
    }
    const double scale = std::sqrt(hectares * 1e4 / signedAreaM2(outer));
    for (Point& point : outer) {
        point = scale * point;
    }
    Polygon field{.outer = outer, .holes = {}};
    for (const Point middle :
         {Point{-0.5, 0.1}, Point{0.25, -0.2}, Point{0.5, 0.25}, Point{-0.1, -0.4}, Point{-0.75, -0.15}}) {
        Ring pond;
        for (int k = 0; k < 8; ++k) {
            pond.push_back(scale * middle + 15.0 * direction(-2.0 * std::numbers::pi * k / 8.0));
        }
        field.holes.push_back(pond);
    }
    return {field};
}

}  // namespace

/// The audit of finished plans; the planning itself is not timed.
class AuditBenchmark : public QObject {
    Q_OBJECT
private slots:
    void plans_data() {
        QTest::addColumn<MultiPolygon>("polygons");
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QStringList>("settings");
        QTest::newRow("1 ha, 2.5 m") << MultiPolygon{rectangle(100, 100)} << "agbot" << QStringList{};
        QTest::newRow("1 ha, clothoids")
            << MultiPolygon{rectangle(100, 100)} << "agbot" << QStringList{"path.method=dubins-cc"};
        QTest::newRow("50 ha, 100 corners, 5 ponds, 2.5 m") << roundField(50) << "agbot" << QStringList{};
        QTest::newRow("50 ha, 100 corners, 5 ponds, 6 m")
            << roundField(50) << "mounted-drill" << QStringList{};
        QTest::newRow("50 ha, 100 corners, 5 ponds, trailed")
            << roundField(50) << "trailed-sprayer" << QStringList{};
        QTest::newRow("4 ha, every turn outside")
            << MultiPolygon{rectangle(200, 200)} << "agbot" << QStringList{"headland.method=none"};
    }
    void plans() {
        QFETCH(MultiPolygon, polygons);
        QFETCH(QString, machine);
        QFETCH(QStringList, settings);
        Settings chosen;
        applySetting(chosen, "swaths.method", "longest-edge").value();
        for (const QString& setting : settings) {
            applySetting(chosen, setting.section('=', 0, 0).toStdString(),
                         setting.section('=', 1).toStdString())
                .value();
        }
        const auto plan = makePlan({.field = std::make_shared<const Field>(
                                        Field::create(fieldSourceFromLocal(polygons, {9.2, 51.3})).value()),
                                    .machine = findMachine(machine.toStdString()).value(),
                                    .settings = chosen})
                              .value();
        double covered = 0.0;
        QBENCHMARK {
            covered = audit(auditInput(*plan)).value().covered->si();
        }
        QVERIFY(covered > 0.0);
    }
};

FURROW_TEST(AuditBenchmark);
#include "bench_audit.moc"
