#include "app/cli/command_line.h"
#include "app/manual/program.h"
#include "app/window/arguments.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace furrow::manual {

namespace {

Argument argumentOf(const CLI::Option& option) {
    Argument argument;
    for (const std::string& name : option.get_snames()) {
        argument.names.push_back("-" + name);
    }
    for (const std::string& name : option.get_lnames()) {
        argument.names.push_back("--" + name);
    }
    argument.description = option.get_description();
    argument.required = option.get_required();
    argument.repeated = option.get_items_expected_max() > 1;
    // "TEXT:{a4,letter}", "INT:INT in [1 - 1024]": the type, then the check.
    const std::string type = option.get_type_name();
    const std::size_t colon = type.find(':');
    if (option.get_items_expected_max() > 0) {
        argument.value = argument.names.empty() ? option.get_name(true) : type.substr(0, colon);
    }
    if (colon != std::string::npos && type[colon + 1] == '{') {
        argument.offer = Offer::Words;
        argument.words = CLI::detail::split(type.substr(colon + 2, type.rfind('}') - colon - 2), ',');
    }
    return argument;
}

Program programOf(const CLI::App& app, const std::string& above) {
    Program program;
    program.name = above.empty() ? app.get_name() : above + " " + app.get_name();
    program.description = app.get_description();
    // A command without a footer of its own has that of the command above it.
    if (app.get_parent() == nullptr || app.get_footer() != app.get_parent()->get_footer()) {
        program.footer = app.get_footer();
    }
    for (const CLI::Option* option : app.get_options()) {
        Argument argument = argumentOf(*option);
        addOffer(program, argument);
        (argument.names.empty() ? program.places : program.options).push_back(std::move(argument));
    }
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        program.commands.push_back(programOf(*command, program.name));
    }
    return program;
}

}  // namespace

Program commandLineProgram() {
    CLI::App app;
    std::function<int()> run;
    cli::addCommands(app, run, nullptr);
    return programOf(app, {});
}

Program windowProgram() {
    Program program;
    program.name = "furrow";
    program.description = windowDescription().toStdString();
    program.places.push_back({.names = {},
                              .value = "FILE",
                              .description = "A project or a boundary file to open.",
                              .offer = Offer::File,
                              .words = {}});
    program.options.push_back(
        {.names = {"-h", "--help"}, .value = {}, .description = "Tell the options and end.", .words = {}});
    program.options.push_back(
        {.names = {"-v", "--version"}, .value = {}, .description = "Tell the version and end.", .words = {}});
    for (const QCommandLineOption& option : windowOptions()) {
        Argument argument;
        for (const QString& name : option.names()) {
            argument.names.push_back((name.size() == 1 ? "-" : "--") + name.toStdString());
        }
        argument.value = option.valueName().toStdString();
        argument.description = option.description().toStdString();
        addOffer(program, argument);
        program.options.push_back(std::move(argument));
    }
    return program;
}

std::string functionName(std::string_view program) {
    std::string name{program};
    std::ranges::replace_if(name, [](char letter) { return letter == '-' || letter == ' '; }, '_');
    return name;
}

}  // namespace furrow::manual
