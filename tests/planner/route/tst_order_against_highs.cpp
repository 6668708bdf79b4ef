#include "planner/route/exact_order.h"
#include "planner/route/order_bound.h"
#include "tests/planner/route/track_instances.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <Highs.h>

#include <algorithm>
#include <map>

using namespace furrow;
using test::TurnKind;

namespace {

/// The cheapest order by integer programming: every end has one link or the depot, and rows against tours
/// without the depot are added until there is none.
double optimumByHighs(const LinkCosts& costs) {
    const auto ends = static_cast<SwathEnd>(costs.endCount());
    Highs highs;
    highs.setOptionValue("output_flag", false);
    highs.setOptionValue("mip_rel_gap", 0.0);
    highs.setOptionValue("threads", 1);
    struct Column {
        SwathEnd a;
        SwathEnd b;  ///< the depot is `ends`
    };
    std::vector<Column> columns;
    for (SwathEnd a = 0; a < ends; ++a) {
        for (SwathEnd b = a + 1; b <= ends; ++b) {
            if (b != ends && a / 2 == b / 2) {
                continue;
            }
            columns.push_back({a, b});
            highs.addCol(b == ends ? 0.0 : costs.eitherWay(a, b), 0.0, 1.0, 0, nullptr, nullptr);
            highs.changeColIntegrality(static_cast<HighsInt>(columns.size() - 1), HighsVarType::kInteger);
        }
    }
    for (SwathEnd end = 0; end <= ends; ++end) {
        std::vector<HighsInt> indices;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (columns[i].a == end || columns[i].b == end) {
                indices.push_back(static_cast<HighsInt>(i));
            }
        }
        const std::vector<double> ones(indices.size(), 1.0);
        const double degree = end == ends ? 2.0 : 1.0;
        highs.addRow(degree, degree, static_cast<HighsInt>(indices.size()), indices.data(), ones.data());
    }
    while (true) {
        highs.run();
        const std::vector<double>& value = highs.getSolution().col_value;
        std::map<SwathEnd, SwathEnd> partner;
        SwathEnd first = ends;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            if (value[i] > 0.5) {
                if (columns[i].b == ends) {
                    first = columns[i].a;
                } else {
                    partner[columns[i].a] = columns[i].b;
                    partner[columns[i].b] = columns[i].a;
                }
            }
        }
        std::vector<char> isReached(costs.swathCount(), 0);
        for (SwathEnd at = first;;) {
            isReached[at / 2] = 1;
            const auto next = partner.find(otherEnd(at));
            if (next == partner.end()) {
                break;
            }
            at = next->second;
        }
        if (std::ranges::count(isReached, 1) == static_cast<std::ptrdiff_t>(isReached.size())) {
            return highs.getInfo().objective_function_value;
        }
        // At least one link has to lead from the swaths reached to the others.
        std::vector<HighsInt> indices;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const auto [a, b] = columns[i];
            if (b != ends && isReached[a / 2] != isReached[b / 2]) {
                indices.push_back(static_cast<HighsInt>(i));
            }
        }
        const std::vector<double> ones(indices.size(), 1.0);
        highs.addRow(1.0, kHighsInf, static_cast<HighsInt>(indices.size()), indices.data(), ones.data());
    }
}

}  // namespace

class OrderAgainstHighsTest : public QObject {
    Q_OBJECT

private slots:
    void sameOptimum_data() {
        QTest::addColumn<int>("swaths");
        QTest::addColumn<int>("instances");
        QTest::newRow("8 swaths") << 8 << 10;
        QTest::newRow("11 swaths") << 11 << 6;
        QTest::newRow("16 swaths") << 16 << 4;
    }
    void sameOptimum() {
        QFETCH(int, swaths);
        QFETCH(int, instances);
        std::mt19937_64 random{static_cast<std::uint64_t>(swaths)};
        for (int i = 0; i < instances; ++i) {
            const auto count = static_cast<std::size_t>(swaths);
            LinkCosts costs =
                test::trackCosts(test::randomTracks(random, count, 3.0), test::uniform(random, 2.0, 9.0),
                                 i % 2 == 0 ? TurnKind::BulbOrU : TurnKind::ForwardOmega);
            const double optimum = optimumByHighs(costs);
            const NearEnds near = nearEnds(costs, 10);
            const std::vector<EndOrder> starts{test::plainOrder(count)};
            const FoundOrder found =
                searchedOrder({.costs = costs, .near = near, .starts = starts, .rounds = 5'000}, {});
            const OrderBound bound = heldKarpBound(costs, near, found.cost, 1'500, {});
            QVERIFY(found.cost >= optimum - 1e-6);
            QVERIFY(bound.cost <= optimum + 1e-6);
            const ProvedOrder proved = branchAndBound(costs, found, bound, 20'000, {});
            COMPARE_WITHIN(proved.found.cost, optimum, 1e-4);
            COMPARE_WITHIN(proved.bound, optimum, 1e-4);
            if (count <= kMostByDynamicProgramming) {
                COMPARE_WITHIN(cheapestOrder(costs).cost, optimum, 1e-4);
            }
        }
    }
};

FURROW_TEST(OrderAgainstHighsTest);
#include "tst_order_against_highs.moc"
