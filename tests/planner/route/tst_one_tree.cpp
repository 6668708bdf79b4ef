#include "planner/route/one_tree.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

using namespace furrow;

namespace {

struct Links {
    std::size_t swaths = 0;
    std::vector<UndirectedLink> all;
    std::vector<double> depot;
    std::vector<double> multipliers;
};

/// Whole costs, so that many are equal.
Links randomLinks(std::uint64_t seed, int shareInHundred) {
    std::mt19937_64 random{seed};
    const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
    Links links;
    links.swaths = 2 + below(30);
    for (SwathEnd a = 0; a < 2 * links.swaths; ++a) {
        for (SwathEnd b = a + 1; b < 2 * links.swaths; ++b) {
            if (a / 2 != b / 2 && below(100) < static_cast<std::size_t>(shareInHundred)) {
                links.all.push_back({a, b, static_cast<double>(below(12))});
            }
        }
        links.depot.push_back(static_cast<double>(below(9)));
        links.multipliers.push_back(static_cast<double>(below(5)) - 2.0);
    }
    return links;
}

/// All links by weight, each taken that joins two trees (Kruskal 1956).
std::vector<std::size_t> treeByWeight(const Links& links) {
    const auto weight = [&](std::size_t i) {
        const UndirectedLink& link = links.all[i];
        return link.cost + links.multipliers[link.a] + links.multipliers[link.b];
    };
    std::vector<std::size_t> order(links.all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::pair{weight(i), i}; });
    std::vector<std::size_t> treeOf(links.swaths);
    std::iota(treeOf.begin(), treeOf.end(), std::size_t{0});
    std::vector<std::size_t> taken;
    for (const std::size_t i : order) {
        const std::size_t from = treeOf[links.all[i].a / 2];
        const std::size_t to = treeOf[links.all[i].b / 2];
        if (from != to) {
            std::ranges::replace(treeOf, from, to);
            taken.push_back(i);
        }
    }
    return taken;
}

}  // namespace

class TestOneTree : public QObject {
    Q_OBJECT

private slots:
    void treesAreTheLeast_data() {
        QTest::addColumn<int>("shareInHundred");
        QTest::newRow("every two ends are linked") << 100;
        QTest::newRow("some are") << 30;
        QTest::newRow("so few that some swaths are alone") << 3;
    }
    void treesAreTheLeast() {
        QFETCH(int, shareInHundred);
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            const Links links = randomLinks(seed, shareInHundred);
            OneTreeFinder finder{{.swathCount = links.swaths,
                                  .links = links.all,
                                  .begin = links.depot,
                                  .finish = links.depot}};
            // Once more with others before: nothing stays of them.
            const std::vector<double> none(links.multipliers.size(), 0.0);
            finder.find(none);
            const OneTree& tree = finder.find(links.multipliers);
            const std::vector<std::size_t> expected = treeByWeight(links);
            QVERIFY(tree.links == expected);
            QCOMPARE(tree.cost < std::numeric_limits<double>::infinity(),
                     expected.size() + 1 == links.swaths);
        }
    }
};

FURROW_TEST(TestOneTree);
#include "tst_one_tree.moc"
