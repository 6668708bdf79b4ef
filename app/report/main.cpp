// What `furrow-cli report` starts: the part of the command line that draws, and so needs Qt.

#include "app/cli/exit_status.h"
#include "app/cli/report_command.h"
#include "app/cli/terminal.h"
#include "app/report/report.h"
#include "planner/version.h"
#include "ui/text/fonts.h"

#include <CLI/CLI.hpp>

#include <QGuiApplication>

#include <cstdio>
#include <functional>
#include <print>
#include <string>

int main(int argc, char** argv) {
    using namespace furrow::cli;
    CLI::App app{"Prints work orders; started by furrow-cli report."};
    app.name("furrow-cli");
    app.set_version_flag("--version", "furrow " + std::string{furrow::kVersion});
    app.require_subcommand(1);
    std::function<int()> run;
    // Before Qt makes threads.
    const InterruptWatch watch;
    addReportCommand(app, run,
                     [&watch](const ReportArguments& arguments) { return runReport(arguments, watch); });
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        const std::string what = error.what();
        std::println(stderr, "furrow-cli: {}; see furrow-cli --help", what.substr(0, what.find('\n')));
        return kWrongUsage;
    }
    return ranAndWritten([&] {
        // Without a display, and whatever the user's desktop says.
        qputenv("QT_QPA_PLATFORM", "offscreen");
        QGuiApplication::setDesktopSettingsAware(false);
        const QGuiApplication application{argc, argv};
        furrow::loadFonts();
        return run();
    });
}
