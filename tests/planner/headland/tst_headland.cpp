#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/headland/turning_room.h"
#include "planner/machine/machine_library.h"
#include "planner/turns/dubins.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <numbers>
#include <stop_token>

using namespace furrow;
using test::agbot;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr GeoPoint kCentre{9.2, 51.3};

Field fieldFrom(const MultiPolygon& polygons) {
    return Field::create(test::fieldSourceFromLocal(polygons, kCentre)).value();
}

// The paper's robot: operating and vehicle width 2.5 m, turning radius 2.1 m.
Settings settingsWith(const std::optional<double>& widthM, const std::optional<double>& passes) {
    Settings settings;
    if (widthM) {
        settings.set(kHeadlandWidth, *widthM).value();
    }
    if (passes) {
        settings.set(kHeadlandPasses, *passes).value();
    }
    return settings;
}

}  // namespace

class HeadlandTest : public QObject {
    Q_OBJECT

private slots:
    // A boom of 24 m works all of it from a line 12 m from the boundary, 176 m x 20 m with corners of 7 m.
    void onePassAllRoundIsAllThereIs() {
        const Field field = fieldFrom({test::centredRectangle(200.0, 44.0)});
        const auto headland = test::headlandBy(kConstantWidthMethod, field,
                                               findMachine("trailed-sprayer").value(), Settings{}, Length{});
        VERIFY_RESULT(headland);
        QCOMPARE(headland->passes, 1);
        QVERIFY(headland->isPerimeterOnly);
        QVERIFY(headland->narrowed);
        QVERIFY(headland->mainland.empty());
        QCOMPARE(headland->mainlandRatio, 0.0);
        QCOMPARE(headland->drivenPasses.size(), std::size_t{1});
        const double byHandM = 2.0 * (176.0 + 20.0) - 8.0 * 7.0 + 2.0 * kPi * 7.0;
        COMPARE_WITHIN(headland->drivenPasses.front().length().si(), byHandM, 0.02 * byHandM);
    }

    // Nothing is worked by a strip that is only for turning.
    void aStripForTurningIsNotAllThereIs() {
        const Field field = fieldFrom({test::centredRectangle(200.0, 44.0)});
        Settings settings;
        settings.set(kHeadlandDriven, false).value();
        const auto headland = test::headlandBy(kConstantWidthMethod, field,
                                               findMachine("trailed-sprayer").value(), settings, Length{});
        VERIFY_RESULT(headland);
        QCOMPARE(headland->passes, 0);
        QVERIFY(!headland->isPerimeterOnly);
        COMPARE_WITHIN(area(headland->mainland).si(), 200.0 * 44.0, 0.01);
    }

