#include "planner/audit/depth_sweep.h"
#include "planner/audit/region_tracer.h"
#include "planner/geometry/geos_bridge.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QTest>

#include <random>
#include <stop_token>

using namespace furrow;
using namespace furrow::test;

namespace {

enum Region : std::size_t { kOnce, kTwice, kFirstOnly, kRegionCount };

/// Layer 0 is one set, layer 1 another.
std::uint32_t regionsAt(const Depths& depths) {
    const int all = depths[0] + depths[1];
    return (all > 0 ? 1U << kOnce : 0U) | (all > 1 ? 1U << kTwice : 0U) |
           (depths[0] > 0 && depths[1] <= 0 ? 1U << kFirstOnly : 0U);
}

Result<std::vector<MeasuredRegion>> measured(const MultiPolygon& a, const MultiPolygon& b,
                                             Point along = {1.0, 0.0}, const JobContext& job = {}) {
    LayeredPolygons layers;
    layers.add(0, a);
    layers.add(1, b);
    return measureRegions(layers, along, {.at = regionsAt, .count = kRegionCount, .traced = 7}, job);
}

}  // namespace

class TestDepthSweep : public QObject {
    Q_OBJECT
private slots:
    /// A bent strip of quadrilaterals that lies over itself: the same areas as ring by ring.
    void ringsThatFollowEachOther() {
        LayeredPolygons one;
        LayeredPolygons other;
        std::vector<Point> left;
        std::vector<Point> right;
        for (int i = 0; i <= 60; ++i) {
            const double angle = 0.12 * i;
            left.push_back((10.0 - 0.05 * i) * direction(angle));
            right.push_back((13.0 - 0.05 * i) * direction(angle));
        }
        for (std::size_t i = 0; i + 1 < left.size(); ++i) {
            const Ring quad{left[i], right[i], right[i + 1], left[i + 1]};
            one.add(0, quad);
            other.addNext(0, quad);
        }
        QCOMPARE(one.edges().size(), std::size_t{240});
        QCOMPARE(other.edges().size(), std::size_t{122});  // 60 on both sides, 2 ends
        const auto a = measureRegions(one, {1.0, 0.0}, {.at = regionsAt, .count = kRegionCount}, {});
        const auto b = measureRegions(other, {1.0, 0.0}, {.at = regionsAt, .count = kRegionCount}, {});
        VERIFY_RESULT(a);
        VERIFY_RESULT(b);
        QVERIFY((*a)[kTwice].area > squareMetres(1.0));
        for (const Region region : {kOnce, kTwice, kFirstOnly}) {
            QCOMPARE_LT(std::abs(((*a)[region].area - (*b)[region].area).si()), 1e-8);
        }
    }

