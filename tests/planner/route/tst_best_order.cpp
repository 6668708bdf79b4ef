#include "planner/route/exact_order.h"
#include "planner/route/order_bound.h"
#include "planner/route/order_search.h"
#include "tests/planner/route/track_instances.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <stop_token>

using namespace furrow;
using test::TurnKind;

namespace {

constexpr double kRadius = 5.4;
constexpr std::size_t kNear = 10;
// More than free ends save.
constexpr double kElsewhere = 20.0;

/// Track numbers from 1, driven up and down in turn.
/// @param first  1: the first one is driven down
EndOrder orderOf(std::initializer_list<int> numbers, SwathEnd first = 0) {
    EndOrder order;
    for (const int number : numbers) {
        order.push_back(static_cast<SwathEnd>(2 * (number - 1)) + (order.size() + first) % 2);
    }
    return order;
}

FoundOrder searched(const LinkCosts& costs, std::size_t rounds) {
    const NearEnds near = nearEnds(costs, kNear);
    const std::vector<EndOrder> starts{test::plainOrder(costs.swathCount())};
    return searchedOrder({.costs = costs, .near = near, .starts = starts, .rounds = rounds}, {});
}

OrderBound boundOf(LinkCosts& costs, double known) {
    return heldKarpBound(costs, nearEnds(costs, kNear), known, 1'500, {});
}

bool isEverySwathOnce(const EndOrder& order, std::size_t count) {
    std::vector<SwathEnd> swaths(order.size());
    std::ranges::transform(order, swaths.begin(), [](SwathEnd end) { return end / 2; });
    std::ranges::sort(swaths);
    return swaths.size() == count && std::ranges::adjacent_find(swaths) == swaths.end() &&
           (swaths.empty() || swaths.back() + 1 == count);
}

/// The same costs with the first and the last end given.
LinkCosts withEnds(const std::vector<test::Track>& tracks, SwathEnd first, SwathEnd last) {
    return LinkCosts{
        tracks.size(),
        {.link = [costs = std::make_shared<LinkCosts>(test::trackCosts(tracks, kRadius, TurnKind::BulbOrU))](
                     SwathEnd from, SwathEnd to) { return costs->link(from, to); },
         .atLeast = {},
         .begin = [first](SwathEnd end) { return end == first ? 0.0 : kElsewhere; },
         .finish = [last](SwathEnd end) { return end == last ? 0.0 : kElsewhere; },
         .fitting = {}}};
}

}  // namespace

class BestOrderTest : public QObject {
    Q_OBJECT

private slots:
    // Bakhtiari, Navid, Mehri, Bochtis 2011: costs of given orders.
    void publishedOrders() {
        const LinkCosts a = test::trackCosts(test::fieldA(), kRadius, TurnKind::BulbOrU);
        COMPARE_WITHIN(a.of(test::plainOrder(10)), 209.38, 0.01);
        COMPARE_WITHIN(a.of(orderOf({1, 6, 2, 7, 3, 8, 4, 9, 5, 10})), 239.98, 0.01);
        COMPARE_WITHIN(a.of(orderOf({2, 4, 6, 9, 7, 10, 8, 5, 3, 1})), 171.58, 0.01);
        const LinkCosts b = test::trackCosts(test::fieldB(), kRadius, TurnKind::BulbOrU);
        COMPARE_WITHIN(b.of(orderOf({1, 3, 5, 7, 9, 11, 12, 14, 16, 18, 17, 15, 13, 10, 8, 6, 4, 2}, 1)),
                       351.40, 0.01);
        const LinkCosts omega = test::trackCosts(test::fieldA(), kRadius, TurnKind::ForwardOmega);
        COMPARE_WITHIN(omega.of(test::plainOrder(10)), 305.03, 0.01);
    }

