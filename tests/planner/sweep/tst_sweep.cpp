// Every value of every setting: the plan is drivable, or it is refused or blocked for a reason that names the
// setting. The everyday part is here; sweep_run.h says how to have all shapes and machines, and pairs of
// settings.

#include "planner/plan/method_registry.h"
#include "tests/planner/sweep/sweep_run.h"
#include "tests/planner/sweep/sweep_verdict.h"
#include "tests/support/scratch.h"

#include <QTest>

#include <algorithm>
#include <map>
#include <set>

using namespace furrow;

class TestSweep : public QObject {
    Q_OBJECT

private slots:
    void everySettingIsTried();
    void aFindingTellsOfItsSetting_data();
    void aFindingTellsOfItsSetting();
    void adviceIsTried_data();
    void adviceIsTried();
    void pairsAreDrawnAgain();
    void everyday_data();
    void everyday();

private:
    const test::SweepBench& benchOf(const std::string& shape, const std::string& machine);

    test::Scratch scratch_;
    std::map<std::string, test::SweepBench> benches_;
};

namespace {

/// What fails as long as it is not mended, by its row in this test. To be emptied: one that passes is a
/// failure of the test.
const std::vector<std::string> kKnownFailures{};

/// What once broke plans, on fields where it did.
struct OnceBroken {
    const char* shape;
    const char* machine;
    const char* change;  ///< how the names of the changes begin
};
constexpr OnceBroken kOnceBroken[] = {
    {"five-ha", "cultivator", "headland.direction="}, {"five-ha", "cultivator", "field.margin_m="},
    {"rectangle", "cultivator", "path.method="},      {"rectangle", "cultivator", "headland."},
    {"rectangle", "cultivator", "route.traversal="},  {"rectangle", "cultivator", "swaths.rows"},
    {"wet-spot", "cultivator", "headland.method="},   {"headland-pond", "field-robot", "headland.method="},
    {"pond", "cultivator", "decomposition."},         {"slanted", "spreader", "swaths.elevation="},
};

/// Every value on a small field with a small machine, what once was broken, and a few of all others that are
/// quick.
const std::vector<test::SweepCase>& everydayCases() {
    static const std::vector<test::SweepCase> cases = [] {
        const std::vector<test::SweepChange> changes = test::everyChange();
        std::vector<test::SweepCase> all = test::casesOf(changes, {"small-pond"}, {"agbot"});
        std::set<std::string> names;
        const auto add = [&](const test::SweepCase& each) {
            if (names.insert(each.name()).second) {
                all.push_back(each);
            }
        };
        for (const OnceBroken& broken : kOnceBroken) {
            for (const test::SweepChange& change : changes) {
                if (change.name().starts_with(broken.change)) {
                    add({broken.shape, broken.machine, change});
                }
            }
        }
        const std::vector<std::string> shapes{"rectangle", "slanted",   "l-shape", "comb",
                                              "triangle",  "strip",     "pond",    "headland-pond",
                                              "wet-spot",  "two-parts", "slalom",  "five-ha"};
        std::ranges::for_each(
            test::drawnCases(test::casesOf(changes, shapes, {"cultivator", "mounted-drill", "combine"}), 80,
                             1),
            add);
        return all;
    }();
    return cases;
}

test::SweepChange changeNamed(const QString& name) {
    const std::vector<test::SweepChange> changes = test::everyChange();
    const auto found = std::ranges::find(changes, name.toStdString(), &test::SweepChange::name);
    return found == changes.end() ? test::SweepChange{} : *found;
}

}  // namespace

void TestSweep::everySettingIsTried() {
    std::set<std::string> tried;
    for (const test::SweepChange& change : test::everyChange()) {
        for (const test::SweepSetting& setting : change.changed) {
            tried.insert(setting.key);
        }
    }
    for (const Parameter* parameter : allParameters()) {
        QVERIFY2(tried.contains(std::string{parameter->key}),
                 (std::string{parameter->key} + ": say in sweep_values.cpp what people give it").c_str());
    }
    const std::vector<test::SweepCase>& cases = everydayCases();
    for (const std::string& known : kKnownFailures) {
        QVERIFY2(std::ranges::contains(cases, known, &test::SweepCase::name), known.c_str());
    }
}

void TestSweep::aFindingTellsOfItsSetting_data() {
    QTest::addColumn<QString>("change");
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("suggestion");
    QTest::addColumn<QString>("key");
    QTest::addColumn<bool>("tells");
    QTest::newRow("by its key") << "path.stay_inside=false" << "This is so since path.stay_inside is off."
                                << "" << "" << true;
    QTest::newRow("by its name") << "path.stay_inside=false" << "It leaves the field."
                                 << "Switch \"Stay inside\" on." << "" << true;
    QTest::newRow("by a word of everyday use")
        << "headland.passes=1" << "The headland passes leave the field." << "" << "" << false;
    QTest::newRow("by that word, quoted")
        << "headland.passes=1" << "It leaves the field." << "Set \"Passes\" to 3." << "" << true;
    QTest::newRow("by what was chosen")
        << "path.method=straight" << "This machine cannot turn on the spot." << "" << "" << true;
    QTest::newRow("by another choice")
        << "path.method=u" << "It leaves the field." << "Choose \"Best that fits\"." << "" << true;
    QTest::newRow("by its change") << "headland.passes=1" << "It leaves the field." << "" << "headland.passes"
                                   << true;
    QTest::newRow("by the change of another setting")
        << "headland.passes=1" << "It leaves the field." << "" << "swaths.method" << false;
    QTest::newRow("by the change of its method")
        << "headland.passes=1" << "It leaves the field." << "" << "headland.method" << true;
    QTest::newRow("by what the operation sets")
        << "operation.kind=sowing" << "It leaves the field." << "" << "route.traversal" << true;
    QTest::newRow("not at all") << "path.method=u" << "It leaves the field."
                                << "Try another direction of the swaths." << "" << false;
}

