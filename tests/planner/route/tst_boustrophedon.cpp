#include "planner/route/methods.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <algorithm>
#include <cmath>
#include <stop_token>

using namespace furrow;
using test::agbot;
using test::swathsOf;
using test::told;

namespace {

Settings corner(const char* id) {
    Settings settings;
    settings.setText(kCorner, id).value();
    return settings;
}

}  // namespace

class BoustrophedonTest : public QObject {
    Q_OBJECT

private slots:
    void byHand_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<QString>("steps");
        QTest::addColumn<double>("lengthInPlaceM");
        // Swaths and the ways between them, one operating width each.
        QTest::newRow("rectangle of four swaths")
            << "POLYGON((0 0, 100 0, 100 20, 0 20, 0 0))" << 5.0 << "0 1- 2 3-" << 400.0 + 15.0;
        QTest::newRow("one swath") << "POLYGON((0 0, 100 0, 100 5, 0 5, 0 0))" << 5.0 << "0" << 100.0;
        // Ends lie on the slanted side: from one line to the next 5 m on and 5 m up on the right only.
        QTest::newRow("trapezoid") << "POLYGON((0 0, 100 0, 80 20, 0 20, 0 0))" << 5.0 << "0 1- 2 3-"
                                   << (97.5 + 92.5 + 87.5 + 82.5) + 2.0 * std::sqrt(50.0) + 5.0;
        // Tracks 1 and 2 are cut by the hole: both pieces in driving direction, 20 m between them.
        QTest::newRow("hole") << "POLYGON((0 0, 100 0, 100 20, 0 20, 0 0), (40 5, 40 15, 60 15, 60 5, 40 5))"
                              << 5.0 << "0 2- 1- 3 4 5-" << 100.0 + 100.0 + 100.0 + 100.0 + 15.0;
    }
    void byHand() {
        QFETCH(QString, wkt);
        QFETCH(double, widthM);
        QFETCH(QString, steps);
        QFETCH(double, lengthInPlaceM);
        const SwathSet swaths = swathsOf(test::polygonsFromWkt(wkt.toStdString()), widthM, 0.0);
        const auto route = test::routeBy(kBoustrophedonMethod, swaths, agbot(), corner("first"), {});
        VERIFY_RESULT(route);
        QCOMPARE(told(*route), steps);
        COMPARE_WITHIN(route->lengthInPlace.si(), lengthInPlaceM, 1e-6);
        COMPARE_WITHIN(lengthInPlace(route->steps, swaths).si(), lengthInPlaceM, 1e-6);
    }

    void poses() {
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 20.0)}, 5.0, 0.0);
        const Pose start = startPose({.swath = 1, .reversed = true}, swaths);
        COMPARE_WITHIN(distance(start.position, {100.0, 7.5}), 0.0, 1e-9);
        COMPARE_WITHIN(inDegrees(start.heading), 180.0, 1e-9);
        const Pose end = endPose({.swath = 1, .reversed = true}, swaths);
        COMPARE_WITHIN(distance(end.position, {0.0, 7.5}), 0.0, 1e-9);
        COMPARE_WITHIN(inDegrees(end.heading), 180.0, 1e-9);
        COMPARE_WITHIN(inDegrees(startPose({.swath = 1, .reversed = false}, swaths).heading), 0.0, 1e-9);
    }

    void everySwathOnce_data() {
        QTest::addColumn<QString>("corner");
        QTest::newRow("best corner") << "best";
        QTest::newRow("first swath") << "first";
    }
    void everySwathOnce() {
        QFETCH(QString, corner);
        constexpr std::uint64_t kSeed = 5;
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 100; ++i) {
            const MultiPolygon mainland =
                test::randomPolygons(random, test::kShapes[static_cast<std::size_t>(i) % 5], 100.0);
            const SwathSet swaths = swathsOf(mainland, 6.0, test::uniform(random, 0.0, 180.0));
            const auto route =
                test::routeBy(kBoustrophedonMethod, swaths, agbot(), ::corner(qPrintable(corner)), {});
            VERIFY_RESULT(route);
            const QByteArray said = QStringLiteral("seed %1, field %2").arg(kSeed).arg(i).toUtf8();
            VERIFY_TOLD(route->steps.size() == swaths.swaths.size(), said);
            std::vector<bool> seen(swaths.swaths.size());
            int lastTrack = -1;
            bool reversed = false;
            std::vector<int> tracks;
            for (const RouteStep& step : route->steps) {
                VERIFY_TOLD(!seen[step.swath], said);
                seen[step.swath] = true;
                const int track = swaths.swaths[step.swath].track;
                // Swaths of one track the same way, the next track the other way.
                VERIFY_TOLD(lastTrack == -1 || (track == lastTrack) == (step.reversed == reversed), said);
                if (track != lastTrack) {
                    tracks.push_back(track);
                }
                lastTrack = track;
                reversed = step.reversed;
            }
            VERIFY_TOLD(std::ranges::is_sorted(tracks) || std::ranges::is_sorted(tracks, std::greater{}),
                        said);
            VERIFY_TOLD(route->lengthInPlace >= swaths.totalLength - metres(1e-6), said);
        }
    }

    // Ends level on the left, slanted on the right: of three turns between four swaths, two are made on the
    // side where the first one is made. A slanted turn is longer, so the first one must be on the left.
    void theBestCornerHasTheShortestTurns() {
        const SwathSet swaths =
            swathsOf(test::polygonsFromWkt("POLYGON((0 0, 100 0, 220 20, 0 20, 0 0))"), 5.0, 0.0);
        QCOMPARE(swaths.swaths.size(), std::size_t{4});
        const auto best = test::routeBy(kBoustrophedonMethod, swaths, agbot(), corner("best"), {});
        VERIFY_RESULT(best);
        QVERIFY2(best->steps.front().reversed, qPrintable(told(*best)));
        const auto first = test::routeBy(kBoustrophedonMethod, swaths, agbot(), corner("first"), {});
        VERIFY_RESULT(first);
        // 30 m along and 5 m up for each slanted way, 5 m for each level one.
        COMPARE_WITHIN(first->lengthInPlace.si(), swaths.totalLength.si() + 2.0 * std::hypot(30.0, 5.0) + 5.0,
                       1e-6);
        COMPARE_WITHIN(best->lengthInPlace.si(), swaths.totalLength.si() + std::hypot(30.0, 5.0) + 10.0,
                       1e-6);
    }

    void noSwaths() {
        const auto route = test::routeBy(kBoustrophedonMethod, {}, agbot(), {}, {});
        VERIFY_RESULT(route);
        QVERIFY(route->steps.empty());
        QCOMPARE(route->lengthInPlace.si(), 0.0);
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 20.0)}, 5.0, 0.0);
        for (const char* id : {"best", "first"}) {
            const auto route =
                test::routeBy(kBoustrophedonMethod, swaths, agbot(), corner(id), {.stop = stop.get_token()});
            QVERIFY(!route);
            QCOMPARE(route.error().code, ErrorCode::Cancelled);
        }
    }
};

FURROW_TEST(BoustrophedonTest);
#include "tst_boustrophedon.moc"
