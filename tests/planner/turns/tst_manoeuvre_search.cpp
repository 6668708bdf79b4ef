// Ways of several moves: checked as any driver would, by moving the machine's outline along them inside GEOS.

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/turns/manoeuvre_search.h"
#include "planner/turns/turn_method.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/field_generator.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <stop_token>
#include <string>
#include <utility>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kRadiusM = 2.0;
constexpr Length kTolerance = metres(0.01);

/// 1.5 m wide and 2.4 m long with its axle in the middle, the implement under it.
MachineSpec robotSpec() {
    MachineSpec spec;
    spec.tractor.width = metres(1.5);
    spec.tractor.length = metres(2.4);
    spec.tractor.rearOverhang = metres(1.2);
    spec.tractor.minTurningRadius = metres(kRadiusM);
    spec.implement.operatingWidth = metres(1.5);
    spec.implement.offset = metres(0.0);
    spec.implement.length = metres(1.0);
    return spec;
}

Machine robot() {
    return Machine::create(robotSpec()).value();
}

Machine forwardRobot() {
    MachineSpec spec = robotSpec();
    spec.tractor.canReverse = false;
    return Machine::create(spec).value();
}

/// A tractor with something wider behind it: it swings out.
Machine withDrill() {
    MachineSpec spec = robotSpec();
    spec.tractor.rearOverhang = metres(0.8);
    spec.implement.operatingWidth = metres(2.5);
    spec.implement.offset = metres(-1.6);
    return Machine::create(spec).value();
}

MultiPolygon room(const char* wkt) {
    return test::polygonsFromWkt(wkt);
}

Polyline closed(Ring ring) {
    ring.push_back(ring.front());
    return ring;
}

double reversedM(const Curve& turn) {
    double sum = 0.0;
    for (const CurvePiece& piece : turn.pieces) {
        sum += piece.gear == Gear::Reverse ? piece.length.si() : 0.0;
    }
    return sum;
}

/// A room with a tolerance all around it.
struct Walls {
    explicit Walls(const MultiPolygon& inside)
        : area{dilated(inside, kTolerance, metres(0.001), {}).value()} {}
    PreparedArea area;

    bool hold(const Ring& footprint, const Pose& pose) const {
        return area.covers({closed(placed(footprint, pose))});
    }
};

/// What is wrong with a way; empty where nothing is.
QByteArray faultOf(const Curve& way, const Pose& from, const Pose& to, const Machine& machine,
                   const Walls& walls) {
    if (way.type != kCombinedTurn) {
        return "its type";
    }
    if (distance(way.start.position, from.position) > 1e-12 || test::headingGap(way.start, from) > 1e-12) {
        return "where it starts";
    }
    const Pose end = test::driven(way);
    if (distance(end.position, to.position) > 1e-6 || test::headingGap(end, to) > 1e-6) {
        return "where it ends: " + QByteArray::number(distance(end.position, to.position));
    }
    const Ring footprint = machine.turningFootprint();
    Pose pose = way.start;
    for (const CurvePiece& piece : way.pieces) {
        if (piece.length < metres(0.0)) {
            return "a negative length";
        }
        if (std::max(std::abs(piece.curvature.si()), std::abs(piece.endCurvature.si())) >
            (1.0 + 1e-9) / machine.minTurningRadius().si()) {
            return "its curvature";
        }
        if (piece.gear == Gear::Reverse && !canReverse(machine)) {
            return "it reverses";
        }
        const int steps = 1 + static_cast<int>(piece.length.si() / 0.05);
        for (int i = 0; i <= steps; ++i) {
            const Pose at = advanced(pose, piece, piece.length * (static_cast<double>(i) / steps));
            if (!walls.hold(footprint, at)) {
                return QStringLiteral("outside at (%1, %2)").arg(at.position.x).arg(at.position.y).toUtf8();
            }
        }
        pose = advanced(pose, piece, piece.length);
    }
    return {};
}

