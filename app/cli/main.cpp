#include "app/cli/audit_command.h"
#include "app/cli/batch_command.h"
#include "app/cli/bench_command.h"
#include "app/cli/compare_command.h"
#include "app/cli/convert_command.h"
#include "app/cli/exit_status.h"
#include "app/cli/list_command.h"
#include "app/cli/plan_command.h"
#include "app/cli/report_command.h"
#include "planner/version.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <functional>
#include <print>
#include <string>

int main(int argc, char** argv) {
    using namespace furrow::cli;
    CLI::App app{"Furrow plans how a machine covers a farm field: headland, swaths, route and turns."};
    app.name("furrow-cli");
    app.set_version_flag("--version", "furrow " + std::string{furrow::kVersion});
    app.require_subcommand(1);
    app.footer("furrow-cli COMMAND --help explains a command.");
    std::function<int()> run;
    addPlanCommand(app, run);
    addBatchCommand(app, run);
    addBenchCommand(app, run);
    addCompareCommand(app, run);
    addConvertCommand(app, run);
    addReportCommand(app, run, [argv](const ReportArguments&) { return handOverToReport(argv); });
    addAuditCommand(app, run);
    addListCommand(app, run);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return app.exit(asked);  // --help and --version
    } catch (const CLI::ParseError& error) {
        std::string what = error.what();
        std::println(stderr, "furrow-cli: {}; see furrow-cli --help", what.substr(0, what.find('\n')));
        return kWrongUsage;
    }
    try {
        return run();
    } catch (const std::exception& error) {
        // What is left to end up here is running out of memory.
        std::println(stderr, "furrow-cli: {}; the field may be too large for this computer", error.what());
        return kInputRefused;
    }
}
