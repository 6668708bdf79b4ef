// Where a machine has room to work: by hand at corners and bays, and against poses that GEOS says are inside.

#include "planner/audit/working_room.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/machine/machine_library.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace furrow;

namespace {

WorkingRoom roomOf(const MultiPolygon& field, const Machine& machine) {
    return {field, machine, shapeOf({.workable = field, .drivable = field, .machine = machine})};
}

/// 6 m wide, its frame 1.3 m behind the working line; it is lowered after a metre.
const Machine& cultivator() {
    static const Machine machine = findMachine("cultivator").value();
    return machine;
}

const Machine& agbot() {
    static const Machine machine = findMachine("agbot").value();
    return machine;
}

/// 60 by 40 m, with a bay of this width and 8 m depth in the middle of the upper side.
MultiPolygon fieldWithBay(double width) {
    return {{.outer = {{0, 0},
                       {60, 0},
                       {60, 40},
                       {30 + width / 2, 40},
                       {30 + width / 2, 48},
                       {30 - width / 2, 48},
                       {30 - width / 2, 40},
                       {0, 40}},
             .holes = {}}};
}

}  // namespace

class TestWorkingRoom : public QObject {
    Q_OBJECT
private slots:
    /// What was found at another place before changes no answer.
    void hintsChangeNoAnswer() {
        // The bay is broad enough for the narrow machine only.
        const MultiPolygon field = fieldWithBay(5.0);
        std::mt19937_64 random{5};
        int reached = 0;
        int unreached = 0;
        for (const Machine& machine : {cultivator(), agbot()}) {
            const WorkingRoom room = roomOf(field, machine);
            WorkingRoom::Hint hint;
            for (int i = 0; i < 400; ++i) {
                const Point place{test::uniform(random, 27.6, 32.4), test::uniform(random, 36.0, 48.0)};
                const bool reaches = room.reaches(place);
                QCOMPARE(room.reaches(place, hint), reaches);
                ++(reaches ? reached : unreached);
            }
        }
        QVERIFY2(reached > 20 && unreached > 20,
                 qPrintable(QStringLiteral("%1 reached, %2 not").arg(reached).arg(unreached)));
    }

    void places_data() {
        QTest::addColumn<MultiPolygon>("field");
        QTest::addColumn<Machine>("machine");
        QTest::addColumn<Point>("place");
        QTest::addColumn<bool>("reached");
        const MultiPolygon whole{test::rectangle(60.0, 40.0)};
        QTest::newRow("in the middle") << whole << cultivator() << Point{30, 20} << true;
        QTest::newRow("beside an edge") << whole << cultivator() << Point{30, 0.05} << true;
        // Backed against one side, the working line is 1.3 m of frame and 1 m of run-in from it.
        QTest::newRow("beside an edge near a corner") << whole << cultivator() << Point{2.5, 0.05} << true;
        QTest::newRow("beside the other edge near a corner")
            << whole << cultivator() << Point{0.05, 2.5} << true;
        QTest::newRow("in the corner") << whole << cultivator() << Point{1.2, 1.2} << false;
        QTest::newRow("in the opposite corner") << whole << cultivator() << Point{58.8, 38.8} << false;
        QTest::newRow("a bay that is narrower than the implement")
            << fieldWithBay(5.5) << cultivator() << Point{30, 43} << false;
        QTest::newRow("the mouth of that bay")
            << fieldWithBay(5.5) << cultivator() << Point{30, 39.9} << true;
        QTest::newRow("a bay that is wider") << fieldWithBay(6.5) << cultivator() << Point{30, 43} << true;
        // Its frame is 0.6 m behind the working line, which is 2.1 m behind the axle; nose in, 4.8 m are
        // ahead of it.
        QTest::newRow("the end of a bay, backwards")
            << fieldWithBay(2.6) << agbot() << Point{30, 47.3} << true;
        QTest::newRow("behind the frame") << fieldWithBay(2.6) << agbot() << Point{30, 47.6} << false;
    }
    void places() {
        QFETCH(MultiPolygon, field);
        QFETCH(Machine, machine);
        QFETCH(Point, place);
        QFETCH(bool, reached);
        QCOMPARE(roomOf(field, machine).reaches(place), reached);
    }

    /// Wherever GEOS says that the machine stands inside after a straight run-in, its working line is
    /// reached.
    void whereItStands() {
        constexpr std::uint64_t kSeed = 2718;
        std::mt19937_64 random{kSeed};
        int stood = 0;
        for (int i = 0; i < 60; ++i) {
            const MultiPolygon field = test::randomPolygons(
                random, test::kShapes[static_cast<std::size_t>(i) % test::kShapes.size()], 30.0);
            const Machine& machine = i % 2 == 0 ? cultivator() : agbot();
            const WorkingRoom room = roomOf(field, machine);
            const PreparedArea inside{field};
            const Bounds box = bounds(field);
            for (int k = 0; k < 100; ++k) {
                const Point axle = box.min + Point{test::uniform(random, 0.0, box.width()),
                                                   test::uniform(random, 0.0, box.height())};
                const double heading = std::numbers::pi / 24.0 * std::floor(test::uniform(random, 0.0, 48.0));
                const Point nose{std::cos(heading), std::sin(heading)};
                const Point left{-nose.y, nose.x};
                Ring swept;
                for (const Point& corner : machine.workingFootprint()) {
                    for (const double back : {0.0, machine.runIn().si()}) {
                        swept.push_back(axle + (corner.x - back) * nose + corner.y * left);
                    }
                }
                swept.push_back(swept.front());
                if (!inside.coversHullOf({swept})) {
                    continue;
                }
                ++stood;
                const double half = 0.5 * machine.operatingWidth().si();
                const Point place = axle + machine.spec().implement.offset.si() * nose +
                                    test::uniform(random, -half, half) * left;
                VERIFY_TOLD(room.reaches(place),
                            QStringLiteral("seed %1, field %2, place %3").arg(kSeed).arg(i).arg(k).toUtf8());
            }
        }
        QVERIFY(stood > 500);
    }

    /// Of a corner of 6 m square something between 1.7 and 2.3 m square stays.
    void whatIsLeftOfACorner() {
        const MultiPolygon field{test::rectangle(60.0, 40.0)};
        const WorkingRoom room = roomOf(field, cultivator());
        const auto parts =
            partsWithRoom({test::rectangle(6.0, 6.0)}, room, cultivator().operatingWidth(), {});
        VERIFY_RESULT(parts);
        QCOMPARE_GT(area(*parts).si(), 36.0 - 2.5 * 2.5);
        QCOMPARE_LT(area(*parts).si(), 36.0 - 1.6 * 1.6);
        const auto whole =
            partsWithRoom({test::rectangle(6.0, 6.0, {20.0, 20.0})}, room, cultivator().operatingWidth(), {});
        VERIFY_RESULT(whole);
        QCOMPARE(*whole, MultiPolygon{test::rectangle(6.0, 6.0, {20.0, 20.0})});
        // A square kilometre is not looked at piece by piece.
        const MultiPolygon vast{test::rectangle(1000.0, 1000.0)};
        QCOMPARE(partsWithRoom(vast, room, cultivator().operatingWidth(), {}).value(), vast);
        QVERIFY(partsWithRoom({test::rectangle(1.0, 1.0)}, room, cultivator().operatingWidth(), {})
                    .value()
                    .empty());
    }
};

FURROW_TEST(TestWorkingRoom);
#include "tst_working_room.moc"
