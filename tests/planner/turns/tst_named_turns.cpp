#include "planner/turns/dubins.h"
#include "planner/turns/named_turns.h"
#include "planner/turns/reeds_shepp.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/test_program.h"

#include <vector>

using namespace furrow;
using namespace furrow::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 20'250'601;
constexpr double kR = 3.0;

using Drive = Curve (*)(const Pose&, const Pose&, Length);

struct Case {
    std::string_view type;
    Drive drive;
    const Method<TurnPlanner>* method;
    bool reverses;
};

constexpr Case kCases[] = {
    {"u", uTurn, &kUTurnMethod, false},
    {"omega", omegaTurn, &kOmegaMethod, false},
    {"p", pTurn, &kPTurnMethod, false},
    {"fishtail", fishtailTurn, &kFishtailMethod, true},
    {"three-point", threePointTurn, &kThreePointMethod, true},
};

double arcCosine(double x) {
    return std::acos(x);
}

/// Letters and signs of a turn: "L+ S+ L+".
QByteArray shapeOf(const Curve& turn) {
    QByteArray shape;
    for (const CurvePiece& piece : turn.pieces) {
        const double k = piece.curvature.si();
        shape += k > 0.0 ? 'L' : k < 0.0 ? 'R' : 'S';
        shape += piece.gear == Gear::Forward ? '+' : '-';
    }
    return shape;
}

}  // namespace

Q_DECLARE_METATYPE(const Case*)

class NamedTurnsTest : public QObject {
    Q_OBJECT

private slots:
    // Every row to the right and, mirrored, to the left. Swath ends at (0, 0), nose to the north.
    void byHand_data() {
        QTest::addColumn<const Case*>("turn");
        QTest::addColumn<double>("w");
        QTest::addColumn<double>("farther");
        QTest::addColumn<QByteArray>("shape");
        QTest::addColumn<double>("lengthM");
        const Case* u = &kCases[0];
        const Case* omega = &kCases[1];
        const Case* p = &kCases[2];
        const Case* fishtail = &kCases[3];
        const Case* threePoint = &kCases[4];
        QTest::newRow("U, level") << u << 10.0 << 0.0 << QByteArray{"R+S+R+"} << kPi * kR + 10.0 - 2.0 * kR;
        QTest::newRow("U of exactly two radii, goal farther out")
            << u << 2.0 * kR << 4.0 << QByteArray{"S+R+"} << kPi * kR + 4.0;
        // Two radii and 3 m across, 4 m along: the tangent is 5 m long.
        QTest::newRow("U at an oblique edge")
            << u << 2.0 * kR + 3.0 << 4.0 << QByteArray{"R+S+R+"} << kPi * kR + 5.0;
        QTest::newRow("U at an oblique edge, goal nearer")
            << u << 2.0 * kR + 3.0 << -4.0 << QByteArray{"R+S+R+"} << kPi * kR + 5.0;
        for (const double w : {0.5, 2.0, 5.5}) {
            const double a = arcCosine((2.0 * kR + w) / (4.0 * kR));
            QTest::addRow("omega, level, %g m apart", w)
                << omega << w << 0.0 << QByteArray{"L+R+L+"} << kR * (kPi + 4.0 * a);
            const double b = arcCosine(w / (2.0 * kR));
            QTest::addRow("fishtail, level, %g m apart", w)
                << fishtail << w << 0.0 << QByteArray{"R+S-R+"} << kPi * kR + 2.0 * kR - w;
            QTest::addRow("three-point, level, %g m apart", w)
                << threePoint << w << 0.0 << QByteArray{"R+L-R+"} << kPi * kR;
            QTest::addRow("P, goal 100 m nearer, %g m apart", w)
                << p << w << -100.0 << QByteArray{"L+R+S+"}
                << kR * (kPi + 2.0 * b + 2.0 * std::sin(b)) + 100.0;
            QTest::addRow("P, goal 100 m farther out, %g m apart", w)
                << p << w << 100.0 << QByteArray{"S+R+L+"}
                << kR * (kPi + 2.0 * b + 2.0 * std::sin(b)) + 100.0;
        }
        // So far that the circles do not reach each other: two radii and 3 m across two outer circles leaves
        // room for no middle one; the Dubins turn it is.
        QTest::newRow("omega between far swaths is none")
            << omega << 2.0 * kR + 3.0 << 0.0 << QByteArray{} << kPi * kR + 3.0;
        QTest::newRow("P between far swaths is none")
            << p << 2.0 * kR + 3.0 << 0.0 << QByteArray{} << kPi * kR + 3.0;
        QTest::newRow("three-point between far swaths is none")
            << threePoint << 2.0 * kR + 3.0 << 0.0 << QByteArray{} << kPi * kR + 3.0;
        QTest::newRow("fishtail between far swaths is none")
            << fishtail << 2.0 * kR + 3.0 << 0.0 << QByteArray{} << kPi * kR + 3.0;
        QTest::newRow("U between near swaths is none")
            << u << 2.0 << 0.0 << QByteArray{} << kR * (kPi + 4.0 * arcCosine((2.0 * kR + 2.0) / (4.0 * kR)));
    }
    void byHand() {
        QFETCH(const Case*, turn);
        QFETCH(double, w);
        QFETCH(double, farther);
        QFETCH(QByteArray, shape);
        QFETCH(double, lengthM);
        const Pose from = pose(0, 0, 90);
        for (const int side : {1, -1}) {
            const Pose to = pose(side * w, farther, -90);
            const Curve driveable = turn->drive(from, to, metres(kR));
            COMPARE_WITHIN(driveable.length().si(), lengthM, 1e-8);
            COMPARE_WITHIN(distance(driven(driveable).position, to.position), 0.0, 1e-8);
            COMPARE_WITHIN(headingGap(driven(driveable), to), 0.0, 1e-8);
            QCOMPARE(driveable.type, shape.isEmpty() ? std::string_view{"dubins"} : turn->type);
            QByteArray expected = shape;
            if (side < 0) {
                expected.replace('L', 'x').replace('R', 'L').replace('x', 'R');
            }
            if (!shape.isEmpty()) {
                QCOMPARE(shapeOf(driveable), expected);
            }
        }
    }

