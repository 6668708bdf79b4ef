#include "planner/turns/dubins.h"
#include "planner/turns/straight_turn.h"
#include "planner/units/angle.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 20'250'101;

double positive(double angle) {
    const double rest = std::fmod(angle, 2.0 * kPi);
    return rest < 0.0 ? rest + 2.0 * kPi : rest;
}

// The oracle: the six words from circles and tangents, as one draws them with a compass.

/// The centre of the circle to the left (side 1) or right (-1) of a pose.
Point centreBeside(const Pose& pose, int side, double radiusM) {
    const double h = pose.heading.si();
    return pose.position + side * radiusM * Point{-std::sin(h), std::cos(h)};
}

/// The angle driven on a circle, from one heading to another, turning to one side only.
double turned(double fromRad, double toRad, int side) {
    return positive(side * (toRad - fromRad));
}

/// Arc, tangent, arc: the tangent's heading follows from the two centres.
double circleLineCircle(const Pose& from, const Pose& to, double radiusM, int firstSide, int lastSide) {
    const Point way = centreBeside(to, lastSide, radiusM) - centreBeside(from, firstSide, radiusM);
    const double apartM = norm(way);
    double tangentM = apartM;
    double heading = std::atan2(way.y, way.x);
    if (firstSide != lastSide) {
        // The tangent crosses between the circles: a right triangle over the centres with one leg of 2 R.
        if (apartM < 2.0 * radiusM) {
            return std::numeric_limits<double>::infinity();
        }
        tangentM = std::sqrt(apartM * apartM - 4.0 * radiusM * radiusM);
        heading += firstSide * std::asin(2.0 * radiusM / apartM);
    } else if (apartM < 1e-12) {
        heading = from.heading.si();  // one circle: any tangent will do, so leave it at once
        return radiusM * turned(from.heading.si(), to.heading.si(), firstSide);
    }
    return radiusM *
               (turned(from.heading.si(), heading, firstSide) + turned(heading, to.heading.si(), lastSide)) +
           tangentM;
}

/// Three arcs: the middle circle touches both others, so its centre is 2 R from both of their centres.
double threeCircles(const Pose& from, const Pose& to, double radiusM, int side) {
    const Point first = centreBeside(from, side, radiusM);
    const Point last = centreBeside(to, side, radiusM);
    const double apartM = distance(first, last);
    if (apartM > 4.0 * radiusM || apartM < 1e-12) {
        return std::numeric_limits<double>::infinity();
    }
    const double heightM = std::sqrt(4.0 * radiusM * radiusM - 0.25 * apartM * apartM);
    const Point along = (1.0 / apartM) * (last - first);
    double shortest = std::numeric_limits<double>::infinity();
    for (const int above : {1, -1}) {
        const Point middle = 0.5 * (first + last) + above * heightM * Point{-along.y, along.x};
        // Headings where the circles touch: across the line between their centres.
        const Point in = middle - first;
        const Point out = middle - last;
        const double headingIn = std::atan2(in.y, in.x) + side * 0.5 * kPi;
        const double headingOut = std::atan2(out.y, out.x) + side * 0.5 * kPi;
        const double length =
            radiusM * (turned(from.heading.si(), headingIn, side) + turned(headingIn, headingOut, -side) +
                       turned(headingOut, to.heading.si(), side));
        shortest = std::min(shortest, length);
    }
    return shortest;
}

double shortestByCompass(const Pose& from, const Pose& to, double radiusM) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const int first : {1, -1}) {
        for (const int last : {1, -1}) {
            shortest = std::min(shortest, circleLineCircle(from, to, radiusM, first, last));
        }
        shortest = std::min(shortest, threeCircles(from, to, radiusM, first));
    }
    return shortest;
}

/// Where one ends that drives the pieces, by rotating around each piece's centre.
Pose driven(const Curve& turn) {
    Point place = turn.start.position;
    double heading = turn.start.heading.si();
    for (const CurvePiece& piece : turn.pieces) {
        const double way = piece.length.si() * (piece.gear == Gear::Forward ? 1.0 : -1.0);
        const double k = piece.curvature.si();
        if (k == 0.0) {
            place = place + way * Point{std::cos(heading), std::sin(heading)};
        } else {
            const Point centre = place + (1.0 / k) * Point{-std::sin(heading), std::cos(heading)};
            heading += way * k;
            place = centre - (1.0 / k) * Point{-std::sin(heading), std::cos(heading)};
        }
    }
    return {place, radians(heading)};
}

Pose pose(double x, double y, double headingDeg) {
    return {.position = {x, y}, .heading = degrees(headingDeg)};
}

