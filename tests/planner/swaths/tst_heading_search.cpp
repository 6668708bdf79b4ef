#include "planner/machine/machine_library.h"
#include "planner/swaths/heading_search.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <array>
#include <cmath>
#include <stop_token>

using namespace furrow;

namespace {

Machine machineOf(double operatingWidthM) {
    MachineSpec spec = findMachine("agbot")->spec();
    spec.implement.operatingWidth = metres(operatingWidthM);
    return Machine::create(spec).value();
}

Settings settingsOf(std::initializer_list<std::pair<const Parameter*, std::string_view>> given) {
    Settings settings;
    for (const auto& [parameter, text] : given) {
        settings.setText(*parameter, text).value();
    }
    return settings;
}

double between(Angle a, Angle b) {
    return std::abs(std::remainder(inDegrees(a) - inDegrees(b), 180.0));
}

}  // namespace

class HeadingSearchTest : public QObject {
    Q_OBJECT

private slots:
    void bruteForceFinds_data() {
        QTest::addColumn<QString>("wkt");
        QTest::addColumn<double>("turnedDeg");
        QTest::addColumn<QString>("objective");
        QTest::addColumn<QString>("stepDeg");
        QTest::addColumn<double>("headingDeg");
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("tried");
        // 100 m x 50 m at 2.5 m: 20 along, 40 across, more at every angle between.
        const QString rectangle = QStringLiteral("POLYGON((0 0, 100 0, 100 50, 0 50, 0 0))");
        QTest::newRow("fewest lie along the long side")
            << rectangle << 0.0 << "swath-count" << "1" << 0.0 << 20 << 180;
        QTest::newRow("long side to the north")
            << rectangle << 90.0 << "swath-count" << "1" << 90.0 << 20 << 180;
        QTest::newRow("turned by 30 degrees")
            << rectangle << 30.0 << "swath-count" << "1" << 30.0 << 20 << 180;
        QTest::newRow("turned by 179 degrees")
            << rectangle << 179.0 << "swath-count" << "1" << 179.0 << 20 << 180;
        QTest::newRow("turned by half a step more")
            << rectangle << 30.5 << "swath-count" << "0.5" << 30.5 << 20 << 360;
        QTest::newRow("steps that do not divide half a circle")
            << rectangle << 14.0 << "swath-count" << "7" << 14.0 << 20 << 26;
        // 100 m x 51 m: along, 21 swaths of 100 m; across, 40 of 51 m, which also cover all of it with less
        // way.
        QTest::newRow("best coverage with the least way lies across")
            << "POLYGON((0 0, 100 0, 100 51, 0 51, 0 0))" << 37.0 << "coverage" << "1" << 127.0 << 40 << 180;
        // The paper: best coverage lies along or across an edge. A right triangle, 50 m high at 10 m: along
        // its legs it misses 5 x 10 x 5 m / 2 on the long one; every other heading misses at more edges.
        QTest::newRow("best coverage of a parallelogram lies along its long edges")
            << "POLYGON((0 0, 200 0, 220 25, 20 25, 0 0))" << 12.0 << "coverage" << "1" << 12.0 << 10 << 180;
    }
    void bruteForceFinds() {
        QFETCH(QString, wkt);
        QFETCH(double, turnedDeg);
        QFETCH(QString, objective);
        QFETCH(QString, stepDeg);
        QFETCH(double, headingDeg);
        QFETCH(int, count);
        QFETCH(int, tried);
        const MultiPolygon mainland =
            test::moved(test::polygonsFromWkt(wkt.toStdString()), degrees(turnedDeg), {300.0, -200.0});
        const Settings settings =
            settingsOf({{&kObjective, objective.toStdString()}, {&kStep, stepDeg.toStdString()}});
        const auto set = test::swathsBy(kBruteForceMethod, mainland, machineOf(2.5), settings, {});
        VERIFY_RESULT(set);
        COMPARE_WITHIN(between(set->heading, degrees(headingDeg)), 0.0, 1e-9);
        QCOMPARE(static_cast<int>(set->swaths.size()), count);
        QCOMPARE(set->headingsTried, tried);
        QVERIFY(set->heading >= degrees(0.0) && set->heading < degrees(180.0));
        QVERIFY(!set->proved);
    }

