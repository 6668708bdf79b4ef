#include "planner/geometry/geos_bridge.h"
#include "planner/machine/machine_library.h"
#include "planner/swaths/full_ends.h"
#include "planner/swaths/scan_line.h"
#include "planner/units/angle.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <cmath>

using namespace furrow;

namespace {

constexpr double kWidthM = 6.0;
constexpr double kHeightM = 60.0;

// Nose 5.5 m ahead of the middle of the implement, which is 1 m long.
const Machine& machine() {
    static const Machine made = [] {
        MachineSpec spec = findMachine("agbot")->spec();
        spec.tractor.width = metres(2.5);
        spec.tractor.length = metres(4.5);
        spec.tractor.rearOverhang = metres(1.0);
        spec.implement.operatingWidth = metres(kWidthM);
        spec.implement.raisedWidth = {};
        spec.implement.offset = metres(-2.0);
        spec.implement.length = metres(1.0);
        return Machine::create(spec).value();
    }();
    return made;
}

/// 200 m long, 60 m high; its sides rise at this angle to the swaths.
MultiPolygon parallelogram(double sideDeg) {
    const double lean = kHeightM / std::tan(degrees(sideDeg).si());
    return {{.outer = {{0.0, 0.0}, {200.0, 0.0}, {200.0 + lean, kHeightM}, {lean, kHeightM}}, .holes = {}}};
}

MultiPolygon plenty() {
    return {test::rectangle(2000.0, 2000.0, {-1000.0, -1000.0})};
}

/// A square of 2 m, driven in its middle, that turns on the spot.
Machine robot(double widthM, double offsetM) {
    MachineSpec spec = findMachine("field-robot")->spec();
    spec.tractor.width = metres(2.0);
    spec.tractor.length = metres(2.0);
    spec.tractor.rearOverhang = metres(1.0);
    spec.implement.operatingWidth = metres(widthM);
    spec.implement.raisedWidth = metres(1.0);
    spec.implement.offset = metres(offsetM);
    spec.implement.length = metres(0.2);
    return Machine::create(spec).value();
}

/// The rectangle that is worked from one point to another, counter-clockwise.
Polygon strip(Point from, Point to, Point along, double halfWidthM) {
    const Point left = halfWidthM * Point{-along.y, along.x};
    Ring ring{from - left, to - left, to + left, from + left};
    if (signedAreaM2(ring) < 0.0) {
        std::ranges::reverse(ring);
    }
    return {.outer = ring, .holes = {}};
}

}  // namespace

class FullEndsTest : public QObject {
    Q_OBJECT

private slots:
    void byHand_data() {
        QTest::addColumn<double>("sideDeg");
        QTest::addColumn<double>("turnedDeg");
        for (const double side : {30.0, 45.0, 60.0, 85.0, 90.0, 95.0, 120.0, 150.0}) {
            QTest::addRow("sides at %g degrees", side) << side << 0.0;
        }
        QTest::newRow("all turned by 37 degrees") << 60.0 << 37.0;
        QTest::newRow("all turned by 170 degrees") << 120.0 << 170.0;
    }
    void byHand() {
        QFETCH(double, sideDeg);
        QFETCH(double, turnedDeg);
        const MultiPolygon mainland = test::moved(parallelogram(sideDeg), degrees(turnedDeg), {});
        const SwathSet flat = test::swathsOf(mainland, kWidthM, turnedDeg);
        QCOMPARE(flat.swaths.size(), std::size_t{10});
        SwathSet full = flat;
        const MultiPolygon room = plenty();
        drawOutEnds(full, mainland, {.working = room, .driving = room, .turning = {}}, machine());
        const double moreM = 0.5 * kWidthM * std::abs(1.0 / std::tan(degrees(sideDeg).si()));
        const Point along = direction(degrees(turnedDeg).si());
        for (std::size_t i = 0; i < flat.swaths.size(); ++i) {
            const Swath& before = flat.swaths[i];
            const Swath& after = full.swaths[i];
            COMPARE_WITHIN(distance(after.start, before.start - moreM * along), 0.0, 1e-6);
            COMPARE_WITHIN(distance(after.end, before.end + moreM * along), 0.0, 1e-6);
            QCOMPARE(after.number, before.number);
            QCOMPARE(after.track, before.track);
            QCOMPARE(after.width.si(), kWidthM);
        }
        COMPARE_WITHIN(full.totalLength.si(), flat.totalLength.si() + 20.0 * moreM, 1e-6);
        // Of what is added at one end, width x more, a triangle of a quarter of it lies within the mainland.
        COMPARE_WITHIN(full.endOverlap.si(), 20.0 * 0.75 * kWidthM * moreM, 1e-4);
        QCOMPARE(full.coverage, flat.coverage);
        QCOMPARE(full.overlap.si(), flat.overlap.si());
        QCOMPARE(full.heading.si(), flat.heading.si());
        // GEOS: nothing of the parallelogram is left.
        MultiPolygon worked;
        for (const Swath& swath : full.swaths) {
            worked.push_back(strip(swath.start, swath.end, along, 0.5 * kWidthM));
        }
        const auto joined = unionOf(worked, {}, kSnapGrid);
        VERIFY_RESULT(joined);
        const auto missed = difference(mainland, *joined, {}, kSnapGrid);
        VERIFY_RESULT(missed);
        COMPARE_WITHIN(area(*missed).si(), 0.0, 1e-3);
        const auto beyond = difference(*joined, mainland, {}, kSnapGrid);
        VERIFY_RESULT(beyond);
        // With the quarter triangle that flat ends reach beyond the edge already.
        COMPARE_WITHIN(area(*beyond).si(), 20.0 * kWidthM * moreM, 1e-3);
    }

