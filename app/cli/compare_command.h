#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// `furrow-cli compare PLAN_DIR TRACK [--json] [--out DIR]`
void addCompareCommand(CLI::App& app, std::function<int()>& run);

}  // namespace furrow::cli
