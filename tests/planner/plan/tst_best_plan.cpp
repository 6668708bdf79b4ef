// The best plan: what it may change, what it keeps, what its table says. That no single change beats it is
// tested in the sweep of simpler choices.

#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/best_plan.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/quicker_choice.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

using namespace furrow;

namespace {

using Given = std::vector<std::pair<std::string, std::string>>;

PlanRequest requestOf(const FieldSource& source, std::string_view machine, const Given& given = {}) {
    PlanRequest request{.field = std::make_shared<const Field>(Field::create(source).value()),
                        .machine = findMachine(machine).value(),
                        .settings = {}};
    for (const auto& [key, value] : given) {
        applySetting(request.settings, key, value).value();
    }
    return request;
}

FieldSource sample(const std::string& name) {
    return readBoundaries(FURROW_SOURCE_DIR "/resources/sample_fields/" + name + ".geojson").value().front();
}

double timeS(const Plan& plan) {
    return timeForAll(plan.request.machine, plan.path, plan.audit).si();
}

std::vector<std::string_view> allIds() {
    std::vector<std::string_view> ids;
    for (const PlanChoice& choice : planChoices()) {
        ids.push_back(choice.id);
    }
    return ids;
}

}  // namespace

class TestBestPlan : public QObject {
    Q_OBJECT

private slots:
    void savesWhatItSays();
    void beginsWithThePlanAsAsked();
    void keepsWhatIsKept_data();
    void keepsWhatIsKept();
    void allKeptIsThePlanAsAsked();
    void ownOrderKeepsItsSwaths();
    void safetyAndAgronomyStay();
    void mendsAPlanThatCannotBeDriven();
    void tellsEachBetterPlan();
    void sameOnAnyNumberOfThreads();
    void plansAreComparedWhateverIsSet();
    void cancelled();
};

void TestBestPlan::savesWhatItSays() {
    const PlanRequest request = requestOf(sample("bend"), "cultivator");
    const auto asked = makePlan(request);
    const auto best = bestPlan({.request = request, .kept = {}, .onBetter = {}});
    VERIFY_RESULT(asked);
    VERIFY_RESULT(best);
    const ChoiceTable& table = *(*best)->choices;
    COMPARE_WITHIN(table.asked.si(), timeS(**asked), 0.001 * timeS(**asked));
    COMPARE_WITHIN(table.best.si(), timeS(**best), 0.0011 * timeS(**best));
    QVERIFY(timeS(**best) < timeS(**asked));
    // What was saved step by step adds up to the difference, but for steps that were taken back.
    double saved = 0.0;
    for (const TriedChoice& tried : table.tried) {
        if (tried.worth == TriedChoice::Worth::Taken) {
            saved += tried.difference.si();
        }
    }
    QVERIFY(saved > 0.0 && saved <= (table.asked - table.best).si() + 0.01);
    // An alternative that was told as slower is: planned from the settings of the best plan.
    int compared = 0;
    for (const TriedChoice& tried : table.tried) {
        if (tried.worth != TriedChoice::Worth::Slower || tried.choice != "headland-passes") {
            continue;
        }
        PlanRequest other = (*best)->request;
        for (const SettingChange& change : tried.changes) {
            applySetting(other.settings, change.key, change.value).value();
        }
        const auto made = makePlan(other);
        VERIFY_RESULT(made);
        COMPARE_WITHIN(timeS(**made), (table.best + tried.difference).si(), 0.002 * timeS(**best));
        ++compared;
    }
    QVERIFY(compared > 0);
    // The settings alone make the same plan again.
    const auto again = makePlan((*best)->request);
    VERIFY_RESULT(again);
    QCOMPARE(timeS(**again), timeS(**best));
    QVERIFY((*again)->path == (*best)->path);
}

// One pass of headland is the planner's own choice here: nothing is saved by it.
void TestBestPlan::beginsWithThePlanAsAsked() {
    const PlanRequest request = requestOf(sample("slanted_field"), "trailed-sprayer");
    const auto asked = makePlan(request);
    VERIFY_RESULT(asked);
    QCOMPARE((*asked)->headland.passes, 1);
    std::vector<double> told;
    const auto best =
        bestPlan({.request = request, .kept = {}, .onBetter = [&](const Settings&, Duration time) {
                      told.push_back(time.si());
                  }});
    VERIFY_RESULT(best);
    COMPARE_WITHIN((*best)->choices->asked.si(), timeS(**asked), 0.001 * timeS(**asked));
    COMPARE_WITHIN(told.front(), timeS(**asked), 0.001 * timeS(**asked));
    QVERIFY(std::ranges::is_sorted(told, std::ranges::greater{}));
    QVERIFY(timeS(**best) <= timeS(**asked));
}

void TestBestPlan::keepsWhatIsKept_data() {
    QTest::addColumn<QString>("id");
    for (const std::string_view id : allIds()) {
        QTest::newRow(std::string{id}.c_str()) << QString::fromStdString(std::string{id});
    }
}

void TestBestPlan::keepsWhatIsKept() {
    QFETCH(QString, id);
    const PlanRequest request = requestOf(sample("home_field"), "cultivator");
    std::vector<std::string_view> kept = allIds();
    const std::string only = id.toStdString();
    std::erase(kept, std::string_view{only});
    const auto best = bestPlan({.request = request, .kept = kept, .onBetter = {}});
    VERIFY_RESULT(best);
    for (const PlanChoice& choice : planChoices()) {
        QVERIFY2(choice.id == only || !isGiven(choice, (*best)->request.settings),
                 std::string{choice.id}.c_str());
    }
    for (const TriedChoice& tried : (*best)->choices->tried) {
        QCOMPARE(tried.choice, std::string_view{only});
    }
}

