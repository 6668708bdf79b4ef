#pragma once

#include "planner/plan/stage_runner.h"

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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
    /// What finishing passes cost with this headland, by the kind of corner. An order or heading hardly
    /// changes it.
    std::map<std::string, FinishingCost> finishing = {};
};

/// The time in which plans are compared.
Duration timeOf(const PlannedStages& plan);

/// Fewer problems, or as many in less time.
bool isBetter(const PlannedStages& other, const PlannedStages& plan);

/// Why a plan is better than another.
Message reasonFor(const PlannedStages& better, const PlannedStages& other);

/// Parts of a path (swaths, turns, ways, passes) and corners of the field. With more of them the plan as
/// asked is taken: some twenty would be driven and audited to compare its headings, orders, corners and
/// simpler choices. A note tells so.
inline constexpr std::size_t kMostCompared = 8'000;
bool isTooLargeToCompare(const PlannedStages& plan);

/// Whether other plans are driven beside this one: not for a draft.
bool isCompared(const PlannedStages& asked);

/// The value that was used for a setting; another one may have been noted before.
void note(std::vector<SettingChange>& instead, const Parameter& parameter, std::string_view value);

/// An order of one's own names the swaths of just these choices.
bool hasOwnOrder(const Settings& settings);

/// The request with all swaths in this direction.
PlanRequest along(PlanRequest request, Angle heading);

/// Share of the plan as asked in the progress of a plan that is improved: the median of real fields.
inline constexpr double kAskedShare = 0.35;
/// The same where others are compared only if it cannot be driven: mostly it can.
inline constexpr double kAskedAloneShare = 0.9;

/// Whom a chooser tells; each may be empty.
struct ChoosingCourse {
    std::function<void(const PlannedStages&)>
        asked;  ///< the plan as asked, before others are compared with it
    std::function<void(std::size_t done, std::size_t known)> compared;  ///< see PlanCourse
};

/// Plans requests and what they leave to the planner, and compares the plans as driven.
class PlanChooser {
public:
    explicit PlanChooser(StageRunner& runner, ChoosingCourse course = {})
        : runner_{runner}, course_{std::move(course)} {}

    /// The plan as asked, with what is left to the planner decided by the time of the driven path: heading,
    /// order and corners. Errors: those of the stages. Cancelled.
    Result<BestSoFar> improved(const PlanRequest& request, const JobContext& job);

    /// The plan of another request with the headings as it asks, and its own best order and corners. Empty if
    /// it blocks more, or takes more than 6 % longer than the best plan before (15 % with up to 8 swaths).
    /// With more than 40 swaths it keeps its first order and corners where it takes more than 1 % longer.
    /// Cancelled.
    Result<std::optional<BestSoFar>> changed(const BestSoFar& best, const PlanRequest& asked,
                                             const JobContext& job);

private:
    struct Comparison;
    Result<std::optional<BestSoFar>> changed(const BestSoFar& best, const PlanRequest& asked,
                                             const Comparison& comparison, const PlannedStages* rival,
                                             const JobContext& job);
    template <class Make>
    Result<void> takeBest(BestSoFar& best, std::size_t count, const Make& make, const JobContext& job);
    Result<std::optional<PlannedStages>> nearPlan(const PlannedStages& best, const PlanRequest& other,
                                                  const Comparison& comparison, const JobContext& job);
    Result<void> tryCorners(BestSoFar& best, const JobContext& job);
    Result<void> decideOrderAndCorners(BestSoFar& best, const PlannedStages* rival, const JobContext& job);
    Result<std::optional<BestSoFar>> inOrder(const BestSoFar& best, const PlannedStages* rival,
                                             std::string_view pattern, QuickestMeanwhile& meanwhile,
                                             const JobContext& job);
    Result<std::optional<BestSoFar>> alongHeading(const BestSoFar& best, const HeadingCandidate& candidate,
                                                  const JobContext& job);
    void expect(std::size_t plans);
    void tellCompared();

    StageRunner& runner_;
    ChoosingCourse course_;
    std::mutex mutex_;  ///< of the next two
    std::size_t known_ = 0;
    std::size_t compared_ = 0;
};

}  // namespace furrow
