// The exact search is never worse than brute force at 0.1 degree, and what it calls proved is.

#include "planner/geometry/convex_hull.h"
#include "planner/headland/methods.h"
#include "planner/machine/machine_library.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"
#include "tests/support/field_generator.h"
#include "tests/support/real_fields.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>

using namespace furrow;

namespace {

constexpr std::uint64_t kSeed = 4711;

Settings byObjective(const char* id) {
    Settings settings;
    [[maybe_unused]] const auto applied = settings.setText(kObjective, id);
    // The search alone: an edge may cost a little.
    [[maybe_unused]] const auto alone = settings.setText(kPreferEdge, "0");
    return settings;
}

/// Every heading at 0.1 degree, one after the other.
HeadingFigures bruteForceAtATenth(const ScanLine& scanLine, SwathObjective objective) {
    HeadingFigures best;
    for (int i = 0; i < 1800; ++i) {
        const HeadingFigures figures = scanLine.figures(degrees(0.1 * i), objective);
        if (i == 0 || isBetter(objective, figures, best)) {
            best = figures;
        }
    }
    return best;
}

/// What a real field leaves to be worked in swaths.
struct RealMainland {
    QByteArray name;
    MultiPolygon polygons;
};

/// Of the fields that come with Furrow, and of every fortieth of the others where they are there; behind
/// headlands of the standard width. Fields that are refused, or too narrow for a headland, are left out.
const std::vector<RealMainland>& realMainlands() {
    static const std::vector<RealMainland> all = [] {
        std::vector<FieldSource> sources = test::shippedFields();
        std::ranges::move(test::collectedFields(40), std::back_inserter(sources));
        std::vector<RealMainland> mainlands;
        for (const FieldSource& source : sources) {
            const auto field = Field::create(source);
            if (!field) {
                continue;
            }
            auto headland = test::headlandBy(kConstantWidthMethod, *field, machineLibrary().front(), {});
            if (headland && headland->notes.empty()) {
                mainlands.push_back({QByteArray::fromStdString(source.id), std::move(headland->mainland)});
            }
        }
        return mainlands;
    }();
    return all;
}

void addObjectives() {
    QTest::addColumn<QString>("objective");
    for (const char* id : {"time", "swath-count", "swath-length", "coverage", "overlap"}) {
        QTest::newRow(id) << QString{id};
    }
}

/// The exact search of this mainland against every tenth of a degree.
void compareWithATenth(const MultiPolygon& mainland, const QString& objective, const QByteArray& told) {
    const Machine& machine = machineLibrary().front();
    const Settings settings = byObjective(qPrintable(objective));
    const SwathObjective by = objectiveOf(settings);
    const auto exact = test::swathsBy(kExactMethod, mainland, machine, settings, {});
    VERIFY_TOLD(exact.has_value(), told);
    const auto scanLine = scanLineFor({test::anyField(), mainland, machine, settings});
    VERIFY_TOLD(scanLine.has_value(), told);
    const HeadingFigures brute = bruteForceAtATenth(*scanLine, by);
    const HeadingFigures ours = scanLine->figures(exact->heading, by);
    VERIFY_TOLD(!isBetter(by, brute, ours) || (by == SwathObjective::Count && brute.count == ours.count),
                told);
    VERIFY_TOLD(static_cast<int>(exact->swaths.size()) == ours.count, told);
}

}  // namespace

