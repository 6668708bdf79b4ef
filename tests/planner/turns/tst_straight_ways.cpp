// Ways of a machine that turns on the spot, round obstacles. Lengths by hand, and by a graph of our own over
// the obstacles' own corners, whose edges GEOS tests.

#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/straight_turn.h"
#include "planner/turns/straight_ways.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/field_generator.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stop_token>
#include <vector>

using namespace furrow;

namespace {

/// A square one, driven in its middle.
MachineSpec specOf(double sizeM) {
    MachineSpec spec;
    spec.tractor.width = metres(sizeM);
    spec.tractor.length = metres(sizeM);
    spec.tractor.rearOverhang = metres(0.5 * sizeM);
    spec.tractor.wheelbase = metres(0.5 * sizeM);
    spec.tractor.minTurningRadius = metres(2.0);
    spec.tractor.canTurnInPlace = true;
    spec.tractor.turningSpeed = metresPerSecond(2.0);
    spec.tractor.maxAcceleration = Acceleration::fromSi(1.0);
    spec.implement.operatingWidth = metres(sizeM);
    spec.implement.offset = metres(0.0);
    spec.implement.length = metres(0.1 * sizeM);
    return spec;
}

Machine robot(double sizeM) {
    return Machine::create(specOf(sizeM)).value();
}

/// 100 m square with a block from (40, 40) to (60, 60).
MultiPolygon withBlock() {
    MultiPolygon inside{test::rectangle(100.0, 100.0)};
    inside.front().holes.push_back({{40, 40}, {40, 60}, {60, 60}, {60, 40}});
    return inside;
}

int turnsIn(const Curve& way) {
    return static_cast<int>(std::ranges::count_if(
        way.pieces, [](const CurvePiece& piece) { return piece.onTheSpot != Angle{}; }));
}

/// The shortest way of a point between two places: all corners of all holes, joined where GEOS says that the
/// line lies inside (Dijkstra without a queue).
double shortestM(const MultiPolygon& inside, Point from, Point to) {
    std::vector<Point> places{from, to};
    for (const Ring& hole : inside.front().holes) {
        places.insert(places.end(), hole.begin(), hole.end());
    }
    const PreparedArea area{dilated(inside, metres(1e-6), metres(1e-7), {}).value()};
    std::vector<double> farM(places.size(), std::numeric_limits<double>::infinity());
    std::vector<char> done(places.size(), 0);
    farM[0] = 0.0;
    for (std::size_t round = 0; round < places.size(); ++round) {
        std::size_t nearest = places.size();
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (done[i] == 0 && (nearest == places.size() || farM[i] < farM[nearest])) {
                nearest = i;
            }
        }
        done[nearest] = 1;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double way = farM[nearest] + distance(places[nearest], places[i]);
            if (way < farM[i] && area.covers({{places[nearest], places[i]}})) {
                farM[i] = way;
            }
        }
    }
    return farM[1];
}

class StraightWaysTest : public QObject {
    Q_OBJECT
private slots:
    // From (30, 50) over the corners (40, 60) and (60, 60) to (70, 50): 2 * sqrt(200) + 20 m for a point. The
    // machine's corner goes round at 0.1 * sqrt(0.5) m, which adds less than 0.2 m.
    void roundABlock() {
        const Machine machine = robot(0.1);
        const MultiPolygon inside = withBlock();
        const Rig rig{inside, machine};
        const StraightWays ways{inside, rig, {}};
        const Pose from = test::pose(30.0, 50.0, 0.0);
        const Pose to = test::pose(70.0, 50.0, 0.0);
        const auto way = ways.between(from, to, {}, {});
        QVERIFY(way);
        const double pointM = 2.0 * std::sqrt(200.0) + 20.0;
        QVERIFY(way->length().si() > pointM && way->length().si() < pointM + 0.2);
        QVERIFY(turnsIn(*way) >= 2);
        QVERIFY(rig.driven(Rig::inLine(from), *way));
        QVERIFY(distance(way->start.position, from.position) < 1e-9);
        QVERIFY(distance(way->end().position, to.position) < 1e-6);
        // It is what the machine takes, where no single turn gets past the block.
        const auto taken = fittingConnection(rig, from, to, {}, {}, SearchEffort::None, &ways);
        QVERIFY(taken == way);
        QVERIFY(!fittingConnection(rig, from, to, {}, {}, SearchEffort::None));
    }

    void nothingInTheWay() {
        const Machine machine = robot(0.1);
        const MultiPolygon inside = withBlock();
        const Rig rig{inside, machine};
        const StraightWays ways{inside, rig, {}};
        const auto way = ways.between(test::pose(10.0, 10.0, 90.0), test::pose(90.0, 10.0, 90.0), {}, {});
        QVERIFY(way);
        QCOMPARE(way->pieces.size(), std::size_t{1});
        COMPARE_WITHIN(way->length().si(), 80.0, 1e-9);
    }

