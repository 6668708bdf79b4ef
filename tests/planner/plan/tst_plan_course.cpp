// What is told of a plan while it is made: the share of the work, the plan as asked, how many are compared.

#include "planner/io/import/boundary_import.h"
#include "planner/jobs/shared_progress.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/advice.h"
#include "planner/plan/draft.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan_course.h"
#include "planner/route/patterns.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <atomic>
#include <mutex>
#include <set>

using namespace furrow;

namespace {

PlanRequest requestFor(const std::string& field, std::string_view machine) {
    const auto sources =
        readBoundaries(FURROW_SOURCE_DIR "/resources/sample_fields/" + field + ".geojson").value();
    return {.field = std::make_shared<const Field>(Field::create(sources.front()).value()),
            .machine = findMachine(machine).value(),
            .settings = {}};
}

/// Remembers what a job tells, from whichever thread.
struct Teller {
    std::mutex mutex;
    std::vector<double> shares;

    JobContext job(int threads) {
        return {.stop = {},
                .progress =
                    [this](double share) {
                        const std::scoped_lock lock{mutex};
                        shares.push_back(share);
                    },
                .threads = threads};
    }
    bool isRising() const { return std::ranges::is_sorted(shares); }
    std::size_t percents() const {
        std::set<int> values;
        for (const double share : shares) {
            values.insert(static_cast<int>(100.0 * share));
        }
        return values.size();
    }
};

}  // namespace

class TestPlanCourse : public QObject {
    Q_OBJECT

private slots:
    void piecesAtOnceHaveTheirShare() {
        Teller told;
        SharedProgress progress{4, told.job(1).part(0.2, 0.6)};
        progress.piece(2).report(0.5);
        // By hand: 0.2 + 0.4 * (0.5 / 4).
        QVERIFY(std::abs(told.shares.back() - 0.25) < 1e-12);
        progress.piece(0).part(0.0, 0.5).report(1.0);
        QVERIFY(std::abs(told.shares.back() - 0.3) < 1e-12);
        // Nothing goes back.
        const std::size_t before = told.shares.size();
        progress.piece(2).report(0.1);
        QCOMPARE(told.shares.size(), before);
        for (std::size_t i = 0; i < 4; ++i) {
            progress.finish(i);
        }
        QVERIFY(std::abs(told.shares.back() - 0.6) < 1e-12);
        QVERIFY(told.isRising());
        SharedProgress silent{1, JobContext{}};
        QVERIFY(!silent.piece(0).progress);
    }

    void sharesRiseEvenly_data() {
        QTest::addColumn<std::string>("field");
        QTest::addColumn<std::string>("machine");
        QTest::addColumn<int>("threads");
        for (const int threads : {1, 2}) {
            QTest::addRow("robot, %d threads", threads)
                << std::string{"home_field"} << std::string{"agbot"} << threads;
            QTest::addRow("sprayer, %d threads", threads)
                << std::string{"slanted_field"} << std::string{"trailed-sprayer"} << threads;
            QTest::addRow("ponds, %d threads", threads)
                << std::string{"three_ponds"} << std::string{"cultivator"} << threads;
        }
    }
    void sharesRiseEvenly() {
        QFETCH(std::string, field);
        QFETCH(std::string, machine);
        QFETCH(int, threads);
        const PlanRequest request = requestFor(field, machine);
        Teller told;
        const auto plan = makePlan(request, told.job(threads));
        VERIFY_RESULT(plan);
        QVERIFY(!told.shares.empty());
        QVERIFY(told.isRising());
        QCOMPARE(told.shares.back(), 1.0);
        QVERIFY2(told.percents() > 25,
                 QByteArray::number(static_cast<qulonglong>(told.percents())).constData());
    }

    void thePlanAsAskedIsToldOnceAndWhole() {
        const PlanRequest request = requestFor("home_field", "agbot");
        std::vector<std::shared_ptr<const Plan>> first;
        std::mutex mutex;
        std::vector<std::pair<std::size_t, std::size_t>> counts;
        const PlanCourse course{.firstPlan = [&](const auto& plan) { first.push_back(plan); },
                                .compared =
                                    [&](std::size_t done, std::size_t known) {
                                        const std::scoped_lock lock{mutex};
                                        counts.emplace_back(done, known);
                                    }};
        const auto plan = makePlan(request, {}, nullptr, course);
        VERIFY_RESULT(plan);
        QCOMPARE(first.size(), std::size_t{1});
        QVERIFY(first.front()->request.draft && isFirstPlan(*first.front()));
        QVERIFY(first.front()->audit.coveredShare.has_value());
        QVERIFY(first.front()->instead.empty());
        QVERIFY(!(*plan)->request.draft && !isFirstPlan(**plan));
        // By the time in which plans are compared, the finished one is as good at the least.
        QVERIFY(timeForAll((*plan)->request.machine, (*plan)->path, (*plan)->audit) <=
                timeForAll(request.machine, first.front()->path, first.front()->audit));
        // A robot that cannot reverse has another kind of corner at the least.
        QVERIFY(!counts.empty());
        for (std::size_t i = 0; i < counts.size(); ++i) {
            QCOMPARE(counts[i].first, i + 1);
            QVERIFY(counts[i].second >= counts[i].first);
            QVERIFY(i == 0 || counts[i].second >= counts[i - 1].second);
        }
        QCOMPARE(counts.back().first, counts.back().second);
        // Who listens changes nothing.
        const auto unheard = makePlan(request);
        VERIFY_RESULT(unheard);
        QVERIFY((*unheard)->path == (*plan)->path);
        QVERIFY((*unheard)->route == (*plan)->route);
    }

