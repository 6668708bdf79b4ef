// What people say of the order of swaths: the first, the last, open strips.

#include "planner/route/methods.h"
#include "planner/route/open_strips.h"
#include "planner/route/order_search.h"
#include "planner/route/patterns.h"
#include "planner/route/route_costs.h"
#include "planner/route/route_proof.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

using namespace furrow;

namespace {

using Given = std::vector<std::pair<const Parameter*, std::string>>;

Settings settingsOf(const Given& given) {
    Settings settings;
    for (const auto& [parameter, text] : given) {
        settings.setText(*parameter, text).value();
    }
    return settings;
}

EndOrder inOrder(const std::vector<std::size_t>& swaths) {
    EndOrder order;
    for (const std::size_t swath : swaths) {
        order.push_back(static_cast<SwathEnd>(2 * swath));
    }
    return order;
}

/// Open strips after each step, counted along the line from scratch.
std::vector<std::size_t> openByHand(const std::vector<std::size_t>& order, std::size_t count) {
    std::vector<std::size_t> open;
    std::vector<char> driven(count, 0);
    for (const std::size_t swath : order) {
        driven[swath] = 1;
        std::size_t strips = 0;
        bool isGap = false;
        bool isAfterDriven = false;
        for (std::size_t i = 0; i < count; ++i) {
            if (driven[i] != 0) {
                strips += isGap && isAfterDriven ? 1 : 0;
                isAfterDriven = true;
                isGap = false;
            } else {
                isGap = true;
            }
        }
        open.push_back(strips);
    }
    return open;
}

/// Tracks side by side whose near turns are dear, with ends at random.
struct Tracks {
    std::vector<double> shift;

    LinkCosts::Functions costs() const {
        return {
            .link =
                [this](SwathEnd leaving, SwathEnd entered) {
                    const int apart = std::abs(static_cast<int>(leaving / 2) - static_cast<int>(entered / 2));
                    const double along = leaving % 2 == entered % 2 ? 0.0 : 20.0;  // from the far end back
                    return (apart < 2 ? 9.0 - 3.0 * apart : 1.0 * apart) + along +
                           0.2 * std::abs(shift[leaving / 2] - shift[entered / 2]);
                },
            .atLeast = {},
            .begin = {},
            .finish = {},
            .fitting = {}};
    }
};

double cheapestByTrying(const LinkCosts& costs, const OpenStripLimit& limit) {
    const std::size_t count = costs.swathCount();
    std::vector<std::size_t> swaths(count);
    std::iota(swaths.begin(), swaths.end(), std::size_t{0});
    double best = std::numeric_limits<double>::infinity();
    do {
        if (limit.excess(inOrder(swaths)) > 0) {
            continue;
        }
        for (std::size_t turned = 0; turned < (std::size_t{1} << count); ++turned) {
            EndOrder order = inOrder(swaths);
            for (std::size_t i = 0; i < count; ++i) {
                order[i] += static_cast<SwathEnd>((turned >> i) & 1U);
            }
            best = std::min(best, costs.of(order));
        }
    } while (std::ranges::next_permutation(swaths).found);
    return best;
}

}  // namespace

class TestOrderLimits : public QObject {
    Q_OBJECT

private slots:
    void stripsByHand_data() {
        QTest::addColumn<QList<int>>("order");
        QTest::addColumn<int>("most");
        QTest::newRow("to and fro") << QList{0, 1, 2, 3, 4} << 0;
        QTest::newRow("from the middle") << QList{2, 3, 1, 4, 0} << 0;
        QTest::newRow("one ahead, one back") << QList{0, 2, 1, 4, 3} << 1;
        QTest::newRow("snake") << QList{0, 2, 4, 3, 1} << 2;
        QTest::newRow("both sides first") << QList{0, 4, 2, 1, 3} << 2;
        QTest::newRow("one") << QList{0} << 0;
    }
    void stripsByHand() {
        QFETCH(QList<int>, order);
        QFETCH(int, most);
        std::vector<std::size_t> swaths(order.begin(), order.end());
        const OpenStripLimit limit{0, {}, swaths.size()};
        QCOMPARE(limit.mostOpen(inOrder(swaths)), static_cast<std::size_t>(most));
        QCOMPARE(limit.excess(inOrder(swaths)) == 0, most == 0);
        QCOMPARE((OpenStripLimit{static_cast<std::size_t>(most), {}, swaths.size()}.excess(inOrder(swaths))),
                 std::size_t{0});
    }

