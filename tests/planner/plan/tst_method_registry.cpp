#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/settings/operation.h"
#include "tests/support/field_generator.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <algorithm>
#include <array>
#include <format>
#include <set>

using namespace furrow;

namespace {

struct ContractRow {
    std::string_view key;
    std::vector<std::string_view> ids;
};

// What settings files of others rely on: the ids of every method in their order, the default of those that
// exist first.
const std::array kContract{
    ContractRow{"headland.method", {"constant", "per-edge", "none"}},
    ContractRow{"decomposition.method", {"merged", "boustrophedon", "trapezoidal", "none"}},
    ContractRow{"swaths.method",
                {"exact", "brute-force", "fixed", "ab-line", "a-plus", "longest-edge", "edge", "oksanen",
                 "ab-curve", "contour", "pivot", "rows"}},
    ContractRow{"route.method",
                {"optimised", "boustrophedon", "snake", "spiral", "skip", "racetrack", "custom"}},
    ContractRow{"path.method",
                {"best-feasible", "dubins", "reeds-shepp", "dubins-cc", "reeds-shepp-cc", "u", "omega", "p",
                 "fishtail", "three-point", "straight"}},
};

// The values of choices that are not methods, which they rely on, too, default first.
const std::array kContractChoices{
    ContractRow{"operation.kind", {"tillage", "sowing", "spraying", "spreading", "mowing", "harvest"}},
    ContractRow{"swaths.objective", {"time", "swath-count", "swath-length", "coverage", "overlap"}},
    ContractRow{"swaths.last_pass", {"overlap", "spread", "gap"}},
    ContractRow{"swaths.ends", {"full", "centre"}},
    ContractRow{"route.corner", {"best", "first"}},
    ContractRow{"headland.order", {"outside-in", "inside-out"}},
    ContractRow{"headland.when", {"before", "after"}},
    ContractRow{"route.traversal", {"interior", "headland", "boundary"}},
};

std::shared_ptr<const Field> rectangleField() {
    const auto source = test::fieldSourceFromLocal({test::centredRectangle(200.0, 120.0)}, {9.5, 51.5});
    return std::make_shared<const Field>(Field::create(source).value());
}

/// Five rows 5 m apart, and a slope of 5 % to the north.
std::shared_ptr<const GuideData> guides() {
    GuideData data;
    for (int i = -2; i <= 2; ++i) {
        data.rows.push_back({{-90.0, 5.0 * i}, {90.0, 5.0 * i}});
    }
    ElevationGrid grid{.origin = {-120.0, -80.0}, .cellM = 5.0, .columns = 49, .rows = 33, .heightsM = {}};
    for (std::size_t row = 0; row < grid.rows; ++row) {
        grid.heightsM.insert(grid.heightsM.end(), grid.columns, 0.25 * static_cast<double>(row));
    }
    data.elevation = std::move(grid);
    return std::make_shared<const GuideData>(std::move(data));
}

}  // namespace

class MethodRegistryTest : public QObject {
    Q_OBJECT

private slots:
    void stagesAreThoseOfThePipeline() {
        std::vector<std::string_view> ids;
        for (const StageInfo& stage : stages()) {
            ids.push_back(stage.id);
        }
        // Stages may be added between these, in this order.
        const std::array order{"headland", "swaths", "decomposition", "route", "path"};
        auto next = order.begin();
        for (const std::string_view id : ids) {
            next = std::find(next, order.end(), id);
            QVERIFY2(next != order.end(), std::string{id}.c_str());
        }
    }

    void methodsAreNamedAsInTheContract_data() {
        QTest::addColumn<QString>("stageId");
        for (const StageInfo& stage : stages()) {
            QTest::newRow(std::string{stage.id}.c_str()) << QString::fromUtf8(stage.id);
        }
    }
    void methodsAreNamedAsInTheContract() {
        QFETCH(QString, stageId);
        const StageInfo& stage = stageInfo(stageId.toStdString());
        const auto row = std::ranges::find(kContract, stage.method->key, &ContractRow::key);
        QVERIFY2(row != kContract.end(), std::string{stage.method->key}.c_str());
        QVERIFY(!stage.methods.empty());
        for (const MethodInfo& method : stage.methods) {
            QVERIFY2(std::ranges::find(row->ids, method.id) != row->ids.end(),
                     std::string{method.id}.c_str());
            QVERIFY(!method.name.empty());
            QVERIFY2(method.description.ends_with('.'), std::string{method.description}.c_str());
        }
        // "the default is the first of the row that exists"
        const auto firstThere = std::ranges::find_if(row->ids, [&](std::string_view id) {
            return std::ranges::find(stage.methods, id, &MethodInfo::id) != stage.methods.end();
        });
        QCOMPARE(settingText(stage.method->defaultValue()), std::string{*firstThere});
    }