    // No heading of the grid beats the one that was found, over fields of every kind.
    void nothingOnTheGridIsBetter() {
        constexpr std::uint64_t kSeed = 99;
        std::mt19937_64 random{kSeed};
        for (int i = 0; i < 60; ++i) {
            const MultiPolygon mainland =
                test::randomPolygons(random, test::kShapes[static_cast<std::size_t>(i) % 5], 80.0);
            for (const auto& [id, objective] : {std::pair{"swath-count", SwathObjective::Count},
                                                {"swath-length", SwathObjective::Length},
                                                {"coverage", SwathObjective::Coverage},
                                                {"overlap", SwathObjective::Overlap}}) {
                const Settings settings = settingsOf({{&kObjective, id}, {&kStep, "5"}, {&kPreferEdge, "0"}});
                const auto found = test::swathsBy(kBruteForceMethod, mainland, machineOf(6.0), settings, {});
                VERIFY_RESULT(found);
                const ScanLine scanLine{mainland, {.width = metres(6.0), .overlap = {}}};
                for (int k = 0; k < 36; ++k) {
                    const HeadingFigures other = scanLine.figures(degrees(5.0 * k), objective);
                    const QByteArray told = QStringLiteral("seed %1, field %2, %3")
                                                .arg(kSeed)
                                                .arg(i)
                                                .arg(QLatin1String(id))
                                                .toUtf8();
                    switch (objective) {
                        case SwathObjective::Count:
                            VERIFY_TOLD(other.count >= static_cast<int>(found->swaths.size()), told);
                            break;
                        case SwathObjective::Length:
                            // At equal coverage: what is missed comes on top.
                            VERIFY_TOLD((other.length + other.missed).si() >=
                                            found->totalLength.si() +
                                                (1.0 - found->coverage) * area(mainland).si() / 6.0 - 1e-4,
                                        told);
                            break;
                        case SwathObjective::Coverage:
                            VERIFY_TOLD(other.coverage <= found->coverage + 1e-9, told);
                            break;
                        case SwathObjective::Overlap:
                            VERIFY_TOLD(other.overlap.si() >= found->overlap.si() - 1e-4, told);
                            break;
                        case SwathObjective::Time: break;  // not among the figures of a set
                    }
                }
            }
        }
    }

    void equallyGoodKeepsTheFirst_data() {
        QTest::addColumn<int>("threads");
        QTest::newRow("1 thread") << 1;
        QTest::newRow("2 threads") << 2;
        QTest::newRow("8 threads") << 8;
    }
    void equallyGoodKeepsTheFirst() {
        QFETCH(int, threads);
        const JobContext job{.stop = {}, .progress = {}, .threads = threads};
        const ScanLine square{{test::centredRectangle(50.0, 50.0)}, {.width = metres(2.5), .overlap = {}}};
        for (const SwathObjective objective :
             {SwathObjective::Count, SwathObjective::Length, SwathObjective::Coverage}) {
            const std::array eastFirst{degrees(45.0), degrees(0.0), degrees(90.0), degrees(180.0)};
            const auto east = bestHeading(square, eastFirst, objective, job);
            VERIFY_RESULT(east);
            const std::array northFirst{degrees(90.0), degrees(0.0), degrees(45.0)};
            const auto north = bestHeading(square, northFirst, objective, job);
            VERIFY_RESULT(north);
            if (objective != SwathObjective::Length) {
                QCOMPARE(inDegrees(east->heading), 0.0);
                QCOMPARE(inDegrees(north->heading), 90.0);
            }
        }
    }

