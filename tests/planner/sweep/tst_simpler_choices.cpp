// What promises time gives time: no simpler choice is quicker as driven than what the planner decides by
// itself, and no single change than the best plan, by more than 0.5 %. Everyday on sample fields. Over others
// with
//   FURROW_SIMPLER=I/N         the I-th of N shares of the shared fields, from 1
//   FURROW_SIMPLER_MACHINE=M   the field robot, if it is not set
//   FURROW_SIMPLER_OUT=FILE    where a line for each comparison is appended
//   FURROW_SIMPLER_TABLE=1     only times of patterns, of the plan by itself and of the best plan, no changes

#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/best_plan.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/plan/quicker_choice.h"
#include "tests/support/large_data.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTest>

#include <algorithm>
#include <format>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace furrow;

namespace {

constexpr double kMostSlower = 1.005;
constexpr Area kLeast = squareMetres(3000.0);

/// A choice, and the simpler one that must not be quicker. Without a choice of its own the default.
struct Simpler {
    const char* key;
    const char* chosen;
    const char* simpler;
};
constexpr Simpler kSimpler[] = {
    {"swaths.method", nullptr, "longest-edge"},
    {"route.method", nullptr, "boustrophedon"},
    {"route.method", nullptr, "snake"},
    {"route.method", nullptr, "spiral"},
    {"route.method", nullptr, "skip"},
    {"route.method", nullptr, "racetrack"},
    {"headland.corner", nullptr, "rounded"},
    {"headland.corner", nullptr, "loop"},
    {"headland.corner", nullptr, "reverse"},
    {"headland.method", "per-edge", "constant"},
    {"decomposition.heading", "per-cell", "common"},
};

/// Single changes to a best plan.
constexpr std::pair<const char*, const char*> kSingle[] = {
    {"headland.method", "constant"},
    {"headland.method", "per-edge"},
    {"headland.method", "none"},
    {"headland.passes", "-1"},
    {"headland.passes", "+1"},
    {"headland.corner", "rounded"},
    {"headland.corner", "loop"},
    {"headland.corner", "reverse"},
    {"headland.order", "inside-out"},
    {"headland.direction", "clockwise"},
    {"swaths.method", "exact"},
    {"swaths.method", "longest-edge"},
    {"swaths.objective", "swath-count"},
    {"swaths.objective", "swath-length"},
    {"swaths.objective", "coverage"},
    {"swaths.ends", "centre"},
    {"swaths.last_pass", "overlap"},
    {"swaths.last_pass", "spread"},
    {"swaths.round_up_to_m", "0"},
    {"decomposition.method", "merged"},
    {"decomposition.method", "boustrophedon"},
    {"decomposition.method", "trapezoidal"},
    {"decomposition.method", "none"},
    {"decomposition.heading", "per-cell"},
    {"route.method", "boustrophedon"},
    {"route.method", "snake"},
    {"route.method", "spiral"},
    {"route.method", "skip"},
    {"route.method", "racetrack"},
};

constexpr const char* kPatterns[] = {"boustrophedon", "snake", "spiral", "skip", "racetrack"};

struct Bench {
    std::shared_ptr<const Field> field;
    Machine machine;
    StageCache cache = {};

    std::shared_ptr<const Plan> plan(const char* key, const char* value, Settings settings = {}) {
        if (value != nullptr) {
            applySetting(settings, key, value).value();
        }
        return makePlan({.field = field, .machine = machine, .settings = settings}, {}, &cache)
            .value_or(nullptr);
    }
};

/// Read once.
const std::vector<FieldSource>& sourcesIn(const QString& file) {
    static std::map<QString, std::vector<FieldSource>> read;
    auto found = read.find(file);
    if (found == read.end()) {
        found = read.emplace(file, readBoundaries(file.toStdString()).value()).first;
    }
    return found->second;
}

/// Nothing where no plan can be driven by it.
std::optional<double> timeS(const std::shared_ptr<const Plan>& plan) {
    return plan && plan->drivable()
               ? std::optional{timeForAll(plan->request.machine, plan->path, plan->audit).si()}
               : std::nullopt;
}

std::string timeText(const std::optional<double>& time) {
    return time ? std::format("{:.1f}", *time) : "blocked";
}

}  // namespace

class TestSimplerChoices : public QObject {
    Q_OBJECT

private slots:
    void areNotQuicker_data();
    void areNotQuicker();
    void noSingleChangeBeatsTheBestPlan_data() { areNotQuicker_data(); }
    void noSingleChangeBeatsTheBestPlan();
};

void TestSimplerChoices::areNotQuicker_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("machine");
    const QString share = qEnvironmentVariable("FURROW_SIMPLER");
    if (share.isEmpty()) {
        for (const char* machine : {"agbot", "cultivator"}) {
            for (const char* name : {"home_field", "bend", "slanted_field"}) {
                QTest::addRow("%s %s", name, machine)
                    << QStringLiteral(FURROW_SOURCE_DIR "/resources/sample_fields/%1.geojson").arg(name)
                    << QString{} << machine;
            }
        }
        // Three swaths: the order in which short passes fit in best is not the quickest without them.
        for (const char* parcel : {"long", "broad"}) {
            QTest::addRow("%s narrow parcel cultivator", parcel)
                << QStringLiteral(FURROW_SOURCE_DIR "/tests/data/narrow_parcels.geojson")
                << QString::fromUtf8(parcel) << QStringLiteral("cultivator");
        }
        return;
    }
    const QString file = test::largeData(QStringLiteral("fields/all_fields.geojson"));
    const std::vector<FieldSource>& fields = sourcesIn(file);
    const auto number = static_cast<std::size_t>(share.section('/', 0, 0).toInt());
    const auto count = static_cast<std::size_t>(share.section('/', 1, 1).toInt());
    for (std::size_t i = number - 1; i < fields.size(); i += count) {
        if (areaOf(fields[i]) >= kLeast) {
            QTest::newRow(fields[i].id.c_str())
                << file << QString::fromStdString(fields[i].id)
                << qEnvironmentVariable("FURROW_SIMPLER_MACHINE", "field-robot");
        }
    }
}

