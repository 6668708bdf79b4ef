#include "planner/field/field.h"
#include "tests/planner/field/drawn_fields.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stop_token>

using namespace furrow;
using test::allNotes;
using test::fieldSourceFromLocal;
using test::placeOf;
using test::sourceFromWkt;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

GeoRing circle(std::size_t count, double radiusM) {
    const LocalFrame frame = LocalFrame::centredOn(test::kDrawnAt).value();
    Ring ring;
    for (std::size_t i = 0; i < count; ++i) {
        ring.push_back(radiusM * direction(2.0 * std::numbers::pi * static_cast<double>(i) /
                                           static_cast<double>(count)));
    }
    return frame.toGeo(ring);
}

Obstacle obstacle(const QString& wkt, bool passable, double bufferM) {
    return {.name = "pond",
            .outline = sourceFromWkt(wkt).parts.front(),
            .passable = passable,
            .buffer = metres(bufferM)};
}

}  // namespace

class FieldTest : public QObject {
    Q_OBJECT

private slots:
    void refuses_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<QString>("part");
        QTest::addColumn<QString>("where");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        const QString boundary = QStringLiteral("the boundary");
        QTest::newRow("one point") << "POLYGON((5 6))" << "fewer than 3" << boundary << 5.0 << 6.0;
        QTest::newRow("two points") << "POLYGON((5 6, 90 90))" << "fewer than 3" << boundary << 5.0 << 6.0;
        QTest::newRow("two different points among five")
            << "POLYGON((5 6, 90 90, 5 6, 90 90, 5 6))" << "fewer than 3" << boundary << 5.0 << 6.0;
        QTest::newRow("points within half a millimetre of each other")
            << "POLYGON((5 6, 5.0002 6, 5.0002 6.0002, 5 6))" << "fewer than 3" << boundary << 5.0 << 6.0;
        // Collinear points are spikes upon spikes; what is left are its two ends.
        QTest::newRow("all points on one line")
            << "POLYGON((0 0, 30 30, 90 90, 60 60, 0 0))" << "" << boundary << 0.0 << 0.0;
        QTest::newRow("a triangle thinner than a point")
            << "POLYGON((0 0, 50 0, 100 0.0001, 0 0))" << "" << boundary << 0.0 << 0.0;
        QTest::newRow("bow-tie") << "POLYGON((0 0, 100 100, 100 0, 0 100, 0 0))" << "crosses itself"
                                 << boundary << 50.0 << 50.0;
        QTest::newRow("uneven bow-tie") << "POLYGON((0 0, 150 50, 150 0, 0 100, 0 0))" << "crosses itself"
                                        << boundary << 100.0 << 100.0 / 3.0;
        // A loop that runs round a second time: the inner square is enclosed twice.
        QTest::newRow("loop over itself")
            << "POLYGON((0 0, 100 0, 100 100, 20 100, 20 -30, 60 -30, 60 60, 0 60, 0 0))" << "crosses itself"
            << boundary << kNan << kNan;
        QTest::newRow("second part is a bow-tie")
            << "MULTIPOLYGON(((0 0, 100 0, 100 100, 0 100, 0 0)), ((200 0, 300 100, 300 0, 200 100, 200 0)))"
            << "crosses itself" << boundary << 250.0 << 50.0;
        QTest::newRow("second part has two points")
            << "MULTIPOLYGON(((0 0, 100 0, 100 100, 0 100, 0 0)), ((200 0, 300 100, 200 0)))"
            << "fewer than 3"
            << "part 2" << 200.0 << 0.0;
        QTest::newRow("hole outside the boundary")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (200 20, 200 40, 240 40, 240 20, 200 20))"
            << "hole lies outside" << boundary << kNan << kNan;
        QTest::newRow("hole the same as the boundary")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (0 0, 100 0, 100 100, 0 100, 0 0))"
            << "leave nothing" << boundary << kNan << kNan;
        QTest::newRow("hole larger than the boundary")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (-10 -10, -10 110, 110 110, 110 -10, -10 -10))"
            << "leave nothing" << boundary << kNan << kNan;
        QTest::newRow("hole that crosses itself")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (20 20, 60 80, 60 20, 20 60, 20 20))"
            << "crosses itself" << boundary << kNan << kNan;
        // Its wings cancel out in the signed area.
        QTest::newRow("hole that is an even bow-tie")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (20 20, 60 60, 60 20, 20 60, 20 20))"
            << "crosses itself" << boundary << 40.0 << 40.0;
        // Half a millimetre broad.
        QTest::newRow("nothing but slivers")
            << "MULTIPOLYGON(((0 0, 10 0, 10 0.0005, 0 0)), ((20 0, 30 0, 30 0.0005, 20 0)))" << ""
            << "the boundary" << 0.0 << 0.0;
    }
    void refuses() {
        QFETCH(QString, wkt);
        QFETCH(QString, part);
        QFETCH(QString, where);
        QFETCH(double, x);
        QFETCH(double, y);
        FieldSource source = sourceFromWkt(wkt);
        source.origin = "fields.gpkg, feature 12";
        const auto field = Field::create(source);
        QVERIFY(!field);
        QCOMPARE(field.error().code, ErrorCode::InputRefused);
        const std::string line = field.error().line();
        QVERIFY2(QString::fromStdString(line).contains(part), line.c_str());
        QVERIFY2(QString::fromStdString(field.error().where).contains(where), line.c_str());
        QVERIFY2(field.error().where.starts_with("fields.gpkg, feature 12"), line.c_str());
        QVERIFY2(!field.error().remedy.empty(), line.c_str());
        QVERIFY2(field.error().place.has_value(), line.c_str());
        if (!std::isnan(x)) {
            COMPARE_WITHIN(placeOf(field.error().place).x, x, 0.01);
            COMPARE_WITHIN(placeOf(field.error().place).y, y, 0.01);
        }
    }

    void refusesCoordinates_data() {
        QTest::addColumn<double>("lonDeg");
        QTest::addColumn<double>("latDeg");
        QTest::addColumn<QString>("part");
        QTest::newRow("longitude is not a number") << kNan << 51.3 << "not a number";
        QTest::newRow("latitude is not a number") << 9.2 << kNan << "not a number";
        QTest::newRow("longitude is infinite") << kInfinity << 51.3 << "not a number";
        QTest::newRow("latitude is minus infinite") << 9.2 << -kInfinity << "not a number";
        QTest::newRow("longitude 200") << 200.0 << 51.3 << "200, 51.3 is outside";
        QTest::newRow("latitude -91") << 9.2 << -91.0 << "9.2, -91 is outside";
        QTest::newRow("metres of UTM") << 513'000.0 << 5'683'000.0 << "outside longitude";
        QTest::newRow("a hundred kilometres away") << 9.2 << 52.3 << "100 km";
        QTest::newRow("on the other side of the world") << -170.0 << -51.0 << "100 km";
        QTest::newRow("at the pole") << 0.0 << 90.0 << "100 km";
        QTest::newRow("a quarter of the world away") << 99.2 << 51.3 << "100 km";
    }
    void refusesCoordinates() {
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        QFETCH(QString, part);
        FieldSource source = fieldSourceFromLocal({test::centredRectangle(200.0, 100.0)}, test::kDrawnAt);
        source.origin = "fields.gpkg";
        source.parts.front().outer[2] = {lonDeg, latDeg};
        const auto field = Field::create(source);
        QVERIFY(!field);
        QCOMPARE(field.error().code, ErrorCode::InputRefused);
        const std::string line = field.error().line();
        QVERIFY2(QString::fromStdString(line).contains(part), line.c_str());
        QVERIFY2(!field.error().remedy.empty(), line.c_str());
        // What is out of this world cannot be shown on the map; the message counts the points as people do.
        QVERIFY2(line.find("part 1, point 3") != std::string::npos, line.c_str());
        QCOMPARE(field.error().place.has_value(), part == "100 km");
    }

    void refusesCoordinatesAnywhere() {
        FieldSource hole =
            sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 40 60, 60 60, 60 40, 40 40))");
        hole.parts.front().holes.front()[1].latDeg = kNan;
        const auto inHole = Field::create(hole);
        QVERIFY(!inHole);
        QVERIFY2(inHole.error().where.contains("hole 1, point 2"), inHole.error().line().c_str());

        FieldSource withPond = sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
        withPond.obstacles = {obstacle("POLYGON((40 40, 60 40, 60 60, 40 40))", false, 0.0)};
        withPond.obstacles.front().outline.outer[2].lonDeg = 500.0;
        const auto inObstacle = Field::create(withPond);
        QVERIFY(!inObstacle);
        QVERIFY2(inObstacle.error().where.contains("obstacle 1"), inObstacle.error().line().c_str());

        FieldSource withGate = sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
        withGate.gates = {{.name = "north", .position = {kNan, 51.3}, .width = metres(6.0)}};
        const auto atGate = Field::create(withGate);
        QVERIFY(!atGate);
        QVERIFY2(atGate.error().where.contains("gate 1"), atGate.error().line().c_str());
    }

    void refusesLengthsThatAreNone_data() {
        QTest::addColumn<double>("lengthM");
        QTest::newRow("negative") << -1.0;
        QTest::newRow("not a number") << kNan;
        QTest::newRow("infinite") << kInfinity;
    }
    void refusesLengthsThatAreNone() {
        QFETCH(double, lengthM);
        FieldSource source = sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
        source.boundaryAccuracy = metres(lengthM);
        const auto accuracy = Field::create(source);
        QVERIFY(!accuracy && accuracy.error().code == ErrorCode::InputRefused);
        source.boundaryAccuracy = metres(0.0);
        source.obstacles = {obstacle("POLYGON((40 40, 60 40, 60 60, 40 40))", false, lengthM)};
        const auto buffer = Field::create(source);
        QVERIFY(!buffer && buffer.error().code == ErrorCode::InputRefused);
        source.obstacles.clear();
        source.gates = {
            {.name = "north", .position = source.parts.front().outer.front(), .width = metres(lengthM)}};
        const auto gate = Field::create(source);
        QVERIFY(!gate && gate.error().code == ErrorCode::InputRefused);
    }

    void keepsWhatIsInTheWay_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<double>("m2");
        QTest::newRow("a pole")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (50 50, 50 50.08, 50.08 50.08, 50.08 50, 50 50))"
            << 0.0064;
        // Wings of 0.12 and 0.03 m² that meet at 50.4, 50.2: less than what makes land a sliver.
        QTest::newRow("a stone drawn as a bow-tie")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (50 50, 50.6 50.3, 50.6 50, 50 50.6, 50 50))"
            << 0.15;
    }
    void keepsWhatIsInTheWay() {
        QFETCH(QString, wkt);
        QFETCH(double, m2);
        const auto field = Field::create(sourceFromWkt(wkt));
        VERIFY_RESULT(field);
        const double takenM2 = 100.0 * 100.0 - furrow::area(field->workable()).si();
        QVERIFY2(std::abs(takenM2 - m2) < 0.02 * m2, qPrintable(QString::number(takenM2)));
        FieldSource source = sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
        GeoRing outline = sourceFromWkt(wkt).parts.front().holes.front();
        source.obstacles = {{.name = "pole", .outline = {.outer = std::move(outline), .holes = {}}}};
        const auto withObstacle = Field::create(source);
        VERIFY_RESULT(withObstacle);
        COMPARE_WITHIN(100.0 * 100.0 - furrow::area(withObstacle->workable()).si(), takenM2, 1e-3 * m2);
    }

    void refusesNothingAtAll() {
        const auto none = Field::create({});
        QVERIFY(!none && none.error().code == ErrorCode::InputRefused);
        const auto emptyPart = Field::create({.parts = {GeoPolygon{}}});
        QVERIFY(!emptyPart && emptyPart.error().code == ErrorCode::InputRefused);
        FieldSource second = sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
        second.parts.emplace_back();
        const auto emptySecond = Field::create(second);
        QVERIFY(!emptySecond && emptySecond.error().code == ErrorCode::InputRefused);
    }

    // Larger ones are refused: tst_bad_input.
    void justWithinTheLimits() {
        VERIFY_RESULT(Field::create({.parts = {{.outer = circle(64, 49'900.0), .holes = {}}}}));
        VERIFY_RESULT(Field::create({.parts = {{.outer = circle(1'000'000, 5000.0), .holes = {}}}}));
    }

    void oneErrorIsOneLine() {
        const auto field = Field::create(sourceFromWkt("POLYGON((0 0, 100 100, 100 0, 0 100, 0 0))"));
        QVERIFY(!field);
        QVERIFY(!field.error().line().contains('\n'));
        // The place is in the text too, for those without a map.
        QVERIFY2(field.error().line().contains("9.2"), field.error().line().c_str());
    }

    // They work like any other field.
    void anywhereOnEarth_data() {
        QTest::addColumn<double>("lonDeg");
        QTest::addColumn<double>("latDeg");
        QTest::newRow("across the antimeridian") << 180.0 << -16.5;
        QTest::newRow("across the antimeridian, mostly west") << -179.9995 << 66.0;
        QTest::newRow("80 degrees north") << 15.0 << 80.0;
        QTest::newRow("89.9 degrees north") << 15.0 << 89.9;
        QTest::newRow("80 degrees south") << 15.0 << -80.0;
        QTest::newRow("across the equator and Greenwich") << 0.0 << 0.0;
        QTest::newRow("across a UTM zone border") << 6.0 << 52.0;
    }
    void anywhereOnEarth() {
        QFETCH(double, lonDeg);
        QFETCH(double, latDeg);
        const MultiPolygon drawn = test::polygonsFromWkt(
            "POLYGON((-100 -60, 100 -60, 100 60, -100 60, -100 -60), (-20 -10, -20 10, 20 10, 20 -10, -20 -10))");
        FieldSource source = fieldSourceFromLocal(drawn, {lonDeg, latDeg});
        source.obstacles = {
            {.name = "pond",
             .outline =
                 LocalFrame::centredOn({lonDeg, latDeg})->toGeo(test::rectangle(20.0, 10.0, {50.0, 20.0})),
             .passable = false,
             .buffer = metres(0.0)}};
        const auto field = Field::create(source);
        VERIFY_RESULT(field);
        QVERIFY2(field->repairs().empty(), allNotes(*field).c_str());
        COMPARE_WITHIN(area(field->boundary()).si(), 200.0 * 120.0 - 800.0, 0.01);
        COMPARE_WITHIN(area(field->workable()).si(), 200.0 * 120.0 - 800.0 - 200.0, 0.01);
        COMPARE_WITHIN(field->area().si(), 200.0 * 120.0 - 800.0 - 200.0, 0.01);
        const Bounds box = bounds(field->boundary());
        COMPARE_WITHIN(box.width(), 200.0, 0.02);
        COMPARE_WITHIN(box.height(), 120.0, 0.02);
        QCOMPARE(field->vertexCount(), std::size_t{8});
        QCOMPARE(field->holeCount(), std::size_t{1});
    }

    void obstacles_data() {
        QTest::addColumn<QString>("outline");
        QTest::addColumn<bool>("passable");
        QTest::addColumn<double>("bufferM");
        QTest::addColumn<double>("workableM2");
        QTest::addColumn<double>("drivableM2");
        QTest::addColumn<double>("toleranceM2");
        // In a square of 100 m. A buffer of 5 m around a square of 20 m takes 400 + 4 x 20 x 5 + 25 pi.
        const double withBuffer = 400.0 + 400.0 + 25.0 * std::numbers::pi;
        const QString middle = QStringLiteral("POLYGON((40 40, 60 40, 60 60, 40 60, 40 40))");
        QTest::newRow("may not be driven on") << middle << false << 0.0 << 9600.0 << 9600.0 << 0.01;
        QTest::newRow("may be driven on") << middle << true << 0.0 << 9600.0 << 10'000.0 << 0.01;
        QTest::newRow("with a buffer")
            << middle << false << 5.0 << 10'000.0 - withBuffer << 10'000.0 - withBuffer << 0.5;
        QTest::newRow("passable with a buffer")
            << middle << true << 5.0 << 10'000.0 - withBuffer << 10'000.0 << 0.5;
        QTest::newRow("half outside the field")
            << "POLYGON((90 40, 110 40, 110 60, 90 60, 90 40))" << false << 0.0 << 9800.0 << 9800.0 << 0.01;
        QTest::newRow("drawn clockwise")
            << "POLYGON((40 40, 40 60, 60 60, 60 40, 40 40))" << false << 0.0 << 9600.0 << 9600.0 << 0.01;
        QTest::newRow("right across the field") << "POLYGON((45 -10, 55 -10, 55 110, 45 110, 45 -10))"
                                                << false << 0.0 << 9000.0 << 9000.0 << 0.01;
        // 5 m by 20 m, and of each quarter circle what lies 2 m to 7 m from its centre's line: the integral
        // of sqrt(49 - u²) is 49 pi / 4 - sqrt(45) - 24.5 asin(2/7).
        const double reachesIn =
            100.0 + 2.0 * (12.25 * std::numbers::pi - std::sqrt(45.0) - 24.5 * std::asin(2.0 / 7.0));
        QTest::newRow("outside, but its buffer reaches in")
            << "POLYGON((102 40, 120 40, 120 60, 102 60, 102 40))" << false << 7.0 << 10'000.0 - reachesIn
            << 10'000.0 - reachesIn << 0.5;
    }
    void obstacles() {
        QFETCH(QString, outline);
        QFETCH(bool, passable);
        QFETCH(double, bufferM);
        QFETCH(double, workableM2);
        QFETCH(double, drivableM2);
        QFETCH(double, toleranceM2);
        FieldSource source = sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
        source.obstacles = {obstacle(outline, passable, bufferM)};
        const auto field = Field::create(source);
        VERIFY_RESULT(field);
        COMPARE_WITHIN(area(field->boundary()).si(), 10'000.0, 0.01);
        COMPARE_WITHIN(area(field->workable()).si(), workableM2, toleranceM2);
        COMPARE_WITHIN(area(field->drivable()).si(), drivableM2, toleranceM2);
        COMPARE_WITHIN(field->area().si(), workableM2, toleranceM2);
    }

    void refusesObstacles_data() {
        QTest::addColumn<QString>("outline");
        QTest::addColumn<QString>("part");
        QTest::newRow("outside the field")
            << "POLYGON((200 40, 220 40, 220 60, 200 60, 200 40))" << "outside the field";
        QTest::newRow("a centimetre outside the field")
            << "POLYGON((100.01 40, 120 40, 120 60, 100.01 60, 100.01 40))"
            << "outside the field";
        QTest::newRow("crosses itself") << "POLYGON((20 20, 60 60, 60 20, 20 60, 20 20))" << "crosses itself";
        QTest::newRow("two points") << "POLYGON((20 20, 60 60, 20 20))" << "fewer than 3";
        QTest::newRow("covers the field")
            << "POLYGON((-10 -10, 110 -10, 110 110, -10 110, -10 -10))" << "leave nothing";
    }
    void refusesObstacles() {
        QFETCH(QString, outline);
        QFETCH(QString, part);
        FieldSource source = sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
        source.origin = "farm.kml";
        source.obstacles = {obstacle(outline, false, 0.0)};
        const auto field = Field::create(source);
        QVERIFY(!field);
        QCOMPARE(field.error().code, ErrorCode::InputRefused);
        const std::string line = field.error().line();
        QVERIFY2(QString::fromStdString(line).contains(part), line.c_str());
        QVERIFY2(field.error().where.contains("farm.kml"), line.c_str());
        if (part != "leave nothing") {
            QVERIFY2(field.error().where.contains("pond"), line.c_str());
            QVERIFY2(field.error().place.has_value(), line.c_str());
        }
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const auto field = Field::create(sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))"),
                                         {.stop = stop.get_token()});
        QVERIFY(!field);
        QCOMPARE(field.error().code, ErrorCode::Cancelled);
    }
};

FURROW_TEST(FieldTest);
#include "tst_field.moc"
