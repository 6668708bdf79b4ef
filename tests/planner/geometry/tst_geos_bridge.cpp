#include "planner/benchmarks/geos_yardstick.h"
#include "planner/geometry/geos_bridge.h"
#include "planner/geometry/prepared_area.h"
#include "planner/geometry/segment.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <stop_token>
#include <thread>

using namespace furrow;
using test::lineFromWkt;
using test::polygonsFromWkt;

namespace {

constexpr double kPi = std::numbers::pi;

JobContext stoppedJob() {
    std::stop_source source;
    source.request_stop();
    return {.stop = source.get_token(), .progress = {}, .threads = 1};
}

/// Outer rings counter-clockwise, holes clockwise, largest first, no closing points.
bool isInOurForm(const MultiPolygon& polygons) {
    double before = std::numeric_limits<double>::infinity();
    for (const Polygon& polygon : polygons) {
        if (signedAreaM2(polygon.outer) <= 0.0 || polygon.outer.front() == polygon.outer.back()) {
            return false;
        }
        for (const Ring& hole : polygon.holes) {
            if (signedAreaM2(hole) >= 0.0 || hole.front() == hole.back()) {
                return false;
            }
        }
        if (area(polygon).si() > before) {
            return false;
        }
        before = area(polygon).si();
    }
    return true;
}

}  // namespace

