#include "planner/editing/outline_edits.h"
#include "planner/editing/shape_hit.h"
#include "planner/editing/snapping.h"
#include "planner/geometry/simplify.h"
#include "planner/units/angle.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace furrow;

namespace {

const LocalFrame kFrame = *LocalFrame::centredOn({.lonDeg = 22.5, .latDeg = 58.25});

/// A field of 100 by 60 m with a square hole, an obstacle and a gate, and a guidance line across it.
FieldSource field() {
    return {
        .id = "1",
        .name = "A",
        .origin = {},
        .parts = {{.outer = kFrame.toGeo(Ring{{0, 0}, {100, 0}, {100, 60}, {0, 60}}),
                   .holes = {kFrame.toGeo(Ring{{20, 20}, {20, 30}, {30, 30}, {30, 20}})}}},
        .obstacles = {{.name = "Pond",
                       .outline = {.outer = kFrame.toGeo(Ring{{60, 20}, {80, 20}, {70, 40}}), .holes = {}},
                       .passable = false,
                       .buffer = {}}},
        .gates = {{.name = "Gate", .position = kFrame.toGeo(Point{50, 0}), .width = metres(6)}},
        .boundaryAccuracy = {},
        .repairs = {}};
}

FieldShape shape(const GeoRing& guide = {}) {
    FieldShape made = *FieldShape::of(field(), {.guide = guide, .splits = {}});
    // Worked out by hand in this frame.
    made.frame = kFrame;
    for (Outline& outline : made.outlines) {
        outline.points = kFrame.toLocal(outline.places);
    }
    made.gates = {{50, 0}};
    return made;
}

const OutlineId kOuter{OutlineKind::Boundary, 0, 0};

Outline ring(Ring points, bool closed = true) {
    return {.id = kOuter, .closed = closed, .places = kFrame.toGeo(points), .points = points};
}

void compare(const GeoRing& places, const Ring& expected) {
    const Ring points = kFrame.toLocal(places);
    QCOMPARE(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        VERIFY_TOLD(distance(points[i], expected[i]) < 1e-6, QByteArray::number(i) + ": " +
                                                                 QByteArray::number(points[i].x) + ", " +
                                                                 QByteArray::number(points[i].y));
    }
}

}  // namespace

