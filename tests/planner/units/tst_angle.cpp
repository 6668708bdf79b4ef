#include "planner/units/angle.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <cmath>
#include <numbers>
#include <random>

using namespace furrow;

namespace {
constexpr double kTolerance = 1e-12;
}

class AngleTest : public QObject {
    Q_OBJECT

private slots:
    void poseHeadingIsInAFullCircle_data() {
        QTest::addColumn<double>("givenDeg");
        QTest::addColumn<double>("expectedDeg");
        QTest::newRow("east") << 0.0 << 0.0;
        QTest::newRow("inside") << 123.0 << 123.0;
        QTest::newRow("once round") << 360.0 << 0.0;
        QTest::newRow("clockwise") << -90.0 << 270.0;
        QTest::newRow("twice round and a quarter") << 810.0 << 90.0;
        QTest::newRow("far clockwise") << -725.0 << 355.0;
    }
    void poseHeadingIsInAFullCircle() {
        QFETCH(double, givenDeg);
        QFETCH(double, expectedDeg);
        COMPARE_WITHIN(inDegrees(normalisedPoseHeading(degrees(givenDeg))), expectedDeg, 1e-11);
    }

    void swathHeadingIsInHalfACircle_data() {
        QTest::addColumn<double>("givenDeg");
        QTest::addColumn<double>("expectedDeg");
        QTest::newRow("east") << 0.0 << 0.0;
        QTest::newRow("west is east") << 180.0 << 0.0;
        QTest::newRow("south is north") << 270.0 << 90.0;
        QTest::newRow("just below east") << -1.0 << 179.0;
        QTest::newRow("twice round") << 750.0 << 30.0;
    }
    void swathHeadingIsInHalfACircle() {
        QFETCH(double, givenDeg);
        QFETCH(double, expectedDeg);
        COMPARE_WITHIN(inDegrees(normalisedSwathHeading(degrees(givenDeg))), expectedDeg, 1e-11);
    }

    // A remainder that rounds up to the modulus itself would not be in the range.
    void rangesAreHalfOpen_data() {
        QTest::addColumn<double>("givenRad");
        QTest::newRow("the smallest number below zero") << -std::numeric_limits<double>::denorm_min();
        QTest::newRow("below zero by less than a full circle can tell") << -1e-17;
        QTest::newRow("just below a full circle") << std::nextafter(2.0 * std::numbers::pi, 0.0);
        QTest::newRow("just below half a circle") << std::nextafter(std::numbers::pi, 0.0);
        QTest::newRow("a thousand circles") << 2000.0 * std::numbers::pi;
    }
    void rangesAreHalfOpen() {
        QFETCH(double, givenRad);
        const double pose = normalisedPoseHeading(radians(givenRad)).si();
        QVERIFY(pose >= 0.0);
        QVERIFY(pose < 2.0 * std::numbers::pi);
        const double line = normalisedSwathHeading(radians(givenRad)).si();
        QVERIFY(line >= 0.0);
        QVERIFY(line < std::numbers::pi);
        const double bearing = lineBearingDeg(radians(givenRad));
        QVERIFY(bearing >= 0.0);
        QVERIFY(bearing < 180.0);
    }

    // fmod and remainder of the library are exact; shorter ways to them must give the same, to the last bit.
    void wrappingIsExact() {
        constexpr double kTurn = 2.0 * std::numbers::pi;
        std::mt19937_64 random{5};
        for (const double range : {1e-9, 1.0, 4.0, 8.0, 20.0, 1e4}) {
            std::uniform_real_distribution<double> some{-range, range};
            for (int i = 0; i < 2000; ++i) {
                const double given = some(random);
                double expected = std::fmod(given, kTurn);
                expected = expected < 0.0 ? expected + kTurn : expected;
                QCOMPARE(normalisedPoseHeading(radians(given)).si() == expected || expected == kTurn, true);
                QCOMPARE(wrappedAngle(radians(given)).si() == std::remainder(given, kTurn), true);
            }
        }
        QCOMPARE(wrappedAngle(radians(std::numbers::pi)).si(), std::remainder(std::numbers::pi, kTurn));
        QCOMPARE(normalisedPoseHeading(radians(kTurn)).si(), 0.0);
    }

    void differenceIsTheShortWayRound_data() {
        QTest::addColumn<double>("fromDeg");
        QTest::addColumn<double>("toDeg");
        QTest::addColumn<double>("expectedDeg");
        QTest::newRow("none") << 40.0 << 40.0 << 0.0;
        QTest::newRow("to the left") << 40.0 << 50.0 << 10.0;
        QTest::newRow("to the right across east") << 10.0 << 350.0 << -20.0;
        QTest::newRow("to the left across east") << 350.0 << 10.0 << 20.0;
        QTest::newRow("about face is to the left") << 0.0 << 180.0 << 180.0;
        QTest::newRow("about face from the west is to the left") << 180.0 << 0.0 << 180.0;
        QTest::newRow("several circles apart") << 0.0 << 1085.0 << 5.0;
    }
    void differenceIsTheShortWayRound() {
        QFETCH(double, fromDeg);
        QFETCH(double, toDeg);
        QFETCH(double, expectedDeg);
        COMPARE_WITHIN(inDegrees(headingDifference(degrees(fromDeg), degrees(toDeg))), expectedDeg, 1e-10);
    }

    // Bearing 0 points north, 90 east; headings count the other way round from east.
    void bearingIsClockwiseFromNorth_data() {
        QTest::addColumn<double>("headingDeg");
        QTest::addColumn<double>("bearingDeg");
        QTest::newRow("a line to the east") << 0.0 << 90.0;
        QTest::newRow("a line to the north") << 90.0 << 0.0;
        QTest::newRow("north-east") << 45.0 << 45.0;
        QTest::newRow("north-west") << 135.0 << 135.0;
        QTest::newRow("a little north of east") << 30.0 << 60.0;
        QTest::newRow("just left of north") << 91.0 << 179.0;
    }
    void bearingIsClockwiseFromNorth() {
        QFETCH(double, headingDeg);
        QFETCH(double, bearingDeg);
        COMPARE_WITHIN(lineBearingDeg(degrees(headingDeg)), bearingDeg, 1e-11);
    }

    void degreesAndRadians() {
        COMPARE_WITHIN(degrees(180.0).si(), std::numbers::pi, kTolerance);
        COMPARE_WITHIN(inDegrees(radians(std::numbers::pi / 6.0)), 30.0, kTolerance);
        COMPARE_WITHIN(inHectares(squareMetres(12'500.0)), 1.25, kTolerance);
    }
};

FURROW_TEST(AngleTest);
#include "tst_angle.moc"
