#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>

namespace furrow::cli {

struct ReportArguments {
    std::string source;
    std::optional<std::string> fieldId;
    std::string out;
    std::string paper = "a4";
    std::string order;
    std::string language = "en";
    std::string units = "metric";
    int threads = 0;
};

/// Adds `report PLAN_DIR|PROJECT ...`; what was asked for ends up in `run`, which hands it to `print`.
void addReportCommand(CLI::App& app, std::function<int()>& run,
                      std::function<int(const ReportArguments&)> print);

/// Hands the whole line to furrow-report, which lies beside this program or in libexec/furrow. It alone needs
/// Qt: what every other command would lose by loading it is a third of its start.
///
/// @return only where there is no such program: kReadOrWriteFailed, after a line on standard error
int handOverToReport(char** argv);

}  // namespace furrow::cli
