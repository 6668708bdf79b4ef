#include "planner/turns/continuous_curvature.h"
#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/test_program.h"

using namespace furrow;
using namespace furrow::test;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 20'250'501;

/// The method under test and the one without clothoids.
struct Case {
    Curve (*turn)(const Pose&, const Pose&, Length, CurvatureRate);
    Length (*plain)(const Pose&, const Pose&, Length);
    bool reversing;
};

constexpr Case kForward{continuousDubinsTurn, dubinsLength, false};
constexpr Case kReversing{continuousReedsSheppTurn, reedsSheppLength, true};

}  // namespace

Q_DECLARE_METATYPE(const Case*)

class ContinuousCurvatureTest : public QObject {
    Q_OBJECT

    static void cases() {
        QTest::addColumn<const Case*>("method");
        QTest::newRow("forward") << &kForward;
        QTest::newRow("with reversing") << &kReversing;
    }

private slots:
    // The end of a clothoid that turns by a quarter circle, and where a clothoid goes in the limit, from
    // tables of the Fresnel integrals: C(1) = 0.7798934004, S(1) = 0.4382591474; C(5) = 0.5636311887,
    // S(5) = 0.4991913819 (Abramowitz & Stegun, table 7.7).
    void drivesClothoids_data() {
        QTest::addColumn<double>("t");
        QTest::addColumn<double>("c");
        QTest::addColumn<double>("s");
        QTest::newRow("t = 0.5") << 0.5 << 0.4923442258714464 << 0.0647324328599992;
        QTest::newRow("t = 1") << 1.0 << 0.7798934003768228 << 0.4382591473903548;
        QTest::newRow("t = 2") << 2.0 << 0.4882534060753408 << 0.3434156783636982;
        QTest::newRow("t = 5") << 5.0 << 0.5636311887040122 << 0.4991913819171169;
    }
    void drivesClothoids() {
        QFETCH(double, t);
        QFETCH(double, c);
        QFETCH(double, s);
        // With the curvature pi u the heading is pi u² / 2: the integrals themselves.
        const CurvePiece piece{
            .length = metres(t), .curvature = {}, .endCurvature = Curvature::fromSi(kPi * t)};
        const Pose end = advanced(pose(0, 0, 0), piece, piece.length);
        COMPARE_WITHIN(end.position.x, c, 1e-13);
        COMPARE_WITHIN(end.position.y, s, 1e-13);
        COMPARE_WITHIN(headingGap(end, {.heading = radians(0.5 * kPi * t * t)}), 0.0, 1e-13);
        // And back again, in reverse from its end.
        const CurvePiece back{
            .length = metres(t), .curvature = piece.endCurvature, .endCurvature = {}, .gear = Gear::Reverse};
        const Pose start = advanced(end, back, back.length);
        COMPARE_WITHIN(distance(start.position, {0.0, 0.0}), 0.0, 1e-13);
        COMPARE_WITHIN(headingGap(start, pose(0, 0, 0)), 0.0, 1e-13);
        // Part of the way is the clothoid to a smaller t.
        const CurvePiece half{
            .length = metres(0.5 * t), .curvature = {}, .endCurvature = Curvature::fromSi(0.5 * kPi * t)};
        COMPARE_WITHIN(distance(advanced(pose(3, 4, 50), piece, half.length).position,
                                advanced(pose(3, 4, 50), half, half.length).position),
                       0.0, 1e-13);
    }

    void lengthsByHand_data() {
        QTest::addColumn<Pose>("to");
        QTest::addColumn<double>("lengthM");
        // R = 4 m, rate 0.05 per m²: a clothoid is 0.25 / 0.05 = 5 m long, two turn by 1.25 rad.
        QTest::newRow("already there") << pose(0, 0, 0) << 0.0;
        QTest::newRow("straight ahead") << pose(17.5, 0, 0) << 17.5;
        QTest::newRow("straight ahead, nearer than two clothoids") << pose(1.5, 0, 0) << 1.5;
        // A single turn by an angle a is a / k + k / rate long. Its end, driven by hand below.
        for (const double a : {1.25, 0.5 * kPi, kPi}) {
            const Curve turn{.type = "test",
                             .start = pose(0, 0, 0),
                             .pieces = {{metres(5.0), {}, Curvature::fromSi(0.25)},
                                        {metres((a - 1.25) * 4.0), Curvature::fromSi(0.25)},
                                        {metres(5.0), Curvature::fromSi(0.25), {}}}};
            const Pose end = driven(turn);
            // Run-outs that the word's second turn, by nothing, needs.
            const Pose goal{end.position + 20.0 * direction(end.heading.si()), end.heading};
            QTest::addRow("one turn by %g rad and 20 m straight on", a) << goal << 4.0 * a + 5.0 + 20.0;
        }
    }
    void lengthsByHand() {
        QFETCH(Pose, to);
        QFETCH(double, lengthM);
        const Curve turn = continuousDubinsTurn(pose(0, 0, 0), to, metres(4.0), CurvatureRate::fromSi(0.05));
        COMPARE_WITHIN(turn.length().si(), lengthM, 1e-7);
        COMPARE_WITHIN(distance(driven(turn).position, to.position), 0.0, 1e-7);
        QCOMPARE(turn.type, std::string_view{"dubins-cc"});
    }

