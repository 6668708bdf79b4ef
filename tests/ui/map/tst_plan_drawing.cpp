#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "tests/support/test_program.h"
#include "ui/map/plan_drawing.h"
#include "ui/map/plan_scene.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace furrow;

namespace {

/// A rectangle of this size with its south-west corner at 22.5 E, 58.25 N.
std::shared_ptr<const Plan> planOf(double widthDeg, double heightDeg,
                                   std::initializer_list<std::pair<const char*, const char*>> given = {},
                                   std::string_view machine = "agbot") {
    Settings settings;
    for (const auto& [key, value] : given) {
        applySetting(settings, key, value).value();
    }
    const GeoRing ring{{22.5, 58.25},
                       {22.5 + widthDeg, 58.25},
                       {22.5 + widthDeg, 58.25 + heightDeg},
                       {22.5, 58.25 + heightDeg}};
    const auto field = Field::create({.id = "f",
                                      .name = "F",
                                      .origin = {},
                                      .parts = {{.outer = ring, .holes = {}}},
                                      .obstacles = {},
                                      .gates = {},
                                      .boundaryAccuracy = {}});
    return makePlan({.field = std::make_shared<const Field>(field.value()),
                     .machine = findMachine(machine).value(),
                     .settings = settings})
        .value();
}

}  // namespace

