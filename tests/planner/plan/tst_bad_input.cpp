// What bad input gets, from what a file or a person gives to the finished plan: a row for each thing that is
// repaired, said and shown, and for each that is refused with its place and what to do. Never a crash, never
// a plan that is silently wrong. Variants of a boundary are rows of tst_field and tst_field_repairs, of a
// machine file of tst_machine_file, of other files of tst_boundary_import; cancelling stage by stage is in
// tst_plan, and what the command line makes of it in tst_cli.

#include "planner/io/import/boundary_import.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"
#include "tests/support/wkt.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <stop_token>

using namespace furrow;
using test::agbot;
using test::fieldSourceFromLocal;

namespace {

constexpr GeoPoint kCentre{9.2, 51.3};
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Point kNoPlace{kNan, kNan};

using PlanResult = Result<std::shared_ptr<const Plan>>;
using Planned = std::function<PlanResult()>;

/// Drawn in metres around the centre.
FieldSource sourceFromWkt(const char* wkt) {
    FieldSource source = fieldSourceFromLocal(test::polygonsAsInFile(wkt), kCentre);
    source.origin = "fields.gpkg, feature 12";
    return source;
}

FieldSource square() {
    return sourceFromWkt("POLYGON((0 0, 100 0, 100 100, 0 100, 0 0))");
}

FieldSource rectangle(double widthM, double heightM) {
    return fieldSourceFromLocal({test::centredRectangle(widthM, heightM)}, kCentre);
}

FieldSource circle(std::size_t count, double radiusM) {
    Ring ring;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        ring.push_back(radiusM * direction(angle));
    }
    FieldSource source = fieldSourceFromLocal({{.outer = std::move(ring), .holes = {}}}, kCentre);
    source.origin = "fields.gpkg, feature 12";
    return source;
}

/// The square with its third point somewhere else.
FieldSource withThirdPointAt(GeoPoint point) {
    FieldSource source = square();
    source.parts.front().outer[2] = point;
    return source;
}

FieldSource withObstacle(const char* wkt) {
    FieldSource source = square();
    source.obstacles = {
        {.name = "pond", .outline = sourceFromWkt(wkt).parts.front(), .passable = false, .buffer = {}}};
    return source;
}

Settings settingsOf(std::initializer_list<std::pair<std::string_view, std::string_view>> given) {
    Settings settings;
    for (const auto& [key, text] : given) {
        applySetting(settings, key, text).value();
    }
    return settings;
}

/// Without headland passes, whose footprint is looked at every few decimetres.
Settings quick(std::initializer_list<std::pair<std::string_view, std::string_view>> given) {
    Settings settings = settingsOf(given);
    applySetting(settings, "headland.driven", "false").value();
    return settings;
}

/// All the way from what was given.
PlanResult plan(const FieldSource& source, const MachineSpec& spec, const Settings& settings = {},
                const JobContext& job = {}) {
    auto field = Field::create(source, job);
    if (!field) {
        return std::unexpected(field.error());
    }
    const auto machine = Machine::create(spec);
    if (!machine) {
        return std::unexpected(machine.error());
    }
    return makePlan({.field = std::make_shared<const Field>(std::move(*field)),
                     .machine = *machine,
                     .settings = settings},
                    job);
}

Planned planOf(FieldSource source) {
    return [source = std::move(source)] { return plan(source, agbot().spec()); };
}

Point inRow(const std::optional<GeoPoint>& place) {
    return place ? LocalFrame::centredOn(kCentre)->toLocal(*place) : kNoPlace;
}

}  // namespace

class BadInputTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    FieldSource sourceFromFile(const char* name, const char* text) const {
        const std::string path = folder_.filePath(name).toStdString();
        std::ofstream{path} << text;
        return readBoundaries(path).value().front();
    }

