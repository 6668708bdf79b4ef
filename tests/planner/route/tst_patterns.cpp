#include "planner/route/methods.h"
#include "planner/route/patterns.h"
#include "planner/route/route_proof.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <set>
#include <stop_token>

using namespace furrow;
using test::agbot;
using test::swathsOf;
using test::told;

namespace {

Settings settingsOf(std::initializer_list<std::pair<const Parameter*, std::string_view>> given) {
    Settings settings;
    for (const auto& [parameter, text] : given) {
        settings.setText(*parameter, text).value();
    }
    return settings;
}

QString told(const TrackOrder& order) {
    QStringList tracks;
    for (const std::size_t track : order) {
        tracks << QString::number(track);
    }
    return tracks.join(' ');
}

/// By the task's objective.
double linkCost(const std::vector<RouteStep>& steps, const RouteTask& task) {
    return RouteCosts{task}.links().between(endOrder(steps));
}

using Pattern = std::function<TrackOrder(std::size_t)>;

/// "skip 2": name and number, as rows have them.
Pattern patternNamed(const QString& name) {
    const auto number = static_cast<std::size_t>(name.section(' ', 1).toInt());
    if (name.startsWith("snake")) {
        return snakeOrder;
    }
    if (name.startsWith("spiral")) {
        return [number](std::size_t count) { return spiralOrder(count, number); };
    }
    if (name.startsWith("skip")) {
        return [number](std::size_t count) { return skipOrder(count, number); };
    }
    return name.startsWith("racetrack") ? Pattern{racetrackOrder} : Pattern{toAndFroOrder};
}

const QStringList kPatterns{"to-and-fro", "snake",  "spiral 2", "spiral 6", "spiral 7",
                            "skip 1",     "skip 2", "skip 5",   "racetrack"};

// Tracks 1 and 2 of four are cut by the hole: swaths 1, 2 and 3, 4.
const char* const kHole = "POLYGON((0 0, 100 0, 100 20, 0 20, 0 0), (40 5, 40 15, 60 15, 60 5, 40 5))";

}  // namespace

class PatternsTest : public QObject {
    Q_OBJECT

private slots:
    /// 1,600 cells of two swaths, 20 m apart: a table of all pairs of their 8 ways would hold 1.3 GB. From
    /// each the next one is a neighbour, but where the nearest ones are all done.
    void thousandsOfCells() {
        constexpr int kAcross = 40;
        constexpr double kApartM = 20.0;
        SwathSet swaths;
        std::vector<std::vector<std::size_t>> cells;
        for (int i = 0; i < kAcross * kAcross; ++i) {
            const Point low{kApartM * (i % kAcross), kApartM * (i / kAcross)};
            cells.push_back({swaths.swaths.size(), swaths.swaths.size() + 1});
            for (const double y : {1.25, 3.75}) {
                swaths.swaths.push_back({.start = low + Point{0.0, y},
                                         .end = low + Point{10.0, y},
                                         .track = y < 2.0 ? 0 : 1,
                                         .width = metres(2.5)});
            }
        }
        const Settings settings;
        const RouteTask task{.swaths = swaths,
                             .machine = agbot(),
                             .turn = kDubinsMethod.run,
                             .settings = settings,
                             .cells = cells};
        const auto route = kBoustrophedonMethod.run(task, {});
        VERIFY_RESULT(route);
        QCOMPARE(route->steps.size(), swaths.swaths.size());
        std::set<std::size_t> seen;
        int far = 0;
        for (std::size_t i = 0; i < route->steps.size(); i += 2) {
            // Both swaths of a cell follow each other.
            QCOMPARE(route->steps[i].swath / 2, route->steps[i + 1].swath / 2);
            seen.insert({route->steps[i].swath, route->steps[i + 1].swath});
            if (i > 0) {
                const double wayM = distance(endPose(route->steps[i - 1], swaths).position,
                                             startPose(route->steps[i], swaths).position);
                far += wayM > 1.5 * kApartM ? 1 : 0;
            }
        }
        QCOMPARE(seen.size(), swaths.swaths.size());
        QVERIFY2(far < kAcross * kAcross / 10, QByteArray::number(far));
    }
    void stoppedAmongThousandsOfCells() {
        std::stop_source stop;
        stop.request_stop();
        SwathSet swaths;
        std::vector<std::vector<std::size_t>> cells;
        for (std::size_t i = 0; i < 2'000; ++i) {
            const double y = 5.0 * static_cast<double>(i);
            swaths.swaths.push_back(
                {.start = {0.0, y}, .end = {10.0, y}, .track = static_cast<int>(i), .width = metres(2.5)});
            cells.push_back({i});
        }
        const Settings settings;
        const auto route = kBoustrophedonMethod.run({.swaths = swaths,
                                                     .machine = agbot(),
                                                     .turn = kDubinsMethod.run,
                                                     .settings = settings,
                                                     .cells = cells},
                                                    {.stop = stop.get_token()});
        QVERIFY(!route);
        QCOMPARE(route.error().code, ErrorCode::Cancelled);
    }