    void comparesFigures_data() {
        QTest::addColumn<int>("objective");
        QTest::addColumn<HeadingFigures>("better");
        QTest::addColumn<HeadingFigures>("worse");
        const auto figures = [](int count, double length, double coverage) {
            return HeadingFigures{
                .count = count, .length = metres(length), .coverage = coverage, .overlap = {}};
        };
        const int count = static_cast<int>(SwathObjective::Count);
        const int length = static_cast<int>(SwathObjective::Length);
        const int coverage = static_cast<int>(SwathObjective::Coverage);
        QTest::newRow("fewer") << count << figures(3, 500, 0.8) << figures(4, 100, 1.0);
        QTest::newRow("as many, more covered") << count << figures(3, 500, 0.9) << figures(3, 100, 0.8);
        QTest::newRow("as many, as much covered, shorter")
            << count << figures(3, 100, 0.9) << figures(3, 101, 0.9);
        QTest::newRow("shorter") << length << figures(9, 100, 0.8) << figures(3, 101, 1.0);
        QTest::newRow("as short, more covered") << length << figures(9, 100, 0.9) << figures(3, 100, 0.8);
        QTest::newRow("more covered") << coverage << figures(9, 900, 0.9) << figures(3, 100, 0.8);
        QTest::newRow("as much covered, shorter") << coverage << figures(9, 100, 0.9) << figures(3, 101, 0.9);
        QTest::newRow("none at all is never better") << length << figures(9, 900, 0.1) << figures(0, 0, 0.0);
        QTest::newRow("none at all is not fewer") << count << figures(9, 900, 0.1) << figures(0, 0, 0.0);
    }
    void comparesFigures() {
        QFETCH(int, objective);
        QFETCH(HeadingFigures, better);
        QFETCH(HeadingFigures, worse);
        const auto by = static_cast<SwathObjective>(objective);
        QVERIFY(isBetter(by, better, worse));
        QVERIFY(!isBetter(by, worse, better));
        QVERIFY(!isBetter(by, better, better));
    }

    // 31.2 m hold twelve widths and 1.2 m: along, 1200 m leave 1.2 m to miss; across, 40 swaths of 31.2 m
    // cover all of it with 1248 m. Less is no better where it leaves something out.
    void lengthsAreComparedAtEqualCoverage() {
        const Settings settings = settingsOf(
            {{&kObjective, "swath-length"}, {&kStep, "90"}, {&kLastPass, "gap"}, {&kPreferEdge, "0"}});
        const auto set =
            test::swathsBy(kBruteForceMethod, {test::rectangle(100.0, 31.2)}, machineOf(2.5), settings, {});
        VERIFY_RESULT(set);
        COMPARE_WITHIN(inDegrees(set->heading), 90.0, 1e-9);
        COMPARE_WITHIN(set->coverage, 1.0, 1e-9);
    }

    // The last swath of `gap`: from half a width on it is laid, over the edge where there is room beyond it,
    // and otherwise beside its neighbour; less is left.
    void theRestOfAGap_data() {
        QTest::addColumn<double>("heightM");
        QTest::addColumn<bool>("hasRoom");
        QTest::addColumn<int>("count");
        QTest::addColumn<double>("uncoveredM");
        QTest::newRow("under half a width") << 31.2 << true << 12 << 1.2;
        QTest::newRow("half a width") << 31.25 << true << 13 << 0.0;
        QTest::newRow("more") << 32.0 << true << 13 << 0.0;
        QTest::newRow("nothing") << 30.0 << true << 12 << 0.0;
        QTest::newRow("under half a width, no room") << 31.2 << false << 12 << 1.2;
        QTest::newRow("half a width, no room") << 31.25 << false << 13 << 0.0;
    }
    void theRestOfAGap() {
        QFETCH(double, heightM);
        QFETCH(bool, hasRoom);
        QFETCH(int, count);
        QFETCH(double, uncoveredM);
        const ScanLine scanLine{{test::rectangle(100.0, heightM)},
                                {.width = metres(2.5),
                                 .overlap = {},
                                 .lastPass = LastPass::Gap,
                                 .anchor = {},
                                 .overEdge = hasRoom}};
        const SwathSet set = scanLine.swaths(degrees(0.0));
        QCOMPARE(static_cast<int>(set.swaths.size()), count);
        COMPARE_WITHIN(set.coverage, 1.0 - uncoveredM / heightM, 1e-9);
        COMPARE_WITHIN((set.restLeft + set.restRight).si(), uncoveredM, 1e-9);
        for (const Swath& swath : set.swaths) {
            const bool isInside = swath.start.y > 1.25 - 1e-9 && swath.start.y < heightM - 1.25 + 1e-9;
            QVERIFY(isInside || hasRoom);
        }
    }

