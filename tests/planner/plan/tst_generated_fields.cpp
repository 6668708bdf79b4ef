#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/general_parameters.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace furrow;
using namespace furrow::test;

// Concave fields with obstacles of every kind: whatever comes of them, it is a plan or a refusal with its
// reason, and a plan that is called drivable is. FURROW_GENERATED=10000 tries that many,
// FURROW_GENERATED_FROM=5001 from that seed on.

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};
constexpr std::array kMachines{"agbot", "mounted-drill", "trailed-sprayer"};

int fromEnvironment(const char* name, int standard) {
    return qEnvironmentVariableIsSet(name) ? qEnvironmentVariableIntValue(name) : standard;
}

/// A blob, a ditch or a pole, anywhere in or about the field: across its boundary and each other, too.
Polygon obstacleIn(std::mt19937_64& random, double radiusM) {
    const Point middle =
        uniform(random, 0.0, 0.6) * radiusM * direction(uniform(random, 0.0, 2.0 * std::numbers::pi));
    const double kind = uniform(random, 0.0, 3.0);
    double longM = uniform(random, 0.05, 0.25) * radiusM;
    double wideM = longM * uniform(random, 0.4, 1.0);
    if (kind < 1.0) {
        longM = wideM = uniform(random, 0.1, 1.5);
    } else if (kind < 2.0) {
        longM = uniform(random, 0.3, 1.2) * radiusM;
        wideM = uniform(random, 0.2, 2.0);
    }
    const auto turned = moved({centredRectangle(longM, wideM)},
                              radians(uniform(random, 0.0, 2.0 * std::numbers::pi)), middle);
    return turned.front();
}

FieldSource generatedField(std::mt19937_64& random) {
    const double radiusM = uniform(random, 40.0, 130.0);
    FieldSource source = fieldSourceFromLocal(
        randomPolygons(random, uniform(random, 0.0, 1.0) < 0.7 ? Shape::Concave : Shape::Holes, radiusM),
        kCentre);
    // Around the middle of the field, wherever that was moved to.
    const LocalFrame frame = LocalFrame::centredOn(middleOf(source.parts)).value();
    const int count = static_cast<int>(uniform(random, 0.0, 8.0));
    for (int i = 0; i < count; ++i) {
        source.obstacles.push_back(
            {.name = "Obstacle " + std::to_string(i + 1),
             .outline = frame.toGeo(obstacleIn(random, radiusM)),
             .passable = uniform(random, 0.0, 1.0) < 0.2,
             .buffer = metres(uniform(random, 0.0, 1.0) < 0.5 ? 0.0 : uniform(random, 0.1, 3.0))});
    }
    return source;
}

/// Half of them as they are, the others with any method of every stage that needs nothing else.
Settings generatedSettings(std::mt19937_64& random) {
    Settings settings;
    if (uniform(random, 0.0, 1.0) < 0.5) {
        return settings;
    }
    for (const StageInfo& stage : stages()) {
        if (stage.id == "swaths") {
            // The others want a line, rows or heights.
            constexpr std::array kFree{"exact", "brute-force", "fixed", "longest-edge", "edge", "oksanen"};
            applySetting(settings, "swaths.method",
                         kFree[static_cast<std::size_t>(uniform(random, 0.0, kFree.size()))])
                .value();
            continue;
        }
        if (stage.id == "route") {
            // Not an order by hand.
            constexpr std::array kFree{"boustrophedon", "snake", "spiral", "skip", "racetrack"};
            applySetting(settings, "route.method",
                         kFree[static_cast<std::size_t>(uniform(random, 0.0, kFree.size()))])
                .value();
            continue;
        }
        const auto& method = stage.methods[static_cast<std::size_t>(
            uniform(random, 0.0, static_cast<double>(stage.methods.size())))];
        applySetting(settings, std::string{stage.id} + ".method", std::string{method.id}).value();
    }
    return settings;
}

