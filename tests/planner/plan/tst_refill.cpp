// Trips to refill points. By hand: a field of 100 m by 100 m, 10 m of headland that is not driven, and eight
// swaths of 80 m. The machine works 10 m and turns on the spot, so that ways are straight lines.

#include "planner/io/delivery/plan_folder.h"
#include "planner/io/plan_files/plan_reader.h"
#include "planner/machine/machine_library.h"
#include "planner/path/refill_stops.h"
#include "planner/plan/drive_course.h"
#include "planner/plan/explanation.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <format>
#include <iterator>
#include <numbers>
#include <random>
#include <set>

using namespace furrow;

namespace {

using Given = std::vector<std::pair<std::string, std::string>>;

constexpr double kSwathM = 80.0;
constexpr double kWidthM = 10.0;
constexpr double kFillS = 120.0;
constexpr std::string_view kFormats[] = {"geojson", "csv"};

std::shared_ptr<const Field> fieldOf(const MultiPolygon& outline, std::optional<Point> gate = {}) {
    FieldSource source = test::fieldSourceFromLocal(outline, {9.2, 51.3});
    if (gate) {
        const Field plain = Field::create(source).value();
        source.gates.push_back(
            {.name = "Road", .position = plain.frame().toGeo(Ring{*gate}).front(), .width = metres(8.0)});
    }
    return std::make_shared<const Field>(Field::create(source).value());
}

std::shared_ptr<const Field> square(std::optional<Point> gate = {}) {
    return fieldOf({test::centredRectangle(100.0, 100.0)}, gate);
}

std::string pointText(const Field& field, Point place) {
    const GeoPoint at = field.frame().toGeo(Ring{place}).front();
    return std::format("POINT ({:.10f} {:.10f})", at.lonDeg, at.latDeg);
}

/// As broad as its work, and worked at the middle of its axle: poses of the machine are those of the work.
Machine onTheSpot(double swathsPerTank) {
    MachineSpec spec = findMachine("agbot").value().spec();
    spec.tractor.canTurnInPlace = true;
    spec.implement.operatingWidth = metres(kWidthM);
    spec.implement.raisedWidth = metres(2.5);
    spec.implement.offset = metres(0.0);
    spec.implement.hitchOffset = metres(0.0);
    spec.tank = Tank{.capacity = swathsPerTank * kSwathM * kWidthM, .ratePerM2 = 1.0, .fillTimeS = kFillS};
    return Machine::create(spec).value();
}

Machine withTank(std::string_view id, double capacity, double rate = 1.0) {
    MachineSpec spec = findMachine(id).value().spec();
    spec.tank = Tank{.capacity = capacity, .ratePerM2 = rate, .fillTimeS = kFillS};
    return Machine::create(spec).value();
}

Result<std::shared_ptr<const Plan>> planned(const std::shared_ptr<const Field>& field, const Machine& machine,
                                            const Given& given) {
    Settings settings;
    for (const auto& [key, value] : given) {
        applySetting(settings, key, value).value();
    }
    return makePlan({.field = field, .machine = machine, .settings = settings});
}

/// Eight swaths from west to east and back, on straight ways.
Given eightSwaths(const std::string& refill, std::string_view operation = "spreading") {
    return {{"operation.kind", std::string{operation}},
            {"headland.width_m", "10"},
            {"headland.driven", "false"},
            {"swaths.method", "fixed"},
            {"swaths.angle_deg", "0"},
            {"swaths.ends", "centre"},
            {"swaths.overlap_m", "0"},
            {"decomposition.method", "none"},
            {"route.method", "boustrophedon"},
            {"path.method", "straight"},
            {"path.stay_inside", "false"},
            {"route.refill", refill}};
}

/// The number of swaths before each stop, in all.
std::vector<int> swathsBeforeStops(const Path& path) {
    std::vector<int> before;
    int swaths = 0;
    for (const PathSegment& segment : path.segments) {
        swaths += segment.kind == SegmentKind::Swath ? 1 : 0;
        if (segment.refills) {
            before.push_back(swaths);
        }
    }
    return before;
}

bool has(const std::vector<Finding>& findings, FindingKind kind, Severity severity) {
    return std::ranges::any_of(findings, [&](const Finding& finding) {
        return finding.kind == kind && finding.severity == severity;
    });
}

const Finding* ofSetting(const Plan& plan) {
    const auto found = std::ranges::find(plan.findings, std::string{"route.refill"}, &Finding::setting);
    return found == plan.findings.end() ? nullptr : &*found;
}

std::string blockingText(const Plan& plan) {
    std::string text;
    for (const Finding& finding : plan.findings) {
        text += finding.severity == Severity::Blocking ? finding.text.text() + " " : "";
    }
    return text;
}

double workedM(const Path& path) {
    double worked = 0.0;
    for (const PathSegment& segment : path.segments) {
        worked += segment.implementDown ? segment.length().si() : 0.0;
    }
    return worked;
}

/// What a path with a tank has to be, whatever the field: levels within the tank, stops at the points, and
/// all of the work done once.
void checkTrips(const Plan& plan, const Plan& without) {
    const double capacity = plan.request.machine.spec().tank->capacity;
    std::multiset<int> swaths;
    for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
        const PathSegment& segment = plan.path.segments[i];
        for (const PathSample& sample : segment.samples) {
            VERIFY_TOLD(sample.level && *sample.level >= 0.0 && *sample.level <= capacity,
                        QByteArray::number(sample.level.value_or(-1.0)));
        }
        if (segment.kind == SegmentKind::Swath) {
            swaths.insert(segment.number);
        }
        if (segment.refills) {
            const Point at = segment.samples.back().position;
            VERIFY_TOLD(std::ranges::any_of(plan.refill->points,
                                            [&](Point point) {
                                                return distance(point, at) <=
                                                       refillReach(plan.request.machine).si() + 0.5;
                                            }),
                        QByteArray{"stops elsewhere"});
            QVERIFY(i + 1 < plan.path.segments.size());
            COMPARE_WITHIN(plan.path.segments[i + 1].samples.front().tS - segment.samples.back().tS, kFillS,
                           1e-6);
        }
    }
    std::multiset<int> wanted;
    for (const PathSegment& segment : without.path.segments) {
        if (segment.kind == SegmentKind::Swath) {
            wanted.insert(segment.number);
        }
    }
    const bool isCut = plan.request.settings.choice(kTraversal) == "interior";
    if (!isCut) {
        VERIFY_TOLD(swaths == wanted, QByteArray{"other swaths"});
    }
    // Steering begins and ends a pass that is interrupted up to a width farther on; between stretches of a
    // pass it may stay down.
    const double longerM = workedM(plan.path) - workedM(without.path);
    const double steeringM = 1.2 * plan.path.refillCount() * plan.request.machine.operatingWidth().si();
    QCOMPARE_GE(longerM, -0.005 * workedM(without.path));
    QCOMPARE_LE(longerM, 0.02 * workedM(without.path) + steeringM);
    const double total = workedM(plan.path) * plan.request.machine.operatingWidth().si() *
                         plan.request.machine.spec().tank->ratePerM2;
    QCOMPARE_GE(plan.path.refillCount() + 1.005, total / capacity);
}

}  // namespace