    // The gap of 3 m between block and edge lets a machine of 2 m pass, which turns within 2.83 m, and none
    // of 4 m.
    void throughAGap_data() {
        QTest::addColumn<double>("sizeM");
        QTest::addColumn<bool>("passes");
        QTest::newRow("narrower than the gap") << 2.0 << true;
        QTest::newRow("wider than the gap") << 4.0 << false;
    }
    void throughAGap() {
        QFETCH(double, sizeM);
        QFETCH(bool, passes);
        const Machine machine = robot(sizeM);
        MultiPolygon inside{test::rectangle(100.0, 40.0)};
        inside.front().holes.push_back({{40, 0.01}, {40, 37}, {60, 37}, {60, 0.01}});
        const Rig rig{inside, machine};
        const StraightWays ways{inside, rig, {}};
        const auto way = ways.between(test::pose(20.0, 10.0, 0.0), test::pose(80.0, 10.0, 0.0), {}, {});
        QCOMPARE(way.has_value(), passes);
        QVERIFY(!way || rig.driven(Rig::inLine(way->start), *way));
    }

    void noWayBetweenPartsNorForOthers() {
        MultiPolygon inside{test::rectangle(40.0, 40.0), test::rectangle(40.0, 40.0, {60.0, 0.0})};
        const Machine machine = robot(1.0);
        const Rig rig{inside, machine};
        const StraightWays ways{inside, rig, {}};
        QVERIFY(!ways.between(test::pose(20, 20, 0), test::pose(80, 20, 0), {}, {}));
        MachineSpec spec = specOf(1.0);
        spec.tractor.canTurnInPlace = false;
        const Machine other = Machine::create(spec).value();
        const Rig otherRig{inside, other};
        QVERIFY(
            !StraightWays(inside, otherRig, {}).between(test::pose(5, 20, 0), test::pose(35, 20, 0), {}, {}));
    }

    // A turn in the middle takes its time, and so does stopping for it: 2 m/s and 1 m/s² cost 2 s.
    void theTimeOfATurnInTheMiddle() {
        const Machine machine = robot(1.0);
        Curve way{.type = kCombinedTurn,
                  .start = test::pose(0, 0, 0),
                  .pieces = {{.length = metres(10.0), .curvature = {}},
                             {.length = {}, .curvature = {}, .onTheSpot = degrees(90.0)},
                             {.length = metres(20.0), .curvature = {}}}};
        // The outer wheel at 0.5 m from the middle drives pi / 4 m from standing to standing.
        COMPARE_WITHIN(roughDuration(way, machine).si(), 15.0 + 2.0 + 2.0 * std::sqrt(M_PI / 4.0), 1e-9);
        QVERIFY(distance(way.end().position, {10.0, 20.0}) < 1e-9);
        QVERIFY(test::headingGap(way.end(), test::pose(0, 0, 90)) < 1e-12);
    }

    // Half a circle of 1 m is driven at sqrt(2 m/s² * 1 m), the straight before it at the turning speed of 2
    // m/s.
    void straightsAtTheirOwnSpeed() {
        MachineSpec spec = specOf(1.0);
        spec.tractor.minTurningRadius = metres(1.0);
        spec.tractor.maxLateralAcceleration = Acceleration::fromSi(2.0);
        const Curvature bend = Curvature::fromSi(1.0);
        const Curve way{.type = "dubins",
                        .start = test::pose(0, 0, 0),
                        .pieces = {{.length = metres(10.0), .curvature = {}},
                                   {.length = metres(M_PI), .curvature = bend, .endCurvature = bend}}};
        COMPARE_WITHIN(roughDuration(way, Machine::create(spec).value()).si(), 5.0 + M_PI / std::sqrt(2.0),
                       1e-9);
    }

    // 8 radii of 2 m and 4 widths of 1 m are 20 m.
    void longStraightsAreTransfers() {
        const Machine machine = robot(1.0);
        const auto isTransfer = [&](double lengthM) {
            return isDrivenAsTransfer(straightTurn(test::pose(0, 0, 0), test::pose(0, lengthM, 0)), machine);
        };
        QVERIFY(!isTransfer(19.9));
        QVERIFY(isTransfer(20.1));
    }

    // 400 poles of 1 m, and 900: each keeps its corners however coarse they are drawn.
    void amongManyPoles_data() {
        QTest::addColumn<int>("across");
        QTest::addColumn<bool>("hasCorners");
        QTest::newRow("400 poles") << 20 << true;
        QTest::newRow("too many to look at") << 30 << false;
    }
    void amongManyPoles() {
        QFETCH(int, across);
        QFETCH(bool, hasCorners);
        const Machine machine = robot(0.5);
        const double sideM = 5.0 * across;
        MultiPolygon inside{test::rectangle(sideM, sideM)};
        for (int x = 0; x < across; ++x) {
            for (int y = 0; y < across; ++y) {
                const Polygon pole = test::rectangle(1.0, 1.0, {2.0 + 5.0 * x, 2.0 + 5.0 * y});
                inside.front().holes.emplace_back(pole.outer.rbegin(), pole.outer.rend());
            }
        }
        const Rig rig{inside, machine};
        const StraightWays ways{inside, rig, {}};
        QCOMPARE(!ways.corners().empty(), hasCorners);
        const auto way = ways.between(test::pose(1, 2.5, 0), test::pose(19, 2.5, 0), {}, {});
        QCOMPARE(way.has_value(), hasCorners);
        QVERIFY(!way || (way->length().si() > 18.0 && way->length().si() < 22.0));
    }

