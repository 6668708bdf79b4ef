// Stages are not run again for equal inputs, and plans are the same with a cache and without.

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;

namespace {

constexpr GeoPoint kCentre{9.5, 51.5};

/// 100 m x 64 m with a bay, and with a mast that swaths go round.
std::shared_ptr<const Field> smallField() {
    MultiPolygon outline{
        {.outer = {{0, 0}, {100, 0}, {100, 64}, {62, 64}, {62, 44}, {42, 44}, {42, 64}, {0, 64}},
         .holes = {}}};
    outline.front().holes.push_back({{30, 28}, {30, 29}, {31, 29}, {31, 28}});
    return std::make_shared<const Field>(Field::create(test::fieldSourceFromLocal(outline, kCentre)).value());
}

using Given = std::vector<std::pair<std::string, std::string>>;

PlanRequest requestWith(const Given& given, std::string_view machine = "agbot") {
    static const std::shared_ptr<const Field> field = smallField();
    Settings settings;
    for (const auto& [key, value] : given) {
        applySetting(settings, key, value).value();
    }
    return {.field = field, .machine = findMachine(machine).value(), .settings = settings};
}

/// Values to try, as text.
std::vector<std::string> valuesOf(const Parameter& parameter) {
    std::vector<std::string> values;
    switch (parameter.kind) {
        case ParameterKind::Choice:
            for (const Choice& choice : parameter.choices) {
                values.emplace_back(choice.id);
            }
            return values;
        case ParameterKind::Flag: return {"true", "false"};
        case ParameterKind::Length:
        case ParameterKind::Angle:
        case ParameterKind::Percent:
        case ParameterKind::Count:
            return {std::to_string(static_cast<int>(std::clamp(2.0, parameter.min, parameter.max)))};
        default: return {};
    }
}

}  // namespace

class TestStageCache : public QObject {
    Q_OBJECT

private slots:
    void plansAreTheSame_data();
    void plansAreTheSame();
    void onlyWhatDependsIsRunAgain_data();
    void onlyWhatDependsIsRunAgain();
    void stagesTakeNoLongerThanThePlan();
    void cornersThatAreTheSameShareAHeadland();
    void whatComesToTheSameIsNotDrivenAgain_data();
    void whatComesToTheSameIsNotDrivenAgain();
    void cellsMatterToTurnsOfOneKind_data();
    void cellsMatterToTurnsOfOneKind();
    void anotherFieldIsNotMixedUp();
    void readsOfInnerStagesCount();

private:
    StageCache cache_;
};

void TestStageCache::plansAreTheSame_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    for (const Parameter* parameter : allParameters()) {
        for (const std::string& value : valuesOf(*parameter)) {
            QTest::addRow("%s=%s", std::string{parameter->key}.c_str(), value.c_str())
                << QString::fromStdString(std::string{parameter->key}) << QString::fromStdString(value);
        }
    }
}

void TestStageCache::plansAreTheSame() {
    QFETCH(QString, key);
    QFETCH(QString, value);
    const PlanRequest request = requestWith({{key.toStdString(), value.toStdString()}});
    // One cache for all rows: a stage that takes the result of a row before is what is looked for.
    const auto cached = makePlan(request, {}, &cache_);
    const auto alone = makePlan(request);
    QCOMPARE(cached.has_value(), alone.has_value());
    if (!alone) {
        QCOMPARE(cached.error(), alone.error());
        return;
    }
    QCOMPARE((*cached)->swaths.swaths, (*alone)->swaths.swaths);
    QCOMPARE((*cached)->route, (*alone)->route);
    QCOMPARE((*cached)->path, (*alone)->path);
    QCOMPARE((*cached)->audit, (*alone)->audit);
    QCOMPARE((*cached)->findings, (*alone)->findings);
    QCOMPARE((*cached)->instead, (*alone)->instead);
    QCOMPARE((*cached)->headland.mainland, (*alone)->headland.mainland);
}