std::optional<Curve> found(const MultiPolygon& inside, const Machine& machine, const Pose& from,
                           const Pose& to) {
    return searchManoeuvre(Rig{inside, machine}, from, to, {}, {});
}

constexpr char kRoundABlock[] = "POLYGON((0 0, 40 0, 40 20, 0 20, 0 0), (15 4, 15 16, 25 16, 25 4, 15 4))";
// An alley 3 m wide and 15 m long, open to the east.
constexpr char kDeadEnd[] = "POLYGON((0 0, 15 0, 15 -15, 40 -15, 40 18, 15 18, 15 3, 0 3, 0 0))";

}  // namespace

class ManoeuvreSearchTest : public QObject {
    Q_OBJECT

private slots:
    void roundABlock_data() {
        QTest::addColumn<bool>("reverses");
        QTest::newRow("forwards only") << false;
        QTest::newRow("in both gears") << true;
    }
    void roundABlock() {
        QFETCH(bool, reverses);
        const Machine machine = reverses ? robot() : forwardRobot();
        const MultiPolygon inside = room(kRoundABlock);
        const Pose from = test::pose(5, 10, 0);
        const Pose to = test::pose(35, 10, 0);
        const auto way = found(inside, machine, from, to);
        QVERIFY(way.has_value());
        const QByteArray fault = faultOf(*way, from, to, machine, Walls{inside});
        QVERIFY2(fault.isEmpty(), fault);
        // A string pulled tight round the block is shorter.
        const double stringM = 2.0 * std::hypot(10.0, 6.0) + 10.0;
        QVERIFY2(way->length().si() > stringM && way->length().si() < 1.5 * stringM,
                 qPrintable(QString::number(way->length().si())));
        QVERIFY(reverses || reversedM(*way) == 0.0);
    }

    // What drives dearly is gone round: here the half of the field with the shorter way.
    void dearPlacesAreGoneRound() {
        const MultiPolygon inside =
            room("POLYGON((0 0, 40 0, 40 20, 0 20, 0 0), (15 5, 15 16, 25 16, 25 5, 15 5))");
        const Pose from = test::pose(5, 8, 0);
        const Pose to = test::pose(35, 8, 0);
        const auto passesBelow = [](const Curve& way) {
            return std::ranges::any_of(sampled(way, metres(0.01)), [](const CurveSample& sample) {
                return sample.pose.position.x > 18.0 && sample.pose.position.x < 22.0 &&
                       sample.pose.position.y < 5.0;
            });
        };
        const auto shortest = found(inside, robot(), from, to);
        QVERIFY(shortest && passesBelow(*shortest));
        const auto cheapest = searchManoeuvre(
            Rig{inside, robot()}, from, to,
            [](Point point) { return point.y < 5.0 && point.x > 14.0 && point.x < 26.0 ? 20.0 : 1.0; }, {});
        QVERIFY(cheapest && !passesBelow(*cheapest));
    }

    void aDeadEndIsLeftInReverse() {
        const MultiPolygon inside = room(kDeadEnd);
        const Pose from = test::pose(3, 1.5, 180);
        const Pose to = test::pose(30, 10, 0);
        const auto way = found(inside, robot(), from, to);
        QVERIFY(way.has_value());
        const QByteArray fault = faultOf(*way, from, to, robot(), Walls{inside});
        QVERIFY2(fault.isEmpty(), fault);
        // It is longer than the alley is wide: the nose cannot come round before the mouth, 12 m behind it.
        QVERIFY2(reversedM(*way) > 9.0, qPrintable(QString::number(reversedM(*way))));
        QVERIFY(!found(inside, forwardRobot(), from, to).has_value());
    }

