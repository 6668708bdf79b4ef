// What promises time gives time: no simpler choice is quicker as driven than what the planner decides by
// itself, by more than 0.5 %. Everyday on sample fields. Over others with
//   FURROW_SIMPLER=I/N         the I-th of N shares of the shared fields, from 1
//   FURROW_SIMPLER_MACHINE=M   the field robot, if it is not set
//   FURROW_SIMPLER_OUT=FILE    where a line for each comparison is appended

#include "planner/io/import/boundary_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/plan/quicker_choice.h"
#include "tests/support/large_data.h"
#include "tests/support/result_check.h"
#include "tests/support/test_program.h"

#include <QFile>
#include <QTest>

#include <format>
#include <map>
#include <memory>
#include <optional>
#include <string>
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
    {"swaths.method", nullptr, "longest-edge"},  {"route.method", nullptr, "boustrophedon"},
    {"route.method", nullptr, "snake"},          {"headland.corner", nullptr, "rounded"},
    {"headland.corner", nullptr, "loop"},        {"headland.corner", nullptr, "reverse"},
    {"headland.method", "per-edge", "constant"}, {"decomposition.heading", "per-cell", "common"},
};

struct Bench {
    std::shared_ptr<const Field> field;
    Machine machine;
    StageCache cache = {};

    std::shared_ptr<const Plan> plan(const char* key, const char* value) {
        Settings settings;
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
};

void TestSimplerChoices::areNotQuicker_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("machine");
    const QString share = qEnvironmentVariable("FURROW_SIMPLER");
    if (share.isEmpty()) {
        for (const char* name : {"home_field", "bend", "slanted_field"}) {
            QTest::addRow("%s agbot", name)
                << QStringLiteral(FURROW_SOURCE_DIR "/resources/sample_fields/%1.geojson").arg(name)
                << QString{} << "agbot";
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

FURROW_TEST(TestSimplerChoices);
#include "tst_simpler_choices.moc"
