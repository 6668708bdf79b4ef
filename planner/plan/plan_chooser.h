#pragma once

#include "planner/plan/stage_runner.h"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace furrow {

/// The best plan so far.
struct BestSoFar {
    PlanRequest asked;                            ///< before anything was decided
    PlannedStages plan;                           ///< whose request has all that was decided
    std::vector<HeadingCandidate> headings = {};  ///< of the search
    std::vector<SettingChange> instead = {};      ///< see Plan::instead
    std::vector<Note> notes = {};
    /// Kinds of corner that may be the quickest with this headland: all until they are compared, then those
    /// that came near. Another order or heading hardly changes what a corner costs.
    std::optional<std::vector<std::string_view>> nearCorners = {};
};

/// The time in which plans are compared.
Duration timeOf(const PlannedStages& plan);

/// Fewer problems, or as many in less time.
bool isBetter(const PlannedStages& other, const PlannedStages& plan);

/// Why a plan is better than another.
Message reasonFor(const PlannedStages& better, const PlannedStages& other);

/// The value that was used for a setting; another one may have been noted before.
void note(std::vector<SettingChange>& instead, const Parameter& parameter, std::string_view value);

/// An order of one's own names the swaths of just these choices.
bool hasOwnOrder(const Settings& settings);

/// The request with all swaths in this direction.
PlanRequest along(PlanRequest request, Angle heading);

/// Plans requests and what they leave to the planner, and compares the plans as driven.
class PlanChooser {
public:
    PlanChooser(StageRunner& runner, const JobContext& job)
        : runner_{runner}, quiet_{job.withoutProgress()} {}

    /// The plan as asked, with what is left to the planner decided by the time of the driven path: heading,
    /// order and corners. Errors: those of the stages. Cancelled.
    ///
    /// @param progress  of the plan as asked; may be empty
    Result<BestSoFar> improved(const PlanRequest& request, const std::function<void(double)>& progress);

    /// The plan of another request with the headings as it asks, and its own best order and corners. Empty if
    /// it blocks more, or takes more than 6 % longer than the best plan before. Cancelled.
    Result<std::optional<BestSoFar>> changed(const BestSoFar& best, const PlanRequest& asked);

private:
    template <class Make>
    Result<void> takeBest(BestSoFar& best, std::size_t count, const Make& make);
    Result<std::optional<PlannedStages>> nearPlan(const BestSoFar& best, const PlanRequest& other,
                                                  double near, QuickestMeanwhile* meanwhile = nullptr);
    Result<void> tryCorners(BestSoFar& best);
    Result<void> decideOrderAndCorners(BestSoFar& best);
    Result<std::optional<BestSoFar>> inOrder(const BestSoFar& best, std::string_view pattern);
    Result<std::optional<BestSoFar>> alongHeading(const BestSoFar& best, const HeadingCandidate& candidate);

    StageRunner& runner_;
    JobContext quiet_;
};

}  // namespace furrow
