#include "planner/geometry/curve_parts.h"
#include "planner/geometry/curve_sampling.h"
#include "planner/swaths/guide_curve.h"
#include "planner/swaths/guide_line.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;

Polyline pointsOf(const GuideLine& line, double chordM = 0.001) {
    Polyline points;
    for (const CurveSample& sample : sampled(drivable(line), metres(chordM))) {
        points.push_back(sample.pose.position);
    }
    return points;
}

double toLine(Point point, const Polyline& line) {
    double nearest = 1e12;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const Point way = line[i + 1] - line[i];
        const double share = std::clamp(dot(point - line[i], way) / std::max(dot(way, way), 1e-12), 0.0, 1.0);
        nearest = std::min(nearest, distance(point, line[i] + share * way));
    }
    return nearest;
}

/// East to the corner at the origin, then north.
const Polyline kRightAngle{{-200.0, 0.0}, {0.0, 0.0}, {0.0, 200.0}};

/// East along y = 0, round half a circle of 25 m to the left, back along y = 50.
GuideLine hairpin() {
    return {.start = {.position = {-200.0, 0.0}, .heading = {}},
            .pieces = {{.lengthM = 200.0}, {.lengthM = 25.0 * kPi, .turnRad = kPi}, {.lengthM = 200.0}}};
}

}  // namespace

class GuideLineTest : public QObject {
    Q_OBJECT

private slots:
    // A parallel of an arc is an arc about the same centre.
    void parallelsOfAnArcAreConcentric_data() {
        QTest::addColumn<double>("leftM");
        QTest::addColumn<double>("radiusM");
        QTest::newRow("towards the centre") << 30.0 << 70.0;
        QTest::newRow("close to the centre") << 94.0 << 6.0;
        QTest::newRow("away from the centre") << -30.0 << 130.0;
        QTest::newRow("on the line") << 0.0 << 100.0;
    }
    void parallelsOfAnArcAreConcentric() {
        QFETCH(double, leftM);
        QFETCH(double, radiusM);
        const GuideLine arc{.start = {.position = {100.0, 0.0}, .heading = degrees(90.0)},
                            .pieces = {{.lengthM = 50.0 * kPi, .turnRad = 0.5 * kPi}}};
        const auto lines = ParallelLines{arc}.at(leftM, metres(6.0));
        QCOMPARE(lines.size(), std::size_t{1});
        for (const Point& point : pointsOf(lines.front())) {
            COMPARE_WITHIN(norm(point), radiusM, 0.0011);
        }
        COMPARE_WITHIN(drivable(lines.front()).length().si(), 0.5 * kPi * radiusM, 1e-6);
    }

    void nothingIsLeftWhereTheArcIsTighter() {
        const GuideLine arc{.start = {.position = {100.0, 0.0}, .heading = degrees(90.0)},
                            .pieces = {{.lengthM = 50.0 * kPi, .turnRad = 0.5 * kPi}}};
        QVERIFY(ParallelLines{arc}.at(96.0, metres(6.0)).empty());
    }

    // The arc is tangent to both sides; its centre lies the radius inside of both.
    void cornersAreRoundedWithTheRadius() {
        const auto guide = guideCurve(kRightAngle, metres(6.0), metres(0.0), "swaths.line");
        VERIFY_RESULT(guide);
        const Curve line = drivable(*guide);
        QCOMPARE(line.pieces.size(), std::size_t{3});
        COMPARE_WITHIN(line.pieces[0].length.si(), 194.0, 1e-4);
        COMPARE_WITHIN(line.pieces[1].curvature.si(), 1.0 / 6.0, 1e-9);
        COMPARE_WITHIN(line.pieces[1].length.si(), 3.0 * kPi, 1e-4);
        COMPARE_WITHIN(distance(line.end().position, {0.0, 200.0}), 0.0, 1e-4);
    }

    // Inside of a right angle every parallel has the same arc, 10 m to the west and to the north; outside
    // they grow.
    void parallelsOfARightAngle() {
        const auto guide = guideCurve(kRightAngle, metres(6.0), metres(0.0), "swaths.line");
        VERIFY_RESULT(guide);
        const ParallelLines parallels{*guide};
        const auto inside = parallels.at(10.0, metres(6.0));
        QCOMPARE(inside.size(), std::size_t{1});
        const Curve line = drivable(inside.front());
        QCOMPARE(line.pieces.size(), std::size_t{3});
        COMPARE_WITHIN(line.pieces[0].length.si(), 184.0, 1e-3);
        COMPARE_WITHIN(1.0 / line.pieces[1].curvature.si(), 6.0, 1e-6);
        COMPARE_WITHIN(distance(line.end().position, {-10.0, 200.0}), 0.0, 1e-3);
        const auto outside = parallels.at(-10.0, metres(6.0));
        QCOMPARE(outside.size(), std::size_t{1});
        COMPARE_WITHIN(1.0 / drivable(outside.front()).pieces[1].curvature.si(), 16.0, 1e-6);
    }

    // Inside of the hairpin a bend of 5 m is tighter than 6 m: each leg ends where it begins. Nothing is left
    // from the middle on.
    void hairpinsAreCutInTwo() {
        const ParallelLines parallels{hairpin()};
        const auto followed = parallels.at(19.0, metres(6.0));
        QCOMPARE(followed.size(), std::size_t{1});
        COMPARE_WITHIN(1.0 / sharpestBend(drivable(followed.front())).si(), 6.0, 1e-9);
        const auto cut = parallels.at(20.0, metres(6.0));
        QCOMPARE(cut.size(), std::size_t{2});
        for (const GuideLine& leg : cut) {
            COMPARE_WITHIN(drivable(leg).length().si(), 200.0, 1e-6);
        }
        COMPARE_WITHIN(distance(drivable(cut[0]).end().position, {0.0, 20.0}), 0.0, 1e-6);
        COMPARE_WITHIN(distance(cut[1].start.position, {0.0, 30.0}), 0.0, 1e-6);
        QVERIFY(parallels.at(25.5, metres(6.0)).empty());
        COMPARE_WITHIN(1.0 / sharpestBend(drivable(parallels.at(-20.0, metres(6.0)).front())).si(), 45.0,
                       1e-6);
    }

