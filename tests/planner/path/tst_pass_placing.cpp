// Where short passes come between other legs, and in which direction. Places are worked out by hand from the
// headings with which the machine leaves and arrives: what goes on straight is quicker than what turns round.

#include "planner/path/pass_placing.h"
#include "planner/turns/best_feasible.h"
#include "planner/turns/connection.h"
#include "tests/support/field_generator.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <numbers>
#include <optional>
#include <vector>

using namespace furrow;

namespace {

constexpr double kEast = 0.0;
constexpr double kNorth = 0.5 * std::numbers::pi;
constexpr double kWest = std::numbers::pi;
constexpr double kSouth = -0.5 * std::numbers::pi;

Curve line(Point start, double heading, double lengthM) {
    return {.type = {},
            .start = {.position = start, .heading = radians(heading)},
            .pieces = {{.length = metres(lengthM), .curvature = {}}}};
}

Leg leg(Point start, double heading, double lengthM) {
    return {.kind = SegmentKind::Swath, .number = 1, .line = line(start, heading, lengthM)};
}

HeadlandPass pass(Curve one, std::optional<Curve> otherWay = {}) {
    return {.ring = 0,
            .width = metres(3.0),
            .closed = false,
            .stretches = {{.line = std::move(one), .working = true, .otherWay = std::move(otherWay)}}};
}

Machine cultivator() {
    return findMachine("cultivator").value();
}

/// Every way in free space.
RememberedWays freeWays() {
    return RememberedWays{[](const Pose& leaving, const Pose& arriving, const JobContext&, SearchEffort) {
        return std::optional{connection(leaving, arriving, cultivator(), kBestFeasibleMethod.run)};
    }};
}

PlacedPasses placed(std::vector<Leg> legs, const std::vector<HeadlandPass>& passes) {
    RememberedWays ways = freeWays();
    return withPassesBetween(std::move(legs), passes, ways, cultivator(), {});
}

Leg headlandLeg(Point start, double heading, double lengthM) {
    return {.kind = SegmentKind::HeadlandPass, .number = 1, .line = line(start, heading, lengthM)};
}

/// In a field without edges near by.
std::vector<Leg> moved(std::vector<Leg> legs) {
    const MultiPolygon field{test::rectangle(10'000.0, 10'000.0, {-5000, -5000})};
    RememberedWays ways = freeWays();
    return withShortPassesMoved(std::move(legs), ways, Rig{field, cultivator(), ImplementAt::Lowered}, {});
}

bool isAt(const Leg& leg, Point start) {
    return distance(leg.line.start.position, start) < 1e-9;
}

}  // namespace

