#include "app/cli/batch_command.h"

#include "app/cli/exit_status.h"
#include "app/cli/planning_arguments.h"
#include "app/cli/terminal.h"
#include "planner/evaluation/batch.h"

#include <algorithm>
#include <charconv>
#include <format>
#include <memory>
#include <print>
#include <string>
#include <vector>

namespace furrow::cli {

namespace {

struct BatchArguments {
    std::vector<std::string> fields;
    PlanningArguments planning;
    std::string shard;
    bool resume = false;
    double smallestHa = 0.0;
    std::optional<double> largestHa;
};

Result<Shard> shardFrom(const std::string& text) {
    if (text.empty()) {
        return Shard{};
    }
    Shard shard{.number = 0, .count = 0};
    const char* const end = text.data() + text.size();
    const auto number = std::from_chars(text.data(), end, shard.number);
    if (number.ec == std::errc{} && number.ptr != end && *number.ptr == '/') {
        const auto count = std::from_chars(number.ptr + 1, end, shard.count);
        if (count.ec == std::errc{} && count.ptr == end && shard.number >= 1 && shard.number <= shard.count) {
            return shard;
        }
    }
    return std::unexpected(Error{.code = ErrorCode::Usage,
                                 .what = std::format("'{}' is no shard", text),
                                 .where = "--shard",
                                 .remedy = "write I/N with I from 1 to N, for example --shard 2/8"});
}

std::string percent(std::size_t part, std::size_t whole) {
    return whole == 0
               ? "-"
               : std::format("{:.1f} %", 100.0 * static_cast<double>(part) / static_cast<double>(whole));
}

void printTotals(std::string_view what, const BatchTotals& totals) {
    if (totals.fields == 0) {
        return;
    }
    say("{}", what);
    say("  Fields     {}, planned {} ({})", totals.fields, totals.planned,
        percent(totals.planned, totals.fields));
    say("  Drivable   {} ({})", totals.drivable, percent(totals.drivable, totals.fields));
    for (const auto& [kind, fields] : totals.fieldsBlocked) {
        say("    in the way: {} in {}", kind, fields);
    }
    say("  Turns      {}, {} not drivable", totals.turns, totals.undrivableTurns);
    say("  Covered    {:.2f} % at the median, {:.2f} % at the 10th percentile, {:.2f} % of what is in reach",
        100.0 * totals.medianCovered, 100.0 * totals.tenthCovered, 100.0 * totals.medianCoveredOfReachable);
    say("  Time       {:.1f} ms at the median, {:.1f} ms at the 95th percentile",
        totals.medianTime.si() * 1e3, totals.slowTime.si() * 1e3);
}

/// " (30 m)" where one machine plans them all.
std::string fiveWidths(const BatchReport& report) {
    const auto differs = [&report](const BatchRecord& record) {
        return record.width != report.records.front().width;
    };
    return report.records.empty() || std::ranges::any_of(report.records, differs)
               ? std::string{}
               : std::format(" ({:.0f} m)", 5.0 * report.records.front().width.si());
}

int runBatchCommand(const BatchArguments& arguments) {
    const PlanningArguments& planning = arguments.planning;
    const InterruptWatch watch;
    const JobContext job = terminalJob(watch, planning.threads, planning.quiet || planning.json);
    const auto shard = shardFrom(arguments.shard);
    if (!shard) {
        return failWith(shard.error());
    }
    const auto choices = choicesFrom(planning, {});
    if (!choices) {
        return failWith(choices.error());
    }
    const BatchTask task{.files = {arguments.fields.begin(), arguments.fields.end()},
                         .machine = choices->machine,
                         .settings = choices->settings,
                         .out = planning.out,
                         .formats = choices->formats,
                         .shard = *shard,
                         .resume = arguments.resume,
                         .smallest = squareMetres(1e4 * arguments.smallestHa),
                         .largest = arguments.largestHa
                                        ? std::optional{squareMetres(1e4 * *arguments.largestHa)}
                                        : std::nullopt};
    const auto report = runBatch(task, job);
    clearProgress(planning.quiet || planning.json);
    if (!report) {
        return failWith(report.error());
    }
    if (planning.json) {
        std::print("{}", batchJson(*report));
    } else if (!planning.quiet) {
        printTotals(std::format("Fields at least five operating widths{} broad", fiveWidths(*report)),
                    report->wide);
        printTotals("Narrower fields", report->narrow);
        say("Written: {}", batchRecordPath(task.out, task.shard).string());
    }
    const bool allDrivable = report->wide.drivable + report->narrow.drivable == report->records.size();
    return allDrivable ? kDrivable : kBlockingFinding;
}

}  // namespace

void addBatchCommand(CLI::App& app, std::function<int()>& run) {
    const auto arguments = std::make_shared<BatchArguments>();
    CLI::App* batch = app.add_subcommand("batch", "Plan every field of some files, with totals at the end.");
    batch->add_option("FIELDS", arguments->fields, "Boundary files and projects")->required();
    addPlanningOptions(*batch, arguments->planning);
    batch->add_option("--shard", arguments->shard, "Only every N-th field, beginning with the I-th: I/N");
    batch->add_flag("--resume", arguments->resume, "Go on where an earlier run into the same folder ended");
    batch->add_option("--min-ha", arguments->smallestHa, "Leave smaller fields out")
        ->check(CLI::NonNegativeNumber);
    batch->add_option("--max-ha", arguments->largestHa, "Leave larger fields out")
        ->check(CLI::NonNegativeNumber);
    batch->footer(
        "Writes a folder for each field (summary.json, and what --format names) and batch.jsonl with one line\n"
        "for each, as soon as it is done. Of several shards each has its own, batch-I-of-N.jsonl. Fields of a\n"
        "project have the machine and settings of their plans. A folder holds one batch: other fields, another\n"
        "machine or other settings need another folder. --resume goes on: it plans what is missing, of more files, too.\n"
        "\n"
        "Exit status: 0 every field has a drivable plan, 1 some have not, 2 wrong usage, 3 input refused,\n"
        "4 could not read or write, 130 cancelled.");
    batch->callback([&run, arguments] { run = [arguments] { return runBatchCommand(*arguments); }; });
}

}  // namespace furrow::cli
