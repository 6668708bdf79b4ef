// Where work is interrupted to fill the tank, against all possible splits; and what a text of places means.

#include "planner/path/refill_split.h"
#include "planner/settings/places.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <random>

using namespace furrow;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// The cost of trips before the pieces of a mask, or never where a tank does not last.
double costOf(unsigned mask, const RefillTask& task, const std::vector<double>& real) {
    double used = 0.0;
    double cost = 0.0;
    for (std::size_t i = 0; i < task.uses.size(); ++i) {
        if (i > 0 && (mask >> i & 1U) != 0) {
            used = 0.0;
            cost += real[i];
        }
        used += task.uses[i];
        if (used > task.capacity) {
            return kNever;
        }
    }
    return cost;
}

Result<std::vector<std::size_t>> split(const RefillTask& task, const std::vector<double>& real,
                                       std::size_t& asked) {
    return cheapestSplit(task, [&](std::span<const std::size_t> pieces) {
        std::vector<std::optional<double>> costs;
        for (const std::size_t piece : pieces) {
            ++asked;
            costs.push_back(real[piece] < kNever ? std::optional{real[piece]} : std::nullopt);
        }
        return Result<std::vector<std::optional<double>>>{std::move(costs)};
    });
}

}  // namespace

class RefillSplitTest : public QObject {
    Q_OBJECT

private slots:
    // Eight pieces of 1, a tank of 3: two trips. Those before the pieces 2 and 5 are the cheapest two that
    // work (2 + 3 + 3).
    void byHand() {
        const RefillTask task{
            .uses = std::vector(8, 1.0), .capacity = 3.0, .atLeast = {0, 1, 1, 1, 1, 1, 1, 1}};
        const std::vector<double> real{0, 9, 2, 4, 1, 2, 7, 1};
        std::size_t asked = 0;
        const auto found = split(task, real, asked);
        VERIFY_RESULT(found);
        QCOMPARE(*found, (std::vector<std::size_t>{2, 5}));
    }
    void enoughForAll() {
        std::size_t asked = 0;
        const auto found =
            split({.uses = {1.0, 1.0, 1.0}, .capacity = 3.0, .atLeast = {0, 0, 0}}, {0, 1, 1}, asked);
        VERIFY_RESULT(found);
        QVERIFY(found->empty());
        QCOMPARE(asked, std::size_t{0});
    }
    // One piece takes more than a tank: it begins with a full one, and so does the next.
    void onePieceIsTooMuch() {
        std::size_t asked = 0;
        const auto found =
            split({.uses = {1.0, 5.0, 1.0}, .capacity = 3.0, .atLeast = {0, 0, 0}}, {0, 1, 1}, asked);
        VERIFY_RESULT(found);
        QCOMPARE(*found, (std::vector<std::size_t>{1, 2}));
    }
    void againstAllSplits() {
        std::mt19937_64 random{7};
        for (int i = 0; i < 300; ++i) {
            const auto count = static_cast<std::size_t>(test::uniform(random, 1.0, 11.0));
            RefillTask task{.uses = {}, .capacity = test::uniform(random, 1.0, 4.0), .atLeast = {}};
            std::vector<double> real;
            for (std::size_t k = 0; k < count; ++k) {
                task.uses.push_back(test::uniform(random, 0.1, 1.0));
                real.push_back(test::uniform(random, 1.0, 10.0));
                task.atLeast.push_back(test::uniform(random, 0.2, 1.0) * real.back());
            }
            double best = kNever;
            for (unsigned mask = 0; mask < 1U << count; mask += 2) {
                best = std::min(best, costOf(mask, task, real));
            }
            std::size_t asked = 0;
            const auto found = split(task, real, asked);
            VERIFY_RESULT(found);
            unsigned mask = 0;
            for (const std::size_t piece : *found) {
                mask |= 1U << piece;
            }
            QVERIFY2(
                costOf(mask, task, real) <= best + 1e-9,
                qPrintable(
                    QStringLiteral("case %1: %2, best %3").arg(i).arg(costOf(mask, task, real)).arg(best)));
            QVERIFY(asked < count);
        }
    }
    // Where no trip leads, the next one is taken.
    void withoutSomeTrips() {
        std::size_t asked = 0;
        const auto found = split({.uses = std::vector(4, 1.0), .capacity = 3.0, .atLeast = {0, 0, 0, 0}},
                                 {0, kNever, kNever, 4}, asked);
        VERIFY_RESULT(found);
        QCOMPARE(*found, std::vector<std::size_t>{3});
    }

    void textsOfPlaces() {
        const auto both = givenPlaces("Road gate; MULTIPOINT ((4.1 52.0), (4.2 52.1)) ;POINT (4.3 52.2)");
        VERIFY_RESULT(both);
        QCOMPARE(both->size(), std::size_t{4});
        QCOMPARE(both->front().name, std::string{"Road gate"});
        QCOMPARE(both->at(2).point->latDeg, 52.1);
        QCOMPARE(givenPlaces(placesText(*both)).value(), *both);
        QCOMPARE(placesText({{.name = {}, .point = GeoPoint{4.1, 52.0}}}),
                 std::string{"POINT (4.10000000 52.00000000)"});
        QCOMPARE(placesText({{.name = {}, .point = GeoPoint{4.1, 52.0}},
                             {.name = {}, .point = GeoPoint{4.2, 52.0}}}),
                 std::string{"MULTIPOINT ((4.10000000 52.00000000), (4.20000000 52.00000000))"});
        QVERIFY(givenPlaces("")->empty());
        QVERIFY(!givenPlaces("POINT (190 52)"));
        // A line is no point: it is taken for the name of a gate, which the field then does not know.
        QCOMPARE(givenPlaces("LINESTRING (4 52, 5 52)")->front().point, std::nullopt);
    }
};

FURROW_TEST(RefillSplitTest);
#include "tst_refill_split.moc"