    void ofARectangle_data() {
        QTest::addColumn<double>("fieldWidthM");
        QTest::addColumn<double>("fieldHeightM");
        QTest::addColumn<double>("givenWidthM");  // negative: auto
        QTest::addColumn<double>("givenPasses");
        QTest::addColumn<double>("marginM");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<int>("passes");
        QTest::addColumn<double>("mainlandM2");
        QTest::addColumn<QString>("note");
        const double automatic = -1.0;
        QTest::newRow("width of the paper")
            << 100.0 << 60.0 << 7.5 << automatic << 0.0 << 7.5 << 3 << 85.0 * 45.0 << "";
        QTest::newRow("width that is no whole number of passes")
            << 100.0 << 60.0 << 9.9 << automatic << 0.0 << 7.5 << 3 << 85.0 * 45.0 << "9.9 m holds 3 passes";
        QTest::newRow("width less than a pass")
            << 100.0 << 60.0 << 2.0 << automatic << 0.0 << 2.0 << 0 << 96.0 * 56.0 << "";
        QTest::newRow("width of nothing")
            << 100.0 << 60.0 << 0.0 << automatic << 0.0 << 0.0 << 0 << 6000.0 << "";
        QTest::newRow("two passes") << 100.0 << 60.0 << automatic << 2.0 << 0.0 << 5.0 << 2 << 90.0 * 50.0
                                    << "";
        QTest::newRow("no passes") << 100.0 << 60.0 << automatic << 0.0 << 0.0 << 0.0 << 0 << 6000.0 << "";
        QTest::newRow("auto makes room for the turns")
            << 100.0 << 60.0 << automatic << automatic << 0.0 << 10.0 << 4 << 80.0 * 40.0 << "";
        QTest::newRow("margin comes on top of passes")
            << 100.0 << 60.0 << automatic << 2.0 << 0.5 << 5.5 << 2 << 89.0 * 49.0 << "";
        QTest::newRow("margin comes on top of auto")
            << 100.0 << 60.0 << automatic << automatic << 0.5 << 10.5 << 4 << 79.0 * 39.0 << "";
        QTest::newRow("margin is within a width")
            << 100.0 << 60.0 << 7.5 << automatic << 0.5 << 5.5 << 2 << 89.0 * 49.0 << "7.5 m holds 2 passes";
        QTest::newRow("margin wider than the width")
            << 100.0 << 60.0 << 1.0 << automatic << 3.0 << 3.0 << 0 << 94.0 * 54.0 << "";
        QTest::newRow("narrow field has one pass less") << 100.0 << 16.0 << automatic << automatic << 0.0
                                                        << 5.0 << 2 << 90.0 * 6.0 << "too narrow for 10.0 m";
        QTest::newRow("narrower field has one pass") << 100.0 << 9.0 << automatic << automatic << 0.0 << 2.5
                                                     << 1 << 95.0 * 4.0 << "too narrow for 10.0 m";
        QTest::newRow("inside one pass no swath is as wide as the robot")
            << 100.0 << 7.0 << automatic << automatic << 0.0 << 2.5 << 1 << 95.0 * 2.0
            << "too narrow for 10.0 m";
        QTest::newRow("very narrow field is all headland")
            << 100.0 << 6.0 << automatic << automatic << 0.0 << 2.5 << 1 << 95.0 << "too narrow for 10.0 m";
        QTest::newRow("field of one pass has none")
            << 100.0 << 2.5 << automatic << automatic << 0.0 << 0.0 << 0 << 250.0 << "there is none";
        QTest::newRow("given width falls back too")
            << 100.0 << 16.0 << 7.5 << automatic << 0.0 << 5.0 << 2 << 90.0 * 6.0 << "too narrow for 7.5 m";
        QTest::newRow("given passes fall back too")
            << 100.0 << 16.0 << automatic << 6.0 << 0.0 << 5.0 << 2 << 90.0 * 6.0 << "too narrow for 15.0 m";
        QTest::newRow("exactly one operating width is left")
            << 100.0 << 22.5 << automatic << automatic << 0.0 << 10.0 << 4 << 80.0 * 2.5 << "";
    }
    void ofARectangle() {
        QFETCH(double, fieldWidthM);
        QFETCH(double, fieldHeightM);
        QFETCH(double, givenWidthM);
        QFETCH(double, givenPasses);
        QFETCH(double, marginM);
        QFETCH(double, widthM);
        QFETCH(int, passes);
        QFETCH(double, mainlandM2);
        QFETCH(QString, note);
        const Field field = fieldFrom({test::centredRectangle(fieldWidthM, fieldHeightM)});
        const Settings settings =
            settingsWith(givenWidthM >= 0.0 ? std::optional{givenWidthM} : std::nullopt,
                         givenPasses >= 0.0 ? std::optional{givenPasses} : std::nullopt);
        const auto headland =
            test::headlandBy(kConstantWidthMethod, field, agbot(), settings, metres(marginM));
        VERIFY_RESULT(headland);
        COMPARE_WITHIN(headland->width.si(), widthM, 1e-12);
        QCOMPARE(headland->passes, passes);
        COMPARE_WITHIN(area(headland->mainland).si(), mainlandM2, 0.01);
        COMPARE_WITHIN(headland->mainlandRatio, mainlandM2 / (fieldWidthM * fieldHeightM), 1e-5);
        QCOMPARE(headland->notes.empty(), note.isEmpty());
        if (!note.isEmpty()) {
            QVERIFY2(QString::fromStdString(headland->notes.front().text).contains(note),
                     headland->notes.front().text.c_str());
        }
    }

