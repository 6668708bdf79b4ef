// What differs between two plans of a field.

#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan_difference.h"
#include "tests/support/field_generator.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace furrow;

namespace {

using Given = std::vector<std::pair<std::string, std::string>>;

/// 204 m from west to east and 102 m from south to north, worked 6 m wide without headland and margin.
std::shared_ptr<const Plan> bareRectangle(Given given, const char* machine = "cultivator") {
    given.insert(given.end(), {{"headland.method", "none"},
                               {"path.stay_inside", "false"},
                               {"field.margin_m", "0"},
                               {"swaths.ends", "centre"}});
    PlanRequest request{
        .field = std::make_shared<const Field>(
            Field::create(test::fieldSourceFromLocal({test::centredRectangle(204.0, 102.0)}, {9.5, 51.5}))
                .value()),
        .machine = findMachine(machine).value(),
        .settings = {}};
    for (const auto& [key, value] : given) {
        applySetting(request.settings, key, value).value();
    }
    return makePlan(request).value();
}

const Given kEast{{"swaths.method", "fixed"}, {"swaths.angle_deg", "0"}};
const Given kNorth{{"swaths.method", "fixed"}, {"swaths.angle_deg", "90"}};

}  // namespace

class TestPlanDifference : public QObject {
    Q_OBJECT

private slots:
    void noneOfAPlanAndItself() {
        const auto plan = bareRectangle(kEast);
        const PlanDifference difference = differenceOf(*plan, *plan);
        QVERIFY(!difference.machine);
        QVERIFY(difference.settings.empty());
        QVERIFY(difference.onlyInFirst.empty() && difference.onlyInSecond.empty());
        QVERIFY(difference.drivenOnlyInFirst.empty() && difference.drivenOnlyInSecond.empty());
        for (const Figure figure : kFigures) {
            QCOMPARE(better(figure, figureOf(*plan, figure), figureOf(*plan, figure)), 0);
        }
    }

    /// 17 swaths of 204 m, or 34 of 102 m: no swath is in both.
    void anotherHeading() {
        const auto east = bareRectangle(kEast);
        const auto north = bareRectangle(kNorth);
        QCOMPARE(figureOf(*east, Figure::Swaths), std::optional{17.0});
        QCOMPARE(figureOf(*north, Figure::Swaths), std::optional{34.0});
        const PlanDifference difference = differenceOf(*east, *north);
        QCOMPARE(difference.onlyInFirst.size(), std::size_t{17});
        QCOMPARE(difference.onlyInSecond.size(), std::size_t{34});
        QCOMPARE(difference.settings.size(), std::size_t{1});
        QCOMPARE(difference.settings.front().parameter->key, std::string_view{"swaths.angle_deg"});
        // Twice the turns take longer.
        QCOMPARE(better(Figure::Time, figureOf(*east, Figure::Time), figureOf(*north, Figure::Time)), -1);
        QCOMPARE(better(Figure::Time, figureOf(*north, Figure::Time), figureOf(*east, Figure::Time)), 1);
        QCOMPARE(better(Figure::Swaths, 17.0, 34.0), 0);
    }

    /// The same swaths in another order and direction are the same swaths.
    void anotherOrder() {
        const auto first = bareRectangle(kEast);
        Given given = kEast;
        given.push_back({"route.method", "skip"});
        const auto second = bareRectangle(given);
        const PlanDifference difference = differenceOf(*first, *second);
        QVERIFY(difference.onlyInFirst.empty() && difference.onlyInSecond.empty());
        QCOMPARE(difference.settings.front().parameter->key, std::string_view{"route.method"});
    }

    /// In another order other ways lead from swath to swath; all of them lie at the ends of the swaths, which
    /// are 102 m from the middle, or beyond. The tractor is some metres before its implement there.
    void otherTurns() {
        const auto first = bareRectangle(kEast);
        Given given = kEast;
        given.push_back({"route.method", "skip"});
        const PlanDifference difference = differenceOf(*first, *bareRectangle(given));
        for (const auto* stretches : {&difference.drivenOnlyInFirst, &difference.drivenOnlyInSecond}) {
            QVERIFY(!stretches->empty());
            QCOMPARE(lengthOf(*stretches, true).si(), 0.0);
            for (const DifferentStretch& stretch : *stretches) {
                QVERIFY(!stretch.worked);
                for (const Point place : stretch.line) {
                    QVERIFY2(std::abs(place.x) > 97.0, qPrintable(QString::number(place.x)));
                }
            }
        }
        // None of them is longer than all that is driven beside the swaths.
        const Path& path = first->path;
        QVERIFY(lengthOf(difference.drivenOnlyInFirst, false) <= path.length() - path.workedLength());
    }

    /// One headland pass more: the outer ones are in both plans, the innermost in one of them only.
    void onePassMore() {
        const auto plan = [](const char* passes) {
            PlanRequest request{.field = std::make_shared<const Field>(
                                    Field::create(test::fieldSourceFromLocal(
                                                      {test::centredRectangle(204.0, 102.0)}, {9.5, 51.5}))
                                        .value()),
                                .machine = findMachine("cultivator").value(),
                                .settings = {}};
            for (const auto& [key, value] : Given{{"headland.method", "constant"},
                                                  {"headland.width_m", passes},
                                                  {"field.margin_m", "0"},
                                                  {"swaths.method", "fixed"},
                                                  {"swaths.angle_deg", "0"}}) {
                applySetting(request.settings, key, value).value();
            }
            return makePlan(request).value();
        };
        const auto two = plan("12");
        const auto three = plan("18");
        const PlanDifference difference = differenceOf(*two, *three);
        const double passTwo = two->path.length(SegmentKind::HeadlandPass).si();
        const double passThree = three->path.length(SegmentKind::HeadlandPass).si();
        QVERIFY(passThree > passTwo + 300.0);
        QCOMPARE(lengthOf(difference.drivenOnlyInFirst, true).si(), 0.0);
        QVERIFY(std::abs(lengthOf(difference.drivenOnlyInSecond, true).si() - (passThree - passTwo)) < 10.0);
        // The mainland is what is left of 204 m by 102 m inside 12 m and 18 m.
        QVERIFY(std::abs(*figureOf(*two, Figure::Mainland) - 180.0 * 78.0) < 1.0);
        QVERIFY(std::abs(*figureOf(*three, Figure::Mainland) - 168.0 * 66.0) < 1.0);
        QCOMPARE(better(Figure::Mainland, 100.0, 50.0), 0);
    }

    void anotherMachine() {
        QVERIFY(differenceOf(*bareRectangle(kEast), *bareRectangle(kEast, "agbot")).machine);
    }

    void lessMissedAndMoreCoveredIsBetter() {
        QCOMPARE(better(Figure::Missed, 100.0, 50.0), 1);
        QCOMPARE(better(Figure::Covered, 100.0, 50.0), -1);
        QCOMPARE(better(Figure::Problems, 0.0, 3.0), -1);
        // Nobody sees half a square metre, and what was not measured is not compared.
        QCOMPARE(better(Figure::Missed, 100.0, 100.5), 0);
        QCOMPARE(better(Figure::Missed, std::nullopt, 1.0), 0);
    }
};

FURROW_TEST(TestPlanDifference);
#include "tst_plan_difference.moc"