    // Sides at 45 degrees: 3 m more at each end. The uppermost swath, at 57 m, ends at 257 m, those below it
    // 6 m before that each.
    void noFartherThanThereIsRoom_data() {
        QTest::addColumn<double>("workingToX");
        QTest::addColumn<double>("drivingToX");
        QTest::addColumn<double>("turningM");
        QTest::addColumn<double>("moreM");  // of the uppermost one
        QTest::addColumn<double>("outsideM2");
        const double far = 900.0;
        // Of e metres that are added e (3 - e / 2) m² lie inside: e² / 2 below the edge and e wide from
        // there.
        const auto outside = [](double more) { return more * kWidthM - more * (3.0 - 0.5 * more); };
        QTest::newRow("plenty") << far << far << 0.0 << 3.0 << 13.5;
        QTest::newRow("the implement stays in the working region")
            << 258.5 << far << 0.0 << 1.5 << outside(1.5);
        QTest::newRow("the nose stays in the driving region")
            << far << 257.0 + 5.5 + 1.0 << 0.0 << 1.0 << outside(1.0);
        QTest::newRow("the nose just fits") << far << 257.0 + 5.5 + 3.0 << 0.0 << 3.0 << 13.5;
        QTest::newRow("no room for the nose") << far << 257.0 + 5.0 << 0.0 << 0.0 << 0.0;
        QTest::newRow("room for the turn") << far << 257.0 + 8.0 + 0.5 << 8.0 << 0.5 << outside(0.5);
        QTest::newRow("working region ends just past the end") << 257.2 << far << 0.0 << 0.2 << outside(0.2);
    }
    void noFartherThanThereIsRoom() {
        QFETCH(double, workingToX);
        QFETCH(double, drivingToX);
        QFETCH(double, turningM);
        QFETCH(double, moreM);
        QFETCH(double, outsideM2);
        const MultiPolygon mainland = parallelogram(45.0);
        const MultiPolygon working{test::rectangle(workingToX + 500.0, 1000.0, {-500.0, -500.0})};
        const MultiPolygon driving{test::rectangle(drivingToX + 500.0, 1000.0, {-500.0, -500.0})};
        const SwathSet flat = test::swathsOf(mainland, kWidthM, 0.0);
        SwathSet full = flat;
        drawOutEnds(full, mainland, {.working = working, .driving = driving, .turning = metres(turningM)},
                    machine());
        const Swath& top = full.swaths.back();
        COMPARE_WITHIN(flat.swaths.back().end.x, 257.0, 1e-9);
        COMPARE_WITHIN(top.end.x, 257.0 + moreM, 1e-6);
        COMPARE_WITHIN(top.start.x, 57.0 - 3.0, 1e-6);
        // The next one is 6 m shorter and has room in all rows.
        COMPARE_WITHIN(full.swaths[8].end.x, 251.0 + 3.0, 1e-6);
        COMPARE_WITHIN(full.endOverlap.si(), 19.0 * 13.5 + outsideM2, 1e-4);
        COMPARE_WITHIN(full.totalLength.si(), flat.totalLength.si() + 19.0 * 3.0 + moreM, 1e-6);
    }