    /// 12 m along the lower side of 100 by 60 m, 5 m along the others.
    void widthsBesideEdges() {
        Headland headland{.width = metres(12.0)};
        QCOMPARE(widthBeside(headland, {50.0, 60.0}).si(), 12.0);
        QCOMPARE(narrowestWidth(headland).si(), 12.0);
        const Ring ring = test::rectangle(100.0, 60.0).outer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            headland.strips.push_back(
                {.from = ring[i], .to = ring[(i + 1) % ring.size()], .width = metres(i == 0 ? 12.0 : 5.0)});
        }
        QCOMPARE(widthBeside(headland, {50.0, 1.0}).si(), 12.0);
        QCOMPARE(widthBeside(headland, {50.0, 58.0}).si(), 5.0);
        QCOMPARE(widthBeside(headland, {1.0, 20.0}).si(), 5.0);
        QCOMPARE(narrowestWidth(headland).si(), 5.0);
    }

    void holesGetARing() {
        const Field field = fieldFrom(test::polygonsFromWkt(
            "POLYGON((-50 -50, 50 -50, 50 50, -50 50, -50 -50), (-10 -10, -10 10, 10 10, 10 -10, -10 -10))"));
        const auto headland =
            test::headlandBy(kConstantWidthMethod, field, agbot(), settingsWith(7.5, {}), {});
        VERIFY_RESULT(headland);
        // The square less the hole with strips of 7.5 m along its sides and a quarter circle at each corner.
        const double expectedM2 = 85.0 * 85.0 - (400.0 + 80.0 * 7.5 + kPi * 7.5 * 7.5);
        COMPARE_WITHIN(area(headland->mainland).si(), expectedM2, 1.0);
        QCOMPARE(headland->mainland.size(), std::size_t{1});
        QCOMPARE(headland->mainland.front().holes.size(), std::size_t{1});
        COMPARE_WITHIN(headland->mainlandRatio, expectedM2 / 9600.0, 1e-4);
    }

    void obstaclesGetARing() {
        FieldSource source = test::fieldSourceFromLocal({test::centredRectangle(100.0, 100.0)}, kCentre);
        source.obstacles = {
            {.name = "wet spot",
             .outline = LocalFrame::centredOn(kCentre)->toGeo(test::centredRectangle(20.0, 20.0)),
             .passable = true,
             .buffer = metres(0.0)}};
        const auto headland = test::headlandBy(kConstantWidthMethod, Field::create(source).value(), agbot(),
                                               settingsWith(5.0, {}), {});
        VERIFY_RESULT(headland);
        COMPARE_WITHIN(area(headland->mainland).si(), 90.0 * 90.0 - (400.0 + 80.0 * 5.0 + kPi * 25.0), 1.0);
    }

    void everyPartHasItsOwn() {
        const Field field = fieldFrom(
            {test::rectangle(60.0, 60.0, {-100.0, -30.0}), test::rectangle(40.0, 40.0, {0.0, -20.0})});
        const auto headland =
            test::headlandBy(kConstantWidthMethod, field, agbot(), settingsWith(5.0, {}), {});
        VERIFY_RESULT(headland);
        QCOMPARE(headland->mainland.size(), std::size_t{2});
        COMPARE_WITHIN(area(headland->mainland).si(), 2500.0 + 900.0, 0.02);
    }

    void bothWidthAndPassesAreRefused() {
        const Field field = fieldFrom({test::centredRectangle(100.0, 60.0)});
        const auto headland =
            test::headlandBy(kConstantWidthMethod, field, agbot(), settingsWith(7.5, 2.0), {});
        QVERIFY(!headland);
        QCOMPARE(headland.error().code, ErrorCode::Usage);
        QVERIFY(headland.error().line().contains("headland.width_m"));
        QVERIFY(headland.error().line().contains("headland.passes"));
    }

    void noneKeepsTheMargin_data() {
        QTest::addColumn<double>("marginM");
        QTest::addColumn<double>("mainlandM2");
        QTest::newRow("without margin") << 0.0 << 6000.0;
        QTest::newRow("with a margin") << 1.0 << 98.0 * 58.0;
    }
    void noneKeepsTheMargin() {
        QFETCH(double, marginM);
        QFETCH(double, mainlandM2);
        const Field field = fieldFrom({test::centredRectangle(100.0, 60.0)});
        const auto headland = test::headlandBy(kNoHeadlandMethod, field, agbot(), {}, metres(marginM));
        VERIFY_RESULT(headland);
        QCOMPARE(headland->passes, 0);
        COMPARE_WITHIN(headland->width.si(), marginM, 1e-12);
        COMPARE_WITHIN(area(headland->mainland).si(), mainlandM2, 0.01);
        COMPARE_WITHIN(headland->mainlandRatio, mainlandM2 / 6000.0, 1e-5);
        QVERIFY(headland->notes.empty());
    }

    // "A headland whose mainland is not empty. InputRefused: nothing of the field is left."
    void aMarginThatLeavesNothingIsRefused() {
        const Field field = fieldFrom({test::centredRectangle(100.0, 60.0)});
        for (const auto* method : {&kConstantWidthMethod, &kNoHeadlandMethod}) {
            const auto headland = test::headlandBy(*method, field, agbot(), {}, metres(31.0));
            QVERIFY(!headland);
            QCOMPARE(headland.error().code, ErrorCode::InputRefused);
            QVERIFY2(headland.error().where.contains("margin"), headland.error().line().c_str());
        }
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const Field field = fieldFrom({test::centredRectangle(100.0, 60.0)});
        for (const auto* method : {&kConstantWidthMethod, &kNoHeadlandMethod}) {
            const auto headland =
                test::headlandBy(*method, field, agbot(), {}, metres(1.0), true, {.stop = stop.get_token()});
            QVERIFY(!headland);
            QCOMPARE(headland.error().code, ErrorCode::Cancelled);
        }
    }

    // A U turn over two radii, seen by hand: a point at the turn's top is R ahead, and the footprint's outer
    // front corner passes at sqrt((R + half a width)² + front²) from the circle's centre.
    void roomForAUTurnByHand() {
        const double r = 3.0;
        MachineSpec spec;
        spec.tractor.width = metres(2.0);
        spec.tractor.length = metres(4.0);
        spec.tractor.rearOverhang = metres(1.0);
        spec.tractor.minTurningRadius = metres(r);
        spec.implement.operatingWidth = metres(2.0 * r);
        spec.implement.raisedWidth = metres(2.0);
        spec.implement.offset = metres(0.0);
        spec.implement.length = metres(1.0);
        const Machine machine = Machine::create(spec).value();
        // Straight edge: the half circle alone. Slanted edges need at least as much.
        const double byHandM = std::hypot(r + 1.0, 3.0);
        QVERIFY(roomForTurns(machine, kDubinsMethod.run, false).si() >= byHandM - 0.01);
        QVERIFY(roomForTurns(machine, kDubinsMethod.run, false).si() <= byHandM + 2.0 * r);
    }

    // The paper's 7.5 m where swaths end on their centre lines; one pass more where they are drawn out.
    void drawnOutEndsNeedMoreRoom() {
        const Field field = fieldFrom({test::centredRectangle(100.0, 60.0)});
        for (const auto& [drawsOutEnds, widthM] : {std::pair{false, 7.5}, {true, 10.0}}) {
            const auto headland =
                test::headlandBy(kConstantWidthMethod, field, agbot(), {}, {}, drawsOutEnds);
            VERIFY_RESULT(headland);
            COMPARE_WITHIN(headland->width.si(), widthM, 1e-12);
        }
    }
};

FURROW_TEST(HeadlandTest);
#include "tst_headland.moc"