    void byHand_data() {
        QTest::addColumn<QString>("a");
        QTest::addColumn<QString>("b");
        QTest::addColumn<double>("once");
        QTest::addColumn<double>("twice");
        QTest::addColumn<double>("firstOnly");
        QTest::addColumn<int>("parts");  // of what is only in the first
        QTest::addColumn<int>("holes");
        const char* square = "POLYGON((0 0, 10 0, 10 10, 0 10, 0 0))";
        QTest::newRow("apart") << square << "POLYGON((20 0, 30 0, 30 10, 20 10, 20 0))" << 200.0 << 0.0
                               << 100.0 << 1 << 0;
        QTest::newRow("beside, sharing an edge")
            << square << "POLYGON((10 0, 20 0, 20 10, 10 10, 10 0))" << 200.0 << 0.0 << 100.0 << 1 << 0;
        QTest::newRow("on it, sharing an edge")
            << square << "POLYGON((0 10, 10 10, 10 20, 0 20, 0 10))" << 200.0 << 0.0 << 100.0 << 1 << 0;
        QTest::newRow("the same") << square << square << 100.0 << 100.0 << 0.0 << 0 << 0;
        QTest::newRow("a corner over it")
            << square << "POLYGON((5 5, 15 5, 15 15, 5 15, 5 5))" << 175.0 << 25.0 << 75.0 << 1 << 0;
        QTest::newRow("inside it") << square << "POLYGON((4 4, 6 4, 6 6, 4 6, 4 4))" << 100.0 << 4.0 << 96.0
                                   << 1 << 1;
        QTest::newRow("inside it, touching an edge")
            << square << "POLYGON((4 0, 6 0, 6 6, 4 6, 4 0))" << 100.0 << 12.0 << 88.0 << 1 << 0;
        QTest::newRow("inside it, touching an edge with a corner")
            << square << "POLYGON((5 0, 7 2, 5 4, 3 2, 5 0))" << 100.0 << 8.0 << 92.0 << 1 << 1;
        QTest::newRow("cut in two") << square << "POLYGON((-1 4, 11 4, 11 6, -1 6, -1 4))" << 104.0 << 20.0
                                    << 80.0 << 2 << 0;
        QTest::newRow("a wedge into it") << square << "POLYGON((5 5, 11 3, 11 7, 5 5))" << 112.0 - 25.0 / 3.0
                                         << 25.0 / 3.0 << 100.0 - 25.0 / 3.0 << 1 << 0;
        QTest::newRow("two squares that touch at a corner")
            << "MULTIPOLYGON(((0 0, 10 0, 10 10, 0 10, 0 0)), ((10 10, 20 10, 20 20, 10 20, 10 10)))"
            << "POLYGON((30 0, 31 0, 31 1, 30 1, 30 0))" << 201.0 << 0.0 << 200.0 << 2 << 0;
        QTest::newRow("a hole") << "POLYGON((0 0, 10 0, 10 10, 0 10, 0 0), (2 2, 2 8, 8 8, 8 2, 2 2))"
                                << square << 100.0 << 64.0 << 0.0 << 0 << 0;
    }
    void byHand() {
        QFETCH(QString, a);
        QFETCH(QString, b);
        QFETCH(double, once);
        QFETCH(double, twice);
        QFETCH(double, firstOnly);
        QFETCH(int, parts);
        QFETCH(int, holes);
        for (const double turn : {0.0, 0.5, 1.3, 2.0, 3.1}) {
            const auto found =
                measured(polygonsFromWkt(a.toStdString()), polygonsFromWkt(b.toStdString()), direction(turn));
            VERIFY_RESULT(found);
            COMPARE_WITHIN((*found)[kOnce].area.si(), once, 1e-7);
            COMPARE_WITHIN((*found)[kTwice].area.si(), twice, 1e-7);
            COMPARE_WITHIN((*found)[kFirstOnly].area.si(), firstOnly, 1e-7);
            const MultiPolygon& polygons = (*found)[kFirstOnly].polygons;
            COMPARE_WITHIN(area(polygons).si(), firstOnly, 1e-6);
            QCOMPARE(static_cast<int>(polygons.size()), parts);
            if (parts > 0) {
                QCOMPARE(static_cast<int>(polygons.front().holes.size()), holes);
            }
        }
    }

    // GEOS is the oracle: union, intersection and difference of random fields, their edges along and across
    // the moving line and not.
    void againstGeos_data() {
        QTest::addColumn<int>("shape");
        for (const Shape shape : kShapes) {
            QTest::addRow("%s", shapeName(shape).data()) << static_cast<int>(shape);
        }
    }
    void againstGeos() {
        QFETCH(int, shape);
        for (std::uint64_t seed = 1; seed <= 100; ++seed) {
            std::mt19937_64 random{seed};
            const MultiPolygon a =
                randomPolygons(random, static_cast<Shape>(shape), uniform(random, 20.0, 200.0));
            const Bounds box = bounds(a);
            const MultiPolygon b =
                moved(randomPolygons(random, kShapes[seed % kShapes.size()], uniform(random, 20.0, 200.0)),
                      degrees(0.0), {});
            const Bounds other = bounds(b);
            const MultiPolygon near = moved(b, degrees(0.0),
                                            0.5 * (box.min + box.max) - 0.5 * (other.min + other.max) +
                                                Point{uniform(random, -50.0, 50.0), 0.0});
            const auto found = measured(a, near, direction(uniform(random, 0.0, 6.3)));
            const QByteArray told = "seed " + QByteArray::number(static_cast<int>(seed));
            VERIFY_TOLD(found.has_value(), told);
            MultiPolygon both = a;
            std::ranges::copy(near, std::back_inserter(both));
            const auto compare = [&](Region region, const Result<MultiPolygon>& expected) {
                const double areaM2 = expected ? area(*expected).si() : -1.0;
                const MultiPolygon& traced = (*found)[region].polygons;
                VERIFY_TOLD(std::abs((*found)[region].area.si() - areaM2) < 1e-5,
                            told + QByteArray::number((*found)[region].area.si() - areaM2));
                VERIFY_TOLD(std::abs(area(traced).si() - areaM2) < 1e-2,
                            told + QByteArray::number(area(traced).si() - areaM2));
                const auto broken = findInvalidPlace(traced, {});
                VERIFY_TOLD(broken && !*broken, told + (broken && *broken ? (*broken)->reason.c_str() : ""));
            };
            compare(kOnce, unionOf(both, {}));
            compare(kTwice, intersection(a, near, {}));
            compare(kFirstOnly, difference(a, near, {}));
        }
    }