    // The edge bends within the swath's width: as far as its farther side reaches.
    void bentEdge() {
        // From (100, 0) up to (100, 3), from there at 45 degrees to (103, 6).
        const MultiPolygon mainland{
            {.outer = {{0.0, 0.0}, {100.0, 0.0}, {100.0, 3.0}, {103.0, 6.0}, {0.0, 6.0}}, .holes = {}}};
        SwathSet set;
        set.swaths = {
            {.start = {0.0, 2.5}, .end = {100.0, 2.5}, .number = 1, .track = 0, .width = metres(kWidthM)}};
        const MultiPolygon room = plenty();
        drawOutEnds(set, mainland, {.working = room, .driving = room, .turning = {}}, machine());
        // The strip reaches from -0.5 to 5.5 m, where the edge is at 102.5 m.
        COMPARE_WITHIN(set.swaths.front().end.x, 102.5, 1e-9);
        COMPARE_WITHIN(set.swaths.front().start.x, 0.0, 1e-9);
        COMPARE_WITHIN(set.endOverlap.si(), 6.0 * 2.5 - 0.5 * 2.5 * 2.5, 1e-9);
    }

    // What is added stays in the working region, over fields of every kind, and no end moves back.
    void nothingLeavesTheWorkingRegion() {
        constexpr std::uint64_t kSeed = 41;
        std::mt19937_64 random{kSeed};
        int drawn = 0;
        for (int i = 0; i < 60; ++i) {
            const MultiPolygon field =
                test::randomPolygons(random, test::kShapes[static_cast<std::size_t>(i) % 5], 150.0);
            const auto working = eroded(field, metres(0.5 * kWidthM), kArcTolerance, {});
            VERIFY_RESULT(working);
            const auto mainland = eroded(field, metres(2.0 * kWidthM), kArcTolerance, {});
            VERIFY_RESULT(mainland);
            if (mainland->empty()) {
                continue;
            }
            const SwathSet flat = test::swathsOf(*mainland, kWidthM, test::uniform(random, 0.0, 180.0));
            SwathSet full = flat;
            drawOutEnds(full, *mainland, {.working = *working, .driving = field, .turning = {}}, machine());
            const Point along = direction(flat.heading.si());
            QVERIFY(full.swaths.size() == flat.swaths.size());
            double total = 0.0;
            double addedM2 = 0.0;
            for (std::size_t k = 0; k < flat.swaths.size(); ++k) {
                const Swath& before = flat.swaths[k];
                const Swath& after = full.swaths[k];
                const QByteArray said =
                    QStringLiteral("seed %1, field %2, swath %3").arg(kSeed).arg(i).arg(k).toUtf8();
                total += after.length().si();
                const double backM = dot(before.start - after.start, along);
                const double onM = dot(after.end - before.end, along);
                VERIFY_TOLD(backM > -1e-9 && onM > -1e-9, said);
                VERIFY_TOLD(std::abs(cross(along, after.start - before.start)) < 1e-9, said);
                VERIFY_TOLD(std::abs(cross(along, after.end - before.end)) < 1e-9, said);
                for (const auto& [from, to, more] :
                     {std::tuple{before.end, after.end, onM}, {before.start, after.start, backM}}) {
                    if (more < 0.01) {
                        continue;
                    }
                    ++drawn;
                    addedM2 += more * kWidthM;
                    const auto outside = difference({strip(from, to, along, 0.5 * kWidthM)}, *working, {});
                    VERIFY_RESULT(outside);
                    // A millimetre on either side is touching.
                    VERIFY_TOLD(area(*outside).si() <= 3e-3 * more + 1e-5 * kWidthM,
                                said + QByteArray::number(area(*outside).si()) + " m2");
                }
            }
            COMPARE_WITHIN(full.totalLength.si(), total, 1e-6);
            QVERIFY(full.endOverlap.si() <= addedM2 + 1.0);
        }
        QVERIFY(drawn > 500);
    }