    void properties_data() {
        QTest::addColumn<const Case*>("turn");
        for (const Case& turn : kCases) {
            QTest::newRow(std::string{turn.type}.c_str()) << &turn;
        }
    }
    void properties() {
        QFETCH(const Case*, turn);
        std::mt19937_64 random{kSeed};
        int kept[2] = {0, 0};
        double worstM = 0.0;
        for (int i = 0; i < 40'000; ++i) {
            const PosePair pair = i % 2 == 0 ? swathPair(random) : randomPair(random);
            const QByteArray text = told(kSeed, i, pair);
            const Length radius = metres(pair.radiusM);
            const Curve found = turn->drive(pair.from, pair.to, radius);
            const Pose end = driven(found);
            worstM = std::max(worstM, distance(end.position, pair.to.position));
            VERIFY_TOLD(distance(end.position, pair.to.position) < 1e-6, text);
            VERIFY_TOLD(headingGap(end, pair.to) < 1e-7, text);
            VERIFY_TOLD(found.type == turn->type || found.type == "dubins", text);
            kept[i % 2] += found.type == turn->type ? 1 : 0;
            for (const CurvePiece& piece : found.pieces) {
                VERIFY_TOLD(piece.length.si() > 0.0, text);
                VERIFY_TOLD(std::abs(piece.curvature.si()) <= 1.0 / pair.radiusM, text);
                VERIFY_TOLD(piece.gear == Gear::Forward || turn->reverses, text);
            }
            const double length = found.length().si();
            VERIFY_TOLD(length >= reedsSheppLength(pair.from, pair.to, radius).si() - 1e-6, text);
            VERIFY_TOLD(turn->reverses || length >= dubinsLength(pair.from, pair.to, radius).si() - 1e-6,
                        text);
            const double mirror = turn->drive(mirrored(pair.from), mirrored(pair.to), radius).length().si();
            VERIFY_TOLD(std::abs(length - mirror) < 1e-9 * (1.0 + length), text);
        }
        qInfo("its own kind between %.3g of swath ends and %.3g of any poses; largest gap %.2g m",
              kept[0] / 20'000.0, kept[1] / 20'000.0, worstM);
    }

