#include "planner/geometry/curve_sampling.h"
#include "planner/turns/dubins.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <cmath>
#include <numbers>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;

Pose pose(double x, double y, double headingDeg) {
    return {.position = {x, y}, .heading = degrees(headingDeg)};
}

double distanceToSegment(Point p, Point a, Point b) {
    const Point along = b - a;
    const double share = std::clamp(dot(p - a, along) / std::max(dot(along, along), 1e-300), 0.0, 1.0);
    return distance(p, a + share * along);
}

}  // namespace

class TurnSamplingTest : public QObject {
    Q_OBJECT

private slots:
    void chordsStayWithinTheTolerance_data() {
        QTest::addColumn<double>("radiusM");
        QTest::addColumn<double>("turnedDeg");
        QTest::addColumn<double>("toleranceM");
        QTest::newRow("AgBot, half a circle") << 2.1 << 180.0 << kChordTolerance.si();
        QTest::newRow("AgBot, nearly a full circle") << 2.1 << 359.0 << kChordTolerance.si();
        QTest::newRow("wide sprayer") << 9.0 << 250.0 << kChordTolerance.si();
        QTest::newRow("a flat arc over hundreds of metres") << 1000.0 << 20.0 << kChordTolerance.si();
        QTest::newRow("very fine") << 5.0 << 90.0 << 1e-6;
        QTest::newRow("coarser than the circle is wide") << 1.0 << 200.0 << 5.0;
        QTest::newRow("to the right") << -4.0 << 120.0 << kChordTolerance.si();
    }
    void chordsStayWithinTheTolerance() {
        QFETCH(double, radiusM);
        QFETCH(double, turnedDeg);
        QFETCH(double, toleranceM);
        const double angle = degrees(turnedDeg).si();
        const Curve turn{.type = "test",
                         .start = pose(0, 0, 0),
                         .pieces = {{.length = metres(std::abs(radiusM) * angle),
                                     .curvature = Curvature::fromSi(1.0 / radiusM)}}};
        const auto samples = sampled(turn, metres(toleranceM));
        QVERIFY(samples.size() >= 2);
        // The arc begins at the origin towards +x around (0, radius): its points are known exactly.
        const Point centre{0.0, radiusM};
        double worstM = 0.0;
        for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
            COMPARE_WITHIN(distance(samples[i].pose.position, centre), std::abs(radiusM),
                           1e-9 * (1.0 + std::abs(radiusM)));
            for (int k = 1; k < 8; ++k) {
                const double way = samples[i].way.si() + (samples[i + 1].way - samples[i].way).si() * k / 8.0;
                const double a = way / std::abs(radiusM);
                const Point onArc =
                    std::abs(radiusM) * Point{std::sin(a), (radiusM > 0 ? 1.0 : -1.0) * (1.0 - std::cos(a))};
                worstM = std::max(
                    worstM, distanceToSegment(onArc, samples[i].pose.position, samples[i + 1].pose.position));
            }
        }
        QVERIFY2(worstM <= toleranceM * (1.0 + 1e-6) + 1e-12, qPrintable(QString::number(worstM)));
        // And not a great deal finer than asked for: one more chord than needed at most.
        if (toleranceM < std::abs(radiusM)) {
            const double needed = angle / (2.0 * std::acos(1.0 - toleranceM / std::abs(radiusM)));
            QVERIFY(static_cast<double>(samples.size()) <= needed + 2.0);
        }
    }

    void endsAreExact_data() {
        QTest::addColumn<Pose>("to");
        QTest::newRow("U turn") << pose(10, 0, -90);
        QTest::newRow("omega") << pose(2.5, 0, -90);
        QTest::newRow("straight on") << pose(0, 30, 90);
        QTest::newRow("already there") << pose(0, 0, 90);
    }
    void endsAreExact() {
        QFETCH(Pose, to);
        const Curve turn = dubinsTurn(pose(0, 0, 90), to, metres(2.1));
        const auto samples = sampled(turn, kChordTolerance);
        QVERIFY(samples.front().pose == turn.start);
        QCOMPARE(samples.front().way.si(), 0.0);
        COMPARE_WITHIN(samples.back().way.si(), turn.length().si(), 1e-12);
        COMPARE_WITHIN(distance(samples.back().pose.position, to.position), 0.0, 1e-9);
        COMPARE_WITHIN(std::remainder((samples.back().pose.heading - to.heading).si(), 2.0 * kPi), 0.0, 1e-9);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            QVERIFY(samples[i].way > samples[i - 1].way || turn.length() == metres(0.0));
        }
    }

    void atLeastTwoSamples() {
        QVERIFY(sampled(dubinsTurn(pose(0, 0, 0), pose(0, 0, 0), metres(2.0)), kChordTolerance).size() >= 2);
        QVERIFY(sampled(dubinsTurn(pose(0, 0, 0), pose(5, 0, 0), metres(2.0)), kChordTolerance).size() >= 2);
    }

    void everyChangeOfPieceIsASample() {
        const Curve turn = dubinsTurn(pose(0, 0, 90), pose(10, 0, -90), metres(2.1));
        QCOMPARE(turn.pieces.size(), std::size_t{3});
        const auto samples = sampled(turn, kChordTolerance);
        double way = 0.0;
        for (const CurvePiece& piece : turn.pieces) {
            const auto at = std::ranges::find_if(
                samples, [&](const CurveSample& s) { return std::abs(s.way.si() - way) < 1e-9; });
            QVERIFY(at != samples.end());
            QCOMPARE(at->curvature.si(), piece.curvature.si());
            way += piece.length.si();
        }
        QCOMPARE(samples.back().curvature.si(), turn.pieces.back().curvature.si());
    }

    void clothoidsStayWithinTheTolerance_data() {
        QTest::addColumn<double>("lengthM");
        QTest::addColumn<double>("from");
        QTest::addColumn<double>("to");
        QTest::addColumn<bool>("forward");
        QTest::newRow("into a turn") << 5.0 << 0.0 << 0.25 << true;
        QTest::newRow("out of a turn, in reverse") << 5.0 << -0.25 << 0.0 << false;
        QTest::newRow("from side to side") << 8.0 << -0.4 << 0.4 << true;
        QTest::newRow("long and flat") << 300.0 << 0.0 << 0.01 << true;
        QTest::newRow("several times round") << 40.0 << 0.1 << 0.6 << false;
    }
    void clothoidsStayWithinTheTolerance() {
        QFETCH(double, lengthM);
        QFETCH(double, from);
        QFETCH(double, to);
        QFETCH(bool, forward);
        const CurvePiece piece{.length = metres(lengthM),
                               .curvature = Curvature::fromSi(from),
                               .endCurvature = Curvature::fromSi(to),
                               .gear = forward ? Gear::Forward : Gear::Reverse};
        const Curve turn{.type = "test", .start = pose(3, 4, 50), .pieces = {piece}};
        const auto samples = sampled(turn, kChordTolerance);
        for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
            const double share = samples[i].way.si() / lengthM;
            COMPARE_WITHIN(samples[i].curvature.si(), from + share * (to - from), 1e-12);
            QCOMPARE(samples[i].gear, piece.gear);
            for (int k = 1; k < 8; ++k) {
                const Length way = samples[i].way + (samples[i + 1].way - samples[i].way) * (k / 8.0);
                const Point on = advanced(turn.start, piece, way).position;
                const double apartM =
                    distanceToSegment(on, samples[i].pose.position, samples[i + 1].pose.position);
                QVERIFY2(apartM <= kChordTolerance.si(), qPrintable(QString::number(apartM)));
            }
        }
        QCOMPARE(samples.back().curvature.si(), to);
        COMPARE_WITHIN(samples.back().way.si(), lengthM, 1e-12);
        COMPARE_WITHIN(distance(samples.back().pose.position, turn.end().position), 0.0, 1e-12);
    }

    void placesAShape() {
        // Nose to the north: what was ahead lies north, what was to the left lies west.
        const Ring moved = placed({{1.0, 0.0}, {0.0, 2.0}, {-3.0, -1.0}}, pose(10, 20, 90));
        COMPARE_WITHIN(distance(moved[0], {10.0, 21.0}), 0.0, 1e-12);
        COMPARE_WITHIN(distance(moved[1], {8.0, 20.0}), 0.0, 1e-12);
        COMPARE_WITHIN(distance(moved[2], {11.0, 17.0}), 0.0, 1e-12);
    }
};

FURROW_TEST(TurnSamplingTest);
#include "tst_turn_sampling.moc"
