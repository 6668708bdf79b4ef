#include "planner/field/drivable_area.h"
#include "planner/machine/machine_library.h"
#include "planner/path/drivable_check.h"
#include "planner/path/path_builder.h"
#include "planner/turns/dubins.h"
#include "planner/turns/straight_turn.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <cmath>
#include <stop_token>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

/// 2 m wide, 1 m ahead of and behind its reference point, 2 m turning radius: its outline fits in a circle.
Machine smallMachine() {
    MachineSpec spec = findMachine("agbot")->spec();
    spec.tractor.width = metres(2.0);
    spec.tractor.length = metres(2.0);
    spec.tractor.rearOverhang = metres(1.0);
    spec.tractor.minTurningRadius = metres(2.0);
    spec.implement.operatingWidth = metres(4.0);
    spec.implement.raisedWidth = metres(2.0);
    spec.implement.offset = metres(0.0);
    spec.implement.length = metres(1.0);
    return Machine::create(spec).value();
}

/// Two swaths to the north, 4 m apart, from y = -10 to y = 10, and the U turn between them at the top: a
/// half circle of 2 m around (0, 10). Its footprint's outer corners lie at most hypot(3, 1) m from there.
Path uTurn(TurnPlanner* turn) {
    SwathSet swaths;
    swaths.heading = degrees(90.0);
    swaths.swaths = {{.start = {2, -10}, .end = {2, 10}, .number = 1, .track = 0, .width = metres(4.0)},
                     {.start = {-2, -10}, .end = {-2, 10}, .number = 2, .track = 1, .width = metres(4.0)}};
    const Route route{.steps = {{.swath = 0, .reversed = false}, {.swath = 1, .reversed = true}},
                      .lengthInPlace = {}};
    return test::pathOf(swaths, route, smallMachine(), turn, {}).value();
}

// The field is 40 m wide and reaches as far below the origin as above; its frame's centre is the origin.
Field fieldWith(double topM, const MultiPolygon& holes = {}) {
    Polygon land = test::centredRectangle(40.0, 2.0 * topM);
    for (const Polygon& hole : holes) {
        land.holes.push_back(hole.outer);
    }
    return Field::create(test::fieldSourceFromLocal({land}, kCentre)).value();
}

Result<std::vector<BlockedConnection>> blockedOn(const Path& path, const Field& field, Length margin,
                                                 const JobContext& job) {
    return drivableArea(field, margin, job).and_then([&](const MultiPolygon& drivable) {
        return blockedConnections(path, drivable, smallMachine(), job);
    });
}

}  // namespace

class DrivableCheckTest : public QObject {
    Q_OBJECT

private slots:
    void uTurns_data() {
        QTest::addColumn<double>("topM");
        QTest::addColumn<double>("marginM");
        QTest::addColumn<bool>("blocked");
        QTest::addColumn<double>("outsideM");
        // The footprint's corners swing to 10 + hypot(3, 1) = 13.162 m.
        const double reachM = 10.0 + std::hypot(3.0, 1.0);
        QTest::newRow("plenty of room") << 20.0 << 0.0 << false << 0.0;
        QTest::newRow("a centimetre of room") << reachM + 0.01 << 0.0 << false << 0.0;
        // Half a centimetre is drawing.
        QTest::newRow("two centimetres short") << reachM - 0.02 << 0.0 << true << 0.02;
        QTest::newRow("half a metre short") << reachM - 0.5 << 0.0 << true << 0.5;
        QTest::newRow("no headland at all") << 10.0 << 0.0 << true << reachM - 10.0;
        QTest::newRow("margin takes the room") << reachM + 0.5 << 1.0 << true << 0.5;
        QTest::newRow("margin leaves room") << reachM + 0.5 << 0.45 << false << 0.0;
    }
    void uTurns() {
        QFETCH(double, topM);
        QFETCH(double, marginM);
        QFETCH(bool, blocked);
        QFETCH(double, outsideM);
        const auto found = blockedOn(uTurn(kDubinsMethod.run), fieldWith(topM), metres(marginM), {});
        VERIFY_RESULT(found);
        QCOMPARE(!found->empty(), blocked);
        if (blocked) {
            QCOMPARE(found->size(), std::size_t{1});
            QCOMPARE(found->front().segment, std::size_t{1});
            QVERIFY(!found->front().obstacle);
            // Samples stand 5 mm off the arc at most, a corner's swing not much more.
            COMPARE_WITHIN(found->front().outside.si(), outsideM, 0.02);
            COMPARE_WITHIN(found->front().place.y, topM - marginM + outsideM, 0.02);
        }
    }

