// A trailed implement after a way with one curvature, against the audit's tractrix in small steps and against
// closed forms of a towed axle.

#include "planner/audit/tractrix.h"
#include "planner/geometry/curve.h"
#include "planner/turns/trailer.h"
#include "planner/units/angle.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;

double awayRad(Angle a, Angle b) {
    return std::abs(wrappedAngle(a - b).si());
}

/// The same in small steps of the hitch.
Angle inSmallSteps(const Trailer& trailer, Angle heading, Angle from, Curvature curvature, Length way,
                   int steps) {
    const CurvePiece piece{.length = metres(std::abs(way.si())),
                           .curvature = curvature,
                           .endCurvature = curvature,
                           .gear = way.si() < 0.0 ? Gear::Reverse : Gear::Forward};
    const Pose start{.position = {}, .heading = from};
    Point last = trailer.poseOf(start, heading).position;
    for (int i = 1; i <= steps; ++i) {
        const Pose pose = advanced(start, piece, piece.length * (static_cast<double>(i) / steps));
        const Point hitch = trailer.poseOf(pose, heading).position;
        heading = trailedHeading(heading, hitch - last, metres(trailer.trailingM));
        last = hitch;
    }
    return heading;
}

}  // namespace

class TestTrailer : public QObject {
    Q_OBJECT
private slots:
    void standsStill() {
        const Trailer trailer{.hitchM = -1.0, .trailingM = 5.0, .raised = {}, .lowered = {}, .wheels = {}};
        const Angle after =
            trailer.headingAfter(radians(2.0), radians(1.0), Curvature::fromSi(0.1), metres(0.0));
        QVERIFY(awayRad(after, radians(2.0)) < 1e-12);
    }

    // Huygens' tractrix: pulled at a right angle, the axle has tan(b / 2) = exp(-s / a).
    void straightOn() {
        const Trailer trailer{.hitchM = -1.0, .trailingM = 4.0, .raised = {}, .lowered = {}, .wheels = {}};
        for (const double way : {0.3, 4.0, 30.0}) {
            const Angle after =
                trailer.headingAfter(radians(1.0 - 0.5 * kPi), radians(1.0), Curvature{}, metres(way));
            const double expected = 1.0 - 2.0 * std::atan(std::exp(-way / 4.0));
            QVERIFY2(awayRad(after, radians(expected)) < 1e-12, qPrintable(QString::number(after.si())));
        }
    }

    // After a long way round, the axle's circle has the radius sqrt(R^2 + h^2 - a^2): the implement trails by
    // asin(a / sqrt(R^2 + h^2)) behind the way of the hitch.
    void longRound() {
        const Trailer trailer{.hitchM = -1.5, .trailingM = 5.0, .raised = {}, .lowered = {}, .wheels = {}};
        const double radius = 8.0;
        const double way = 1e6 * kPi;  // far enough for the exponential to be none
        const Angle after =
            trailer.headingAfter(radians(0.3), radians(0.3), Curvature::fromSi(1.0 / radius), metres(way));
        const double tractor = 0.3 + way / radius;
        const double expected = tractor - std::atan(1.5 / radius) - std::asin(5.0 / std::hypot(radius, 1.5));
        QVERIFY2(awayRad(after, radians(expected)) < 1e-8, qPrintable(QString::number(after.si())));
    }

    // Curves wider and sharper than the trailed length, and just as sharp; both gears; any begin.
    void asInSmallSteps() {
        std::mt19937 random{20261127};
        const auto between = [&](double low, double high) {
            return std::uniform_real_distribution{low, high}(random);
        };
        for (int i = 0; i < 300; ++i) {
            const Trailer trailer{.hitchM = between(-3.0, 2.0),
                                  .trailingM = between(1.0, 8.0),
                                  .raised = {},
                                  .lowered = {},
                                  .wheels = {}};
            double curvature = between(-0.4, 0.4);
            if (i % 5 == 0) {
                curvature = 0.0;
            } else if (i % 5 == 1) {
                // The hitch's circle is as small as the trailed length.
                const double square = trailer.trailingM * trailer.trailingM - trailer.hitchM * trailer.hitchM;
                curvature = square > 0.0 ? 1.0 / std::sqrt(square) : curvature;
            }
            const Angle from = radians(between(-kPi, kPi));
            const Angle heading = from + radians(between(-2.0, 2.0));
            // Backwards errors grow with exp(way / trailed length).
            const Length way = metres(between(-2.0 * trailer.trailingM, 20.0));
            const Angle expected =
                inSmallSteps(trailer, heading, from, Curvature::fromSi(curvature), way, 20000);
            const Angle after = trailer.headingAfter(heading, from, Curvature::fromSi(curvature), way);
            QVERIFY2(awayRad(after, expected) < 2e-5,
                     qPrintable(QString("%1: %2 and %3").arg(i).arg(after.si()).arg(expected.si())));
        }
    }

    // One way is its parts one after the other.
    void inParts() {
        const Trailer trailer{.hitchM = -1.0, .trailingM = 6.0, .raised = {}, .lowered = {}, .wheels = {}};
        for (const double curvature : {0.0, 0.05, -0.15, 0.25}) {
            const Curvature bend = Curvature::fromSi(curvature);
            const Angle whole = trailer.headingAfter(radians(0.2), radians(0.5), bend, metres(9.0));
            const Angle half = trailer.headingAfter(radians(0.2), radians(0.5), bend, metres(4.0));
            const Angle rest = trailer.headingAfter(half, radians(0.5 + 4.0 * curvature), bend, metres(5.0));
            QVERIFY(awayRad(whole, rest) < 1e-12);
        }
    }
};

FURROW_TEST(TestTrailer);

#include "tst_trailer.moc"
