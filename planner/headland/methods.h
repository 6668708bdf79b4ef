#pragma once

#include "planner/headland/headland.h"
#include "planner/settings/method.h"

#include <array>

namespace furrow {

extern const Parameter kHeadlandWidth;
extern const Parameter kHeadlandPasses;

extern const Method<HeadlandGenerator> kConstantWidthMethod;
extern const Method<HeadlandGenerator> kPerEdgeMethod;
extern const Method<HeadlandGenerator> kNoHeadlandMethod;

/// Every method of the stage, the default first.
inline constexpr std::array kHeadlandMethods{
    &kConstantWidthMethod,
    &kPerEdgeMethod,
    &kNoHeadlandMethod,
};

}  // namespace furrow
