#pragma once

#include "planner/settings/method.h"
#include "planner/swaths/objective.h"
#include "planner/swaths/swath.h"

namespace furrow {

/// How much neighbouring swaths overlap.
extern const Parameter kOverlap;
/// What becomes of the width that is left over.
extern const Parameter kLastPass;
extern const Parameter kStep;
extern const Parameter kAngle;

extern const Method<SwathGenerator> kExactMethod;
extern const Method<SwathGenerator> kBruteForceMethod;
extern const Method<SwathGenerator> kFixedHeadingMethod;
extern const Method<SwathGenerator> kLongestEdgeMethod;

}  // namespace furrow
