#pragma once

#include "planner/plan/plan_to_beat.h"
#include "planner/plan/stage_cache.h"
#include "planner/plan/stages.h"

#include <mutex>
#include <optional>

namespace furrow {

/// Wall time of each stage, of all plans that were compared.
struct StageTimings {
    Duration headland;
    Duration swaths;
    Duration route;
    Duration path;
    Duration audit;
    Duration proof;  ///< of the order
    Duration total;  ///< less than their sum where plans were made at once
};

/// All stages of one request.
struct PlannedStages {
    PlanRequest request;
    std::shared_ptr<const Ground> ground;
    LaidOut laidOut;
    std::shared_ptr<const Ordered> ordered;
    std::shared_ptr<const Driven> driven;

    std::ptrdiff_t blockingCount() const;
    bool drivable() const { return blockingCount() == 0; }
};

/// Runs the stages of requests one after the other. A stage is not run again where the cache holds its
/// result. May be used by several threads at once.
class StageRunner {
public:
    explicit StageRunner(StageCache& cache) : cache_{cache} {}

    /// All stages once, with just these settings. Where something blocks near obstacles that swaths go round,
    /// the plan is made again with headlands there, or everywhere.
    ///
    /// @param toBeat  InputRefused for a plan that is no better, as soon as that is known
    /// Errors: those of the stages; InputRefused where the machine fits nowhere in the field. Cancelled.
    Result<PlannedStages> run(const PlanRequest& request, std::optional<PlanToBeat> toBeat,
                              const JobContext& job);

    /// Of all that was run so far, added up over threads. Not while something runs.
    const StageTimings& timings() const { return timings_; }

private:
    Result<std::shared_ptr<const Headland>> headland(const PlanRequest& request,
                                                     const std::shared_ptr<const Ground>& ground,
                                                     const std::vector<Ring>& filled,
                                                     const MultiPolygon& workable, const JobContext& job);
    Result<LaidOut> laidOut(const PlanRequest& request, const std::shared_ptr<const Ground>& ground,
                            std::vector<Ring> round, const JobContext& job);
    Result<PlannedStages> plannedRound(const PlanRequest& request,
                                       const std::shared_ptr<const Ground>& ground, std::vector<Ring> round,
                                       std::optional<PlanToBeat> toBeat, const JobContext& job);

    void add(Duration StageTimings::* stage, Duration taken);
    template <class Run>
    auto timed(Duration StageTimings::* stage, const Run& run);

    StageCache& cache_;
    std::mutex mutex_;
    StageTimings timings_;
};

}  // namespace furrow
