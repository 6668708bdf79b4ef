// A draft goes on from the order of the plan before. Orders are worked out by hand: tracks of 100 m along y,
// 3 m apart, track 0 at x = 0, the next ones to its left.

#include "planner/route/earlier_order.h"
#include "planner/route/order_search.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <numbers>
#include <vector>

using namespace furrow;

namespace {

constexpr double kSpacingM = 3.0;

Swath swathAt(double x, double fromY, double toY, int track) {
    return {.start = {x, fromY}, .end = {x, toY}, .number = 0, .track = track, .width = metres(kSpacingM)};
}

SwathSet setOf(std::vector<Swath> swaths) {
    SwathSet set;
    set.swaths = std::move(swaths);
    set.heading = radians(std::numbers::pi / 2.0);
    return set;
}

/// Track i at x = byM - 3 i, from y = 0 to 100.
SwathSet tracks(int count, double byM = 0.0) {
    std::vector<Swath> swaths;
    for (int i = 0; i < count; ++i) {
        swaths.push_back(swathAt(byM - kSpacingM * i, 0.0, 100.0, i));
    }
    return setOf(std::move(swaths));
}

std::vector<DrivenSwath> driven(const SwathSet& set, const EndOrder& order) {
    std::vector<DrivenSwath> swaths;
    for (const RouteStep& step : stepsOf(order)) {
        swaths.push_back(drivenSwath(step, set));
    }
    return swaths;
}

/// 0 up, 3 down, 1 up, 4 down, 2 up.
const EndOrder kSkips{0, 7, 2, 9, 4};

}  // namespace

class TestEarlierOrder : public QObject {
    Q_OBJECT

private slots:
    void theSameSwathsKeepTheirOrder() {
        QVERIFY(orderAsBefore(tracks(5), driven(tracks(5), kSkips)) == kSkips);
    }
    void tracksThatMoveAsideTogetherKeepIt_data() {
        QTest::addColumn<double>("byM");
        for (const double byM : {-1.4, -0.2, 0.2, 1.4}) {
            QTest::addRow("by %.1f m", byM) << byM;
        }
    }
    void tracksThatMoveAsideTogetherKeepIt() {
        QFETCH(double, byM);
        QVERIFY(orderAsBefore(tracks(5, byM), driven(tracks(5), kSkips)) == kSkips);
    }
    void aHeadingTheOtherWayIsTheSameOrder() {
        // Laid from the other side and the other way: swath i was swath 4 - i, and starts where it ended.
        std::vector<Swath> swaths;
        for (int i = 0; i < 5; ++i) {
            swaths.push_back(swathAt(-kSpacingM * (4 - i), 100.0, 0.0, i));
        }
        SwathSet set = setOf(std::move(swaths));
        set.heading = radians(-std::numbers::pi / 2.0);
        QVERIFY(orderAsBefore(set, driven(tracks(5), kSkips)) == (EndOrder{9, 2, 7, 0, 5}));
    }
    void aFurtherTrackComesAfterItsNeighbour() {
        // Beside track 4, which was driven down: up.
        QVERIFY(orderAsBefore(tracks(6), driven(tracks(5), kSkips)) == (EndOrder{0, 7, 2, 9, 10, 4}));
    }
    void fewerTracksKeepTheOrderOfTheRest() {
        QVERIFY(orderAsBefore(tracks(4), driven(tracks(5), kSkips)) == (EndOrder{0, 7, 2, 4}));
    }
    void piecesOfOneTrackAreDrivenInTheSameDirection() {
        // A hole cuts track 3, which is driven down: the upper piece first.
        SwathSet set = tracks(5);
        set.swaths[3] = swathAt(-9.0, 0.0, 40.0, 3);
        set.swaths.insert(set.swaths.begin() + 4, swathAt(-9.0, 60.0, 100.0, 3));
        QVERIFY(orderAsBefore(set, driven(tracks(5), kSkips)) == (EndOrder{0, 9, 7, 2, 11, 4}));
    }
    void longerAndShorterSwathsKeepIt() {
        SwathSet set = tracks(5);
        for (std::size_t i = 0; i < set.swaths.size(); ++i) {
            set.swaths[i].end.y = 60.0 + 20.0 * static_cast<double>(i);
        }
        QVERIFY(orderAsBefore(set, driven(tracks(5), kSkips)) == kSkips);
    }
    void swathsThatWereTurnedHaveAnotherOrder() {
        SwathSet set = tracks(5);
        for (const auto& [degreesTurned, isKept] : {std::pair{15.0, true}, {30.0, false}, {90.0, false}}) {
            const double rad = degreesTurned * std::numbers::pi / 180.0;
            SwathSet turned = set;
            turned.heading = turned.heading + radians(rad);
            for (Swath& swath : turned.swaths) {
                const Point half = 50.0 * direction(turned.heading.si());
                const Point middle{swath.start.x, 50.0};
                swath.start = middle - half;
                swath.end = middle + half;
            }
            QCOMPARE(!orderAsBefore(turned, driven(set, kSkips)).empty(), isKept);
        }
    }
    void withoutAnEarlierOrderThereIsNone() {
        QVERIFY(orderAsBefore(tracks(5), {}).empty());
        QVERIFY(orderAsBefore(setOf({}), driven(tracks(5), kSkips)).empty());
        QVERIFY(
            orderAsBefore(tracks(static_cast<int>(kMostSearched) + 1), driven(tracks(5), kSkips)).empty());
    }
};

FURROW_TEST(TestEarlierOrder);
#include "tst_earlier_order.moc"
