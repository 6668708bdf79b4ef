#include "planner/machine/machine_library.h"
#include "planner/plan/draft.h"
#include "tests/support/real_fields.h"
#include "tests/support/test_program.h"
#include "ui/map/plan_drawing.h"

#include <QElapsedTimer>
#include <QTest>

#include <ctime>
#include <random>

using namespace furrow;

namespace {

/// Processor time of all threads so far.
double processorMs() {
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// What the environment says.
int numberOf(const char* variable, int otherwise) {
    bool isThere = false;
    const int number = qEnvironmentVariableIntValue(variable, &isThere);
    return isThere ? number : otherwise;
}

/// As many fields as the environment asks for, always the same; a few of those that come along otherwise.
std::vector<FieldSource> fieldsToTime() {
    const auto wanted = static_cast<std::size_t>(numberOf("FURROW_BENCH_FIELDS", 4));
    std::vector<FieldSource> all = wanted > 4 ? test::collectedFields(1) : test::shippedFields();
    if (wanted > 4) {
        std::mt19937 random{20260};
        std::ranges::shuffle(all, random);
        std::erase_if(all, [least = numberOf("FURROW_BENCH_LEAST_HA", 0)](const FieldSource& source) {
            return inHectares(areaOf(source)) < static_cast<double>(least);
        });
    }
    all.resize(std::min(all.size(), wanted));
    return all;
}

double shareOf(std::vector<double> values, double share) {
    std::ranges::sort(values);
    return values.empty() ? 0.0
                          : values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

/// How soon there is something to look at, and how evenly the progress of a plan goes.
class FirstPlanBenchmark : public QObject {
    Q_OBJECT

private slots:
    void machine_data() {
        QTest::addColumn<QByteArray>("machine");
        for (const char* machine : {"agbot", "cultivator", "trailed-sprayer"}) {
            QTest::newRow(machine) << QByteArray{machine};
        }
    }
    // Processor time from an outline to a draft on the map.
    void draft_data() { machine_data(); }
    void draft() {
        QFETCH(QByteArray, machine);
        std::vector<double> took;
        std::size_t failed = 0;
        for (const FieldSource& source : fieldsToTime()) {
            const double begun = processorMs();
            const auto field = Field::create(source, {.stop = {}, .progress = {}, .threads = 1});
            if (!field) {
                continue;
            }
            const auto draft = makePlan(draftOf({.field = std::make_shared<const Field>(*field),
                                                 .machine = findMachine(machine.toStdString()).value(),
                                                 .settings = {}},
                                                nullptr),
                                        {.stop = {}, .progress = {}, .threads = 1});
            if (!draft) {
                ++failed;
                continue;
            }
            const double planned = processorMs();
            const PlanGeometry drawn = planGeometry(**draft);
            took.push_back(processorMs() - begun);
            if (took.back() > 300.0 || qEnvironmentVariableIsSet("FURROW_BENCH_EACH")) {
                const StageTimings& t = (*draft)->timings;
                qInfo(
                    "%s, %.1f ha, %zu swaths: %.0f ms; headland %.0f, swaths %.0f, route %.0f, path %.0f, "
                    "plan %.0f, drawing %.0f",
                    source.name.c_str(), inHectares(field->area()), (*draft)->swaths.swaths.size(),
                    took.back(), 1e3 * t.headland.si(), 1e3 * t.swaths.si(), 1e3 * t.route.si(),
                    1e3 * t.path.si(), 1e3 * t.total.si(), processorMs() - planned);
            }
        }
        qInfo("%s: %zu drafts, %zu without: median %.0f ms, 95 %% in %.0f ms, slowest %.0f ms",
              machine.constData(), took.size(), failed, shareOf(took, 0.5), shareOf(took, 0.95),
              shareOf(took, 1.0));
    }
    // The values that progress takes while a plan is made, and how long it stands at one.
    void progress_data() { machine_data(); }
    void progress() {
        QFETCH(QByteArray, machine);
        const std::string file = qEnvironmentVariable("FURROW_BENCH_FILE", FURROW_SOURCE_DIR
                                                      "/resources/sample_fields/home_field.geojson")
                                     .toStdString();
        const auto sources = readBoundaries(file).value();
        const auto index = static_cast<std::size_t>(numberOf("FURROW_BENCH_INDEX", 0));
        const PlanRequest request{
            .field = std::make_shared<const Field>(Field::create(sources[index]).value()),
            .machine = findMachine(machine.toStdString()).value(),
            .settings = {}};
        struct Value {
            int percent;
            double sinceMs;
        };
        std::vector<Value> values{{0, 0.0}};
        QElapsedTimer watch;
        watch.start();
        const auto told = [&](double share) {
            const int percent = static_cast<int>(100.0 * share);
            if (percent != values.back().percent) {
                values.push_back({percent, 1e-6 * static_cast<double>(watch.nsecsElapsed())});
            }
        };
        const auto plan = makePlan(request, {.stop = {}, .progress = told, .threads = 1}).value();
        values.push_back({100, 1e-6 * static_cast<double>(watch.nsecsElapsed())});
        double longest = 0.0;
        int at = 0;
        for (std::size_t i = 1; i < values.size(); ++i) {
            const double stood = values[i].sinceMs - values[i - 1].sinceMs;
            if (qEnvironmentVariableIsSet("FURROW_BENCH_EACH")) {
                qInfo("%3d %% from %.0f ms for %.0f ms", values[i - 1].percent, values[i - 1].sinceMs, stood);
            }
            if (stood > longest) {
                longest = stood;
                at = values[i - 1].percent;
            }
        }
        const StageTimings& t = plan->timings;
        qInfo(
            "%s, %.1f ha: %.0f ms, %zu values, longest at %d %% for %.0f ms; headland %.0f, swaths %.0f, route %.0f, "
            "path %.0f, audit %.0f",
            machine.constData(), inHectares(request.field->area()), values.back().sinceMs, values.size(), at,
            longest, 1e3 * t.headland.si(), 1e3 * t.swaths.si(), 1e3 * t.route.si(), 1e3 * t.path.si(),
            1e3 * t.audit.si());
    }
};

FURROW_TEST(FirstPlanBenchmark);
#include "bench_first_plan.moc"