    void ordersByHand_data() {
        QTest::addColumn<QString>("pattern");
        QTest::addColumn<int>("count");
        QTest::addColumn<QString>("order");
        QTest::newRow("to and fro of 4") << "to-and-fro" << 4 << "0 1 2 3";
        QTest::newRow("snake of 1") << "snake" << 1 << "0";
        QTest::newRow("snake of 2") << "snake" << 2 << "0 1";
        QTest::newRow("snake of 3") << "snake" << 3 << "0 2 1";
        QTest::newRow("snake of 6") << "snake" << 6 << "0 2 4 5 3 1";
        QTest::newRow("snake of 7") << "snake" << 7 << "0 2 4 6 5 3 1";
        QTest::newRow("spiral of less than a cluster") << "spiral 6" << 5 << "0 2 4 3 1";
        QTest::newRow("spiral of one cluster") << "spiral 6" << 6 << "0 2 4 5 3 1";
        QTest::newRow("spiral of two clusters") << "spiral 6" << 12 << "0 2 4 5 3 1 6 8 10 11 9 7";
        QTest::newRow("spiral with one swath left") << "spiral 6" << 7 << "0 2 4 5 3 1 6";
        QTest::newRow("spiral with four swaths left") << "spiral 6" << 10 << "0 2 4 5 3 1 6 8 9 7";
        QTest::newRow("spiral with five swaths left") << "spiral 6" << 11 << "0 2 4 5 3 1 6 8 10 9 7";
        QTest::newRow("spiral of pairs is to and fro") << "spiral 2" << 5 << "0 1 2 3 4";
        // One left out: two on, one back, two on, then one on into the next three.
        QTest::newRow("skip 1 of 3") << "skip 1" << 3 << "0 2 1";
        QTest::newRow("skip 1 of 6") << "skip 1" << 6 << "0 2 1 3 5 4";
        QTest::newRow("skip 1 of 7") << "skip 1" << 7 << "0 2 1 3 5 4 6";
        QTest::newRow("skip 1 of 8") << "skip 1" << 8 << "0 2 1 3 5 4 6 7";
        // Two left out: three on, two back.
        QTest::newRow("skip 2 of 5") << "skip 2" << 5 << "0 3 1 4 2";
        QTest::newRow("skip 2 of 10") << "skip 2" << 10 << "0 3 1 4 2 5 8 6 9 7";
        QTest::newRow("skip 2 of 4") << "skip 2" << 4 << "0 3 1 2";
        QTest::newRow("skip 2 of 7") << "skip 2" << 7 << "0 3 1 4 2 5 6";
        QTest::newRow("skip 2 of 9") << "skip 2" << 9 << "0 3 1 4 2 5 8 6 7";
        QTest::newRow("skip more than there are") << "skip 5" << 3 << "0 1 2";
        QTest::newRow("racetrack of 1") << "racetrack" << 1 << "0";
        QTest::newRow("racetrack of 2") << "racetrack" << 2 << "0 1";
        QTest::newRow("racetrack of 6") << "racetrack" << 6 << "0 3 1 4 2 5";
        QTest::newRow("racetrack of 7") << "racetrack" << 7 << "0 4 1 5 2 6 3";
    }
    void ordersByHand() {
        QFETCH(QString, pattern);
        QFETCH(int, count);
        QFETCH(QString, order);
        QCOMPARE(told(patternNamed(pattern)(static_cast<std::size_t>(count))), order);
    }