    // Swaths of different cells are no neighbours, whatever their numbers.
    void stripsOfCells() {
        const OpenStripLimit limit{0, {{0, 2, 4}, {1, 3}}, 5};
        QCOMPARE(limit.mostOpen(inOrder({0, 1, 2, 3, 4})), std::size_t{0});
        QCOMPARE(limit.mostOpen(inOrder({0, 4, 1, 3, 2})), std::size_t{1});
    }

    void stripsOfRandomOrders() {
        std::mt19937_64 random{77};
        for (int i = 0; i < 500; ++i) {
            std::vector<std::size_t> swaths(2 + random() % 30);
            std::iota(swaths.begin(), swaths.end(), std::size_t{0});
            std::ranges::shuffle(swaths, random);
            const std::size_t most = random() % 4;
            const std::vector<std::size_t> open = openByHand(swaths, swaths.size());
            std::size_t over = 0;
            for (const std::size_t each : open) {
                over += each > most ? each - most : 0;
            }
            const OpenStripLimit limit{most, {}, swaths.size()};
            QCOMPARE(limit.mostOpen(inOrder(swaths)), std::ranges::max(open));
            QCOMPARE(limit.excess(inOrder(swaths)), over);
            QVERIFY(over == 0 || limit.excess(inOrder(swaths), over - 1) > over - 1);
        }
    }

    // Against all orders of up to six swaths.
    void searchFindsTheCheapestWithinTheLimit() {
        std::mt19937_64 random{4711};
        int found = 0;
        constexpr int kCases = 60;
        for (int i = 0; i < kCases; ++i) {
            const std::size_t count = 3 + random() % 4;
            Tracks tracks;
            for (std::size_t k = 0; k < count; ++k) {
                tracks.shift.push_back(static_cast<double>(random() % 100));
            }
            const LinkCosts costs{count, tracks.costs()};
            const OpenStripLimit limit{random() % 2, {}, count};
            std::vector<std::size_t> swaths(count);
            std::iota(swaths.begin(), swaths.end(), std::size_t{0});
            const std::vector<EndOrder> starts{inOrder(swaths)};
            const FoundOrder order = searchedOrder({.costs = costs,
                                                    .near = nearEnds(costs, kNearLinks),
                                                    .starts = starts,
                                                    .rounds = 1'000,
                                                    .strips = &limit},
                                                   {});
            QCOMPARE(limit.excess(order.order), std::size_t{0});
            const double best = cheapestByTrying(costs, limit);
            QVERIFY(order.cost >= best - 1e-9);
            found += order.cost < best + 1e-9 ? 1 : 0;
        }
        QVERIFY2(found >= kCases - 1, qPrintable(QString::number(found)));
    }

    void limitsHoldInFields_data() {
        QTest::addColumn<double>("heightM");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        for (const double height : {30.0, 100.0}) {
            for (const auto& [key, value] :
                 {std::pair{"route.open_strips", "0"}, std::pair{"route.open_strips", "1"},
                  std::pair{"route.open_strips", "2"}, std::pair{"route.first", "4"},
                  std::pair{"route.first", "6"}, std::pair{"route.last", "3"},
                  std::pair{"route.last", "1"}}) {
                QTest::addRow("%g m, %s %s", height, key, value) << height << key << value;
            }
        }
    }
    void limitsHoldInFields() {
        QFETCH(double, heightM);
        QFETCH(QString, key);
        QFETCH(QString, value);
        const SwathSet swaths = test::swathsOf({test::rectangle(100.0, heightM)}, 5.0, 0.0);
        const Parameter& parameter = key == "route.first"  ? kFirstSwath
                                     : key == "route.last" ? kLastSwath
                                                           : kOpenStrips;
        const Settings settings = settingsOf({{&parameter, value.toStdString()}});
        const auto route = test::routeBy(kOptimisedMethod, swaths, test::agbot(), settings);
        VERIFY_RESULT(route);
        QCOMPARE(route->steps.size(), swaths.swaths.size());
        const std::size_t number = value.toULong();
        if (&parameter == &kFirstSwath) {
            QCOMPARE(route->steps.front().swath, number - 1);
        } else if (&parameter == &kLastSwath) {
            QCOMPARE(route->steps.back().swath, number - 1);
        } else {
            QVERIFY((OpenStripLimit{0, {}, swaths.swaths.size()}.mostOpen(endOrder(route->steps))) <= number);
        }
        // No order without the limit is dearer, and the proof holds for all of them.
        const RouteTask task{
            .swaths = swaths, .machine = test::agbot(), .turn = kDubinsMethod.run, .settings = settings};
        const auto proof = proofOf(*route, task, {});
        VERIFY_RESULT(proof);
        QVERIFY((*proof)->lowerBound <= (*proof)->nonWorking + 1e-9);
    }