    // An AB line 1 m above the lower edge's first lane: below it there is 1 m, which is left, above 2 m,
    // which is not.
    void theRestsBesideALine() {
        const ScanLine scanLine{{test::rectangle(100.0, 25.0 + 3.0)},
                                {.width = metres(2.5),
                                 .overlap = {},
                                 .lastPass = LastPass::Gap,
                                 .anchor = Point{0.0, 1.0 + 1.25}}};
        const SwathSet set = scanLine.swaths(degrees(0.0));
        QCOMPARE(set.swaths.size(), std::size_t{11});
        COMPARE_WITHIN(set.swaths.front().start.y, 2.25, 1e-9);
        COMPARE_WITHIN(set.swaths.back().start.y, 27.25, 1e-9);
        COMPARE_WITHIN(set.restRight.si(), 1.0, 1e-9);
        COMPARE_WITHIN(set.restLeft.si(), 0.0, 1e-9);
    }

    void otherHeadings_data() {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("angleDeg");
        QTest::addColumn<double>("headingDeg");
        QTest::newRow("as given") << "fixed" << "20" << 20.0;
        QTest::newRow("given the other way round") << "fixed" << "200" << 20.0;
        QTest::newRow("given clockwise") << "fixed" << "-30" << 150.0;
        QTest::newRow("half a circle") << "fixed" << "180" << 0.0;
        // The edges are 60, 50 and sqrt(30² + 40²) = 50 from the corner at 40: the first one is the longest.
        QTest::newRow("along the longest edge") << "longest-edge" << "0" << 25.0;
    }
    void otherHeadings() {
        QFETCH(QString, method);
        QFETCH(QString, angleDeg);
        QFETCH(double, headingDeg);
        const MultiPolygon mainland = test::moved(test::polygonsFromWkt("POLYGON((0 0, 60 0, 30 40, 0 0))"),
                                                  degrees(25.0), {10.0, 20.0});
        const auto& chosen = method == "fixed" ? kFixedHeadingMethod : kLongestEdgeMethod;
        const auto set = test::swathsBy(chosen, mainland, machineOf(2.5),
                                        settingsOf({{&kAngle, angleDeg.toStdString()}}), {});
        VERIFY_RESULT(set);
        COMPARE_WITHIN(inDegrees(set->heading), headingDeg, 1e-9);
    }

    void spacingFollowsTheSettings() {
        const MultiPolygon mainland{test::rectangle(100.0, 51.0)};
        const Settings settings = settingsOf({{&kLastPass, "spread"}, {&kOverlap, "0.5"}});
        const auto set = test::swathsBy(kFixedHeadingMethod, mainland, machineOf(2.5), settings, {});
        VERIFY_RESULT(set);
        // (51 - 2.5) / 2 = 24.25: 25 gaps of 1.94 m.
        QCOMPARE(set->swaths.size(), std::size_t{26});
        COMPARE_WITHIN(set->swaths[1].start.y - set->swaths[0].start.y, 48.5 / 25.0, 1e-9);
        COMPARE_WITHIN(set->swaths[25].start.y - set->swaths[24].start.y, 48.5 / 25.0, 1e-9);
    }

