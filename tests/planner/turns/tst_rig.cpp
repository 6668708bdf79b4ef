// Tractor and implement against figures worked out by hand and the closed forms of a towed axle.

#include "planner/machine/machine.h"
#include "planner/turns/rig.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/field_generator.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTrailingM = 5.0;

/// 2 m wide, 3 m ahead of its axle and 1 m behind; the implement is 4 m wide, 1 m long, its middle 2 m
/// behind.
Machine mounted() {
    MachineSpec spec;
    spec.tractor.width = metres(2.0);
    spec.tractor.length = metres(4.0);
    spec.tractor.rearOverhang = metres(1.0);
    spec.tractor.minTurningRadius = metres(4.0);
    spec.implement.operatingWidth = metres(4.0);
    spec.implement.offset = metres(-2.0);
    spec.implement.length = metres(1.0);
    return Machine::create(spec).value();
}

/// The same tractor; the implement's middle is kTrailingM behind its hitch.
Machine trailed(double hitchM) {
    MachineSpec spec = mounted().spec();
    spec.implement.mounting = Mounting::Trailed;
    spec.implement.hitchOffset = metres(hitchM);
    spec.implement.offset = metres(hitchM - kTrailingM);
    return Machine::create(spec).value();
}

MultiPolygon square() {
    return {test::rectangle(20.0, 20.0)};
}

MultiPolygon open() {
    return {test::centredRectangle(2000.0, 2000.0)};
}

CurvePiece piece(double lengthM, double curvature, Gear gear = Gear::Forward) {
    return {.length = metres(lengthM),
            .curvature = Curvature::fromSi(curvature),
            .endCurvature = Curvature::fromSi(curvature),
            .gear = gear};
}

double wrapped(double angle) {
    return std::remainder(angle, 2.0 * kPi);
}

}  // namespace

