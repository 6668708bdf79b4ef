#pragma once

#include "planner/io/content/export_job.h"

#include <CLI/CLI.hpp>

#include <string>

namespace furrow::cli {

/// The options of formats for terminals; `options` must live until the line is parsed.
/// @param ofPlans  also those that only a plan has
void addExportOptions(CLI::App& command, ExportOptions& options, bool ofPlans);

/// In one line: what was looked at, and how much was found.
std::string checkSummary(const ExportChecks& checks);

/// What receivers would stumble over, on standard error, a line each: whatever is printed otherwise.
void printProblems(const ExportChecks& checks);

}  // namespace furrow::cli
