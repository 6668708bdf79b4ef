#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// Adds `list fields|methods|machines|formats`; what was asked for ends up in `run`.
void addListCommand(CLI::App& app, std::function<int()>& run);

}  // namespace furrow::cli