class RigTest : public QObject {
    Q_OBJECT

private slots:
    void outsideByHand_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("headingDeg");
        QTest::addColumn<double>("outsideM");
        QTest::newRow("in the middle") << 10.0 << 10.0 << 30.0 << 0.0;
        QTest::newRow("its wheels fit, the implement does not") << 10.0 << 1.5 << 0.0 << 0.5;
        QTest::newRow("on the other side") << 10.0 << 18.5 << 0.0 << 0.5;
        QTest::newRow("just inside") << 10.0 << 2.0 << 0.0 << 0.0;
        QTest::newRow("nose first") << 17.5 << 10.0 << 0.0 << 0.5;
        QTest::newRow("tail first") << 2.0 << 10.0 << 0.0 << 0.5;
        QTest::newRow("turned round") << 18.0 << 10.0 << 180.0 << 0.5;
        // The front corners are (3, ±1): at 45 degrees one is (3 + 1) / sqrt 2 up.
        QTest::newRow("aslant") << 10.0 << 18.0 << 45.0 << 4.0 / std::numbers::sqrt2 - 2.0;
    }
    void outsideByHand() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, headingDeg);
        QFETCH(double, outsideM);
        const Rig rig{square(), mounted()};
        QVERIFY(!rig.hasTrailer());
        COMPARE_WITHIN(rig.outsideM(Rig::inLine(test::pose(x, y, headingDeg))), outsideM, 1e-9);
    }

    // A corner of the field that reaches 0.3 m into the tractor's right side, while all corners of the
    // machine are inside.
    void aCornerOfTheFieldInTheSide() {
        const MultiPolygon bend{
            {.outer = {{0, 0}, {20, 0}, {20, 10}, {10, 10}, {10, 20}, {0, 20}}, .holes = {}}};
        const Rig rig{bend, mounted()};
        const Point nose = direction(0.75 * kPi);
        const Point left{-nose.y, nose.x};
        const Pose beside{.position = Point{10, 10} - nose + 0.7 * left, .heading = degrees(135.0)};
        COMPARE_WITHIN(rig.outsideM(Rig::inLine(beside)), 0.3, 1e-9);
        const Pose away{.position = beside.position + 0.31 * left, .heading = beside.heading};
        COMPARE_WITHIN(rig.outsideM(Rig::inLine(away)), 0.0, 1e-9);
    }

    // An obstacle cuts the front of the tractor off from corner to side: all its own corners and those of the
    // machine touch each other's sides and nothing more. The middle of its long side, (12, 10), is a metre
    // from front and side.
    void anEdgeFromCornerToSide() {
        const MultiPolygon wedged{{.outer = square().front().outer, .holes = {{{13, 11}, {13, 9}, {11, 9}}}}};
        const Rig rig{wedged, mounted()};
        COMPARE_WITHIN(rig.outsideM(Rig::inLine(test::pose(10.0, 10.0, 0.0))), 1.0, 1e-9);
        const auto within = rig.driven(Rig::inLine(test::pose(9.999, 10.0, 0.0)), piece(0.001, 0.0));
        QVERIFY(!within.has_value());
    }

    void aTrailedImplementHasItsOwnPlace() {
        const Rig rig{square(), trailed(-1.0)};
        QVERIFY(rig.hasTrailer());
        const Pose tractor = test::pose(10.0, 4.0, 0.0);
        COMPARE_WITHIN(rig.outsideM(Rig::inLine(tractor)), 0.0, 1e-9);
        // Hitched at (9, 4) and pointing north: its middle is at (9, -1), its tail half a metre farther.
        COMPARE_WITHIN(rig.outsideM({.tractor = tractor, .implement = degrees(90.0)}), 1.5, 1e-9);
        // Pointing south-west it is inside again.
        COMPARE_WITHIN(rig.outsideM({.tractor = tractor, .implement = degrees(-120.0)}), 0.0, 1e-9);
        // In line, its tail is 1 + 5.5 m behind the axle.
        COMPARE_WITHIN(rig.outsideM(Rig::inLine(test::pose(6.0, 10.0, 0.0))), 0.5, 1e-9);
    }

    // tan(angle / 2) falls by exp(-s / L) while the hitch moves straight: the tractrix.
    void straightPull_data() {
        QTest::addColumn<double>("angleDeg");
        QTest::addColumn<double>("wayM");
        QTest::newRow("small") << 1.0 << 7.0;
        QTest::newRow("to the right") << -1.0 << 7.0;
        QTest::newRow("60 degrees") << 60.0 << 8.0;
        QTest::newRow("across") << -90.0 << 3.0;
        QTest::newRow("long") << 60.0 << 100.0;
    }
    void straightPull() {
        QFETCH(double, angleDeg);
        QFETCH(double, wayM);
        const Rig rig{open(), trailed(-1.0)};
        const Pose start = test::pose(3.0, -7.0, 25.0);
        const RigState from{.tractor = start, .implement = start.heading + degrees(angleDeg)};
        const auto after = rig.driven(from, piece(wayM, 0.0));
        QVERIFY(after.has_value());
        COMPARE_WITHIN(
            distance(after->tractor.position, start.position + wayM * direction(start.heading.si())), 0.0,
            1e-9);
        const double angle = wrapped(after->implement.si() - after->tractor.heading.si());
        const double expected =
            2.0 * std::atan(std::tan(0.5 * degrees(angleDeg).si()) * std::exp(-wayM / kTrailingM));
        COMPARE_WITHIN(angle, expected, 1e-9);
        if (std::abs(angleDeg) < 2.0) {
            COMPARE_WITHIN(angle / degrees(angleDeg).si(), std::exp(-wayM / kTrailingM), 1e-4);
        }
    }

    // Pushed back over the same way, it swings out as it swung in.
    void pushedBack() {
        const Rig rig{open(), trailed(-1.0)};
        const RigState from{.tractor = test::pose(0.0, 0.0, 0.0), .implement = degrees(50.0)};
        const auto there = rig.driven(from, piece(6.0, 0.0));
        QVERIFY(there.has_value());
        const auto back = rig.driven(*there, piece(6.0, 0.0, Gear::Reverse));
        QVERIFY(back.has_value());
        COMPARE_WITHIN(back->implement.si(), from.implement.si(), 1e-9);
    }

    // In a circle for long: the hitch runs on a circle of radius r, at right angles to it the implement's
    // axle, so that sin(angle) = L / r. A hitch h behind the axle has r² = R² + h² and moves atan(h / R) off
    // the nose.
    void roundACircle_data() {
        QTest::addColumn<double>("radiusM");
        QTest::addColumn<double>("hitchM");
        QTest::newRow("hitch on the axle") << 8.0 << 0.0;
        QTest::newRow("the same to the right") << -8.0 << 0.0;
        QTest::newRow("tight") << 5.5 << 0.0;
        QTest::newRow("wide") << 40.0 << 0.0;
        QTest::newRow("hitch behind") << 8.0 << -1.5;
        QTest::newRow("hitch behind, to the right") << -8.0 << -1.5;
    }
    void roundACircle() {
        QFETCH(double, radiusM);
        QFETCH(double, hitchM);
        const Rig rig{open(), trailed(hitchM)};
        const auto after = rig.driven(Rig::inLine(test::pose(0.0, 0.0, 70.0)), piece(200.0, 1.0 / radiusM));
        QVERIFY(after.has_value());
        const double angle = wrapped(after->tractor.heading.si() - after->implement.si());
        const double r = std::hypot(radiusM, hitchM);
        const double expected = std::asin(kTrailingM / r) + std::atan(-hitchM / std::abs(radiusM));
        COMPARE_WITHIN(angle, std::copysign(expected, radiusM), 2e-3);
    }

    void stopsWhereSomethingIsOutside() {
        const Rig rig{square(), mounted()};
        const RigState from = Rig::inLine(test::pose(10.0, 10.0, 0.0));
        // The nose is 3 m ahead: 7 m are left.
        QVERIFY(rig.driven(from, piece(6.9, 0.0)).has_value());
        QVERIFY(!rig.driven(from, piece(7.1, 0.0)).has_value());
        // Back again before the end does not help.
        const Curve outAndBack{.type = "made",
                               .start = from.tractor,
                               .pieces = {piece(8.0, 0.0), piece(8.0, 0.0, Gear::Reverse)}};
        QVERIFY(!rig.driven(from, outAndBack).has_value());
        const Curve inside{.type = "made",
                           .start = from.tractor,
                           .pieces = {piece(5.0, 0.0), piece(3.0, 0.2, Gear::Reverse)}};
        const auto after = rig.driven(from, inside);
        QVERIFY(after.has_value());
        const Pose end = test::driven(inside);
        COMPARE_WITHIN(distance(after->tractor.position, end.position), 0.0, 1e-9);
        COMPARE_WITHIN(test::headingGap(after->tractor, end), 0.0, 1e-12);
        QCOMPARE(after->implement, after->tractor.heading);
    }

    // However few places are looked at, and whatever is known to begin with, what is driven is what stays
    // inside when every centimetre is looked at; what is outside by a millimetre or two may go either way.
    void likeLookingEverywhere_data() {
        QTest::addColumn<Machine>("machine");
        QTest::newRow("mounted") << mounted();
        QTest::newRow("trailed") << trailed(-1.5);
    }
    void likeLookingEverywhere() {
        QFETCH(Machine, machine);
        constexpr double kSurelyInsideM = 0.5e-3;
        constexpr double kSurelyOutsideM = 4e-3;
        int driven = 0;
        int stopped = 0;
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            std::mt19937_64 random{seed};
            const MultiPolygon field = test::randomPolygons(
                random, test::kShapes[seed % test::kShapes.size()], test::uniform(random, 40.0, 120.0));
            const Rig rig{field, machine};
            const Bounds box = bounds(field);
            for (int i = 0; i < 60; ++i) {
                const RigState from = Rig::inLine(test::pose(test::uniform(random, box.min.x, box.max.x),
                                                             test::uniform(random, box.min.y, box.max.y),
                                                             test::uniform(random, 0.0, 2.0 * kPi)));
                const double curvature = i % 3 == 0 ? test::uniform(random, -0.25, 0.25) : 0.0;
                const CurvePiece way = piece(test::uniform(random, 0.05, 25.0), curvature,
                                             i % 2 == 0 ? Gear::Forward : Gear::Reverse);
                if (rig.outsideM(from) > 0.0) {
                    continue;
                }
                double outsideM = 0.0;
                const RigState end = *rig.follow(from, way, metres(0.01), [&](const RigState& at) {
                    outsideM = std::max(outsideM, rig.outsideM(at));
                    return true;
                });
                const QByteArray told = QStringLiteral("seed %1, way %2, outside by %3 mm")
                                            .arg(seed)
                                            .arg(i)
                                            .arg(1e3 * outsideM)
                                            .toUtf8();
                for (const FootprintRoom& known : {FootprintRoom{}, rig.roomAt(from)}) {
                    const auto after = rig.driven(from, way, metres(1e-3), known);
                    if (outsideM < kSurelyInsideM) {
                        QVERIFY2(after.has_value(), told);
                        QVERIFY2(distance(after->tractor.position, end.tractor.position) < 1e-9, told);
                        QVERIFY2(std::abs(wrapped((after->implement - end.implement).si())) < 1e-3, told);
                        ++driven;
                    } else if (outsideM > kSurelyOutsideM) {
                        QVERIFY2(!after.has_value(), told);
                        ++stopped;
                    }
                }
            }
        }
        QVERIFY(driven > 200 && stopped > 200);
    }

    // A bend that the tractor takes inside, while the swinging tail of what is mounted does not.
    void theTailSwingsOut() {
        const RigState from = Rig::inLine(test::pose(10.0, 17.9, 0.0));
        const CurvePiece bend = piece(2.0, -1.0 / 4.0);
        QVERIFY(!Rig(square(), mounted()).driven(from, bend).has_value());
        MachineSpec narrow = mounted().spec();
        narrow.implement.raisedWidth = metres(2.0);
        QVERIFY(Rig(square(), Machine::create(narrow).value()).driven(from, bend).has_value());
    }

    void roomForTheWheels() {
        const Rig rig{square(), mounted()};
        QVERIFY(rig.mayStandAt({10.0, 10.0}));
        QVERIFY(rig.mayStandAt({1.01, 10.0}));
        QVERIFY(!rig.mayStandAt({0.9, 10.0}));
        QVERIFY(!rig.mayStandAt({-0.5, 10.0}));
    }
};

FURROW_TEST(RigTest);
#include "tst_rig.moc"
