#include "planner/headland/headland_passes.h"
#include "planner/headland/methods.h"
#include "planner/plan/draft.h"
#include "planner/plan/method_registry.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/stages.h"
#include "tests/support/test_program.h"

#include <QTest>

using namespace furrow;
using test::agbot;

namespace {

std::shared_ptr<const Field> fieldOf(const Ring& outer) {
    return std::make_shared<const Field>(
        Field::create(test::fieldSourceFromLocal({{.outer = outer, .holes = {}}}, GeoPoint{9.2, 51.3}))
            .value());
}

}  // namespace

class TestDraft : public QObject {
    Q_OBJECT

private slots:
    void aDraftKeepsHeadingAndHeadlandAndIsNotMeasured() {
        PlanRequest request{.field = fieldOf({{0, 0}, {400, 60}, {380, 300}, {-30, 250}}),
                            .machine = agbot(),
                            .settings = {}};
        const auto whole = makePlan(request);
        VERIFY_RESULT(whole);
        QVERIFY((*whole)->audit.coveredShare.has_value());
        // A corner is moved: the draft goes on from the plan before.
        request.field = fieldOf({{0, 0}, {420, 80}, {380, 300}, {-30, 250}});
        const auto draft = makePlan(draftOf(request, whole->get()));
        VERIFY_RESULT(draft);
        QVERIFY((*draft)->request.draft);
        COMPARE_WITHIN(inDegrees((*draft)->swaths.heading), inDegrees((*whole)->swaths.heading), 1e-6);
        QCOMPARE((*draft)->headland.width.si(), (*whole)->headland.width.si());
        QVERIFY((*draft)->headland.drivenPasses.empty());
        QVERIFY(!(*draft)->audit.coveredShare.has_value());
        QVERIFY((*draft)->path.length() > metres(1000.0));
        QVERIFY((*draft)->drivable());
        // The request of the whole plan is as it was.
        const auto again = makePlan(request);
        VERIFY_RESULT(again);
        QVERIFY(!(*again)->request.draft && (*again)->audit.coveredShare.has_value());
    }
    void whatTheUserChoseStays() {
        PlanRequest request{
            .field = fieldOf({{0, 0}, {400, 0}, {400, 300}, {0, 300}}), .machine = agbot(), .settings = {}};
        for (const auto& [key, text] : {std::pair{"headland.width_m", "20"},
                                        {"swaths.method", "fixed"},
                                        {"swaths.angle_deg", "30"},
                                        {"path.method", "dubins"},
                                        {"route.method", "snake"}}) {
            VERIFY_RESULT(applySetting(request.settings, key, text));
        }
        const PlanRequest draft = draftOf(request, nullptr);
        for (const char* key :
             {"headland.width_m", "swaths.method", "swaths.angle_deg", "path.method", "route.method"}) {
            const Parameter& parameter = **findParameter(key);
            QVERIFY2(draft.settings.value(parameter) == request.settings.value(parameter), key);
        }
        QVERIFY(!draft.settings.flag(kHeadlandDriven));
    }
    void anotherMachineHasItsOwnHeadland() {
        PlanRequest request{
            .field = fieldOf({{0, 0}, {400, 0}, {400, 300}, {0, 300}}), .machine = agbot(), .settings = {}};
        const auto whole = makePlan(request);
        VERIFY_RESULT(whole);
        request.machine = findMachine("mounted-drill").value();
        const PlanRequest draft = draftOf(request, whole->get());
        QVERIFY(!draft.settings.isSet(kHeadlandWidth));
    }
    void theOrderOfManySwathsGoesOn() {
        // 200 swaths, every second one out and the others back: curves that need not fit would make another
        // order of them.
        PlanRequest request{
            .field = fieldOf({{0, 0}, {520, 0}, {500, 90}, {0, 60}}), .machine = agbot(), .settings = {}};
        VERIFY_RESULT(applySetting(request.settings, "swaths.method", "fixed"));
        VERIFY_RESULT(applySetting(request.settings, "swaths.angle_deg", "90"));
        const auto whole = makePlan(request);
        VERIFY_RESULT(whole);
        request.field = fieldOf({{0, 0}, {520.5, 0}, {500, 92}, {0, 60}});
        const auto draft = makePlan(draftOf(request, whole->get()));
        VERIFY_RESULT(draft);
        QCOMPARE((*draft)->route.steps.size(), (*whole)->route.steps.size());
        QVERIFY((*draft)->route.steps == (*whole)->route.steps);
        // Without that plan, and with other settings, the order is a draft, too.
        const auto alone = makePlan(draftOf(request, nullptr));
        VERIFY_RESULT(alone);
        QVERIFY((*alone)->route.steps != (*whole)->route.steps);
        VERIFY_RESULT(applySetting(request.settings, "route.objective", "length"));
        QVERIFY(draftOf(request, whole->get()).earlier.empty());
    }
    void withoutAPlanBeforeNoHeadingIsSearched() {
        const PlanRequest request{
            .field = fieldOf({{0, 0}, {400, 0}, {400, 100}, {0, 100}}), .machine = agbot(), .settings = {}};
        const auto draft = makePlan(draftOf(request, nullptr));
        VERIFY_RESULT(draft);
        // Along the longest edge, from west to east.
        COMPARE_WITHIN(std::abs(std::sin((*draft)->swaths.heading.si())), 0.0, 1e-3);
        QVERIFY((*draft)->swaths.headingsTried <= 1);
    }
};

FURROW_TEST(TestDraft);
#include "tst_draft.moc"