/// What of tractor and implement is outside by more than a centimetre, wherever the path has a point.
double outsideByGeosM2(const Plan& plan) {
    const MultiPolygon open = dilated(plan.field().drivable(), metres(0.011), metres(0.0005), {}).value();
    MultiPolygon footprints;
    for (const PathSegment& segment : plan.path.segments) {
        const Machine machine = segment.folded ? plan.request.machine.folded() : plan.request.machine;
        const Ring shape = segment.implementDown ? machine.workingFootprint() : machine.turningFootprint();
        for (const PathSample& sample : segment.samples) {
            footprints.push_back(
                {.outer = placed(shape, {sample.position, radians(sample.headingRad)}), .holes = {}});
        }
    }
    return area(difference(unionOf(footprints, {}).value(), open, {}).value()).si();
}

}  // namespace

class TestGeneratedFields : public QObject {
    Q_OBJECT

    /// Worked, missed, or left on purpose; every place of the path is one.
    static void checkPlan(const Plan& plan, const QByteArray& where) {
        const AuditReport& report = plan.audit;
        const double workable = area(plan.field().workable()).si();
        // Wet spots are left on purpose, too, and no part of what is to be worked.
        const double left = workable - report.covered->si() - report.missed->si();
        const double slack = 1e-6 * workable + 1e-6;
        VERIFY_TOLD(left >= -slack && left <= report.leftOnPurpose->si() + slack, where);
        for (const PathSegment& segment : plan.path.segments) {
            VERIFY_TOLD(std::ranges::all_of(segment.samples,
                                            [](const PathSample& sample) {
                                                return std::isfinite(sample.position.x + sample.position.y +
                                                                     sample.headingRad + sample.tS +
                                                                     sample.sM);
                                            }),
                        where);
        }
    }
    /// Of a plan that is called drivable and has to stay inside; counts those that GEOS looked at.
    static void checkInside(const Plan& plan, const Machine& machine, int& looked, const QByteArray& where) {
        VERIFY_TOLD(plan.audit.minClearance->si() >= -0.01, where);
        // A trailed implement is not where the tractor's heading says: the audit's tests follow it by
        // themselves.
        if (machine.spec().implement.mounting == Mounting::Mounted) {
            ++looked;
            const double outside = outsideByGeosM2(plan);
            VERIFY_TOLD(outside <= 1e-3, where + ": " + QByteArray::number(outside) + " m² outside");
        }
    }

public:
    TestGeneratedFields() {
        if (qEnvironmentVariableIsSet("FURROW_GENERATED") &&
            !qEnvironmentVariableIsSet("QTEST_FUNCTION_TIMEOUT")) {
            qputenv("QTEST_FUNCTION_TIMEOUT", "36000000");
        }
    }

private slots:
    void planOrReason() {
        const int first = fromEnvironment("FURROW_GENERATED_FROM", 1);
        const int count = fromEnvironment("FURROW_GENERATED", 16);
        int planned = 0;
        int drivable = 0;
        int looked = 0;
        for (int seed = first; seed < first + count; ++seed) {
            std::mt19937_64 random{static_cast<std::uint64_t>(seed)};
            const QByteArray where = "seed " + QByteArray::number(seed);
            const FieldSource source = generatedField(random);
            const Machine machine =
                findMachine(kMachines[static_cast<std::size_t>(seed) % kMachines.size()]).value();
            const Settings settings = generatedSettings(random);
            auto field = Field::create(source);
            if (!field) {
                VERIFY_TOLD(field.error().code == ErrorCode::InputRefused && !field.error().what.empty(),
                            where);
                continue;
            }
            const auto made = makePlan({.field = std::make_shared<const Field>(std::move(*field)),
                                        .machine = machine,
                                        .settings = settings});
            if (!made) {
                VERIFY_TOLD(made.error().code == ErrorCode::InputRefused && !made.error().what.empty() &&
                                !made.error().remedy.empty(),
                            where + ": " + made.error().line().c_str());
                continue;
            }
            ++planned;
            const Plan& plan = **made;
            checkPlan(plan, where);
            if (QTest::currentTestFailed()) {
                return;
            }
            if (!plan.drivable()) {
                continue;
            }
            ++drivable;
            if (settings.flag(kStayInside)) {
                checkInside(plan, machine, looked, where);
            }
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        qInfo("%d of %d planned, %d drivable, %d of them looked at with GEOS", planned, count, drivable,
              looked);
        QVERIFY(planned > count / 2);
        QVERIFY(looked > count / 20);
    }
};

FURROW_TEST(TestGeneratedFields);
#include "tst_generated_fields.moc"
