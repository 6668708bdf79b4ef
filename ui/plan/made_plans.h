#pragma once

#include "planner/core/result.h"
#include "planner/jobs/job.h"
#include "planner/plan/plan.h"
#include "planner/project/project.h"

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace furrow {

/// A finished plan, and whether advice for what blocks it was looked for (withAdvice).
struct MadePlan {
    std::shared_ptr<const Plan> plan;
    bool advised = false;

    explicit operator bool() const { return plan != nullptr; }
};

/// Finished plans of a farm's fields, by what they were made from (planKey): what was planned in the window,
/// in the background or on the way to paper and files is not planned again for the next of these. Whole
/// plans, the latest ones that have at most `kMostSamples` points of their paths together; the memory of
/// those is some 150 MB. For the GUI thread only.
class MadePlans {
public:
    static constexpr std::size_t kMostSamples = 2'000'000;

    explicit MadePlans(std::size_t mostSamples = kMostSamples) : mostSamples_{mostSamples} {}

    void keep(const std::string& planKey, const MadePlan& made);
    /// The plan of a field as it is now; without a plan where there is none.
    MadePlan find(const ProjectField& field, const FieldPlan& wanted) const;
    std::size_t size() const { return plans_.size(); }

private:
    struct Kept {
        MadePlan made;
        std::size_t samples = 0;
        std::size_t age = 0;
    };
    std::size_t mostSamples_;
    std::map<std::string, Kept, std::less<>> plans_;
    std::size_t samples_ = 0;
    std::size_t next_ = 0;
};

/// The plan with advice: the one that is there, with advice where it lacks that, or one that is made. Errors:
/// those of advisedPlanOfSource.
Result<std::shared_ptr<const Plan>> advisedPlan(const MadePlan& there, const FieldSource& source,
                                                const Machine& machine, const Settings& settings,
                                                const JobContext& job);

}  // namespace furrow
