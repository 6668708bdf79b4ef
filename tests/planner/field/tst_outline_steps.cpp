#include "planner/field/outline_steps.h"
#include "planner/geometry/segment.h"
#include "planner/project/project_edits.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};

FieldSource fieldOf(Ring outer) {
    return test::fieldSourceFromLocal({{.outer = std::move(outer), .holes = {}}}, kCentre);
}

/// A right-angled triangle whose long side goes down in steps of a width and a height: from (0, steps x
/// height) to (steps x width, 0).
Ring stairs(int steps, double widthM, double heightM) {
    Ring ring{{0.0, 0.0}, {steps * widthM, 0.0}};
    for (int i = 0; i < steps; ++i) {
        ring.push_back({(steps - i) * widthM, (i + 1) * heightM});
        ring.push_back({(steps - i - 1) * widthM, (i + 1) * heightM});
    }
    ring.pop_back();
    ring.push_back({0.0, steps * heightM});
    return ring;
}

Ring outerOf(const FieldSource& source) {
    return LocalFrame::centredOn(kCentre).value().toLocal(source.parts.front().outer);
}

double areaOf(const FieldSource& source) {
    return std::abs(signedAreaM2(outerOf(source)));
}

double farthestFrom(const Ring& ring, const Ring& other) {
    double farthest = 0.0;
    for (const Point& point : ring) {
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0, j = other.size() - 1; i < other.size(); j = i++) {
            nearest = std::min(nearest, distanceToSegment(point, other[j], other[i]));
        }
        farthest = std::max(farthest, nearest);
    }
    return farthest;
}

/// The outline of the pixels whose middles lie in a rectangle turned about the origin: up the right side of
/// its rows and down the left side.
Ring traced(double widthM, double heightM, double turn, double pixelM) {
    struct Row {
        double from;
        double to;
        double low;
    };
    std::vector<Row> rows;
    const int reach = static_cast<int>((widthM + heightM) / pixelM);
    for (int y = -reach; y < reach; ++y) {
        std::optional<Row> row;
        for (int x = -reach; x < reach; ++x) {
            const Point middle = pixelM * Point{x + 0.5, y + 0.5};
            const double along = middle.x * std::cos(turn) + middle.y * std::sin(turn);
            const double across = middle.y * std::cos(turn) - middle.x * std::sin(turn);
            if (std::abs(along) < 0.5 * widthM && std::abs(across) < 0.5 * heightM) {
                row = {row ? row->from : x * pixelM, (x + 1) * pixelM, y * pixelM};
            }
        }
        if (row) {
            rows.push_back(*row);
        }
    }
    Ring ring;
    const auto add = [&ring](Point point) {
        if (ring.size() >= 2 && (point.x == ring.back().x ? ring[ring.size() - 2].x == point.x
                                                          : ring[ring.size() - 2].y == point.y)) {
            ring.back() = point;
        } else {
            ring.push_back(point);
        }
    };
    for (const Row& row : rows) {
        add({row.to, row.low});
        add({row.to, row.low + pixelM});
    }
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        add({row->from, row->low + pixelM});
        add({row->from, row->low});
    }
    return ring;
}

}  // namespace

