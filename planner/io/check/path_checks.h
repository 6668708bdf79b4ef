#pragma once

#include "planner/core/message.h"
#include "planner/io/content/received_content.h"

#include <optional>

namespace furrow {

struct Plan;

/// What a written path is looked at for, against the plan that was meant. The first thing that is wrong, if
/// any. Cost of each: linear in the samples of both.
using PathCheck = std::optional<Message>(const ReceivedPath& path, const Plan& plan);

PathCheck
    pathFollowed;      ///< every sample lies on the plan's path, in its order; a whole one from start to end
PathCheck pathLength;  ///< of a whole path: as long as the plan's, to 1 %
PathCheck pathTimes;   ///< never fall, and do not all stand still
PathCheck pathHeadings;  ///< along the motion, or against it in reverse
PathCheck pathSpeeds;    ///< not negative; the largest of a whole path is the plan's, to a tenth

}  // namespace furrow
