// Results of plans that are kept when the plans are gone, and edits of many fields at once.

#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/project/plan_key.h"
#include "planner/project/plan_results.h"
#include "planner/project/project_edits.h"
#include "planner/swaths/methods.h"
#include "tests/planner/project/project_samples.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <array>

using namespace furrow;
using namespace furrow::test;

namespace {

FieldSource source(const std::string& name) {
    FieldSource field =
        readBoundaries(FURROW_SOURCE_DIR "/resources/sample_fields/home_field.geojson").value().front();
    field.name = name;
    return field;
}

PlanResult result(double hectares, int blocking = 0) {
    return {.area = squareMetres(1e4 * hectares),
            .duration = seconds(3600.5),
            .length = metres(12345.678901),
            .blocking = blocking};
}

}  // namespace

class TestPlanResults : public QObject {
    Q_OBJECT

private slots:
    void readBackAsTheyWere() {
        PlanResults results;
        results.keep("a", result(2.5));
        results.keep("b", result(0.1, 3));
        const PlanResults read = PlanResults::fromJson(results.json());
        QCOMPARE(read.size(), std::size_t{2});
        QVERIFY(*read.find("a") == result(2.5));
        QVERIFY(*read.find("b") == result(0.1, 3));
        QVERIFY(read.find("a")->drivable());
        QVERIFY(!read.find("b")->drivable());
        QVERIFY(read.find("c") == nullptr);
    }

    void whereTheyBelong() {
        PlanResults results;
        results.keep("a", result(2.5), "field-1");
        results.keep("b", result(0.1), "field-2");
        results.keep("c", result(0.1), "field-2");
        results.keep("d", result(0.1));
        const std::set<std::string> wanted{"field-1", "field-2"};
        QVERIFY(results.places() == wanted);
        QVERIFY(PlanResults::fromJson(results.json()).places() == wanted);
        // As it was written before there were places.
        std::string older = results.json();
        for (std::size_t at = older.find(",\"place\""); at != std::string::npos;
             at = older.find(",\"place\"")) {
            older.erase(at, older.find('}', at) - at);
        }
        const PlanResults read = PlanResults::fromJson(older);
        QCOMPARE(read.size(), std::size_t{4});
        QVERIFY(read.places().empty());
    }

    void whatIsDamagedIsForgotten() {
        PlanResults results;
        results.keep("a", result(2.5));
        const std::string good = results.json();
        for (const std::string& text :
             {std::string{}, std::string{"[]"}, std::string{"null"}, good.substr(0, good.size() / 2),
              std::string{R"({"version":"0.0.0","results":[]})"},
              std::string{R"({"version":)"} + R"(1,"results":[]})"}) {
            QCOMPARE(PlanResults::fromJson(text).size(), std::size_t{0});
        }
        // Plans of another version may be others.
        std::string older = good;
        older.replace(older.find("version\":\"") + 10, 1, "x");
        QCOMPARE(PlanResults::fromJson(older).size(), std::size_t{0});
        std::string wrong = good;
        wrong.replace(wrong.find("12345.678901"), 12, "\"far\"       ");
        QCOMPARE(PlanResults::fromJson(wrong).size(), std::size_t{0});
    }

    void theOldestGoFirst() {
        PlanResults results;
        for (std::size_t i = 0; i < PlanResults::kMost; ++i) {
            results.keep(std::to_string(i), result(1.0));
        }
        results.keep("0", result(2.0));
        results.keep("new", result(1.0));
        QCOMPARE(results.size(), PlanResults::kMost);
        QVERIFY(results.find("0") != nullptr);
        QVERIFY(results.find("1") == nullptr);
        // The order of their ages is read back, too.
        results = PlanResults::fromJson(results.json());
        results.keep("newer", result(1.0));
        QVERIFY(results.find("2") == nullptr);
        QVERIFY(results.find("3") != nullptr);
    }

    void ofAPlan() {
        const Project project = withFields(Project::empty(), {source("Home")});
        const auto plan =
            makePlan({.field = std::make_shared<const Field>(Field::create(*project.field()->source).value()),
                      .machine = project.plan().machine,
                      .settings = project.plan().settings})
                .value();
        const PlanResult result = resultOf(*plan);
        QCOMPARE(result.area.si(), plan->field().area().si());
        QCOMPARE(result.duration.si(), plan->path.duration().si());
        QCOMPARE(result.length.si(), plan->path.length().si());
        QCOMPARE(result.blocking, static_cast<int>(plan->blockingCount()));
    }

    /// Places of the one field stay there; review and order of the others stay with them.
    void manyFieldsAlike() {
        Project project = withFields(Project::empty(), {source("A"), source("B"), source("C")});
        project = showing(std::move(project), 2, 0);
        project = withReview(std::move(project), {.id = "r", .comments = {}});
        project = showing(std::move(project), 0, 0);
        Settings settings;
        settings.set(kOverlap, 0.3).value();
        QVERIFY(applySetting(settings, "swaths.method", "ab-line").has_value());
        QVERIFY(applySetting(settings, "swaths.line", "LINESTRING (22.5 58.25, 22.507 58.25)").has_value());
        const Machine machine = machineLibrary().back();
        project = withPlan(std::move(project), machine, settings);
        const Project alike = withPlansLike(project, std::array<std::size_t, 2>{0, 2}, project.plan());
        // The example itself is not touched, and neither is what was not chosen.
        QVERIFY(alike.fields[0] == project.fields[0]);
        QVERIFY(alike.fields[1] == project.fields[1]);
        const FieldPlan& third = alike.fields[2]->plans.front();
        QVERIFY(third.machine == machine);
        QCOMPARE(third.settings.value(kOverlap), SettingValue{0.3});
        QVERIFY(!third.settings.isSet(**findParameter("swaths.line")));
        QVERIFY(third.settings.choice(**findParameter("swaths.method")) != "ab-line");
        QCOMPARE(third.id, project.fields[2]->plans.front().id);
        QCOMPARE(third.review.id, std::string{"r"});
    }

    void aPlanForEach() {
        Project project = withFields(Project::empty(), {source("A"), source("B"), source("C")});
        project = showing(std::move(project), 1, 0);
        project = withPlanCopy(std::move(project), "Second");
        QCOMPARE(project.currentPlan, std::size_t{1});
        project = withPlansAdded(std::move(project), std::array<std::size_t, 2>{0, 1}, "Drilling", "2027");
        QCOMPARE(project.fields[0]->plans.size(), std::size_t{2});
        QCOMPARE(project.fields[1]->plans.size(), std::size_t{3});
        QCOMPARE(project.fields[2]->plans.size(), std::size_t{1});
        QCOMPARE(project.plan().name, std::string{"Drilling"});
        QCOMPARE(project.planOf(0).season, std::string{"2027"});
        QCOMPARE(project.planOf(2).name, std::string{});
        std::set<std::string> ids;
        for (const auto& field : project.fields) {
            for (const FieldPlan& plan : field->plans) {
                ids.insert(plan.id);
            }
        }
        QCOMPARE(ids.size(), std::size_t{6});
    }
};

FURROW_TEST(TestPlanResults);
#include "tst_plan_results.moc"
