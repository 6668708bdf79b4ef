#pragma once

#include "planner/project/project.h"

#include <string>

namespace furrow {

/// All that a plan follows from, as one text: outlines and names of the field, machine, settings with the
/// size and age of files that they name. Equal texts give equal plans by the same version of Furrow.
std::string planInputs(const FieldSource& field, const Machine& machine, const Settings& settings);

/// The outlines, obstacles, gates and edges of a field as text.
std::string fieldInputs(const FieldSource& field);
std::string settingInputs(const Settings& settings);

/// A short fingerprint of planInputs: tells whether a field or its plan has changed since.
std::string planKey(const FieldSource& field, const FieldPlan& plan);

}  // namespace furrow
