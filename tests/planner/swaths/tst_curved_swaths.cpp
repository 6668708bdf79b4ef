#include "planner/geometry/curve_parts.h"
#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/machine/machine_library.h"
#include "planner/route/methods.h"
#include "planner/route/route.h"
#include "planner/swaths/curved_swaths.h"
#include "planner/swaths/full_ends.h"
#include "planner/swaths/methods.h"
#include "planner/swaths/strip_coverage.h"
#include "planner/turns/connection.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};
constexpr double kPi = std::numbers::pi;

Field fieldFrom(const MultiPolygon& polygons) {
    return Field::create(test::fieldSourceFromLocal(polygons, kCentre)).value();
}

Machine machineOf(double widthM, double radiusM) {
    MachineSpec spec = findMachine("agbot")->spec();
    spec.implement.operatingWidth = metres(widthM);
    spec.tractor.minTurningRadius = metres(radiusM);
    return Machine::create(spec).value();
}

using Given = std::initializer_list<std::pair<const Parameter*, std::string>>;

Result<SwathSet> run(const Method<SwathGenerator>& method, const Field& field, const Machine& machine,
                     const Given& given, const JobContext& job = {}) {
    Settings settings;
    for (const auto& [parameter, text] : given) {
        settings.setText(*parameter, text).value();
    }
    return method.run(
        {.field = field, .mainland = field.workable(), .machine = machine, .settings = settings}, job);
}

std::string wktOf(const Field& field, const Polyline& points) {
    QStringList texts;
    for (const Point& point : points) {
        const GeoPoint place = field.frame().toGeo(point);
        texts << QStringLiteral("%1 %2").arg(place.lonDeg, 0, 'f', 12).arg(place.latDeg, 0, 'f', 12);
    }
    return (QLatin1String(points.size() == 1 ? "POINT (" : "LINESTRING (") + texts.join(", ") + ")")
        .toStdString();
}

double toLine(Point point, const Polyline& line) {
    double nearest = 1e12;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point way = line[i + 1] - line[i];
        const double share = std::clamp(dot(point - line[i], way) / std::max(dot(way, way), 1e-12), 0.0, 1.0);
        nearest = std::min(nearest, distance(point, line[i] + share * way));
    }
    return nearest;
}

/// What a swath works, quadrilateral by quadrilateral.
MultiPolygon stripsOf(const Swath& swath) {
    Polyline line;
    for (const Point& point : middleLine(swath, metres(0.002))) {
        // Chords of rounding have no direction.
        if (line.empty() || distance(line.back(), point) > 0.01) {
            line.push_back(point);
        }
    }
    MultiPolygon strips;
    if (line.size() < 2) {
        return strips;
    }
    const auto side = [&](std::size_t i) {
        const Point in = i == 0 ? line[1] - line[0] : line[i] - line[i - 1];
        const Point out = i + 1 == line.size() ? in : line[i + 1] - line[i];
        const Point ahead = (1.0 / norm(in)) * in + (1.0 / norm(out)) * out;
        return 0.5 * swath.width.si() / norm(ahead) * Point{-ahead.y, ahead.x};
    };
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        Ring ring{line[i] - side(i), line[i + 1] - side(i + 1), line[i + 1] + side(i + 1), line[i] + side(i)};
        strips.push_back({.outer = ring, .holes = {}});
    }
    return strips;
}

/// A quarter of a ring between these radii, about the origin.
MultiPolygon bentField(double innerM, double outerM) {
    Ring ring;
    for (int i = 0; i <= 90; ++i) {
        ring.push_back(outerM * direction(i * kPi / 180.0));
    }
    for (int i = 90; i >= 0; --i) {
        ring.push_back(innerM * direction(i * kPi / 180.0));
    }
    return {{.outer = ring, .holes = {}}};
}

Polyline arcAround(Point centre, double radiusM) {
    Polyline points;
    for (int i = 0; i <= 45; ++i) {
        points.push_back(centre + radiusM * direction(2.0 * i * kPi / 180.0));
    }
    return points;
}

/// Across the middle of a box. Gentle: no bend of less than 500 m, so that no parallel within the field is
/// singular.
Polyline gentleCurve(std::mt19937_64& random, const Bounds& box) {
    const double headingRad = test::uniform(random, 0.0, kPi);
    const double bendM = test::uniform(random, 500.0, 2000.0);
    const Point middle = 0.5 * (box.min + box.max);
    Polyline points;
    for (int i = -40; i <= 40; ++i) {
        points.push_back(middle + bendM * (direction(headingRad + i * 0.01) - direction(headingRad)));
    }
    return points;
}