    void publishedOptima_data() {
        QTest::addColumn<QString>("field");
        QTest::addColumn<double>("optimum");
        QTest::newRow("A, free ends") << "A" << 170.68;
        QTest::newRow("A from 2 to 1") << "A from 2 to 1" << 171.58;
        QTest::newRow("A, omega turns") << "A omega" << 189.34;
        QTest::newRow("B, free ends") << "B" << 344.20;
        QTest::newRow("B from 1 to 2") << "B from 1 to 2" << 351.40;
    }
    void publishedOptima() {
        QFETCH(QString, field);
        QFETCH(double, optimum);
        const auto tracks = field.startsWith('A') ? test::fieldA() : test::fieldB();
        LinkCosts costs =
            field == "A from 2 to 1" ? withEnds(tracks, 2, 0)
            : field == "B from 1 to 2"
                ? withEnds(tracks, 1, 3)
                : test::trackCosts(tracks, kRadius,
                                   field == "A omega" ? TurnKind::ForwardOmega : TurnKind::BulbOrU);
        const FoundOrder found = searched(costs, 5'000);
        QVERIFY(isEverySwathOnce(found.order, tracks.size()));
        COMPARE_WITHIN(found.cost, optimum, 0.01);
        COMPARE_WITHIN(costs.of(found.order), found.cost, 1e-9);
        // And proved: nothing is cheaper.
        const OrderBound bound = boundOf(costs, found.cost);
        const ProvedOrder proved = branchAndBound(costs, found, bound, 5'000, {});
        QVERIFY(bound.cost <= found.cost + 1e-9);
        COMPARE_WITHIN(proved.bound, optimum, 0.01);
    }

    // Dynamic programming gives the optimum; costs that differ with direction in every second instance.
    void smallInstances() {
        std::mt19937_64 random{20};
        int found = 0;
        double worstGap = 0.0;
        double sumOfGaps = 0.0;
        std::size_t kept = 0;
        std::size_t all = 0;
        int dearer = 0;
        constexpr int kInstances = 500;
        for (int i = 0; i < kInstances; ++i) {
            const auto count = static_cast<std::size_t>(2 + i % 9);
            const double width = test::uniform(random, 2.0, 6.0);
            LinkCosts costs = test::trackCosts(test::randomTracks(random, count, width),
                                               test::uniform(random, 0.4, 3.0) * width,
                                               i % 4 < 2 ? TurnKind::BulbOrU : TurnKind::ForwardOmega,
                                               i % 2 == 0 ? 0.0 : test::uniform(random, 0.0, 0.5));
            const FoundOrder best = cheapestOrder(costs);
            QVERIFY(isEverySwathOnce(best.order, count));
            COMPARE_WITHIN(costs.of(best.order), best.cost, 1e-9);
            const FoundOrder order = searched(costs, 1'000);
            QVERIFY(isEverySwathOnce(order.order, count));
            QVERIFY(order.cost >= best.cost - 1e-9);
            found += order.cost <= best.cost + 1e-6 ? 1 : 0;
            const OrderBound bound = boundOf(costs, best.cost);
            VERIFY_TOLD(bound.cost <= best.cost + 1e-9, QByteArray::number(i));
            QVERIFY(assignmentBound(costs) <= best.cost + 1e-9);
            const double gap = best.cost / bound.cost - 1.0;
            worstGap = std::max(worstGap, gap);
            sumOfGaps += gap / kInstances;
            // Links that no cheaper order has are left out: of a dear order few, of the best one most.
            const FoundOrder plain{.order = test::plainOrder(count),
                                   .cost = costs.of(test::plainOrder(count))};
            const FoundOrder* const known = i % 10 < 5 ? &order : &plain;
            const OrderBound below = boundOf(costs, known->cost);
            if (i % 5 == 0) {
                const ProvedOrder proved = branchAndBound(costs, *known, below, 20'000, {});
                COMPARE_WITHIN(proved.found.cost, best.cost, 1e-6);
                COMPARE_WITHIN(proved.bound, best.cost, 1e-6);
            }
            if (best.cost < known->cost - 1e-6) {
                const auto links = linksOfCheaperOrders(costs, below, known->cost);
                for (std::size_t step = 1; step < count; ++step) {
                    const std::pair<SwathEnd, SwathEnd> ends =
                        std::minmax({otherEnd(best.order[step - 1]), best.order[step]});
                    const bool isThere = std::ranges::any_of(links, [&](const UndirectedLink& link) {
                        return link.a == ends.first && link.b == ends.second;
                    });
                    VERIFY_TOLD(isThere, QByteArray::number(i));
                }
                ++dearer;
            }
            kept += linksOfCheaperOrders(costs, bound, best.cost).size();
            all += 2 * count * (count - 1);
        }
        VERIFY_TOLD(found >= kInstances * 99 / 100, QByteArray::number(found));
        VERIFY_TOLD(sumOfGaps < 0.01, QByteArray::number(sumOfGaps));
        VERIFY_TOLD(worstGap < 0.15, QByteArray::number(worstGap));
        VERIFY_TOLD(dearer > 100, QByteArray::number(dearer));
        VERIFY_TOLD(kept < all / 2, QByteArray::number(static_cast<double>(kept) / static_cast<double>(all)));
    }

    // On larger ones nothing that is found is below the bound, and more rounds are no worse.
    void largeInstances() {
        std::mt19937_64 random{21};
        for (const std::size_t count : {40, 120, 300}) {
            const double width = test::uniform(random, 2.0, 6.0);
            LinkCosts costs = test::trackCosts(test::randomTracks(random, count, width),
                                               test::uniform(random, 0.4, 3.0) * width, TurnKind::BulbOrU);
            const FoundOrder first = searched(costs, 0);
            const FoundOrder order = searched(costs, 4'000);
            QVERIFY(isEverySwathOnce(order.order, count));
            QVERIFY(first.cost <= costs.of(test::plainOrder(count)));
            QVERIFY(order.cost <= first.cost);
            const OrderBound bound = boundOf(costs, order.cost);
            VERIFY_TOLD(bound.cost <= order.cost && bound.cost > 0.85 * order.cost,
                        QByteArray::number(bound.cost / order.cost));
        }
    }

    void nothingAndOneSwath() {
        LinkCosts none{0, {.link = {}, .atLeast = {}, .begin = {}, .finish = {}, .fitting = {}}};
        QCOMPARE(cheapestOrder(none).order.size(), std::size_t{0});
        QCOMPARE(boundOf(none, 0.0).cost, 0.0);
        LinkCosts one{1,
                      {.link = {},
                       .atLeast = {},
                       .begin = [](SwathEnd end) { return 5.0 + end; },
                       .finish = [](SwathEnd end) { return 1.0 + 3.0 * end; },
                       .fitting = {}}};
        // Entered at its end: 6 + 1. At its start: 5 + 4.
        QCOMPARE(cheapestOrder(one).order, EndOrder{1});
        QCOMPARE(cheapestOrder(one).cost, 7.0);
        QCOMPARE(searched(one, 100).cost, 7.0);
        QVERIFY(boundOf(one, 7.0).cost <= 7.0);
    }

    // The same seed gives the same order; a stop gives the best so far.
    void repeatedAndStopped() {
        std::mt19937_64 random{22};
        const auto tracks = test::randomTracks(random, 60, 3.0);
        const LinkCosts costs = test::trackCosts(tracks, 6.0, TurnKind::BulbOrU);
        QCOMPARE(searched(costs, 2'000), searched(costs, 2'000));
        std::stop_source stop;
        stop.request_stop();
        const NearEnds near = nearEnds(costs, kNear);
        const std::vector<EndOrder> starts{test::plainOrder(60)};
        const FoundOrder kept =
            searchedOrder({.costs = costs, .near = near, .starts = starts, .rounds = 1'000'000},
                          {.stop = stop.get_token(), .progress = {}});
        QVERIFY(isEverySwathOnce(kept.order, 60));
        QCOMPARE(kept.cost, costs.of(starts[0]));
    }

    // A link that is found not to fit is dearer from then on, and never cheaper than in free space.
    void checkedLinks() {
        const auto free = [](SwathEnd, SwathEnd) { return 10.0; };
        LinkCosts costs{
            2,
            {.link = free,
             .atLeast = {},
             .begin = {},
             .finish = {},
             .fitting = [](SwathEnd leaving, SwathEnd) -> std::optional<double> {
                 return leaving == 0 ? std::optional{25.0} : leaving == 1 ? std::optional{4.0} : std::nullopt;
             }}};
        QCOMPARE(costs.link(0, 2), 10.0);
        QVERIFY(costs.check(0, 2));
        QCOMPARE(costs.link(0, 2), 25.0);
        QVERIFY(!costs.check(0, 2));
        QVERIFY(!costs.check(1, 2));
        QCOMPARE(costs.link(1, 2), 10.0);
        QVERIFY(!costs.check(2, 0));
        QCOMPARE(costs.link(2, 0), 10.0);
        QCOMPARE(costs.eitherWay(0, 2), 10.0);
    }
};

FURROW_TEST(BestOrderTest);
#include "tst_best_order.moc"