void TestStageCache::onlyWhatDependsIsRunAgain_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::addColumn<bool>("headland");
    QTest::addColumn<bool>("swaths");
    QTest::addColumn<bool>("route");
    QTest::newRow("nothing") << "route.start" << "" << false << false << false;
    QTest::newRow("where ways lead, which the order depends on")
        << "route.traversal" << "boundary" << false << false << true;
    QTest::newRow("order") << "route.method" << "racetrack" << false << false << true;
    QTest::newRow("swaths") << "swaths.overlap_m" << "0.1" << false << true << true;
    QTest::newRow("headland") << "headland.passes" << "3" << true << true << true;
}

void TestStageCache::onlyWhatDependsIsRunAgain() {
    QFETCH(QString, key);
    QFETCH(QString, value);
    QFETCH(bool, headland);
    QFETCH(bool, swaths);
    QFETCH(bool, route);
    StageCache cache;
    // Other numbers of passes and other corners would be compared, each with what is quickest for it.
    Given given{{"headland.passes", "2"}, {"headland.corner", "rounded"}};
    VERIFY_RESULT(makePlan(requestWith(given), {}, &cache));
    if (!value.isEmpty()) {
        given.emplace_back(key.toStdString(), value.toStdString());
    }
    const auto plan = makePlan(requestWith(given), {}, &cache);
    VERIFY_RESULT(plan);
    const StageTimings& timings = (*plan)->timings;
    QCOMPARE(timings.headland > Duration{}, headland);
    QCOMPARE(timings.swaths > Duration{}, swaths);
    QCOMPARE(timings.route > Duration{}, route);
}

/// On one thread nothing is counted twice.
void TestStageCache::stagesTakeNoLongerThanThePlan() {
    const auto plan = makePlan(requestWith({}), {.stop = {}, .progress = {}, .threads = 1});
    VERIFY_RESULT(plan);
    const StageTimings& timings = (*plan)->timings;
    const Duration each[] = {timings.headland, timings.swaths, timings.route,
                             timings.path,     timings.audit,  timings.proof};
    Duration sum;
    for (const Duration one : each) {
        QVERIFY(one > Duration{});
        sum += one;
    }
    QVERIFY(sum <= timings.total);
}

/// The quickest kind of corner begins as a rounded one.
void TestStageCache::cornersThatAreTheSameShareAHeadland() {
    StageCache cache;
    const Given given{{"headland.passes", "2"}};
    VERIFY_RESULT(makePlan(requestWith(given), {}, &cache));
    Given rounded = given;
    rounded.emplace_back("headland.corner", "rounded");
    const auto plan = makePlan(requestWith(rounded), {}, &cache);
    VERIFY_RESULT(plan);
    QCOMPARE((*plan)->timings.headland, Duration{});
    QCOMPARE((*plan)->timings.swaths, Duration{});
}

// A rectangle is one cell, so the heading of each cell is that of all of them.
void TestStageCache::whatComesToTheSameIsNotDrivenAgain_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::addColumn<bool>("driven");
    QTest::newRow("heading of each cell") << "decomposition.heading" << "per-cell" << false;
    QTest::newRow("another order") << "route.method" << "racetrack" << true;
}

void TestStageCache::whatComesToTheSameIsNotDrivenAgain() {
    QFETCH(QString, key);
    QFETCH(QString, value);
    QFETCH(bool, driven);
    StageCache cache;
    Given given{{"headland.corner", "rounded"}, {"route.compare", "blocked"}};
    const auto plan = [&] {
        PlanRequest request = requestWith(given);
        request.field = std::make_shared<const Field>(
            Field::create(test::fieldSourceFromLocal({test::rectangle(100.0, 64.0)}, kCentre)).value());
        return makePlan(request, {}, &cache);
    };
    const auto first = plan();
    VERIFY_RESULT(first);
    QVERIFY((*first)->drivable());
    given.emplace_back(key.toStdString(), value.toStdString());
    const auto second = plan();
    VERIFY_RESULT(second);
    QCOMPARE((*second)->timings.path > Duration{}, driven);
    QCOMPARE((*second)->path == (*first)->path, !driven);
}