    // Lanes of 2.5 m. A curve with a radius of 1 m is half a circle and 0.5 m, 1.214 s at 3 m/s. With 8 m it
    // is 8 (3 pi - 4 asin(18.5 / 32)) = 55.67 m, 18.556 s. On the spot each quarter drives the outer
    // wheel 1.571 m from stand to stand, 2.507 s at 1 m/s²; the way between takes 2 sqrt(2.5) = 3.162 s;
    // braking from 2 m/s and speeding up, 2 s. 10.175 s in all.
    void turningOnTheSpotTakesItsTime_data() {
        QTest::addColumn<bool>("canTurnInPlace");
        QTest::addColumn<bool>("hasHeadland");
        QTest::addColumn<double>("radiusM");
        QTest::addColumn<double>("longerS");
        QTest::newRow("without room it stops at every swath") << true << false << 1.0 << 10.175 - 1.214;
        QTest::newRow("with room it drives the curve") << true << true << 1.0 << 0.0;
        QTest::newRow("with room for a curve that is slower") << true << true << 8.0 << 10.175 - 18.556;
        QTest::newRow("other machines drive the curve") << false << false << 1.0 << 0.0;
    }
    void turningOnTheSpotTakesItsTime() {
        QFETCH(bool, canTurnInPlace);
        QFETCH(bool, hasHeadland);
        QFETCH(double, radiusM);
        QFETCH(double, longerS);
        MachineSpec spec = findMachine("agbot")->spec();
        spec.implement.offset = {};
        spec.tractor.width = metres(2.0);
        spec.tractor.minTurningRadius = metres(radiusM);
        spec.tractor.workingSpeed = metresPerSecond(2.0);
        spec.tractor.turningSpeed = metresPerSecond(3.0);
        spec.tractor.maxAcceleration = Acceleration::fromSi(1.0);
        spec.tractor.maxLateralAcceleration = Acceleration::fromSi(9.0);
        const auto timeOf = [&](bool inPlace) {
            spec.tractor.canTurnInPlace = inPlace;
            const Machine machine = Machine::create(spec).value();
            const MultiPolygon field = test::anyField().workable();
            const MultiPolygon mainland =
                hasHeadland ? test::moved({test::rectangle(200.0, 100.0)}, {}, {-100.0, -50.0}) : field;
            const Settings settings;
            return scanLineFor({.field = test::anyField(),
                                .mainland = mainland,
                                .machine = machine,
                                .settings = settings})
                .value()
                .figures(degrees(0.0), SwathObjective::Time);
        };
        const HeadingFigures figures = timeOf(canTurnInPlace);
        const double perChangeS =
            (figures.time - timeOf(false).time).si() / static_cast<double>(figures.count - 1);
        // The last lane is narrower.
        COMPARE_WITHIN(perChangeS, longerS, 1e-2);
    }

    void refuses_data() {
        QTest::addColumn<double>("widthM");
        QTest::addColumn<QString>("overlap");
        QTest::addColumn<double>("fieldM");
        QTest::addColumn<QString>("where");
        QTest::newRow("overlap of the whole width") << 2.5 << "2.5" << 100.0 << "swaths.overlap_m";
        QTest::newRow("overlap of more than the width") << 2.5 << "3" << 100.0 << "swaths.overlap_m";
        QTest::newRow("over ten thousand tracks") << 0.1 << "0" << 2000.0 << "operating_width_m";
        QTest::newRow("over ten thousand tracks by overlap")
            << 2.5 << "2.4999" << 2000.0 << "operating_width_m";
        QTest::newRow("no mainland") << 2.5 << "0" << 0.0 << "swaths";
    }
    void refuses() {
        QFETCH(double, widthM);
        QFETCH(QString, overlap);
        QFETCH(double, fieldM);
        QFETCH(QString, where);
        const MultiPolygon mainland =
            fieldM > 0.0 ? MultiPolygon{test::rectangle(fieldM, fieldM)} : MultiPolygon{};
        const Settings settings = settingsOf({{&kOverlap, overlap.toStdString()}});
        for (const auto* method : {&kBruteForceMethod, &kFixedHeadingMethod, &kLongestEdgeMethod}) {
            const auto set = test::swathsBy(*method, mainland, machineOf(widthM), settings, {});
            QVERIFY(!set);
            QCOMPARE(set.error().code, ErrorCode::InputRefused);
            QCOMPARE(QString::fromStdString(set.error().where), where);
            QVERIFY(!set.error().remedy.empty());
        }
    }

    void aStoppedJobIsCancelled() {
        std::stop_source stop;
        stop.request_stop();
        for (const int threads : {1, 4}) {
            for (const auto* method : {&kBruteForceMethod, &kFixedHeadingMethod, &kLongestEdgeMethod}) {
                const auto set =
                    test::swathsBy(*method, {test::rectangle(100.0, 50.0)}, machineOf(2.5), {},
                                   {.stop = stop.get_token(), .progress = {}, .threads = threads});
                QVERIFY(!set);
                QCOMPARE(set.error().code, ErrorCode::Cancelled);
            }
        }
    }
};

FURROW_TEST(HeadingSearchTest);
#include "tst_heading_search.moc"