    // A square and an arm round its corner: the arm begins in the middle of a side that goes on, and joins
    // the square above. What they enclose touches the outside there. 100 m2 and, by the shoelace
    // formula, 47.5 m2.
    void anArmThatBeginsAtASide() {
        const MultiPolygon square{rectangle(10.0, 10.0)};
        const MultiPolygon arm{{.outer = {{10.0, 5.0},
                                          {15.0, 8.0},
                                          {15.0, 14.0},
                                          {4.0, 14.0},
                                          {4.0, 10.0},
                                          {8.0, 10.0},
                                          {8.0, 12.0},
                                          {12.0, 12.0},
                                          {12.0, 9.0}},
                                .holes = {}}};
        for (const Point along : {Point{1.0, 0.0}, Point{-1.0, 0.0}, Point{0.0, 1.0}, Point{0.0, -1.0}}) {
            const auto found = measured(square, arm, along);
            VERIFY_RESULT(found);
            const MeasuredRegion& once = (*found)[kOnce];
            COMPARE_WITHIN(once.area.si(), 147.5, 1e-9);
            COMPARE_WITHIN(area(once.polygons).si(), 147.5, 1e-6);
            QCOMPARE(once.polygons.size(), std::size_t{1});
            const auto broken = findInvalidPlace(once.polygons, {});
            QVERIFY2(broken && !*broken, broken && *broken ? (*broken)->reason.c_str() : "");
        }
    }

    // A ring may begin and end at one corner, nanometres apart: 10 m by 10 m, the lowest row of nanometres.
    void aCornerAtBothEndsOfTheRing() {
        for (const double rowM : {2e-9, 5e-9, 5e-8}) {
            RegionTracer tracer;
            const RegionTracer::Span span{
                .leftLow = 0.0, .leftHigh = 0.0, .rightLow = 10.0, .rightHigh = 10.0};
            tracer.addRow(0.0, rowM, {span});
            tracer.addRow(rowM, 10.0, {span});
            const MultiPolygon traced = tracer.finish(1e-3);
            QCOMPARE(traced.size(), std::size_t{1});
            COMPARE_WITHIN(area(traced).si(), 100.0, 1e-5);
        }
    }

    // A trough of 10 m, its walls 1 m thick, and a lid between the tops of the walls, or over one of them,
    // that meets them by nanometres or not at all: 10 + 1 + 1 m² and the lid.
    void piecesThatMeetByNanometres() {
        for (const double overM : {-2e-7, -5e-8, 0.0, 5e-8, 2e-7}) {
            for (const double lidLeftM : {1.0, 0.0, -3.0}) {
                RegionTracer tracer;
                const auto wide = [](double left, double right) {
                    return RegionTracer::Span{
                        .leftLow = left, .leftHigh = left, .rightLow = right, .rightHigh = right};
                };
                const double lidM = lidLeftM == 1.0 ? 1.0 - overM : lidLeftM;
                tracer.addRow(0.0, 1.0, {wide(0.0, 10.0)});
                tracer.addRow(1.0, 2.0, {wide(0.0, 1.0), wide(9.0, 10.0)});
                tracer.addRow(2.0, 3.0, {wide(lidM, 9.0 + overM)});
                const MultiPolygon traced = tracer.finish(1e-3);
                COMPARE_WITHIN(area(traced).si(), 12.0 + 9.0 - lidM, 1e-5);
            }
        }
    }