    void plansAreComparedWhereTheFirstCannotBeDriven_data() {
        QTest::addColumn<std::string>("field");
        QTest::addColumn<std::string>("machine");
        QTest::addColumn<std::string>("passes");
        QTest::addColumn<bool>("isCompared");
        QTest::newRow("drivable at once")
            << std::string{"home_field"} << std::string{"agbot"} << std::string{"auto"} << false;
        // One pass has no room for the turns of a cultivator.
        QTest::newRow("blocked") << std::string{"long_strip"} << std::string{"cultivator"} << std::string{"1"}
                                 << true;
    }
    void plansAreComparedWhereTheFirstCannotBeDriven() {
        QFETCH(const std::string, field);
        QFETCH(const std::string, machine);
        QFETCH(const std::string, passes);
        PlanRequest request = requestFor(field, machine);
        VERIFY_RESULT(applySetting(request.settings, "headland.passes", passes));
        const auto always = makePlan(request);
        VERIFY_RESULT(always);
        VERIFY_RESULT(applySetting(request.settings, "route.compare", "blocked"));
        std::atomic<int> compared = 0;
        std::shared_ptr<const Plan> first;
        const auto plan = makePlan(request, {}, nullptr,
                                   {.firstPlan = [&](const auto& asked) { first = asked; },
                                    .compared = [&](std::size_t, std::size_t) { ++compared; }});
        VERIFY_RESULT(plan);
        QTEST(compared > 0, "isCompared");
        const auto timeOf = [](const Plan& one) {
            return timeForAll(one.request.machine, one.path, one.audit);
        };
        QVERIFY((*always)->blockingCount() <= (*plan)->blockingCount());
        if (compared == 0) {
            QVERIFY((*plan)->drivable());
            QVERIFY((*plan)->path == first->path && (*plan)->instead.empty());
            QVERIFY(timeOf(**always) <= timeOf(**plan));
        } else {
            // Nothing is given up for speed where the plan needs it.
            QVERIFY((*plan)->path == (*always)->path);
        }
    }

    // Of few swaths several patterns are the same order. Nothing but the order is left to the planner here.
    void equalOrdersAreDrivenOnce_data() {
        QTest::addColumn<int>("swaths");
        for (const int swaths : {2, 4, 6, 10}) {
            QTest::addRow("%d swaths", swaths) << swaths;
        }
    }
    void equalOrdersAreDrivenOnce() {
        QFETCH(const int, swaths);
        const Machine machine = findMachine("cultivator").value();
        const double heightM = 2.0 * 24.0 + (swaths - 0.01) * machine.operatingWidth().si();
        PlanRequest request{
            .field = std::make_shared<const Field>(
                Field::create(test::fieldSourceFromLocal({test::rectangle(200.0, heightM)}, {9.0, 51.0}))
                    .value()),
            .machine = machine,
            .settings = {}};
        for (const auto& [key, value] : {std::pair{"headland.width_m", "24"},
                                         {"headland.corner", "rounded"},
                                         {"swaths.method", "fixed"},
                                         {"swaths.angle_deg", "0"}}) {
            VERIFY_RESULT(applySetting(request.settings, key, value));
        }
        std::atomic<std::size_t> compared = 0;
        const auto plan =
            makePlan(request, {}, nullptr,
                     {.firstPlan = {}, .compared = [&](std::size_t, std::size_t) { ++compared; }});
        VERIFY_RESULT(plan);
        QCOMPARE((*plan)->route.steps.size(), static_cast<std::size_t>(swaths));
        VERIFY_RESULT(applySetting(request.settings, "route.compare", "blocked"));
        std::vector<Route> orders;
        const auto addOrder = [&] {
            const auto asked = makePlan(request);
            VERIFY_RESULT(asked);
            if (!std::ranges::contains(orders, (*asked)->route)) {
                orders.push_back((*asked)->route);
            }
        };
        addOrder();
        for (const auto* const pattern : routePatterns()) {
            VERIFY_RESULT(applySetting(request.settings, "route.method", std::string{pattern->info.id}));
            addOrder();
        }
        QVERIFY(compared < orders.size());
    }

    void aDraftTellsNoFirstPlan() {
        int told = 0;
        const auto draft = makePlan(draftOf(requestFor("home_field", "agbot"), nullptr), {}, nullptr,
                                    {.firstPlan = [&](const auto&) { ++told; },
                                     .compared = [&](std::size_t, std::size_t) { ++told; }});
        VERIFY_RESULT(draft);
        QVERIFY((*draft)->request.draft && !isFirstPlan(**draft));
        QCOMPARE(told, 0);
    }

    void adviceGoesOnEvenly() {
        PlanRequest request = requestFor("home_field", "cultivator");
        // No room to turn: each of the changes that might mend it is planned.
        VERIFY_RESULT(applySetting(request.settings, "headland.width_m", "1"));
        const auto plan = makePlan(request);
        VERIFY_RESULT(plan);
        QVERIFY(!(*plan)->drivable());
        Teller told;
        const auto advised = withAdvice(*plan, told.job(1));
        VERIFY_RESULT(advised);
        QVERIFY(told.isRising());
        QVERIFY(told.percents() > 20);
    }
};

FURROW_TEST(TestPlanCourse);
#include "tst_plan_course.moc"
