// Which ways there are is told by the test: what is looked at is what becomes of the legs.

#include "planner/path/way_repair.h"
#include "tests/support/field_generator.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

using namespace furrow;

namespace {

Leg straight(SegmentKind kind, int number, Point from, Point to) {
    const Point way = to - from;
    return {.kind = kind,
            .number = number,
            .line = {.type = {},
                     .start = {.position = from, .heading = radians(std::atan2(way.y, way.x))},
                     .pieces = {{.length = metres(norm(way)), .curvature = {}}}}};
}

Leg pass(int number, Point from, Point to) {
    return straight(SegmentKind::HeadlandPass, number, from, to);
}

/// A circle of 20 m, begun at its rightmost point.
Leg roundPass(int number) {
    Leg leg{
        .kind = SegmentKind::HeadlandPass,
        .number = number,
        .line = {.type = {}, .start = {.position = {70.0, 50.0}, .heading = degrees(90.0)}, .pieces = {}}};
    const Curvature bend = Curvature::fromSi(1.0 / 20.0);
    leg.line.pieces.push_back(
        {.length = metres(40.0 * std::numbers::pi), .curvature = bend, .endCurvature = bend});
    return leg;
}

/// There is a way wherever the test says so.
std::vector<Leg> repaired(std::vector<Leg> legs, const std::function<bool(const Pose&, const Pose&)>& leads) {
    RememberedWays ways{[&](const Pose& leaving, const Pose& arriving, const JobContext&, SearchEffort) {
        return leads(leaving, arriving)
                   ? std::optional<Curve>{Curve{.type = {}, .start = leaving, .pieces = {}}}
                   : std::nullopt;
    }};
    const MultiPolygon field{test::rectangle(200.0, 200.0, {-50.0, -50.0})};
    const Rig lowered{field, test::agbot(), ImplementAt::Lowered};
    return withWaysBetween(std::move(legs), ways, lowered,
                           DrivenParts::of(field, test::agbot(), {}, {}).value(), {});
}

std::vector<int> numbersOf(const std::vector<Leg>& legs) {
    std::vector<int> numbers;
    for (const Leg& leg : legs) {
        numbers.push_back(leg.number);
    }
    return numbers;
}

bool isAt(const Pose& pose, Point place) {
    return distance(pose.position, place) < 1e-6;
}

}  // namespace

class WayRepairTest : public QObject {
    Q_OBJECT

private slots:
    /// Three yards of 40 m side by side, with 1 m between them.
    void partByPart_data() {
        QTest::addColumn<QList<int>>("yards");  // in which the legs lie, in order
        QTest::addColumn<QList<int>>("order");  // of the legs then
        QTest::newRow("one yard") << QList<int>{1, 1, 1} << QList<int>{0, 1, 2};
        QTest::newRow("swaths, then headlands") << QList<int>{0, 0, 1, 0, 1} << QList<int>{0, 1, 3, 2, 4};
        QTest::newRow("the last leg's yard last") << QList<int>{0, 1, 2, 0, 1} << QList<int>{0, 3, 2, 1, 4};
        QTest::newRow("begun and ended in one") << QList<int>{0, 1, 2, 1, 0} << QList<int>{0, 4, 1, 3, 2};
    }
    void partByPart() {
        QFETCH(QList<int>, yards);
        QFETCH(QList<int>, order);
        MultiPolygon field;
        for (int yard = 0; yard < 3; ++yard) {
            field.push_back(test::rectangle(40.0, 40.0, {41.0 * yard, 0.0}));
        }
        const DrivenParts parts = DrivenParts::of(field, test::agbot(), {}, {}).value();
        std::vector<Leg> legs;
        for (int i = 0; i < yards.size(); ++i) {
            const double xM = 41.0 * yards[i] + 2.0;
            legs.push_back(pass(i, {xM, 5.0 + i}, {xM + 36.0, 5.0 + i}));
        }
        const std::vector<int> numbers = numbersOf(furrow::partByPart(std::move(legs), parts));
        QCOMPARE(QList<int>(numbers.begin(), numbers.end()), order);
    }