void TestBestPlan::allKeptIsThePlanAsAsked() {
    const PlanRequest request = requestOf(sample("home_field"), "cultivator");
    const auto best = bestPlan({.request = request, .kept = allIds(), .onBetter = {}});
    VERIFY_RESULT(best);
    QCOMPARE((*best)->choices->alternatives, std::size_t{0});
    QVERIFY((*best)->request.settings == request.settings);
    QVERIFY((*best)->path == makePlan(request).value()->path);
}

void TestBestPlan::ownOrderKeepsItsSwaths() {
    PlanRequest request = requestOf(test::fieldSourceFromLocal({test::rectangle(120.0, 90.0)}, {9.5, 51.5}),
                                    "cultivator", {{"route.locked", "1,2,3"}});
    const auto asked = makePlan(request);
    const auto best = bestPlan({.request = request, .kept = {}, .onBetter = {}});
    VERIFY_RESULT(asked);
    VERIFY_RESULT(best);
    QVERIFY((*asked)->swaths.swaths == (*best)->swaths.swaths);
    QCOMPARE((*best)->request.settings.numbers(**findParameter("route.locked")), (std::vector{1, 2, 3}));
}

void TestBestPlan::safetyAndAgronomyStay() {
    const Given given{{"operation.kind", "sowing"}, {"field.margin_m", "0.5"}, {"swaths.overlap_m", "0.2"}};
    const PlanRequest request = requestOf(sample("home_field"), "cultivator", given);
    const auto best = bestPlan({.request = request, .kept = {}, .onBetter = {}});
    VERIFY_RESULT(best);
    for (const Parameter* const parameter : allParameters()) {
        const std::string_view key = parameter->key;
        const bool mayChange = std::ranges::any_of(planChoices(), [&](const PlanChoice& choice) {
            Settings one;
            one.add((*best)->request.settings);
            for (const Parameter* const other : allParameters()) {
                if (other != parameter) {
                    one.clear(*other);
                }
            }
            return isGiven(choice, one);
        });
        QVERIFY2(
            mayChange || (*best)->request.settings.value(*parameter) == request.settings.value(*parameter),
            std::string{key}.c_str());
    }
    for (const char* key : {"headland.when", "route.traversal", "path.method", "path.stay_inside",
                            "headland.driven", "headland.finish", "swaths.min_length_m"}) {
        const Parameter& parameter = **findParameter(key);
        QVERIFY2((*best)->request.settings.value(parameter) == request.settings.value(parameter), key);
    }
    QVERIFY((*best)->request.settings.choice(**findParameter("swaths.last_pass")) != "gap");
}

void TestBestPlan::mendsAPlanThatCannotBeDriven() {
    // One pass of headland has no room for the turns of a cultivator; the number is not kept here.
    const PlanRequest request = requestOf(sample("bend"), "cultivator", {{"headland.passes", "1"}});
    const auto best = bestPlan({.request = request, .kept = {}, .onBetter = {}});
    VERIFY_RESULT(best);
    QVERIFY((*best)->choices->askedProblems > 0);
    QVERIFY((*best)->drivable());
    QVERIFY((*best)->headland.passes > 1);
}

void TestBestPlan::tellsEachBetterPlan() {
    const PlanRequest request = requestOf(sample("bend"), "cultivator");
    std::vector<double> times;
    Settings last;
    const auto best =
        bestPlan({.request = request, .kept = {}, .onBetter = [&](const Settings& settings, Duration time) {
                      times.push_back(time.si());
                      last = settings;
                  }});
    VERIFY_RESULT(best);
    QVERIFY(times.size() > 1);
    QVERIFY(std::ranges::is_sorted(times, std::greater{}));
    COMPARE_WITHIN(times.back(), timeS(**best), 0.0011 * timeS(**best));
    QVERIFY(last == (*best)->request.settings);
}

void TestBestPlan::sameOnAnyNumberOfThreads() {
    const PlanRequest request = requestOf(sample("bend"), "cultivator");
    const auto one = bestPlan({.request = request, .kept = {}, .onBetter = {}},
                              {.stop = {}, .progress = {}, .threads = 1});
    const auto four = bestPlan({.request = request, .kept = {}, .onBetter = {}},
                               {.stop = {}, .progress = {}, .threads = 4});
    VERIFY_RESULT(one);
    VERIFY_RESULT(four);
    QVERIFY((*one)->path == (*four)->path);
    QCOMPARE((*one)->choices->tried.size(), (*four)->choices->tried.size());
}

// Who asks for the best plan does not want fewer plans to be looked at.
void TestBestPlan::plansAreComparedWhateverIsSet() {
    const auto best = [](const Given& given) {
        return bestPlan(
            {.request = requestOf(sample("bend"), "cultivator", given), .kept = {}, .onBetter = {}});
    };
    const auto always = best({});
    const auto blocked = best({{"route.compare", "blocked"}});
    VERIFY_RESULT(always);
    VERIFY_RESULT(blocked);
    QVERIFY((*always)->path == (*blocked)->path);
    QCOMPARE((*always)->choices->asked.si(), (*blocked)->choices->asked.si());
}

void TestBestPlan::cancelled() {
    std::stop_source stop;
    const PlanRequest request = requestOf(sample("bend"), "cultivator");
    const auto best = bestPlan(
        {.request = request, .kept = {}, .onBetter = [&](const Settings&, Duration) { stop.request_stop(); }},
        {.stop = stop.get_token(), .progress = {}, .threads = 0});
    QVERIFY(!best.has_value());
    QCOMPARE(best.error().code, ErrorCode::Cancelled);
}

FURROW_TEST(TestBestPlan);
#include "tst_best_plan.moc"