class TestEditing : public QObject {
    Q_OBJECT

private slots:
    void whatIsHit_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("kind");  // -1: nothing
        QTest::addColumn<int>("of");
        QTest::addColumn<int>("index");
        using Kind = ShapeHit::Kind;
        const auto row = [](const char* name, double x, double y, Kind kind, OutlineKind of, int index) {
            QTest::newRow(name) << x << y << static_cast<int>(kind) << static_cast<int>(of) << index;
        };
        row("a corner", 99.2, 0.5, Kind::Vertex, OutlineKind::Boundary, 1);
        row("a corner before its edges", 100.0, 0.9, Kind::Vertex, OutlineKind::Boundary, 1);
        row("an edge", 30.0, 0.4, Kind::Edge, OutlineKind::Boundary, 0);
        row("the closing edge", -0.5, 30.0, Kind::Edge, OutlineKind::Boundary, 3);
        row("a gate before the edge", 50.4, 0.3, Kind::Gate, OutlineKind::Boundary, 0);
        row("a hole's edge", 20.3, 25.0, Kind::Edge, OutlineKind::Hole, 0);
        row("inside a hole", 25.0, 25.0, Kind::Inside, OutlineKind::Hole, 0);
        row("inside the obstacle", 70.0, 26.0, Kind::Inside, OutlineKind::Obstacle, 0);
        QTest::newRow("the land") << 50.0 << 50.0 << -1 << 0 << 0;
        QTest::newRow("far outside") << 500.0 << 50.0 << -1 << 0 << 0;
    }
    void whatIsHit() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, kind);
        QFETCH(int, of);
        QFETCH(int, index);
        const auto hit = hitAt(shape(), {x, y}, metres(1.0));
        QCOMPARE(hit.has_value(), kind >= 0);
        if (hit) {
            QCOMPARE(static_cast<int>(hit->kind), kind);
            QCOMPARE(static_cast<int>(hit->outline.kind), of);
            QCOMPARE(static_cast<int>(hit->index), index);
        }
    }
    /// A millimetre decides at the closest zoom.
    void hitsAreExact() {
        QVERIFY(hitAt(shape(), {10.0, 0.0009}, metres(0.001)).has_value());
        QVERIFY(!hitAt(shape(), {10.0, 0.0011}, metres(0.001)).has_value());
    }
    void theGuideIsOpen() {
        const GeoRing guide = kFrame.toGeo(Ring{{0, 50}, {50, 55}, {100, 50}});
        const FieldShape made = shape(guide);
        const Outline* line = made.find({OutlineKind::Guide, 0, 0});
        QVERIFY(line != nullptr);
        QCOMPARE(line->edgeCount(), std::size_t{2});
        QVERIFY2(!hitAt(made, {50, 50}, metres(1.0)), "no edge leads from its end to its beginning");
    }
    void edgesMoveParallel_data() {
        QTest::addColumn<Ring>("points");
        QTest::addColumn<bool>("closed");
        QTest::addColumn<int>("edge");
        QTest::addColumn<double>("sideways");
        QTest::addColumn<Ring>("expected");
        const Ring square{{0, 0}, {100, 0}, {100, 60}, {0, 60}};
        QTest::newRow("inwards") << square << true << 0 << 10.0
                                 << Ring{{0, 10}, {100, 10}, {100, 60}, {0, 60}};
        QTest::newRow("outwards") << square << true << 0 << -5.0
                                  << Ring{{0, -5}, {100, -5}, {100, 60}, {0, 60}};
        QTest::newRow("the closing edge")
            << square << true << 3 << 20.0 << Ring{{20, 0}, {100, 0}, {100, 60}, {20, 60}};
        // The sides lean by 45 degrees: the edge gets shorter by what it moves at either end.
        QTest::newRow("along slanting neighbours") << Ring{{0, 0}, {100, 0}, {60, 40}, {40, 40}} << true << 0
                                                   << 10.0 << Ring{{10, 10}, {90, 10}, {60, 40}, {40, 40}};
        QTest::newRow("a neighbour straight on moves along")
            << Ring{{0, 0}, {50, 0}, {100, 0}, {100, 60}, {0, 60}} << true << 0 << 10.0
            << Ring{{0, 10}, {50, 10}, {100, 0}, {100, 60}, {0, 60}};
        QTest::newRow("not beyond its neighbours' other ends")
            << square << true << 0 << 70.0 << Ring{{0, 70}, {100, 70}, {100, 60}, {0, 60}};
        QTest::newRow("the end of a line")
            << Ring{{0, 0}, {100, 0}} << false << 0 << 3.0 << Ring{{0, 3}, {100, 3}};
    }
    void edgesMoveParallel() {
        QFETCH(Ring, points);
        QFETCH(bool, closed);
        QFETCH(int, edge);
        QFETCH(double, sideways);
        QFETCH(Ring, expected);
        compare(withEdgeMoved(ring(points, closed), kFrame, static_cast<std::size_t>(edge), metres(sideways)),
                expected);
    }
    void verticesComeAndGo() {
        const Outline square = ring({{0, 0}, {100, 0}, {100, 60}, {0, 60}});
        compare(withVertexAt(square, kFrame, 2, {90, 70}), {{0, 0}, {100, 0}, {90, 70}, {0, 60}});
        compare(withVertexOn(square, kFrame, 3, {0, 30}), {{0, 0}, {100, 0}, {100, 60}, {0, 60}, {0, 30}});
        compare(*withoutVertex(square, 0), {{100, 0}, {100, 60}, {0, 60}});
        QVERIFY(!withoutVertex(ring({{0, 0}, {100, 0}, {0, 60}}), 1));
        QVERIFY(!withoutVertex(ring({{0, 0}, {100, 0}}, false), 1));
        QVERIFY2(withVertexAt(square, kFrame, 2, {90, 70})[1] == square.places[1],
                 "what does not move stays to the last bit");
    }
    void lengthsAndHeadingsAreTyped() {
        const Outline square = ring({{0, 0}, {100, 0}, {100, 60}, {0, 60}});
        compare(withEdgeLength(square, kFrame, 0, metres(80)), {{0, 0}, {80, 0}, {100, 60}, {0, 60}});
        compare(withEdgeHeading(square, kFrame, 0, degrees(30)),
                {{0, 0}, {100 * std::sqrt(3.0) / 2.0, 50}, {100, 60}, {0, 60}});
        compare(withAllMoved(square, kFrame, {5, -5}), {{5, -5}, {105, -5}, {105, 55}, {5, 55}});
    }
    void ringsAreTurned() {
        const Ring square{{0, 0}, {100, 0}, {100, 60}, {0, 60}};
        const Ring back{square.rbegin(), square.rend()};
        compare(turnedRing(kFrame.toGeo(square), kFrame, true), square);
        compare(turnedRing(kFrame.toGeo(square), kFrame, false), back);
        compare(turnedRing(kFrame.toGeo(back), kFrame, true), square);
    }
    void cornersHaveAngles_data() {
        QTest::addColumn<Ring>("points");
        QTest::addColumn<int>("vertex");
        QTest::addColumn<double>("angleDeg");
        const Ring bay{{0, 0}, {100, 0}, {100, 60}, {50, 10}, {0, 60}};
        QTest::newRow("right") << bay << 0 << 90.0;
        QTest::newRow("acute") << bay << 2 << 45.0;
        QTest::newRow("reentrant") << bay << 3 << 270.0;
        QTest::newRow("clockwise") << Ring{bay.rbegin(), bay.rend()} << 1 << 270.0;
    }
    void cornersHaveAngles() {
        QFETCH(Ring, points);
        QFETCH(int, vertex);
        QFETCH(double, angleDeg);
        COMPARE_WITHIN(inDegrees(cornerAngle(ring(points), static_cast<std::size_t>(vertex))), angleDeg,
                       1e-9);
    }
    void whatAPlaceSnapsTo_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("toX");
        QTest::addColumn<double>("toY");
        QTest::addColumn<QList<int>>("kinds");
        const auto row = [](const char* name, Point at, Point to, std::initializer_list<SnapKind> kinds) {
            QList<int> list;
            for (const SnapKind kind : kinds) {
                list << static_cast<int>(kind);
            }
            QTest::newRow(name) << at.x << at.y << to.x << to.y << list;
        };
        // The draft goes from (40, 50) to (45, 50).
        row("nothing near", {55, 45}, {55, 45}, {});
        row("a vertex before its edges", {99.5, 60.4}, {100, 60}, {SnapKind::Vertex});
        row("an edge", {80, 59.4}, {80, 60}, {SnapKind::Edge});
        row("a right angle", {45.6, 40}, {45, 40}, {SnapKind::RightAngle});
        row("straight on", {55, 50.7}, {55, 50}, {SnapKind::Straight});
        row("a right angle on an edge", {45.5, 59.5}, {45, 60}, {SnapKind::Edge, SnapKind::RightAngle});
        row("straight on to an edge", {99.6, 50.6}, {100, 50}, {SnapKind::Edge, SnapKind::Straight});
    }
    void whatAPlaceSnapsTo() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, toX);
        QFETCH(double, toY);
        QFETCH(QList<int>, kinds);
        const Snap snap = snapped(shape(), {x, y}, metres(1.0), angleLines({45, 50}, {40, 50}));
        COMPARE_WITHIN(snap.place.x, toX, 1e-9);
        COMPARE_WITHIN(snap.place.y, toY, 1e-9);
        QList<int> met;
        for (const SnapKind kind : snap.kinds) {
            met << static_cast<int>(kind);
        }
        QCOMPARE(met, kinds);
    }
    void aMovedVertexDoesNotSnapToItself() {
        QVERIFY(snapped(shape(), {100.3, 60.3}, metres(1.0), {}).isSnapped());
        QVERIFY(
            !snapped(shape(), {100.3, 60.3}, metres(1.0), {}, std::pair{kOuter, std::size_t{2}}).isSnapped());
    }
    void handDrawnLinesAreThinned() {
        Polyline line;
        for (int i = 0; i <= 100; ++i) {
            line.push_back({i * 1.0, (i % 2) * 0.2});
        }
        line.push_back({100, 50});
        const Polyline thin = simplified(line, metres(0.5));
        QCOMPARE(thin.size(), std::size_t{3});
        QVERIFY(thin[1] == (Point{100, 0}));
        QCOMPARE(simplified({{0, 0}, {1, 1}}, metres(5)).size(), std::size_t{2});
    }
    void aShapeFollowsAChange() {
        const auto before = FieldShape::of(field(), {});
        VERIFY_RESULT(before);
        const Outline* outer = before->find(kOuter);
        FieldSource moved = withOutline(
            field(), kOuter, withVertexAt(*outer, before->frame, 1, outer->points[1] + Point{3, 4}));
        const auto after = FieldShape::of(moved, {}, &*before);
        VERIFY_RESULT(after);
        QVERIFY(after->frame == before->frame);
        QVERIFY(after->find(kOuter)->points[0] == outer->points[0]);
        COMPARE_WITHIN(distance(after->find(kOuter)->points[1], outer->points[1]), 5.0, 1e-6);
    }

    // An edge keeps its own headland whatever happens to the points of other edges, and both halves of it
    // have it.
    void headlandsStayWithTheirEdges_data() {
        QTest::addColumn<QList<int>>("points");  // of the ring below by number, or new ones (-1)
        QTest::addColumn<QList<int>>("edges");   // that have the headland that edge 1 had
        QTest::newRow("as it was") << QList{0, 1, 2, 3} << QList{1};
        QTest::newRow("a point before it") << QList{0, -1, 1, 2, 3} << QList{2};
        QTest::newRow("a point behind it") << QList{0, 1, 2, -1, 3} << QList{1};
        QTest::newRow("a point at the end") << QList{0, 1, 2, 3, -1} << QList{1};
        QTest::newRow("divided") << QList{0, 1, -1, 2, 3} << QList{1, 2};
        QTest::newRow("without its first point") << QList{0, 2, 3} << QList<int>{};
        QTest::newRow("without its last point") << QList{0, 1, 3} << QList{1};
        QTest::newRow("without a point before it") << QList{1, 2, 3} << QList{0};
        QTest::newRow("without a point behind it") << QList{0, 1, 2} << QList{1};
    }
    void headlandsStayWithTheirEdges() {
        QFETCH(QList<int>, points);
        QFETCH(QList<int>, edges);
        FieldSource source = field();
        source.edgeHeadlands = {{.part = 0, .ring = 0, .edge = 1, .width = metres(18.0)},
                                {.part = 0, .ring = 1, .edge = 1, .width = metres(6.0)}};
        source.edgeOverhangs = source.edgeHeadlands;
        const GeoRing before = source.parts.front().outer;
        GeoRing after;
        for (const int point : points) {
            after.push_back(point < 0 ? kFrame.toGeo(Point{111, 222})
                                      : before[static_cast<std::size_t>(point)]);
        }
        const FieldSource changed = withOutline(source, kOuter, after);
        QList<int> found;
        for (const EdgeWidth& headland : changed.edgeHeadlands) {
            if (headland.ring == 0) {
                found << static_cast<int>(headland.edge);
                QCOMPARE(headland.width.si(), 18.0);
            }
        }
        QCOMPARE(found, edges);
        // That of the hole is where it was.
        QVERIFY(std::ranges::contains(changed.edgeHeadlands,
                                      EdgeWidth{.part = 0, .ring = 1, .edge = 1, .width = metres(6.0)}));
        QVERIFY(changed.edgeOverhangs == changed.edgeHeadlands);
    }
};

FURROW_TEST(TestEditing);
#include "tst_editing.moc"
