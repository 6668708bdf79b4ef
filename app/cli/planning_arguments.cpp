#include "app/cli/planning_arguments.h"

#include "app/cli/machine_argument.h"
#include "planner/io/formats/registry.h"
#include "planner/io/plan_files/settings_file.h"
#include "planner/plan/method_registry.h"
#include "planner/settings/operation.h"

#include <format>
#include <utility>

namespace furrow::cli {

namespace {

/// Settings file first, then --set in their order, then --operation.
Result<Settings> settingsFrom(const PlanningArguments& arguments) {
    Settings settings;
    Result<void> applied;
    if (!arguments.settingsFile.empty()) {
        applied = applySettingsFile(settings, arguments.settingsFile);
    }
    for (const std::string& assignment : arguments.assignments) {
        const std::size_t equals = assignment.find('=');
        if (applied && equals == std::string::npos) {
            applied =
                std::unexpected(Error{.code = ErrorCode::Usage,
                                      .what = std::format("'{}' has no '='", assignment),
                                      .where = "--set",
                                      .remedy = "write key=value, for example --set headland.passes=2"});
        }
        if (applied) {
            applied = applySetting(settings, assignment.substr(0, equals), assignment.substr(equals + 1));
        }
    }
    if (applied && arguments.operation) {
        applied = settings.setText(kOperationKind, *arguments.operation);
    }
    if (!applied) {
        return std::unexpected(applied.error());
    }
    return settings;
}

}  // namespace

void addPlanningOptions(CLI::App& command, PlanningArguments& arguments) {
    command.add_option(
        "--machine", arguments.machine,
        "A machine of furrow-cli list machines, or a machine file (default: the first of the list,\nof a project its plan's)");
    command.add_option("--operation", arguments.operation,
                       "tillage, sowing, spraying, spreading, mowing or harvest: sets headland.when,\n"
                       "route.traversal and swaths.overlap_m where they are not given");
    command.add_option("--settings", arguments.settingsFile, "A JSON file of settings");
    command
        .add_option("--set", arguments.assignments,
                    "One setting, for example headland.width_m=12; may be given several times")
        ->take_all()
        ->allow_extra_args(false);
    command
        .add_option("--threads", arguments.threads,
                    "Threads to plan with (default: all); the plan is the same")
        ->check(CLI::Range(1, 1024));
    command.add_option("--out", arguments.out, "The folder to write to; made if it is not there")->required();
    command
        .add_option("--format", arguments.formats,
                    "What to write besides summary.json (see furrow-cli list formats)")
        ->delimiter(',');
    command.add_flag("--json", arguments.json, "Print one JSON object and nothing else");
    command.add_flag("--quiet", arguments.quiet, "Print nothing but errors");
}

Result<PlanningChoices> choicesFrom(const PlanningArguments& arguments,
                                    std::span<const std::string_view> formats) {
    auto settings = settingsFrom(arguments);
    if (!settings) {
        return std::unexpected(settings.error());
    }
    std::vector<std::string_view> ids{arguments.formats.begin(), arguments.formats.end()};
    if (ids.empty()) {
        ids.assign(formats.begin(), formats.end());
    }
    for (const std::string_view id : ids) {
        if (const auto known = findPlanFormat(id); !known) {
            return std::unexpected(known.error());
        }
    }
    std::optional<Machine> machine;
    if (!arguments.machine.empty()) {
        auto named = machineFrom(arguments.machine);
        if (!named) {
            return std::unexpected(named.error());
        }
        machine = *std::move(named);
    }
    return PlanningChoices{std::move(machine), std::move(*settings), std::move(ids)};
}

}  // namespace furrow::cli