    void everyOrderIsAPermutation() {
        for (const QString& name : kPatterns) {
            for (std::size_t count = 0; count <= 20; ++count) {
                TrackOrder order = patternNamed(name)(count);
                std::ranges::sort(order);
                VERIFY_TOLD(order == toAndFroOrder(count),
                            QStringLiteral("%1 of %2").arg(name).arg(count).toUtf8());
            }
        }
    }

    // What the patterns are for: how many tracks lie from one to the next.
    void noTurnIsTight() {
        const auto shortestStep = [](const TrackOrder& order) {
            std::size_t shortest = order.size();
            for (std::size_t i = 1; i < order.size(); ++i) {
                shortest =
                    std::min(shortest, std::max(order[i], order[i - 1]) - std::min(order[i], order[i - 1]));
            }
            return shortest;
        };
        for (std::size_t count = 4; count <= 20; ++count) {
            QVERIFY(shortestStep(racetrackOrder(count)) >= (count - 1) / 2);
        }
        QCOMPARE(shortestStep(skipOrder(5, 2)), std::size_t{2});
        QCOMPARE(shortestStep(skipOrder(9, 4)), std::size_t{4});
        // A snake has one tight turn, at the far side.
        for (std::size_t count = 3; count <= 20; ++count) {
            const TrackOrder order = snakeOrder(count);
            int tight = 0;
            for (std::size_t i = 1; i < count; ++i) {
                tight += order[i] + 1 == order[i - 1] || order[i - 1] + 1 == order[i] ? 1 : 0;
            }
            QCOMPARE(tight, 1);
        }
    }

    void alongTracksByHand_data() {
        QTest::addColumn<QString>("order");
        QTest::addColumn<bool>("firstReversed");
        QTest::addColumn<QString>("steps");
        QTest::newRow("to and fro") << "0 1 2 3" << false << "0 2- 1- 3 4 5-";
        QTest::newRow("to and fro from the other end") << "0 1 2 3" << true << "0- 1 2 4- 3- 5";
        QTest::newRow("snake") << "0 2 3 1" << false << "0 4- 3- 5 2- 1-";
        QTest::newRow("from the far side") << "3 2 1 0" << false << "5 4- 3- 1 2 0-";
        QTest::newRow("some of them only") << "2 0" << true << "4- 3- 0";
        QTest::newRow("none") << "" << false << "";
    }
    void alongTracksByHand() {
        QFETCH(QString, order);
        QFETCH(bool, firstReversed);
        QFETCH(QString, steps);
        const SwathSet swaths = swathsOf(test::polygonsFromWkt(kHole), 5.0, 0.0);
        QCOMPARE(trackCount(swaths), std::size_t{4});
        TrackOrder tracks;
        for (const QString& track : order.split(' ', Qt::SkipEmptyParts)) {
            tracks.push_back(track.toUInt());
        }
        QCOMPARE(told(Route{.steps = alongTracks(swaths, tracks, firstReversed), .lengthInPlace = {}}),
                 steps);
    }

