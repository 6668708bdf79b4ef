#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"
#include "tests/planner/turns/turn_check.h"
#include "tests/support/test_program.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

using namespace furrow;
using namespace furrow::test;

namespace {

namespace ob = ompl::base;
constexpr std::uint64_t kSeed = 20'250'401;
constexpr int kPairs = 100'000;

/// The length that a space of OMPL finds.
template <class Space>
double oracleLength(const PosePair& pair) {
    // One space per call: the radius is fixed in it. Its states come from their own heap.
    const auto space = std::make_shared<Space>(pair.radiusM);
    ob::ScopedState<Space> from{space};
    ob::ScopedState<Space> to{space};
    const auto set = [](auto& state, const Pose& p) {
        state->setXY(p.position.x, p.position.y);
        state->setYaw(normalisedPoseHeading(p.heading).si());
    };
    set(from, pair.from);
    set(to, pair.to);
    return space->distance(from.get(), to.get());
}

template <class Ours, class Drive>
void neverLonger(Ours ours, Drive drive, double (*oracle)(const PosePair&), std::uint64_t seed) {
    std::mt19937_64 random{seed};
    double most = 0.0;
    double least = 0.0;
    for (int i = 0; i < kPairs; ++i) {
        const PosePair pair = i % 4 == 0 ? swathPair(random) : randomPair(random);
        const double theirs = oracle(pair);
        const double length = ours(pair.from, pair.to, metres(pair.radiusM)).si();
        const QByteArray lengths =
            QStringLiteral(": %1, OMPL %2").arg(length, 0, 'g', 15).arg(theirs, 0, 'g', 15).toUtf8();
        VERIFY_TOLD(length <= theirs + 1e-6, told(seed, i, pair) + lengths);
        const Pose end = driven(drive(pair.from, pair.to, metres(pair.radiusM)));
        VERIFY_TOLD(distance(end.position, pair.to.position) < 1e-3, told(seed, i, pair));
        VERIFY_TOLD(headingGap(end, pair.to) < 1e-6, told(seed, i, pair));
        most = std::max(most, length - theirs);
        least = std::min(least, length - theirs);
    }
    qInfo("ours less theirs: %.3g to %.3g m", least, most);
}

}  // namespace

class TurnsAgainstOmplTest : public QObject {
    Q_OBJECT

private slots:
    void dubins() { neverLonger(dubinsLength, dubinsTurn, oracleLength<ob::DubinsStateSpace>, kSeed); }
    void reedsShepp() {
        neverLonger(reedsSheppLength, reedsSheppTurn, oracleLength<ob::ReedsSheppStateSpace>, kSeed + 1);
    }
};

FURROW_TEST(TurnsAgainstOmplTest);
#include "tst_turns_against_ompl.moc"
