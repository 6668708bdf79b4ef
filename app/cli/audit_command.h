#pragma once

#include <CLI/CLI.hpp>

#include <functional>

namespace furrow::cli {

/// Adds `audit DIR|PLAN.geojson ...`; what was asked for ends up in `run`.
void addAuditCommand(CLI::App& app, std::function<int()>& run);

}  // namespace furrow::cli
