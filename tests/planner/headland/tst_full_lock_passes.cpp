// Passes round a tip on full lock, for what cannot reverse: against what an arc of the outer end leaves of a
// corner, worked by hand, and against GEOS.

#include "planner/geometry/geos_bridge.h"
#include "planner/headland/full_lock_passes.h"
#include "planner/machine/machine_library.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>
#include <stop_token>

using namespace furrow;

namespace {

/// 24 m wide; its boom trails 5.2 m behind a hitch 1 m behind the axle.
const Machine& sprayer() {
    static const Machine machine = findMachine("trailed-sprayer").value();
    return machine;
}

// On full lock, 7 m, the boom's middle follows on sqrt(7² + 1² - 5.2²) = 4.79 m.
const double kOuterM = 12.0 + std::sqrt(7.0 * 7.0 + 1.0 - 5.2 * 5.2);
// The rounding of a headland pass: the boom's end is 12 m outside of what the tractor drives.
constexpr double kRoundedM = 12.0 + 7.0;

constexpr auto kThere = [](const Curve&) { return PassAccess::There; };
constexpr auto kNoneRefused = [](const Curve&) { return false; };

/// Two sides of 200 m from a tip at the origin, one along the x axis.
MultiPolygon tipOf(double angleRad) {
    return {
        {.outer = {{0.0, 0.0}, {200.0, 0.0}, 200.0 * direction(0.5 * angleRad), 200.0 * direction(angleRad)},
         .holes = {}}};
}

/// What an arc of a radius that touches both sides leaves of a tip.
double leftBeyondArcM2(double angleRad, double radiusM) {
    const double half = 0.5 * angleRad;
    return radiusM * radiusM * (1.0 / std::tan(half) - (0.5 * std::numbers::pi - half));
}

/// The same as a polygon.
MultiPolygon leftBeyondArc(double angleRad, double radiusM) {
    const double half = 0.5 * angleRad;
    const Point middle = (radiusM / std::sin(half)) * direction(half);
    Ring ring{{0.0, 0.0}};
    // From one side to the other along the arc, by a tenth of a degree.
    const double turned = std::numbers::pi - angleRad;
    const int steps = static_cast<int>(turned * 1800.0 / std::numbers::pi);
    for (int i = 0; i <= steps; ++i) {
        ring.push_back(middle + radiusM * direction(-0.5 * std::numbers::pi - turned * i / steps));
    }
    return {{.outer = std::move(ring), .holes = {}}};
}

double outsideM2(const MultiPolygon& part, const MultiPolygon& whole) {
    return area(difference(part, whole, {}).value()).si();
}

}  // namespace

class FullLockPassesTest : public QObject {
    Q_OBJECT

private slots:
    void tips_data() {
        QTest::addColumn<double>("angleDeg");
        for (const double angleDeg : {25.0, 30.0, 45.0, 60.0}) {
            QTest::addRow("%.0f degrees", angleDeg) << angleDeg;
        }
    }
    /// Beyond what a rounded pass reaches lies land that no sharper arc than that of the outer end on full
    /// lock does.
    void tips() {
        QFETCH(double, angleDeg);
        const double angle = angleDeg * std::numbers::pi / 180.0;
        const MultiPolygon tip = tipOf(angle);
        const MultiPolygon left = leftBeyondArc(angle, kRoundedM);
        const double leftM2 = leftBeyondArcM2(angle, kRoundedM);
        COMPARE_WITHIN(area(left).si(), leftM2, 0.01 * leftM2);

        const Rig lowered{tip, sprayer(), ImplementAt::Lowered};
        auto passes = FullLockPasses::of(tip, lowered, kThere, {});
        VERIFY_RESULT(passes);
        const auto pass = passes->over(left.front(), kNoneRefused, {});
        QVERIFY(pass.has_value());
        const double restM2 = outsideM2(left, pass->worked);
        const double leastM2 = leftBeyondArcM2(angle, kOuterM);
        // Of what can be gained at least two thirds.
        const QByteArray said =
            QStringLiteral("%1 of %2, %3 at least").arg(restM2).arg(leftM2).arg(leastM2).toUtf8();
        QVERIFY2(restM2 >= leastM2 - 0.01 * leftM2, said);
        QVERIFY2(restM2 <= leastM2 + 0.33 * (leftM2 - leastM2), said);

        // Inside all the way, in line at both ends, one bend of 7 m.
        QCOMPARE_LT(outsideM2(pass->worked, tip), 0.05);
        QVERIFY(lowered.driven(Rig::inLine(pass->line.start), pass->line).has_value());
        QCOMPARE(pass->line.pieces.size(), std::size_t{3});
        QVERIFY(pass->line.pieces[0].curvature == Curvature{} && pass->line.pieces[0].length >= metres(5.2));
        COMPARE_WITHIN(std::abs(pass->line.pieces[1].curvature.si()), 1.0 / 7.0, 1e-12);
        QVERIFY(pass->line.pieces[2].curvature == Curvature{} &&
                pass->line.pieces[2].length >= metres(2.0 * 5.2));
    }

    /// 17 m² of a right angle could be gained by some 60 m of way.
    void notWorthIt() {
        const double angle = 0.5 * std::numbers::pi;
        const MultiPolygon tip = tipOf(angle);
        const Rig lowered{tip, sprayer(), ImplementAt::Lowered};
        auto passes = FullLockPasses::of(tip, lowered, kThere, {}).value();
        QVERIFY(!passes.over(leftBeyondArc(angle, kRoundedM).front(), kNoneRefused, {}));
    }

