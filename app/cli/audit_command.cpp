#include "app/cli/audit_command.h"

#include "app/cli/exit_status.h"
#include "app/cli/finding_line.h"
#include "app/cli/machine_argument.h"
#include "app/cli/terminal.h"
#include "planner/audit/audit.h"
#include "planner/io/plan_files/audit_json.h"
#include "planner/io/plan_files/plan_reader.h"
#include "planner/path/blocking.h"

#include <format>
#include <memory>
#include <print>
#include <string>
#include <vector>

namespace furrow::cli {

namespace {

struct AuditArguments {
    std::string plan;
    std::string machine;
    bool json = false;
};

std::string shareText(const std::optional<double>& share) {
    return share ? std::format("{:.2f} %", 100.0 * *share) : "not known";
}

template <class Quantity>
std::string figure(const std::optional<Quantity>& quantity, int digits, std::string_view unit) {
    return quantity ? std::format("{:.{}f} {}", quantity->si(), digits, unit) : "not known";
}

void printReport(const WrittenPlan& plan, const AuditReport& report) {
    say("Field        {} · {:.2f} ha to be worked", plan.name, inHectares(report.workable));
    say("Machine      {}",
        plan.machine ? plan.machine->name() : "not known: nothing is said of what it would drive over");
    say("Covered      {} · {} · {} of what can be reached", figure(report.covered, 1, "m²"),
        shareText(report.coveredShare), shareText(report.coveredOfReachable));
    say("Missed       {}", figure(report.missed, 1, "m²"));
    say("Overlap      {} · {} of it between headland and swaths", figure(report.overlap, 1, "m²"),
        figure(report.overlapHeadland, 1, "m²"));
    say("Outside      {} · clearance {}", figure(report.outside, 1, "m²"),
        figure(report.minClearance, 3, "m"));
    say("Curvature    {} · rate {}", figure(report.maxCurvature, 4, "1/m"),
        figure(report.maxCurvatureRate, 4, "1/m²"));
    say("Jumps        {} · {}", figure(report.maxPositionJump, 3, "m"),
        figure(report.maxHeadingJump, 3, "rad"));
    say("Reversed     {:.1f} m", report.reversed.si());
    say("Crossed      {:.0f} m over worked land · {:.0f} m over land that is worked later",
        report.drivenOnWorked.si(), report.drivenOnUnworked.si());
    say("Wheels       up to {} times over one square of {:.0f} m · {:.1f} % of the field more than 3 times",
        report.mostWheelPasses, report.wheelSquare.si(), 100.0 * report.oftenDrivenShare);
    if (report.maxHitchAngle) {
        say("Hitch angle  up to {:.0f}°", inDegrees(*report.maxHitchAngle));
    }
    say("Exact to     {:.2g} m² · {:.2g} m", report.areaError.si(), report.distanceError.si());
    if (report.findings.empty()) {
        say("Findings     none");
    }
    for (std::size_t i = 0; i < report.findings.size(); ++i) {
        say("{}", findingLine(i + 1, report.findings[i].finding, plan.frame));
    }
}

int runAudit(const AuditArguments& arguments) {
    const InterruptWatch watch;
    const JobContext job = terminalJob(watch, 0, arguments.json);
    auto plan = readPlan(arguments.plan, job.part(0.0, 0.1));
    if (!plan) {
        clearProgress(arguments.json);
        return failWith(plan.error());
    }
    if (!arguments.machine.empty()) {
        auto machine = machineFrom(arguments.machine);
        if (!machine) {
            clearProgress(arguments.json);
            return failWith(machine.error());
        }
        plan->machine = std::move(*machine);
    }
    const auto report = audit(auditInput(*plan), job.part(0.1, 1.0));
    clearProgress(arguments.json);
    if (!report) {
        return failWith(report.error());
    }
    std::vector<Finding> findings;
    for (const AuditFinding& each : report->findings) {
        findings.push_back(each.finding);
    }
    if (arguments.json) {
        std::println("{}", auditJson(*report, findings, plan->frame));
    } else {
        printReport(*plan, *report);
    }
    return blockingCount(findings) > 0 ? kBlockingFinding : kDrivable;
}

}  // namespace

void addAuditCommand(CLI::App& app, std::function<int()>& run) {
    const auto arguments = std::make_shared<AuditArguments>();
    CLI::App* command = app.add_subcommand("audit", "Measure a written plan from its files alone.");
    command
        ->add_option("PLAN", arguments->plan,
                     "The folder of a plan, or its GeoJSON alone, which gives areas and gaps only")
        ->required();
    command->add_option("--machine", arguments->machine,
                        "Measure with this machine (default: the one the folder names)");
    command->add_flag("--json", arguments->json, "Print the figures as one JSON object and nothing else");
    command->footer(
        "Examples:\n"
        "  furrow-cli audit plan\n"
        "  furrow-cli audit plan/plan.geojson --machine trailed-sprayer --json\n"
        "\n"
        "Exit status: 0 nothing in the way, 1 a finding that blocks, 2 wrong usage, 3 plan refused,\n"
        "4 could not read, 130 cancelled.");
    command->callback([&run, arguments] { run = [arguments] { return runAudit(*arguments); }; });
}

}  // namespace furrow::cli