void TestSimplerChoices::areNotQuicker() {
    QFETCH(QString, file);
    QFETCH(QString, id);
    QFETCH(QString, machine);
    const auto source =
        pickField(sourcesIn(file), id.isEmpty() ? std::nullopt : std::optional{id.toStdString()});
    VERIFY_RESULT(source);
    const auto field = Field::create(*source);
    VERIFY_RESULT(field);
    Bench bench{std::make_shared<const Field>(*field), findMachine(machine.toStdString()).value()};
    const std::optional<double> byItself = timeS(bench.plan(nullptr, nullptr));
    QFile out{qEnvironmentVariable("FURROW_SIMPLER_OUT")};
    if (!out.fileName().isEmpty()) {
        QVERIFY(out.open(QIODevice::Append));
    }
    std::string worse;
    for (const Simpler& each : kSimpler) {
        const std::optional<double> chosen =
            each.chosen == nullptr ? byItself : timeS(bench.plan(each.key, each.chosen));
        const std::optional<double> simpler =
            each.chosen == nullptr ? timeS(bench.plan(each.key, each.simpler)) : byItself;
        const std::string row = std::format("{}\t{}\t{}\t{}\t{}\t{}\t{:.4f}\n", machine.toStdString(),
                                            QTest::currentDataTag(), each.key, each.simpler, timeText(chosen),
                                            timeText(simpler), chosen && simpler ? *chosen / *simpler : 0.0);
        if (out.isOpen()) {
            out.write(row.c_str());
        }
        if (simpler && !(chosen && *chosen <= kMostSlower * *simpler)) {
            worse += row;
        }
    }
    QVERIFY2(worse.empty(), worse.c_str());
}

void TestSimplerChoices::noSingleChangeBeatsTheBestPlan() {
    QFETCH(QString, file);
    QFETCH(QString, id);
    QFETCH(QString, machine);
    const auto source =
        pickField(sourcesIn(file), id.isEmpty() ? std::nullopt : std::optional{id.toStdString()});
    VERIFY_RESULT(source);
    const auto field = Field::create(*source);
    VERIFY_RESULT(field);
    Bench bench{std::make_shared<const Field>(*field), findMachine(machine.toStdString()).value()};
    std::string row = std::format("best\t{}\t{}\t{:.2f}", machine.toStdString(), QTest::currentDataTag(),
                                  inHectares(field->area()));
    const bool isMeasured = qEnvironmentVariableIsSet("FURROW_SIMPLER_OUT");
    for (const char* const pattern : kPatterns) {
        row += "\t" + (isMeasured ? timeText(timeS(bench.plan("route.method", pattern))) : std::string{});
    }
    QElapsedTimer timer;
    timer.start();
    const auto asked = bench.plan(nullptr, nullptr);
    row += std::format("\t{}\t{:.2f}", timeText(timeS(asked)), 1e-3 * static_cast<double>(timer.restart()));
    // From nothing, as a user of the command line has it.
    const auto best = bestPlan({.request = {.field = bench.field, .machine = bench.machine, .settings = {}},
                                .kept = {},
                                .onBetter = {}});
    row += std::format("\t{}\t{:.2f}", timeText(timeS(best.value_or(nullptr))),
                       1e-3 * static_cast<double>(timer.elapsed()));
    QVERIFY2(best.has_value() == (asked != nullptr), row.c_str());
    if (!best) {
        return;
    }
    QVERIFY((*best)->choices.has_value());
    QVERIFY2((*best)->blockingCount() <= asked->blockingCount(), row.c_str());
    std::string quicker;
    double least = 1.0;
    for (const auto& [key, value] : kSingle) {
        if (qEnvironmentVariableIsSet("FURROW_SIMPLER_TABLE")) {
            break;
        }
        std::string changed = value;
        if (changed == "-1" || changed == "+1") {
            const int passes = (*best)->headland.passes + (changed == "+1" ? 1 : -1);
            if (passes < 1) {
                continue;
            }
            changed = std::to_string(passes);
        }
        const auto other = timeS(bench.plan(key, changed.c_str(), (*best)->request.settings));
        const auto bestS = timeS(*best);
        if (other) {
            const double ratio = bestS ? *other / *bestS : 0.0;
            least = std::min(least, ratio);
            if (ratio < 1.0 / kMostSlower) {
                quicker += std::format(" {}={} {:.4f}", key, changed, ratio);
            }
        }
    }
    row += std::format("\t{:.4f}\t{}\n", least, quicker);
    if (isMeasured) {
        QFile out{qEnvironmentVariable("FURROW_SIMPLER_OUT")};
        QVERIFY(out.open(QIODevice::Append));
        out.write(row.c_str());
    }
    QVERIFY2(quicker.empty(), row.c_str());
}

FURROW_TEST(TestSimplerChoices);
#include "tst_simpler_choices.moc"
