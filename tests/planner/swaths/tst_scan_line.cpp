#include "planner/swaths/heading_search.h"
#include "planner/swaths/scan_line.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

using namespace furrow;
using test::polygonsFromWkt;

namespace {

constexpr double kPi = std::numbers::pi;

/// GEOS as the oracle: nothing of the planner's own geometry in between.
class Oracle {
public:
    struct Delete {
        void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context(), geometry); }
    };
    using Geometry = std::unique_ptr<GEOSGeometry, Delete>;

    static GEOSContextHandle_t context() {
        static const GEOSContextHandle_t handle = GEOS_init_r();
        return handle;
    }

    static GEOSCoordSequence* sequence(const std::vector<Point>& points, bool close) {
        const auto count = static_cast<unsigned>(points.size() + (close ? 1 : 0));
        GEOSCoordSequence* made = GEOSCoordSeq_create_r(context(), count, 2);
        for (unsigned i = 0; i < count; ++i) {
            GEOSCoordSeq_setXY_r(context(), made, i, points[i % points.size()].x,
                                 points[i % points.size()].y);
        }
        return made;
    }
    static Geometry polygon(const Polygon& polygon) {
        std::vector<GEOSGeometry*> holes;
        holes.reserve(polygon.holes.size());
        for (const Ring& hole : polygon.holes) {
            holes.push_back(GEOSGeom_createLinearRing_r(context(), sequence(hole, true)));
        }
        return Geometry{GEOSGeom_createPolygon_r(
            context(), GEOSGeom_createLinearRing_r(context(), sequence(polygon.outer, true)), holes.data(),
            static_cast<unsigned>(holes.size()))};
    }
    static Geometry line(Point from, Point to) {
        return Geometry{GEOSGeom_createLineString_r(context(), sequence({from, to}, false))};
    }
    static Geometry unionOf(std::vector<Geometry> parts) {
        std::vector<GEOSGeometry*> raw;
        raw.reserve(parts.size());
        for (Geometry& part : parts) {
            raw.push_back(part.release());
        }
        const Geometry all{GEOSGeom_createCollection_r(context(), GEOS_GEOMETRYCOLLECTION, raw.data(),
                                                       static_cast<unsigned>(raw.size()))};
        return Geometry{GEOSUnaryUnion_r(context(), all.get())};
    }
    static Geometry both(const Geometry& a, const Geometry& b) {
        return Geometry{GEOSIntersection_r(context(), a.get(), b.get())};
    }
    static double area(const Geometry& geometry) {
        double value = 0.0;
        GEOSArea_r(context(), geometry.get(), &value);
        return value;
    }
    static double length(const GEOSGeometry* geometry) {
        double value = 0.0;
        GEOSLength_r(context(), geometry, &value);
        return value;
    }
};

struct OracleSwath {
    Point start;
    Point end;
    double y = 0.0;  // of its centre line, turned
};

struct OracleFigures {
    int count = 0;
    double lengthM = 0.0;
    double coverage = 0.0;
    double overlapM2 = 0.0;
};

Oracle::Geometry mainlandOf(const MultiPolygon& polygons) {
    std::vector<Oracle::Geometry> parts;
    for (const Polygon& polygon : polygons) {
        parts.push_back(Oracle::polygon(polygon));
    }
    return Oracle::unionOf(std::move(parts));
}

Point at(double headingRad, double along, double across) {
    const Point ahead{std::cos(headingRad), std::sin(headingRad)};
    return along * ahead + across * Point{-ahead.y, ahead.x};
}