    void properties_data() { cases(); }
    void properties() {
        QFETCH(const Case*, method);
        std::mt19937_64 random{kSeed};
        double worstM = 0.0;
        double worstRad = 0.0;
        double longer = 0.0;
        for (int i = 0; i < 24'000; ++i) {
            const PosePair pair = i % 2 == 0 ? swathPair(random) : randomPair(random);
            const double rate = 0.02 * std::pow(50.0, uniform(random, 0.0, 1.0));
            const Length radius = metres(pair.radiusM);
            const auto drive = [&](const Pose& from, const Pose& to) {
                return method->turn(from, to, radius, CurvatureRate::fromSi(rate));
            };
            const Curve turn = drive(pair.from, pair.to);
            const QByteArray text = told(kSeed, i, pair) + ", rate " + QByteArray::number(rate, 'g', 17);
            const double length = turn.length().si();
            const Pose end = driven(turn);
            worstM = std::max(worstM, distance(end.position, pair.to.position));
            worstRad = std::max(worstRad, headingGap(end, pair.to));
            VERIFY_TOLD(distance(end.position, pair.to.position) < 1e-6, text);
            VERIFY_TOLD(headingGap(end, pair.to) < 1e-7, text);
            VERIFY_TOLD(distance(turn.end().position, pair.to.position) < 1e-6, text);
            double curvature = 0.0;
            Gear gear = Gear::Forward;
            for (const CurvePiece& piece : turn.pieces) {
                VERIFY_TOLD(piece.length.si() > 0.0, text);
                VERIFY_TOLD(method->reversing || piece.gear == Gear::Forward, text);
                VERIFY_TOLD(std::abs(piece.curvature.si() - curvature) < 1e-9, text);
                VERIFY_TOLD(piece.gear == gear || std::abs(curvature) < 1e-9, text);
                curvature = piece.endCurvature.si();
                gear = piece.gear;
                VERIFY_TOLD(std::abs(curvature) <= (1.0 + 1e-9) / pair.radiusM, text);
                const double change = (piece.endCurvature - piece.curvature).si() / piece.length.si();
                VERIFY_TOLD(std::abs(change) <= rate * (1.0 + 1e-9), text);
            }
            VERIFY_TOLD(std::abs(curvature) < 1e-9, text);
            VERIFY_TOLD(length >= method->plain(pair.from, pair.to, radius).si() - 1e-7, text);
            longer += length / method->plain(pair.from, pair.to, radius).si();
            const double within = 1e-9 * (1.0 + length);
            VERIFY_TOLD(
                std::abs(length - drive(mirrored(pair.from), mirrored(pair.to)).length().si()) < within,
                text);
            const auto about = [](const Pose& p) { return Pose{p.position, p.heading + radians(kPi)}; };
            VERIFY_TOLD(std::abs(length - drive(about(pair.to), about(pair.from)).length().si()) < within,
                        text);
            VERIFY_TOLD(
                !method->reversing || std::abs(length - drive(pair.to, pair.from).length().si()) < within,
                text);
            if (method->reversing) {
                const Length forward =
                    continuousDubinsTurn(pair.from, pair.to, radius, CurvatureRate::fromSi(rate)).length();
                VERIFY_TOLD(length <= forward.si() + 1e-7, text);
            }
        }
        qInfo("largest gap at the end: %.2g m, %.2g rad; %.3g times as long as without clothoids", worstM,
              worstRad, longer / 24'000);
    }

    void becomesThePlainCurveAsTheRateGrows_data() { cases(); }
    void becomesThePlainCurveAsTheRateGrows() {
        QFETCH(const Case*, method);
        std::mt19937_64 random{kSeed + 1};
        double most = 0.0;
        for (int i = 0; i < 5'000; ++i) {
            const PosePair pair = i % 2 == 0 ? swathPair(random) : randomPair(random);
            const double plain = method->plain(pair.from, pair.to, metres(pair.radiusM)).si();
            const double length =
                method->turn(pair.from, pair.to, metres(pair.radiusM), CurvatureRate::fromSi(1e9))
                    .length()
                    .si();
            // The clothoids are at most 1 / (0.5 * 1e9) m long; where circles just touch, the square root of
            // that may count.
            VERIFY_TOLD(length >= plain - 1e-9 * (1.0 + plain), told(kSeed + 1, i, pair));
            VERIFY_TOLD(length <= plain + 1e-6, told(kSeed + 1, i, pair));
            most = std::max(most, length - plain);
        }
        qInfo("longer by at most %.2g m", most);
    }

    void poseGrid_data() { cases(); }
    void poseGrid() {
        QFETCH(const Case*, method);
        for (int x = -6; x <= 6; ++x) {
            for (int y = -6; y <= 6; ++y) {
                for (int b = 0; b < 360; b += 30) {
                    const PosePair pair{pose(0, 0, 0), pose(2 * x, 2 * y, b), 3.0};
                    const Curve turn =
                        method->turn(pair.from, pair.to, metres(3.0), CurvatureRate::fromSi(0.1));
                    const Pose end = driven(turn);
                    VERIFY_TOLD(distance(end.position, pair.to.position) < 1e-6, told(0, 0, pair));
                    VERIFY_TOLD(headingGap(end, pair.to) < 1e-7, told(0, 0, pair));
                }
            }
        }
    }

    void farAndNear_data() { cases(); }
    void farAndNear() {
        QFETCH(const Case*, method);
        const Pose from = pose(0, 0, 0);
        for (const Pose& to : {pose(0, 0, 0), pose(1e-7, 0, 0), pose(0, 1e-7, 0), pose(0, 0, 1e-6),
                               pose(0, 0, 180), pose(-1e-3, 0, 0), pose(-20, 0, 0), pose(1e5, 1e4, 200),
                               pose(-1e5, 3, 0), pose(1e4, 1e-9, 0), pose(0.1, 0.1, 45)}) {
            for (const double rate : {1e-4, 0.02, 1.0, 1e6}) {
                const Curve turn = method->turn(from, to, metres(3.0), CurvatureRate::fromSi(rate));
                const Pose end = driven(turn);
                const PosePair pair{from, to, 3.0};
                VERIFY_TOLD(std::isfinite(turn.length().si()), told(0, 0, pair));
                VERIFY_TOLD(distance(end.position, to.position) < 1e-3, told(0, 0, pair));
                VERIFY_TOLD(distance(turn.end().position, to.position) < 1e-3, told(0, 0, pair));
                VERIFY_TOLD(headingGap(end, to) < 1e-6, told(0, 0, pair));
            }
        }
    }

    void rateOfAMachine() {
        MachineSpec spec;
        spec.tractor.minTurningRadius = metres(5.0);
        spec.tractor.turningSpeed = metresPerSecond(2.0);
        // Two seconds at 2 m/s to 0.2 per m: 0.2 / 4 m.
        COMPARE_WITHIN(Machine::create(spec)->maxCurvatureRate().si(), 0.05, 1e-12);
        spec.tractor.wheelbase = metres(2.5);
        spec.tractor.steeringRateRadps = 0.4;
        COMPARE_WITHIN(Machine::create(spec)->maxCurvatureRate().si(), 0.4 / (2.5 * 2.0), 1e-12);
        spec.tractor.reverseSpeed = metresPerSecond(4.0);
        COMPARE_WITHIN(Machine::create(spec)->maxCurvatureRate().si(), 0.4 / (2.5 * 4.0), 1e-12);
        spec.tractor.canReverse = false;
        COMPARE_WITHIN(Machine::create(spec)->maxCurvatureRate().si(), 0.4 / (2.5 * 2.0), 1e-12);
        QCOMPARE(kContinuousReedsSheppMethod.run(pose(0, 0, 0), pose(0, 0, 180), *Machine::create(spec)).type,
                 std::string_view{"dubins-cc"});
        spec.tractor.maxCurvatureRate = CurvatureRate::fromSi(0.123);
        QCOMPARE(Machine::create(spec)->maxCurvatureRate().si(), 0.123);
    }
};

FURROW_TEST(ContinuousCurvatureTest);
#include "tst_continuous_curvature.moc"
