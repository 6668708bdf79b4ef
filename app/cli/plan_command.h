#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// Adds `plan FIELD ...`; what was asked for ends up in `run`.
void addPlanCommand(CLI::App& app, std::function<int()>& run);

}  // namespace furrow::cli