// A turn of the chosen kind belongs between swaths of one cell. Where any kind may be taken, the same order
// in other cells is the same path.
void TestStageCache::cellsMatterToTurnsOfOneKind_data() {
    QTest::addColumn<QString>("turn");
    QTest::addColumn<bool>("driven");
    QTest::newRow("any kind") << "best-feasible" << false;
    QTest::newRow("one kind") << "dubins" << true;
}

void TestStageCache::cellsMatterToTurnsOfOneKind() {
    QFETCH(QString, turn);
    QFETCH(bool, driven);
    StageCache cache;
    Given given{{"headland.corner", "rounded"},
                {"route.compare", "blocked"},
                {"swaths.method", "fixed"},
                {"swaths.angle_deg", "90"},
                {"path.method", turn.toStdString()}};
    const auto plan = [&](const char* cells) {
        Given with = given;
        with.emplace_back("decomposition.method", cells);
        PlanRequest request = requestWith(with);
        const MultiPolygon angled{
            {.outer = {{0, 0}, {100, 0}, {100, 40}, {50, 40}, {50, 64}, {0, 64}}, .holes = {}}};
        request.field =
            std::make_shared<const Field>(Field::create(test::fieldSourceFromLocal(angled, kCentre)).value());
        return makePlan(request, {}, &cache);
    };
    const auto any = plan("none");
    VERIFY_RESULT(any);
    std::string order;
    for (const Swath& swath : (*any)->swaths.swaths) {
        order += (order.empty() ? "" : ",") + std::to_string(swath.number);
    }
    given.emplace_back("route.method", "custom");
    given.emplace_back("route.order", order);
    const auto first = plan("none");
    VERIFY_RESULT(first);
    const auto second = plan("boustrophedon");
    VERIFY_RESULT(second);
    QCOMPARE((*first)->cells.cells.size(), std::size_t{1});
    QVERIFY((*second)->cells.cells.size() > 1);
    QCOMPARE((*second)->route, (*first)->route);
    QCOMPARE((*second)->timings.path > Duration{}, driven);
}

void TestStageCache::anotherFieldIsNotMixedUp() {
    StageCache cache;
    VERIFY_RESULT(makePlan(requestWith({}), {}, &cache));
    PlanRequest other = requestWith({});
    FieldSource source = other.field->source();
    source.obstacles.clear();
    source.parts.front().holes.clear();
    other.field = std::make_shared<const Field>(Field::create(source).value());
    const auto cached = makePlan(other, {}, &cache);
    const auto alone = makePlan(other);
    VERIFY_RESULT(cached);
    VERIFY_RESULT(alone);
    QCOMPARE((*cached)->path, (*alone)->path);
    other.machine = findMachine("field-robot").value();
    const auto withRobot = makePlan(other, {}, &cache);
    VERIFY_RESULT(withRobot);
    QVERIFY((*withRobot)->path != (*alone)->path);
}

// The headland along each edge asks the swath method for its ends: another method gives another headland.
void TestStageCache::readsOfInnerStagesCount() {
    StageCache cache;
    const Given perEdge{{"headland.method", "per-edge"}};
    VERIFY_RESULT(makePlan(requestWith(perEdge), {}, &cache));
    const Given turned{
        {"headland.method", "per-edge"}, {"swaths.method", "fixed"}, {"swaths.angle_deg", "30"}};
    const auto cached = makePlan(requestWith(turned), {}, &cache);
    const auto alone = makePlan(requestWith(turned));
    VERIFY_RESULT(cached);
    VERIFY_RESULT(alone);
    QCOMPARE((*cached)->headland.mainland, (*alone)->headland.mainland);
    QCOMPARE((*cached)->path, (*alone)->path);
}

FURROW_TEST(TestStageCache);
#include "tst_stage_cache.moc"