struct Pair {
    Pose from;
    Pose to;
    double radiusM;
};

/// Half of them near enough for three arcs to matter.
Pair randomPair(std::mt19937_64& random) {
    const double radiusM = test::uniform(random, 0.5, 12.0);
    const double reachM = radiusM * (random() % 2 == 0 ? 2.0 : 12.0);
    const auto randomPose = [&] {
        return Pose{
            .position = {test::uniform(random, -reachM, reachM), test::uniform(random, -reachM, reachM)},
            .heading = radians(test::uniform(random, 0.0, 2.0 * kPi))};
    };
    const Pose from = randomPose();
    return {from, randomPose(), radiusM};
}

QByteArray told(int i, const Pair& pair) {
    return QStringLiteral("seed %1, pair %2: (%3, %4, %5) to (%6, %7, %8), radius %9")
        .arg(kSeed)
        .arg(i)
        .arg(pair.from.position.x, 0, 'g', 17)
        .arg(pair.from.position.y, 0, 'g', 17)
        .arg(pair.from.heading.si(), 0, 'g', 17)
        .arg(pair.to.position.x, 0, 'g', 17)
        .arg(pair.to.position.y, 0, 'g', 17)
        .arg(pair.to.heading.si(), 0, 'g', 17)
        .arg(pair.radiusM, 0, 'g', 17)
        .toUtf8();
}

}  // namespace

class DubinsTest : public QObject {
    Q_OBJECT

private slots:
    void lengthsByHand_data() {
        QTest::addColumn<Pose>("from");
        QTest::addColumn<Pose>("to");
        QTest::addColumn<double>("radiusM");
        QTest::addColumn<double>("lengthM");
        const double r = 2.1;
        QTest::newRow("already there") << pose(3, 4, 30) << pose(3, 4, 30) << r << 0.0;
        QTest::newRow("straight ahead") << pose(0, 0, 0) << pose(17.5, 0, 0) << r << 17.5;
        QTest::newRow("straight ahead at an angle")
            << pose(1, 1, 45) << pose(4, 4, 45) << r << 3.0 * std::sqrt(2.0);
        QTest::newRow("quarter turn to the left") << pose(0, 0, 0) << pose(r, r, 90) << r << 0.5 * kPi * r;
        QTest::newRow("quarter turn to the right") << pose(0, 0, 0) << pose(r, -r, -90) << r << 0.5 * kPi * r;
        QTest::newRow("three quarters on one circle")
            << pose(0, 0, 0) << pose(-r, r, 270) << r << 1.5 * kPi * r;
        QTest::newRow("run-out and quarter turn")
            << pose(0, 0, 0) << pose(r + 5, r, 90) << r << 5.0 + 0.5 * kPi * r;
        QTest::newRow("U turn of exactly two radii")
            << pose(0, 0, 90) << pose(-2 * r, 0, -90) << r << kPi * r;
        QTest::newRow("U turn of exactly two radii to the right")
            << pose(0, 0, 90) << pose(2 * r, 0, -90) << r << kPi * r;
        QTest::newRow("U turn with a straight piece")
            << pose(0, 0, 90) << pose(10, 0, -90) << r << kPi * r + 10.0 - 2.0 * r;
        QTest::newRow("U turn with swath ends 3 m apart along the heading")
            << pose(0, 0, 90) << pose(2 * r, 3, -90) << r << kPi * r + 3.0;
        // S curve between parallel lines 2 R apart and 2 R on: two quarter circles.
        QTest::newRow("two quarter circles as an S")
            << pose(0, 0, 0) << pose(2 * r, 2 * r, 0) << r << kPi * r;
        // Turning round on the spot: the outer arcs' circles meet the middle one in an equilateral triangle
        // of 2 R: pi/3 + 5 pi/3 + pi/3 = 7 pi/3.
        QTest::newRow("about face on the spot")
            << pose(0, 0, 0) << pose(0, 0, 180) << r << 7.0 / 3.0 * kPi * r;
        // Omega: the outer circles' centres lie at -R and w + R, 2 R + w apart; the middle one's is 2 R from
        // both, so with cos a = (2 R + w) / 4 R the outer arcs turn a each and the middle one pi + 2 a.
        for (const double w : {0.5, 1.25, 2.5, 4.0}) {
            const double a = std::acos((2.0 * r + w) / (4.0 * r));
            QTest::addRow("omega between swaths %g m apart, to the right", w)
                << pose(0, 0, 90) << pose(w, 0, -90) << r << r * (kPi + 4.0 * a);
            QTest::addRow("omega between swaths %g m apart, to the left", w)
                << pose(0, 0, 90) << pose(-w, 0, -90) << r << r * (kPi + 4.0 * a);
        }
        // Behind, the same heading, far away: a half circle, the line back, another half circle; the two
        // centres lie beside the poses, so that the line is as long as they are apart.
        QTest::newRow("to a place behind") << pose(0, 0, 0) << pose(-50, 0, 0) << r << 2.0 * kPi * r + 50.0;
        QTest::newRow("far from the origin")
            << pose(5e4, -5e4, 90) << pose(5e4 + 10, -5e4, -90) << r << kPi * r + 10.0 - 2.0 * r;
        QTest::newRow("headings several circles off")
            << pose(0, 0, 450) << pose(10, 0, 630) << r << kPi * r + 10.0 - 2.0 * r;
    }
    void lengthsByHand() {
        QFETCH(Pose, from);
        QFETCH(Pose, to);
        QFETCH(double, radiusM);
        QFETCH(double, lengthM);
        COMPARE_WITHIN(dubinsLength(from, to, metres(radiusM)).si(), lengthM, 1e-6);
        const Curve turn = dubinsTurn(from, to, metres(radiusM));
        COMPARE_WITHIN(turn.length().si(), lengthM, 1e-6);
        const Pose end = driven(turn);
        COMPARE_WITHIN(distance(end.position, to.position), 0.0, 1e-6);
        COMPARE_WITHIN(std::remainder(end.heading.si() - to.heading.si(), 2.0 * kPi), 0.0, 1e-6);
        QVERIFY(turn.start == from);
        QCOMPARE(turn.type, std::string_view{"dubins"});
    }