/// The figures of swaths on these centre lines, by overlays.
OracleFigures measured(const Oracle::Geometry& mainland, double mainlandM2, double headingRad,
                       const std::vector<double>& tracks, double widthM, double farM) {
    constexpr double kShortestM = 1e-3;
    OracleFigures figures;
    std::vector<OracleSwath> swaths;
    for (const double y : tracks) {
        const auto cut =
            Oracle::both(Oracle::line(at(headingRad, -farM, y), at(headingRad, farM, y)), mainland);
        for (int i = 0; i < GEOSGetNumGeometries_r(Oracle::context(), cut.get()); ++i) {
            const GEOSGeometry* part = GEOSGetGeometryN_r(Oracle::context(), cut.get(), i);
            const double lengthM = Oracle::length(part);
            if (lengthM < kShortestM) {
                continue;
            }
            OracleSwath swath{.start = {}, .end = {}, .y = y};
            const GEOSCoordSequence* points = GEOSGeom_getCoordSeq_r(Oracle::context(), part);
            unsigned count = 0;
            GEOSCoordSeq_getSize_r(Oracle::context(), points, &count);
            GEOSCoordSeq_getXY_r(Oracle::context(), points, 0, &swath.start.x, &swath.start.y);
            GEOSCoordSeq_getXY_r(Oracle::context(), points, count - 1, &swath.end.x, &swath.end.y);
            swaths.push_back(swath);
            ++figures.count;
            figures.lengthM += lengthM;
        }
    }
    const auto box = [&](const OracleSwath& swath) {
        const Point half = at(headingRad, 0.0, 0.5 * widthM);
        return Oracle::polygon(
            {.outer = {swath.start - half, swath.end - half, swath.end + half, swath.start + half},
             .holes = {}});
    };
    std::vector<Oracle::Geometry> boxes;
    std::vector<Oracle::Geometry> twice;
    for (std::size_t i = 0; i < swaths.size(); ++i) {
        boxes.push_back(box(swaths[i]));
        for (std::size_t k = 0; k < i; ++k) {
            if (std::abs(swaths[i].y - swaths[k].y) < widthM - 1e-9 && swaths[i].y != swaths[k].y) {
                auto pair = Oracle::both(boxes[i], boxes[k]);
                if (Oracle::area(pair) > 0.0) {
                    twice.push_back(std::move(pair));
                }
            }
        }
    }
    if (!boxes.empty()) {
        figures.coverage =
            Oracle::area(Oracle::both(Oracle::unionOf(std::move(boxes)), mainland)) / mainlandM2;
    }
    if (!twice.empty()) {
        figures.overlapM2 = Oracle::area(Oracle::both(Oracle::unionOf(std::move(twice)), mainland));
    }
    return figures;
}

/// Centre lines as a farmer would lay them out: of two layouts the better one counts.
std::vector<std::vector<double>> layoutsOf(const MultiPolygon& polygons, double heading, double widthM,
                                           double overlapM, bool spread) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    forEachEdge(polygons, [&](Point from, Point) {
        const double y = -std::sin(heading) * from.x + std::cos(heading) * from.y;
        low = std::min(low, y);
        high = std::max(high, y);
    });
    const double step = widthM - overlapM;
    std::vector<std::vector<double>> layouts;
    if (high - low <= widthM) {
        layouts = {{0.5 * (low + high)}};
    } else {
        const int count = 1 + static_cast<int>(std::ceil((high - low - widthM) / step));
        const double first = low + 0.5 * widthM;
        const double last = high - 0.5 * widthM;
        if (spread) {
            layouts.emplace_back();
            for (int k = 0; k < count; ++k) {
                layouts[0].push_back(first + (last - first) * k / (count - 1));
            }
        } else {
            layouts.resize(2);
            for (int k = 0; k < count; ++k) {
                layouts[0].push_back(k + 1 == count ? last : first + k * step);
                layouts[1].push_back(k == 0 ? first : last - (count - 1 - k) * step);
            }
        }
    }
    return layouts;
}

/// Of the layout that covers more, or overlaps less where both cover the same.
OracleFigures bestOf(const std::vector<std::vector<double>>& layouts, const Oracle::Geometry& mainland,
                     double mainlandM2, double heading, double widthM) {
    OracleFigures best = measured(mainland, mainlandM2, heading, layouts[0], widthM, 5000.0);
    if (layouts.size() > 1) {
        const OracleFigures other = measured(mainland, mainlandM2, heading, layouts[1], widthM, 5000.0);
        if (other.coverage > best.coverage + 1e-10 ||
            (other.coverage > best.coverage - 1e-10 && other.overlapM2 < best.overlapM2)) {
            best = other;
        }
    }
    return best;
}

SwathSpacing spacing(double widthM, double overlapM = 0.0, LastPass lastPass = LastPass::Overlap) {
    return {.width = metres(widthM), .overlap = metres(overlapM), .lastPass = lastPass};
}

}  // namespace

class ScanLineTest : public QObject {
    Q_OBJECT