    // A U of two fields 300 m long that hang together at its far end, 310 m away, and through a gap that is
    // too narrow for the 2.5 m behind the tractor: the grid would lead through that.
    void farRound_data() {
        QTest::addColumn<double>("gapM");
        QTest::newRow("no gap") << 0.0;
        QTest::newRow("a gap for the tractor only") << 2.0;
    }
    void farRound() {
        QFETCH(double, gapM);
        MultiPolygon inside = room("POLYGON((0 0, 320 0, 320 50, 0 50, 0 30, 300 30, 300 20, 0 20, 0 0))");
        if (gapM > 0.0) {
            inside = unionOf({inside.front(), test::rectangle(gapM, 12.0, {20.0, 19.0})}, {}).value();
        }
        const Pose from = test::pose(25.0, 10.0, 180.0);
        const Pose to = test::pose(25.0, 40.0, 0.0);
        const auto way = found(inside, withDrill(), from, to);
        QVERIFY(way.has_value());
        const QByteArray fault = faultOf(*way, from, to, withDrill(), Walls{inside});
        QVERIFY2(fault.isEmpty(), fault);
        // To the far end and back, at least.
        QVERIFY2(way->length().si() > 550.0 && way->length().si() < 900.0,
                 qPrintable(QString::number(way->length().si())));
    }

    // Two centimetres from the edge any bend swings a corner out of the field.
    void besideAnEdge_data() {
        QTest::addColumn<double>("toX");
        QTest::addColumn<double>("toY");
        QTest::addColumn<double>("toDeg");
        QTest::newRow("away into the field") << 30.0 << 30.0 << 180.0;
        QTest::newRow("to the other edge") << 30.0 << 40.0 - 0.77 << 180.0;
        QTest::newRow("round the corner, edge to edge") << 60.0 - 0.77 << 20.0 << 90.0;
    }
    void besideAnEdge() {
        QFETCH(double, toX);
        QFETCH(double, toY);
        QFETCH(double, toDeg);
        const MultiPolygon inside{test::rectangle(60.0, 40.0)};
        const Pose from = test::pose(20.0, 0.77, 0.0);
        const Pose to = test::pose(toX, toY, toDeg);
        const auto way = found(inside, robot(), from, to);
        QVERIFY(way.has_value());
        const QByteArray fault = faultOf(*way, from, to, robot(), Walls{inside});
        QVERIFY2(fault.isEmpty(), fault);
    }

    // Into a pocket beside a lane, 2 m deep, and out of it again. The machine is 2.4 m long and 1.5 m wide
    // and turns within 2 m: with less than twice its length it would take very many moves.
    void intoAPocket_data() {
        QTest::addColumn<double>("lengthM");
        QTest::addColumn<bool>("fits");
        QTest::newRow("its own length") << 2.5 << false;
        QTest::newRow("a metre more") << 3.5 << false;
        QTest::newRow("longer than two machines") << 5.0 << true;
        QTest::newRow("longer than three machines") << 8.0 << true;
    }
    void intoAPocket() {
        QFETCH(double, lengthM);
        QFETCH(bool, fits);
        const double endM = 20.0 + lengthM;
        const MultiPolygon inside{
            {.outer = {{0, 0}, {20, 0}, {20, -2.0}, {endM, -2.0}, {endM, 0}, {50, 0}, {50, 8}, {0, 8}},
             .holes = {}}};
        const Machine machine = robot();
        const Pose lane = test::pose(10.0, 4.0, 0.0);
        const Pose pocket = test::pose(20.0 + 0.5 * lengthM, -1.0, 0.0);
        const Walls walls{inside};
        for (const auto& [from, to] : {std::pair{lane, pocket}, std::pair{pocket, lane}}) {
            const auto way = found(inside, machine, from, to);
            QCOMPARE(way.has_value(), fits);
            QCOMPARE(way ? faultOf(*way, from, to, machine, walls) : QByteArray{}, QByteArray{});
        }
    }