    void arrives() {
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 20'000; ++i) {
            const Pair pair = randomPair(random);
            const Curve turn = dubinsTurn(pair.from, pair.to, metres(pair.radiusM));
            const Pose end = driven(turn);
            VERIFY_TOLD(distance(end.position, pair.to.position) < 1e-6, told(i, pair));
            VERIFY_TOLD(std::abs(std::remainder(end.heading.si() - pair.to.heading.si(), 2.0 * kPi)) < 1e-6,
                        told(i, pair));
            // The planner's own way of driving pieces ends at the same place.
            VERIFY_TOLD(distance(turn.end().position, end.position) < 1e-9 * (1.0 + 100.0 * pair.radiusM),
                        told(i, pair));
            VERIFY_TOLD(std::abs(headingDifference(turn.end().heading, end.heading).si()) < 1e-9,
                        told(i, pair));
        }
    }

    void piecesAreForwardAndWithinTheRadius() {
        std::mt19937_64 random{kSeed + 1};
        for (int i = 0; i < 20'000; ++i) {
            const Pair pair = randomPair(random);
            const Curve turn = dubinsTurn(pair.from, pair.to, metres(pair.radiusM));
            VERIFY_TOLD(turn.pieces.size() <= 3, told(i, pair));
            for (const CurvePiece& piece : turn.pieces) {
                VERIFY_TOLD(piece.gear == Gear::Forward && piece.length.si() > 0.0, told(i, pair));
                VERIFY_TOLD(std::abs(piece.curvature.si()) <= 1.0 / pair.radiusM, told(i, pair));
                VERIFY_TOLD(piece.curvature.si() == 0.0 || piece.length.si() < 2.0 * kPi * pair.radiusM,
                            told(i, pair));
            }
            VERIFY_TOLD(
                std::abs((turn.length() - dubinsLength(pair.from, pair.to, metres(pair.radiusM))).si()) <
                    1e-9,
                told(i, pair));
        }
    }

    void nothingIsShorter() {
        std::mt19937_64 random{kSeed + 2};
        for (int i = 0; i < 20'000; ++i) {
            const Pair pair = randomPair(random);
            const double ours = dubinsLength(pair.from, pair.to, metres(pair.radiusM)).si();
            VERIFY_TOLD(ours >= distance(pair.from.position, pair.to.position) - 1e-9, told(i, pair));
            const double compass = shortestByCompass(pair.from, pair.to, pair.radiusM);
            VERIFY_TOLD(std::abs(ours - compass) < 1e-6, told(i, pair) + QStringLiteral(": %1, by compass %2")
                                                                             .arg(ours, 0, 'g', 15)
                                                                             .arg(compass, 0, 'g', 15)
                                                                             .toUtf8());
        }
    }

    // The plane of the poses on a grid: exact angles and distances are where words meet and roundings bite.
    void nothingIsShorterOnAGrid() {
        const double r = 2.0;
        int checked = 0;
        for (int x = -8; x <= 8; ++x) {
            for (int y = -8; y <= 8; ++y) {
                for (int a = 0; a < 360; a += 45) {
                    for (int b = 0; b < 360; b += 45) {
                        const Pair pair{pose(0, 0, a), pose(x, y, b), r};
                        const Curve turn = dubinsTurn(pair.from, pair.to, metres(r));
                        const Pose end = driven(turn);
                        VERIFY_TOLD(distance(end.position, pair.to.position) < 1e-6, told(checked, pair));
                        // The compass takes exact fits of 0 for full circles now and then: never shorter than
                        // ours.
                        const double ours = turn.length().si();
                        VERIFY_TOLD(ours <= shortestByCompass(pair.from, pair.to, r) + 1e-6,
                                    told(checked, pair));
                        ++checked;
                    }
                }
            }
        }
        QCOMPARE(checked, 17 * 17 * 64);
    }

    void driveBackIsAsLong() {
        std::mt19937_64 random{kSeed + 3};
        for (int i = 0; i < 20'000; ++i) {
            const Pair pair = randomPair(random);
            const Length radius = metres(pair.radiusM);
            const Length there = dubinsLength(pair.from, pair.to, radius);
            const Pose back{.position = pair.to.position, .heading = pair.to.heading + radians(kPi)};
            const Pose home{.position = pair.from.position, .heading = pair.from.heading + radians(kPi)};
            VERIFY_TOLD(std::abs((there - dubinsLength(back, home, radius)).si()) < 1e-9 * (1.0 + there.si()),
                        told(i, pair));
            // And so is the mirror image.
            const auto mirrored = [](const Pose& p) {
                return Pose{.position = {p.position.x, -p.position.y}, .heading = -p.heading};
            };
            VERIFY_TOLD(
                std::abs((there - dubinsLength(mirrored(pair.from), mirrored(pair.to), radius)).si()) <
                    1e-9 * (1.0 + there.si()),
                told(i, pair));
        }
    }

    void straightTurnJumps() {
        const Curve turn = straightTurn(pose(0, 0, 90), pose(3, 4, -90));
        COMPARE_WITHIN(turn.length().si(), 5.0, 1e-12);
        COMPARE_WITHIN(turn.start.heading.si(), std::atan2(4.0, 3.0), 1e-12);
        COMPARE_WITHIN(distance(turn.end().position, {3.0, 4.0}), 0.0, 1e-12);
        QCOMPARE(turn.type, std::string_view{"straight"});
        COMPARE_WITHIN(straightTurn(pose(1, 1, 0), pose(1, 1, 180)).length().si(), 0.0, 1e-12);
    }

    void advancesExactly_data() {
        QTest::addColumn<double>("curvature");
        QTest::addColumn<bool>("forward");
        QTest::addColumn<double>("wayM");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("headingDeg");
        QTest::newRow("straight on") << 0.0 << true << 7.0 << 7.0 << 0.0 << 0.0;
        QTest::newRow("straight back") << 0.0 << false << 7.0 << -7.0 << 0.0 << 0.0;
        QTest::newRow("quarter to the left") << 0.5 << true << kPi << 2.0 << 2.0 << 90.0;
        QTest::newRow("quarter to the right") << -0.5 << true << kPi << 2.0 << -2.0 << 270.0;
        QTest::newRow("backwards with the wheel to the left") << 0.5 << false << kPi << -2.0 << 2.0 << 270.0;
        QTest::newRow("half a circle") << 0.25 << true << 4.0 * kPi << 0.0 << 8.0 << 180.0;
        QTest::newRow("almost straight") << 1e-12 << true << 100.0 << 100.0 << 5e-9 << 0.0;
    }
    void advancesExactly() {
        QFETCH(double, curvature);
        QFETCH(bool, forward);
        QFETCH(double, wayM);
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, headingDeg);
        const CurvePiece piece{.length = metres(wayM),
                               .curvature = Curvature::fromSi(curvature),
                               .gear = forward ? Gear::Forward : Gear::Reverse};
        const Pose end = advanced(pose(0, 0, 0), piece, metres(wayM));
        COMPARE_WITHIN(end.position.x, x, 1e-12 * (1.0 + wayM));
        COMPARE_WITHIN(end.position.y, y, 1e-12 * (1.0 + wayM));
        COMPARE_WITHIN(inDegrees(end.heading), headingDeg, 1e-7);
    }
};

FURROW_TEST(DubinsTest);
#include "tst_dubins.moc"