    void nothingIsChangedWhereAllLead() {
        const std::vector<Leg> legs{pass(1, {0, 0}, {50, 0}), pass(2, {50, 5}, {0, 5}),
                                    pass(3, {0, 10}, {50, 10})};
        const auto same = repaired(legs, [](const Pose&, const Pose&) { return true; });
        QCOMPARE(numbersOf(same), (std::vector{1, 2, 3}));
        for (std::size_t i = 0; i < legs.size(); ++i) {
            QCOMPARE(same[i].line, legs[i].line);
        }
    }

    // Nobody gets to (50, 5), but to (0, 5) one does: the second pass is driven from there.
    void aPassIsTurnedRound() {
        const auto legs =
            repaired({pass(1, {0, 0}, {50, 0}), pass(2, {50, 5}, {0, 5}), pass(3, {0, 10}, {50, 10})},
                     [](const Pose&, const Pose& arriving) { return !isAt(arriving, {50, 5}); });
        QCOMPARE(numbersOf(legs), (std::vector{1, 2, 3}));
        QVERIFY(isAt(legs[1].line.start, {0, 5}) && isAt(legs[1].line.end(), {50, 5}));
        QVERIFY(std::abs(std::remainder(legs[1].line.start.heading.si(), 2.0 * std::numbers::pi)) < 1e-9);
    }

    // Out of (50, 0) nobody gets: the first pass has to end elsewhere.
    void thePassBeforeIsTurnedRound() {
        const auto legs = repaired({pass(1, {0, 0}, {50, 0}), pass(2, {50, 5}, {0, 5})},
                                   [](const Pose& leaving, const Pose&) { return !isAt(leaving, {50, 0}); });
        QCOMPARE(numbersOf(legs), (std::vector{1, 2}));
        QVERIFY(isAt(legs[0].line.end(), {0, 0}));
    }

    // To the rightmost point of a circle there is no way, to its left half there is.
    void aClosedPassBeginsElsewhere() {
        const Leg round = roundPass(2);
        const auto legs =
            repaired({pass(1, {0, 0}, {50, 0}), round, pass(3, {0, 10}, {50, 10})},
                     [](const Pose&, const Pose& arriving) { return arriving.position.x < 49.0; });
        QCOMPARE(numbersOf(legs), (std::vector{1, 2, 3}));
        QVERIFY(legs[1].line.start.position.x < 49.0);
        QVERIFY(distance(legs[1].line.start.position, legs[1].line.end().position) < 1e-6);
        QVERIFY(std::abs(distance(legs[1].line.start.position, {50.0, 50.0}) - 20.0) < 1e-6);
        QVERIFY(std::abs((legs[1].line.length() - round.line.length()).si()) < 1e-6);
    }

    // Pass 2 can only be reached from pass 3 and only be left to pass 4.
    void aPassIsDrivenElsewhere() {
        const auto legs = repaired({pass(1, {0, 0}, {50, 0}), pass(2, {50, 5}, {0, 5}),
                                    pass(3, {0, 10}, {50, 10}), pass(4, {50, 15}, {0, 15})},
                                   [](const Pose& leaving, const Pose& arriving) {
                                       const auto isSecond = [](const Pose& pose) {
                                           return std::abs(pose.position.y - 5.0) < 1e-6;
                                       };
                                       return isSecond(arriving)  ? leaving.position.y > 9.0
                                              : isSecond(leaving) ? arriving.position.y > 14.0
                                                                  : true;
                                   });
        QCOMPARE(numbersOf(legs), (std::vector{1, 3, 2, 4}));
    }

    // Swaths are as the route has them, and what cannot be mended stays.
    void whatCannotBeMendedStays() {
        const std::vector<Leg> swaths{straight(SegmentKind::Swath, 1, {0, 0}, {50, 0}),
                                      straight(SegmentKind::Swath, 2, {50, 5}, {0, 5})};
        const auto nowhere = [](const Pose&, const Pose&) { return false; };
        const auto same = repaired(swaths, nowhere);
        QCOMPARE(numbersOf(same), (std::vector{1, 2}));
        QCOMPARE(same[1].line, swaths[1].line);
        const std::vector<Leg> passes{pass(1, {0, 0}, {50, 0}), pass(2, {50, 5}, {0, 5}),
                                      pass(3, {0, 10}, {50, 10})};
        QCOMPARE(numbersOf(repaired(passes, nowhere)), (std::vector{1, 2, 3}));
    }
};

FURROW_TEST(WayRepairTest);
#include "tst_way_repair.moc"