    void methodsByHand_data() {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("steps");
        // Eight swaths from the first one.
        QTest::newRow("to and fro") << "boustrophedon" << "0 1- 2 3- 4 5- 6 7-";
        QTest::newRow("snake") << "snake" << "0 2- 4 6- 7 5- 3 1-";
        QTest::newRow("spiral of 4") << "spiral" << "0 2- 3 1- 4 6- 7 5-";
        QTest::newRow("skip 2") << "skip" << "0 3- 1 4- 2 5- 6 7-";
        QTest::newRow("racetrack") << "racetrack" << "0 4- 1 5- 2 6- 3 7-";
    }
    void methodsByHand() {
        QFETCH(QString, method);
        QFETCH(QString, steps);
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 40.0)}, 5.0, 0.0);
        const Settings settings = settingsOf({{&kCorner, "first"}, {&kCluster, "4"}, {&kSkip, "2"}});
        for (const auto* known :
             {&kBoustrophedonMethod, &kSnakeMethod, &kSpiralMethod, &kSkipMethod, &kRacetrackMethod}) {
            if (method.toStdString() == known->info.id) {
                const auto route = test::routeBy(*known, swaths, agbot(), settings);
                VERIFY_RESULT(route);
                QCOMPARE(told(*route), steps);
                return;
            }
        }
        QFAIL("no such method");
    }

    // Swaths 10 m long, 4 m apart: the robot's smallest radius is 2.1 m, so neighbours need a bulb.
    void linksCostTheSumOfTheTurns() {
        const SwathSet swaths = swathsOf({test::rectangle(10.0, 20.0)}, 4.0, 0.0);
        const Settings settings;
        const RouteTask task{
            .swaths = swaths, .machine = agbot(), .turn = kDubinsMethod.run, .settings = settings};
        const auto one = [&](std::size_t a, std::size_t b) {
            return linkCost({{.swath = a, .reversed = false}, {.swath = b, .reversed = true}}, task);
        };
        QCOMPARE(linkCost({}, task), 0.0);
        QCOMPARE(linkCost({{.swath = 2, .reversed = false}}, task), 0.0);
        COMPARE_WITHIN(linkCost(alongTracks(swaths, {0, 1, 2}, false), task), one(0, 1) + one(1, 2), 1e-9);
        // The bulb over 4 m, with radii of 2.1 m, is longer than a half circle of 2 m would be.
        QVERIFY(one(0, 1) > 2.0 * std::numbers::pi / agbot().turningSpeed().si());
        QVERIFY(one(0, 2) < one(0, 3));
    }

    void theBestCornerIsNeverSlower() {
        constexpr std::uint64_t kSeed = 21;
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 60; ++i) {
            const MultiPolygon mainland =
                test::randomPolygons(random, test::kShapes[static_cast<std::size_t>(i) % 5], 90.0);
            const SwathSet swaths = swathsOf(mainland, 8.0, test::uniform(random, 0.0, 180.0));
            const Settings best = settingsOf({{&kCorner, "best"}});
            const Settings first = settingsOf({{&kCorner, "first"}});
            for (const QString& name : kPatterns) {
                const TrackOrder order = patternNamed(name)(trackCount(swaths));
                const RouteTask bestTask{
                    .swaths = swaths, .machine = agbot(), .turn = kDubinsMethod.run, .settings = best};
                const RouteTask firstTask{
                    .swaths = swaths, .machine = agbot(), .turn = kDubinsMethod.run, .settings = first};
                const auto quick = bestRoute(order, bestTask, RouteCosts{bestTask}, {});
                VERIFY_RESULT(quick);
                const auto plain = bestRoute(order, firstTask, RouteCosts{firstTask}, {});
                VERIFY_RESULT(plain);
                const QByteArray said =
                    QStringLiteral("seed %1, field %2, %3").arg(kSeed).arg(i).arg(name).toUtf8();
                VERIFY_TOLD(linkCost(quick->steps, bestTask) <= linkCost(plain->steps, firstTask), said);
                for (const Route* route : {&*quick, &*plain}) {
                    std::set<std::size_t> driven;
                    std::set<int> tracksLeft;
                    int track = -1;
                    bool reversed = false;
                    for (const RouteStep& step : route->steps) {
                        VERIFY_TOLD(driven.insert(step.swath).second, said);
                        const int now = swaths.swaths[step.swath].track;
                        if (now == track) {
                            VERIFY_TOLD(step.reversed == reversed, said);
                        } else {
                            VERIFY_TOLD(track == -1 || step.reversed != reversed, said);
                            // Pieces of one track follow on each other: it is never come back to.
                            VERIFY_TOLD(tracksLeft.insert(now).second, said);
                        }
                        track = now;
                        reversed = step.reversed;
                    }
                    VERIFY_TOLD(driven.size() == swaths.swaths.size(), said);
                    // Every swath, and the straight distance from where one ends to where the next begins.
                    double allM = 0.0;
                    std::optional<Point> before;
                    for (const RouteStep& step : route->steps) {
                        const Swath& swath = swaths.swaths[step.swath];
                        const Point begin = step.reversed ? swath.end : swath.start;
                        allM += swath.length().si() + (before ? distance(*before, begin) : 0.0);
                        before = step.reversed ? swath.start : swath.end;
                    }
                    VERIFY_TOLD(std::abs(route->lengthInPlace.si() - allM) < 1e-6, said);
                }
            }
        }
    }

    // By every objective the optimised order costs no more than any pattern, and no less than its bound.
    void optimisedIsNeverDearer_data() {
        QTest::addColumn<QString>("objective");
        for (const char* objective : {"time", "length", "fuel"}) {
            QTest::newRow(objective) << objective;
        }
    }
    void optimisedIsNeverDearer() {
        QFETCH(QString, objective);
        constexpr std::uint64_t kSeed = 23;
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 25; ++i) {
            const MultiPolygon mainland =
                test::randomPolygons(random, test::kShapes[static_cast<std::size_t>(i) % 5], 90.0);
            const SwathSet swaths =
                swathsOf(mainland, test::uniform(random, 4.0, 12.0), test::uniform(random, 0.0, 180.0));
            const Settings settings = settingsOf({{&kRouteObjective, objective.toStdString()}});
            const RouteTask task{
                .swaths = swaths, .machine = agbot(), .turn = kDubinsMethod.run, .settings = settings};
            const auto best = kOptimisedMethod.run(task, {});
            VERIFY_RESULT(best);
            QCOMPARE(best->steps.size(), swaths.swaths.size());
            const double cost = linkCost(best->steps, task);
            const QByteArray said = QStringLiteral("seed %1, field %2").arg(kSeed).arg(i).toUtf8();
            for (const auto* method :
                 {&kBoustrophedonMethod, &kSnakeMethod, &kSpiralMethod, &kSkipMethod, &kRacetrackMethod}) {
                const auto pattern = method->run(task, {});
                VERIFY_RESULT(pattern);
                VERIFY_TOLD(cost <= linkCost(pattern->steps, task) + 1e-9, said);
            }
            const auto proof = proofOf(*best, task, {});
            VERIFY_RESULT(proof);
            QVERIFY(proof->has_value());
            COMPARE_WITHIN((*proof)->nonWorking, cost, 1e-9);
            VERIFY_TOLD((*proof)->lowerBound > 0.0 && (*proof)->lowerBound <= cost + 1e-9, said);
            VERIFY_TOLD((*proof)->gap() < 0.25 && (*proof)->gapTotal() <= (*proof)->gap(), said);
            QVERIFY((*proof)->working > 0.0);
        }
    }

    // A way that does not fit is not taken where there is another one.
    void optimisedLooksUpWays() {
        // Three swaths of 100 m, 5 m apart.
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 15.0)}, 5.0, 0.0);
        RouteTask task{.swaths = swaths, .machine = agbot(), .turn = kDubinsMethod.run, .settings = {}};
        int asked = 0;
        // From the first swath none leads to the second one, in either direction.
        task.way = [&](const RouteStep& from, const RouteStep& to, SearchEffort) -> std::optional<Curve> {
            ++asked;
            if (from.swath + to.swath == 1) {
                return std::nullopt;
            }
            return turnBetween(from, to, swaths, agbot(), kDubinsMethod.run);
        };
        const auto route = kOptimisedMethod.run(task, {});
        VERIFY_RESULT(route);
        QVERIFY(asked > 0);
        for (std::size_t i = 1; i < route->steps.size(); ++i) {
            QVERIFY(route->steps[i - 1].swath + route->steps[i].swath != 1);
        }
    }

    void lockedSwathsStayTogether_data() {
        QTest::addColumn<QString>("locked");
        QTest::addColumn<QString>("block");
        QTest::addColumn<double>("heightM");
        QTest::newRow("one direction") << "4" << "3" << 30.0;
        QTest::newRow("the other direction") << "-4" << "3-" << 30.0;
        QTest::newRow("far apart") << "6,-1,3" << "5 0- 2" << 30.0;
        QTest::newRow("both the same way") << "1,2" << "0 1" << 30.0;
        QTest::newRow("too many for the exact order") << "16,-2,9,-8" << "15 1- 8 7-" << 100.0;
        QTest::newRow("all") << "6,5,4,3,2,1" << "5 4 3 2 1 0" << 30.0;
    }
    void lockedSwathsStayTogether() {
        QFETCH(QString, locked);
        QFETCH(QString, block);
        QFETCH(double, heightM);
        const SwathSet swaths = swathsOf({test::rectangle(100.0, heightM)}, 5.0, 0.0);
        const auto route =
            test::routeBy(kOptimisedMethod, swaths, agbot(), settingsOf({{&kLocked, locked.toStdString()}}));
        VERIFY_RESULT(route);
        QCOMPARE(route->steps.size(), swaths.swaths.size());
        QVERIFY2((' ' + told(*route) + ' ').contains(' ' + block + ' '), qPrintable(told(*route)));
    }

    void lockedRefuses() {
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 15.0)}, 5.0, 0.0);
        for (const char* locked : {"4", "0", "1,-1"}) {
            const auto route =
                test::routeBy(kOptimisedMethod, swaths, agbot(), settingsOf({{&kLocked, locked}}));
            QVERIFY(!route);
            QCOMPARE(route.error().code, ErrorCode::InputRefused);
            QCOMPARE(route.error().where, std::string{"route.locked"});
        }
    }

    // Without a way there is no cost to compare with a bound.
    void noProofWithoutAWay() {
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 15.0)}, 5.0, 0.0);
        RouteTask task{.swaths = swaths, .machine = agbot(), .turn = kDubinsMethod.run, .settings = {}};
        task.way = [](const RouteStep&, const RouteStep&, SearchEffort) { return std::optional<Curve>{}; };
        const auto route = kOptimisedMethod.run(task, {});
        VERIFY_RESULT(route);
        QCOMPARE(route->steps.size(), std::size_t{3});
        const auto proof = proofOf(*route, task, {});
        VERIFY_RESULT(proof);
        QVERIFY(!*proof);
    }

    // The way from a gate counts.
    void optimisedBeginsAtTheGate_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("swath");
        QTest::addColumn<bool>("reversed");
        QTest::newRow("lower left") << -500.0 << 2.5 << 0 << false;
        QTest::newRow("upper right") << 600.0 << 12.5 << 2 << true;
    }
    void optimisedBeginsAtTheGate() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, swath);
        QFETCH(bool, reversed);
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 15.0)}, 5.0, 0.0);
        RouteTask task{.swaths = swaths, .machine = agbot(), .turn = kDubinsMethod.run, .settings = {}};
        task.start = Point{x, y};
        const auto route = kOptimisedMethod.run(task, {});
        VERIFY_RESULT(route);
        QCOMPARE(route->steps.front().swath, static_cast<std::size_t>(swath));
        QCOMPARE(route->steps.front().reversed, reversed);
    }

    void customOrder_data() {
        QTest::addColumn<QString>("order");
        QTest::addColumn<QString>("steps");
        QTest::addColumn<double>("betweenM");
        // Three swaths of 100 m, 5 m apart; where the end of one lies at the other end from the next, 100 m
        // along.
        QTest::newRow("with directions") << "3,-1,2" << "2 0- 1" << 10.0 + 5.0;
        QTest::newRow("all the same way") << "1,2,3" << "0 1 2" << 2.0 * std::hypot(100.0, 5.0);
        QTest::newRow("blanks") << " -3, 2 ,-1" << "2- 1 0-" << 5.0 + 5.0;
        QTest::newRow("a plain minus at the first") << "-1,3,-2" << "0- 2 1-" << 10.0 + 5.0;
    }
    void customOrder() {
        QFETCH(QString, order);
        QFETCH(QString, steps);
        QFETCH(double, betweenM);
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 15.0)}, 5.0, 0.0);
        const auto route =
            test::routeBy(kCustomMethod, swaths, agbot(), settingsOf({{&kOrder, order.toStdString()}}));
        VERIFY_RESULT(route);
        QCOMPARE(told(*route), steps);
        COMPARE_WITHIN(route->lengthInPlace.si(), 300.0 + betweenM, 1e-6);
    }

    void customOrderRefuses_data() {
        QTest::addColumn<QString>("order");
        QTest::addColumn<QString>("what");
        QTest::newRow("not given") << "" << "3 of 3 swaths are not in the order: 1, 2, 3";
        QTest::newRow("one missing") << "3,1" << "1 of 3 swaths are not in the order: 2";
        QTest::newRow("twice") << "1,2,1" << "swath 1 is named twice";
        QTest::newRow("twice, both ways") << "1,2,-2" << "swath 2 is named twice";
        QTest::newRow("unknown") << "1,2,4" << "there is no swath 4";
        QTest::newRow("unknown the other way") << "1,2,-4" << "there is no swath 4";
        QTest::newRow("zero") << "0,1,2" << "there is no swath 0";
        QTest::newRow("smallest number there is") << "-2147483648" << "there is no swath";
    }
    void customOrderRefuses() {
        QFETCH(QString, order);
        QFETCH(QString, what);
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 15.0)}, 5.0, 0.0);
        const auto route =
            test::routeBy(kCustomMethod, swaths, agbot(), settingsOf({{&kOrder, order.toStdString()}}));
        QVERIFY(!route);
        QCOMPARE(route.error().code, ErrorCode::InputRefused);
        QCOMPARE(route.error().where, std::string{"route.order"});
        QVERIFY2(QString::fromStdString(route.error().what).contains(what), route.error().what.c_str());
        QVERIFY(!route.error().remedy.empty());
    }

    void noSwaths() {
        for (const auto* method :
             {&kSnakeMethod, &kSpiralMethod, &kSkipMethod, &kRacetrackMethod, &kCustomMethod}) {
            const auto route = test::routeBy(*method, {}, agbot(), {});
            VERIFY_RESULT(route);
            QVERIFY(route->steps.empty());
            QCOMPARE(route->lengthInPlace.si(), 0.0);
        }
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        const SwathSet swaths = swathsOf({test::rectangle(100.0, 20.0)}, 5.0, 0.0);
        for (const auto* method :
             {&kSnakeMethod, &kSpiralMethod, &kSkipMethod, &kRacetrackMethod, &kCustomMethod}) {
            const auto route = test::routeBy(*method, swaths, agbot(), {}, {.stop = stop.get_token()});
            QVERIFY(!route);
            QCOMPARE(route.error().code, ErrorCode::Cancelled);
        }
    }
};

FURROW_TEST(PatternsTest);
#include "tst_patterns.moc"
