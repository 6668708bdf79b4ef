// How many swaths land can need at all: bounds from its height across the heading (its altitude, by which
// Huang 2001, doi 10.1109/ROBOT.2001.932525, counts turns), its longest chord, its area and its boundary.
// None of these is worked out by the planner.

#include "planner/machine/machine_library.h"
#include "planner/swaths/methods.h"
#include "planner/swaths/scan_line.h"
#include "tests/support/field_generator.h"
#include "tests/support/real_fields.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace furrow;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSeed = 20010521;
// A height that is a whole number of widths but for rounding fits either way.
constexpr double kSlack = 1e-9;

/// Land in one piece, and how to find it again.
struct Land {
    QByteArray name;
    Polygon polygon;
};

double heightM(const Polygon& polygon, double headingRad) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Point& point : polygon.outer) {
        const double y = std::cos(headingRad) * point.y - std::sin(headingRad) * point.x;
        low = std::min(low, y);
        high = std::max(high, y);
    }
    return high - low;
}

double longestChordM(const Polygon& polygon) {
    double longest = 0.0;
    for (const Point& a : polygon.outer) {
        for (const Point& b : polygon.outer) {
            longest = std::max(longest, std::hypot(a.x - b.x, a.y - b.y));
        }
    }
    return longest;
}

double perimeterM(const Polygon& polygon) {
    double sum = 0.0;
    forEachEdge({polygon}, [&sum](Point from, Point to) { sum += std::hypot(to.x - from.x, to.y - from.y); });
    return sum;
}

bool isConvexLand(const Polygon& polygon) {
    const Ring& ring = polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point in = ring[(i + 1) % ring.size()] - ring[i];
        const Point out = ring[(i + 2) % ring.size()] - ring[(i + 1) % ring.size()];
        if (in.x * out.y - in.y * out.x < 0.0) {
            return false;
        }
    }
    return polygon.holes.empty();
}

/// Every kind of generated land in one piece, then the real fields, parts one by one.
std::vector<Land> allLand() {
    std::vector<Land> land;
    for (const test::Shape shape :
         {test::Shape::Convex, test::Shape::Concave, test::Shape::Holes, test::Shape::Thin}) {
        std::mt19937_64 random{kSeed + static_cast<std::uint64_t>(shape)};
        for (int i = 0; i < 40; ++i) {
            land.push_back({QStringLiteral("%1, seed %2, field %3")
                                .arg(QLatin1String(test::shapeName(shape)))
                                .arg(kSeed + static_cast<std::uint64_t>(shape))
                                .arg(i)
                                .toUtf8(),
                            test::randomPolygons(random, shape, test::uniform(random, 20.0, 300.0)).front()});
        }
    }
    for (const FieldSource& source : test::shippedFields()) {
        const Field field = Field::create(source).value();
        for (const Polygon& part : field.boundary()) {
            land.push_back({QByteArray::fromStdString(source.name), part});
        }
    }
    return land;
}

std::vector<Land> convexLand() {
    std::vector<Land> land = allLand();
    std::erase_if(land, [](const Land& each) { return !isConvexLand(each.polygon); });
    return land;
}

int fewestSwaths(const Polygon& polygon, double widthM) {
    MachineSpec spec = machineLibrary().front().spec();
    spec.implement.operatingWidth = metres(widthM);
    Settings settings;
    settings.setText(kObjective, "swath-count").value();
    const auto set = test::swathsBy(kExactMethod, {polygon}, Machine::create(spec).value(), settings);
    return static_cast<int>(set.value().swaths.size());
}

}  // namespace

class SwathBoundsTest : public QObject {
    Q_OBJECT

private slots:
    void thereIsLandOfEveryKind() {
        const std::size_t convex = convexLand().size();
        QVERIFY(convex >= 40U + 38U);
        QVERIFY(allLand().size() >= convex + 3U * 40U);
    }

    // Strips w wide whose centres are w - o apart cover a height h once (n - 1)(w - o) + w >= h. Every one of
    // them crosses land in one piece, and a line meets land with k edges in at most k / 2 stretches, convex
    // land in one.
    void byTheHeight_data() {
        QTest::addColumn<int>("lastPass");
        QTest::addColumn<double>("overlapM");
        QTest::newRow("last pass overlaps") << static_cast<int>(LastPass::Overlap) << 0.0;
        QTest::newRow("last pass overlaps, neighbours too") << static_cast<int>(LastPass::Overlap) << 0.4;
        QTest::newRow("spread over all") << static_cast<int>(LastPass::Spread) << 0.0;
        QTest::newRow("rest left out") << static_cast<int>(LastPass::Gap) << 0.0;
    }
    void byTheHeight() {
        QFETCH(int, lastPass);
        QFETCH(double, overlapM);
        std::mt19937_64 random{kSeed};
        for (const Land& land : allLand()) {
            const double widthM = test::uniform(random, 1.0, 12.0);
            const ScanLine scanLine{{land.polygon},
                                    {.width = metres(widthM),
                                     .overlap = metres(overlapM),
                                     .lastPass = static_cast<LastPass>(lastPass)}};
            const bool convex = isConvexLand(land.polygon);
            const auto mostStretches = static_cast<int>(vertexCount({land.polygon}) / 2);
            for (int i = 0; i < 24; ++i) {
                const double headingRad = test::uniform(random, 0.0, kPi);
                const double steps = (heightM(land.polygon, headingRad) - widthM) / (widthM - overlapM);
                const auto tracks = [&](double slack) {
                    // Left out is less than half a width.
                    const double more = static_cast<LastPass>(lastPass) == LastPass::Gap
                                            ? std::floor(steps + 0.5 + slack)
                                            : std::ceil(steps + slack);
                    return 1 + std::max(0, static_cast<int>(more));
                };
                const int count = scanLine.figures(radians(headingRad)).count;
                const QByteArray told = land.name + QStringLiteral(", %1 m, heading %2: %3 swaths, %4 steps")
                                                        .arg(widthM)
                                                        .arg(headingRad, 0, 'g', 17)
                                                        .arg(count)
                                                        .arg(steps)
                                                        .toUtf8();
                VERIFY_TOLD(count >= tracks(-kSlack), told);
                VERIFY_TOLD(count <= tracks(kSlack) * (convex ? 1 : mostStretches), told);
            }
        }
    }