/// Middle lines of swaths by their track.
using Tracks = std::map<int, std::vector<Polyline>>;

struct Neighbour {
    double awayM = 1e12;
    bool besideMiddle = false;
};

Neighbour neighbourOf(Point point, const std::vector<Polyline>& lines) {
    Neighbour nearest;
    for (const Polyline& other : lines) {
        const double hereM = toLine(point, other);
        nearest.besideMiddle = hereM < nearest.awayM
                                   ? toLine(point, {other.begin() + 1, other.end() - 1}) <= hereM + 1e-9
                                   : nearest.besideMiddle;
        nearest.awayM = std::min(nearest.awayM, hereM);
    }
    return nearest;
}

}  // namespace

class CurvedSwathsTest : public QObject {
    Q_OBJECT

    static void checkSwaths(const SwathSet& set, const Field& field, const QByteArray& told) {
        const auto around = dilated(field.workable(), metres(0.002), metres(0.001), {});
        VERIFY_RESULT(around);
        const PreparedArea area{*around};
        for (const Swath& swath : set.swaths) {
            VERIFY_TOLD(area.covers({middleLine(swath, metres(0.0005))}), told);
            VERIFY_TOLD(sharpestBend(swath.curve).si() <= 1.0 / 8.0, told);
            VERIFY_TOLD(distance(swath.curve.end().position, swath.end) < 1e-6, told);
        }
    }
    /// An operating width apart, wherever the neighbour goes on; counts the places that were compared.
    static void compareNeighbours(const SwathSet& set, double widthM, int& compared, const QByteArray& told) {
        Tracks tracks;
        for (const Swath& swath : set.swaths) {
            // The outermost may have been moved back to the edge.
            if (swath.lane) {
                tracks[swath.track].push_back(middleLine(swath, metres(0.0005)));
            }
        }
        for (const auto& [track, lines] : tracks) {
            const auto next = tracks.find(track + 1);
            if (next == tracks.end()) {
                continue;
            }
            for (const Polyline& line : lines) {
                for (std::size_t i = 0; i < line.size(); i += 5) {
                    const auto [awayM, besideMiddle] = neighbourOf(line[i], next->second);
                    VERIFY_TOLD(awayM > widthM - 0.01, told + " " + QByteArray::number(awayM));
                    // Not where the neighbour has ended.
                    if (besideMiddle && awayM < 1.5 * widthM) {
                        VERIFY_TOLD(awayM < widthM + 0.01, told + " " + QByteArray::number(awayM));
                        ++compared;
                    }
                }
            }
        }
    }
    static void compareCoverage(const SwathSet& set, const Field& field) {
        MultiPolygon strips;
        for (const Swath& swath : set.swaths) {
            std::ranges::copy(stripsOf(swath), std::back_inserter(strips));
        }
        const auto all = unionOf(strips, {}, kSnapGrid);
        VERIFY_RESULT(all);
        const auto covered = intersection(*all, field.workable(), {});
        VERIFY_RESULT(covered);
        COMPARE_WITHIN(set.coverage, furrow::area(*covered) / furrow::area(field.workable()), 2e-3);
    }

private slots:
    // 40 m between the arcs, 4 m wide: ten swaths from edge to edge, with one on the curve 38 m inside of the
    // rim.
    void swathsFollowTheCurve() {
        const Field field = fieldFrom(bentField(100.0, 140.0));
        const Point centre = field.frame().toLocal(kCentre);
        const auto set = run(kAbCurveMethod, field, machineOf(4.0, 5.0),
                             {{&kLine, wktOf(field, arcAround(centre, 102.0))}});
        VERIFY_RESULT(set);
        QVERIFY(set->isCurved());
        // Chords of an arc, and arcs through them again, lie up to 15 cm beside it: the rim may need an
        // overlapping one.
        QVERIFY2(set->swaths.size() == 10 || set->swaths.size() == 11,
                 qPrintable(QString::number(set->swaths.size())));
        for (const Swath& swath : set->swaths) {
            const Polyline line = middleLine(swath);
            const double radiusM = distance(line[line.size() / 2], centre);
            for (const Point& point : line) {
                COMPARE_WITHIN(distance(point, centre), radiusM, 0.2);
            }
            COMPARE_WITHIN(swath.length().si(), 0.5 * kPi * radiusM, 0.01 * radiusM);
        }
        QVERIFY2(set->coverage > 0.995, qPrintable(QString::number(set->coverage)));
    }

