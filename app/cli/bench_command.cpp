#include "app/cli/bench_command.h"

#include "app/cli/exit_status.h"
#include "app/cli/terminal.h"
#include "planner/benchmarks/paper.h"
#include "planner/benchmarks/speed.h"
#include "planner/io/files/atomic_files.h"
#include "planner/io/import/boundary_import.h"

#include <nlohmann/json.hpp>

#include <format>
#include <memory>
#include <print>
#include <string>
#include <vector>

namespace furrow::cli {

namespace {

using Json = nlohmann::ordered_json;

struct PaperArguments {
    std::string fields;
    std::string out;
    bool json = false;
};

struct SpeedArguments {
    std::string out;
    bool json = false;
};

std::string_view agreement(const PaperStatement& statement) {
    return !statement.agrees ? "?" : *statement.agrees ? "yes" : "no";
}

std::string textOf(const std::vector<PaperExperiment>& experiments) {
    std::string text;
    for (const PaperExperiment& experiment : experiments) {
        text += std::format("Experiment {}: {}\n", experiment.number, experiment.title);
        for (const PaperStatement& statement : experiment.statements) {
            text += std::format("  {:<4} {}\n       {}\n", agreement(statement), statement.paper,
                                statement.found);
        }
        for (const std::string& note : experiment.notes) {
            text += std::format("  note {}\n", note);
        }
        text += "\n";
    }
    return text;
}

std::string jsonOf(const std::vector<PaperExperiment>& experiments) {
    Json all = Json::array();
    for (const PaperExperiment& experiment : experiments) {
        Json statements = Json::array();
        for (const PaperStatement& statement : experiment.statements) {
            statements.push_back({{"paper", statement.paper},
                                  {"found", statement.found},
                                  {"agrees", statement.agrees ? Json(*statement.agrees) : Json()}});
        }
        Json files = Json::array();
        for (const PaperFile& file : experiment.files) {
            files.push_back(file.name);
        }
        all.push_back({{"number", experiment.number},
                       {"title", experiment.title},
                       {"statements", std::move(statements)},
                       {"notes", experiment.notes},
                       {"files", std::move(files)}});
    }
    return Json{{"experiments", std::move(all)}}.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// An experiment that this planner lacks a method for is told, not failed: the others still run.
Result<void> keep(Result<PaperExperiment> experiment, int number, std::vector<PaperExperiment>& experiments) {
    if (experiment) {
        experiments.push_back(std::move(*experiment));
        return {};
    }
    if (experiment.error().code != ErrorCode::Usage) {
        return std::unexpected(experiment.error());
    }
    experiments.push_back({.number = number,
                           .title = "not run",
                           .statements = {},
                           .notes = {experiment.error().line()},
                           .files = {}});
    return {};
}

int runPaper(const PaperArguments& arguments) {
    const InterruptWatch watch;
    const JobContext job = terminalJob(watch, 0, arguments.json);
    std::vector<FieldSource> fields = paperFields();
    if (!arguments.fields.empty()) {
        auto read = readBoundaries(arguments.fields, job.part(0.0, 0.0));
        if (!read) {
            return failWith(read.error());
        }
        fields = std::move(*read);
    }
    std::vector<PaperExperiment> experiments;
    Result<void> kept = keep(paperHeadings(job.part(0.0, 0.05)), 1, experiments);
    if (kept) {
        kept = keep(paperTurning(fields, job.part(0.05, 0.6)), 2, experiments);
    }
    if (kept) {
        kept = keep(paperTiming(job.part(0.6, 0.95)), 3, experiments);
    }
    if (kept) {
        kept = keep(paperDrive(job.part(0.95, 1.0)), 4, experiments);
    }
    clearProgress(arguments.json);
    if (!kept) {
        return failWith(kept.error());
    }
    std::vector<FileToWrite> files;
    if (!arguments.out.empty()) {
        for (const PaperExperiment& experiment : experiments) {
            for (const PaperFile& file : experiment.files) {
                files.push_back({file.name, [&file] { return file.text; }});
            }
        }
        files.push_back({"summary.txt", [&experiments] { return textOf(experiments); }});
        if (const auto written = writeTogether(arguments.out, files, job); !written) {
            return failWith(written.error());
        }
    }
    std::print("{}", arguments.json ? jsonOf(experiments) : textOf(experiments));
    if (!arguments.json && !arguments.out.empty()) {
        say("{} files written to {}", files.size(), arguments.out);
    }
    return kDrivable;
}

double inMegabytes(std::size_t bytes) {
    return 1e-6 * static_cast<double>(bytes);
}

Json speedJson(const std::vector<SpeedCase>& cases) {
    Json all = Json::array();
    const auto timeOrNull = [](const std::optional<Duration>& time) {
        return time ? Json(time->si()) : Json();
    };
    for (const SpeedCase& each : cases) {
        all.push_back(
            {{"name", each.name},
             {"area_ha", each.areaHa},
             {"vertices", each.vertices},
             {"threads", each.threads},
             {"runs", each.runs},
             {"min_s", each.least.si()},
             {"median_s", each.median.si()},
             {"yardstick_min_s", timeOrNull(each.yardstickLeast)},
             {"yardstick_s", timeOrNull(each.yardstick)},
             {"ratio", each.ratio ? Json(*each.ratio) : Json()},
             {"peak_memory_mb", each.peakMemoryBytes ? Json(inMegabytes(*each.peakMemoryBytes)) : Json()}});
    }
    return {{"cases", std::move(all)}};
}

std::string shortTime(Duration time) {
    const double s = time.si();
    return s < 1e-3  ? std::format("{:.2f} µs", 1e6 * s)
           : s < 1.0 ? std::format("{:.2f} ms", 1e3 * s)
                     : std::format("{:.2f} s", s);
}

int runSpeed(const SpeedArguments& arguments) {
    const InterruptWatch watch;
    const auto cases = measureSpeed(terminalJob(watch, 0, arguments.json));
    clearProgress(arguments.json);
    if (!cases) {
        return failWith(cases.error());
    }
    const std::string json = speedJson(*cases).dump(2) + "\n";
    if (!arguments.out.empty()) {
        const std::vector<FileToWrite> files{{"speed.json", [&json] { return std::string{json}; }}};
        if (const auto written = writeTogether(arguments.out, files, {}); !written) {
            return failWith(written.error());
        }
    }
    if (arguments.json) {
        std::print("{}", json);
        return kDrivable;
    }
    for (const SpeedCase& each : *cases) {
        say("{:62} {:8.2f} ha {:7} vertices {} thread{} {:>11} (least {}){}{}", each.name, each.areaHa,
            each.vertices, each.threads, each.threads == 1 ? " " : "s", shortTime(each.median),
            shortTime(each.least),
            each.ratio ? std::format("  plain GEOS {:>10} (least {}), {:.0f} times",
                                     shortTime(*each.yardstick), shortTime(*each.yardstickLeast), *each.ratio)
                       : "",
            each.peakMemoryBytes ? std::format("  memory {:.1f} MB", inMegabytes(*each.peakMemoryBytes))
                                 : "");
    }
    return kDrivable;
}

}  // namespace

void addBenchCommand(CLI::App& app, std::function<int()>& run) {
    CLI::App* bench = app.add_subcommand("bench", "Measure the planner in ways that others can repeat.");
    bench->require_subcommand(1);
    const auto arguments = std::make_shared<PaperArguments>();
    CLI::App* paper = bench->add_subcommand(
        "paper",
        "The experiments of the Fields2Cover paper (doi 10.1109/LRA.2023.3248439), statement by statement.");
    paper->add_option(
        "--fields", arguments->fields,
        "A boundary file for the second experiment (default: 38 convex fields that come with Furrow)");
    paper->add_option("--out", arguments->out,
                      "Write tables (CSV), plots (SVG) and summary.txt to this folder");
    paper->add_flag("--json", arguments->json, "Print one JSON object and nothing else");
    const auto speedArguments = std::make_shared<SpeedArguments>();
    CLI::App* speed = bench->add_subcommand(
        "speed",
        "Time headings, searches, plans and turns, with plain GEOS as the yardstick in the same run, and measure "
        "the memory of plans.");
    speed->add_option("--out", speedArguments->out, "Write speed.json to this folder");
    speed->add_flag("--json", speedArguments->json, "Print one JSON object and nothing else");
    speed->callback([&run, speedArguments] { run = [speedArguments] { return runSpeed(*speedArguments); }; });
    paper->callback([&run, arguments] { run = [arguments] { return runPaper(*arguments); }; });
}

}  // namespace furrow::cli
