#include "planner/route/cell_sequence.h"
#include "planner/route/methods.h"
#include "planner/route/patterns.h"

namespace furrow {

namespace {

Result<Route> boustrophedon(const RouteTask& task, const JobContext& job) {
    return routeOverCells(toAndFroOrder, task, job);
}

Result<Route> snake(const RouteTask& task, const JobContext& job) {
    return routeOverCells(snakeOrder, task, job);
}

Result<Route> spiral(const RouteTask& task, const JobContext& job) {
    const auto cluster = static_cast<std::size_t>(*task.settings.count(kCluster));
    return routeOverCells([cluster](std::size_t count) { return spiralOrder(count, cluster); }, task, job);
}

Result<Route> skip(const RouteTask& task, const JobContext& job) {
    const auto skipped = static_cast<std::size_t>(*task.settings.count(kSkip));
    return routeOverCells([skipped](std::size_t count) { return skipOrder(count, skipped); }, task, job);
}

Result<Route> racetrack(const RouteTask& task, const JobContext& job) {
    return routeOverCells(racetrackOrder, task, job);
}

constexpr const Parameter* kCornerOnly[] = {&kCorner};
constexpr const Parameter* kSpiralParameters[] = {&kCluster, &kCorner};
constexpr const Parameter* kSkipParameters[] = {&kSkip, &kCorner};

}  // namespace

const Parameter kCluster{.key = "route.cluster",
                         .name = "Cluster",
                         .description = "Swaths that are finished together.",
                         .kind = ParameterKind::Count,
                         .standard = 6.0,
                         .min = 2.0,
                         .max = 1000.0,
                         .choices = {}};

const Parameter kSkip{.key = "route.skip",
                      .name = "Left out",
                      .description = "Swaths left out at each turn and driven on the way back.",
                      .kind = ParameterKind::Count,
                      .standard = 1.0,
                      .min = 1.0,
                      .max = 1000.0,
                      .choices = {}};

const Method<RoutePlanner> kBoustrophedonMethod{
    .info = {.id = "boustrophedon",
             .name = "To and fro",
             .description = "Every swath after its neighbour, back and forth.",
             .parameters = kCornerOnly},
    .run = boustrophedon,
    .traits = {.isPlain = true}};

const Method<RoutePlanner> kSnakeMethod{
    .info = {.id = "snake",
             .name = "Snake",
             .description = "Every second swath on the way out, the others on the way back.",
             .parameters = kCornerOnly},
    .run = snake,
    .traits = {.isPlain = true}};

const Method<RoutePlanner> kSpiralMethod{
    .info = {.id = "spiral",
             .name = "Spiral in clusters",
             .description = "A snake within each cluster of swaths, cluster after cluster.",
             .parameters = kSpiralParameters},
    .run = spiral};

const Method<RoutePlanner> kSkipMethod{
    .info = {.id = "skip",
             .name = "Skip and fill",
             .description = "Leaves some swaths out at each turn and comes back for them.",
             .parameters = kSkipParameters},
    .run = skip};

const Method<RoutePlanner> kRacetrackMethod{
    .info = {.id = "racetrack",
             .name = "Racetrack",
             .description = "Round and round, with half of the swaths between the way out and the way back.",
             .parameters = kCornerOnly},
    .run = racetrack};

}  // namespace furrow
