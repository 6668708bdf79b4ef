#include "planner/geometry/eased_line.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;

CurvePiece piece(double lengthM, double curvature, Gear gear = Gear::Forward) {
    return {.length = metres(lengthM),
            .curvature = Curvature::fromSi(curvature),
            .endCurvature = Curvature::fromSi(curvature),
            .gear = gear};
}

EasedLine easedBy(const Curve& line, double windowM, double sharpest) {
    const std::array fromM{0.0};
    const std::array mostM{windowM};
    return eased({&line, 1}, {fromM, mostM, line.length().si()}, Curvature::fromSi(sharpest));
}

Curve curveOf(const EasedLine& line) {
    Curve curve{.type = {}, .start = line.pieces.front().start, .pieces = {}};
    for (const EasedPiece& each : line.pieces) {
        curve.pieces.push_back(each.piece);
    }
    return curve;
}

/// The nearest that a line comes to a place.
double nearestM(const Curve& line, Point place) {
    double nearest = 1e9;
    Pose pose = line.start;
    for (const CurvePiece& each : line.pieces) {
        for (int i = 0; i <= 50; ++i) {
            nearest =
                std::min(nearest, distance(place, advanced(pose, each, (i / 50.0) * each.length).position));
        }
        pose = advanced(pose, each, each.length);
    }
    return nearest;
}

/// Straights and arcs of 5 m radius and more, with both ends straight.
Curve randomLine(std::mt19937& random, bool reverses) {
    std::uniform_real_distribution<double> lengths{0.3, 15.0};
    std::uniform_real_distribution<double> bends{-0.2, 0.2};
    std::bernoulli_distribution straight{0.4};
    std::bernoulli_distribution back{reverses ? 0.2 : 0.0};
    Curve line{.type = {}, .start = {{3.0, -2.0}, radians(1.0)}, .pieces = {piece(20.0, 0.0)}};
    Gear gear = Gear::Forward;
    for (int i = 0; i < 12; ++i) {
        if (back(random)) {
            gear = gear == Gear::Forward ? Gear::Reverse : Gear::Forward;
        }
        line.pieces.push_back(piece(lengths(random), straight(random) ? 0.0 : bends(random), gear));
    }
    line.pieces.push_back(piece(20.0, 0.0, gear));
    return line;
}

}  // namespace

class EasedLineTest : public QObject {
    Q_OBJECT

private slots:
    /// A quarter circle of 10 m radius between straights, the curvature averaged over 4 m. Clothoids of 4 m
    /// and 0.2 rad at both ends: the arc between has moved by 4² / 240 m = 0.0667 m from both straights
    /// (0.0666 exactly), so its middle has moved by sqrt(2) of that from the corner of the straights, (30,
    /// 0).
    void aCornerIsTwoClothoidsAndAnArc() {
        const Curve line{.type = {},
                         .start = {{0.0, 0.0}, {}},
                         .pieces = {piece(20.0, 0.0), piece(5.0 * kPi, 0.1), piece(20.0, 0.0)}};
        const EasedLine result = easedBy(line, 4.0, 0.1);
        QVERIFY(result.failed.empty());
        QCOMPARE(result.bends.size(), 1U);
        const Curve made = curveOf(result);
        QVERIFY(distance(made.end().position, {30.0, 30.0}) < 1e-6);
        QVERIFY(std::abs(made.end().heading.si() - 0.5 * kPi) < 1e-8);
        const Point corner{30.0, 0.0};
        COMPARE_WITHIN(nearestM(made, corner) - 10.0 * (std::numbers::sqrt2 - 1.0),
                       std::numbers::sqrt2 * 16.0 / 240.0, 2e-3);
        double turnedRad = 0.0;
        for (const EasedPiece& each : result.pieces) {
            const CurvePiece& made1 = each.piece;
            turnedRad += 0.5 * (made1.curvature + made1.endCurvature).si() * made1.length.si();
            QVERIFY(std::abs((made1.endCurvature - made1.curvature).si()) <=
                    1.02 * 0.1 / 4.0 * made1.length.si() + 1e-12);
        }
        COMPARE_WITHIN(turnedRad, 0.5 * kPi, 1e-9);
    }

