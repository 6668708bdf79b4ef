#pragma once

#include "planner/plan/heading_curve.h"

#include <string_view>
#include <vector>

namespace furrow {

/// Why a step of the plan came out as it did, in one or two sentences with numbers.
struct Explanation {
    std::string_view step;  ///< id of a stage, or "field", "check"
    Message text;

    friend bool operator==(const Explanation&, const Explanation&) = default;
};

/// One for each step that something can be said about, in the order of the steps. Times of headings and
/// orders are estimates of the searches: to and fro in the mainland, and turns in free space.
/// @param curve  of this plan, where it has one
/// Cost: a route in a pattern, some milliseconds; seconds for thousands of swaths. Cancelled.
Result<std::vector<Explanation>> explanations(const Plan& plan, const std::optional<HeadingCurve>& curve,
                                              const JobContext& job = {});

}  // namespace furrow