    /// Bends that were tried before are the same bends, whatever the ways were then.
    void trialsAreRemembered() {
        const double angle = std::numbers::pi / 6.0;
        const MultiPolygon tip = tipOf(angle);
        const Polygon piece = leftBeyondArc(angle, kRoundedM).front();
        const Rig lowered{tip, sprayer(), ImplementAt::Lowered};
        const auto trials = std::make_shared<FullLockTrials>();
        std::size_t most = 0;
        for (const std::size_t refused : {2, 0, 5, 0}) {
            const auto isRefused = [refused, asked = std::size_t{0}](const Curve&) mutable {
                return asked++ < refused;
            };
            auto alone = FullLockPasses::of(tip, lowered, kThere, {}).value();
            auto shared = FullLockPasses::of(tip, lowered, kThere, {}, trials).value();
            const auto expected = alone.over(piece, isRefused, {});
            const auto found = shared.over(piece, isRefused, {});
            QCOMPARE(found.has_value(), expected.has_value());
            if (found) {
                QVERIFY(found->line == expected->line && found->worked == expected->worked);
                ++most;
            }
        }
        QVERIFY(most >= 2);
    }

    void onThreads_data() {
        QTest::addColumn<int>("threads");
        QTest::addColumn<bool>("looksAhead");
        QTest::newRow("two") << 2 << false;
        QTest::newRow("one, looked ahead") << 1 << true;
        QTest::newRow("three, looked ahead") << 3 << true;
    }
    /// What several threads work out beforehand changes no pass.
    void onThreads() {
        QFETCH(int, threads);
        QFETCH(bool, looksAhead);
        for (const double angle : {0.45, 0.6, 0.8}) {
            const MultiPolygon tip = tipOf(angle);
            const Polygon piece = leftBeyondArc(angle, kRoundedM).front();
            const Rig lowered{tip, sprayer(), ImplementAt::Lowered};
            // The first two lead nowhere.
            const auto isRefused = [](std::size_t& asked) {
                return [&asked](const Curve&) { return asked++ < 2; };
            };
            std::size_t asked = 0;
            auto plain = FullLockPasses::of(tip, lowered, kThere, {}).value();
            const auto expected = plain.over(piece, isRefused(asked), {.threads = 1});
            QVERIFY(expected.has_value());
            auto passes = FullLockPasses::of(tip, lowered, kThere, {}).value();
            if (looksAhead) {
                VERIFY_RESULT(passes.lookAhead(std::array{piece, piece}, kNoneRefused, {.threads = threads}));
            }
            asked = 0;
            const auto found = passes.over(piece, isRefused(asked), {.threads = threads});
            QVERIFY(found && found->line == expected->line && found->worked == expected->worked);
        }
    }

    /// Another pass where the best has no way in or out, few looked for, and none where there is none at all.
    void onlyWithAWayInAndOut() {
        const double angle = std::numbers::pi / 3.0;
        const MultiPolygon tip = tipOf(angle);
        const MultiPolygon left = leftBeyondArc(angle, kRoundedM);
        const Rig lowered{tip, sprayer(), ImplementAt::Lowered};
        auto all = FullLockPasses::of(tip, lowered, kThere, {}).value();
        const Curve best = all.over(left.front(), kNoneRefused, {})->line;

        const auto isBest = [&](const Curve& line) {
            return distance(line.start.position, best.start.position) < 1.0;
        };
        auto others =
            FullLockPasses::of(
                tip, lowered,
                [&](const Curve& line) { return isBest(line) ? PassAccess::NoWayIn : PassAccess::There; }, {})
                .value();
        const auto other = others.over(left.front(), kNoneRefused, {});
        QVERIFY(other && !isBest(other->line));
        const auto notRefused = all.over(left.front(), isBest, {});
        QVERIFY(notRefused && !isBest(notRefused->line));

        int asked = 0;
        auto none = FullLockPasses::of(tip, lowered,
                                       [&](const Curve&) {
                                           ++asked;
                                           return PassAccess::NoWayOut;
                                       },
                                       {})
                        .value();
        QVERIFY(!none.over(left.front(), kNoneRefused, {}));
        QVERIFY2(asked > 2 && asked <= 24, qPrintable(QString::number(asked)));
        // What is hopeless is not looked at again.
        const int before = asked;
        QVERIFY(!none.over(left.front(), kNoneRefused, {}));
        QCOMPARE(asked, before);
    }

    /// 30 m broad: the boom gets in, but not round.
    void noRoom() {
        const MultiPolygon strip{test::rectangle(200.0, 30.0)};
        const MultiPolygon end{test::rectangle(10.0, 30.0)};
        const Rig lowered{strip, sprayer(), ImplementAt::Lowered};
        auto passes = FullLockPasses::of(strip, lowered, kThere, {}).value();
        QVERIFY(!passes.over(end.front(), kNoneRefused, {}));
    }

    void cancels() {
        std::stop_source stop;
        stop.request_stop();
        const MultiPolygon tip = tipOf(1.0);
        const Rig lowered{tip, sprayer(), ImplementAt::Lowered};
        const auto passes = FullLockPasses::of(tip, lowered, kThere, {.stop = stop.get_token()});
        QVERIFY(!passes);
        QVERIFY(passes.error().code == ErrorCode::Cancelled);
        const auto others = FullLockPasses::of(tip, lowered, kThere, {}).value();
        const auto ahead = others.lookAhead(tip, kNoneRefused, {.stop = stop.get_token()});
        QVERIFY(!ahead && ahead.error().code == ErrorCode::Cancelled);
    }
};

FURROW_TEST(FullLockPassesTest);
#include "tst_full_lock_passes.moc"
