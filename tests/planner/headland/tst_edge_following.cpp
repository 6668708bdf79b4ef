// Lines along an edge: the footprint is laid along them and its distance from the field's outline measured by
// GEOS.

#include "planner/geometry/curve_sampling.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/headland/edge_following.h"
#include "planner/headland/smooth_ring.h"
#include "planner/machine/machine_library.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace furrow;

namespace {

const Machine& agbot() {
    static const Machine machine = findMachine("agbot").value();
    return machine;
}

Polygon rectangle(double widthM, double heightM) {
    return {.outer = {{0.0, 0.0}, {widthM, 0.0}, {widthM, heightM}, {0.0, heightM}}, .holes = {}};
}

// The robot's footprint: 2.5 m wide, 2.7 m ahead and behind of its axle with the implement.
constexpr double kHalfWidthM = 1.25;
constexpr double kOverhangM = 2.7;

Polygon regular(int corners, double radiusM) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        polygon.outer.push_back(radiusM * direction(2.0 * std::numbers::pi * i / corners));
    }
    return polygon;
}

Curve roundedAlong(const Polygon& field) {
    const auto base = eroded({field}, metres(kHalfWidthM), metres(0.01), {}).value();
    return smoothRing(base.front().outer, agbot().minTurningRadius(), metres(0.25), metres(kOverhangM))
        .value();
}

Ring followed(const Curve& line, const Polygon& field, std::span<const Point> left = {}) {
    const AllowedEdges edges{MultiPolygon{field}, metres(10.0)};
    return followingTheEdge(line, edges, agbot(),
                            {.beside = {}, .leftOut = PointGrid{{left.begin(), left.end()}}, .aroundM = 6.0});
}

/// The outlines of the footprint along a closed ring of points.
MultiPolygon outlinesAlong(const Ring& ring) {
    MultiPolygon outlines;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point along = ring[(i + 1) % ring.size()] - ring[(i + ring.size() - 1) % ring.size()];
        outlines.push_back(
            {.outer = placed(agbot().workingFootprint(),
                             {.position = ring[i], .heading = radians(std::atan2(along.y, along.x))}),
             .holes = {}});
    }
    return outlines;
}

}  // namespace

class EdgeFollowingTest : public QObject {
    Q_OBJECT

private slots:
    void theMachine() {
        const Bounds box = bounds(agbot().workingFootprint());
        COMPARE_WITHIN(box.max.x, kOverhangM, 1e-9);
        COMPARE_WITHIN(box.min.x, -kOverhangM, 1e-9);
        COMPARE_WITHIN(box.max.y, kHalfWidthM, 1e-9);
    }

    void bends_data() {
        QTest::addColumn<int>("corners");
        for (const int corners : {8, 12, 18, 24, 36, 72}) {
            QTest::addRow("%d bends of %d degrees", corners, 360 / corners) << corners;
        }
    }

    /// Round a polygon tail and nose stay inside, and no more is left along the edge than a chord as long as
    /// the machine cannot reach by much: with both outer corners on the two sides of a bend of angle a, and
    /// the tail then drawn in by the nose, L squared a / 8 for each, half as much again for what is not
    /// driven like that.
    void bends() {
        QFETCH(const int, corners);
        const Polygon field = regular(corners, 80.0);
        const Ring ring = followed(roundedAlong(field), field);
        const MultiPolygon outlines = outlinesAlong(ring);
        double outsideM2 = 0.0;
        for (const Polygon& outline : outlines) {
            outsideM2 = std::max(outsideM2, area(difference({outline}, {field}, {}).value()).si());
        }
        // Outside by a centimetre along a metre is 0.005.
        QCOMPARE_LT(outsideM2, 0.005);
        const MultiPolygon swept = unionOf(outlines, {}).value();
        MultiPolygon filled;
        for (const Polygon& polygon : swept) {
            filled.push_back({.outer = polygon.outer, .holes = {}});
        }
        const double alongEdgeM2 = area(difference({field}, filled, {}).value()).si();
        const double lengthM = 2.0 * kOverhangM;
        QCOMPARE_LT(alongEdgeM2, 1.5 * lengthM * lengthM * 2.0 * std::numbers::pi / 8.0);
    }

    /// Along the straight sides of a rectangle, far from its corners, it stays where it was.
    void straightSides() {
        const Polygon field = rectangle(120.0, 90.0);
        for (const Point& point : followed(roundedAlong(field), field)) {
            if (point.x > 40.0 && point.x < 80.0) {
                COMPARE_WITHIN(std::min(point.y, 90.0 - point.y), kHalfWidthM, 2e-3);
            }
        }
    }

    /// Wherever it is, a corner of the footprint or its side is at the edge: nothing lies farther out.
    void nothingToGain() {
        const Polygon field = regular(16, 70.0);
        const BoundaryDistance edges{{field}, metres(10.0)};
        const Ring ring = followed(roundedAlong(field), field);
        const MultiPolygon outlines = outlinesAlong(ring);
        double sum = 0.0;
        for (const Polygon& outline : outlines) {
            double nearestM = 10.0;
            for (const Point& corner : outline.outer) {
                nearestM = std::min(nearestM, edges.insideM(corner).value_or(10.0));
            }
            sum += nearestM;
        }
        QCOMPARE_LT(sum / static_cast<double>(outlines.size()), 0.05);
    }

    /// Where a corner is left out the line stays.
    void leftOut() {
        const Polygon field = rectangle(60.0, 50.0);
        const Curve line = roundedAlong(field);
        const Point corner{0.0, 0.0};
        const Ring left = followed(line, field, std::span{&corner, 1});
        // The corner of the eroded rectangle, to be rounded again.
        double nearestM = 10.0;
        for (const Point& point : left) {
            nearestM = std::min(nearestM, distance(point, {kHalfWidthM, kHalfWidthM}));
        }
        QCOMPARE_LT(nearestM, 1e-6);
    }
};

FURROW_TEST(EdgeFollowingTest);
#include "tst_edge_following.moc"
