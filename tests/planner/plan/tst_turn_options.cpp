#include "planner/machine/machine_library.h"
#include "planner/path/turn_shape.h"
#include "planner/plan/turn_options.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>

using namespace furrow;

namespace {

/// 300 by 200 m.
std::shared_ptr<const Plan> planOf(const char* machine) {
    const GeoRing ring{{22.5, 58.25}, {22.5051, 58.25}, {22.5051, 58.2518}, {22.5, 58.2518}};
    const auto field = Field::create({.id = "f",
                                      .name = "F",
                                      .origin = {},
                                      .parts = {{.outer = ring, .holes = {}}},
                                      .obstacles = {},
                                      .gates = {},
                                      .boundaryAccuracy = {}});
    return makePlan({.field = std::make_shared<const Field>(field.value()),
                     .machine = findMachine(machine).value(),
                     .settings = {}})
        .value();
}

}  // namespace

class TestTurnOptions : public QObject {
    Q_OBJECT

private slots:
    void everyTurnHasOthers_data() {
        QTest::addColumn<QString>("machine");
        for (const char* machine : {"agbot", "cultivator", "trailed-sprayer"}) {
            QTest::newRow(machine) << QString::fromLatin1(machine);
        }
    }
    void everyTurnHasOthers() {
        QFETCH(QString, machine);
        const auto plan = planOf(machine.toLatin1().constData());
        QVERIFY(plan->drivable());
        const auto turns = drivenTurns(plan->path);
        QVERIFY(!turns.empty());
        for (const DrivenTurn& turn : turns) {
            const auto options = turnOptions(*plan, turn.firstSegment, {});
            QVERIFY(options && *options);
            const double clearance = (*options)->clearance.si();
            // No turn comes nearer than the whole path does.
            QVERIFY2(
                clearance >= plan->audit.minClearance->si() - 0.03,
                qPrintable(QStringLiteral("%1 < %2").arg(clearance).arg(plan->audit.minClearance->si())));
            const auto& others = (*options)->others;
            QVERIFY(std::ranges::is_sorted(others, {}, [](const TurnOption& option) {
                return std::pair{!option.fits, option.duration.si()};
            }));
            QVERIFY(std::ranges::all_of(others,
                                        [](const TurnOption& option) { return option.duration.si() > 0.0; }));
            // Dubins' curve is one that every machine drives; its own place has the turn that is driven.
            const bool hasDubins = std::ranges::any_of(
                others, [](const TurnOption& option) { return option.name.text() == "Forward curves"; });
            QVERIFY(hasDubins || plan->path.segments[turn.firstSegment].turnType == "dubins");
        }
    }
    void aSwathHasNone() {
        const auto plan = planOf("agbot");
        const auto swath = std::ranges::find(plan->path.segments, SegmentKind::Swath, &PathSegment::kind);
        const auto options =
            turnOptions(*plan, static_cast<std::size_t>(swath - plan->path.segments.begin()), {});
        QVERIFY(options && !*options);
    }
};

FURROW_TEST(TestTurnOptions);
#include "tst_turn_options.moc"