class OutlineStepsTest : public QObject {
    Q_OBJECT

private slots:
    void stepsAreCounted() {
        // Twenty risers of 1.5 m: the last one belongs to the corner at the top.
        const auto steps = stepsOf(fieldOf(stairs(20, 4.0, 1.5)));
        QVERIFY(steps.has_value());
        QVERIFY(std::abs(steps->count - 19) <= 1);
        QVERIFY(std::abs(steps->height.si() - 1.5) < 0.01);
    }
    void whatHasNoneStays_data() {
        QTest::addColumn<Ring>("ring");
        QTest::newRow("rectangle") << Ring{{0, 0}, {80, 0}, {80, 50}, {0, 50}};
        QTest::newRow("L") << Ring{{0, 0}, {80, 0}, {80, 20}, {30, 20}, {30, 50}, {0, 50}};
        QTest::newRow("few") << stairs(6, 4.0, 1.5);
        QTest::newRow("parcels") << stairs(14, 60.0, 45.0);
        Ring circle;
        for (int i = 0; i < 90; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 90.0;
            circle.push_back({80.0 * std::cos(angle), 80.0 * std::sin(angle)});
        }
        QTest::newRow("circle") << circle;
        Ring teeth{{0, 0}, {200, 0}};
        for (int i = 0; i < 20; ++i) {
            teeth.push_back({200.0 - 10.0 * i, 60});
            teeth.push_back({195.0 - 10.0 * i, 52});
        }
        QTest::newRow("teeth") << teeth;
    }
    void whatHasNoneStays() {
        QFETCH(Ring, ring);
        const FieldSource source = fieldOf(ring);
        QVERIFY(!stepsOf(source));
        QVERIFY(withStraightSteps(source).value() == source);
    }
    void stairsBecomeOneEdge() {
        const FieldSource source = fieldOf(stairs(20, 4.0, 1.5));
        const FieldSource straight = withStraightSteps(source).value();
        QVERIFY(straight.parts.front().outer.size() <= 5);
        QVERIFY(!stepsOf(straight));
        // Between the triangles through the inner and through the outer corners, half of 80 by 30 m and half
        // of 84 by 31.5 m. Its corners stay.
        QVERIFY(areaOf(straight) > 1200.0 && areaOf(straight) < 1323.0);
        QVERIFY(std::ranges::contains(straight.parts.front().outer, source.parts.front().outer[0]));
        QVERIFY(farthestFrom(outerOf(straight), outerOf(source)) <= 1.5 * 1.5);
    }
    void pointsOnTheWayAreNoCorners() {
        Ring halved;
        const Ring ring = stairs(20, 4.0, 1.5);
        for (std::size_t i = 0; i < ring.size(); ++i) {
            halved.push_back(ring[i]);
            halved.push_back(0.5 * (ring[i] + ring[(i + 1) % ring.size()]));
        }
        const FieldSource straight = withStraightSteps(fieldOf(halved)).value();
        QVERIFY(straight.parts.front().outer.size() <= 9);
    }
    void tracedRectanglesComeBack_data() {
        QTest::addColumn<double>("turnDeg");
        QTest::addColumn<double>("pixelM");
        for (const double turn : {7.0, 20.0, 33.0, 45.0, 58.0, 81.0}) {
            for (const double pixel : {1.5, 5.0, 10.0}) {
                QTest::addRow("%g degrees, %g m", turn, pixel) << turn << pixel;
            }
        }
    }
    void tracedRectanglesComeBack() {
        QFETCH(double, turnDeg);
        QFETCH(double, pixelM);
        const double turn = turnDeg * std::numbers::pi / 180.0;
        const FieldSource source = fieldOf(traced(40.0 * pixelM, 25.0 * pixelM, turn, pixelM));
        QVERIFY(stepsOf(source).has_value());
        const FieldSource straight = withStraightSteps(source).value();
        const Ring ring = outerOf(straight);
        QVERIFY2(ring.size() <= 16, qPrintable(QString::number(ring.size())));
        QVERIFY(farthestFrom(ring, outerOf(source)) <= 1.5 * pixelM);
        Ring rectangle;
        for (const auto& [x, y] : {std::pair{-20.0, -12.5}, {20.0, -12.5}, {20.0, 12.5}, {-20.0, 12.5}}) {
            rectangle.push_back(pixelM * Point{x * std::cos(turn) - y * std::sin(turn),
                                               x * std::sin(turn) + y * std::cos(turn)});
        }
        QVERIFY(farthestFrom(ring, rectangle) <= 1.5 * pixelM);
        QVERIFY(std::abs(areaOf(straight) / (1000.0 * pixelM * pixelM) - 1.0) < 0.02);
    }
    void ownEdgesAndGatesStay() {
        FieldSource source = fieldOf(stairs(20, 4.0, 1.5));
        const GeoRing ring = source.parts.front().outer;
        source.edgeHeadlands = {{.part = 0, .ring = 0, .edge = 14, .width = metres(9.0)}};
        source.edgeOverhangs = {{.part = 0, .ring = 0, .edge = 0, .width = metres(1.0)}};
        source.gates = {{.name = "on it", .position = ring[20], .width = metres(6.0)},
                        {.name = "beside", .position = {9.2, 51.31}, .width = metres(6.0)}};
        const FieldSource straight = withStraightSteps(source).value();
        const GeoRing& now = straight.parts.front().outer;
        const std::size_t edge = straight.edgeHeadlands.front().edge;
        QVERIFY(now.size() < 12);
        QVERIFY(now[edge] == ring[14] && now[(edge + 1) % now.size()] == ring[15]);
        const std::size_t over = straight.edgeOverhangs.front().edge;
        QVERIFY(now[over] == ring[0] && now[(over + 1) % now.size()] == ring[1]);
        const Point gate = LocalFrame::centredOn(kCentre).value().toLocal(straight.gates[0].position);
        QVERIFY(farthestFrom({gate}, outerOf(straight)) < 0.01);
        QVERIFY(straight.gates[1].position == source.gates[1].position);
    }
    /// Nothing is offered that would do nothing.
    void stepsBetweenEdgesThatStayAreNone() {
        FieldSource source = fieldOf(stairs(20, 4.0, 1.5));
        QVERIFY(stepsOf(source));
        // A headland of its own at every second edge: single risers between them are steps, and cannot be
        // left out.
        const std::size_t edges = source.parts.front().outer.size();
        for (std::size_t edge = 0; edge < edges; edge += 2) {
            source.edgeHeadlands.push_back({.part = 0, .ring = 0, .edge = edge, .width = metres(9.0)});
        }
        QVERIFY(withStraightSteps(source).value() == source);
        QVERIFY(!stepsOf(source));
    }
    void holesAreMadeStraight() {
        FieldSource source = test::fieldSourceFromLocal({test::centredRectangle(300.0, 200.0)}, kCentre);
        Ring hole = traced(60.0, 40.0, 0.4, 1.5);
        std::ranges::reverse(hole);
        Ring round;
        for (int i = 0; i < 90; ++i) {
            const double angle = -2.0 * std::numbers::pi * i / 90.0;
            round.push_back({100.0 + 20.0 * std::cos(angle), 20.0 * std::sin(angle)});
        }
        const LocalFrame frame = LocalFrame::centredOn(kCentre).value();
        source.parts.front().holes = {frame.toGeo(hole), frame.toGeo(round)};
        const FieldSource straight = withStraightSteps(source).value();
        QVERIFY(straight.parts.front().outer == source.parts.front().outer);
        QVERIFY(straight.parts.front().holes[0].size() <= 16);
        QVERIFY(straight.parts.front().holes[1] == source.parts.front().holes[1]);
    }
    void aProjectChangesOnlyTheseFields() {
        Project project =
            withFields(Project::empty(), {fieldOf(stairs(20, 4.0, 1.5)), fieldOf(stairs(30, 4.0, 1.5)),
                                          fieldOf({{0, 0}, {80, 0}, {80, 50}, {0, 50}})});
        const std::size_t one[] = {1};
        const Project second = withStraightSteps(project, one);
        QVERIFY(second.fields[0] == project.fields[0] && second.fields[2] == project.fields[2]);
        QVERIFY(!stepsOf(*second.fields[1]->source));
        const std::size_t all[] = {0, 1, 2};
        const Project every = withStraightSteps(project, all);
        QVERIFY(!stepsOf(*every.fields[0]->source));
        QVERIFY(every.fields[2] == project.fields[2]);
    }
};

FURROW_TEST(OutlineStepsTest);
#include "tst_outline_steps.moc"