void TestSweep::aFindingTellsOfItsSetting() {
    QFETCH(QString, change);
    QFETCH(QString, text);
    QFETCH(QString, suggestion);
    QFETCH(QString, key);
    QFETCH(bool, tells);
    const test::SweepChange changed = changeNamed(change);
    QCOMPARE(changed.name(), change.toStdString());
    Finding finding{.severity = Severity::Blocking,
                    .kind = FindingKind::Outside,
                    .place = {},
                    .text = text.toStdString(),
                    .suggestion = suggestion.toStdString()};
    if (!key.isEmpty()) {
        finding.change = SettingChange{key.toStdString(), "1"};
    }
    QCOMPARE(test::tells(finding, changed), tells);
}

void TestSweep::adviceIsTried_data() {
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("said");
    QTest::newRow("helps") << "headland.passes" << "auto" << "";
    QTest::newRow("changes nothing") << "route.corner" << "first" << "still there";
    QTest::newRow("does harm") << "headland.passes" << "0" << "still there";
    QTest::newRow("is refused") << "swaths.overlap_m" << "30" << "less than the operating width";
    QTest::newRow("is no setting") << "headland.breadth" << "18" << "no setting";
}

/// On a headland of one pass the cultivator leaves the field in its turns.
void TestSweep::adviceIsTried() {
    QFETCH(QString, key);
    QFETCH(QString, value);
    QFETCH(QString, said);
    const test::SweepBench& bench = benchOf("small-rectangle", "cultivator");
    Settings settings;
    QVERIFY(applySetting(settings, "headland.passes", "1").has_value());
    Plan plan = *bench.plan(settings).value();
    QVERIFY(!plan.drivable());
    for (Finding& finding : plan.findings) {
        finding.change = std::nullopt;
    }
    QCOMPARE(bench.badAdvice(plan), std::string{});
    plan.findings.front().change = SettingChange{key.toStdString(), value.toStdString()};
    const std::string bad = bench.badAdvice(plan);
    QVERIFY2(said.isEmpty() ? bad.empty() : bad.contains(said.toStdString()), bad.c_str());
}

void TestSweep::pairsAreDrawnAgain() {
    const std::vector<test::SweepChange> changes = test::everyChange();
    const std::vector<test::SweepChange> pairs = test::drawnPairs(changes, 300, 5);
    QCOMPARE(pairs.size(), std::size_t{300});
    std::set<std::string> names;
    for (const test::SweepChange& pair : pairs) {
        QCOMPARE(pair.changed.size(), std::size_t{2});
        QVERIFY2(names.insert(pair.name()).second, pair.name().c_str());
        std::set<std::string> keys;
        for (const auto* settings : {&pair.changed, &pair.partners}) {
            for (const test::SweepSetting& setting : *settings) {
                QVERIFY2(keys.insert(setting.key).second, pair.name().c_str());
            }
        }
    }
    const std::vector<test::SweepChange> again = test::drawnPairs(changes, 300, 5);
    QVERIFY(std::ranges::equal(pairs, again, {}, &test::SweepChange::name, &test::SweepChange::name));
    QVERIFY(test::drawnPairs(changes, 300, 6).front().name() != pairs.front().name());
}

const test::SweepBench& TestSweep::benchOf(const std::string& shape, const std::string& machine) {
    const std::string name = shape + "_" + machine;
    const auto found = benches_.find(name);
    if (found != benches_.end()) {
        return found->second;
    }
    std::filesystem::create_directories(scratch_.path(name));
    return benches_.emplace(name, test::SweepBench{shape, machine, scratch_.path(name)}).first->second;
}

void TestSweep::everyday_data() {
    QTest::addColumn<int>("number");
    for (std::size_t i = 0; i < everydayCases().size(); ++i) {
        QTest::newRow(everydayCases()[i].name().c_str()) << static_cast<int>(i);
    }
}

void TestSweep::everyday() {
    QFETCH(int, number);
    const test::SweepCase& each = everydayCases()[static_cast<std::size_t>(number)];
    const test::SweepOutcome outcome = benchOf(each.shape, each.machine).run(each.change);
    if (std::ranges::contains(kKnownFailures, each.name())) {
        QEXPECT_FAIL("", outcome.reason.c_str(), Continue);
    }
    QVERIFY2(outcome.verdict != test::SweepVerdict::Failed,
             (outcome.settings + "\n" + outcome.reason).c_str());
}

int main(int argc, char** argv) {
    const QCoreApplication application{argc, argv};
    if (test::isSweepWorker()) {
        return test::runSweepWorker();
    }
    if (test::sweepIsWanted()) {
        return test::runSweep();
    }
    TestSweep everyday;
    return QTest::qExec(&everyday, argc, argv);
}

#include "tst_sweep.moc"
