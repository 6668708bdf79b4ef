// Two thousand real fields, none of them drawn by the authors: every one is planned or refused for a reason.

#include "planner/machine/machine_library.h"
#include "planner/plan/plan.h"
#include "tests/support/real_fields.h"
#include "tests/support/test_program.h"

#include <QTest>

#include <map>

using namespace furrow;

class TestAllFields : public QObject {
    Q_OBJECT

public:
    TestAllFields() { test::allowTimeForEveryField(); }

private slots:
    void everyFieldIsPlannedOrRefusedForAReason();
};

namespace {

/// The refusals that are meant to happen to real boundaries; anything else is a bug.
bool isKnownReason(const Error& error) {
    static const std::string_view known[] = {"crosses itself", "nowhere as wide as the machine",
                                             "fits nowhere into the field", "enclose no area",
                                             "fewer than 3 different points"};
    return error.code == ErrorCode::InputRefused && std::ranges::any_of(known, [&](std::string_view text) {
               return error.what.find(text) != std::string::npos;
           });
}

/// What came of the fields.
struct Tally {
    int planned = 0;
    int drivable = 0;
    int large = 0;
    int largePlanned = 0;
    double turns = 0.0;
    double undrivableTurns = 0.0;
    std::vector<double> milliseconds;
    double slowest = 0.0;
    std::string slowestId;
    std::map<std::string, int> refusals;

    void addRefusal(const Error& error) { ++refusals[error.what.substr(0, 30)]; }
    void addPlan(const Plan& plan, const std::string& fieldId, bool isLarge) {
        ++planned;
        largePlanned += isLarge ? 1 : 0;
        drivable += plan.drivable() ? 1 : 0;
        turns += plan.path.turnCount();
        undrivableTurns += plan.path.undrivableCount();
        milliseconds.push_back(plan.timings.total.si() * 1e3);
        if (milliseconds.back() > slowest) {
            slowest = milliseconds.back();
            slowestId = fieldId;
        }
    }
    void tell(std::size_t fields) {
        std::ranges::sort(milliseconds);
        QVERIFY(!milliseconds.empty());
        const auto quantile = [&](double share) {
            return milliseconds[static_cast<std::size_t>(share *
                                                         static_cast<double>(milliseconds.size() - 1))];
        };
        qInfo("planned %d of %zu, %d of %d over 0.3 ha, fully drivable %d, turns that stay inside %.1f %%",
              planned, fields, largePlanned, large, drivable, 100.0 * (1.0 - undrivableTurns / turns));
        qInfo("planning time: median %.1f ms, 95 %% %.1f ms, largest %.0f ms (%s)", quantile(0.5),
              quantile(0.95), slowest, slowestId.c_str());
        for (const auto& [reason, count] : refusals) {
            qInfo("refused %d: %s ...", count, reason.c_str());
        }
    }
};

}  // namespace

void TestAllFields::everyFieldIsPlannedOrRefusedForAReason() {
    const std::vector<FieldSource> sources = test::collectedFields(58);
    if (sources.empty()) {
        QSKIP("the collection of real fields is not beside the project");
    }
    // 2005 of them, or every fifty-eighth: plans that need many short passes take seconds.
    QVERIFY(sources.size() == 2005 || sources.size() == 35);

    Tally tally;
    for (const FieldSource& source : sources) {
        auto field = Field::create(source);
        const bool valid = field.has_value();
        const bool isLarge = valid && inHectares(field->area()) > 0.3;
        tally.large += isLarge ? 1 : 0;
        if (!valid) {
            QVERIFY2(isKnownReason(field.error()), qPrintable(QString::fromStdString(field.error().line())));
            tally.addRefusal(field.error());
            continue;
        }
        const auto plan = makePlan({.field = std::make_shared<const Field>(std::move(*field)),
                                    .machine = machineLibrary().front(),
                                    .settings = {}});
        if (!plan) {
            QVERIFY2(isKnownReason(plan.error()), qPrintable(QString::fromStdString(plan.error().line())));
            tally.addRefusal(plan.error());
            continue;
        }
        tally.addPlan(**plan, source.id, isLarge);
        // A narrow field may be passes around it alone.
        QVERIFY2(!(*plan)->swaths.swaths.empty() || (*plan)->headland.isPerimeterOnly, source.id.c_str());
        QVERIFY2((*plan)->swaths.coverage > 0.0 && (*plan)->swaths.coverage <= 1.0, source.id.c_str());
        QCOMPARE((*plan)->route.steps.size(), (*plan)->swaths.swaths.size());
    }
    tally.tell(sources.size());
    QVERIFY(tally.largePlanned >= 0.98 * tally.large);
}

FURROW_TEST(TestAllFields);
#include "tst_all_fields.moc"
