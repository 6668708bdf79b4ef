#include "planner/geometry/geos_bridge.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/swaths/curved_swaths.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.5, 51.5};

std::shared_ptr<const Field> fieldOf(const MultiPolygon& polygons) {
    return std::make_shared<const Field>(
        Field::create(test::fieldSourceFromLocal(polygons, kCentre)).value());
}

std::string wktOf(const Field& field, const std::vector<Polyline>& lines) {
    QStringList parts;
    for (const Polyline& line : lines) {
        QStringList points;
        for (const Point& point : line) {
            const GeoPoint place = field.frame().toGeo(point);
            points << QStringLiteral("%1 %2").arg(place.lonDeg, 0, 'f', 12).arg(place.latDeg, 0, 'f', 12);
        }
        parts << "(" + points.join(", ") + ")";
    }
    return ("MULTILINESTRING (" + parts.join(", ") + ")").toStdString();
}

Result<std::shared_ptr<const Plan>> planOf(
    const std::shared_ptr<const Field>& field,
    std::initializer_list<std::pair<std::string_view, std::string>> given) {
    Settings settings;
    for (const auto& [key, value] : given) {
        applySetting(settings, key, value).value();
    }
    return makePlan({.field = field, .machine = findMachine("agbot").value(), .settings = settings});
}

/// An L: an arm of 300 m to the east and one of 300 m to the north, each 80 m wide.
MultiPolygon angle() {
    return {{.outer = {{0, 0}, {300, 0}, {300, 80}, {80, 80}, {80, 300}, {0, 300}}, .holes = {}}};
}

/// What no swath of a set works of a mainland, square metres.
double missedM2(const SwathSet& set, const MultiPolygon& mainland) {
    MultiPolygon lanes;
    for (const Swath& swath : set.swaths) {
        addStrips(lineOf(swath), swath.width, lanes);
    }
    return area(difference(mainland, unionOf(lanes, {}, kSnapGrid).value(), {}, kSnapGrid).value()).si();
}

}  // namespace

