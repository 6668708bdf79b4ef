#pragma once

#include "planner/core/result.h"
#include "planner/machine/machine.h"
#include "planner/settings/settings.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace furrow::cli {

/// What `plan` and `batch` are told in the same words.
struct PlanningArguments {
    std::string machine;
    std::optional<std::string> operation;
    std::string settingsFile;
    std::vector<std::string> assignments;
    int threads = 0;
    std::string out;
    std::vector<std::string> formats;
    bool json = false;
    bool quiet = false;
};

/// The options that fill them; `arguments` must live until the line is parsed.
void addPlanningOptions(CLI::App& command, PlanningArguments& arguments);

/// What the words mean; no machine where none is named.
struct PlanningChoices {
    std::optional<Machine> machine;
    Settings settings;
    std::vector<std::string_view> formats;
};

/// @param formats  where none are named
/// Errors: Usage; those of the machine's and the settings' file.
Result<PlanningChoices> choicesFrom(const PlanningArguments& arguments,
                                    std::span<const std::string_view> formats);

}  // namespace furrow::cli