class TestPlanDrawing : public QObject {
    Q_OBJECT

private slots:
    void framesAgree_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("origin") << 0.0 << 0.0;
        QTest::newRow("a kilometre east") << 1000.0 << 0.0;
        QTest::newRow("three kilometres south-west") << -2100.0 << -2200.0;
    }
    void framesAgree() {
        QFETCH(double, x);
        QFETCH(double, y);
        const LocalFrame local = LocalFrame::centredOn({.lonDeg = 22.5, .latDeg = 58.25}).value();
        const MapFrame frame{local};
        const MapPoint point = frame.map(Point{x, y});
        // Against the straight way: degrees to Mercator in double precision.
        const WorldPoint world = worldPoint(local.toGeo(Point{x, y}));
        QVERIFY(std::abs((world.x - frame.origin().x) * kUnitsPerWorld - double{point.x}) * 1.0 < 0.02);
        QVERIFY(std::abs((world.y - frame.origin().y) * kUnitsPerWorld - double{point.y}) * 1.0 < 0.02);
        // North is up, and a metre is as long as it says near the origin.
        if (x == 1000.0) {
            QVERIFY(std::abs(double{point.x} / frame.unitsPerMetre() - 1000.0) < 4.0);
        }
    }
    // Four corners for each chord: curves have many, and tramlines are drawn once more.
    void curvesAndTramlines() {
        const auto plan = planOf(0.01, 0.004,
                                 {{"swaths.method", "ab-curve"},
                                  {"swaths.line", "LINESTRING (22.501 58.251, 22.505 58.252, 22.509 58.251)"},
                                  {"swaths.tramline_every", "8"}});
        const PlanGeometry geometry = planGeometry(*plan);
        std::size_t chords = 0;
        std::size_t tramlineChords = 0;
        for (const Swath& swath : plan->swaths.swaths) {
            chords += middleLine(swath).size() - 1;
            tramlineChords += swath.tramline ? middleLine(swath).size() - 1 : 0;
        }
        QVERIFY(chords > 2 * plan->swaths.swaths.size());
        QVERIFY(tramlineChords > 0);
        QCOMPARE(geometry.swaths.vertices().size(), 4 * chords);
        QCOMPARE(geometry.tramlines.vertices().size(), 4 * tramlineChords);
    }
    // The implement of a trailed sprayer is metres behind the machine: what is drawn of a swath goes on to
    // where its turn begins.
    void swathsReachTheirTurns() {
        const auto plan = planOf(0.005, 0.003, {}, "trailed-sprayer");
        const PlanGeometry geometry = planGeometry(*plan);
        const std::vector<LineVertex>& corners = geometry.beyondSwaths.vertices();
        int turns = 0;
        for (std::size_t i = 1; i < geometry.segments.size(); ++i) {
            if (geometry.segments[i].kind != PathKind::Turn ||
                geometry.segments[i - 1].kind != PathKind::Work) {
                continue;
            }
            ++turns;
            const MapPoint begin = geometry.segments[i].points.front();
            QVERIFY(std::ranges::any_of(corners, [&](const LineVertex& corner) {
                const double x = double{corner.start.x} + double{corner.delta.x} - double{begin.x};
                const double y = double{corner.start.y} + double{corner.delta.y} - double{begin.y};
                return std::hypot(x, y) < 0.1 * geometry.unitsPerMetre;
            }));
        }
        QVERIFY(turns > 3);
    }
    // Nothing but that: no circle is drawn twice.
    void onlyWaysBeyondSwaths() {
        const auto plan =
            planOf(0.006, 0.003, {{"swaths.method", "pivot"}, {"swaths.line", "POINT (22.503 58.2515)"}},
                   "trailed-sprayer");
        const PlanGeometry geometry = planGeometry(*plan);
        QVERIFY(!plan->swaths.swaths.empty());
        double lengthM = 0.0;
        for (std::size_t i = 0; i < geometry.beyondSwaths.vertices().size(); i += 4) {
            const MapPoint delta = geometry.beyondSwaths.vertices()[i].delta;
            lengthM += std::hypot(double{delta.x}, double{delta.y}) / geometry.unitsPerMetre;
        }
        // The hitch and the drawbar of this machine are 7 m.
        QVERIFY2(lengthM < 12.0 * static_cast<double>(plan->swaths.swaths.size()),
                 qPrintable(QString::number(lengthM)));
    }
    void hasEverythingOfThePlan() {
        const auto plan = planOf(0.01, 0.004);
        const PlanGeometry geometry = planGeometry(*plan);
        QCOMPARE(geometry.swaths.vertices().size(), 4 * plan->swaths.swaths.size());
        QCOMPARE(geometry.numbers.size(), plan->swaths.swaths.size());
        QCOMPARE(geometry.rings.size(), std::size_t{1});
        QCOMPARE(geometry.rings.front().points.size(), std::size_t{4});
        QCOMPARE(geometry.findings.size(), plan->findings.size());
        QVERIFY(geometry.start && geometry.end);
        QVERIFY(!geometry.headland.empty());
        QCOMPARE(geometry.segments.size(), plan->path.segments.size());
        for (std::size_t i = 0; i < geometry.segments.size(); ++i) {
            QCOMPARE(geometry.segments[i].points.size(), plan->path.segments[i].samples.size());
        }
    }
    static double areaOf(const FillMesh& mesh) {
        double twice = 0.0;
        for (std::size_t i = 0; i + 2 < mesh.size(); i += 3) {
            const MapPoint a = mesh[i];
            const MapPoint b = mesh[i + 1];
            const MapPoint c = mesh[i + 2];
            twice += std::abs((double{b.x} - a.x) * (double{c.y} - a.y) -
                              (double{c.x} - a.x) * (double{b.y} - a.y));
        }
        return 0.5 * twice;
    }
    // What the audit measured is what is drawn, to a hundredth of it: the map's units are rounded.
    void measuredAreasAreDrawn() {
        const auto plan = planOf(0.006, 0.003, {{"headland.width_m", "15"}});
        const PlanGeometry geometry = planGeometry(*plan);
        const double unit = geometry.unitsPerMetre * geometry.unitsPerMetre;
        const AuditReport& audit = plan->audit;
        QVERIFY(std::abs(areaOf(geometry.covered) / unit - audit.covered->si()) < 0.01 * audit.covered->si());
        QVERIFY(std::abs(areaOf(geometry.missed) / unit - audit.missed->si()) <
                0.01 * audit.missed->si() + 1.0);
        QVERIFY(std::abs(areaOf(geometry.overlap) / unit - audit.overlap->si()) <
                0.02 * audit.overlap->si() + 1.0);
        QVERIFY(std::abs(areaOf(geometry.wheels) / unit - audit.oftenDrivenShare * audit.workable.si()) <
                0.02 * audit.oftenDrivenShare * audit.workable.si() + 1.0);
        QVERIFY(audit.oftenDrivenShare > 0.0 && audit.overlap->si() > 0.0);
    }
    void coarserLevelsHaveFewerPoints() {
        const PlanGeometry geometry = planGeometry(*planOf(0.01, 0.004));
        QVERIFY(!geometry.chunks.empty());
        for (const PathChunk& chunk : geometry.chunks) {
            QVERIFY(!chunk.box.isNull());
            for (std::size_t level = 1; level < PathChunk::kLevels; ++level) {
                QVERIFY(chunk.levels[level].vertices().size() <= chunk.levels[level - 1].vertices().size());
            }
        }
    }
    void numbersThinOut() {
        // In a plain order: neighbours have numbers that follow on each other.
        const PlanGeometry geometry = planGeometry(*planOf(0.01, 0.004, {{"route.method", "boustrophedon"}}));
        int last = 1000000;
        for (const double zoom : {12.0, 14.0, 16.0, 18.0, 20.0, 22.0}) {
            const int step = numberStep(geometry.numbers, std::exp2(zoom - 22.0));
            QVERIFY(step <= last);
            last = step;
        }
        // The last swath may lie on the one before it, to end flush with the edge.
        QVERIFY(last <= 2);
    }
    // The numbers on the map are those of the swaths, in their order across the field, and say when each is
    // driven.
    void numbersAreTheSwaths() {
        const auto plan = planOf(0.01, 0.004, {{"route.method", "snake"}});
        const PlanGeometry geometry = planGeometry(*plan);
        int order = 0;
        for (const PathSegment& segment : plan->path.segments) {
            if (segment.kind != SegmentKind::Swath) {
                continue;
            }
            ++order;
            const auto mark = std::ranges::find(geometry.numbers, segment.number, &NumberMark::number);
            QVERIFY(mark != geometry.numbers.end());
            QCOMPARE(mark->order, order);
        }
        QVERIFY(std::ranges::is_sorted(geometry.numbers, {}, &NumberMark::number));
        // In this order the two differ.
        QVERIFY(!std::ranges::is_sorted(geometry.numbers, {}, &NumberMark::order));
    }
    void reverseIsAKindOfItsOwn() {
        // A wide turning circle and no room beside the field: turns go backwards.
        const auto plan = planOf(0.004, 0.003, {{"path.method", "fishtail"}, {"headland.width_m", "14"}});
        const PlanGeometry geometry = planGeometry(*plan);
        std::size_t reversed = 0;
        for (std::size_t i = 0; i < geometry.segments.size(); ++i) {
            const bool isReverse = geometry.segments[i].kind == PathKind::Reverse;
            QCOMPARE(isReverse,
                     plan->path.segments[i].gear == Gear::Reverse && plan->path.segments[i].drivable);
            reversed += isReverse ? 1 : 0;
        }
        QVERIFY(reversed > 0);
    }
    void brokenBoundaryIsDrawnAsFarAsItGoes() {
        FieldSource source{.id = "x",
                           .name = "x",
                           .origin = {},
                           .parts = {},
                           .obstacles = {},
                           .gates = {},
                           .boundaryAccuracy = {}};
        QVERIFY(outlineGeometry(source, {}).rings.empty());
        source.parts = {
            {.outer = {{22.5, 58.25}, {22.51, 58.26}, {22.51, 58.25}, {22.5, 58.26}}, .holes = {}},
            {.outer = {{std::nan(""), 1.0}, {2.0, 2.0}, {3.0, 1.0}}, .holes = {}}};
        const PlanGeometry geometry = outlineGeometry(source, GeoPoint{.lonDeg = 22.505, .latDeg = 58.255});
        QCOMPARE(geometry.rings.size(), std::size_t{1});
        QCOMPARE(geometry.findings.size(), std::size_t{1});
        QVERIFY(geometry.bounds.contains(QGeoCoordinate(58.255, 22.505)));
    }
};

FURROW_TEST(TestPlanDrawing);
#include "tst_plan_drawing.moc"