    static void addRectangles() {
        const QString exact = QStringLiteral("POLYGON((0 0, 100 0, 100 50, 0 50, 0 0))");
        const QString odd = QStringLiteral("POLYGON((0 0, 100 0, 100 51, 0 51, 0 0))");
        QTest::newRow("rectangle that fits")
            << exact << 0.0 << 2.5 << 0.0 << false << 20 << 2000.0 << 1.0 << 0.0;
        QTest::newRow("rectangle that fits, across")
            << exact << 90.0 << 2.5 << 0.0 << false << 40 << 2000.0 << 1.0 << 0.0;
        QTest::newRow("rectangle that fits, backwards")
            << exact << 180.0 << 2.5 << 0.0 << false << 20 << 2000.0 << 1.0 << 0.0;
        // 21 x 2.5 m = 52.5 m on 51 m.
        QTest::newRow("a metre too high: the last one overlaps")
            << odd << 0.0 << 2.5 << 0.0 << false << 21 << 2100.0 << 1.0 << 150.0;
        QTest::newRow("a metre too high: spread over all")
            << odd << 0.0 << 2.5 << 0.0 << true << 21 << 2100.0 << 1.0 << 150.0;
        QTest::newRow("a fraction of a millimetre too high counts")
            << "POLYGON((0 0, 100 0, 100 50.0005, 0 50.0005, 0 0))" << 0.0 << 2.5 << 0.0 << false << 21
            << 2100.0 << 1.0 << 249.95;
        // Every 2 m: 23 gaps of 2 m and a last one of 1.5 m; 25 x 2.5 m = 62.5 m on 50 m.
        QTest::newRow("neighbours overlap")
            << exact << 0.0 << 2.5 << 0.5 << false << 25 << 2500.0 << 1.0 << 1250.0;
    }
    static void addSlantsAndHoles() {
        // Section 100 - 2 y; centre lines at 5, 15 ... 45. Each strip misses 5 m x 10 m / 2 above its line.
        QTest::newRow("triangle") << "POLYGON((0 0, 100 0, 0 50, 0 0))" << 0.0 << 10.0 << 0.0 << false << 5
                                  << 250.0 << 0.95 << 0.0;
        // Section 100 - y: 95 + 85 + 75 + 65; each of four strips misses 5 m x 5 m / 2.
        QTest::newRow("trapezoid") << "POLYGON((0 0, 100 0, 80 40, 20 40, 0 0))" << 0.0 << 10.0 << 0.0
                                   << false << 4 << 320.0 << 1.0 - 50.0 / 3200.0 << 0.0;
        QTest::newRow("rectangular hole")
            << "POLYGON((0 0, 100 0, 100 50, 0 50, 0 0), (40 20, 40 30, 60 30, 60 20, 40 20))" << 0.0 << 5.0
            << 0.0 << false << 12 << 8.0 * 100.0 + 4.0 * 40.0 << 1.0 << 0.0;
        // The hole's upper half of 5 m lies in a strip whose centre line runs below it at 17.5: that strip
        // covers through the hole, which is not mainland.
        QTest::newRow("hole between two centre lines")
            << "POLYGON((0 0, 100 0, 100 50, 0 50, 0 0), (40 18, 40 22, 60 22, 60 18, 40 18))" << 0.0 << 5.0
            << 0.0 << false << 10 << 1000.0 << 1.0 << 0.0;
        // One centre line at y = 22.5 meets the hole from 21 to 24: 20 m of its strip of 5 m less the hole
        // of 3 m is covered by nobody.
        QTest::newRow("hole smaller than its strip")
            << "POLYGON((0 0, 100 0, 100 50, 0 50, 0 0), (40 21, 40 24, 60 24, 60 21, 40 21))" << 0.0 << 5.0
            << 0.0 << false << 11 << 980.0 << 1.0 - 40.0 / 4940.0 << 0.0;
    }
    static void addParts() {
        QTest::newRow("L shape") << "POLYGON((0 0, 100 0, 100 20, 40 20, 40 50, 0 50, 0 0))" << 0.0 << 10.0
                                 << 0.0 << false << 5 << 320.0 << 1.0 << 0.0;
        QTest::newRow("L shape across") << "POLYGON((0 0, 100 0, 100 20, 40 20, 40 50, 0 50, 0 0))" << 90.0
                                        << 10.0 << 0.0 << false << 10 << 320.0 << 1.0 << 0.0;
        QTest::newRow("two parts beside each other share their tracks")
            << "MULTIPOLYGON(((0 0, 40 0, 40 10, 0 10, 0 0)), ((60 0, 100 0, 100 10, 60 10, 60 0)))" << 0.0
            << 5.0 << 0.0 << false << 4 << 160.0 << 1.0 << 0.0;
        QTest::newRow("tracks between two parts have no swath")
            << "MULTIPOLYGON(((0 0, 100 0, 100 10, 0 10, 0 0)), ((0 30, 100 30, 100 40, 0 40, 0 30)))" << 0.0
            << 5.0 << 0.0 << false << 4 << 400.0 << 1.0 << 0.0;
    }
    static void addNarrow() {
        QTest::newRow("narrower than a swath") << "POLYGON((0 0, 100 0, 100 2, 0 2, 0 0))" << 0.0 << 2.5
                                               << 0.0 << false << 1 << 100.0 << 1.0 << 0.0;
        QTest::newRow("exactly one swath") << "POLYGON((0 0, 100 0, 100 2.5, 0 2.5, 0 0))" << 0.0 << 2.5
                                           << 0.0 << false << 1 << 100.0 << 1.0 << 0.0;
        // Three on 5.1 m: centre lines 1.25, 2.55, 3.85 when spread: every pair overlaps, nothing thrice.
        QTest::newRow("three swaths spread over two widths")
            << "POLYGON((0 0, 100 0, 100 5.1, 0 5.1, 0 0))" << 0.0 << 2.5 << 0.0 << true << 3 << 300.0 << 1.0
            << 240.0;
        // A step of 0.5 m: five swaths reach over each place in the middle, but land counts once.
        // Height 5 m: centre lines 1.25, 1.75 ... 3.75; all but the outer 0.5 m on both sides twice or more.
        QTest::newRow("places covered five times count once")
            << "POLYGON((0 0, 100 0, 100 5, 0 5, 0 0))" << 0.0 << 2.5 << 2.0 << false << 6 << 600.0 << 1.0
            << 400.0;
    }
    /// The figures of a generated field are those of its best layout, as GEOS has them.
    static void compareFigures(const HeadingFigures& ours, const OracleFigures& best, double mainlandM2,
                               const QByteArray& told) {
        VERIFY_TOLD(ours.count == best.count,
                    told + QByteArray::number(ours.count) + " " + QByteArray::number(best.count));
        VERIFY_TOLD(std::abs(ours.length.si() - best.lengthM) < 1e-6,
                    told + QByteArray::number(ours.length.si() - best.lengthM));
        VERIFY_TOLD(std::abs(ours.coverage - best.coverage) < 1e-9,
                    told + QByteArray::number(ours.coverage - best.coverage));
        VERIFY_TOLD(std::abs(ours.overlap.si() - best.overlapM2) < 1e-6 * std::max(1.0, mainlandM2 * 1e-3),
                    told + QByteArray::number(ours.overlap.si() - best.overlapM2));
    }
    /// Swaths: inside, in order, and the figures are theirs.
    static void checkSwaths(const SwathSet& set, const Oracle::Geometry& mainland, double heading,
                            const HeadingFigures& ours, const QByteArray& told) {
        VERIFY_TOLD(static_cast<int>(set.swaths.size()) == ours.count, told);
        const Oracle::Geometry grown{GEOSBuffer_r(Oracle::context(), mainland.get(), 1e-6, 4)};
        double lengthM = 0.0;
        for (std::size_t k = 0; k < set.swaths.size(); ++k) {
            const Swath& swath = set.swaths[k];
            lengthM += swath.length().si();
            VERIFY_TOLD(
                GEOSCovers_r(Oracle::context(), grown.get(), Oracle::line(swath.start, swath.end).get()) == 1,
                told);
            VERIFY_TOLD(swath.number == static_cast<int>(k) + 1, told);
            VERIFY_TOLD(k == 0 || swath.track >= set.swaths[k - 1].track, told);
            VERIFY_TOLD(dot(swath.end - swath.start, direction(heading)) > 0.0, told);
        }
        VERIFY_TOLD(std::abs(lengthM - ours.length.si()) < 1e-6, told);
    }

private slots:
    void byHand_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<double>("headingDeg");
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("overlapM");
        QTest::addColumn<bool>("spread");
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("lengthM");
        QTest::addColumn<double>("coverage");
        QTest::addColumn<double>("overlapM2");
        addRectangles();
        addSlantsAndHoles();
        addParts();
        addNarrow();
    }
    void byHand() {
        QFETCH(QString, wkt);
        QFETCH(double, headingDeg);
        QFETCH(double, widthM);
        QFETCH(double, overlapM);
        QFETCH(bool, spread);
        QFETCH(int, count);
        QFETCH(double, lengthM);
        QFETCH(double, coverage);
        QFETCH(double, overlapM2);
        // The same wherever the field lies and however it is turned.
        for (const double turnDeg : {0.0, 30.0, 137.0}) {
            for (const Point by : {Point{}, Point{1234.5, -987.6}}) {
                const MultiPolygon mainland =
                    test::moved(polygonsFromWkt(wkt.toStdString()), degrees(turnDeg), by);
                const ScanLine scanLine{
                    mainland, spacing(widthM, overlapM, spread ? LastPass::Spread : LastPass::Overlap)};
                const HeadingFigures figures =
                    scanLine.figures(degrees(headingDeg + turnDeg), SwathObjective::Coverage);
                QCOMPARE(figures.count, count);
                COMPARE_WITHIN(figures.length.si(), lengthM, 1e-6);
                COMPARE_WITHIN(figures.coverage, coverage, 1e-9);
                COMPARE_WITHIN(figures.overlap.si(), overlapM2, 1e-4);
                const SwathSet set = scanLine.swaths(degrees(headingDeg + turnDeg), SwathObjective::Coverage);
                QCOMPARE(static_cast<int>(set.swaths.size()), count);
                QCOMPARE(set.totalLength.si(), figures.length.si());
                QCOMPARE(set.coverage, figures.coverage);
                QCOMPARE(set.overlap.si(), figures.overlap.si());
            }
        }
    }

    void swathsLieWhereTheyShould() {
        const ScanLine scanLine{
            polygonsFromWkt("POLYGON((0 0, 100 0, 100 50, 0 50, 0 0), (40 20, 40 30, 60 30, 60 20, 40 20))"),
            spacing(5.0)};
        const SwathSet set = scanLine.swaths(degrees(0.0), SwathObjective::Coverage);
        QCOMPARE(set.swaths.size(), std::size_t{12});
        const auto check = [&](std::size_t i, Point start, Point end, int track) {
            const Swath& swath = set.swaths[i];
            return distance(swath.start, start) < 1e-9 && distance(swath.end, end) < 1e-9 &&
                   swath.track == track && swath.number == static_cast<int>(i) + 1 &&
                   swath.width == metres(5.0);
        };
        QVERIFY(check(0, {0, 2.5}, {100, 2.5}, 0));
        QVERIFY(check(3, {0, 17.5}, {100, 17.5}, 3));
        QVERIFY(check(4, {0, 22.5}, {40, 22.5}, 4));
        QVERIFY(check(5, {60, 22.5}, {100, 22.5}, 4));
        QVERIFY(check(6, {0, 27.5}, {40, 27.5}, 5));
        QVERIFY(check(11, {0, 47.5}, {100, 47.5}, 9));
        COMPARE_WITHIN(set.shift.si(), 0.0, 1e-12);
        // Seen to the north, the rightmost track lies in the east.
        const SwathSet north = scanLine.swaths(degrees(90.0), SwathObjective::Coverage);
        COMPARE_WITHIN(distance(north.swaths.front().start, {97.5, 0.0}), 0.0, 1e-9);
        COMPARE_WITHIN(distance(north.swaths.front().end, {97.5, 50.0}), 0.0, 1e-9);
    }

    void oneSwathLiesInTheMiddle() {
        const ScanLine scanLine{polygonsFromWkt("POLYGON((0 0, 100 0, 100 2, 0 2, 0 0))"), spacing(2.5)};
        const SwathSet set = scanLine.swaths(degrees(0.0), SwathObjective::Coverage);
        QCOMPARE(set.swaths.size(), std::size_t{1});
        COMPARE_WITHIN(set.swaths.front().start.y, 1.0, 1e-12);
        COMPARE_WITHIN(set.shift.si(), -0.25, 1e-12);
    }

    // A right triangle 51 m high over a rectangle: what the moved swath overlaps is less at the narrow end.
    void theMovedSwathLiesOnTheBetterSide_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<bool>("movedAtTheTop");
        // A leg of 10 m width rises from the middle of a wide base: moving the swath at its top costs 1 m x
        // 10 m.
        QTest::newRow("narrow at the top")
            << "POLYGON((0 0, 100 0, 100 25, 60 25, 60 51, 50 51, 50 25, 0 25, 0 0))" << true;
        QTest::newRow("narrow at the bottom")
            << "POLYGON((0 51, 0 26, 50 26, 50 0, 60 0, 60 26, 100 26, 100 51, 0 51))" << false;
    }
    void theMovedSwathLiesOnTheBetterSide() {
        QFETCH(QString, wkt);
        QFETCH(bool, movedAtTheTop);
        const ScanLine scanLine{polygonsFromWkt(wkt.toStdString()), spacing(5.0)};
        const SwathSet set = scanLine.swaths(degrees(0.0), SwathObjective::Coverage);
        QCOMPARE(set.swaths.size(), std::size_t{11});
        // 11 x 5 m on 51 m: 4 m of overlap, on 10 m where it is narrow.
        COMPARE_WITHIN(set.overlap.si(), 40.0, 1e-6);
        const double second = set.swaths[1].start.y - set.swaths[0].start.y;
        const double last = set.swaths[10].start.y - set.swaths[9].start.y;
        COMPARE_WITHIN(second, movedAtTheTop ? 5.0 : 1.0, 1e-9);
        COMPARE_WITHIN(last, movedAtTheTop ? 1.0 : 5.0, 1e-9);
    }

    // With many vertices, lines alone are found by a tree of edges; figures with areas rotate every vertex.
    void manyVertices_data() {
        QTest::addColumn<int>("vertices");
        QTest::addColumn<int>("holes");
        QTest::addColumn<double>("jagM");
        QTest::newRow("few, without a tree") << 100 << 1 << 0.0;
        QTest::newRow("a tree") << 1000 << 0 << 0.0;
        QTest::newRow("with holes") << 1000 << 7 << 0.0;
        QTest::newRow("every edge turns back") << 1000 << 2 << 2.0;
        QTest::newRow("steps of a raster") << 1000 << 2 << 0.05;
        QTest::newRow("ten thousand") << 10'000 << 3 << 0.0;
    }
    void manyVertices() {
        QFETCH(int, vertices);
        QFETCH(int, holes);
        QFETCH(double, jagM);
        const auto wavy = [jagM](Point centre, double radiusM, int count, double turn) {
            Ring ring;
            for (int i = 0; i < count; ++i) {
                const double angle = turn * 2.0 * std::numbers::pi * i / count;
                const double m =
                    radiusM * (1.0 + 0.1 * std::sin(9.0 * angle) + 0.01 * std::sin(101.0 * angle)) +
                    (i % 2 == 0 ? jagM : 0.0);
                ring.push_back(centre + m * direction(angle));
                if (i % 10 == 0) {
                    ring.push_back(ring.back());  // the same point again
                }
            }
            return ring;
        };
        Polygon field{.outer = wavy({300.0, -20.0}, 150.0, vertices, 1.0), .holes = {}};
        for (int i = 0; i < holes; ++i) {
            const Point centre = Point{300.0, -20.0} + 80.0 * direction(2.0 * std::numbers::pi * i / holes);
            field.holes.push_back(wavy(centre, 12.0, vertices / 10, -1.0));
        }
        for (const LastPass lastPass : {LastPass::Spread, LastPass::Overlap, LastPass::Gap}) {
            const ScanLine scanLine{
                {field}, {.width = metres(3.0), .overlap = metres(0.1), .lastPass = lastPass, .anchor = {}}};
            for (double deg = 0.0; deg < 180.0; deg += 7.3) {
                const HeadingFigures lines = scanLine.lineFigures(degrees(deg), SwathObjective::Count);
                const HeadingFigures all = scanLine.figures(degrees(deg), SwathObjective::Count);
                QCOMPARE(lines.count, all.count);
                if (lastPass == LastPass::Spread) {  // one layout: there is nothing to choose from
                    QCOMPARE(lines.length.si(), all.length.si());
                }
            }
        }
    }

    // 2,828 m from corner to corner.
    void tooManyTracks() {
        const ScanLine scanLine{{test::rectangle(2000.0, 2000.0)}, spacing(0.5)};
        COMPARE_WITHIN(scanLine.diameter().si(), 2828.427, 1e-3);
        QVERIFY(checkTrackCount(spacing(0.5), scanLine.diameter()).has_value());
        const auto narrow = checkTrackCount(spacing(0.1), scanLine.diameter());
        QVERIFY(!narrow.has_value());
        QVERIFY2(narrow.error().what.contains("gives 28284 swaths"), narrow.error().line().c_str());
        QVERIFY(!checkTrackCount(spacing(2.5, 2.4999), scanLine.diameter()).has_value());
    }

    void nothingInNothingOut() {
        const ScanLine scanLine{{}, spacing(2.5)};
        QCOMPARE(scanLine.figures(degrees(10.0), SwathObjective::Coverage).count, 0);
        QCOMPARE(scanLine.figures(degrees(10.0), SwathObjective::Coverage).coverage, 0.0);
        QVERIFY(scanLine.swaths(degrees(10.0), SwathObjective::Coverage).swaths.empty());
    }

    void agreesWithGeos_data() {
        QTest::addColumn<int>("shape");
        QTest::addColumn<bool>("spread");
        for (const test::Shape shape : test::kShapes) {
            for (const bool spread : {false, true}) {
                QTest::addRow("%s, last pass %s", std::string{test::shapeName(shape)}.c_str(),
                              spread ? "spread" : "overlaps")
                    << static_cast<int>(shape) << spread;
            }
        }
    }
    void agreesWithGeos() {
        QFETCH(int, shape);
        QFETCH(bool, spread);
        constexpr int kFields = 40;
        const std::uint64_t seed = 4711 + 10 * static_cast<std::uint64_t>(shape) + (spread ? 1 : 0);
        std::mt19937_64 random{seed};
        for (int i = 0; i < kFields; ++i) {
            const double radiusM = test::uniform(random, 20.0, 200.0);
            const MultiPolygon polygons =
                test::randomPolygons(random, static_cast<test::Shape>(shape), radiusM);
            const double widthM = test::uniform(random, 0.04, 0.6) * radiusM;
            const double overlapM = random() % 2 == 0 ? 0.0 : test::uniform(random, 0.0, 0.7) * widthM;
            const double heading = test::uniform(random, 0.0, kPi);
            const QByteArray told = QStringLiteral("seed %1, field %2, width %3, overlap %4, heading %5: ")
                                        .arg(seed)
                                        .arg(i)
                                        .arg(widthM, 0, 'g', 17)
                                        .arg(overlapM, 0, 'g', 17)
                                        .arg(heading, 0, 'g', 17)
                                        .toUtf8();
            const ScanLine scanLine{polygons,
                                    spacing(widthM, overlapM, spread ? LastPass::Spread : LastPass::Overlap)};
            const HeadingFigures ours = scanLine.figures(radians(heading), SwathObjective::Coverage);

            const auto mainland = mainlandOf(polygons);
            const double mainlandM2 = Oracle::area(mainland);
            const OracleFigures best = bestOf(layoutsOf(polygons, heading, widthM, overlapM, spread),
                                              mainland, mainlandM2, heading, widthM);
            compareFigures(ours, best, mainlandM2, told);
            if (QTest::currentTestFailed()) {
                return;
            }
            checkSwaths(scanLine.swaths(radians(heading), SwathObjective::Coverage), mainland, heading, ours,
                        told);
            if (QTest::currentTestFailed()) {
                return;
            }

            // A line has no front: the other way round is the same heading.
            const HeadingFigures turned = scanLine.figures(radians(heading + kPi), SwathObjective::Coverage);
            VERIFY_TOLD(turned.count == ours.count, told);
            VERIFY_TOLD(std::abs((turned.length - ours.length).si()) < 1e-6, told);
            VERIFY_TOLD(std::abs(turned.coverage - ours.coverage) < 1e-9, told);
        }
    }
};

FURROW_TEST(ScanLineTest);
#include "tst_scan_line.moc"
