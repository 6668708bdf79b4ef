#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// Adds every command of furrow-cli, with name, version and help; what was asked for ends up in `run`.
/// `argv` is what is handed over to the program that prints.
void addCommands(CLI::App& app, std::function<int()>& run, char** argv);

}  // namespace furrow::cli
