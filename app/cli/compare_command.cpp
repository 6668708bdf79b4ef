#include "app/cli/compare_command.h"

#include "app/cli/exit_status.h"
#include "app/cli/terminal.h"
#include "planner/evaluation/comparison_report.h"
#include "planner/io/files/atomic_files.h"
#include "planner/io/import/track_reader.h"
#include "planner/io/plan_files/written_path.h"
#include "planner/track/comparison.h"

#include <memory>
#include <optional>
#include <print>
#include <string>
#include <vector>

namespace furrow::cli {

namespace {

struct CompareArguments {
    std::string plan;
    std::string track;
    std::string out;
    bool json = false;
};

int runCompare(const CompareArguments& arguments) {
    const InterruptWatch watch;
    const JobContext job = terminalJob(watch, 0, true);
    const auto plan = readWrittenPath(arguments.plan);
    if (!plan) {
        return failWith(plan.error());
    }
    const auto file = readTracks(arguments.track, job);
    if (!file) {
        return failWith(file.error());
    }
    const auto laid = laidOver(plan->path, plan->frame, *file, plan->operatingWidth, job);
    if (!laid) {
        Error error = laid.error();
        error.where = arguments.track;
        return failWith(error);
    }
    const ComparisonReport report{.plan = *plan,
                                  .format = file->format,
                                  .tracks = laid->tracks,
                                  .comparison = laid->comparison,
                                  .notes = laid->notes,
                                  .radius = laid->radius};
    std::vector<std::filesystem::path> written;
    if (!arguments.out.empty()) {
        const FileToWrite files[] = {{"compare.csv", [&report] { return comparisonCsv(report); }},
                                     {"compare.svg", [&report] { return comparisonSvg(report); }}};
        auto done = writeTogether(arguments.out, files, job);
        if (!done) {
            return failWith(done.error());
        }
        written = std::move(*done);
    }
    if (arguments.json) {
        std::print("{}", comparisonJson(report));
    } else {
        sayLines(comparisonText(report));
    }
    if (!arguments.json && !written.empty()) {
        say("Written:");
        for (const std::filesystem::path& path : written) {
            say("  {}", path.string());
        }
    }
    return kDrivable;
}

}  // namespace

void addCompareCommand(CLI::App& app, std::function<int()>& run) {
    const auto arguments = std::make_shared<CompareArguments>();
    CLI::App* compare = app.add_subcommand(
        "compare", "Lay a recorded track over a written plan: how far beside it was driven.");
    compare->add_option("PLAN_DIR", arguments->plan, "The folder of a plan, as furrow-cli plan writes it")
        ->required();
    compare
        ->add_option("TRACK", arguments->track,
                     "GPX, CSV, an NMEA or gpsd log, ISOXML time logs (folder, TASKDATA.XML, zip), rosbag2")
        ->required();
    compare->add_option("--out", arguments->out,
                        "Write compare.csv (every position) and compare.svg (a map) to this folder");
    compare->add_flag("--json", arguments->json, "Print one JSON object and nothing else");
    compare->footer(
        "Examples:\n"
        "  furrow-cli compare plan drive.gpx\n"
        "  furrow-cli compare plan TASKDATA --out comparison\n"
        "\n"
        "Positions farther than one and a half operating widths from the plan are not on it; figures are\n"
        "of the others. Exit status: 0 compared, 2 wrong usage, 3 input refused, 4 could not read or\n"
        "write, 130 cancelled.");
    compare->callback([&run, arguments] { run = [arguments] { return runCompare(*arguments); }; });
}

}  // namespace furrow::cli