private slots:
    void isRepairedAndSaid_data() {
        QTest::addColumn<FieldSource>("source");
        QTest::addColumn<QString>("said");
        QTest::addColumn<Point>("place");
        QTest::addColumn<double>("areaM2");
        QTest::newRow("points given twice")
            << sourceFromWkt("POLYGON((0 0, 100 0, 100 0, 100 100, 0 100, 0 0))") << "1 point was given twice"
            << Point{100.0, 0.0} << 10'000.0;
        QTest::newRow("spike") << sourceFromWkt(
                                      "POLYGON((0 0, 50 0, 50 -30, 50 0, 100 0, 100 100, 0 100, 0 0))")
                               << "1 spike without area was removed" << Point{50.0, -30.0} << 10'000.0;
        QTest::newRow("ring the wrong way round")
            << sourceFromWkt("POLYGON((0 0, 0 100, 100 100, 100 0, 0 0))") << "ran the wrong way round"
            << Point{0.0, 0.0} << 10'000.0;
        // 205.96 m by 222.53 m of the ellipsoid there, by geod(1), and too far away for the row's own metres.
        QTest::newRow("ring left open in a file")
            << sourceFromFile(
                   "open.geojson",
                   R"({"type":"Polygon","coordinates":[[[9,52],[9.003,52],[9.003,52.002],[9,52.002]]]})")
            << "did not end where it began and was closed" << kNoPlace << 45'848.8;
        QTest::newRow("tiny sliver")
            << sourceFromWkt(
                   "POLYGON((0 0, 100 0, 100 100, 60 100, 60 130.01, 60.01 130, 60.01 99.9, 0 100, 0 0))")
            << "a sliver of" << kNoPlace << 10'000.0;
        QTest::newRow("ring that touches itself")
            << sourceFromWkt("POLYGON((0 0, 50 0, 50 50, 100 50, 100 100, 50 100, 50 50, 0 50, 0 0))")
            << "touches or crosses itself by a sliver; taken apart" << Point{50.0, 50.0} << 5000.0;
    }
    void isRepairedAndSaid() {
        QFETCH(FieldSource, source);
        QFETCH(QString, said);
        QFETCH(Point, place);
        QFETCH(double, areaM2);
        const PlanResult result = plan(source, agbot().spec());
        VERIFY_RESULT(result);
        const Plan& made = **result;
        COMPARE_WITHIN(area(made.field().boundary()).si(), areaM2, 5.0);
        // In the list of findings and on the map, as a note: the field can be planned.
        const auto found = std::ranges::find_if(made.findings, [&](const Finding& finding) {
            return finding.kind == FindingKind::Repair && QString::fromStdString(finding.text).contains(said);
        });
        QVERIFY(found != made.findings.end());
        QVERIFY(found->severity == Severity::Note);
        QVERIFY(found->text.starts_with("Repaired in the boundary: "));
        if (!std::isnan(place.x)) {
            COMPARE_WITHIN(distance(inRow(made.field().frame().toGeo(found->place)), place), 0.0, 0.01);
        }
    }

    void isRefused_data() {
        QTest::addColumn<Planned>("planned");
        QTest::addColumn<QString>("said");
        QTest::addColumn<QString>("where");
        QTest::addColumn<Point>("place");
        const QString boundary = "fields.gpkg, feature 12, the boundary";
        QTest::newRow("a ring of one point")
            << planOf(sourceFromWkt("POLYGON((5 6))")) << "fewer than 3 different points" << boundary
            << Point{5.0, 6.0};
        QTest::newRow("two different points among five")
            << planOf(sourceFromWkt("POLYGON((5 6, 90 90, 5 6, 90 90, 5 6))"))
            << "fewer than 3 different points" << boundary << Point{5.0, 6.0};
        QTest::newRow("a crossing with two ways out")
            << planOf(sourceFromWkt("POLYGON((0 0, 100 100, 100 0, 0 100, 0 0))"))
            << "the line crosses itself at 9.2" << boundary << Point{50.0, 50.0};
        const QString third = "fields.gpkg, feature 12, part 1, point 3";
        QTest::newRow("NaN") << planOf(withThirdPointAt({kNan, 51.3})) << "not a number" << third << kNoPlace;
        QTest::newRow("infinite") << planOf(withThirdPointAt({9.2, -kInfinity})) << "not a number" << third
                                  << kNoPlace;
        QTest::newRow("outside WGS84") << planOf(withThirdPointAt({513'000.0, 5'683'000.0}))
                                       << "outside longitude -180 to 180" << third << kNoPlace;
        // 50 cm².
        QTest::newRow("no area") << planOf(sourceFromWkt("POLYGON((0 0, 5 0, 2.5 0.002, 0 0))"))
                                 << "enclose no area" << boundary << Point{0.0, 0.0};
        QTest::newRow("over 100 km across") << planOf(circle(64, 50'200.0)) << "more than 100 km"
                                            << "fields.gpkg, feature 12, part 1" << kNoPlace;
        QTest::newRow("one point 100 km away") << planOf(withThirdPointAt({9.2, 52.3})) << "more than 100 km"
                                               << third << inRow(GeoPoint{9.2, 52.3});
        QTest::newRow("more than a million vertices") << planOf(circle(1'000'001, 1000.0)) << "1000001 points"
                                                      << "fields.gpkg, feature 12" << kNoPlace;
        QTest::newRow("obstacle outside the field")
            << planOf(withObstacle("POLYGON((200 40, 220 40, 220 60, 200 60, 200 40))"))
            << "lies outside the field"
            << "fields.gpkg, feature 12, obstacle 'pond'" << Point{200.0, 40.0};
        for (const double value : {0.0, -3.0, kNan, kInfinity}) {
            MachineSpec spec = agbot().spec();
            spec.implement.operatingWidth = metres(value);
            QTest::addRow("operating width %g", value)
                << Planned{[spec] { return plan(square(), spec); }} << "is beyond what machines have"
                << "machine, operating_width_m" << kNoPlace;
            spec = agbot().spec();
            spec.tractor.minTurningRadius = metres(value);
            QTest::addRow("turning radius %g", value)
                << Planned{[spec] { return plan(square(), spec); }} << "is beyond what machines have"
                << "machine, min_turning_radius_m" << kNoPlace;
        }
    }
    void isRefused() {
        QFETCH(Planned, planned);
        QFETCH(QString, said);
        QFETCH(QString, where);
        QFETCH(Point, place);
        const PlanResult result = planned();
        QVERIFY(!result);
        const Error& error = result.error();
        QVERIFY2(error.code == ErrorCode::InputRefused, error.line().c_str());
        QVERIFY2(QString::fromStdString(error.what).contains(said), error.line().c_str());
        QVERIFY2(QString::fromStdString(error.where).startsWith(where), error.line().c_str());
        QVERIFY2(!error.remedy.empty(), error.line().c_str());
        QVERIFY2(!error.line().contains('\n'), error.line().c_str());
        if (!std::isnan(place.x)) {
            COMPARE_WITHIN(distance(inRow(error.place), place), 0.0, 0.01);
        }
    }

    // The AgBot is 2.5 m wide and, with its implement, 5.4 m long.
    void aMachineThatFitsNowhere_data() {
        QTest::addColumn<double>("widthM");
        QTest::addColumn<double>("heightM");
        QTest::addColumn<QString>("marginM");
        QTest::addColumn<QString>("said");
        QTest::newRow("wide enough") << 100.0 << 2.6 << "0" << "";
        QTest::newRow("too narrow") << 100.0 << 2.4 << "0" << "nowhere as wide as the machine (2.50 m)";
        QTest::newRow("too narrow with its margin")
            << 100.0 << 4.0 << "1" << "(2.50 m and twice 1.00 m of margin)";
        QTest::newRow("wide enough with its margin") << 100.0 << 4.7 << "1" << "";
        // Its middle line of 2.9 m, which keeps 1.25 m off the edge: the diagonal of 1.5 m by 1.5 m is 2.12
        // m, of 2.1 m by 2.1 m 2.97 m.
        QTest::newRow("too short") << 4.0 << 4.0 << "0" << "(2.50 m wide, 5.40 m long) fits nowhere";
        QTest::newRow("long enough across") << 4.6 << 4.6 << "0" << "";
        QTest::newRow("long enough along one side") << 5.5 << 2.6 << "0" << "";
        QTest::newRow("too short with its margin")
            << 6.0 << 5.0 << "1" << "(2.50 m wide, 5.40 m long and twice 1.00 m of margin)";
    }
    void aMachineThatFitsNowhere() {
        QFETCH(double, widthM);
        QFETCH(double, heightM);
        QFETCH(QString, marginM);
        QFETCH(QString, said);
        const PlanResult result = plan(rectangle(widthM, heightM), agbot().spec(),
                                       settingsOf({{"field.margin_m", marginM.toStdString()}}));
        QVERIFY2(result.has_value() == said.isEmpty(), result ? "" : result.error().line().c_str());
        if (!result) {
            QCOMPARE(result.error().code, ErrorCode::InputRefused);
            QVERIFY2(QString::fromStdString(result.error().what).contains(said),
                     result.error().line().c_str());
            QVERIFY(!result.error().remedy.empty());
            COMPARE_WITHIN(distance(inRow(result.error().place), {}), 0.0, 0.01);
        }
    }

    // A trailed implement bends at its hitch: only the tractor, 5.2 m of a length that is 11.5 m in all, has
    // to fit. One that is shorter than wide goes sideways into what is as wide as it is long.
    void whatOfAMachineHasToFit() {
        MachineSpec trailed = agbot().spec();
        trailed.tractor.length = metres(5.2);
        trailed.implement.mounting = Mounting::Trailed;
        trailed.implement.offset = metres(-7.0);
        VERIFY_RESULT(plan(rectangle(5.3, 2.6), trailed));
        trailed.implement.mounting = Mounting::Mounted;
        QVERIFY(!plan(rectangle(5.3, 2.6), trailed));
        MachineSpec wide = agbot().spec();
        wide.tractor.length = metres(1.5);
        wide.tractor.rearOverhang = metres(0.5);
        wide.implement.offset = metres(0.0);
        wide.implement.length = metres(1.0);
        wide.implement.operatingWidth = metres(1.5);
        VERIFY_RESULT(plan(rectangle(30.0, 1.6), wide));
        QVERIFY(!plan(rectangle(30.0, 1.4), wide));
    }

    void aHundredThousandVerticesArePlanned() {
        const PlanResult result =
            plan(circle(100'000, 150.0), agbot().spec(), quick({{"swaths.method", "longest-edge"}}));
        VERIFY_RESULT(result);
        QCOMPARE((*result)->field().vertexCount(), std::size_t{100'000});
        // pi 150² m², and 300 m less twice 10 m of headland in swaths of 2.5 m.
        COMPARE_WITHIN((*result)->field().area().si(), 22'500.0 * std::numbers::pi, 1.0);
        QCOMPARE((*result)->swaths.swaths.size(), std::size_t{112});
        // The mainland is (140 / 150)² of it.
        QVERIFY((*result)->audit.coveredShare > 0.86);
    }

    void aCancelIsAnswered_data() {
        QTest::addColumn<int>("report");
        QTest::newRow("at the first report") << 1;
        QTest::newRow("in the middle of the search") << 100;
    }
    void aCancelIsAnswered() {
        QFETCH(int, report);
        std::stop_source stop;
        QElapsedTimer answered;
        std::atomic<int> reports = 0;
        const JobContext job{.stop = stop.get_token(),
                             .progress =
                                 [&](double) {
                                     if (++reports == report) {
                                         answered.start();
                                         stop.request_stop();
                                     }
                                 },
                             .threads = 0};
        const PlanResult result = plan(circle(100'000, 150.0), agbot().spec(), quick({}), job);
        QVERIFY(stop.stop_requested());
        QVERIFY(!result);
        QCOMPARE(result.error().code, ErrorCode::Cancelled);
        qInfo("the worker ended %lld ms later", answered.elapsed());
    }
};

FURROW_TEST(BadInputTest);
#include "tst_bad_input.moc"
