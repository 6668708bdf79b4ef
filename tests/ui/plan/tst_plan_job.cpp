// What a planning job hands over, and in which order: a draft, a first plan, the plan.

#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "tests/support/test_program.h"
#include "ui/plan/plan_job.h"

#include <QTest>

#include <condition_variable>
#include <mutex>

using namespace furrow;
using namespace std::chrono_literals;

namespace {

/// 9,000 headings.
PlanTask heavyTask() {
    const auto sources =
        readBoundaries(FURROW_SOURCE_DIR "/resources/sample_fields/home_field.geojson").value();
    PlanTask task{.source = std::make_shared<const FieldSource>(sources.front()),
                  .machine = findMachine("agbot").value(),
                  .settings = {}};
    applySetting(task.settings, "swaths.method", "brute-force").value();
    applySetting(task.settings, "swaths.step_deg", "0.02").value();
    return task;
}

struct HandedOver {
    std::mutex mutex;
    std::condition_variable came;
    std::vector<PlanOutcome> outcomes;

    std::function<void(PlanOutcome)> take() {
        return [this](PlanOutcome outcome) {
            const std::scoped_lock lock{mutex};
            outcomes.push_back(std::move(outcome));
            came.notify_all();
        };
    }
    void waitForOne() {
        std::unique_lock lock{mutex};
        came.wait(lock, [this] { return !outcomes.empty(); });
    }
};

}  // namespace

class TestPlanJob : public QObject {
    Q_OBJECT

private slots:
    void aDraftThenAFirstPlanThenThePlan() {
        const PlanTask task = heavyTask();
        HandedOver handed;
        StageCache cache;
        // However quick the machine, the plan does not go on before its draft is there.
        const JobContext job{.stop = {}, .progress = [&](double share) {
                                 if (share > 0.05) {
                                     handed.waitForOne();
                                 }
                             }};
        const PlanOutcome last =
            planned(task, cache, job, {.firstPlan = handed.take(), .firstPlanAfter = 0ms});
        QVERIFY(last.plan != nullptr);
        QVERIFY(!last.plan->request.draft);
        QCOMPARE(handed.outcomes.size(), std::size_t{2});
        const Plan& draft = *handed.outcomes[0].plan;
        QVERIFY(draft.request.draft && !isFirstPlan(draft));
        QVERIFY(!draft.audit.coveredShare.has_value());
        const Plan& first = *handed.outcomes[1].plan;
        QVERIFY(first.request.draft && isFirstPlan(first));
        QVERIFY(first.audit.coveredShare.has_value());
        for (const PlanOutcome& outcome : handed.outcomes) {
            QVERIFY(outcome.source == task.source);
            QVERIFY(!outcome.error && !outcome.drawing.isEmpty());
        }
        // The plan is the same as without anybody who looks at it meanwhile.
        StageCache fresh;
        const PlanOutcome alone = planned(task, fresh, {});
        QVERIFY(alone.plan->path == last.plan->path);
        QVERIFY(alone.plan->findings == last.plan->findings);
    }
    // A plan that is there before its draft is begun is not kept up by that.
    void noDraftOfWhatIsThereInTime() {
        PlanTask task = heavyTask();
        task.settings = {};
        HandedOver handed;
        StageCache cache;
        const PlanOutcome last =
            planned(task, cache, {}, {.firstPlan = handed.take(), .draftAfter = std::chrono::hours{1}});
        QVERIFY(last.plan != nullptr);
        for (const PlanOutcome& outcome : handed.outcomes) {
            QVERIFY(isFirstPlan(*outcome.plan));
        }
    }
    void stoppedBeforeItHasBegunHandsNothingOver() {
        std::stop_source stop;
        stop.request_stop();
        HandedOver handed;
        StageCache cache;
        const PlanOutcome outcome = planned(heavyTask(), cache, {.stop = stop.get_token(), .progress = {}},
                                            {.firstPlan = handed.take()});
        QVERIFY(outcome.plan == nullptr);
        QVERIFY(outcome.error && outcome.error->code == ErrorCode::Cancelled);
        QVERIFY(handed.outcomes.empty());
    }
    void whatCannotBePlannedHasNoDraft() {
        PlanTask task = heavyTask();
        FieldSource crossed = *task.source;
        auto& ring = crossed.parts.front().outer;
        ring = {{22.5, 58.25}, {22.507, 58.2535}, {22.507, 58.25}, {22.5, 58.2535}};
        task.source = std::make_shared<const FieldSource>(crossed);
        HandedOver handed;
        StageCache cache;
        const PlanOutcome outcome = planned(task, cache, {}, {.firstPlan = handed.take()});
        QVERIFY(outcome.error.has_value());
        QVERIFY(handed.outcomes.empty());
    }
};

FURROW_TEST(TestPlanJob);
#include "tst_plan_job.moc"