    // A hole of 1 m in the way of the half circle, none of it outside the field.
    void holesBlock_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<bool>("blocked");
        QTest::newRow("on the curve") << -0.5 << 11.5 << true;
        QTest::newRow("under the middle of the curve, wholly within the footprint's sweep")
            << 1.6 << 11.0 << true;
        QTest::newRow("beyond the curve") << -0.5 << 14.0 << false;
        QTest::newRow("beside the curve") << 6.0 << 11.0 << false;
    }
    void holesBlock() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(bool, blocked);
        Polygon hole = test::rectangle(1.0, 1.0, {x, y});
        std::ranges::reverse(hole.outer);
        const auto found = blockedOn(uTurn(kDubinsMethod.run), fieldWith(30.0, {hole}), {}, {});
        VERIFY_RESULT(found);
        QCOMPARE(!found->empty(), blocked);
        if (blocked) {
            QVERIFY(found->front().obstacle);
            QVERIFY(found->front().outside > metres(0.0));
            const Point place = found->front().place;
            QVERIFY(place.x >= x - 0.01 && place.x <= x + 1.01 && place.y >= y - 0.01 && place.y <= y + 1.01);
        }
    }

    void obstaclesBlockUnlessPassable_data() {
        QTest::addColumn<bool>("passable");
        QTest::addColumn<bool>("blocked");
        QTest::newRow("may not be driven on") << false << true;
        QTest::newRow("may be driven on") << true << false;
    }
    void obstaclesBlockUnlessPassable() {
        QFETCH(bool, passable);
        QFETCH(bool, blocked);
        FieldSource source = test::fieldSourceFromLocal({test::centredRectangle(40.0, 60.0)}, kCentre);
        source.obstacles = {
            {.name = "wet spot",
             .outline = LocalFrame::centredOn(kCentre)->toGeo(test::rectangle(1.0, 1.0, {-0.5, 11.5})),
             .passable = passable,
             .buffer = {}}};
        const auto found = blockedOn(uTurn(kDubinsMethod.run), Field::create(source).value(), {}, {});
        VERIFY_RESULT(found);
        QCOMPARE(!found->empty(), blocked);
    }

    // The turn needs the strip from y = 10 to 13.2 between x = -3.2 and 3.2.
    void gatesAreOpen_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<bool>("blocked");
        QTest::newRow("wide gate where the turn is") << 0.0 << 8.0 << false;
        QTest::newRow("narrow gate where the turn is") << 0.0 << 3.0 << true;
        QTest::newRow("wide gate elsewhere") << 12.0 << 8.0 << true;
    }
    void gatesAreOpen() {
        QFETCH(double, x);
        QFETCH(double, widthM);
        QFETCH(bool, blocked);
        FieldSource source = test::fieldSourceFromLocal({test::centredRectangle(40.0, 20.0)}, kCentre);
        source.gates = {{.name = "north",
                         .position = LocalFrame::centredOn(kCentre)->toGeo(Point{x, 10.0}),
                         .width = metres(widthM)}};
        const auto found = blockedOn(uTurn(kDubinsMethod.run), Field::create(source).value(), {}, {});
        VERIFY_RESULT(found);
        QCOMPARE(!found->empty(), blocked);
    }

    void swathsThemselvesAreNotJudged() {
        SwathSet swaths;
        swaths.heading = degrees(0.0);
        swaths.swaths = {
            {.start = {-500, 0}, .end = {500, 0}, .number = 1, .track = 0, .width = metres(4.0)}};
        const Route route{.steps = {{.swath = 0, .reversed = false}}, .lengthInPlace = {}};
        const Path path = test::pathOf(swaths, route, smallMachine(), kDubinsMethod.run, {}).value();
        const auto found = blockedOn(path, fieldWith(20.0), {}, {});
        VERIFY_RESULT(found);
        QVERIFY(found->empty());
    }

    void threadsAgree() {
        const Field field = fieldWith(12.0);
        const auto one = blockedOn(uTurn(kDubinsMethod.run), field, {}, {.threads = 1});
        const auto many = blockedOn(uTurn(kDubinsMethod.run), field, {}, {.threads = 8});
        VERIFY_RESULT(one);
        VERIFY_RESULT(many);
        QCOMPARE(one->size(), many->size());
        QVERIFY(one->front().place == many->front().place && one->front().outside == many->front().outside);
    }

    // What was tested before is not tested again, and told of the segment that it is now.
    void testsAreRemembered() {
        const Field field = fieldWith(12.0);
        const auto drivable = drivableArea(field, {}, {});
        VERIFY_RESULT(drivable);
        WayChecks checks{*drivable, smallMachine()};
        const Path path = uTurn(kDubinsMethod.run);
        Path longer = path;
        longer.segments.insert(longer.segments.begin(), path.segments.front());
        for (const Path& each : {path, path, longer}) {
            const auto afresh = blockedConnections(each, *drivable, smallMachine(), {});
            const auto found = checks.blocked(each, {});
            VERIFY_RESULT(afresh);
            VERIFY_RESULT(found);
            QCOMPARE(found->size(), std::size_t{1});
            QCOMPARE(found->front().segment, afresh->front().segment);
            QCOMPARE(found->front().segment, each.segments.size() - 2);
            QVERIFY(found->front().place == afresh->front().place &&
                    found->front().outside == afresh->front().outside);
        }
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const auto found =
            blockedOn(uTurn(kDubinsMethod.run), fieldWith(20.0), {}, {.stop = stop.get_token()});
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::Cancelled);
    }
};

FURROW_TEST(DrivableCheckTest);
#include "tst_drivable_check.moc"
