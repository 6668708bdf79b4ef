// Turns by the name that drivers give them, of lines that were drawn by hand.

#include "planner/path/turn_shape.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <vector>

using namespace furrow;

namespace {

/// Bends one after the other, each of so many degrees (left positive) on a radius of 6 m, or 10 m straight
/// for 0.
PathSegment segmentOf(const std::vector<double>& bendsDeg, Gear gear, double headingDeg, double fromM) {
    PathSegment segment{.kind = SegmentKind::Turn, .gear = gear};
    double heading = headingDeg * std::numbers::pi / 180.0;
    double along = fromM;
    segment.samples.push_back({.sM = along, .tS = along, .headingRad = heading});
    for (const double bend : bendsDeg) {
        const int steps = bend == 0.0 ? 1 : static_cast<int>(std::ceil(std::abs(bend) / 5.0));
        for (int i = 0; i < steps; ++i) {
            heading += bend / steps * std::numbers::pi / 180.0;
            along += bend == 0.0 ? 10.0 : std::abs(bend) / steps * std::numbers::pi / 180.0 * 6.0;
            const double whole = 2.0 * std::numbers::pi;
            segment.samples.push_back(
                {.sM = along, .tS = along, .headingRad = std::fmod(heading + 4.0 * whole, whole)});
        }
    }
    return segment;
}

}  // namespace

class TestTurnShape : public QObject {
    Q_OBJECT

private slots:
    void namesForwardTurns_data();
    void namesForwardTurns();
    void namesReversing();
    void standsWhileItTurns();
    void turnsOnTheSpotAtItsEnds();
    void joinsSegmentsOfOneTurn();
};

void TestTurnShape::namesForwardTurns_data() {
    QTest::addColumn<QList<double>>("bends");
    QTest::addColumn<QString>("name");
    QTest::newRow("half circle") << QList<double>{180.0} << "U turn";
    QTest::newRow("two corners") << QList<double>{90.0, 0.0, 90.0} << "U turn";
    QTest::newRow("to the right") << QList<double>{-90.0, 0.0, -90.0} << "U turn";
    QTest::newRow("out first and back at the end") << QList<double>{-40.0, 260.0, -40.0} << "bulb turn";
    QTest::newRow("out first only") << QList<double>{-60.0, 240.0} << "bulb turn";
    QTest::newRow("all round") << QList<double>{270.0} << "loop";
    QTest::newRow("round a corner") << QList<double>{90.0} << "corner";
    QTest::newRow("to another lane") << QList<double>{30.0, 0.0, -30.0} << "corner";
    QTest::newRow("straight on") << QList<double>{0.0, 5.0, -5.0} << "way straight on";
}

void TestTurnShape::namesForwardTurns() {
    QFETCH(QList<double>, bends);
    QFETCH(QString, name);
    const std::vector<PathSegment> way{segmentOf({bends.begin(), bends.end()}, Gear::Forward, 350.0, 0.0)};
    QCOMPARE(QString::fromStdString(nameOf(turnShape(way)).text()), name);
}

void TestTurnShape::namesReversing() {
    const PathSegment ahead = segmentOf({90.0}, Gear::Forward, 0.0, 0.0);
    const PathSegment back = segmentOf({0.0}, Gear::Reverse, 90.0, 9.4);
    const PathSegment on = segmentOf({90.0}, Gear::Forward, 90.0, 19.4);
    QCOMPARE(turnShape(std::vector{ahead, back, on}), TurnShape::Fishtail);
    QCOMPARE(turnShape(std::vector{ahead, back}), TurnShape::Reversing);
    // Two segments in one gear are one stretch.
    QCOMPARE(turnShape(std::vector{ahead, ahead, back, on}), TurnShape::Fishtail);
}

void TestTurnShape::standsWhileItTurns() {
    PathSegment turn{.kind = SegmentKind::Turn};
    turn.samples = {{.tS = 0.0, .headingRad = 0.0},
                    {.tS = 5.0, .headingRad = 0.5 * std::numbers::pi},
                    {.tS = 10.0, .headingRad = std::numbers::pi}};
    QCOMPARE(turnShape(std::vector{turn}), TurnShape::OnTheSpot);
}

// A quarter turn at both ends of 10 m straight, 2 s each: a turn on the spot of 14 s.
void TestTurnShape::turnsOnTheSpotAtItsEnds() {
    PathSegment before = segmentOf({0.0}, Gear::Forward, 0.0, 0.0);
    before.kind = SegmentKind::Swath;
    const PathSegment across = segmentOf({0.0}, Gear::Forward, 90.0, 12.0);
    PathSegment next = segmentOf({0.0}, Gear::Forward, 180.0, 24.0);
    next.kind = SegmentKind::Swath;
    const std::vector<DrivenTurn> turns = drivenTurns(Path{{before, across, next}});
    QCOMPARE(turns.size(), 1U);
    QCOMPARE(turns[0].shape, TurnShape::OnTheSpot);
    QVERIFY(std::abs(turns[0].duration.si() - 14.0) < 1e-9);
    QVERIFY(std::abs(turns[0].length.si() - 10.0) < 1e-9);
}

void TestTurnShape::joinsSegmentsOfOneTurn() {
    PathSegment swath = segmentOf({0.0}, Gear::Forward, 0.0, 0.0);
    swath.kind = SegmentKind::Swath;
    const PathSegment ahead = segmentOf({90.0}, Gear::Forward, 0.0, 10.0);
    const double after = ahead.samples.back().sM;
    const PathSegment back = segmentOf({0.0}, Gear::Reverse, 90.0, after);
    const PathSegment on = segmentOf({90.0}, Gear::Forward, 90.0, after + 10.0);
    const Path path{{swath, ahead, back, on, swath, ahead, swath}};
    const std::vector<DrivenTurn> turns = drivenTurns(path);
    QCOMPARE(turns.size(), 2U);
    QCOMPARE(turns[0].firstSegment, 1U);
    QCOMPARE(turns[0].segmentCount, 3U);
    QCOMPARE(turns[0].shape, TurnShape::Fishtail);
    // Twice a quarter of a circle of 6 m, and 10 m back.
    QVERIFY(std::abs(turns[0].length.si() - (6.0 * std::numbers::pi + 10.0)) < 1e-9);
    QCOMPARE(turns[1].firstSegment, 5U);
    QCOMPARE(turns[1].shape, TurnShape::Corner);
    QCOMPARE(drivenTurns(Path{}).size(), 0U);
}

FURROW_TEST(TestTurnShape);
#include "tst_turn_shape.moc"