    void choicesAreNamedAsInTheContract() {
        int checked = 0;
        for (const ContractRow& row : kContractChoices) {
            const auto found = findParameter(row.key);
            if (!found) {
                continue;  // not there yet
            }
            ++checked;
            const auto choices = (*found)->choices;
            for (const Choice& choice : choices) {
                QVERIFY2(std::ranges::find(row.ids, choice.id) != row.ids.end(),
                         std::string{choice.id}.c_str());
            }
            const auto firstThere = std::ranges::find_if(row.ids, [&](std::string_view id) {
                return std::ranges::find(choices, id, &Choice::id) != choices.end();
            });
            QCOMPARE(settingText((*found)->defaultValue()), std::string{*firstThere});
        }
        QVERIFY(checked >= 4);
    }

    void everyParameterKeyIsThereOnce() {
        std::set<std::string_view> keys;
        for (const Parameter* parameter : allParameters()) {
            QVERIFY2(keys.insert(parameter->key).second, std::string{parameter->key}.c_str());
        }
        for (const StageInfo& stage : stages()) {
            QVERIFY(keys.contains(stage.method->key));
            for (const Parameter* parameter : stage.parameters) {
                QVERIFY(keys.contains(parameter->key));
            }
            for (const MethodInfo& method : stage.methods) {
                for (const Parameter* parameter : method.parameters) {
                    QVERIFY(keys.contains(parameter->key));
                }
            }
        }
        for (const Parameter* parameter : generalParameters()) {
            QVERIFY(keys.contains(parameter->key));
        }
    }

    void everyParameter_data() {
        QTest::addColumn<QString>("key");
        for (const Parameter* parameter : allParameters()) {
            QTest::newRow(std::string{parameter->key}.c_str()) << QString::fromUtf8(parameter->key);
        }
    }
    void everyParameter() {
        QFETCH(QString, key);
        const auto found = findParameter(key.toStdString());
        VERIFY_RESULT(found);
        const Parameter& parameter = **found;
        QCOMPARE(QString::fromUtf8(parameter.key), key);
        QVERIFY(!parameter.name.empty());
        QVERIFY(parameter.description.ends_with('.'));
        // Its default is one of its own values, as a value and as text.
        Settings settings;
        VERIFY_RESULT(settings.set(parameter, parameter.defaultValue()));
        VERIFY_RESULT(settings.setText(parameter, settingText(parameter.defaultValue())));
        QVERIFY(settings == Settings{} || isSetByOperation(parameter.key));
        if (!parameter.excludes.empty()) {
            const auto excluded = findParameter(parameter.excludes);
            VERIFY_RESULT(excluded);
            QCOMPARE((*excluded)->excludes, parameter.key);
        }
        // And every value that it offers can be set.
        for (const Choice& choice : parameter.choices) {
            VERIFY_RESULT(applySetting(settings, parameter.key, choice.id));
            QCOMPARE(settings.choice(parameter), std::string{choice.id});
        }
    }

