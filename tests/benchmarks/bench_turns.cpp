#include "planner/turns/continuous_curvature.h"
#include "planner/turns/dubins.h"
#include "planner/turns/named_turns.h"
#include "planner/turns/reeds_shepp.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/test_program.h"

#include <vector>

using namespace furrow;
using namespace furrow::test;

using Named = Curve (*)(const Pose&, const Pose&, Length);
Q_DECLARE_METATYPE(Named)

/// Every figure is for a thousand turns: milliseconds read as microseconds each.
class TurnsBenchmark : public QObject {
    Q_OBJECT

    std::vector<PosePair> pairs_;

    template <class Drive>
    void thousand(Drive drive) {
        double sum = 0.0;
        QBENCHMARK {
            for (const PosePair& pair : pairs_) {
                sum += drive(pair.from, pair.to, metres(pair.radiusM));
            }
        }
        QVERIFY(sum > 0.0);
    }

private slots:
    void initTestCase() {
        std::mt19937_64 random{1};
        for (int i = 0; i < 1000; ++i) {
            pairs_.push_back(i % 2 == 0 ? swathPair(random) : randomPair(random));
        }
    }

    void dubinsLengths() {
        thousand([](const Pose& a, const Pose& b, Length r) { return dubinsLength(a, b, r).si(); });
    }
    void dubinsTurns() {
        thousand([](const Pose& a, const Pose& b, Length r) { return dubinsTurn(a, b, r).length().si(); });
    }
    void reedsSheppLengths() {
        thousand([](const Pose& a, const Pose& b, Length r) { return reedsSheppLength(a, b, r).si(); });
    }
    void reedsSheppTurns() {
        thousand(
            [](const Pose& a, const Pose& b, Length r) { return reedsSheppTurn(a, b, r).length().si(); });
    }
    void continuousDubinsTurns() {
        thousand([](const Pose& a, const Pose& b, Length r) {
            return continuousDubinsTurn(a, b, r, CurvatureRate::fromSi(0.1)).length().si();
        });
    }
    void continuousReedsSheppTurns() {
        thousand([](const Pose& a, const Pose& b, Length r) {
            return continuousReedsSheppTurn(a, b, r, CurvatureRate::fromSi(0.1)).length().si();
        });
    }
    void namedTurns_data() {
        QTest::addColumn<Named>("named");
        QTest::newRow("U") << Named{uTurn};
        QTest::newRow("omega") << Named{omegaTurn};
        QTest::newRow("P") << Named{pTurn};
        QTest::newRow("fishtail") << Named{fishtailTurn};
        QTest::newRow("three-point") << Named{threePointTurn};
    }
    void namedTurns() {
        QFETCH(Named, named);
        thousand([&](const Pose& a, const Pose& b, Length r) { return named(a, b, r).length().si(); });
    }
};

FURROW_TEST(TurnsBenchmark);
#include "bench_turns.moc"
