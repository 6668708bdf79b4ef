#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;

/// The time to a new plan after one setting of a stage was changed, with the stages of the plan before and
/// without.
class ChangesBenchmark : public QObject {
    Q_OBJECT

private slots:
    void change_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        QTest::addColumn<bool>("cached");
        for (const bool cached : {false, true}) {
            const char* how = cached ? "cache" : "anew";
            QTest::addRow("nothing, %s", how) << "" << "" << cached;
            QTest::addRow("headland, %s", how) << "headland.width_m" << "12" << cached;
            QTest::addRow("swaths, %s", how) << "swaths.overlap_m" << "0.1" << cached;
            QTest::addRow("cells, %s", how) << "decomposition.method" << "boustrophedon" << cached;
            QTest::addRow("route, %s", how) << "route.method" << "snake" << cached;
            QTest::addRow("turns, %s", how) << "path.method" << "u" << cached;
        }
    }
    void change() {
        QFETCH(QString, key);
        QFETCH(QString, value);
        QFETCH(bool, cached);
        // great_field has 49 ha; a small one by default, since all benchmarks run with the tests.
        const std::string name = qEnvironmentVariable("FURROW_BENCH_FIELD", "home_field").toStdString();
        const auto sources =
            readBoundaries(FURROW_SOURCE_DIR "/resources/sample_fields/" + name + ".geojson").value();
        const PlanRequest before{
            .field = std::make_shared<const Field>(Field::create(sources.front()).value()),
            .machine = findMachine("agbot").value(),
            .settings = {}};
        PlanRequest after = before;
        if (!key.isEmpty()) {
            applySetting(after.settings, key.toStdString(), value.toStdString()).value();
        }
        StageCache cache;
        if (cached) {
            makePlan(before, {}, &cache).value();
        }
        QBENCHMARK_ONCE {
            makePlan(after, {}, cached ? &cache : nullptr).value();
        }
    }
};

FURROW_TEST(ChangesBenchmark);
#include "bench_changes.moc"