    void leftIsPositive() {
        const ParallelLines parallels{hairpin()};
        COMPARE_WITHIN(parallels.leftOf({-100.0, 7.0}), 7.0, 1e-9);
        COMPARE_WITHIN(parallels.leftOf({-100.0, -7.0}), -7.0, 1e-9);
        COMPARE_WITHIN(parallels.leftOf({10.0, 25.0}), 15.0, 1e-9);
        COMPARE_WITHIN(parallels.leftOf({40.0, 25.0}), -15.0, 1e-9);
    }

    // Points of a circle become arcs of about its radius, not corners: within 15 cm of it.
    void chordsBecomeArcsAgain() {
        Polyline chords;
        for (int i = 0; i <= 45; ++i) {
            chords.push_back(200.0 * direction(2.0 * i * kPi / 180.0));
        }
        const auto guide = guideCurve(chords, metres(6.0), metres(0.0), "swaths.line");
        VERIFY_RESULT(guide);
        for (const Point& point : pointsOf(*guide)) {
            COMPARE_WITHIN(norm(point), 200.0, 0.15);
        }
        QVERIFY2(sharpestBend(drivable(*guide)).si() < 1.0 / 100.0,
                 qPrintable(QString::number(sharpestBend(drivable(*guide)).si())));
    }

    void refusesCurvesThatCannotBeFollowed_data() {
        QTest::addColumn<QList<double>>("coordinates");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("one point") << QList<double>{5.0, 5.0} << ErrorCode::Usage;
        QTest::newRow("one point twice") << QList<double>{5.0, 5.0, 5.0, 5.001} << ErrorCode::Usage;
        QTest::newRow("an eight") << QList<double>{0.0, 0.0, 100.0, 100.0, 100.0, 0.0, 0.0, 100.0}
                                  << ErrorCode::InputRefused;
        QTest::newRow("there and back")
            << QList<double>{0.0, 0.0, 100.0, 0.0, 0.0, 1.0} << ErrorCode::InputRefused;
    }
    void refusesCurvesThatCannotBeFollowed() {
        QFETCH(QList<double>, coordinates);
        QFETCH(ErrorCode, code);
        Polyline points;
        for (qsizetype i = 0; i + 1 < coordinates.size(); i += 2) {
            points.push_back({coordinates[i], coordinates[i + 1]});
        }
        const auto guide = guideCurve(points, metres(6.0), metres(500.0), "swaths.line");
        QVERIFY(!guide);
        QCOMPARE(guide.error().code, code);
        QCOMPARE(guide.error().where, std::string{"swaths.line"});
    }

    // Over random curves, zigzags among them: no bend tighter than the radius, no point of a parallel nearer
    // to the curve than its distance, and no two parallels that are whole nearer to each other than the
    // difference.
    void parallelsKeepTheirDistance() {
        constexpr double kRadiusM = 6.0;
        constexpr double kSpacingM = 3.0;
        std::mt19937_64 random{20261};
        int measured = 0;
        int cut = 0;
        for (int round = 0; round < 60; ++round) {
            Polyline points{{0.0, 0.0}};
            double headingRad = 0.0;
            for (int i = 0; i < 12; ++i) {
                headingRad = std::clamp(headingRad + test::uniform(random, -1.0, 1.0), -1.5, 1.5);
                points.push_back(points.back() + test::uniform(random, 5.0, 40.0) * direction(headingRad));
            }
            const auto guide = guideCurve(points, metres(kRadiusM), metres(300.0), "swaths.line");
            VERIFY_RESULT(guide);
            const ParallelLines parallels{*guide};
            const Polyline reference = pointsOf(*guide);
            Polyline before;
            for (int k = -20; k <= 20; ++k) {
                const std::vector<GuideLine> lines = parallels.at(k * kSpacingM, metres(kRadiusM));
                Polyline here;
                for (const GuideLine& line : lines) {
                    const Curve way = drivable(line);
                    const QByteArray told =
                        "round " + QByteArray::number(round) + ", parallel " + QByteArray::number(k);
                    VERIFY_TOLD(sharpestBend(way).si() <= (1.0 + 1e-5) / kRadiusM, told);
                    for (const CurveSample& sample : sampled(way, metres(0.004))) {
                        const Point point = sample.pose.position;
                        here.push_back(point);
                        VERIFY_TOLD(toLine(point, reference) > std::abs(k) * kSpacingM - 0.01, told);
                        if (!before.empty() && lines.size() == 1) {
                            VERIFY_TOLD(toLine(point, before) > kSpacingM - 0.01, told);
                            ++measured;
                        }
                    }
                }
                // Where one is cut in two its ends reach farther into the bend than the rounding beside it.
                before = lines.size() == 1 ? here : Polyline{};
                cut += lines.size() == 1 ? 0 : 1;
            }
        }
        QVERIFY2(cut < 60 * 41 / 4, qPrintable(QString::number(cut)));
        QVERIFY(measured > 10000);
    }
};

FURROW_TEST(GuideLineTest);
#include "tst_guide_line.moc"
