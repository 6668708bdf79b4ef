#include "app/cli/report_command.h"

#include "app/cli/exit_status.h"

#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace furrow::cli {

void addReportCommand(CLI::App& app, std::function<int()>& run,
                      std::function<int(const ReportArguments&)> print) {
    const auto arguments = std::make_shared<ReportArguments>();
    CLI::App* report =
        app.add_subcommand("report", "Print the work order of a plan: PDF, or its map page as a picture.");
    report
        ->add_option(
            "PLAN", arguments->source,
            "The folder of a plan, as furrow-cli plan writes it, or a project (Farm.furrow), which is planned")
        ->required();
    report->add_option(
        "--field-id", arguments->fieldId,
        "Which field of the project: its id, its name, or its number from 1 (default: all of them)");
    report->add_option("--out", arguments->out, "The file to write: .pdf, .png or .svg")->required();
    report->add_option("--paper", arguments->paper, "a4 or letter")
        ->check(CLI::IsMember({"a4", "letter"}))
        ->capture_default_str();
    report->add_option(
        "--order", arguments->order,
        "Work order data as JSON (number, customer, operator ...); of a project, instead of its own");
    report->add_option("--language", arguments->language, "en, de, nl, fr, es, pt_BR or pt_PT")
        ->check(CLI::IsMember({"en", "de", "nl", "fr", "es", "pt_BR", "pt_PT"}))
        ->capture_default_str();
    report->add_option("--units", arguments->units, "metric or imperial")
        ->check(CLI::IsMember({"metric", "imperial"}))
        ->capture_default_str();
    report->add_option("--threads", arguments->threads, "Threads to plan with; 0 for as many as there are")
        ->check(CLI::NonNegativeNumber);
    report->footer(
        "Of a folder what it holds is printed. A project is planned first: one field, or all of them with a first page\n"
        "of totals (PDF only). A PNG or SVG is the first page, the one with the map. The hash on the paper is the\n"
        "SHA-256 sum of the plan's path.csv.\n"
        "\n"
        "Examples:\n"
        "  furrow-cli report plan --out order.pdf\n"
        "  furrow-cli report plan --order order.json --paper letter --units imperial --out order.pdf\n"
        "  furrow-cli report Farm.furrow --out farm.pdf\n"
        "  furrow-cli report Farm.furrow --field-id 12 --language de --out map.png\n"
        "\n"
        "Exit status: 0 printed, 1 printed and marked: a plan cannot be driven as it is, 2 wrong usage, 3 input\n"
        "refused, 4 could not read or write, 130 cancelled.");
    report->callback([&run, arguments, print = std::move(print)] {
        run = [arguments, print] { return print(*arguments); };
    });
}

int handOverToReport(char** argv) {
    std::error_code failed;
    const std::filesystem::path own = std::filesystem::read_symlink("/proc/self/exe", failed);
    // Beside this program where it was built; among the programs that nobody starts by hand where it was
    // installed.
    std::filesystem::path program = own.parent_path() / "furrow-report";
    if (!std::filesystem::exists(program, failed)) {
        program = (own.parent_path() / FURROW_REPORT_FROM_BIN).lexically_normal();
    }
    ::execv(program.c_str(), argv);
    return failWith({.code = ErrorCode::ReadFailed,
                     .what = "the program that prints is not there",
                     .where = program.string(),
                     .remedy = "install Furrow again"});
}

}  // namespace furrow::cli