    // Without a line the run of edges around edge 45, which is the rim: up to both corners, 2 m inside of it.
    void withoutALineItFollowsTheEdges() {
        const Field field = fieldFrom(bentField(100.0, 140.0));
        const auto set = run(kAbCurveMethod, field, machineOf(4.0, 5.0), {{&kEdge, "45"}});
        VERIFY_RESULT(set);
        const Point centre = field.frame().toLocal(kCentre);
        double outermostM = 0.0;
        for (const Swath& swath : set->swaths) {
            for (const Point& point : middleLine(swath)) {
                outermostM = std::max(outermostM, distance(point, centre));
            }
        }
        COMPARE_WITHIN(outermostM, 138.0, 0.2);
        const auto none = run(kAbCurveMethod, field, machineOf(4.0, 5.0), {{&kEdge, "500"}});
        QVERIFY(!none);
        QCOMPARE(none.error().where, std::string{"swaths.edge"});
    }

    // Rings of 5 m from the rim of 100 m inwards, each whole; the innermost that can be driven has 7.5 m.
    void aCurveThatNobodyFollowsIsRefused_data() {
        QTest::addColumn<Polyline>("points");
        QTest::addColumn<QByteArray>("told");
        QTest::newRow("far away") << Polyline{{300'000.0, 0.0}, {300'100.0, 30.0}, {300'200.0, 0.0}}
                                  << QByteArray{"away from the field"};
        // 3,000 corners of a right angle within 3 m: 1,500 half circles.
        Polyline scribble;
        for (int i = 0; i < 1'500; ++i) {
            const double x = 0.002 * i;
            scribble.push_back({x, i % 2 == 0 ? 0.0 : 0.4});
            scribble.push_back({x, i % 2 == 0 ? 0.4 : 0.0});
        }
        QTest::newRow("scribble") << scribble << QByteArray{"bends more sharply"};
    }
    void aCurveThatNobodyFollowsIsRefused() {
        QFETCH(Polyline, points);
        QFETCH(QByteArray, told);
        const Field field = fieldFrom({test::centredRectangle(200.0, 100.0)});
        const auto set = run(kAbCurveMethod, field, machineOf(4.0, 5.0), {{&kLine, wktOf(field, points)}});
        QVERIFY(!set);
        QCOMPARE(set.error().code, ErrorCode::InputRefused);
        QVERIFY2(QByteArray::fromStdString(set.error().what.text()).contains(told),
                 set.error().what.text().c_str());
        QCOMPARE(set.error().where, std::string{"swaths.line"});
    }

    void pivotsAreRings() {
        Ring rim;
        for (int i = 0; i < 720; ++i) {
            rim.push_back(100.0 * direction(0.5 * i * kPi / 180.0));
        }
        const Field field = fieldFrom({{.outer = rim, .holes = {}}});
        const Point centre = field.frame().toLocal(kCentre);
        const auto set = run(kPivotMethod, field, machineOf(5.0, 6.0), {{&kLine, wktOf(field, {centre})}});
        VERIFY_RESULT(set);
        QCOMPARE(set->swaths.size(), std::size_t{19});
        for (std::size_t i = 0; i < set->swaths.size(); ++i) {
            const Swath& swath = set->swaths[i];
            QVERIFY(swath.isClosed());
            COMPARE_WITHIN(swath.length().si(), 2.0 * kPi * (97.5 - 5.0 * static_cast<double>(i)), 1e-3);
            COMPARE_WITHIN(distance(swath.start, centre), 97.5 - 5.0 * static_cast<double>(i), 1e-3);
        }
        // pi 100² less the disc of 5 m that cannot be driven, and the slivers between rim and chords.
        COMPARE_WITHIN(set->coverage, 1.0 - 25.0 / 10000.0, 1e-3);
        COMPARE_WITHIN(set->overlap.si(), 0.0, 5.0);
        QCOMPARE(set->notes.size(), std::size_t{1});
        // All the same way round.
        const auto route = test::routeBy(kBoustrophedonMethod, *set, machineOf(5.0, 6.0), {});
        VERIFY_RESULT(route);
        for (const RouteStep& step : route->steps) {
            QCOMPARE(step.reversed, route->steps.front().reversed);
        }
    }

    void pivotNeedsItsCentre() {
        const Field field = fieldFrom(bentField(100.0, 140.0));
        const auto set = run(kPivotMethod, field, machineOf(4.0, 5.0), {});
        QVERIFY(!set);
        QCOMPARE(set.error().code, ErrorCode::Usage);
        QCOMPARE(set.error().where, std::string{"swaths.line"});
    }

    // An operating width between tracks, and flush at the far edges but for `gap`.
    void tracksAreSpaced_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<LastPass>("lastPass");
        QTest::addColumn<bool>("anchored");
        QTest::addColumn<QList<double>>("places");
        QTest::newRow("flush at both edges")
            << 0.0 << 12.0 << LastPass::Overlap << false << QList<double>{2, 6, 10};
        QTest::newRow("the last one overlaps")
            << 0.0 << 11.0 << LastPass::Overlap << false << QList<double>{2, 6, 9};
        QTest::newRow("spread evenly")
            << 0.0 << 11.0 << LastPass::Spread << false << QList<double>{2, 5.5, 9};
        QTest::newRow("the rest is left") << 0.0 << 9.9 << LastPass::Gap << false << QList<double>{2, 6};
        QTest::newRow("half a width reaches over the edge")
            << 0.0 << 10.0 << LastPass::Gap << false << QList<double>{2, 6, 10};
        QTest::newRow("through the line")
            << -5.0 << 7.0 << LastPass::Overlap << true << QList<double>{-3, 0, 4, 5};
        QTest::newRow("through the line, the smaller rest is left")
            << -5.0 << 7.0 << LastPass::Gap << true << QList<double>{-4, 0, 4};
        QTest::newRow("narrower than one") << 10.0 << 12.0 << LastPass::Overlap << false << QList<double>{11};
    }
    void tracksAreSpaced() {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(LastPass, lastPass);
        QFETCH(bool, anchored);
        QFETCH(QList<double>, places);
        const auto made =
            trackPlaces(low, high, {.width = metres(4.0), .overlap = {}, .lastPass = lastPass}, anchored);
        QCOMPARE(made.size(), static_cast<std::size_t>(places.size()));
        for (std::size_t i = 0; i < made.size(); ++i) {
            COMPARE_WITHIN(made[i], places[static_cast<qsizetype>(i)], 1e-9);
        }
    }

    // Two strips of 2 m over a square of 10 m, which overlap by 1 m: 30 m² once or more, 10 m² twice.
    void coverageOfStrips() {
        const MultiPolygon square{test::rectangle(10.0, 10.0)};
        const MultiPolygon strips{test::rectangle(12.0, 2.0, {-1.0, 3.0}),
                                  test::rectangle(12.0, 2.0, {-1.0, 4.0})};
        const auto covered = coverageOf(strips, square, {}, {});
        VERIFY_RESULT(covered);
        COMPARE_WITHIN(covered->share, 0.3, 1e-9);
        COMPARE_WITHIN(covered->overlap.si(), 10.0, 1e-9);
    }

    // Over generated fields and curves: inside the mainland (GEOS), bends within the limit, neighbours an
    // operating width apart wherever the curve bends gently, coverage as GEOS's union has it.
    void propertiesOverGeneratedFields() {
        constexpr double kWidthM = 6.0;
        const Machine machine = machineOf(kWidthM, 8.0);
        std::mt19937_64 random{4711};
        int compared = 0;
        for (int round = 0; round < 40; ++round) {
            const test::Shape shape = test::kShapes[static_cast<std::size_t>(round) % test::kShapes.size()];
            const MultiPolygon polygons = test::randomPolygons(random, shape, 150.0);
            const auto created = Field::create(test::fieldSourceFromLocal(polygons, kCentre));
            if (!created) {
                continue;
            }
            const Field& field = *created;
            const Polyline points = gentleCurve(random, bounds(field.workable()));
            const auto set =
                run(kAbCurveMethod, field, machine, {{&kLine, wktOf(field, points)}, {&kLastPass, "gap"}});
            const QByteArray told =
                "round " + QByteArray::number(round) + " " + QByteArray{test::shapeName(shape).data()};
            if (!set) {
                QCOMPARE(set.error().code, ErrorCode::InputRefused);
                continue;
            }
            checkSwaths(*set, field, told);
            if (QTest::currentTestFailed()) {
                return;
            }
            compareNeighbours(*set, kWidthM, compared, told);
            if (QTest::currentTestFailed()) {
                return;
            }
            compareCoverage(*set, field);
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        QVERIFY2(compared > 1000, qPrintable(QString::number(compared)));
    }

    // Driven one way and the other: the vehicle's line starts its lead ahead on the curve and goes straight
    // on beyond its end; the implement's middle stays within d² / 2R of the swath.
    void theVehicleFollowsTheCurve() {
        const Curve curve{.type = {},
                          .start = {.position = {0.0, 0.0}, .heading = {}},
                          .pieces = {{.length = metres(50.0), .curvature = {}},
                                     {.length = metres(40.0),
                                      .curvature = Curvature::fromSi(0.05),
                                      .endCurvature = Curvature::fromSi(0.05)},
                                     {.length = metres(50.0), .curvature = {}}}};
        const SwathSet set{.swaths = {{.start = curve.start.position,
                                       .end = curve.end().position,
                                       .number = 1,
                                       .width = metres(2.5),
                                       .curve = curve}}};
        MachineSpec spec = findMachine("agbot")->spec();
        for (const double offsetM : {-2.0, 0.0, 3.0}) {
            for (const double asideM : {0.0, 0.5, -0.5}) {
                spec.implement.offset = metres(offsetM);
                spec.implement.lateralOffset = metres(asideM);
                const auto machine = Machine::create(spec);
                VERIFY_RESULT(machine);
                for (const bool reversed : {false, true}) {
                    const RouteStep step{.swath = 0, .reversed = reversed};
                    const Curve line = drivenLine(step, set, *machine);
                    const Pose start = vehicleAt(startPose(step, set), *machine);
                    const Pose end = vehicleAt(endPose(step, set), *machine);
                    COMPARE_WITHIN(distance(line.start.position, start.position), 0.0, 1e-6);
                    COMPARE_WITHIN(distance(line.end().position, end.position), 0.0, 1e-6);
                    COMPARE_WITHIN(distance(vehicleStart(step, set, *machine).position, line.start.position),
                                   0.0, 1e-9);
                    COMPARE_WITHIN(distance(vehicleEnd(step, set, *machine).position, line.end().position),
                                   0.0, 1e-9);
                    const Polyline middle = middleLine(set.swaths.front(), metres(0.0001));
                    for (const CurveSample& sample : sampled(line, metres(0.001))) {
                        const Point ahead = direction(sample.pose.heading.si());
                        const Point implement =
                            sample.pose.position + offsetM * ahead + asideM * Point{-ahead.y, ahead.x};
                        QVERIFY(toLine(implement, middle) <= 0.5 * offsetM * offsetM * 0.05 * 1.1 + 1e-3);
                    }
                }
            }
        }
    }

    // At an edge of 45 degrees half a width more; the swath goes straight on.
    void endsAreDrawnOut() {
        const MultiPolygon mainland{
            {.outer = {{-500, -100}, {0, -100}, {200, 100}, {-500, 100}}, .holes = {}}};
        const Machine machine = machineOf(6.0, 5.0);
        const Curve curve{.type = {},
                          .start = {.position = {-400.0, 0.0}, .heading = {}},
                          .pieces = {{.length = metres(500.0), .curvature = {}}}};
        SwathSet set{.swaths = {{.start = {-400.0, 0.0},
                                 .end = {100.0, 0.0},
                                 .number = 1,
                                 .width = metres(6.0),
                                 .curve = curve}}};
        const MultiPolygon plenty{test::centredRectangle(3000.0, 3000.0)};
        drawOutEnds(set, mainland, {.working = plenty, .driving = plenty, .turning = {}}, machine);
        COMPARE_WITHIN(set.swaths.front().end.x, 103.0, 1e-6);
        COMPARE_WITHIN(set.swaths.front().start.x, -400.0, 1e-6);
        COMPARE_WITHIN(set.swaths.front().length().si(), 503.0, 1e-6);
        COMPARE_WITHIN(set.totalLength.si(), 503.0, 1e-6);
    }
};

FURROW_TEST(CurvedSwathsTest);
#include "tst_curved_swaths.moc"