class TestExactSearch : public QObject {
    Q_OBJECT

public:
    TestExactSearch() { test::allowTimeForEveryField(); }

private slots:
    void neverWorseThanATenthOfADegree_data() { addObjectives(); }
    void neverWorseThanATenthOfADegree() {
        QFETCH(QString, objective);
        std::mt19937_64 random{kSeed};
        for (std::size_t i = 0; i < 25; ++i) {
            compareWithATenth(test::randomPolygons(random, test::kShapes[i % 5], 60.0), objective,
                              QStringLiteral("seed %1, field %2").arg(kSeed).arg(i).toUtf8());
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }

    void neverWorseOnRealFields_data() { addObjectives(); }
    void neverWorseOnRealFields() {
        QFETCH(QString, objective);
        QVERIFY(realMainlands().size() >= 40);
        for (const RealMainland& mainland : realMainlands()) {
            compareWithATenth(mainland.polygons, objective, mainland.name);
            if (QTest::currentTestFailed()) {
                return;
            }
        }
    }

    // A bound is never above what a heading takes; where less would do it is only told to be more than that.
    void noHeadingIsQuickerThanItsBound() {
        constexpr Duration kAll = seconds(std::numeric_limits<double>::infinity());
        std::mt19937_64 random{kSeed};
        for (std::size_t i = 0; i < 25; ++i) {
            const MultiPolygon mainland = test::randomPolygons(random, test::kShapes[i % 5], 60.0);
            const auto scanLine =
                scanLineFor({test::anyField(), mainland, machineLibrary().front(), byObjective("time")});
            VERIFY_RESULT(scanLine);
            for (int k = 0; k < 20; ++k) {
                const Angle heading = degrees(9.0 * k + 0.37);
                const Duration time = scanLine->figures(heading, SwathObjective::Time).time;
                const Duration bound = scanLine->timeBound(heading, kAll);
                QVERIFY(bound > seconds(0.0));
                QCOMPARE_LE(bound.si(), time.si() + 1e-9);
                for (const Duration enough : {seconds(0.0), 0.5 * bound, 0.98 * bound, 1.02 * bound}) {
                    const Duration cheap = scanLine->timeBound(heading, enough);
                    QCOMPARE_LE(cheap, bound);
                    QVERIFY(bound <= enough ? cheap == bound : cheap > enough);
                }
            }
        }
    }

    // A convex field needs as many swaths as its least width holds (rotating calipers), and no fewer.
    void convexCountIsProved() {
        const Machine& machine = machineLibrary().front();
        std::mt19937_64 random{kSeed + 1};
        for (int i = 0; i < 50; ++i) {
            const MultiPolygon mainland = test::randomPolygons(random, test::Shape::Convex, 80.0);
            const auto exact =
                test::swathsBy(kExactMethod, mainland, machine, byObjective("swath-count"), {});
            QVERIFY(exact.has_value());
            QVERIFY(exact->proved);
            // Worked out apart from the search: the least height over ten thousand directions.
            double narrowest = 1e9;
            for (int k = 0; k < 10'000; ++k) {
                const double angle = std::numbers::pi * k / 10'000.0;
                double low = 1e9;
                double high = -1e9;
                for (const Point& point : mainland[0].outer) {
                    const double y = std::cos(angle) * point.y - std::sin(angle) * point.x;
                    low = std::min(low, y);
                    high = std::max(high, y);
                }
                narrowest = std::min(narrowest, high - low);
            }
            const int atLeast = static_cast<int>(std::ceil(narrowest / 2.5 - 1e-3));
            const auto count = static_cast<int>(exact->swaths.size());
            QVERIFY(count <= atLeast);
            QVERIFY(count >= atLeast - 1);
        }
    }

    void otherObjectivesAreNotCalledProved() {
        const MultiPolygon field{test::rectangle(100.0, 60.0)};
        const auto byLength =
            test::swathsBy(kExactMethod, field, machineLibrary().front(), byObjective("swath-length"), {});
        QVERIFY(byLength.has_value());
        QVERIFY(!byLength->proved);
    }

    void rectangleIsWorkedAlongItsLongSide() {
        const MultiPolygon field{test::rectangle(100.0, 60.0)};
        const auto exact =
            test::swathsBy(kExactMethod, field, machineLibrary().front(), byObjective("swath-count"), {});
        QVERIFY(exact.has_value());
        // 60 m / 2.5 m
        QCOMPARE(exact->swaths.size(), std::size_t{24});
        QCOMPARE(inDegrees(exact->heading), 0.0);
        QVERIFY(exact->proved);
    }

    void hullAndItsWidth_data() {
        QTest::addColumn<QList<QPointF>>("points");
        QTest::addColumn<int>("corners");
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("diameterM");
        QTest::newRow("square with points inside and on edges")
            << QList<QPointF>{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 1}, {2, 3}} << 4 << 4.0
            << std::sqrt(32.0);
        // Height on the hypotenuse of 3-4-5: 12/5.
        QTest::newRow("right triangle") << QList<QPointF>{{0, 0}, {4, 0}, {0, 3}} << 3 << 2.4 << 5.0;
        QTest::newRow("rectangle aslant")
            << QList<QPointF>{{0, 0}, {6, 8}, {2, 11}, {-4, 3}} << 4 << 5.0 << std::sqrt(125.0);
    }
    void hullAndItsWidth() {
        QFETCH(QList<QPointF>, points);
        QFETCH(int, corners);
        QFETCH(double, width);
        QFETCH(double, diameterM);
        Ring ring;
        for (const QPointF& point : points) {
            ring.push_back({point.x(), point.y()});
        }
        const Ring hull = convexHull(ring);
        QCOMPARE(static_cast<int>(hull.size()), corners);
        QVERIFY(isConvex(hull));
        QCOMPARE(minimumWidth(hull).si(), width);
        QCOMPARE(diameter(hull).si(), diameterM);
    }

    void stopsWhenAsked() {
        std::stop_source stop;
        stop.request_stop();
        const auto set = test::swathsBy(kExactMethod, {test::rectangle(100.0, 60.0)},
                                        machineLibrary().front(), {}, {.stop = stop.get_token()});
        QVERIFY(!set.has_value());
        QCOMPARE(set.error().code, ErrorCode::Cancelled);
    }
};

FURROW_TEST(TestExactSearch);
#include "tst_exact_search.moc"
