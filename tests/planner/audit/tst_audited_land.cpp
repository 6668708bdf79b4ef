#include "planner/audit/audited_land.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/audit_input.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

using namespace furrow;
using namespace furrow::test;

class TestAuditedLand : public QObject {
    Q_OBJECT

private slots:
    // Audits that share their land, and the pieces that they looked at, report what each reports by itself.
    void audits_data() {
        QTest::addColumn<QString>("machine");
        for (const char* machine : {"agbot", "cultivator", "trailed-sprayer"}) {
            QTest::newRow(machine) << machine;
        }
    }
    void audits() {
        QFETCH(QString, machine);
        std::mt19937_64 random{3};
        const auto field = std::make_shared<const Field>(
            Field::create(fieldSourceFromLocal(randomPolygons(random, Shape::Convex, 120.0), {9.2, 51.3}))
                .value());
        const auto plan =
            makePlan({.field = field, .machine = findMachine(machine.toStdString()).value(), .settings = {}});
        VERIFY_RESULT(plan);
        AuditInput input = auditInput(**plan);
        const auto land = auditedLand(input, {});
        VERIFY_RESULT(land);
        // Without the last segments more is missed.
        for (const std::size_t fewer : {std::size_t{0}, std::size_t{3}, std::size_t{3}, std::size_t{6}}) {
            input.segments = std::span{(*plan)->path.segments}.first((*plan)->path.segments.size() - fewer);
            const auto alone = audit(input, {.threads = 1});
            const auto shared = audit(input, *land, {.threads = 1});
            VERIFY_RESULT(alone);
            VERIFY_RESULT(shared);
            QVERIFY(*alone == *shared);
        }
    }
};

FURROW_TEST(TestAuditedLand);
#include "tst_audited_land.moc"
