#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// Adds `convert IN OUT`; what was asked for ends up in `run`.
void addConvertCommand(CLI::App& app, std::function<int()>& run);

}  // namespace furrow::cli