    // Between swaths at least two radii apart there is always a U turn; between nearer ones all the others,
    // whatever the angle of the field edge.
    void swathEndsAlwaysHaveTheirTurn_data() { properties_data(); }
    void swathEndsAlwaysHaveTheirTurn() {
        QFETCH(const Case*, turn);
        for (double edge = 30.0; edge <= 150.0; edge += 2.5) {
            for (double w = 0.25; w < 12.0; w += 0.25) {
                const bool far = w >= 2.0 * kR;
                if (far != (turn->type == "u")) {
                    continue;
                }
                const Pose to = pose(w, w / std::tan(degrees(edge).si()), -90);
                const Curve found = turn->drive(pose(0, 0, 90), to, metres(kR));
                QVERIFY2(found.type == turn->type,
                         qPrintable(QStringLiteral("%1 m, %2 degrees").arg(w).arg(edge)));
            }
        }
    }

    // Square to each other but for rounding, or nearly so: the level of the other end lies millions of metres
    // away, and no turn goes there. A run-out is at most twice the way between the ends and the straight
    // after it thrice; their arcs are less than eight circles.
    void neverFarAway_data() { properties_data(); }
    void neverFarAway() {
        QFETCH(const Case*, turn);
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 20'000; ++i) {
            PosePair pair = randomPair(random);
            const double across = (i % 2 == 0 ? 0.5 : -0.5) * kPi;
            const double by = std::pow(10.0, std::uniform_real_distribution<double>{-12.0, 0.0}(random)) *
                              (i % 4 < 2 ? 1.0 : -1.0);
            pair.to.heading = pair.from.heading + radians(across + by);
            const Curve found = turn->drive(pair.from, pair.to, metres(pair.radiusM));
            const double mostM =
                5.0 * distance(pair.from.position, pair.to.position) + 16.0 * kPi * pair.radiusM;
            VERIFY_TOLD(found.length().si() < mostM, told(kSeed, i, pair));
        }
    }

    void degenerate() {
        for (const Case& turn : kCases) {
            for (const Pose& to :
                 {pose(0, 0, 0), pose(0, 0, 180), pose(5, 0, 0), pose(-5, 0, 0), pose(1e6, 3, 180),
                  pose(0, 2 * kR, 180), pose(0, 4 * kR, 0), pose(0, 1e-9, 180)}) {
                const Curve found = turn.drive(pose(0, 0, 0), to, metres(kR));
                const Pose end = driven(found);
                COMPARE_WITHIN(distance(end.position, to.position), 0.0, 1e-6 + 1e-12 * norm(to.position));
                COMPARE_WITHIN(headingGap(end, to), 0.0, 1e-7);
            }
        }
    }

    void machinesThatCannotReverse() {
        MachineSpec spec;
        spec.tractor.minTurningRadius = metres(kR);
        const Machine reversing = *Machine::create(spec);
        spec.tractor.canReverse = false;
        const Machine forward = *Machine::create(spec);
        for (const Case& turn : kCases) {
            const Pose to = pose(turn.type == "u" ? 10 : 2, 0, -90);
            QCOMPARE(turn.method->info.id, turn.type);
            QCOMPARE(turn.method->run(pose(0, 0, 90), to, reversing).type, turn.type);
            QCOMPARE(turn.method->run(pose(0, 0, 90), to, forward).type,
                     turn.reverses ? std::string_view{"dubins"} : turn.type);
        }
    }
};

FURROW_TEST(NamedTurnsTest);
#include "tst_named_turns.moc"
