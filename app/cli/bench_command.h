#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// Adds `bench paper ...`; what was asked for ends up in `run`.
void addBenchCommand(CLI::App& app, std::function<int()>& run);

}  // namespace furrow::cli