    /// A half circle needs more room than two radii with a curvature that changes gradually, and there is
    /// none: the line stays, and says so.
    void aHalfCircleOnFullLockStays() {
        const Curve line{.type = {},
                         .start = {{0.0, 0.0}, {}},
                         .pieces = {piece(20.0, 0.0), piece(10.0 * kPi, 0.1), piece(20.0, 0.0)}};
        const EasedLine tight = easedBy(line, 4.0, 0.1);
        QCOMPARE(tight.failed.size(), 1U);
        QVERIFY(distance(curveOf(tight).end().position, {0.0, 20.0}) < 1e-6);
        // With 2 % of curvature to spare it is possible.
        const EasedLine free = easedBy(line, 4.0, 0.102);
        QVERIFY(free.failed.empty());
        QVERIFY(distance(curveOf(free).end().position, {0.0, 20.0}) < 1e-6);
    }

    void anArcStays() {
        const Curve line{.type = {}, .start = {{0.0, 0.0}, {}}, .pieces = {piece(60.0, 0.1)}};
        const EasedLine result = easedBy(line, 3.0, 0.1);
        QVERIFY(result.failed.empty());
        for (const EasedPiece& each : result.pieces) {
            COMPARE_WITHIN(each.piece.curvature.si(), 0.1, 1e-9);
        }
    }

    void withoutAWindowNothingChanges() {
        std::mt19937 random{7};
        const Curve line = randomLine(random, true);
        const EasedLine result = easedBy(line, 0.0, 0.2);
        QVERIFY(result.failed.empty() && result.bends.empty());
        QVERIFY(distance(curveOf(result).end().position, line.end().position) < 1e-9);
        COMPARE_WITHIN(curveOf(result).length().si(), line.length().si(), 1e-9);
    }

    void gradually_data() {
        QTest::addColumn<bool>("reverses");
        QTest::addColumn<double>("windowM");
        for (const double windowM : {0.7, 2.0, 3.5}) {
            QTest::addRow("forwards, %.1f m", windowM) << false << windowM;
            QTest::addRow("with changes of gear, %.1f m", windowM) << true << windowM;
        }
    }
    /// 100 lines: the same ends, no sharper bend, no jump within an eased bend, near the line.
    void gradually() {
        QFETCH(bool, reverses);
        QFETCH(double, windowM);
        std::mt19937 random{20};
        int failed = 0;
        for (int i = 0; i < 100; ++i) {
            const Curve line = randomLine(random, reverses);
            const EasedLine result = easedBy(line, windowM, 0.21);
            failed += result.failed.empty() ? 0 : 1;
            const QByteArray told = QByteArray::number(i);
            VERIFY_TOLD(distance(result.pieces.front().start.position, line.start.position) < 1e-9, told);
            // Bends that failed end where they did, each on its own.
            const EasedPiece& last = result.pieces.back();
            const Pose end = advanced(last.start, last.piece, last.piece.length);
            VERIFY_TOLD(distance(end.position, line.end().position) < 1e-5, told);
            const auto isFailed = [&](double m) {
                return std::ranges::any_of(result.failed, [m](const LineRange& range) {
                    return m >= range.fromM - 1e-6 && m <= range.toM + 1e-6;
                });
            };
            for (std::size_t k = 0; k < result.pieces.size(); ++k) {
                const EasedPiece& each = result.pieces[k];
                VERIFY_TOLD(std::abs(each.piece.curvature.si()) <= 0.21 + 1e-12, told);
                VERIFY_TOLD(std::abs(each.piece.endCurvature.si()) <= 0.21 + 1e-12, told);
                if (k > 0 && !isFailed(each.fromM)) {
                    VERIFY_TOLD(
                        std::abs((each.piece.curvature - result.pieces[k - 1].piece.endCurvature).si()) <
                            1e-9,
                        told);
                }
                if (!reverses && !isFailed(each.fromM)) {
                    const double asideM = std::abs(
                        cross(direction(each.was.heading.si()), each.start.position - each.was.position));
                    VERIFY_TOLD(asideM < 0.05 + 0.03 * windowM * windowM, told);
                }
            }
        }
        // Lines at random may turn through half circles without room.
        QVERIFY2(failed <= (reverses ? 25 : 10), QByteArray::number(failed));
    }
};

FURROW_TEST(EasedLineTest);
#include "tst_eased_line.moc"
