#include "planner/geometry/geos_bridge.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace furrow;
using namespace furrow::test;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

double sweptArea(const PathSegment& swath, double width) {
    return width * distance(swath.samples.front().position, swath.samples.back().position);
}

}  // namespace

namespace {

/// Straight lanes only: what they sweep can be worked out from their lengths.
Settings mainlandOnly() {
    Settings settings;
    applySetting(settings, "headland.driven", "false").value();
    return settings;
}

}  // namespace

class TestAuditProperties : public QObject {
    Q_OBJECT
private slots:
    void generatedFields() {
        int planned = 0;
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            std::mt19937_64 random{seed};
            const Shape shape = kShapes[seed % kShapes.size()];
            const auto polygons = randomPolygons(random, shape, uniform(random, 60.0, 160.0));
            auto field = Field::create(fieldSourceFromLocal(polygons, kCentre));
            VERIFY_RESULT(field);
            const Machine& machine = machineLibrary()[seed % machineLibrary().size()];
            const auto result = makePlan({.field = std::make_shared<const Field>(std::move(*field)),
                                          .machine = machine,
                                          .settings = mainlandOnly()});
            if (!result) {
                continue;
            }
            ++planned;
            const Plan& plan = **result;
            const AuditReport& report = plan.audit;
            const QByteArray where = "seed " + QByteArray::number(static_cast<int>(seed));
            const double workable = area(plan.field().workable()).si();
            VERIFY_TOLD(std::abs(report.covered->si() + report.missed->si() - workable) <= 1e-6 * workable,
                        where);
            // Outlines of less than 10 cm² are left out: of a small field that is more than a millionth.
            VERIFY_TOLD(
                std::abs(area(report.missedAreas).si() - report.missed->si()) <= 1e-6 * workable + 5e-3,
                where);
            VERIFY_TOLD(report.overlap->si() <= report.covered->si() + 1e-6 * workable, where);
            VERIFY_TOLD(report.overlapHeadland->si() <= report.overlap->si() + 1e-6 * workable, where);
            VERIFY_TOLD(*report.coveredOfReachable <= 1.0 && *report.coveredShare <= 1.0, where);
            VERIFY_TOLD((report.minClearance->si() < 0.0) == (report.outside->si() > 0.0) ||
                            std::abs(report.minClearance->si()) < 1e-3 || report.outside->si() < 1e-3,
                        where);
            // A lane lost on the way would be missing here: swept areas add up to what is covered once and
            // more, less what lies outside.
            if (machine.spec().implement.mounting == Mounting::Mounted) {
                double swept = 0.0;
                for (const PathSegment& segment : plan.path.segments) {
                    swept += segment.implementDown ? sweptArea(segment, machine.operatingWidth().si()) : 0.0;
                }
                VERIFY_TOLD(report.covered->si() + report.overlap->si() <= 1.001 * swept + 0.1, where);
                // The lanes of one heading, slid by the implement's offset, reach outside here and there.
                if (report.overlap->si() < 1e-6 && report.outside->si() < 1e-6) {
                    VERIFY_TOLD(std::abs(report.covered->si() - swept) < 0.1, where);
                }
            }
        }
        qInfo("%d fields planned", planned);
        QVERIFY(planned > 40);
    }
    // Plans with every kind of turn, on fields with room for it: what the points tell is what the samples
    // state, and nothing stands in the way that is not there.
    void turnMethods_data() {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("machine");
        for (const MethodInfo& method : stageInfo("path").methods) {
            for (const char* machine : {"agbot", "mounted-drill", "trailed-sprayer"}) {
                QTest::addRow("%s, %s", std::string{method.id}.c_str(), machine)
                    << QString::fromStdString(std::string{method.id}) << machine;
            }
        }
    }
    void turnMethods() {
        QFETCH(QString, method);
        QFETCH(QString, machine);
        MachineSpec spec = findMachine(machine.toStdString())->spec();
        // A trailed implement does not reverse unless set; here it is the turns that are looked at.
        spec.tractor.canReverse = true;
        spec.implement.canReverse = true;
        spec.tractor.canTurnInPlace = method == "straight";
        std::mt19937_64 random{11};
        const std::vector<MultiPolygon> fields{{centredRectangle(260.0, 200.0)},
                                               randomPolygons(random, Shape::Convex, 160.0)};
        for (const MultiPolygon& polygons : fields) {
            Settings settings;
            applySetting(settings, "path.method", method.toStdString()).value();
            applySetting(settings, "headland.driven", "false").value();
            applySetting(settings, "headland.width_m", "30").value();
            applySetting(settings, "swaths.method", "longest-edge").value();
            const auto plan = makePlan({.field = std::make_shared<const Field>(
                                            Field::create(fieldSourceFromLocal(polygons, kCentre)).value()),
                                        .machine = Machine::create(spec).value(),
                                        .settings = settings});
            VERIFY_RESULT(plan);
            const AuditReport& report = (*plan)->audit;
            QByteArray told;
            for (const AuditFinding& each : report.findings) {
                told += (std::string{kindId(each.finding)} + ": " + each.finding.text + "\n").c_str();
            }
            for (const double figure :
                 {report.covered->si(), report.missed->si(), report.overlap->si(), report.outside->si(),
                  report.minClearance->si(), report.maxCurvature->si(), report.maxCurvatureMismatch->si(),
                  report.maxCurvatureRate->si(), report.maxPositionJump->si(), report.maxHeadingJump->si(),
                  report.drivenOnWorked.si(), report.areaError.si()}) {
                VERIFY_TOLD(std::isfinite(figure), told);
            }
            VERIFY_TOLD(std::ranges::none_of(report.findings,
                                             [](const AuditFinding& each) {
                                                 return each.finding.severity == Severity::Blocking;
                                             }),
                        told);
            const Machine& used = (*plan)->request.machine;
            VERIFY_TOLD(report.maxCurvature->si() <= 1.0 / used.minTurningRadius().si() * 1.002, told);
            COMPARE_WITHIN(report.maxCurvatureMismatch->si(), 0.0, 1e-3);
            COMPARE_WITHIN(report.maxPositionJump->si(), 0.0, 1e-3);
            if (method != "straight") {
                COMPARE_WITHIN(report.maxHeadingJump->si(), 0.0, 1e-3);
            }
            if (method.endsWith("-cc")) {
                // Eased where it meets other lines, at least at half the turning speed.
                QVERIFY(report.maxCurvatureRate->si() <= 2.1 * used.maxCurvatureRate().si());
            }
            double reversed = 0.0;
            for (const PathSegment& segment : (*plan)->path.segments) {
                reversed += segment.gear == Gear::Reverse ? segment.length().si() : 0.0;
            }
            COMPARE_WITHIN(report.reversed.si(), reversed, 0.01 * reversed + 0.01);
        }
    }

    // Every lane of a tiled rectangle at any angle: the union must lose none.
    void tiledLanesAreAllCounted() {
        std::mt19937_64 random{7};
        for (int round = 0; round < 40; ++round) {
            const double width = uniform(random, 1.0, 12.0);
            const int count = 20 + static_cast<int>(uniform(random, 0.0, 130.0));
            const double length = uniform(random, 50.0, 600.0);
            const double heading = uniform(random, 0.0, 6.28);
            const Point along = direction(heading);
            const Point left{-along.y, along.x};
            MachineSpec spec = findMachine("agbot")->spec();
            spec.implement.operatingWidth = metres(width);
            spec.implement.offset = metres(0.0);
            std::vector<PathSegment> segments;
            for (int i = 0; i < count; ++i) {
                const Point start = Point{uniform(random, -1e-9, 1e-9), 300.0} + (i * width) * left;
                PathSegment segment{.kind = SegmentKind::Swath, .turnType = {}, .implementDown = true};
                segment.samples = {
                    {.position = start, .headingRad = heading},
                    {.sM = length, .tS = length, .position = start + length * along, .headingRad = heading}};
                segments.push_back(segment);
            }
            const MultiPolygon field{
                {.outer = {{-1e4, -1e4}, {1e4, -1e4}, {1e4, 1e4}, {-1e4, 1e4}}, .holes = {}}};
            const auto report = audit({.workable = field,
                                       .drivable = field,
                                       .machine = Machine::create(spec).value(),
                                       .segments = segments});
            VERIFY_RESULT(report);
            COMPARE_WITHIN(report->covered->si(), width * length * count, 0.05);
            COMPARE_WITHIN(report->overlap->si(), 0.0, 0.05);
        }
    }
};

FURROW_TEST(TestAuditProperties);
#include "tst_audit_properties.moc"
