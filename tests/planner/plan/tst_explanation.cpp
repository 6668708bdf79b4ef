// What a plan says of itself: figures of other headings by hand, and the sentences.

#include "planner/machine/machine_library.h"
#include "planner/plan/explanation.h"
#include "planner/plan/method_registry.h"
#include "planner/swaths/methods.h"
#include "planner/units/angle.h"
#include "tests/support/field_generator.h"
#include "tests/support/real_fields.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace furrow;

namespace {

using Given = std::vector<std::pair<std::string, std::string>>;

// 204 m from west to east and 102 m from south to north: 17 or 34 swaths of 6 m fit exactly.
constexpr double kLongM = 204.0;
constexpr double kShortM = 102.0;

Result<std::shared_ptr<const Plan>> planOf(const FieldSource& source, const Given& given,
                                           const std::string& machine = "cultivator") {
    PlanRequest request{.field = std::make_shared<const Field>(Field::create(source).value()),
                        .machine = findMachine(machine).value(),
                        .settings = {}};
    for (const auto& [key, value] : given) {
        applySetting(request.settings, key, value).value();
    }
    return makePlan(request);
}

/// Without headland and margin: what is worked is the rectangle itself.
std::shared_ptr<const Plan> bareRectangle(Given given) {
    given.insert(given.end(), {{"headland.method", "none"},
                               {"path.stay_inside", "false"},
                               {"field.margin_m", "0"},
                               {"swaths.ends", "centre"}});
    return planOf(test::fieldSourceFromLocal({test::centredRectangle(kLongM, kShortM)}, {9.5, 51.5}), given)
        .value();
}

/// Of the samples and every sixth of the other fields.
const std::vector<std::shared_ptr<const Plan>>& somePlans() {
    static const std::vector<std::shared_ptr<const Plan>> plans = [] {
        std::vector<std::shared_ptr<const Plan>> made;
        const std::vector<FieldSource> fields = test::shippedFields();
        constexpr std::size_t kSamples = 6;
        for (std::size_t i = 0; i < fields.size(); i += i < kSamples ? 1 : 6) {
            if (auto plan = planOf(fields[i], {})) {
                made.push_back(*std::move(plan));
            }
        }
        return made;
    }();
    return plans;
}

const HeadingTrial& at(const HeadingCurve& curve, double bearingDeg) {
    return *std::ranges::min_element(curve.trials, {}, [bearingDeg](const HeadingTrial& trial) {
        return std::abs(lineBearingDeg(trial.heading) - bearingDeg);
    });
}

std::string textOf(const std::vector<Explanation>& all, std::string_view step) {
    const auto found = std::ranges::find(all, step, &Explanation::step);
    return found == all.end() ? std::string{} : found->text.text();
}

std::vector<Explanation> told(const Plan& plan) {
    return explanations(plan, headingCurve(plan).value()).value();
}

}  // namespace

class TestExplanation : public QObject {
    Q_OBJECT

private slots:
    void figuresOfHeadings();
    void tradeOffsAreBeatenByNone();
    void noCurveWithoutACommonHeading_data();
    void noCurveWithoutACommonHeading();
    void comparesHeadings();
    void preferredEdges();
    void comparesOrders();
    void saysWhatATurnNeeds();
    void speaksOfEveryShippedField();
    void cancelled();
};

void TestExplanation::figuresOfHeadings() {
    const auto plan = bareRectangle({});
    const auto curve = headingCurve(*plan);
    VERIFY_RESULT(curve);
    QVERIFY(curve->has_value());
    const HeadingCurve& all = **curve;
    // Every degree; the heading of the plan and the longest edge are 90 degrees but for the frame's rounding.
    QVERIFY(all.trials.size() >= 180 && all.trials.size() <= 182);
    QVERIFY(std::ranges::is_sorted(all.trials, {},
                                   [](const HeadingTrial& trial) { return lineBearingDeg(trial.heading); }));
    QVERIFY(std::abs(lineBearingDeg(all.trials[all.chosen].heading) - 90.0) < 0.01);
    QCOMPARE(all.quickest, all.chosen);
    const HeadingTrial& along = all.trials[all.chosen];
    const HeadingTrial& across = at(all, 0.0);
    QCOMPARE(along.figures.count, 17);
    QCOMPARE(across.figures.count, 34);
    COMPARE_WITHIN(along.figures.length.si(), 17 * kLongM, 0.1);
    COMPARE_WITHIN(across.figures.length.si(), 34 * kShortM, 0.1);
    COMPARE_WITHIN(along.missed.si(), 0.0, 1.0);
    // Every turn leads to the neighbour: 16 of them, and 33.
    COMPARE_WITHIN(across.turning.si() / along.turning.si(), 33.0 / 16.0, 0.01);
    // Swaths at 45 degrees end slantwise: land is missed or worked twice there.
    QVERIFY(at(all, 45.0).missed > squareMetres(100.0) ||
            at(all, 45.0).figures.overlap > squareMetres(100.0));
}

void TestExplanation::tradeOffsAreBeatenByNone() {
    for (const auto& plan : somePlans()) {
        const auto curve = headingCurve(*plan).value();
        if (!curve) {
            continue;
        }
        const auto& trials = curve->trials;
        QVERIFY(std::ranges::any_of(trials, &HeadingTrial::isTradeOff));
        for (const HeadingTrial& one : trials) {
            const bool beaten = std::ranges::any_of(trials, [&](const HeadingTrial& other) {
                return other.figures.count > 0 && one.figures.time - other.figures.time > seconds(0.1) &&
                       one.figures.overlap - other.figures.overlap > squareMetres(1.0) &&
                       one.missed - other.missed > squareMetres(1.0);
            });
            QVERIFY(!(one.isTradeOff && beaten));
        }
        QVERIFY(trials[curve->quickest].figures.time <= trials[curve->chosen].figures.time + seconds(0.05));
    }
}

