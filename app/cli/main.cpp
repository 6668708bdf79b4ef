#include "app/cli/command_line.h"
#include "app/cli/exit_status.h"
#include "app/cli/terminal.h"
#include "planner/core/text.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

namespace {

using namespace furrow::cli;

/// An empty value is a mistake of the calling script, not a wish for the default; "nan" is one, too.
void refuseEmptyValues(CLI::App& app) {
    const CLI::Validator isSaid{[](const std::string& value) {
                                    return value.empty() ? std::string{"an empty value"} : std::string{};
                                },
                                ""};
    const CLI::Validator isNumber{
        [](const std::string& value) {
            const auto number = furrow::numberIn(value);
            return number && !std::isfinite(*number) ? value + " is no finite number" : std::string{};
        },
        ""};
    for (CLI::App* command : app.get_subcommands({})) {
        for (CLI::Option* option : command->get_options()) {
            if (option->get_type_name().starts_with("FLOAT")) {
                option->check(isNumber);
            }
            if (option->get_expected_max() > 0) {
                option->check(isSaid);
            }
        }
        refuseEmptyValues(*command);
    }
}

}  // namespace

int main(int argc, char** argv) {
    using namespace furrow::cli;
    CLI::App app;
    std::function<int()> run;
    addCommands(app, run, argv);
    refuseEmptyValues(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return app.exit(asked);  // --help and --version
    } catch (const CLI::ParseError& error) {
        std::string what = error.what();
        say(stderr, "furrow-cli: {}; see furrow-cli --help", what.substr(0, what.find('\n')));
        return kWrongUsage;
    }
    return ranAndWritten(run);
}
