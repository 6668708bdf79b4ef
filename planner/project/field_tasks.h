#pragma once

#include "planner/core/result.h"
#include "planner/field/field.h"
#include "planner/jobs/job.h"
#include "planner/machine/machine.h"
#include "planner/plan/plan.h"
#include "planner/settings/settings.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace furrow {

/// A field and what it is to be planned with.
struct FieldTask {
    FieldSource source;
    Machine machine;
    Settings settings;
};

/// What is asked for, whatever a file says.
struct TaskWishes {
    std::optional<std::string_view> planName;  ///< of a project: the plan's name or id
    std::optional<Machine> machine;
    Settings settings;  ///< these win over the plan's
};

/// The fields of a file. Those of a project have the machine and the settings of a plan: of the one that is
/// named, or the current one (of fields that are not worked on now the first), and their edges' own
/// headlands. All others begin with the library's first machine and the standard settings.
///
/// @return in the order of the file. Errors as readBoundaries and readProject. Usage: a plan is named and the
/// file is
///         no project, or one of the fields has no such plan (lists those it has).
Result<std::vector<FieldTask>> readFieldTasks(const std::filesystem::path& path, const TaskWishes& wishes,
                                              const JobContext& job);
/// The same of the field that is meant; see pickField.
Result<FieldTask> readFieldTask(const std::filesystem::path& path, std::optional<std::string_view> fieldId,
                                const TaskWishes& wishes, const JobContext& job);

/// The request for a field that is checked already, with the files that the settings name. Errors as
/// readGuides.
Result<PlanRequest> planRequest(std::shared_ptr<const Field> field, const Machine& machine,
                                const Settings& settings, const JobContext& job);

/// The plan of a field as it was read: checked, requested, planned. Errors: those of the three.
Result<std::shared_ptr<const Plan>> planOfSource(const FieldSource& source, const Machine& machine,
                                                 const Settings& settings, const JobContext& job);

/// The same with advice for what blocks it, as it leaves the program. Errors: those of planOfSource.
Result<std::shared_ptr<const Plan>> advisedPlanOfSource(const FieldSource& source, const Machine& machine,
                                                        const Settings& settings, const JobContext& job);

}  // namespace furrow