    // A limit that costs nothing changes nothing; a narrower one never makes the route cheaper.
    void narrowerLimitsAreNotCheaper() {
        const SwathSet swaths = test::swathsOf({test::rectangle(100.0, 120.0)}, 5.0, 0.0);
        const auto costWith = [&](const Given& given) {
            const Settings settings = settingsOf(given);
            const auto route = test::routeBy(kOptimisedMethod, swaths, test::agbot(), settings);
            const RouteTask task{
                .swaths = swaths, .machine = test::agbot(), .turn = kDubinsMethod.run, .settings = {}};
            return RouteCosts{task}.links().between(endOrder(route.value().steps));
        };
        const double free = costWith({});
        double before = free;
        for (const char* most : {"24", "3", "2", "1", "0"}) {
            const double cost = costWith({{&kOpenStrips, most}});
            QVERIFY2(cost >= 0.99 * before, most);
            before = cost;
        }
        QCOMPARE(costWith({{&kOpenStrips, "24"}}), free);
    }

    // The swaths between locked ones are driven before them.
    void lockedSwathsNeedNoOpenStrip() {
        const SwathSet swaths = test::swathsOf({test::rectangle(100.0, 100.0)}, 5.0, 0.0);
        const Settings settings = settingsOf({{&kLocked, "8,-12"}, {&kOpenStrips, "0"}});
        const auto route = test::routeBy(kOptimisedMethod, swaths, test::agbot(), settings);
        VERIFY_RESULT(route);
        QCOMPARE((OpenStripLimit{0, {}, swaths.swaths.size()}.mostOpen(endOrder(route->steps))),
                 std::size_t{0});
        const auto at = std::ranges::find(route->steps, std::size_t{7}, &RouteStep::swath);
        QVERIFY(at != route->steps.end() && std::next(at) != route->steps.end());
        QCOMPARE(std::next(at)->swath, std::size_t{11});
        QVERIFY(!at->reversed && std::next(at)->reversed);
    }

    void refuses_data() {
        QTest::addColumn<QList<QStringList>>("given");
        QTest::addColumn<QString>("where");
        using Rows = QList<QStringList>;
        QTest::newRow("no such first") << Rows{{"route.first", "4"}} << "route.first";
        QTest::newRow("no such last") << Rows{{"route.last", "99"}} << "route.last";
        QTest::newRow("both ends") << Rows{{"route.first", "2"}, {"route.last", "2"}} << "route.last";
        QTest::newRow("locked over a gap")
            << Rows{{"route.locked", "1,3,2"}, {"route.open_strips", "0"}} << "route.locked";
    }
    void refuses() {
        QFETCH(QList<QStringList>, given);
        QFETCH(QString, where);
        const SwathSet swaths = test::swathsOf({test::rectangle(100.0, 15.0)}, 5.0, 0.0);
        Settings settings;
        for (const QStringList& each : given) {
            const Parameter& parameter = each[0] == "route.first"    ? kFirstSwath
                                         : each[0] == "route.last"   ? kLastSwath
                                         : each[0] == "route.locked" ? kLocked
                                                                     : kOpenStrips;
            settings.setText(parameter, each[1].toStdString()).value();
        }
        const auto route = test::routeBy(kOptimisedMethod, swaths, test::agbot(), settings);
        QVERIFY(!route);
        QCOMPARE(route.error().code, ErrorCode::InputRefused);
        QCOMPARE(route.error().where, where.toStdString());
    }
};

FURROW_TEST(TestOrderLimits);
#include "tst_order_limits.moc"