void TestExplanation::noCurveWithoutACommonHeading_data() {
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("line");
    QTest::newRow("circles") << "pivot" << "POINT (9.5 51.5)";
    QTest::newRow("curve") << "ab-curve" << "LINESTRING (9.4985 51.5, 9.5 51.5002, 9.5015 51.5)";
}

void TestExplanation::noCurveWithoutACommonHeading() {
    QFETCH(QString, method);
    QFETCH(QString, line);
    const auto plan =
        bareRectangle({{"swaths.method", method.toStdString()}, {"swaths.line", line.toStdString()}});
    const auto curve = headingCurve(*plan);
    VERIFY_RESULT(curve);
    QVERIFY(!curve->has_value());
    QCOMPARE(textOf(explanations(*plan, *curve).value(), "swaths"), std::string{});
}

void TestExplanation::comparesHeadings() {
    const std::string best = textOf(told(*bareRectangle({})), "swaths");
    QVERIFY2(best.starts_with("90 degrees runs along the longest edge; no heading is quicker."),
             best.c_str());
    // Heading 90 is bearing 0: twice as many swaths.
    const std::string given =
        textOf(told(*bareRectangle({{"swaths.method", "fixed"}, {"swaths.angle_deg", "90"}})), "swaths");
    QVERIFY2(given.starts_with("0 degrees costs 17 swaths and "), given.c_str());
    QVERIFY2(
        given.contains(
            " more than the longest edge (90 degrees); by this estimate 90 degrees would save 17 swaths and "),
        given.c_str());
    const std::string fewest = textOf(told(*bareRectangle({{"swaths.objective", "swath-count"}})), "swaths");
    QVERIFY2(fewest.starts_with("No heading has fewer than 17 swaths. "), fewest.c_str());
}

/// A finding says that the edge is some seconds slower; the reason beside it must not deny that.
void TestExplanation::preferredEdges() {
    int preferred = 0;
    for (const auto& plan : somePlans()) {
        const std::string said = textOf(told(*plan), "swaths");
        const bool isPreferred = std::ranges::contains(plan->swaths.notes, kPreferEdge.key, &Note::where);
        QVERIFY2(!said.contains(isPreferred ? "no heading is quicker" : "no heading is much quicker"),
                 said.c_str());
        preferred += isPreferred && said.contains("no heading is much quicker") ? 1 : 0;
    }
    QVERIFY(preferred > 0);
}

void TestExplanation::comparesOrders() {
    const std::string best = textOf(told(*bareRectangle({})), "route");
    QVERIFY2(best.contains("with the pattern “"), best.c_str());
    QVERIFY2(best.contains("No order of these swaths "), best.c_str());
    // A pattern of one's own is compared with others, and nothing is proved of it.
    const std::string own = textOf(told(*bareRectangle({{"route.method", "boustrophedon"}})), "route");
    QVERIFY2(own.contains("with the pattern “"), own.c_str());
    QVERIFY2(!own.contains("pattern “To and fro”"), own.c_str());
}

void TestExplanation::saysWhatATurnNeeds() {
    const FieldSource source = test::shippedFields().front();
    const auto plan = planOf(source, {{"headland.passes", "3"}});
    VERIFY_RESULT(plan);
    const std::string three = textOf(told(**plan), "headland");
    QVERIFY2(three.starts_with("3 passes of 6.0 m: a turn of this machine, with a radius of 6.0 m, needs "),
             three.c_str());
    const auto one = planOf(source, {{"headland.passes", "1"}});
    VERIFY_RESULT(one);
    const std::string narrow = textOf(told(**one), "headland");
    QVERIFY2(narrow.starts_with("1 pass of 6.0 m: a turn to the next swath would need "), narrow.c_str());
    QCOMPARE(textOf(told(*bareRectangle({})), "headland").substr(0, 39),
             std::string{"There is no headland, as chosen. Turns "});
    const auto robot = planOf(source, {{"headland.method", "none"}}, "field-robot");
    VERIFY_RESULT(robot);
    QCOMPARE(textOf(told(**robot), "headland"),
             std::string{"There is no headland, as chosen. The machine turns on the spot inside the field."});
}

void TestExplanation::speaksOfEveryShippedField() {
    QVERIFY(somePlans().size() > 8);
    for (const auto& plan : somePlans()) {
        const std::vector<Explanation> all = told(*plan);
        for (const std::string_view step :
             {"headland", "swaths", "decomposition", "route", "path", "check"}) {
            const std::string text = textOf(all, step);
            QVERIFY2(!text.empty() || (plan->swaths.swaths.size() < 2 && step != "headland"),
                     (plan->field().name() + ": " + std::string{step}).c_str());
            QVERIFY2(text.empty() || text.ends_with('.'), text.c_str());
        }
    }
}

void TestExplanation::cancelled() {
    std::stop_source stop;
    stop.request_stop();
    const auto curve = headingCurve(*bareRectangle({}), {.stop = stop.get_token()});
    QVERIFY(!curve);
    QCOMPARE(curve.error().code, ErrorCode::Cancelled);
}

FURROW_TEST(TestExplanation);
#include "tst_explanation.moc"
