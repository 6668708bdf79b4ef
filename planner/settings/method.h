#pragma once

#include "planner/settings/parameter.h"

#include <span>
#include <string_view>

namespace furrow {

/// One method as people and programs see it.
struct MethodInfo {
    std::string_view id;                           ///< as in settings: "brute-force"
    std::string_view name;                         ///< "Every heading"
    std::string_view description;                  ///< one sentence
    std::span<const Parameter* const> parameters;  ///< those that only this method (or a few) reads
};

/// What other stages ask about the methods of a stage. A stage whose methods differ in more than their result
/// declares its own.
template <class Signature>
struct MethodTraits {};

/// A method that is described and can be run. `Signature` is the common one of its stage.
template <class Signature>
struct Method {
    MethodInfo info;
    Signature* run;
    MethodTraits<Signature> traits = {};
};

}  // namespace furrow
