#include "app/cli/export_arguments.h"

#include "app/cli/terminal.h"

#include <format>

namespace furrow::cli {

std::string checkSummary(const ExportChecks& checks) {
    std::string made;
    for (const std::string_view id : checks.made) {
        made += std::format("{}{}", made.empty() ? "" : ", ", id);
    }
    const std::size_t problems = checks.problems.size();
    return problems == 0 ? std::format("nothing wrong found ({})", made)
                         : std::format("{} {} ({})", problems, problems == 1 ? "problem" : "problems", made);
}

void printProblems(const ExportChecks& checks) {
    for (const std::string& problem : checks.problems) {
        say(stderr, "Warning: {}", problem);
    }
}

void addExportOptions(CLI::App& command, ExportOptions& options, bool ofPlans) {
    command.add_flag("--holes-as-obstacles", options.holesAsObstacles,
                     "ISOXML: holes as areas of their own, for terminals that overlook inner rings");
    command.add_flag("--ascii-names", options.asciiNames, "ISOXML, AgOpenGPS: names in plain letters");
    command.add_flag("--task", options.task,
                     "ISOXML: a planned task for each field, for terminals that show lines in tasks only");
    if (ofPlans) {
        command.add_flag("--headland-lines", options.headlandLines,
                         "Headland passes as guidance curves of their own (ISOXML, AgOpenGPS, AgGPS)");
    }
}

}  // namespace furrow::cli