    // Beside an edge a machine of 1 m by 1 m with its middle 0.55 m from it cannot turn, so it gets there
    // only along the edge: from a corner of a pole, or straight from the start.
    void besideAnEdge_data() {
        QTest::addColumn<Pose>("to");
        QTest::addColumn<bool>("hasWay");
        QTest::newRow("along the edge") << test::pose(40.0, 0.55, 0.0) << true;
        QTest::newRow("across it") << test::pose(40.0, 0.55, 45.0) << false;
        QTest::newRow("across it, farther off") << test::pose(40.0, 0.75, 45.0) << true;
    }
    void besideAnEdge() {
        QFETCH(Pose, to);
        QFETCH(bool, hasWay);
        const Machine machine = robot(1.0);
        MultiPolygon inside{test::rectangle(60.0, 60.0)};
        for (double x = 5.0; x < 50.0; x += 5.0) {
            for (double y = 5.0; y < 50.0; y += 5.0) {
                const Polygon pole = test::rectangle(1.0, 1.0, {x, y});
                inside.front().holes.emplace_back(pole.outer.rbegin(), pole.outer.rend());
            }
        }
        const Rig rig{inside, machine};
        const StraightWays ways{inside, rig, {}};
        const auto way = ways.between(test::pose(3.0, 0.55, 0.0), to, {}, {});
        QCOMPARE(way.has_value(), hasWay);
        QVERIFY(!way || rig.driven(Rig::inLine(way->start), *way));
    }

    void stopsWhenAsked() {
        const Machine machine = robot(0.1);
        const MultiPolygon inside = withBlock();
        const Rig rig{inside, machine};
        std::stop_source stop;
        stop.request_stop();
        const StraightWays ways{inside, rig, {}};
        QVERIFY(
            !ways.between(test::pose(30, 50, 0), test::pose(70, 50, 0), {}, JobContext{stop.get_token()}));
    }

    // A small machine's way is as long as that of a point, but for going round corners at its own reach. The
    // same again, whatever was asked before.
    void asShortAsAPoints() {
        constexpr std::uint64_t kSeed = 2511;
        std::mt19937_64 random{kSeed};
        const Machine machine = robot(0.1);
        int bent = 0;
        for (int i = 0; i < 40; ++i) {
            const MultiPolygon all = test::randomPolygons(random, test::Shape::Holes, 60.0);
            const MultiPolygon inside{all.front()};
            const Rig rig{inside, machine};
            const StraightWays ways{inside, rig, {}};
            std::vector<Pose> poses;
            for (int tries = 0; poses.size() < 6 && tries < 1000; ++tries) {
                const Bounds box = bounds(inside);
                const Pose pose = test::pose(test::uniform(random, box.min.x, box.max.x),
                                             test::uniform(random, box.min.y, box.max.y),
                                             test::uniform(random, 0.0, 360.0));
                if (rig.mayTurnOnTheSpot(pose, degrees(360.0))) {
                    poses.push_back(pose);
                }
            }
            for (std::size_t k = 0; k + 1 < poses.size(); ++k) {
                const Pose& from = poses[k];
                const Pose& to = poses[k + 1];
                const auto way = ways.between(from, to, {}, {});
                QVERIFY2(way, qPrintable(QStringLiteral("area %1, way %2").arg(i).arg(k)));
                const double pointM = shortestM(inside, from.position, to.position);
                const double lengthM = way->length().si();
                // At each corner twice the reach, 0.07 m, and what a slower but straighter way costs.
                const double mostM = pointM + 0.15 * turnsIn(*way) + 0.06 * pointM;
                QVERIFY2(lengthM > pointM - 1e-6 && lengthM < mostM,
                         qPrintable(QStringLiteral("area %1, way %2: %3 m, a point %4 m")
                                        .arg(i)
                                        .arg(k)
                                        .arg(lengthM)
                                        .arg(pointM)));
                QVERIFY(rig.driven(Rig::inLine(from), *way));
                QVERIFY(StraightWays(inside, rig, {}).between(from, to, {}, {}) == way);
                bent += turnsIn(*way) > 0 ? 1 : 0;
            }
        }
        QVERIFY(bent > 30);
    }
};

}  // namespace

FURROW_TEST(StraightWaysTest);
#include "tst_straight_ways.moc"
