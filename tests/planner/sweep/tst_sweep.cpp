// Every value of every setting: the plan is drivable, or it is refused or blocked for a reason that names the setting.
// The everyday part is here; sweep_run.h says how to have all shapes and machines, and pairs of settings.

#include "tests/planner/sweep/sweep_run.h"
#include "tests/planner/sweep/sweep_shapes.h"
#include "tests/planner/sweep/sweep_verdict.h"
#include "tests/support/scratch.h"

#include <QTest>

#include <algorithm>
#include <map>

using namespace furrow;

class TestSweep : public QObject {
    Q_OBJECT

private slots:
    void everyChange_data();
    void everyChange();

private:
    const test::SweepBench& benchOf(const std::string& shape, const std::string& machine);

    test::Scratch scratch_;
    std::map<std::string, test::SweepBench> benches_;
};

namespace {

/// What fails as long as it is not mended, by its row in this test. To be emptied: one that passes is a failure of the
/// test.
const std::vector<std::string> kKnownFailures{
    "small-pond | agbot | field.margin_m=0.5",
    "small-pond | agbot | field.margin_m=2",
    "small-pond | agbot | headland.method=none",
    "small-pond | agbot | headland.passes=0",
    "small-pond | agbot | headland.passes=1",
    "small-pond | agbot | headland.width_m=0",
    "small-pond | agbot | headland.width_m=1.5 widths",
    "small-pond | agbot | headland.finish=false",
    "small-pond | agbot | decomposition.split=ends in the field",
    "small-pond | agbot | path.method=dubins",
    "small-pond | agbot | path.method=reeds-shepp",
    "small-pond | agbot | path.method=dubins-cc",
    "small-pond | agbot | path.method=reeds-shepp-cc",
    "small-pond | agbot | path.method=u",
    "small-pond | agbot | path.method=omega",
    "small-pond | agbot | path.method=p",
    "small-pond | agbot | path.method=fishtail",
    "small-pond | agbot | path.method=three-point",
    "small-pond | agbot | path.method=straight",
    "small-pond | agbot | path.stay_inside=false",
};

std::vector<test::SweepCase> everydayCases() {
    return test::casesOf(test::everyChange(), {"small-pond"}, {"agbot"});
}

}  // namespace

const test::SweepBench& TestSweep::benchOf(const std::string& shape, const std::string& machine) {
    const std::string name = shape + "_" + machine;
    const auto found = benches_.find(name);
    if (found != benches_.end()) {
        return found->second;
    }
    std::filesystem::create_directories(scratch_.path(name));
    return benches_.emplace(name, test::SweepBench{shape, machine, scratch_.path(name)}).first->second;
}

void TestSweep::everyChange_data() {
    QTest::addColumn<int>("number");
    const std::vector<test::SweepCase> cases = everydayCases();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        QTest::newRow(cases[i].name().c_str()) << static_cast<int>(i);
    }
}

void TestSweep::everyChange() {
    QFETCH(int, number);
    static const std::vector<test::SweepCase> cases = everydayCases();
    const test::SweepCase& each = cases[static_cast<std::size_t>(number)];
    const test::SweepOutcome outcome = benchOf(each.shape, each.machine).run(each.change);
    if (std::ranges::contains(kKnownFailures, each.name())) {
        QEXPECT_FAIL("", outcome.reason.c_str(), Continue);
    }
    QVERIFY2(outcome.verdict != test::SweepVerdict::Failed, (outcome.settings + "\n" + outcome.reason).c_str());
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
