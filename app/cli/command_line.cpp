#include "app/cli/command_line.h"

#include "app/cli/audit_command.h"
#include "app/cli/batch_command.h"
#include "app/cli/bench_command.h"
#include "app/cli/compare_command.h"
#include "app/cli/convert_command.h"
#include "app/cli/list_command.h"
#include "app/cli/plan_command.h"
#include "app/cli/report_command.h"
#include "planner/version.h"

#include <string>

namespace furrow::cli {

void addCommands(CLI::App& app, std::function<int()>& run, char** argv) {
    app.description("Furrow plans how a machine covers a farm field: headland, swaths, route and turns.");
    app.name("furrow-cli");
    app.set_version_flag("--version", "furrow " + std::string{kVersion});
    app.require_subcommand(1);
    app.footer("furrow-cli COMMAND --help explains a command.");
    addPlanCommand(app, run);
    addBatchCommand(app, run);
    addBenchCommand(app, run);
    addCompareCommand(app, run);
    addConvertCommand(app, run);
    addReportCommand(app, run, [argv](const ReportArguments&) { return handOverToReport(argv); });
    addAuditCommand(app, run);
    addListCommand(app, run);
}

}  // namespace furrow::cli
