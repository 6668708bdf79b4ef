#pragma once

#include "planner/io/export_job.h"

#include <CLI/CLI.hpp>

namespace furrow::cli {

/// The options of formats for terminals; `options` must live until the line is parsed.
/// @param ofPlans  also those that only a plan has
void addExportOptions(CLI::App& command, ExportOptions& options, bool ofPlans);

}  // namespace furrow::cli
