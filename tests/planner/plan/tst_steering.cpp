// Steering follows every plan: the audit finds no place, and time and curvature of the samples say the same.

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/real_fields.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>

using namespace furrow;

namespace {

/// Radians in a second that the wheels turn between two samples. The curvature is that of the samples, the
/// time all that passes.
double wheelsRadps(const PathSample& a, const PathSample& b, double wheelbaseM) {
    const double turned = std::atan(wheelbaseM * b.curvature1pm) - std::atan(wheelbaseM * a.curvature1pm);
    return std::abs(turned) / std::max(1e-9, b.tS - a.tS);
}

}  // namespace

class SteeringTest : public QObject {
    Q_OBJECT

private slots:
    void steeringFollows_data() {
        QTest::addColumn<std::size_t>("field");
        QTest::addColumn<std::string>("machine");
        QTest::addColumn<std::string>("key");
        QTest::addColumn<std::string>("value");
        const auto add = [](std::size_t field, const std::string& machine, const char* key,
                            const char* value) {
            QTest::addRow("field %d, %s, %s %s", static_cast<int>(field), machine.c_str(), key, value)
                << field << machine << std::string{key} << std::string{value};
        };
        for (const Machine& machine : machineLibrary()) {
            add(0, machine.id(), "headland.corner", "quickest");
            add(5, machine.id(), "headland.corner", "rounded");
        }
        for (const char* corner : {"loop", "reverse"}) {
            add(0, "cultivator", "headland.corner", corner);
        }
        for (const char* turn : {"dubins", "reeds-shepp", "dubins-cc", "reeds-shepp-cc", "u", "omega", "p",
                                 "fishtail", "three-point"}) {
            add(0, "cultivator", "path.method", turn);
        }
        add(0, "field-robot", "path.method", "straight");
        add(1, "agbot", "swaths.method", "oksanen");
        add(1, "cultivator", "headland.corner", "rounded");
    }
    void steeringFollows() {
        QFETCH(std::size_t, field);
        QFETCH(std::string, machine);
        QFETCH(std::string, key);
        QFETCH(std::string, value);
        Settings settings;
        applySetting(settings, key, value).value();
        const auto plan = makePlan(
            {.field = std::make_shared<const Field>(Field::create(test::shippedFields()[field]).value()),
             .machine = findMachine(machine).value(),
             .settings = settings});
        VERIFY_RESULT(plan);
        for (const Finding& finding : (*plan)->findings) {
            QVERIFY2(finding.kind != FindingKind::CurvatureRate, finding.text.c_str());
        }
        const Tractor& tractor = (*plan)->request.machine.spec().tractor;
        if (!tractor.steeringRateRadps || tractor.maxCurvatureRate) {
            return;
        }
        const PathSample* before = nullptr;
        for (const PathSegment& segment : (*plan)->path.segments) {
            for (const PathSample& sample : segment.samples) {
                // Where it stands it steers before it goes on; a sample has the curvature after it.
                const bool drives = before != nullptr && before->speedMps > 0.0 && sample.speedMps > 0.0;
                if (drives && sample.sM > before->sM + 1e-6) {
                    const double rate = wheelsRadps(*before, sample, tractor.wheelbase.si());
                    VERIFY_TOLD(rate <= 1.01 * *tractor.steeringRateRadps + 1e-3 / (sample.tS - before->tS),
                                std::format("{} rad/s at {} m", rate, sample.sM).c_str());
                }
                before = &sample;
            }
        }
    }
};

FURROW_TEST(SteeringTest);
#include "tst_steering.moc"