class RefillTest : public QObject {
    Q_OBJECT

private slots:
    // A tank for two swaths and a little: after the 2nd, the 4th and the 6th swath. All end on one side.
    void everyTwoSwaths() {
        const auto field = square();
        const Point point{-45.0, 3.0};
        const auto plan = planned(field, onTheSpot(2.05), eightSwaths(pointText(*field, point)));
        VERIFY_RESULT(plan);
        const Path& path = (*plan)->path;
        QCOMPARE((*plan)->swaths.swaths.size(), std::size_t{8});
        QCOMPARE(swathsBeforeStops(path), (std::vector<int>{2, 4, 6}));
        // Straight from the swath's end to the last 2 m before the point, which lie along the west edge, and
        // straight on to the next swath, 10 m aside.
        double expectedM = 0.0;
        std::vector<Point> ends;
        std::vector<Point> starts;
        for (const PathSegment& segment : path.segments) {
            if (segment.kind == SegmentKind::Swath) {
                starts.push_back(segment.samples.front().position);
                ends.push_back(segment.samples.back().position);
            }
        }
        for (const std::size_t after : {1, 3, 5}) {
            double leastM = 1e9;
            for (const double side : {-2.0, 2.0}) {
                leastM = std::min(leastM, distance(ends[after], point + Point{0.0, side}) + 2.0 +
                                              distance(point, starts[after + 1]));
            }
            expectedM += leastM;
        }
        COMPARE_WITHIN(path.length(SegmentKind::Refill).si(), expectedM, 0.01);
        for (const PathSegment& segment : path.segments) {
            if (segment.refills) {
                QCOMPARE_LT(distance(segment.samples.back().position, point), 1e-3);
            }
        }
    }
    // Levels: full, and 800 less after each swath; two swaths of a tank of 1640 leave 40. The third, fifth
    // and seventh begin with a full one.
    void levelsFallAndRise() {
        const auto field = square();
        const auto plan = planned(field, onTheSpot(2.05), eightSwaths(pointText(*field, {-45.0, 3.0})));
        VERIFY_RESULT(plan);
        std::vector<double> before;
        std::vector<double> after;
        for (const PathSegment& segment : (*plan)->path.segments) {
            if (segment.kind == SegmentKind::Swath) {
                before.push_back(segment.samples.front().level.value());
                after.push_back(segment.samples.back().level.value());
            }
        }
        for (std::size_t i = 0; i < before.size(); ++i) {
            COMPARE_WITHIN(before[i], i % 2 == 0 ? 1640.0 : 840.0, 0.1);
            COMPARE_WITHIN(after[i], i % 2 == 0 ? 840.0 : 40.0, 0.1);
        }
        QVERIFY(!has((*plan)->findings, FindingKind::Refill, Severity::Blocking));
        QVERIFY(!(*plan)->proof);
        // The machine stands while its tank is filled.
        const auto course = DriveCourse::of(**plan);
        VERIFY_RESULT(course);
        const auto stop = std::ranges::find((*plan)->path.segments, true, &PathSegment::refills);
        const double stopsS = stop->samples.back().tS;
        COMPARE_WITHIN(course->at(seconds(stopsS)).level.value(), 40.0, 0.1);
        COMPARE_WITHIN(course->at(seconds(stopsS + 0.5 * kFillS)).level.value(), 840.0, 1.0);
        COMPARE_WITHIN(course->at(seconds(stopsS + kFillS + 0.1)).level.value(), 1640.0, 0.1);
    }
    // A bunker is the same upside down.
    void aBunkerFills() {
        const auto field = square();
        const auto plan =
            planned(field, onTheSpot(2.05), eightSwaths(pointText(*field, {-45.0, 3.0}), "harvest"));
        VERIFY_RESULT(plan);
        QCOMPARE(swathsBeforeStops((*plan)->path), (std::vector<int>{2, 4, 6}));
        const auto first = std::ranges::find((*plan)->path.segments, SegmentKind::Swath, &PathSegment::kind);
        COMPARE_WITHIN(first->samples.front().level.value(), 0.0, 1e-9);
        COMPARE_WITHIN(first->samples.back().level.value(), 800.0, 0.1);
        QVERIFY(!has((*plan)->findings, FindingKind::Refill, Severity::Blocking));
    }
    // Three swaths a tank: two trips, in three ways. Beside the ends of the 2nd and the 5th swath there are
    // points, so these two are the cheapest.
    void theCheapestSplit() {
        const auto field = square();
        const auto known = planned(field, onTheSpot(3.05), eightSwaths(pointText(*field, {-45.0, 3.0})));
        VERIFY_RESULT(known);
        QCOMPARE(swathsBeforeStops((*known)->path).size(), std::size_t{2});
        std::vector<Point> ends;
        for (const PathSegment& segment : (*known)->path.segments) {
            if (segment.kind == SegmentKind::Swath) {
                ends.push_back(segment.samples.back().position);
            }
        }
        const auto beside = [&](std::size_t swath) {
            return pointText(*field, ends[swath] + Point{ends[swath].x < 0.0 ? -5.0 : 5.0, 0.0});
        };
        for (const auto& [first, second] : {std::pair{2, 5}, std::pair{3, 6}, std::pair{3, 5}}) {
            const auto plan = planned(field, onTheSpot(3.05),
                                      eightSwaths(beside(static_cast<std::size_t>(first) - 1) + "; " +
                                                  beside(static_cast<std::size_t>(second) - 1)));
            VERIFY_RESULT(plan);
            QCOMPARE(swathsBeforeStops((*plan)->path), (std::vector<int>{first, second}));
        }
    }
    void noTripIsNeeded() {
        const auto field = square();
        const auto plan = planned(field, onTheSpot(8.05), eightSwaths(pointText(*field, {-45.0, 3.0})));
        VERIFY_RESULT(plan);
        QCOMPARE((*plan)->path.refillCount(), 0);
        QVERIFY(ofSetting(**plan) != nullptr);
        QVERIFY2(ofSetting(**plan)->text.contains("6400 of the 6440"), ofSetting(**plan)->text.c_str());
        QVERIFY((*plan)->path.segments.back().samples.back().level.has_value());
    }
    void withoutATank_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("operation");
        QTest::addColumn<QString>("why");
        QTest::newRow("no tank") << "agbot" << "spreading" << "no tank";
        QTest::newRow("tillage") << "mounted-drill" << "tillage" << "operation uses no tank";
    }
    void withoutATank() {
        QFETCH(QString, machine);
        QFETCH(QString, operation);
        QFETCH(QString, why);
        const auto field = square();
        Given given{{"operation.kind", operation.toStdString()}};
        const auto before = planned(field, findMachine(machine.toStdString()).value(), given);
        given.emplace_back("route.refill", pointText(*field, {0.0, 0.0}));
        const auto plan = planned(field, findMachine(machine.toStdString()).value(), given);
        VERIFY_RESULT(before);
        VERIFY_RESULT(plan);
        QVERIFY((*plan)->path == (*before)->path);
        QVERIFY(ofSetting(**plan) != nullptr);
        QVERIFY2(ofSetting(**plan)->text.contains(why.toStdString()), ofSetting(**plan)->text.c_str());
    }
    void noSuchPlace() {
        const auto field = square(Point{-50.0, 0.0});
        const Machine machine = onTheSpot(2.05);
        const auto refused = [&](const std::string& text) {
            const auto plan = planned(field, machine, eightSwaths(text));
            return plan ? Error{} : plan.error();
        };
        QCOMPARE(refused("Barn").code, ErrorCode::Usage);
        QVERIFY(refused("Barn").remedy.contains("Road"));
        QVERIFY(refused("LINESTRING (9.2 51.3, 9.3 51.3)").what.contains("LINESTRING"));
        QVERIFY(refused("POINT (9 50)").what.contains("outside"));
        QVERIFY(refused("Road; " + pointText(*field, {80.0, 0.0})).what.contains("outside"));
        QCOMPARE(refused("Road; Road").what.text(), std::string{});
        Settings settings;
        QVERIFY(!applySetting(settings, "route.refill", "POINT (200 50)"));
    }
    void atAGate() {
        const auto field = square(Point{-50.0, 0.0});
        const auto plan = planned(field, onTheSpot(2.05), eightSwaths("Road"));
        VERIFY_RESULT(plan);
        QCOMPARE((*plan)->path.refillCount(), 3);
        QVERIFY2((*plan)->drivable(), blockingText(**plan).c_str());
    }

    // The tank holds less than one swath takes: told with both numbers. Where ways may cross the mainland,
    // swaths are interrupted instead.
    void aSwathThatTakesMore() {
        const auto field = square();
        Given given = eightSwaths(pointText(*field, {-45.0, 3.0}));
        const auto plan = planned(field, onTheSpot(0.75), given);
        VERIFY_RESULT(plan);
        QVERIFY(!(*plan)->drivable());
        QVERIFY(has((*plan)->findings, FindingKind::Refill, Severity::Blocking));
        QVERIFY2(blockingText(**plan).contains("takes 800; the tank holds 600"),
                 blockingText(**plan).c_str());
        QVERIFY2(blockingText(**plan).contains("8 passes"), blockingText(**plan).c_str());
        for (const PathSegment& segment : (*plan)->path.segments) {
            for (const PathSample& sample : segment.samples) {
                QVERIFY(sample.level.value() >= 0.0);
            }
        }
        given.emplace_back("route.traversal", "interior");
        const auto crossing = planned(field, onTheSpot(0.75), given);
        VERIFY_RESULT(crossing);
        QVERIFY2((*crossing)->drivable(), blockingText(**crossing).c_str());
        // 6400 of 600 each.
        QCOMPARE_GE((*crossing)->path.refillCount(), 10);
        COMPARE_WITHIN(workedM((*crossing)->path), 640.0, 0.5);
    }

    // The audit finds what is changed in a path.
    void theAuditFindsIt() {
        const auto field = square();
        const auto plan = planned(field, onTheSpot(2.05), eightSwaths(pointText(*field, {-45.0, 3.0})));
        VERIFY_RESULT(plan);
        const auto told = [&](const auto& change) {
            std::vector<PathSegment> segments = (*plan)->path.segments;
            AuditInput input = auditInput(**plan);
            change(segments, input);
            input.segments = segments;
            std::string text;
            const AuditReport report = audit(input).value();
            for (const AuditFinding& found : report.findings) {
                text += found.finding.kind == FindingKind::Refill ? found.finding.text.text() + "\n" : "";
            }
            return text;
        };
        using Segments = std::vector<PathSegment>;
        QCOMPARE(told([](Segments&, AuditInput&) {}), std::string{});
        QVERIFY(told([](Segments&, AuditInput& input) {
                    input.tank->points = {{40.0, 0.0}};
                }).contains("away from the refill points"));
        // A tank of 75 m² less than the two swaths take: 7.5 m in each of four pairs are worked with nothing.
        const std::string empty = told([](Segments&, AuditInput& input) {
            MachineSpec spec = input.machine->spec();
            spec.tank->capacity = 1525.0;
            input.machine = Machine::create(spec).value();
        });
        QVERIFY2(empty.contains("30 m are worked beyond"), empty.c_str());
        QVERIFY(told([](Segments& segments, AuditInput&) {
                    for (PathSegment& segment : segments) {
                        for (PathSample& sample : segment.samples) {
                            sample.level = *sample.level + 100.0;
                        }
                    }
                }).contains("differs"));
        QVERIFY(told([](Segments& segments, AuditInput&) {
                    double earlierS = 0.0;
                    bool stops = false;
                    for (PathSegment& segment : segments) {
                        earlierS += stops ? kFillS : 0.0;
                        for (PathSample& sample : segment.samples) {
                            sample.tS -= earlierS;
                        }
                        stops = segment.refills;
                    }
                }).contains("3 places"));
    }

    // What is written is read back and found to be the same.
    void writtenAndRead() {
        const auto field = square();
        const auto plan = planned(field, onTheSpot(2.05), eightSwaths(pointText(*field, {-45.0, 3.0})));
        VERIFY_RESULT(plan);
        const QTemporaryDir folder;
        VERIFY_RESULT(writePlanFolder(**plan, folder.path().toStdString(), kFormats));
        const auto read = readPlan(folder.path().toStdString());
        VERIFY_RESULT(read);
        QVERIFY(read->tank.has_value());
        QCOMPARE(read->tank->points.size(), std::size_t{1});
        QCOMPARE(std::ranges::count(read->segments, true, &PathSegment::refills), 3);
        for (std::size_t i = 0; i < read->segments.size(); ++i) {
            QVERIFY(read->segments[i].samples == (*plan)->path.segments[i].samples);
        }
        const auto report = audit(auditInput(*read));
        VERIFY_RESULT(report);
        QVERIFY(std::ranges::none_of(report->findings, [](const AuditFinding& found) {
            return found.finding.kind == FindingKind::Refill;
        }));
    }
    void theReasonTellsIt() {
        const auto field = square();
        const auto plan = planned(field, onTheSpot(2.05), eightSwaths(pointText(*field, {-45.0, 3.0})));
        VERIFY_RESULT(plan);
        const auto told = explanations(**plan, {});
        VERIFY_RESULT(told);
        const auto route = std::ranges::find(*told, std::string_view{"route"}, &Explanation::step);
        QVERIFY(route != told->end());
        QVERIFY2(route->text.contains("3 refills, with") && route->text.contains("6 min of standing"),
                 route->text.c_str());
    }

    // Headland passes first, turns that fit, every pattern and every rule for ways, mounted and trailed,
    // tank and bunker.
    void staysInTheTank_data() {
        QTest::addColumn<QString>("machine");
        QTest::addColumn<QString>("operation");
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("value");
        for (const char* method :
             {"optimised", "boustrophedon", "snake", "spiral", "skip", "racetrack", "custom"}) {
            QTest::addRow("%s", method) << "agbot" << "spreading" << "route.method" << method;
        }
        for (const char* rule : {"interior", "headland", "boundary"}) {
            QTest::addRow("%s", rule) << "agbot" << "sowing" << "route.traversal" << rule;
        }
        QTest::newRow("may leave the field") << "agbot" << "spreading" << "path.stay_inside" << "false";
        QTest::newRow("headland not driven") << "agbot" << "spreading" << "headland.driven" << "false";
        QTest::newRow("trailed") << "orchard-sprayer" << "spraying" << "headland.order" << "inside-out";
        QTest::newRow("bunker") << "agbot" << "harvest" << "swaths.method" << "longest-edge";
    }
    void staysInTheTank() {
        QFETCH(QString, machine);
        QFETCH(QString, operation);
        QFETCH(QString, key);
        QFETCH(QString, value);
        const auto field = fieldOf({test::centredRectangle(90.0, 70.0)});
        // A headland pass round the field takes up to 300 m of its width.
        const Machine worked = findMachine(machine.toStdString()).value();
        const Machine driven = withTank(machine.toStdString(), 420.0 * worked.operatingWidth().si());
        Given given{{"operation.kind", operation.toStdString()}, {key.toStdString(), value.toStdString()}};
        if (value == "custom") {
            given = {{"operation.kind", operation.toStdString()}};
            const auto first = planned(field, driven, given);
            VERIFY_RESULT(first);
            std::string order;
            for (std::size_t i = 1; i <= (*first)->swaths.swaths.size(); ++i) {
                order += (i > 1 ? "," : "") +
                         std::to_string(i % 2 == 1 ? static_cast<int>(i) : -static_cast<int>(i));
            }
            given.emplace_back("route.method", "custom");
            given.emplace_back("route.order", order);
        }
        const auto without = planned(field, driven, given);
        given.emplace_back("route.refill",
                           pointText(*field, {-37.0, 0.0}) + "; " + pointText(*field, {39.0, 27.0}));
        const auto plan = planned(field, driven, given);
        VERIFY_RESULT(without);
        VERIFY_RESULT(plan);
        QVERIFY2(!has((*plan)->findings, FindingKind::Refill, Severity::Blocking),
                 blockingText(**plan).c_str());
        QVERIFY2((*plan)->blockingCount() <= (*without)->blockingCount(), blockingText(**plan).c_str());
        QCOMPARE_GT((*plan)->path.refillCount(), 0);
        checkTrips(**plan, **without);
    }

    // A tank that is smaller than one headland pass: the pass is interrupted.
    void interruptsHeadlandPasses() {
        const auto field = fieldOf({test::centredRectangle(90.0, 70.0)});
        const Machine machine = withTank("agbot", 100.0 * 2.5);
        Given given{{"operation.kind", "spreading"}};
        const auto without = planned(field, machine, given);
        given.emplace_back("route.refill", pointText(*field, {-37.0, 0.0}));
        const auto plan = planned(field, machine, given);
        VERIFY_RESULT(without);
        VERIFY_RESULT(plan);
        QVERIFY2((*plan)->drivable(), blockingText(**plan).c_str());
        checkTrips(**plan, **without);
        // Nothing is missed where a pass goes on.
        COMPARE_WITHIN((*plan)->audit.missed->si(), (*without)->audit.missed->si(), 5.0);
    }

    void onRandomFields() {
        std::mt19937_64 random{11};
        for (int i = 0; i < 8; ++i) {
            const test::Shape shape = i % 2 == 0 ? test::Shape::Convex : test::Shape::Concave;
            const auto field = fieldOf(test::randomPolygons(random, shape, 70.0));
            const Machine machine = withTank("agbot", test::uniform(random, 500.0, 3000.0));
            // Trips may make other headings and headlands the quickest; these are the same in both plans.
            Given given{{"operation.kind", i % 3 == 0 ? "harvest" : "spreading"},
                        {"swaths.method", "longest-edge"},
                        {"headland.passes", "2"}};
            const auto without = planned(field, machine, given);
            VERIFY_RESULT(without);
            // Where the drive begins there is room for the machine.
            given.emplace_back("route.refill",
                               pointText(*field, (*without)->path.segments.front().samples[0].position));
            const auto plan = planned(field, machine, given);
            VERIFY_RESULT(plan);
            QVERIFY2((*plan)->blockingCount() <= (*without)->blockingCount(), blockingText(**plan).c_str());
            if (!has((*plan)->findings, FindingKind::Refill, Severity::Blocking)) {
                checkTrips(**plan, **without);
            }
        }
    }
    // The same plan whatever the thread count.
    void sameWithOneThread() {
        const auto field = fieldOf({test::centredRectangle(90.0, 70.0)});
        const Machine machine = withTank("agbot", 800.0);
        Settings settings;
        for (const auto& [key, value] :
             Given{{"operation.kind", "spreading"}, {"route.refill", pointText(*field, {-37.0, 0.0})}}) {
            applySetting(settings, key, value).value();
        }
        const PlanRequest request{.field = field, .machine = machine, .settings = settings};
        JobContext one;
        one.threads = 1;
        const auto alone = makePlan(request, one);
        const auto both = makePlan(request);
        VERIFY_RESULT(alone);
        VERIFY_RESULT(both);
        QVERIFY((*alone)->path == (*both)->path);
    }
};

FURROW_TEST(RefillTest);
#include "tst_refill.moc"
