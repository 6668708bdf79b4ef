#include "planner/benchmarks/speed.h"

#include "planner/benchmarks/geos_yardstick.h"
#include "planner/benchmarks/paired_timing.h"
#include "planner/benchmarks/paper_settings.h"
#include "planner/benchmarks/peak_memory.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/swaths/scan_line.h"
#include "planner/turns/continuous_curvature.h"
#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"

#include <cmath>
#include <format>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

constexpr int kTimedHeadings = 180;
constexpr Length kTimedWidth = metres(2.5);
// Headings that one run of the yardstick tries, on small fields and on others.
constexpr int kFewHeadings = 30;
constexpr int kFewestHeadings = 2;
constexpr Area kSmallField = squareMetres(10'000.0);
constexpr std::size_t kFewVertices = 1000;
// Whole degrees from one heading to the next; coprime to 180, so all have their turn.
constexpr int kStride = 77;

using OwnSettings = std::initializer_list<std::pair<std::string_view, std::string_view>>;

Result<Settings> settingsWith(OwnSettings own) {
    Settings settings;
    for (const auto& [key, value] : own) {
        if (const auto applied = applySetting(settings, key, value); !applied) {
            return std::unexpected(applied.error());
        }
    }
    return settings;
}

/// An oval field with gentle waves, with any number of points. All points differ, and are the same every
/// time.
Polygon waveField(double areaHa, std::size_t vertices) {
    Polygon field;
    for (std::size_t i = 0; i < vertices; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(vertices);
        const double radius = 1.0 + 0.05 * std::sin(5.0 * angle) + 0.02 * std::cos(11.0 * angle);
        field.outer.push_back({1.6 * radius * std::cos(angle), radius * std::sin(angle)});
    }
    return scaledTo(field, squareMetres(1e4 * areaHa));
}

/// The same with ponds inside.
Polygon withPonds(Polygon field, int ponds) {
    const double size = std::sqrt(area(field).si());
    for (int i = 0; i < ponds; ++i) {
        const double around = 2.0 * std::numbers::pi * i / ponds;
        const Point centre{0.4 * size * std::cos(around), 0.2 * size * std::sin(around)};
        Ring pond;
        for (int k = 0; k < 12; ++k) {
            pond.push_back(centre + 0.03 * size * direction(-2.0 * std::numbers::pi * k / 12));
        }
        field.holes.push_back(std::move(pond));
    }
    return field;
}

class Bench {
public:
    explicit Bench(const JobContext& job) : job_{job} {}

    Result<std::vector<SpeedCase>> run() {
        const auto cases = {&Bench::headings, &Bench::searches, &Bench::vertices,
                            &Bench::exact,    &Bench::plans,    &Bench::turns};
        double done = 0.0;
        for (const auto part : cases) {
            if (const auto ran = (this->*part)(); !ran) {
                return std::unexpected(ran.error());
            }
            job_.report(++done / static_cast<double>(cases.size()));
        }
        return std::move(cases_);
    }

private:
    /// Uses a measured value, so that the compiler does not remove the work.
    void keep(double value) { kept_ = kept_ + value; }

    Result<void> stopped() const {
        return job_.stopRequested() ? Result<void>{std::unexpected(cancelled())} : Result<void>{};
    }

    /// @param scale  of the yardstick's times
    void addCase(SpeedCase added, const std::function<void()>& ours, const std::function<void()>& yardstick,
                 double scale = 1.0) {
        const PairedTiming timing =
            timedInTurn(ours, yardstick, added.threads == 1 ? processorSeconds : wallSeconds);
        added.runs = timing.ours.runs;
        added.least = timing.ours.least;
        added.median = timing.ours.median;
        if (timing.yardstick) {
            added.yardstickLeast = scale * timing.yardstick->least;
            added.yardstick = scale * timing.yardstick->median;
            added.ratio = scale * *timing.ratio;
        }
        cases_.push_back(std::move(added));
    }

    static SpeedCase caseOf(std::string name, const Polygon& field, int threads) {
        return {.name = std::move(name),
                .areaHa = inHectares(area(field)),
                .vertices = vertexCount({field}),
                .threads = threads};
    }

    Result<void> headings() {
        const Polygon field = waveField(1.0, 20);
        const ScanLine scanLine{{field}, {.width = kTimedWidth, .overlap = {}}};
        int turn = 0;
        const auto next = [&turn] { return degrees(turn++ % kTimedHeadings); };
        addCase(
            caseOf("one heading, number and length of swaths", field, 1),
            [&] { keep(scanLine.lineFigures(next(), SwathObjective::Count).length.si()); },
            [&] { keep(plainFigures(field, kTimedWidth, next(), false).length.si()); });
        addCase(
            caseOf("one heading, all swath objectives", field, 1),
            [&] { keep(scanLine.figures(next()).coverage); },
            [&] { keep(plainFigures(field, kTimedWidth, next(), true).coverage); });
        return stopped();
    }

    Result<void> search(const Polygon& field, std::string_view objective,
                        std::initializer_list<int> threadCounts) {
        const auto settings =
            settingsWith({{"swaths.method", "brute-force"}, {"swaths.objective", objective}});
        const auto whole = fieldOf(field, "bench");
        if (!settings || !whole) {
            return std::unexpected(settings ? whole.error() : settings.error());
        }
        const MultiPolygon mainland{field};
        const Machine machine = paperMachine();
        const SwathTask task{
            .field = **whole, .mainland = mainland, .machine = machine, .settings = *settings};
        // Plain GEOS tries a few of the whole degrees at a time, spread over the half circle.
        const int tried =
            area(field) > kSmallField || vertexCount({field}) > kFewVertices ? kFewestHeadings : kFewHeadings;
        int turn = 0;
        const auto plain = [&] {
            for (int i = 0; i < tried && !job_.stopRequested(); ++i, turn += kStride) {
                keep(plainFigures(field, kTimedWidth, degrees(turn % kTimedHeadings), objective == "coverage")
                         .length.si());
            }
        };
        for (const int threads : threadCounts) {
            addCase(
                caseOf(std::format("best of 180 headings, {}", objective), field, threads),
                [&] {
                    const auto set = swathMethod(*settings).run(
                        task, {.stop = job_.stop, .progress = {}, .threads = threads});
                    keep(set ? set->coverage : 0.0);
                },
                plain, static_cast<double>(kTimedHeadings) / tried);
        }
        return stopped();
    }

    Result<void> searches() {
        for (const double areaHa : {0.25, 1.0, 4.0, 16.0, 64.0, 256.0}) {
            for (const std::string_view objective : {"swath-count", "coverage"}) {
                if (const auto ran = search(waveField(areaHa, 20), objective, {1, 2}); !ran) {
                    return ran;
                }
            }
        }
        return {};
    }

    Result<void> vertices() {
        for (const std::size_t count : {10UZ, 100UZ, 1000UZ, 10000UZ, 100000UZ}) {
            if (const auto ran = search(waveField(16.0, count), "swath-count", {1}); !ran) {
                return ran;
            }
        }
        return {};
    }

    Result<void> exact() {
        Polygon convex;
        for (int i = 0; i < 20; ++i) {
            convex.outer.push_back(
                {1.6 * std::cos(2.0 * std::numbers::pi * i / 20), std::sin(2.0 * std::numbers::pi * i / 20)});
        }
        convex = scaledTo(convex, squareMetres(1e4));
        const MultiPolygon mainland{convex};
        const auto whole = fieldOf(convex, "bench");
        if (!whole) {
            return std::unexpected(whole.error());
        }
        const Machine machine = paperMachine();
        // Whole degrees as well, as the base for the time of the exact search.
        for (const std::string_view objective : {"swath-count", "time"}) {
            for (const auto& [name, method] :
                 {std::pair{"exact search", "exact"}, std::pair{"best of 180 headings", "brute-force"}}) {
                const auto settings =
                    settingsWith({{"swaths.method", method}, {"swaths.objective", objective}});
                if (!settings) {
                    return std::unexpected(settings.error());
                }
                const SwathTask task{
                    .field = **whole, .mainland = mainland, .machine = machine, .settings = *settings};
                addCase(caseOf(std::format("{} of a convex cell, {}", name, objective), convex, 1),
                        [&] {
                            const auto set = swathMethod(*settings).run(
                                task, {.stop = job_.stop, .progress = {}, .threads = 1});
                            keep(set ? set->coverage : 0.0);
                        },
                        {});
            }
        }
        return stopped();
    }

    Result<void> plan(std::string name, const Polygon& shape, OwnSettings own, bool isAudited = true) {
        const auto field = fieldOf(shape, "bench");
        const auto settings = settingsWith(own);
        if (!field || !settings) {
            return std::unexpected(field ? settings.error() : field.error());
        }
        const Machine machine = findMachine("agbot").value();
        for (const int threads : {1, 2}) {
            std::optional<Error> failed;
            const auto makeOne = [&] {
                const auto made = makePlan({.field = *field,
                                            .machine = machine,
                                            .settings = *settings,
                                            .guides = {},
                                            .draft = !isAudited},
                                           {.stop = job_.stop, .progress = {}, .threads = threads});
                if (!made) {
                    failed = made.error();
                }
            };
            addCase(caseOf(name, shape, threads), makeOne, {});
            const auto memory = peakMemoryOf(makeOne);
            if (failed) {
                return std::unexpected(*failed);
            }
            cases_.back().peakMemoryBytes = memory;
        }
        return stopped();
    }

    Result<void> plans() {
        // Headland, heading search, best pattern, Dubins path.
        const OwnSettings plain{{"headland.driven", "false"},        {"swaths.method", "brute-force"},
                                {"swaths.objective", "swath-count"}, {"route.method", "boustrophedon"},
                                {"path.method", "dubins"},           {"path.stay_inside", "false"}};
        const auto all = [&](double areaHa) {
            const Polygon field = waveField(areaHa, 20);
            return plan("whole plan, plain", field, plain, false)
                .and_then([&] { return plan("whole plan, plain, with audit", field, plain); })
                .and_then([&] { return plan("whole plan, default settings, with audit", field, {}); });
        };
        const Polygon ponds = withPonds(waveField(50.0, 40), 5);
        return all(1.0)
            .and_then([&] { return all(64.0); })
            .and_then([&] { return plan("whole plan with 5 obstacles, plain, with audit", ponds, plain); })
            .and_then(
                [&] { return plan("whole plan with 5 obstacles, default settings, with audit", ponds, {}); });
    }

    Result<void> turns() {
        const Machine machine = findMachine("agbot").value();
        const std::pair<std::string_view, TurnPlanner*> methods[] = {
            {"dubins", kDubinsMethod.run},
            {"reeds-shepp", kReedsSheppMethod.run},
            {"dubins-cc", kContinuousDubinsMethod.run},
            {"reeds-shepp-cc", kContinuousReedsSheppMethod.run}};
        constexpr int kTurns = 1000;
        for (const auto& [id, turn] : methods) {
            const PairedTiming many = timedInTurn(
                [&] {
                    for (int i = 0; i < kTurns; ++i) {
                        const Pose to{.position = {2.5 + 0.01 * (i % 7), 0.3 * (i % 11)},
                                      .heading = degrees(180.0 + i % 13)};
                        keep(turn({.position = {}, .heading = degrees(0.0)}, to, machine).length().si());
                    }
                },
                {}, processorSeconds);
            cases_.push_back({.name = std::format("one turn, {}", id),
                              .runs = many.ours.runs * kTurns,
                              .least = (1.0 / kTurns) * many.ours.least,
                              .median = (1.0 / kTurns) * many.ours.median,
                              .yardstickLeast = {},
                              .yardstick = {},
                              .ratio = {}});
        }
        return stopped();
    }

    const JobContext& job_;
    std::vector<SpeedCase> cases_;
    volatile double kept_ = 0.0;
};

}  // namespace

Result<std::vector<SpeedCase>> measureSpeed(const JobContext& job) {
    return Bench{job}.run();
}

}  // namespace furrow
