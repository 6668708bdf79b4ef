#include "planner/benchmarks/speed.h"

#include "planner/benchmarks/geos_yardstick.h"
#include "planner/benchmarks/paper_settings.h"
#include "planner/benchmarks/peak_memory.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/method_registry.h"
#include "planner/plan/plan.h"
#include "planner/swaths/scan_line.h"
#include "planner/turns/continuous_curvature.h"
#include "planner/turns/dubins.h"
#include "planner/turns/reeds_shepp.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <format>
#include <functional>
#include <initializer_list>
#include <numbers>
#include <utility>

namespace furrow {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kHeadings = 180;
constexpr Length kWidth = metres(2.5);
// A case is repeated until this time has passed, within the limits for the number of runs.
constexpr double kEnoughS = 0.3;
constexpr int kFewestRuns = 3;
constexpr int kMostRuns = 2000;

struct Measured {
    Duration median;
    int runs = 0;
};

Measured measured(const std::function<void()>& work) {
    std::vector<double> times;
    double sum = 0.0;
    while (static_cast<int>(times.size()) < kFewestRuns ||
           (sum < kEnoughS && static_cast<int>(times.size()) < kMostRuns)) {
        const Clock::time_point begin = Clock::now();
        work();
        times.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
        sum += times.back();
    }
    std::ranges::nth_element(times, times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2));
    return {seconds(times[times.size() / 2]), static_cast<int>(times.size())};
}

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

    void add(std::string name, const Polygon& field, int threads, const Measured& ours,
             std::optional<Duration> yardstick) {
        cases_.push_back({.name = std::move(name),
                          .areaHa = inHectares(area(field)),
                          .vertices = vertexCount({field}),
                          .threads = threads,
                          .runs = ours.runs,
                          .median = ours.median,
                          .yardstick = yardstick});
    }

    Result<void> headings() {
        const Polygon field = waveField(1.0, 20);
        const ScanLine scanLine{{field}, {.width = kWidth, .overlap = {}}};
        int turn = 0;
        const auto next = [&turn] { return degrees(turn++ % kHeadings); };
        const Measured lines =
            measured([&] { keep(scanLine.lineFigures(next(), SwathObjective::Count).length.si()); });
        add("one heading, number and length of swaths", field, 1, lines,
            measured([&] { keep(plainFigures(field, kWidth, next(), false).length.si()); }).median);
        const Measured all = measured([&] { keep(scanLine.figures(next()).coverage); });
        add("one heading, all swath objectives", field, 1, all,
            measured([&] { keep(plainFigures(field, kWidth, next(), true).coverage); }).median);
        return stopped();
    }

    /// Every whole degree by plain GEOS. On large fields every n-th, scaled.
    Duration plainSearch(const Polygon& field, bool withCoverage) {
        const double perHeading = area(field).si() / 1e4;
        const int every = perHeading > 16.0 ? 30 : perHeading > 1.0 || vertexCount({field}) > 1000 ? 10 : 1;
        const Clock::time_point begin = Clock::now();
        int tried = 0;
        for (int deg = 0; deg < kHeadings && !job_.stopRequested(); deg += every, ++tried) {
            keep(plainFigures(field, kWidth, degrees(deg), withCoverage).length.si());
        }
        const double tookS = std::chrono::duration<double>(Clock::now() - begin).count();
        return seconds(tookS * kHeadings / std::max(1, tried));
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
        const Duration plain = plainSearch(field, objective == "coverage");
        for (const int threads : threadCounts) {
            const Measured ours = measured([&] {
                const auto set =
                    swathMethod(*settings).run(task, {.stop = job_.stop, .progress = {}, .threads = threads});
                keep(set ? set->coverage : 0.0);
            });
            add(std::format("best of 180 headings, {}", objective), field, threads, ours, plain);
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
                add(std::format("{} of a convex cell, {}", name, objective), convex, 1, measured([&] {
                        const auto set = swathMethod(*settings).run(
                            task, {.stop = job_.stop, .progress = {}, .threads = 1});
                        keep(set ? set->coverage : 0.0);
                    }),
                    std::nullopt);
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
            const Measured ours = measured(makeOne);
            const auto memory = peakMemoryOf(makeOne);
            if (failed) {
                return std::unexpected(*failed);
            }
            add(name, shape, threads, ours, std::nullopt);
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
            const Measured many = measured([&] {
                for (int i = 0; i < kTurns; ++i) {
                    const Pose to{.position = {2.5 + 0.01 * (i % 7), 0.3 * (i % 11)},
                                  .heading = degrees(180.0 + i % 13)};
                    keep(turn({.position = {}, .heading = degrees(0.0)}, to, machine).length().si());
                }
            });
            cases_.push_back({.name = std::format("one turn, {}", id),
                              .runs = many.runs * kTurns,
                              .median = (1.0 / kTurns) * many.median,
                              .yardstick = {}});
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
