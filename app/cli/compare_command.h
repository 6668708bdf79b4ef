#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// Adds `compare PLAN_DIR TRACK ...`; what was asked for ends up in `run`.
void addCompareCommand(CLI::App& app, std::function<int()>& run);

}  // namespace furrow::cli
