#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// `furrow-cli batch`: every field of some files.
void addBatchCommand(CLI::App& app, std::function<int()>& run);

}  // namespace furrow::cli