    // Lanes that share their edges but for rounding, along the line and across it.
    void lanesLoseNothing() {
        std::mt19937_64 random{3};
        for (int round = 0; round < 50; ++round) {
            const double width = uniform(random, 1.0, 12.0);
            const double length = uniform(random, 20.0, 900.0);
            const Point along = direction(uniform(random, 0.0, 6.3));
            const Point left{-along.y, along.x};
            MultiPolygon lanes;
            for (int i = 0; i < 200; ++i) {
                const Point start = Point{uniform(random, -1e-10, 1e-10), 1000.0} + (i * width) * left;
                lanes.push_back({.outer = {start, start + length * along,
                                           start + length * along + width * left, start + width * left},
                                 .holes = {}});
            }
            for (const double turn : {0.0, 0.7, 1.5707963267948966}) {
                const auto found = measured(lanes, {},
                                            Point{along.x * std::cos(turn) - along.y * std::sin(turn),
                                                  along.x * std::sin(turn) + along.y * std::cos(turn)});
                VERIFY_RESULT(found);
                COMPARE_WITHIN((*found)[kOnce].area.si(), 200 * width * length, 1e-3);
                COMPARE_WITHIN((*found)[kTwice].area.si(), 0.0, 1e-3);
                COMPARE_WITHIN(area((*found)[kOnce].polygons).si(), 200 * width * length, 1e-2);
            }
        }
    }

    // What lies around lanes is one piece with a hole, also where the line is hardly along them: then lanes
    // and land meet in rows of nanometres.
    void landAroundLanesKeepsItsHole() {
        std::mt19937_64 random{41};
        for (int round = 0; round < 300; ++round) {
            const double width = uniform(random, 1.0, 6.0);
            const double length = uniform(random, 40.0, 200.0);
            const double turn = uniform(random, 0.0, 6.3);
            const Point along = direction(turn);
            const Point left{-along.y, along.x};
            const int count = 4 + round % 40;
            const double gapM = std::pow(10.0, uniform(random, -11.0, -7.0));
            MultiPolygon lanes;
            for (int i = 0; i < count; ++i) {
                // Swaths end at slanting edges.
                const Point start =
                    (uniform(random, 0.0, 8.0) * along) + (i * width + uniform(random, -gapM, gapM)) * left;
                const Point end = start + uniform(random, 0.6, 1.0) * length * along;
                lanes.push_back(
                    {.outer = {start, end, end + width * left, start + width * left}, .holes = {}});
            }
            const auto corner = [&](double x, double y) { return x * along + y * left; };
            const MultiPolygon land{
                {.outer = {corner(-20.0, -20.0), corner(length + 30.0, -20.0),
                           corner(length + 30.0, count * width + 20.0), corner(-20.0, count * width + 20.0)},
                 .holes = {}}};
            for (const double off : {0.0, 1e-11, 1e-10, 5e-10, 5e-9, 5e-8}) {
                const auto found = measured(land, lanes, direction(turn + off));
                VERIFY_RESULT(found);
                const MeasuredRegion& around = (*found)[kFirstOnly];
                VERIFY_TOLD(std::abs(area(around.polygons).si() - around.area.si()) < 1e-2,
                            QStringLiteral("round %1, off by %2: %3 and %4 m²")
                                .arg(round)
                                .arg(off)
                                .arg(area(around.polygons).si())
                                .arg(around.area.si())
                                .toUtf8());
            }
        }
    }

    void cancels() {
        std::stop_source source;
        source.request_stop();
        const auto found = measured({rectangle(1, 1)}, {}, {1.0, 0.0}, {.stop = source.get_token()});
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::Cancelled);
    }
};

FURROW_TEST(TestDepthSweep);
#include "tst_depth_sweep.moc"