    // No section of land is longer than its longest chord D: its height is at least A / D, and at most D.
    void byTheLongestChord() {
        std::mt19937_64 random{kSeed + 1};
        for (const Land& land : allLand()) {
            const double widthM = test::uniform(random, 1.0, 12.0);
            const ScanLine scanLine{{land.polygon}, {.width = metres(widthM), .overlap = {}}};
            const double chordM = longestChordM(land.polygon);
            const double areaM2 = area(land.polygon).si();
            for (int i = 0; i < 24; ++i) {
                const HeadingFigures figures = scanLine.figures(radians(test::uniform(random, 0.0, kPi)));
                const QByteArray told =
                    land.name + QStringLiteral(", %1 m: %2 swaths").arg(widthM).arg(figures.count).toUtf8();
                VERIFY_TOLD(figures.count * widthM * chordM >= areaM2, told);
                VERIFY_TOLD(figures.length.si() <= figures.count * chordM * (1.0 + kSlack), told);
                if (isConvexLand(land.polygon)) {
                    VERIFY_TOLD(figures.count <= std::ceil(chordM / widthM - kSlack), told);
                }
            }
        }
    }

    // Convex land of area A is nowhere narrower than it can be: its width is at most sqrt(sqrt(3) A) (Pál
    // 1921; the equilateral triangle has just that), so that the fewest swaths grow with sqrt(A) / w, as the
    // paper found of the time. From two widths on that is below A / w², what the paper's own tests ask for.
    void fewestByTheArea() {
        std::mt19937_64 random{kSeed + 2};
        for (const Land& land : convexLand()) {
            const double widthM = test::uniform(random, 1.0, 12.0);
            const double side = std::sqrt(area(land.polygon).si()) / widthM;
            const int fewest = fewestSwaths(land.polygon, widthM);
            const QByteArray told =
                land.name + QStringLiteral(", %1 m: %2 swaths").arg(widthM).arg(fewest).toUtf8();
            VERIFY_TOLD(fewest <= std::ceil(std::pow(3.0, 0.25) * side - kSlack), told);
            VERIFY_TOLD(side < 2.0 || fewest <= side * side, told);
            VERIFY_TOLD(fewest * widthM * longestChordM(land.polygon) >= area(land.polygon).si(), told);
        }
    }

    void anEquilateralTriangleNeedsTheMost() {
        // 100 m high on each side; 40.5 swaths of it.
        const Polygon triangle{
            .outer = {{0.0, 0.0}, {200.0 / std::sqrt(3.0), 0.0}, {100.0 / std::sqrt(3.0), 100.0}},
            .holes = {}};
        const double widthM = 100.0 / 40.5;
        QCOMPARE(fewestSwaths(triangle, widthM), 41);
        COMPARE_WITHIN(std::pow(3.0, 0.25) * std::sqrt(area(triangle).si()) / widthM, 40.5, 1e-9);
    }

    // Cauchy's formula: over all headings the mean height of convex land is its perimeter / pi. A whole
    // number of swaths is less than one more than the height holds.
    void theMeanOverAllHeadingsByThePerimeter() {
        std::mt19937_64 random{kSeed + 3};
        constexpr int kHeadings = 720;
        for (const Land& land : convexLand()) {
            const double widthM = test::uniform(random, 1.0, 12.0);
            const ScanLine scanLine{{land.polygon}, {.width = metres(widthM), .overlap = {}}};
            int sum = 0;
            for (int i = 0; i < kHeadings; ++i) {
                sum += scanLine.lineFigures(radians(kPi * i / kHeadings), SwathObjective::Count).count;
            }
            const double mean = static_cast<double>(sum) / kHeadings;
            const double cauchy = perimeterM(land.polygon) / (kPi * widthM);
            const QByteArray told =
                land.name + QStringLiteral(", %1 m: %2, %3").arg(widthM).arg(mean).arg(cauchy).toUtf8();
            // The trapezium rule of a curve with bends is off by a hundred-thousandth at a quarter of a
            // degree.
            VERIFY_TOLD(mean >= cauchy * (1.0 - 1e-4), told);
            VERIFY_TOLD(mean <= cauchy * (1.0 + 1e-4) + 1.0, told);
        }
    }
};

FURROW_TEST(SwathBoundsTest);
#include "tst_swath_bounds.moc"
