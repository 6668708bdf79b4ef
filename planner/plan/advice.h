#pragma once

#include "planner/plan/plan.h"

namespace furrow {

/// The same plan with advice for what blocks it. Changes of one setting are planned: those that were given
/// back to what they are by themselves, and one headland pass more where something leaves the field. A
/// blocking finding gets the first change after which it is gone and nothing else blocks that did not before;
/// what no change mends gets none, but says where the field is too narrow for the machine or its turns. Cost:
/// at most four plans, none for a plan that can be driven. Cancelled.
Result<std::shared_ptr<const Plan>> withAdvice(const std::shared_ptr<const Plan>& plan,
                                               const JobContext& job = {}, StageCache* cache = nullptr);

}  // namespace furrow