class SwathStageTest : public QObject {
    Q_OBJECT

private slots:
    /// 100 tracks are few; 120 teeth cut them into 12,000 swaths.
    void anOutlineCutsTracksIntoTooMany() {
        Ring comb{{0.0, 0.0}, {840.0, 0.0}};
        for (int tooth = 119; tooth >= 0; --tooth) {
            const double left = 7.0 * tooth;
            comb.insert(comb.end(),
                        {{left + 6.0, 10.0}, {left + 6.0, 260.0}, {left + 1.0, 260.0}, {left + 1.0, 10.0}});
        }
        const auto plan = planOf(fieldOf({{.outer = comb, .holes = {}}}), {{"headland.method", "none"},
                                                                           {"swaths.method", "fixed"},
                                                                           {"swaths.angle_deg", "0"},
                                                                           {"swaths.min_length_m", "0"}});
        QVERIFY(!plan);
        QCOMPARE(plan.error().code, ErrorCode::InputRefused);
        QCOMPARE(plan.error().where.text(), std::string{"swaths"});
        const QByteArray what = QByteArray::fromStdString(plan.error().what.text());
        QVERIFY2(what.contains("no plan may have more than 10000"), what);
        QVERIFY(!plan.error().remedy.empty());
    }
    // Two lines right through make three pieces of known size; one that ends inside makes none.
    void splitLinesCutExactlyThere_data() {
        QTest::addColumn<QString>("method");
        for (const char* method : {"none", "boustrophedon", "merged", "trapezoidal"}) {
            QTest::newRow(method) << method;
        }
    }
    void splitLinesCutExactlyThere() {
        QFETCH(QString, method);
        const auto field = fieldOf({test::centredRectangle(240.0, 120.0)});
        const std::string split = wktOf(
            *field,
            {{{-50.0, -200.0}, {-50.0, 200.0}}, {{60.0, -200.0}, {30.0, 200.0}}, {{0.0, 0.0}, {0.0, 20.0}}});
        const auto plan = planOf(field, {{"decomposition.method", method.toStdString()},
                                         {"decomposition.split", split},
                                         {"swaths.method", "fixed"},
                                         {"swaths.angle_deg", "0"}});
        VERIFY_RESULT(plan);
        const Plan& p = **plan;
        QCOMPARE(p.cells.cells.size(), std::size_t{3});
        const double insetM = p.headland.width.si();
        const double heightM = 120.0 - 2.0 * insetM;
        // Across the middle the slanting line lies at 45.
        std::multiset<long> areas;
        for (const Cell& cell : p.cells.cells) {
            areas.insert(std::lround(area(cell.outline).si()));
        }
        const auto rounded = [&](double widthM) { return std::lround(widthM * heightM); };
        QCOMPARE(areas, (std::multiset<long>{rounded(70.0 - insetM), rounded(95.0), rounded(75.0 - insetM)}));
        double sum = 0.0;
        std::set<std::size_t> dealt;
        for (const Cell& cell : p.cells.cells) {
            sum += area(cell.outline).si();
            for (const std::size_t index : cell.swaths) {
                QVERIFY(dealt.insert(index).second);
                const Swath& swath = p.swaths.swaths[index];
                const Point middle = 0.5 * (swath.start + swath.end);
                const Bounds box = bounds(cell.outline);
                QVERIFY(middle.x > box.min.x && middle.x < box.max.x);
            }
        }
        QCOMPARE(dealt.size(), p.swaths.swaths.size());
        COMPARE_WITHIN(sum / area(p.headland.mainland).si(), 1.0, 1e-6);
        // Nothing is joined across a split line.
        if (method != "none") {
            QCOMPARE(p.cells.history.pieces.size(), std::size_t{3});
            QCOMPARE(p.cells.history.steps.size(), std::size_t{1});
            QCOMPARE(p.cells.history.steps.front().cells, std::size_t{3});
            COMPARE_WITHIN(p.cells.history.steps.front().altitude.si(), 3.0 * heightM, 1e-3);
        }
        QCOMPARE(p.route.steps.size(), p.swaths.swaths.size());
        // The line that ends inside is told, with what it falls short by: straight down from the middle is
        // the farther edge, and straight up from 20 m.
        const auto told = std::ranges::find(p.findings, "decomposition.split", &Finding::setting);
        QVERIFY(told != p.findings.end());
        QCOMPARE(told->severity, Severity::Note);
        const QString missing = QString::number(0.5 * heightM, 'f', 1);
        QVERIFY2(told->text.contains("Split line 3 ends " + missing.toStdString() + " m short"),
                 told->text.c_str());
        QVERIFY(told->text.contains("decomposition.split"));
        // A swath goes on beyond the line: together they are as long as without.
        const auto whole = planOf(field, {{"swaths.method", "fixed"}, {"swaths.angle_deg", "0"}});
        VERIFY_RESULT(whole);
        COMPARE_WITHIN(p.swaths.totalLength.si(), (*whole)->swaths.totalLength.si(), 1e-3);
        QCOMPARE(p.swaths.swaths.size(), 3 * (*whole)->swaths.swaths.size());
        for (std::size_t i = 0; i < p.swaths.swaths.size(); ++i) {
            QCOMPARE(p.swaths.swaths[i].number, static_cast<int>(i) + 1);
        }
    }

