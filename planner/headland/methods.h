#pragma once

#include "planner/headland/headland.h"
#include "planner/settings/method.h"

namespace furrow {

extern const Parameter kHeadlandWidth;
extern const Parameter kHeadlandPasses;

extern const Method<HeadlandGenerator> kConstantWidthMethod;
extern const Method<HeadlandGenerator> kPerEdgeMethod;
extern const Method<HeadlandGenerator> kNoHeadlandMethod;

}  // namespace furrow