class TestPassPlacing : public QObject {
    Q_OBJECT

private slots:
    void aPassIsDrivenInTheDirectionThatTheWaysHave() {
        // From the first leg to the second the machine turns left twice: a pass between is driven north.
        const std::vector<Leg> legs{leg({0, 0}, kEast, 100), leg({100, 50}, kWest, 100)};
        const Curve north = line({120, 15}, kNorth, 20);
        const Curve south = line({120, 35}, kSouth, 20);
        for (const HeadlandPass& one : {pass(south, north), pass(north, south)}) {
            const PlacedPasses finished = placed(legs, {one});
            QCOMPARE(finished.put.size(), std::size_t{1});
            QVERIFY(finished.refused.empty());
            QCOMPARE(finished.legs.size(), std::size_t{3});
            QVERIFY(isAt(finished.legs[1], {120, 15}));
            // The pass that was put is the one that is driven.
            QVERIFY(finished.put.front().stretches.front().line == north);
        }
        // With room in one direction only, it is that one.
        QVERIFY(isAt(placed(legs, {pass(south)}).legs[1], {120, 35}));
    }
    void aGapFartherAwayMayBeQuicker() {
        // The first gap is nearer by 10 m of straight lines, but the machine faces south there, and would
        // turn round twice. At the other one it turns right twice.
        const std::vector<Leg> legs{leg({20, 116}, kSouth, 100), leg({20, -16}, kSouth, 100),
                                    leg({145, -10}, kWest, 100), leg({45, 10}, kEast, 100)};
        const PlacedPasses finished = placed(legs, {pass(line({20, -10}, kNorth, 20))});
        QCOMPARE(finished.legs.size(), std::size_t{5});
        QVERIFY(isAt(finished.legs[3], {20, -10}));
    }
    void passesOnOneLineFollowEachOther() {
        // Whichever is placed first.
        const std::vector<Leg> legs{leg({0, 0}, kNorth, 50), leg({0, 200}, kNorth, 50)};
        const HeadlandPass near = pass(line({0, 80}, kNorth, 10));
        const HeadlandPass far = pass(line({0, 120}, kNorth, 10));
        for (const auto& passes : {std::vector{near, far}, std::vector{far, near}}) {
            const PlacedPasses finished = placed(legs, passes);
            QCOMPARE(finished.legs.size(), std::size_t{4});
            QVERIFY(isAt(finished.legs[1], {0, 80}));
            QVERIFY(isAt(finished.legs[2], {0, 120}));
        }
    }
    void withoutAWayAPassIsRefused() {
        const Machine machine = cultivator();
        RememberedWays none{
            [](const Pose&, const Pose&, const JobContext&, SearchEffort) { return std::optional<Curve>{}; }};
        const std::vector<Leg> legs{leg({0, 0}, kNorth, 50), leg({0, 200}, kNorth, 50)};
        const PlacedPasses finished =
            withPassesBetween(legs, {pass(line({0, 80}, kNorth, 10))}, none, machine, {});
        QCOMPARE(finished.refused.size(), std::size_t{1});
        QVERIFY(finished.put.empty());
        QCOMPARE(finished.legs.size(), std::size_t{2});
    }
    void noPassComesBeforeTheWayInOrAfterTheWayOut() {
        // All on one line; by the ways alone both would be first and last.
        Leg in = leg({0, 0}, kEast, 10);
        Leg out = leg({190, 0}, kEast, 10);
        in.kind = out.kind = SegmentKind::Transfer;
        const std::vector<Leg> legs{in, leg({50, 0}, kEast, 100), out};
        const PlacedPasses finished =
            placed(legs, {pass(line({-60, 0}, kEast, 20)), pass(line({240, 0}, kEast, 20))});
        QCOMPARE(finished.legs.size(), std::size_t{5});
        QVERIFY(isAt(finished.legs.front(), {0, 0}));
        QVERIFY(isAt(finished.legs.back(), {190, 0}));
    }
    void aShortPassFarOutOfTheWayIsDrivenWhereTheMachineComesBy() {
        // All on one line to the east. The pass lies between the last two legs.
        const std::vector<Leg> legs{leg({0, 0}, kEast, 100), headlandLeg({600, 0}, kEast, 20),
                                    leg({200, 0}, kEast, 100), leg({400, 0}, kEast, 100),
                                    leg({800, 0}, kEast, 100)};
        const auto found = moved(legs);
        QCOMPARE(found.size(), legs.size());
        QVERIFY(isAt(found[1], {200, 0}));
        QVERIFY(isAt(found[3], {600, 0}));
        QVERIFY(found[3].kind == SegmentKind::HeadlandPass);
    }
    void aShortPassIsTurnedRoundWhereThatSavesMuch() {
        // Between two legs to the east it is driven to the west, with a turn round at both ends.
        const std::vector<Leg> legs{leg({0, 0}, kEast, 100), headlandLeg({170, 0}, kWest, 20),
                                    leg({220, 0}, kEast, 100)};
        const auto found = moved(legs);
        QCOMPARE(found.size(), legs.size());
        QVERIFY(isAt(found[1], {150, 0}));
    }
    void otherPassesStay() {
        const auto stays = [](const std::vector<Leg>& legs) {
            return std::ranges::equal(moved(legs), legs, [](const Leg& a, const Leg& b) {
                return a.line == b.line && a.kind == b.kind;
            });
        };
        const Leg first = leg({0, 0}, kEast, 100);
        const std::vector<Leg> back{leg({200, 0}, kEast, 100), leg({400, 0}, kEast, 100),
                                    leg({800, 0}, kEast, 100)};
        const auto before = [&](std::vector<Leg> legs) {
            legs.insert(legs.begin(), first);
            legs.insert(legs.end(), back.begin(), back.end());
            return legs;
        };
        // Nothing is to be gained, ...
        QVERIFY(stays({first, headlandLeg({150, 0}, kEast, 20), leg({220, 0}, kEast, 100)}));
        // ... it is no short pass, ...
        QVERIFY(stays(before({headlandLeg({600, 0}, kEast, 60)})));
        // ... no pass of the headland, ...
        QVERIFY(stays(before({leg({600, 0}, kEast, 20)})));
        // ... or goes on without a way.
        QVERIFY(stays(before({headlandLeg({600, 0}, kEast, 20), headlandLeg({620, 0}, kEast, 60)})));
        // A short one alone would be moved.
        QVERIFY(!stays(before({headlandLeg({600, 0}, kEast, 20)})));
    }
};

FURROW_TEST(TestPassPlacing);
#include "tst_pass_placing.moc"