    // An operation sets headland first or last, where may be driven, fill or empty,
    // and overlap.
    void operationsSetDefaults_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("when");
        QTest::addColumn<QString>("traversal");
        QTest::addColumn<double>("overlapM");
        QTest::addColumn<TankUse>("tank");
        QTest::newRow("tillage") << "tillage" << "before" << "interior" << 0.0 << TankUse::None;
        QTest::newRow("sowing") << "sowing" << "after" << "headland" << 0.0 << TankUse::Empties;
        QTest::newRow("spraying") << "spraying" << "before" << "headland" << 0.0 << TankUse::Empties;
        QTest::newRow("spreading") << "spreading" << "before" << "headland" << 0.0 << TankUse::Empties;
        QTest::newRow("mowing") << "mowing" << "before" << "headland" << 0.1 << TankUse::None;
        QTest::newRow("harvest") << "harvest" << "before" << "headland" << 0.1 << TankUse::Fills;
    }
    void operationsSetDefaults() {
        QFETCH(QString, kind);
        QFETCH(QString, when);
        QFETCH(QString, traversal);
        QFETCH(double, overlapM);
        QFETCH(TankUse, tank);
        Settings settings;
        VERIFY_RESULT(applySetting(settings, "operation.kind", kind.toStdString()));
        const auto value = [&](std::string_view key) {
            return settingText(settings.value(**findParameter(key)));
        };
        QCOMPARE(value("headland.when"), when.toStdString());
        QCOMPARE(value("route.traversal"), traversal.toStdString());
        QCOMPARE(settings.length(**findParameter("swaths.overlap_m"))->si(), overlapM);
        QCOMPARE(settings.operation().tank, tank);
        // What it sets exists, and can be set.
        for (const OperationDefault& entry : settings.operation().defaults) {
            const auto parameter = findParameter(entry.key);
            VERIFY_RESULT(parameter);
            Settings other;
            VERIFY_RESULT(other.set(**parameter, entry.value));
        }
    }

    // Also where it is what the operation before it would have set, and whichever comes first.
    void whatIsGivenHoldsForEveryOperation() {
        Settings first;
        VERIFY_RESULT(applySetting(first, "headland.when", "before"));
        VERIFY_RESULT(applySetting(first, "operation.kind", "sowing"));
        Settings second;
        VERIFY_RESULT(applySetting(second, "operation.kind", "sowing"));
        VERIFY_RESULT(applySetting(second, "headland.when", "before"));
        QCOMPARE(first.choice(**findParameter("headland.when")), std::string{"before"});
        QVERIFY(first == second);
        second.clear(**findParameter("headland.when"));
        QCOMPARE(second.choice(**findParameter("headland.when")), std::string{"after"});
    }

    void unknownKeyNamesTheNearest() {
        const auto misspelt = findParameter("headland.widht_m");
        QVERIFY(!misspelt);
        QCOMPARE(misspelt.error().code, ErrorCode::Usage);
        QVERIFY2(misspelt.error().line().contains("'headland.width_m'"), misspelt.error().line().c_str());
        Settings settings;
        const auto applied = applySetting(settings, "colour", "red");
        QVERIFY(!applied);
        QCOMPARE(applied.error().code, ErrorCode::Usage);
        QVERIFY(settings == Settings{});
    }

    // In the contract's order, the default first.
    void decompositionsInTheContractsOrder() {
        QStringList ids;
        for (const MethodInfo& method : stageInfo("decomposition").methods) {
            ids << QString::fromUtf8(method.id);
        }
        QCOMPARE(ids.join(QLatin1Char{' '}), QStringLiteral("merged boustrophedon trapezoidal none"));
        QCOMPARE(Settings{}.choice(*stageInfo("decomposition").method), std::string{"merged"});
    }

    void everyMethodPlansARectangle_data() {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QString>("id");
        for (const StageInfo& stage : stages()) {
            for (const MethodInfo& method : stage.methods) {
                QTest::newRow((std::string{stage.id} + " " + std::string{method.id}).c_str())
                    << QString::fromUtf8(stage.method->key) << QString::fromUtf8(method.id);
            }
        }
    }
    void everyMethodPlansARectangle() {
        QFETCH(QString, key);
        QFETCH(QString, id);
        Settings settings;
        // What some methods cannot do without.
        const GeoPoint middle = middleOf(rectangleField()->source().parts);
        const std::string line = std::format("LINESTRING ({} {}, {} {})", middle.lonDeg, middle.latDeg,
                                             middle.lonDeg + 0.001, middle.latDeg);
        VERIFY_RESULT(applySetting(settings, "swaths.line", line));
        if (id == "custom") {
            const auto counted =
                makePlan({.field = rectangleField(), .machine = machineLibrary().front(), .settings = {}});
            VERIFY_RESULT(counted);
            std::string order;
            for (std::size_t number = 1; number <= (*counted)->swaths.swaths.size(); ++number) {
                order += std::format("{}{}", number == 1 ? "" : ",-", number);
            }
            VERIFY_RESULT(applySetting(settings, "route.order", order));
        }
        VERIFY_RESULT(applySetting(settings, key.toStdString(), id.toStdString()));
        const PlanRequest request{.field = rectangleField(),
                                  .machine = machineLibrary().front(),
                                  .settings = settings,
                                  .guides = guides()};
        const auto plan = makePlan(request, {.threads = 1});
        VERIFY_RESULT(plan);
        // The same on any number of threads.
        const auto again = makePlan(request, {.threads = 8});
        VERIFY_RESULT(again);
        QVERIFY((*again)->swaths.swaths == (*plan)->swaths.swaths);
        QVERIFY((*again)->path == (*plan)->path);
        QVERIFY(!(*plan)->swaths.swaths.empty());
        QCOMPARE((*plan)->route.steps.size(), (*plan)->swaths.swaths.size());
        QVERIFY((*plan)->path.length() > metres(0.0));
        QCOMPARE((*plan)->request.settings.choice(**findParameter(key.toStdString())), id.toStdString());
    }
};

FURROW_TEST(MethodRegistryTest);
#include "tst_method_registry.moc"