    // A line drawn by hand ends in the headland at one side, and 2 m inside of the mainland at the other: it
    // is meant to cut.
    void aSplitLineThatFallsShortIsDrawnOn() {
        const auto field = fieldOf({test::centredRectangle(240.0, 120.0)});
        const auto whole = planOf(field, {{"swaths.method", "fixed"}, {"swaths.angle_deg", "0"}});
        VERIFY_RESULT(whole);
        const double edgeM = 60.0 - (*whole)->headland.width.si();
        for (const double shortM : {2.0, 3.0}) {
            const std::string split = wktOf(*field, {{{0.0, -58.0}, {0.0, edgeM - shortM}}});
            const auto plan =
                planOf(field, {{"decomposition.split", split}, {"decomposition.method", "none"}});
            VERIFY_RESULT(plan);
            const bool isDrawnOn = shortM < (*plan)->request.machine.operatingWidth().si();
            QCOMPARE((*plan)->cells.cells.size(), isDrawnOn ? std::size_t{2} : std::size_t{1});
            QCOMPARE(std::ranges::count((*plan)->findings, "decomposition.split", &Finding::setting),
                     isDrawnOn ? 0 : 1);
        }
        const std::string outside = wktOf(*field, {{{-200.0, 59.0}, {200.0, 59.0}}});
        const auto plan = planOf(field, {{"decomposition.split", outside}, {"swaths.method", "fixed"}});
        VERIFY_RESULT(plan);
        const auto told = std::ranges::find((*plan)->findings, "decomposition.split", &Finding::setting);
        QVERIFY(told != (*plan)->findings.end());
        QVERIFY2(told->text.contains("Split line 1 does not lie inside the headland"), told->text.c_str());
    }

    // Nothing is worth lowering the implement for that is shorter than it: a triangle's tip, whatever cuts
    // the swaths.
    void noSwathIsShorterThanTheLeast_data() {
        QTest::addColumn<QString>("method");
        for (const char* method : {"exact", "fixed", "ab-curve"}) {
            QTest::newRow(method) << method;
        }
    }
    void noSwathIsShorterThanTheLeast() {
        QFETCH(QString, method);
        const auto field = fieldOf({{.outer = {{0, 0}, {150, 0}, {0, 60}}, .holes = {}}});
        const std::string split = wktOf(*field, {{{-200.0, -5.0}, {200.0, 7.0}}});
        for (const char* least : {"0", "auto", "12"}) {
            const auto plan = planOf(field, {{"swaths.method", method.toStdString()},
                                             {"swaths.angle_deg", "60"},
                                             {"swaths.min_length_m", least},
                                             {"decomposition.split", split},
                                             {"decomposition.method", "trapezoidal"}});
            VERIFY_RESULT(plan);
            const double leastM = least == std::string_view{"12"} ? 12.0
                                  : least == std::string_view{"0"}
                                      ? 0.0
                                      : (*plan)->request.machine.spec().implement.length.si();
            const auto isShort = [&](const Swath& swath) { return swath.length().si() < leastM; };
            QCOMPARE(std::ranges::count_if((*plan)->swaths.swaths, isShort), 0);
            QCOMPARE((*plan)->route.steps.size(), (*plan)->swaths.swaths.size());
            if (leastM == 12.0) {
                QVERIFY(std::ranges::find((*plan)->findings, "swaths.min_length_m", &Finding::setting) !=
                        (*plan)->findings.end());
            }
        }
    }

    // One cell has one heading, whatever is asked for: nothing changes.
    void aSingleCellStaysAsItIs() {
        for (const MultiPolygon& shape : {MultiPolygon{test::centredRectangle(240.0, 120.0)}, angle()}) {
            const auto field = fieldOf(shape);
            const auto common = planOf(field, {{"decomposition.method", "none"}});
            const auto own =
                planOf(field, {{"decomposition.method", "none"}, {"decomposition.heading", "per-cell"}});
            VERIFY_RESULT(common);
            VERIFY_RESULT(own);
            QVERIFY((*own)->swaths.swaths == (*common)->swaths.swaths);
            COMPARE_WITHIN((*own)->path.duration().si(), (*common)->path.duration().si(), 0.0);
        }
    }