    void nothingWhereThereIsNoWay_data() {
        QTest::addColumn<QString>("wkt");
        QTest::newRow("two rooms")
            << "MULTIPOLYGON(((0 0, 20 0, 20 20, 0 20, 0 0)), ((25 0, 45 0, 45 20, 25 20, 25 0)))";
        QTest::newRow("a door that is too narrow")
            << "POLYGON((0 0, 20 0, 20 9.5, 25 9.5, 25 0, 45 0, 45 20, 25 20, 25 10.5, 20 10.5, 20 20, 0 20, 0 0))";
    }
    void nothingWhereThereIsNoWay() {
        QFETCH(QString, wkt);
        const MultiPolygon inside = test::polygonsFromWkt(wkt.toStdString());
        for (const Machine& machine : {robot(), forwardRobot()}) {
            QVERIFY(!found(inside, machine, test::pose(10, 10, 0), test::pose(35, 10, 0)).has_value());
        }
    }

    void aStoppedJobFindsNothing() {
        std::stop_source stop;
        stop.request_stop();
        const Rig rig{room(kRoundABlock), robot()};
        QVERIFY(!searchManoeuvre(rig, test::pose(5, 10, 0), test::pose(35, 10, 0), {},
                                 {.stop = stop.get_token()}));
    }

    void inRandomRooms_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<int>("machine");
        QTest::addColumn<int>("least");  // ways that are to be found of 30
        for (const test::Shape shape : {test::Shape::Convex, test::Shape::Concave, test::Shape::Holes}) {
            int machine = 0;
            for (const char* name : {"robot", "forwards only", "drill"}) {
                QTest::addRow("%s, %s", std::string{test::shapeName(shape)}.c_str(), name)
                    << static_cast<int>(shape) << machine++ << 20;
            }
        }
    }
    void inRandomRooms() {
        QFETCH(int, shape);
        QFETCH(int, machine);
        QFETCH(int, least);
        const Machine driven = machine == 0 ? robot() : machine == 1 ? forwardRobot() : withDrill();
        const Ring footprint = driven.turningFootprint();
        const std::uint64_t seed = 7100 + static_cast<std::uint64_t>(shape);
        std::mt19937_64 random{seed};
        int ways = 0;
        for (int i = 0; i < 10; ++i) {
            const MultiPolygon inside = test::randomPolygons(random, static_cast<test::Shape>(shape),
                                                             test::uniform(random, 12.0, 40.0));
            const Rig rig{inside, driven};
            const Walls walls{inside};
            const PreparedArea exact{inside};
            const Bounds box = bounds(inside);
            const auto somewhere = [&] {
                for (int attempt = 0; attempt < 2000; ++attempt) {
                    const double x = test::uniform(random, box.min.x, box.max.x);
                    const double y = test::uniform(random, box.min.y, box.max.y);
                    const Pose pose{.position = {x, y},
                                    .heading = radians(test::uniform(random, 0.0, 2.0 * kPi))};
                    if (exact.covers({closed(placed(footprint, pose))})) {
                        return std::optional{pose};
                    }
                }
                return std::optional<Pose>{};
            };
            for (int k = 0; k < 3; ++k) {
                const auto from = somewhere();
                const auto to = somewhere();
                if (!from || !to) {
                    continue;
                }
                const auto way = searchManoeuvre(rig, *from, *to, {}, {});
                QVERIFY(searchManoeuvre(rig, *from, *to, {}, {}) == way);
                if (way) {
                    ++ways;
                    const QByteArray fault = faultOf(*way, *from, *to, driven, walls);
                    VERIFY_TOLD(
                        fault.isEmpty(),
                        QStringLiteral("seed %1, room %2, way %3: ").arg(seed).arg(i).arg(k).toUtf8() +
                            fault);
                }
            }
        }
        QVERIFY2(ways >= least, qPrintable(QString::number(ways)));
    }
};

FURROW_TEST(ManoeuvreSearchTest);
#include "tst_manoeuvre_search.moc"
