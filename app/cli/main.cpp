#include "app/cli/command_line.h"
#include "app/cli/exit_status.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <functional>
#include <print>
#include <string>

int main(int argc, char** argv) {
    using namespace furrow::cli;
    CLI::App app;
    std::function<int()> run;
    addCommands(app, run, argv);
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
