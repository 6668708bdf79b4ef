#pragma once

#include "planner/project/json_members.h"
#include "planner/project/review.h"

namespace furrow {

/// A review as the member `review` of a plan; not for an empty one.
OrderedJson reviewJson(const Review& review);
/// The same back. Throws what nlohmann throws where members are missing or of another kind.
Review reviewFrom(const OrderedJson& json);

}  // namespace furrow