class GeosBridgeTest : public QObject {
    Q_OBJECT

private slots:
    void erodes_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<double>("distanceM");
        QTest::addColumn<int>("parts");
        QTest::addColumn<double>("areaM2");
        QTest::addColumn<double>("toleranceM2");
        // Straight corners stay corners: all by hand, exact.
        QTest::newRow("square") << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))" << 10.0 << 1 << 6400.0
                                << 1e-6;
        QTest::newRow("rectangle") << "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0))" << 7.5 << 1 << 85.0 * 45.0
                                   << 1e-6;
        QTest::newRow("by nothing") << "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0))" << 0.0 << 1 << 6000.0
                                    << 1e-9;
        QTest::newRow("more than there is")
            << "POLYGON((0 0, 100 0, 100 60, 0 60, 0 0))" << 30.1 << 0 << 0.0 << 0.0;
        // The hole grows to a square with sides moved out and quarter circles at its corners.
        QTest::newRow("hole grows with rounded corners")
            << "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 40 60, 60 60, 60 40, 40 40))" << 10.0 << 1
            << 6400.0 - (400.0 + 4.0 * 20.0 * 10.0 + kPi * 100.0) << 2.0;
        // A waist of 8 m between squares of 40 m: eroded by 5 m it parts into two squares of 30 m, each with
        // a bulge towards the waist between circles of 5 m around its corners: with u the distance from the
        // corners' line, the integral of 8 - 2 sqrt(25 - u²) from 3 to 5 is 16 - 12.5 pi + 12 + 25 asin(0.6).
        QTest::newRow("waist parts in two")
            << "POLYGON((0 0, 40 0, 40 16, 60 16, 60 0, 100 0, 100 40, 60 40, 60 24, 40 24, 40 40, 0 40, 0 0))"
            << 5.0 << 2 << 1800.0 + 2.0 * (28.0 - 12.5 * kPi + 25.0 * std::asin(0.6)) << 0.2;
        QTest::newRow("two parts shrink apart")
            << "MULTIPOLYGON(((0 0, 20 0, 20 20, 0 20, 0 0)), ((30 0, 60 0, 60 30, 30 30, 30 0)))" << 5.0 << 2
            << 100.0 + 400.0 << 1e-6;
    }
    void erodes() {
        QFETCH(QString, wkt);
        QFETCH(double, distanceM);
        QFETCH(int, parts);
        QFETCH(double, areaM2);
        QFETCH(double, toleranceM2);
        const auto result = eroded(polygonsFromWkt(wkt.toStdString()), metres(distanceM), kArcTolerance, {});
        VERIFY_RESULT(result);
        QCOMPARE(static_cast<int>(result->size()), parts);
        COMPARE_WITHIN(area(*result).si(), areaM2, toleranceM2);
        QVERIFY(isInOurForm(*result));
    }

    // 4,000 spikes of 120 m that stand 10 to 20 cm apart. What lies 6 m inside is the disc that has none,
    // smaller by that: the tips between the spikes lie on its edge.
    void erodesSpikesThatStandClose() {
        Ring star;
        for (int i = 0; i < 8'000; ++i) {
            star.push_back((i % 2 == 0 ? 250.0 : 130.0) * direction(2.0 * kPi * i / 8'000));
        }
        const auto result = eroded({{.outer = star, .holes = {}}}, metres(6.0), kArcTolerance, {});
        VERIFY_RESULT(result);
        QCOMPARE(result->size(), std::size_t{1});
        QVERIFY(isInOurForm(*result));
        double nearestM = 1e9;
        double farthestM = 0.0;
        for (const Point& point : result->front().outer) {
            nearestM = std::min(nearestM, norm(point));
            farthestM = std::max(farthestM, norm(point));
        }
        // Between two tips the circle bulges by a millimetre, and its arcs are chords; thinning may take 5
        // cm.
        QCOMPARE_LE(farthestM, 124.0 + 0.02);
        QCOMPARE_GE(nearestM, 124.0 - 0.1);
    }

    // Around a re-entrant corner of an L: points of the arc are at the distance, chords within the tolerance.
    void arcsKeepTheTolerance_data() {
        QTest::addColumn<double>("distanceM");
        QTest::addColumn<double>("toleranceM");
        QTest::newRow("a headland") << 7.5 << 0.01;
        QTest::newRow("a wide headland") << 24.0 << 0.01;
        QTest::newRow("coarse") << 24.0 << 0.2;
    }
    void arcsKeepTheTolerance() {
        QFETCH(double, distanceM);
        QFETCH(double, toleranceM);
        const auto result =
            eroded(polygonsFromWkt("POLYGON((0 0, 200 0, 200 100, 100 100, 100 200, 0 200, 0 0))"),
                   metres(distanceM), metres(toleranceM), {});
        VERIFY_RESULT(result);
        const Point corner{100.0, 100.0};
        int onArc = 0;
        forEachEdge(*result, [&](Point from, Point to) {
            const Point middle = 0.5 * (from + to);
            if (middle.x < 100.0 && middle.y < 100.0 && middle.x > 99.0 - distanceM &&
                middle.y > 99.0 - distanceM) {
                ++onArc;
                const double away = distance(middle, corner);
                QVERIFY2(away > distanceM - toleranceM - 1e-9 && away < distanceM + 1e-9,
                         qPrintable(QString::number(away)));
            }
        });
        QVERIFY(onArc >= 2);
    }

    void dilates() {
        // Minkowski: area + perimeter x distance + a full circle.
        const auto result = dilated({test::rectangle(40.0, 20.0)}, metres(5.0), kArcTolerance, {});
        VERIFY_RESULT(result);
        COMPARE_WITHIN(area(*result).si(), 800.0 + 120.0 * 5.0 + 25.0 * kPi, 0.5);
        QVERIFY(isInOurForm(*result));
        const auto grown = dilated({}, metres(5.0), kArcTolerance, {});
        VERIFY_RESULT(grown);
        QVERIFY(grown->empty());
    }

    void combines() {
        const MultiPolygon a{test::rectangle(10.0, 10.0)};
        const MultiPolygon b{test::rectangle(10.0, 10.0, {6.0, 4.0})};
        const auto both = intersection(a, b, {});
        VERIFY_RESULT(both);
        COMPARE_WITHIN(area(*both).si(), 4.0 * 6.0, 1e-9);
        const auto rest = difference(a, b, {});
        VERIFY_RESULT(rest);
        COMPARE_WITHIN(area(*rest).si(), 100.0 - 24.0, 1e-9);
        const auto joined = unionOf({a.front(), b.front()}, {});
        VERIFY_RESULT(joined);
        COMPARE_WITHIN(area(*joined).si(), 200.0 - 24.0, 1e-9);
        QCOMPARE(joined->size(), std::size_t{1});
        const auto hollow = difference(a, {test::rectangle(2.0, 2.0, {4.0, 4.0})}, {});
        VERIFY_RESULT(hollow);
        QVERIFY(isInOurForm(*hollow));
        QCOMPARE(hollow->front().holes.size(), std::size_t{1});
        const auto nothing = intersection(a, {test::rectangle(1.0, 1.0, {50.0, 50.0})}, {});
        VERIFY_RESULT(nothing);
        QVERIFY(nothing->empty());
        // Touching along an edge is a line, not land.
        const auto touching = intersection(a, {test::rectangle(5.0, 10.0, {10.0, 0.0})}, {});
        VERIFY_RESULT(touching);
        QVERIFY(touching->empty());
    }

    // Its spike comes back on itself and crosses: 10 by 10 m less a corner of 2 by 2 m, and what it is taken
    // from is a bow tie of two triangles of 25 m².
    void combinesWhatCrossesItself() {
        const MultiPolygon spiked = polygonsFromWkt("POLYGON((0 0, 10 0, 10 10, 12 10, 8 10, 0 10, 0 0))");
        const auto rest = difference(spiked, {test::rectangle(4.0, 4.0, {8.0, 8.0})}, {});
        VERIFY_RESULT(rest);
        COMPARE_WITHIN(area(*rest).si(), 96.0, 1e-9);
        const MultiPolygon bow = polygonsFromWkt("POLYGON((0 0, 10 10, 10 0, 0 10, 0 0))");
        const auto half = difference(bow, {test::rectangle(5.0, 10.0)}, {});
        VERIFY_RESULT(half);
        COMPARE_WITHIN(area(*half).si(), 25.0, 1e-9);
        QVERIFY(isInOurForm(*half));
    }

    // Squares of 1.5 m, the second moved by 0.25 and 0.5 m: worked by hand, to the last bit, as all corners
    // are binary fractions. Any grid coarser than an eighth of a metre would show.
    void fractionsStay_data() {
        QTest::addColumn<double>("gridM");
        QTest::newRow("without a grid") << 0.0;
        QTest::newRow("on the grid for lanes") << kSnapGrid.si();
    }
    void fractionsStay() {
        QFETCH(double, gridM);
        const Length grid = metres(gridM);
        const MultiPolygon a{test::rectangle(1.5, 1.5, {0.125, 0.375})};
        const MultiPolygon b{test::rectangle(1.5, 1.5, {0.375, 0.875})};
        const auto both = intersection(a, b, {}, grid);
        VERIFY_RESULT(both);
        COMPARE_WITHIN(area(*both).si(), 1.25 * 1.0, 1e-9);
        COMPARE_WITHIN(bounds(*both).min.x, 0.375, 1e-9);
        const auto rest = difference(a, b, {}, grid);
        VERIFY_RESULT(rest);
        COMPARE_WITHIN(area(*rest).si(), 2.25 - 1.25, 1e-9);
        const auto joined = unionOf({a.front(), b.front()}, {}, grid);
        VERIFY_RESULT(joined);
        COMPARE_WITHIN(area(*joined).si(), 4.5 - 1.25, 1e-9);
        COMPARE_WITHIN(bounds(*joined).max.y, 2.375, 1e-9);
    }

    void findsInvalidPlaces_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<QString>("reason");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("valid") << "POLYGON((0 0, 10 0, 10 10, 0 10, 0 0))" << "" << 0.0 << 0.0;
        QTest::newRow("valid with a hole")
            << "POLYGON((0 0, 10 0, 10 10, 0 10, 0 0), (4 4, 4 6, 6 6, 6 4, 4 4))" << "" << 0.0 << 0.0;
        QTest::newRow("bow-tie") << "POLYGON((0 0, 10 10, 10 0, 0 10, 0 0))" << "Self-intersection" << 5.0
                                 << 5.0;
        QTest::newRow("uneven bow-tie")
            << "POLYGON((0 0, 30 10, 30 0, 0 20, 0 0))" << "Self-intersection" << 20.0 << 20.0 / 3.0;
        QTest::newRow("ring touches itself at a vertex")
            << "POLYGON((0 0, 10 0, 5 5, 10 10, 0 10, 5 5, 0 0))" << "Ring Self-intersection" << 5.0 << 5.0;
        QTest::newRow("hole crosses the boundary")
            << "POLYGON((0 0, 10 0, 10 10, 0 10, 0 0), (8 4, 8 6, 12 6, 12 4, 8 4))" << "Self-intersection"
            << 10.0 << -1.0;
    }
    void findsInvalidPlaces() {
        QFETCH(QString, wkt);
        QFETCH(QString, reason);
        QFETCH(double, x);
        QFETCH(double, y);
        const auto problem = findInvalidPlace(polygonsFromWkt(wkt.toStdString()), {});
        VERIFY_RESULT(problem);
        QCOMPARE(problem->has_value(), !reason.isEmpty());
        if (problem->has_value()) {
            QCOMPARE((*problem)->reason, reason.toStdString());
            COMPARE_WITHIN((*problem)->place.x, x, 1e-9);
            if (y >= 0.0) {
                COMPARE_WITHIN((*problem)->place.y, y, 1e-9);
            }
        }
    }

    void makesValid() {
        // Two triangles of 5 m on either side of the crossing.
        const auto wings = madeValid(polygonsFromWkt("POLYGON((0 0, 10 10, 10 0, 0 10, 0 0))"), {});
        VERIFY_RESULT(wings);
        QCOMPARE(wings->size(), std::size_t{2});
        COMPARE_WITHIN(area(*wings).si(), 50.0, 1e-9);
        QVERIFY(isInOurForm(*wings));
    }

    void covers_data() {
        QTest::addColumn<QString>("line");
        QTest::addColumn<bool>("covered");
        QTest::addColumn<QString>("farthest");
        QTest::addColumn<double>("distanceM");
        // In a square of 100 m with a hole from 40 to 60.
        QTest::newRow("inside") << "LINESTRING(10 10, 90 10)" << true << "" << 0.0;
        QTest::newRow("along the edge") << "LINESTRING(0 0, 100 0)" << true << "" << 0.0;
        QTest::newRow("along the edge of the hole") << "LINESTRING(40 10, 40 90)" << true << "" << 0.0;
        QTest::newRow("touches the edge from inside")
            << "LINESTRING(10 10, 50 0, 90 10)" << true << "" << 0.0;
        QTest::newRow("ends outside") << "LINESTRING(90 20, 107 20)" << false << "107 20" << 7.0;
        QTest::newRow("bend outside") << "LINESTRING(20 90, 30 112, 40 90)" << false << "30 112" << 12.0;
        QTest::newRow("past a corner") << "LINESTRING(95 50, 103 104, 50 95)" << false << "103 104" << 5.0;
        QTest::newRow("across the hole is farthest out in its middle")
            << "LINESTRING(30 50, 70 50)" << false << "50 50" << 10.0;
        QTest::newRow("across a side of the hole") << "LINESTRING(30 57, 70 57)" << false << "50 57" << 3.0;
        QTest::newRow("across the hole from corner to corner")
            << "LINESTRING(40 40, 60 60)" << false << "50 50" << 10.0;
        QTest::newRow("across the hole from edge to edge")
            << "LINESTRING(40 45, 60 45)" << false << "50 45" << 5.0;
        QTest::newRow("wholly outside") << "LINESTRING(110 0, 130 50)" << false << "130 50" << 30.0;
    }
    void covers() {
        QFETCH(QString, line);
        QFETCH(bool, covered);
        QFETCH(QString, farthest);
        QFETCH(double, distanceM);
        const PreparedArea area{polygonsFromWkt(
            "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 40 60, 60 60, 60 40, 40 40))")};
        const std::vector<Polyline> lines{lineFromWkt(line.toStdString())};
        QCOMPARE(area.covers(lines), covered);
        const auto found = area.farthestOutside(lines);
        QCOMPARE(found.has_value(), !covered);
        if (found) {
            const Point expected = lineFromWkt("LINESTRING(" + farthest.toStdString() + ")").front();
            COMPARE_WITHIN(found->point.x, expected.x, 1e-9);
            COMPARE_WITHIN(found->point.y, expected.y, 1e-9);
            COMPARE_WITHIN(found->distance.si(), distanceM, 1e-9);
        }
    }

    // Against a walk along the lines in small steps, with the even-odd rule and the distance from every edge.
    void farthestOutsideOfRandomAreas() {
        constexpr std::uint64_t kSeed = 11;
        constexpr int kSteps = 1000;
        std::mt19937_64 random{kSeed};
        for (int field = 0; field < 60; ++field) {
            const MultiPolygon polygons = test::randomPolygons(
                random, field % 2 == 0 ? test::Shape::Concave : test::Shape::Holes, 50.0);
            const Bounds box = bounds(polygons);
            Polyline line;
            for (int k = 0; k < 5; ++k) {
                line.push_back({test::uniform(random, box.min.x - 20.0, box.max.x + 20.0),
                                test::uniform(random, box.min.y - 20.0, box.max.y + 20.0)});
            }
            const auto awayM = [&](Point point) {
                double nearest = std::numeric_limits<double>::infinity();
                forEachEdge(polygons, [&](Point a, Point b) {
                    nearest = std::min(nearest, distanceToSegment(point, a, b));
                });
                return isInside(polygons, point) ? 0.0 : nearest;
            };
            double farthest = awayM(line.front());
            double slack = 0.0;
            for (std::size_t k = 1; k < line.size(); ++k) {
                const Point way = line[k] - line[k - 1];
                slack = std::max(slack, 2.0 * norm(way) / kSteps);
                farthest = std::max(farthest, awayM(line[k]));
                std::optional<int> outsideFrom;
                for (int i = 0; i <= kSteps; ++i) {
                    const bool isOut =
                        !isInside(polygons, line[k - 1] + (static_cast<double>(i) / kSteps) * way);
                    if (isOut && !outsideFrom) {
                        outsideFrom = i;
                    }
                    if (outsideFrom && (!isOut || i == kSteps)) {
                        const double middle = 0.5 * (*outsideFrom + i) / kSteps;
                        farthest = std::max(farthest, awayM(line[k - 1] + middle * way));
                        outsideFrom.reset();
                    }
                }
            }
            const auto found = PreparedArea{polygons}.farthestOutside({line});
            const QByteArray where = "field " + QByteArray::number(field);
            VERIFY_TOLD(std::abs((found ? found->distance.si() : 0.0) - farthest) <= slack, where);
            if (found) {
                VERIFY_TOLD(std::abs(awayM(found->point) - found->distance.si()) < 1e-9, where);
            }
        }
    }

    void aStoppedJobIsCancelled() {
        const JobContext job = stoppedJob();
        const MultiPolygon square{test::rectangle(10.0, 10.0)};
        const auto verify = [](const auto& result) { return !result && result.error() == cancelled(); };
        QVERIFY(verify(eroded(square, metres(1.0), kArcTolerance, job)));
        QVERIFY(verify(dilated(square, metres(1.0), kArcTolerance, job)));
        QVERIFY(verify(difference(square, square, job)));
        QVERIFY(verify(intersection(square, square, job)));
        QVERIFY(verify(unionOf(square, job)));
        QVERIFY(verify(findInvalidPlace(square, job)));
        QVERIFY(verify(madeValid(square, job)));
    }

    // A stop that comes while GEOS is at work: a ring of 200,000 corners takes it seconds.
    void stopsWithinALongOperation() {
        Ring comb;
        constexpr int kTeeth = 50'000;
        for (int i = 0; i < kTeeth; ++i) {
            comb.push_back({i * 0.5, 0.0});
            comb.push_back({i * 0.5 + 0.2, 100.0 + (i % 7)});
        }
        comb.push_back({kTeeth * 0.5, 200.0});
        comb.push_back({0.0, 200.0});
        const MultiPolygon polygons{Polygon{.outer = comb, .holes = {}}};
        std::stop_source source;
        const JobContext job{.stop = source.get_token(), .progress = {}, .threads = 1};
        const std::jthread stopper{[&] { source.request_stop(); }};
        const auto result = dilated(polygons, metres(3.0), kArcTolerance, job);
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Cancelled);
        // What was interrupted leaves nothing behind for the next one.
        const auto next = dilated({test::rectangle(10.0, 10.0)}, metres(1.0), kArcTolerance, {});
        VERIFY_RESULT(next);
    }

    // A point every 5 cm that lies up to 2 cm beside the circle: as they are, GEOS moves them in for seconds
    // that no stop ends. Thinned, the result is never nearer to the boundary, and 10 cm farther at most.
    void aBoundaryOfScatteredPointsIsThinned() {
        constexpr std::uint64_t kSeed = 12;
        std::mt19937_64 random{kSeed};
        constexpr int kPoints = 62'832;
        Ring ring;
        for (int i = 0; i < kPoints; ++i) {
            ring.push_back((500.0 + test::uniform(random, -0.02, 0.02)) *
                           direction(2.0 * std::numbers::pi * i / kPoints));
        }
        const auto inner = eroded({{.outer = ring, .holes = {}}}, metres(1.25), kArcTolerance, {});
        VERIFY_RESULT(inner);
        QCOMPARE(inner->size(), std::size_t{1});
        VERIFY_TOLD(vertexCount(*inner) < 25'000, QByteArray::number(vertexCount(*inner)));
        const Ring& result = inner->front().outer;
        for (std::size_t k = 0; k < result.size(); k += 97) {
            const Point point = result[k];
            double nearest = 500.0;
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Point from = ring[i];
                const Point way = ring[(i + 1) % ring.size()] - from;
                const double along = std::clamp(dot(point - from, way) / dot(way, way), 0.0, 1.0);
                nearest = std::min(nearest, distance(point, from + along * way));
            }
            VERIFY_TOLD(nearest >= 1.25 - 1e-6 && nearest <= 1.35, QByteArray::number(nearest));
        }
    }

    void severalThreadsAtOnce() {
        const MultiPolygon polygons = polygonsFromWkt(
            "POLYGON((0 0, 100 0, 100 100, 0 100, 0 0), (40 40, 40 60, 60 60, 60 40, 40 40))");
        const auto expected = eroded(polygons, metres(7.5), kArcTolerance, {});
        VERIFY_RESULT(expected);
        const PreparedArea prepared{polygons};
        const PreparedArea other{MultiPolygon{test::rectangle(30.0, 30.0)}};
        const PreparedArea third{MultiPolygon{test::rectangle(5.0, 5.0, {200.0, 200.0})}};
        const std::vector<Polyline> across{lineFromWkt("LINESTRING(30 50, 70 50)")};
        const std::vector<Polyline> inside{lineFromWkt("LINESTRING(5 5, 25 25)")};
        std::array<bool, 4> good{};
        {
            std::vector<std::jthread> threads;
            for (bool& result : good) {
                threads.emplace_back([&] {
                    result = true;
                    for (int i = 0; i < 100; ++i) {
                        // Another planner's stop must not reach this one's work.
                        const auto cancelledOne = eroded(polygons, metres(7.5), kArcTolerance, stoppedJob());
                        const auto now = eroded(polygons, metres(7.5), kArcTolerance, {});
                        const auto farthest = prepared.farthestOutside(across);
                        result = result && !cancelledOne && now && *now == *expected &&
                                 !prepared.covers(across) && prepared.covers(inside) &&
                                 other.covers(inside) && !third.covers(inside) && farthest &&
                                 std::abs(farthest->distance.si() - 10.0) < 1e-9;
                    }
                });
            }
        }
        for (const bool result : good) {
            QVERIFY(result);
        }
    }

    // An area's place in a thread's store must not be mistaken for that of an area that is gone.
    void areasComeAndGo() {
        const std::vector<Polyline> line{lineFromWkt("LINESTRING(1 1, 2 2)")};
        for (int i = 0; i < 50; ++i) {
            const PreparedArea near{MultiPolygon{test::rectangle(10.0, 10.0)}};
            QVERIFY(near.covers(line));
            PreparedArea far{MultiPolygon{test::rectangle(10.0, 10.0, {100.0, 100.0})}};
            QVERIFY(!far.covers(line));
            const PreparedArea taken = std::move(far);
            QVERIFY(!taken.covers(line));
        }
    }

    void ringsAndAreas() {
        COMPARE_WITHIN(signedAreaM2(Ring{{0, 0}, {4, 0}, {4, 3}}), 6.0, 1e-12);
        COMPARE_WITHIN(signedAreaM2(Ring{{0, 0}, {4, 3}, {4, 0}}), -6.0, 1e-12);
        // Far from the origin nothing is lost: a square metre at UTM-like coordinates.
        COMPARE_WITHIN(
            signedAreaM2(
                Ring{{500'000, 5'700'000}, {500'001, 5'700'000}, {500'001, 5'700'001}, {500'000, 5'700'001}}),
            1.0, 1e-9);
        const MultiPolygon polygons = polygonsFromWkt(
            "MULTIPOLYGON(((0 0, 10 0, 10 10, 0 10, 0 0), (4 4, 4 6, 6 6, 6 4, 4 4)), ((20 5, 25 5, 25 30, 20 5)))");
        COMPARE_WITHIN(area(polygons).si(), 96.0 + 62.5, 1e-12);
        const Bounds box = bounds(polygons);
        QVERIFY((box.min == Point{0.0, 0.0}) && (box.max == Point{25.0, 30.0}));
        QCOMPARE(vertexCount(polygons), std::size_t{11});
        COMPARE_WITHIN(lengthM(Polyline{{0, 0}, {3, 4}, {3, 10}}), 11.0, 1e-12);
    }

    // 100 m x 50 m in strips of 2.5 m along and across: 20 of 100 m, 40 of 50 m, nothing left.
    void theYardstickMeasuresARectangle() {
        const Polygon field{.outer = {{0, 0}, {100, 0}, {100, 50}, {0, 50}}, .holes = {}};
        const PlainFigures along = plainFigures(field, metres(2.5), degrees(0.0), true);
        QCOMPARE(along.count, 20);
        QVERIFY(std::abs(along.length.si() - 2000.0) < 1e-6);
        QVERIFY(std::abs(along.coverage - 1.0) < 1e-9);
        const PlainFigures across = plainFigures(field, metres(2.5), degrees(90.0), false);
        QCOMPARE(across.count, 40);
        QVERIFY(std::abs(across.length.si() - 2000.0) < 1e-6);
    }
};

FURROW_TEST(GeosBridgeTest);
#include "tst_geos_bridge.moc"
