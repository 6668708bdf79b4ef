#include "planner/route/order_edits.h"
#include "tests/support/field_generator.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <limits>
#include <numeric>
#include <random>

using namespace furrow;

namespace {

std::vector<RouteStep> toAndFro(std::size_t count) {
    std::vector<RouteStep> steps;
    steps.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        steps.push_back({.swath = i, .reversed = i % 2 == 1});
    }
    return steps;
}

double waysM(const std::vector<RouteStep>& steps, const SwathSet& swaths) {
    double sum = 0.0;
    for (std::size_t i = 1; i < steps.size(); ++i) {
        sum += distance(endPose(steps[i - 1], swaths).position, startPose(steps[i], swaths).position);
    }
    return sum;
}

}  // namespace

class TestOrderEdits : public QObject {
    Q_OBJECT

private slots:
    // Four swaths of 100 m, 5 m apart: the order 2, 3, 1, 4 again goes up and down by turns.
    void movesByHand() {
        const SwathSet swaths = test::swathsOf({test::rectangle(100.0, 20.0)}, 5.0, 0.0);
        const auto moved = withStepMoved(toAndFro(4), 0, 2, swaths);
        QCOMPARE(orderText(moved), std::string{"2,-3,1,-4"});
        QCOMPARE(orderText(withStepMoved(moved, 2, 0, swaths)), std::string{"1,-2,3,-4"});
        QCOMPARE(orderText(withStepMoved(moved, 1, 1, swaths)), orderText(moved));
    }

    void turnsOne() {
        const SwathSet swaths = test::swathsOf({test::rectangle(100.0, 20.0)}, 5.0, 0.0);
        QCOMPARE(orderText(withStepTurned(toAndFro(4), 1, swaths)), std::string{"1,2,3,-4"});
    }

    // No other directions have shorter ways: against all of them.
    void directionsAreTheBest() {
        std::mt19937_64 random{31};
        for (int i = 0; i < 50; ++i) {
            const SwathSet swaths =
                test::swathsOf({test::rectangle(30.0 + static_cast<double>(random() % 90), 40.0)}, 5.0, 0.0);
            const std::size_t count = swaths.swaths.size();
            std::vector<RouteStep> steps = toAndFro(count);
            std::ranges::shuffle(steps, random);
            const auto moved = withStepMoved(steps, random() % count, 0, swaths);
            double best = std::numeric_limits<double>::infinity();
            for (std::size_t turned = 0; turned < (std::size_t{1} << count); ++turned) {
                std::vector<RouteStep> other = moved;
                for (std::size_t k = 0; k < count; ++k) {
                    other[k].reversed = ((turned >> k) & 1U) != 0;
                }
                best = std::min(best, waysM(other, swaths));
            }
            QVERIFY(moved == steps || waysM(moved, swaths) < best + 1e-9);
        }
    }
};

FURROW_TEST(TestOrderEdits);
#include "tst_order_edits.moc"
