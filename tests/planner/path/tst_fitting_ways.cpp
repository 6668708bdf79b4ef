#include "planner/machine/machine_library.h"
#include "planner/path/fitting_ways.h"
#include "planner/turns/best_feasible.h"
#include "tests/support/field_generator.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <random>

using namespace furrow;

namespace {

/// Two rooms of 60 by 40 m, joined by a neck 20 m long.
MultiPolygon dumbbell(double neckM) {
    const double low = 20.0 - 0.5 * neckM;
    const double high = 20.0 + 0.5 * neckM;
    return {{.outer = {{0, 0},
                       {60, 0},
                       {60, low},
                       {80, low},
                       {80, 0},
                       {140, 0},
                       {140, 40},
                       {80, 40},
                       {80, high},
                       {60, high},
                       {60, 40},
                       {0, 40}},
             .holes = {}}};
}

Pose pose(double x, double y, double headingDeg) {
    return {.position = {x, y}, .heading = degrees(headingDeg)};
}

}  // namespace

// The robot is 2.5 m wide.
class FittingWaysTest : public QObject {
    Q_OBJECT

private slots:
    void partsByTheNeck_data() {
        QTest::addColumn<double>("neckM");
        QTest::addColumn<double>("spareM");
        QTest::addColumn<bool>("separate");
        QTest::newRow("too narrow") << 2.4 << 0.0 << true;
        QTest::newRow("wide enough") << 2.6 << 0.0 << false;
        QTest::newRow("not with room to spare") << 3.2 << 0.4 << true;
        QTest::newRow("with room to spare") << 3.4 << 0.4 << false;
    }
    void partsByTheNeck() {
        QFETCH(double, neckM);
        QFETCH(double, spareM);
        QFETCH(bool, separate);
        const auto parts = DrivenParts::of(dumbbell(neckM), metres(2.5 + 2.0 * spareM), {});
        QVERIFY(parts.has_value());
        QCOMPARE(parts->separate({30.0, 20.0}, {110.0, 20.0}), separate);
        QVERIFY(!parts->separate({30.0, 20.0}, {5.0, 5.0}));
        // Beside an edge the nearest part counts.
        QCOMPARE(parts->separate({0.5, 0.5}, {139.5, 39.5}), separate);
    }

    // A boom of 24 m does not get through where its tractor would.
    void partsByTheMachine_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<double>("neckM");
        QTest::addColumn<double>("spareM");
        QTest::addColumn<bool>("separate");
        QTest::newRow("robot, too narrow") << "agbot" << 2.4 << 0.0 << true;
        QTest::newRow("robot, as wide as it is") << "agbot" << 2.5 << 0.0 << false;
        QTest::newRow("robot, not with room to spare") << "agbot" << 2.9 << 0.5 << true;
        QTest::newRow("sprayer, too narrow") << "trailed-sprayer" << 23.0 << 0.0 << true;
        QTest::newRow("sprayer, wide enough") << "trailed-sprayer" << 25.0 << 0.0 << false;
    }
    void partsByTheMachine() {
        QFETCH(QString, machine);
        QFETCH(double, neckM);
        QFETCH(double, spareM);
        QFETCH(bool, separate);
        const auto parts =
            DrivenParts::of(dumbbell(neckM), findMachine(machine.toStdString()).value(), metres(spareM), {});
        QVERIFY(parts.has_value());
        QCOMPARE(parts->separate({30.0, 20.0}, {110.0, 20.0}), separate);
    }

    // A way through the neck needs a search; one that stays in a room is found all the same, as is a straight
    // one through the neck.
    void narrowNecksAreNotSearchedAgain() {
        FittingWays ways{std::make_shared<WaySearches>(dumbbell(3.0), test::agbot(), TravelCost{})};
        const Pose here = pose(5.0, 5.0, 180.0);
        // Where it does not fit: nothing is found, and from then on it is known what is joined by necks.
        QVERIFY(!ways.between(here, pose(70.0, 20.0, 90.0), {}, SearchEffort::Quick));
        QVERIFY(!ways.between(here, pose(130.0, 35.0, 90.0), {}, SearchEffort::Quick));
        QVERIFY(ways.between(pose(30.0, 20.0, 0.0), pose(110.0, 20.0, 0.0), {}, SearchEffort::Quick));
        QVERIFY(ways.between(here, pose(50.0, 30.0, 0.0), {}, SearchEffort::Quick));
    }

    // Where a tractor gets through, its implement may not: then it is not known.
    void apartByTheTractor_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<double>("neckM");
        QTest::addColumn<bool>("apart");
        QTest::newRow("robot, too narrow") << "agbot" << 2.4 << true;
        QTest::newRow("robot, as wide as it is") << "agbot" << 2.5 << false;
        QTest::newRow("sprayer, too narrow for its tractor") << "trailed-sprayer" << 2.4 << true;
        QTest::newRow("sprayer, too narrow for its boom only") << "trailed-sprayer" << 5.0 << false;
    }
    void apartByTheTractor() {
        QFETCH(QString, machine);
        QFETCH(double, neckM);
        QFETCH(bool, apart);
        WaySearches ways{dumbbell(neckM), findMachine(machine.toStdString()).value(), TravelCost{}};
        QCOMPARE(ways.areApart(pose(30.0, 20.0, 0.0), pose(110.0, 20.0, 180.0)), apart);
        QCOMPARE(ways.areApart(pose(110.0, 5.0, 90.0), pose(30.0, 35.0, 0.0)), apart);
        QVERIFY(!ways.areApart(pose(30.0, 20.0, 0.0), pose(5.0, 5.0, 90.0)));
        QVERIFY(!ways.areApart(pose(1.5, 38.0, 0.0), pose(58.0, 2.0, 180.0)));
    }

    // No search finds a way between places that are apart, and every search finds what it finds without that.
    void whatIsApartHasNoWay() {
        std::mt19937_64 random{20261129};
        int apart = 0;
        int joined = 0;
        for (int i = 0; i < 24; ++i) {
            const MultiPolygon field = dumbbell(test::uniform(random, 2.0, 2.9));
            const Rig rig{field, test::agbot()};
            WaySearches ways{field, test::agbot(), TravelCost{}};
            const auto place = [&](double fromX, double toX) {
                return pose(test::uniform(random, fromX, toX), test::uniform(random, 4.0, 36.0),
                            test::uniform(random, 0.0, 360.0));
            };
            const Pose from = place(4.0, 56.0);
            const Pose to = i % 3 == 0 ? place(4.0, 56.0) : place(84.0, 136.0);
            const auto alone = fittingConnection(rig, from, to, {}, {});
            QVERIFY(ways.between(from, to, {}, SearchEffort::Thorough) == alone);
            if (ways.areApart(from, to)) {
                ++apart;
                QVERIFY(!alone);
            } else {
                ++joined;
            }
        }
        QVERIFY(apart >= 6);
        QVERIFY(joined >= 10);
    }
};

FURROW_TEST(FittingWaysTest);
#include "tst_fitting_ways.moc"
