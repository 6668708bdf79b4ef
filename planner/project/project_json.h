#pragma once

#include "planner/project/json_members.h"
#include "planner/project/project.h"

#include <vector>

namespace furrow {

// A project and its fields as JSON: what the project file and the history have in common. Those that read
// throw what nlohmann throws where members are missing or of another kind.

/// The property of features that are made anew with each review file: no part of a project.
inline constexpr const char* kDrawnOnly = "drawn_only";

/// What could not be used as it is and was kept all the same.
using Notes = std::vector<Message>;

/// The features of a field: itself, its obstacles, its gates.
OrderedJson featuresOf(const ProjectField& field);
/// Its plans, each with the id of the field.
OrderedJson plansOf(const ProjectField& field);

/// A field of such features and plans. Where there is no plan, it gets `standard` under the id `planId`.
ProjectField fieldOf(const OrderedJson& features, const OrderedJson& plans, const FieldPlan& standard,
                     const std::string& planId, Notes& notes);

/// What a project holds besides its fields: name, what is current (by id), standard plan.
OrderedJson headOf(const Project& project);
/// The same back; `project` has its fields already.
void readHead(const OrderedJson& head, Project& project, Notes& notes);

}  // namespace furrow