    // Where cells with different headings meet, no triangles and no strips are missed, although nobody works
    // the headland: a split line that slants, and one between two lanes.
    void nothingIsMissedBetweenHeadings_data() {
        QTest::addColumn<double>("fromM");
        QTest::addColumn<double>("toM");
        QTest::addColumn<QString>("ends");
        QTest::newRow("along the arm") << 80.0 << 80.0 << "full";
        QTest::newRow("slanting") << 70.0 << 90.0 << "full";
        QTest::newRow("slanting, swaths to the middle") << 70.0 << 90.0 << "centre";
    }
    void nothingIsMissedBetweenHeadings() {
        QFETCH(double, fromM);
        QFETCH(double, toM);
        QFETCH(QString, ends);
        const auto field = fieldOf(angle());
        const Point corner = field->frame().toLocal(kCentre);
        const std::string split = wktOf(*field, {{corner + Point{-50.0, fromM}, corner + Point{150.0, toM}}});
        const auto own = planOf(field, {{"decomposition.split", split},
                                        {"decomposition.method", "none"},
                                        {"headland.driven", "false"},
                                        {"headland.width_m", "10"},
                                        {"decomposition.heading", "per-cell"},
                                        {"swaths.ends", ends.toStdString()}});
        VERIFY_RESULT(own);
        QCOMPARE((*own)->cells.cells.size(), std::size_t{2});
        QVERIFY(std::abs((*own)->cells.cells[0].heading.si() - (*own)->cells.cells[1].heading.si()) > 0.1);
        // The arms are 60 m broad, 280 and 220 m long: all of it but for what slanting headings leave at the
        // ends.
        const double missed = missedM2((*own)->swaths, (*own)->headland.mainland);
        QVERIFY2(missed < 0.002 * area((*own)->headland.mainland).si(), qPrintable(QString::number(missed)));
    }

    // Each arm of an L along itself, once a split line parts them.
    void cellsHaveHeadingsOfTheirOwnWhereThatSavesTime() {
        const auto field = fieldOf(angle());
        const Point corner = field->frame().toLocal(kCentre);
        const std::string split = wktOf(*field, {{corner + Point{-50.0, 80.0}, corner + Point{150.0, 80.0}}});
        const auto common = planOf(field, {{"decomposition.split", split}, {"decomposition.method", "none"}});
        const auto own = planOf(field, {{"decomposition.split", split},
                                        {"decomposition.method", "none"},
                                        {"decomposition.heading", "per-cell"}});
        VERIFY_RESULT(common);
        VERIFY_RESULT(own);
        QCOMPARE((*common)->cells.cells.size(), std::size_t{2});
        QCOMPARE((*own)->cells.cells.size(), std::size_t{2});
        COMPARE_WITHIN((*common)->cells.cells[0].heading.si(), (*common)->cells.cells[1].heading.si(), 0.0);
        std::vector<double> headings{inDegrees((*own)->cells.cells[0].heading),
                                     inDegrees((*own)->cells.cells[1].heading)};
        std::ranges::sort(headings);
        // East within a degree, at either end of the range, and north.
        const auto toEast = [](double deg) { return std::min(deg, 180.0 - deg); };
        QVERIFY2((toEast(headings[0]) < 1.5 && std::abs(headings[1] - 90.0) < 1.5) ||
                     (toEast(headings[1]) < 1.5 && std::abs(headings[0] - 90.0) < 1.5),
                 qPrintable(QString("%1 %2").arg(headings[0]).arg(headings[1])));
        QVERIFY2(
            (*own)->swaths.swaths.size() < (*common)->swaths.swaths.size(),
            qPrintable(
                QString("%1 %2").arg((*own)->swaths.swaths.size()).arg((*common)->swaths.swaths.size())));
        QVERIFY((*own)->path.duration() < (*common)->path.duration());
        QVERIFY2((*own)->audit.coveredShare.value() > 0.97,
                 qPrintable(QString::number(*(*own)->audit.coveredShare)));
    }

    // A rectangle is best in one heading: nothing changes.
    void aSharedHeadingStaysWhereItIsBest() {
        const auto field = fieldOf({test::centredRectangle(240.0, 120.0)});
        const std::string split = wktOf(*field, {{{0.0, -200.0}, {0.0, 200.0}}});
        const auto own = planOf(field, {{"decomposition.split", split},
                                        {"decomposition.heading", "per-cell"},
                                        {"swaths.method", "fixed"},
                                        {"swaths.angle_deg", "0"}});
        VERIFY_RESULT(own);
        for (const Cell& cell : (*own)->cells.cells) {
            QCOMPARE(cell.heading.si(), 0.0);
        }
        QVERIFY(!(*own)->swaths.isCurved());
    }
};

FURROW_TEST(SwathStageTest);
#include "tst_swath_stage.moc"