    // A square machine of 2 m reaches sqrt(2) m round its middle. Its implement is 3 m wide and raised to 1
    // m. 10 m from the side it stops where it can turn at the end. 1.2 m from the side it can turn nowhere,
    // and stops where its nose touches, 1 m before the end. An implement 0.5 m behind the middle stops 0.5 m
    // sooner.
    void roomToTurnOnTheSpot_data() {
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("offsetM");
        QTest::addColumn<double>("endX");
        QTest::newRow("room to turn") << 10.0 << 0.0 << 100.0 - std::sqrt(2.0);
        QTest::newRow("too near the side") << 1.2 << 0.0 << 99.0;
        QTest::newRow("behind the axle") << 10.0 << -0.5 << 99.5 - std::sqrt(2.0);
    }
    void roomToTurnOnTheSpot() {
        QFETCH(double, y);
        QFETCH(double, offsetM);
        QFETCH(double, endX);
        const MultiPolygon field{test::rectangle(100.0, 60.0)};
        SwathSet set;
        set.swaths = {{.start = {0.0, y}, .end = {100.0, y}, .number = 1, .track = 0, .width = metres(2.0)}};
        const EndRoom room{
            .working = field, .driving = field, .turning = {}, .drawsIn = true, .turnsOnTheSpot = true};
        drawOutEnds(set, field, room, robot(2.0, offsetM));
        COMPARE_WITHIN(set.swaths.front().end.x, endX, 1e-9);
        COMPARE_WITHIN(set.swaths.front().start.x, 100.0 - endX, 1e-9);
    }

    // A hole from (40, 31) to (60, 40) beside a swath at y = 30: 3 m of implement reach over it, 1.8 m do
    // not. The implement is 0.2 m long.
    void stretchesThatReachOverAHole_data() {
        QTest::addColumn<double>("widthM");
        QTest::addColumn<int>("pieces");
        QTest::newRow("reaches over it") << 3.0 << 2;
        QTest::newRow("passes beside it") << 1.8 << 1;
    }
    void stretchesThatReachOverAHole() {
        QFETCH(double, widthM);
        QFETCH(int, pieces);
        MultiPolygon field{test::rectangle(100.0, 60.0)};
        field.front().holes.push_back({{40, 31}, {40, 40}, {60, 40}, {60, 31}});
        SwathSet set;
        set.swaths = {
            {.start = {0.0, 30.0}, .end = {100.0, 30.0}, .number = 1, .track = 0, .width = metres(widthM)}};
        const SwathSet inside = withoutReachingOver(set, field, robot(widthM, 0.0));
        // Both ends touch the edge, where the implement would reach over by half its length.
        QCOMPARE(static_cast<int>(inside.swaths.size()), pieces);
        COMPARE_WITHIN(inside.swaths.front().start.x, 1.0, 2e-3);
        COMPARE_WITHIN(inside.swaths.back().end.x, 99.0, 2e-3);
        if (pieces == 2) {
            COMPARE_WITHIN(inside.swaths.front().end.x, 39.9, 2e-3);
            COMPARE_WITHIN(inside.swaths.back().start.x, 60.1, 2e-3);
        }
        COMPARE_WITHIN(inside.totalLength.si(), pieces == 2 ? 98.0 - 20.2 : 98.0, 1e-2);
    }

    void noSwaths() {
        SwathSet set;
        const MultiPolygon room = plenty();
        drawOutEnds(set, parallelogram(60.0), {.working = room, .driving = room, .turning = {}}, machine());
        QVERIFY(set.swaths.empty());
        QCOMPARE(set.endOverlap.si(), 0.0);
    }
};

FURROW_TEST(FullEndsTest);
#include "tst_full_ends.moc"
