#include "planner/project/field_tasks.h"

#include "planner/io/import/boundary_import.h"
#include "planner/io/import/guide_import.h"
#include "planner/machine/machine_library.h"
#include "planner/plan/advice.h"
#include "planner/project/project_file.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

Error usage(Message what, Message remedy) {
    return {.code = ErrorCode::Usage,
            .what = std::move(what),
            .where = "--plan-name",
            .remedy = std::move(remedy)};
}

/// Fields with the plans they have; without any for files that are no project.
struct FieldsOfFile {
    std::vector<FieldSource> sources;
    std::optional<Project> project;
};

Result<FieldsOfFile> read(const std::filesystem::path& path, const JobContext& job) {
    if (!holdsProject(path)) {
        return readBoundaries(path, job).transform([](std::vector<FieldSource> sources) {
            return FieldsOfFile{.sources = std::move(sources), .project = {}};
        });
    }
    auto opened = readProject(path);
    if (!opened) {
        return std::unexpected(opened.error());
    }
    if (opened->project.fields.empty()) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "there is no field in this project",
                                     .where = path.string(),
                                     .remedy = "draw or open one in the window first"});
    }
    FieldsOfFile fields;
    for (const auto& field : opened->project.fields) {
        fields.sources.push_back(*field->source);
    }
    for (Message& note : opened->notes) {
        fields.sources.front().repairs.push_back({std::move(note), path.filename().string(), {}});
    }
    fields.project = std::move(opened->project);
    return fields;
}

Result<const FieldPlan*> planOf(const Project& project, std::size_t index,
                                std::optional<std::string_view> name) {
    const std::vector<FieldPlan>& plans = project.fields[index]->plans;
    if (!name) {
        return &project.planOf(index);
    }
    for (const auto member : {&FieldPlan::name, &FieldPlan::id}) {
        const auto found = std::ranges::find(plans, *name, member);
        if (found != plans.end() && std::ranges::count(plans, *name, member) == 1) {
            return &*found;
        }
    }
    Message known;
    for (const FieldPlan& plan : plans) {
        const Message one = plan.name.empty() ? Message{plan.id} : message("{} '{}'", plan.id, plan.name);
        known = known.empty() ? one : message("{}, {}", known, one);
    }
    const bool several = std::ranges::count(plans, *name, &FieldPlan::name) > 1;
    const std::string& field = project.fields[index]->source->name;
    return std::unexpected(several ? usage(message("several plans of '{}' are called '{}'", field, *name),
                                           message("choose one by its id: {}", known))
                                   : usage(message("the field '{}' has no plan '{}'", field, *name),
                                           message("it has: {}", known)));
}

Result<FieldTask> taskOf(const FieldsOfFile& fields, std::size_t index, const TaskWishes& wishes) {
    FieldTask task{.source = fields.sources[index], .machine = machineLibrary().front(), .settings = {}};
    if (fields.project) {
        const auto plan = planOf(*fields.project, index, wishes.planName);
        if (!plan) {
            return std::unexpected(plan.error());
        }
        task.machine = (*plan)->machine;
        task.settings = (*plan)->settings;
    } else if (wishes.planName) {
        return std::unexpected(usage("only the fields of a project have plans",
                                     "leave it out, or give a project of the window"));
    }
    task.machine = wishes.machine.value_or(task.machine);
    task.settings.add(wishes.settings);
    return task;
}

}  // namespace

Result<std::vector<FieldTask>> readFieldTasks(const std::filesystem::path& path, const TaskWishes& wishes,
                                              const JobContext& job) {
    const auto fields = read(path, job);
    if (!fields) {
        return std::unexpected(fields.error());
    }
    std::vector<FieldTask> tasks;
    for (std::size_t i = 0; i < fields->sources.size(); ++i) {
        auto task = taskOf(*fields, i, wishes);
        if (!task) {
            return std::unexpected(task.error());
        }
        tasks.push_back(*std::move(task));
    }
    return tasks;
}

Result<FieldTask> readFieldTask(const std::filesystem::path& path, std::optional<std::string_view> fieldId,
                                const TaskWishes& wishes, const JobContext& job) {
    return read(path, job).and_then([&](const FieldsOfFile& fields) {
        return pickFieldIndex(fields.sources, fieldId).and_then([&](std::size_t index) {
            return taskOf(fields, index, wishes);
        });
    });
}

Result<PlanRequest> planRequest(std::shared_ptr<const Field> field, const Machine& machine,
                                const Settings& settings, const JobContext& job) {
    return readGuides(settings, *field, job).transform([&](std::shared_ptr<const GuideData> guides) {
        return PlanRequest{
            .field = std::move(field), .machine = machine, .settings = settings, .guides = std::move(guides)};
    });
}

Result<std::shared_ptr<const Plan>> planOfSource(const FieldSource& source, const Machine& machine,
                                                 const Settings& settings, const JobContext& job) {
    return Field::create(source, job.part(0.0, 0.1))
        .and_then([&](Field field) {
            return planRequest(std::make_shared<const Field>(std::move(field)), machine, settings, job);
        })
        .and_then([&job](const PlanRequest& request) { return makePlan(request, job.part(0.1, 1.0)); });
}

Result<std::shared_ptr<const Plan>> advisedPlanOfSource(const FieldSource& source, const Machine& machine,
                                                        const Settings& settings, const JobContext& job) {
    return planOfSource(source, machine, settings, job.part(0.0, 0.9)).and_then([&job](const auto& plan) {
        return withAdvice(plan, job.part(0.9, 1.0));
    });
}

}  // namespace furrow
