#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/test_program.h"

using namespace furrow;
using namespace furrow::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 20'250'301;

}  // namespace

class ReedsSheppTest : public QObject {
    Q_OBJECT

private slots:
    void lengthsByHand_data() {
        QTest::addColumn<Pose>("to");
        QTest::addColumn<double>("lengthM");
        const double r = 2.0;
        QTest::newRow("already there") << pose(0, 0, 0) << 0.0;
        QTest::newRow("straight ahead") << pose(17.5, 0, 0) << 17.5;
        QTest::newRow("straight back") << pose(-17.5, 0, 0) << 17.5;
        QTest::newRow("quarter turn forward to the left") << pose(r, r, 90) << 0.5 * kPi * r;
        QTest::newRow("quarter turn backward with the wheel to the left")
            << pose(-r, r, -90) << 0.5 * kPi * r;
        QTest::newRow("quarter turn backward with the wheel to the right")
            << pose(-r, -r, 90) << 0.5 * kPi * r;
        QTest::newRow("U turn of two radii") << pose(0, 2 * r, 180) << kPi * r;
        // Turning round on the spot: three arcs of a sixth of a circle, forward, back, forward; the three
        // circles touch each other.
        QTest::newRow("about face on the spot") << pose(0, 0, 180) << kPi * r;
        // Parallel parking: two circles that touch, each driven by a: sideways 2 R (1 - cos a), ahead 2 R sin
        // a.
        for (const double a : {0.2, 0.5, 1.0}) {
            QTest::addRow("parallel parking backward, arcs of %g rad", a)
                << pose(-2.0 * r * std::sin(a), 2.0 * r * (1.0 - std::cos(a)), 0) << 2.0 * r * a;
        }
    }
    void lengthsByHand() {
        QFETCH(Pose, to);
        QFETCH(double, lengthM);
        const Length radius = metres(2.0);
        COMPARE_WITHIN(reedsSheppLength(pose(0, 0, 0), to, radius).si(), lengthM, 1e-7);
        const Curve turn = reedsSheppTurn(pose(0, 0, 0), to, radius);
        COMPARE_WITHIN(turn.length().si(), lengthM, 1e-7);
        const Pose end = driven(turn);
        COMPARE_WITHIN(distance(end.position, to.position), 0.0, 1e-7);
        COMPARE_WITHIN(headingGap(end, to), 0.0, 1e-8);
        QCOMPARE(turn.type, std::string_view{"reeds-shepp"});
    }

    void properties() {
        std::mt19937_64 random{kSeed};
        double worstM = 0.0;
        double worstRad = 0.0;
        for (int i = 0; i < 60'000; ++i) {
            const PosePair pair = i % 3 == 0 ? swathPair(random) : randomPair(random);
            const Length radius = metres(pair.radiusM);
            const Curve turn = reedsSheppTurn(pair.from, pair.to, radius);
            const Pose end = driven(turn);
            worstM = std::max(worstM, distance(end.position, pair.to.position));
            worstRad = std::max(worstRad, headingGap(end, pair.to));
            VERIFY_TOLD(distance(end.position, pair.to.position) < 1e-6, told(kSeed, i, pair));
            VERIFY_TOLD(headingGap(end, pair.to) < 1e-7, told(kSeed, i, pair));
            VERIFY_TOLD(distance(turn.end().position, end.position) < 1e-9 * (1.0 + 100.0 * pair.radiusM),
                        told(kSeed, i, pair));
            VERIFY_TOLD(turn.pieces.size() <= 5, told(kSeed, i, pair));
            for (const CurvePiece& piece : turn.pieces) {
                VERIFY_TOLD(piece.length.si() > 0.0, told(kSeed, i, pair));
                VERIFY_TOLD(std::abs(piece.curvature.si()) <= 1.0 / pair.radiusM, told(kSeed, i, pair));
                VERIFY_TOLD(piece.curvature == piece.endCurvature, told(kSeed, i, pair));
            }
            const double length = reedsSheppLength(pair.from, pair.to, radius).si();
            VERIFY_TOLD(std::abs(turn.length().si() - length) < 1e-9 * (1.0 + length), told(kSeed, i, pair));
            VERIFY_TOLD(length >= distance(pair.from.position, pair.to.position) - 1e-9,
                        told(kSeed, i, pair));
            VERIFY_TOLD(length <= dubinsLength(pair.from, pair.to, radius).si() + 1e-7, told(kSeed, i, pair));
            // The way back, the mirror image, and the way there with the nose the other way round.
            const double back = reedsSheppLength(pair.to, pair.from, radius).si();
            const double mirror = reedsSheppLength(mirrored(pair.from), mirrored(pair.to), radius).si();
            const auto about = [](const Pose& p) { return Pose{p.position, p.heading + radians(kPi)}; };
            const double flipped = reedsSheppLength(about(pair.from), about(pair.to), radius).si();
            const double within = 1e-9 * (1.0 + length);
            VERIFY_TOLD(std::abs(length - back) < within, told(kSeed, i, pair));
            VERIFY_TOLD(std::abs(length - mirror) < within, told(kSeed, i, pair));
            VERIFY_TOLD(std::abs(length - flipped) < within, told(kSeed, i, pair));
        }
        qInfo("largest gap at the end: %.2g m, %.2g rad", worstM, worstRad);
    }

    // Exact angles and distances are where words meet and roundings bite.
    void onAGrid() {
        const Length radius = metres(2.0);
        for (int x = -9; x <= 9; ++x) {
            for (int y = -9; y <= 9; ++y) {
                for (int a = 0; a < 360; a += 45) {
                    for (int b = 0; b < 360; b += 45) {
                        const PosePair pair{pose(0, 0, a), pose(x, y, b), 2.0};
                        const Curve turn = reedsSheppTurn(pair.from, pair.to, radius);
                        const Pose end = driven(turn);
                        VERIFY_TOLD(distance(end.position, pair.to.position) < 1e-6, told(0, 0, pair));
                        VERIFY_TOLD(headingGap(end, pair.to) < 1e-7, told(0, 0, pair));
                        VERIFY_TOLD(
                            turn.length().si() <= dubinsLength(pair.from, pair.to, radius).si() + 1e-7,
                            told(0, 0, pair));
                        const double back = reedsSheppLength(pair.to, pair.from, radius).si();
                        VERIFY_TOLD(std::abs(turn.length().si() - back) < 1e-7, told(0, 0, pair));
                    }
                }
            }
        }
    }

    void machinesThatCannotReverseDriveDubins() {
        MachineSpec spec;
        spec.tractor.minTurningRadius = metres(4.0);
        const Pose to = pose(0, 0, 180);
        QCOMPARE(kReedsSheppMethod.run(pose(0, 0, 0), to, *Machine::create(spec)).type,
                 std::string_view{"reeds-shepp"});
        spec.tractor.canReverse = false;
        QCOMPARE(kReedsSheppMethod.run(pose(0, 0, 0), to, *Machine::create(spec)).type,
                 std::string_view{"dubins"});
        spec.tractor.canReverse = true;
        spec.implement.mounting = Mounting::Trailed;
        spec.implement.canReverse = false;
        QCOMPARE(kReedsSheppMethod.run(pose(0, 0, 0), to, *Machine::create(spec)).type,
                 std::string_view{"dubins"});
    }
};

FURROW_TEST(ReedsSheppTest);
#include "tst_reeds_shepp.moc"
