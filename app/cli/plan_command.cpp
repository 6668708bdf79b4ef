#include "app/cli/plan_command.h"

#include "app/cli/exit_status.h"
#include "app/cli/export_arguments.h"
#include "app/cli/finding_line.h"
#include "app/cli/planning_arguments.h"
#include "app/cli/terminal.h"
#include "planner/io/delivery/plan_folder.h"
#include "planner/io/delivery/terminals.h"
#include "planner/plan/advice.h"
#include "planner/plan/best_plan.h"
#include "planner/plan/draft.h"
#include "planner/plan/explanation.h"
#include "planner/plan/plan_course.h"
#include "planner/plan/stopwatch.h"
#include "planner/project/field_tasks.h"
#include "planner/units/angle.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <format>
#include <memory>
#include <optional>
#include <print>
#include <string>
#include <vector>

namespace furrow::cli {

namespace {

struct PlanArguments {
    std::string field;
    std::optional<std::string> fieldId;
    std::optional<std::string> planName;
    std::optional<std::string> terminal;
    ExportOptions options;
    PlanningArguments planning;
    bool progress = false;
    bool best = false;
    bool explain = false;
};

// More would push the plan itself off the screen.
constexpr std::size_t kMostFilesShown = 24;

std::string kilometres(Length length) {
    return length < metres(1000.0) ? std::format("{:.0f} m", length.si())
                                   : std::format("{:.2f} km", length.si() / 1000.0);
}

std::string hoursMinutes(Duration duration) {
    const auto minutes = static_cast<int>(std::lround(duration.si() / 60.0));
    return minutes < 60 ? std::format("{} min", minutes)
                        : std::format("{} h {:02} min", minutes / 60, minutes % 60);
}

std::string counted(long long count, std::string_view one, std::string_view many) {
    return std::format("{} {}", count, count == 1 ? one : many);
}

std::string minutesSeconds(Duration duration) {
    const auto wholeSeconds = std::lround(duration.si());
    return wholeSeconds < 60 ? std::format("{} s", wholeSeconds)
                             : std::format("{} min {:02} s", wholeSeconds / 60, wholeSeconds % 60);
}

std::string timeBeside(Duration difference) {
    if (std::lround(difference.si()) == 0) {
        return "the same time";
    }
    return difference > Duration{} ? minutesSeconds(difference) + " slower"
                                   : minutesSeconds(-difference) + " quicker";
}

/// What was changed, then what the nearest alternatives would cost.
void printChoices(const ChoiceTable& table) {
    say("Best      {} of {} after {} alternatives{}", minutesSeconds(table.best), minutesSeconds(table.asked),
        table.alternatives, table.askedProblems > 0 ? ", and what stood in the way is gone or less" : "");
    std::size_t behind = 0;
    for (const TriedChoice& tried : table.tried) {
        switch (tried.worth) {
            case TriedChoice::Worth::Taken:
                say("  taken   {}: {}", tried.text.text(),
                    tried.difference > Duration{} ? "saves " + minutesSeconds(tried.difference)
                                                  : std::string{"fewer problems"});
                break;
            case TriedChoice::Worth::Slower:
                say("          {}: {}", tried.text.text(), timeBeside(tried.difference));
                break;
            case TriedChoice::Worth::Behind: ++behind; break;
        }
    }
    if (behind > 0) {
        say("          {} more than 6 % slower, or not drivable",
            counted(static_cast<long long>(behind), "other is", "others are"));
    }
}

/// Why each step came out as it did.
Result<void> printReasons(const Plan& plan, const JobContext& job) {
    const auto curve = headingCurve(plan, job);
    if (!curve) {
        return std::unexpected(curve.error());
    }
    const auto reasons = explanations(plan, *curve, job);
    if (!reasons) {
        return std::unexpected(reasons.error());
    }
    say("Why");
    for (const Explanation& reason : *reasons) {
        say("  {:<14} {}", reason.step, reason.text.text());
    }
    return {};
}

void printPlan(const Plan& plan, const WrittenFiles& written, const Terminal* terminal, bool quiet) {
    if (quiet) {
        return;
    }
    const Machine& machine = plan.request.machine;
    const Length turns = plan.path.length() - plan.path.workedLength();
    const auto swathCount = static_cast<long long>(plan.swaths.swaths.size());
    say("Field     {} · {:.2f} ha · {}", plan.field().name(), inHectares(plan.field().area()),
        counted(static_cast<long long>(plan.field().vertexCount()), "point", "points"));
    say("Machine   {} · {} m · {} m turning radius", machine.name(), machine.operatingWidth().si(),
        machine.minTurningRadius().si());
    say("Headland  {:.2f} m · {} · mainland {:.1f} %", plan.headland.width.si(),
        counted(plan.headland.passes, "pass", "passes"), 100.0 * plan.headland.mainlandRatio);
    if (plan.swaths.swaths.empty()) {
        say("Swaths    none: the headland takes all of the field");
    } else {
        say("Swaths    {} · {} · bearing {:.1f}° · covers {:.2f} % of the mainland",
            counted(swathCount, "swath", "swaths"), kilometres(plan.swaths.totalLength),
            lineBearingDeg(plan.swaths.heading), 100.0 * plan.swaths.coverage);
    }
    say("Path      {} · {} · {:.1f} % turning · {}", kilometres(plan.path.length()),
        counted(plan.path.turnCount(), "turn", "turns"),
        plan.path.length() > metres(0.0) ? 100.0 * (turns / plan.path.length()) : 0.0,
        hoursMinutes(plan.path.duration()));
    if (const int refills = plan.path.refillCount(); refills > 0) {
        say("Refills   {} · {} to the refill points and back",
            plan.refill->work.gathers ? counted(refills, "unloading", "unloadings")
                                      : counted(refills, "refill", "refills"),
            kilometres(plan.path.length(SegmentKind::Refill)));
    }
    say("Covered   {:.2f} % of the field · {:.0f} m² missed · {:.0f} m² worked twice",
        100.0 * plan.audit.coveredShare.value_or(0.0), plan.audit.missed.value_or(Area{}).si(),
        plan.audit.overlap.value_or(Area{}).si());
    if (plan.choices) {
        printChoices(*plan.choices);
    }
    const auto blocking = plan.blockingCount();
    say("Drivable  {}", plan.drivable() ? std::string{"yes"}
                                        : std::format("no, {} in the way",
                                                      counted(blocking, "finding stands", "findings stand")));
    constexpr std::size_t kMostShown = 10;
    for (std::size_t i = 0; i < std::min(plan.findings.size(), kMostShown); ++i) {
        say("{}", findingLine(i + 1, plan.findings[i], plan.field().frame()));
    }
    if (plan.findings.size() > kMostShown) {
        say("       and {} more in summary.json", plan.findings.size() - kMostShown);
    }
    if (terminal != nullptr) {
        say("Terminal  {}: {}", terminal->name, terminal->shows);
    }
    say("Planned in {:.1f} ms. Written:", plan.timings.total.si() * 1e3);
    for (std::size_t i = 0; i < std::min(written.files.size(), kMostFilesShown); ++i) {
        say("  {}", written.files[i].string());
    }
    if (written.files.size() > kMostFilesShown) {
        say("  and {} more", written.files.size() - kMostFilesShown);
    }
    say("Checked   {}", checkSummary(written.checks));
    for (const std::string& note : written.notes) {
        say("Note      {}", note);
    }
}

/// One line for a plan that is there before the finished one.
void tellFirst(std::string_view what, Duration after, const Plan& plan) {
    say(stderr, "{} after {:.0f} ms{}: {} · {} · {}", what, 1e3 * after.si(),
        plan.request.draft ? ", a draft" : "",
        counted(static_cast<long long>(plan.swaths.swaths.size()), "swath", "swaths"),
        kilometres(plan.path.length()), hoursMinutes(plan.path.duration()));
}

/// A draft is there at once, also where the plan takes long. A draft that cannot be made is not worth a word:
/// the plan tells the reason.
void printDraft(const PlanRequest& request, const Stopwatch& watch, const JobContext& job) {
    const auto draft = makePlan(draftOf(request, nullptr), {.stop = job.stop, .progress = {}, .threads = 1});
    if (draft) {
        tellFirst("first plan", Stopwatch{watch}.lap(), **draft);
    }
}

/// Lines for other programs: the plan as asked, and how many are compared with it.
PlanCourse courseInLines(const Stopwatch& watch) {
    return {.firstPlan =
                [&watch](const std::shared_ptr<const Plan>& plan) {
                    tellFirst("plan as asked", Stopwatch{watch}.lap(), *plan);
                },
            .compared = [](std::size_t done,
                           std::size_t known) { say(stderr, "compared {} of {}", done, known); }};
}

/// What is given stays, here or by the plan of a project.
std::vector<std::string_view> givenChoices(const Settings& settings) {
    std::vector<std::string_view> ids;
    for (const PlanChoice& choice : planChoices()) {
        if (isGiven(choice, settings)) {
            ids.push_back(choice.id);
        }
    }
    return ids;
}

int runPlan(const PlanArguments& arguments) {
    const PlanningArguments& planning = arguments.planning;
    const InterruptWatch watch;
    const Stopwatch since;
    const bool noBar = planning.quiet || planning.json || arguments.progress;
    const JobContext job =
        arguments.progress ? linesJob(watch, planning.threads) : terminalJob(watch, planning.threads, noBar);
    const auto choices = choicesFrom(planning, standardPlanFormats());
    if (!choices) {
        return failWith(choices.error());
    }
    std::optional<Terminal> terminal;
    if (arguments.terminal) {
        const auto found = findTerminal(*arguments.terminal);
        if (!found) {
            return failWith(found.error());
        }
        terminal = **found;
        terminal->options.task = arguments.options.task;
    }
    const auto task = readFieldTask(
        arguments.field, arguments.fieldId,
        {.planName = arguments.planName, .machine = choices->machine, .settings = choices->settings},
        job.part(0.0, 0.05));
    if (!task) {
        return failWith(task.error());
    }
    auto field = Field::create(task->source, job.part(0.05, 0.1));
    if (!field) {
        return failWith(field.error());
    }
    const auto plan =
        planRequest(std::make_shared<const Field>(std::move(*field)), task->machine, task->settings,
                    job.part(0.1, 0.1))
            .and_then([&](const PlanRequest& request) {
                PlanCourse course;
                if (arguments.progress) {
                    printDraft(request, since, job);
                    course = courseInLines(since);
                }
                return arguments.best
                           ? bestPlan(
                                 {.request = request, .kept = givenChoices(task->settings), .onBetter = {}},
                                 job.part(0.1, 0.8))
                           : makePlan(request, job.part(0.1, 0.8), nullptr, course);
            })
            .and_then([&job](const auto& made) { return withAdvice(made, job.part(0.8, 0.95)); });
    if (!plan) {
        clearProgress(noBar);
        return failWith(plan.error());
    }
    const JobContext rest = job.part(0.95, 1.0);
    const auto written =
        terminal ? writeForTerminal(**plan, planning.out, *terminal, rest)
                 : writePlanFolder(**plan, planning.out, choices->formats, rest, arguments.options);
    job.report(1.0);
    clearProgress(noBar);
    if (!written) {
        return failWith(written.error());
    }
    printProblems(written->checks);
    if (planning.json) {
        std::print("{}", written->summary);
    } else {
        printPlan(**plan, *written, terminal ? &*terminal : nullptr, planning.quiet);
    }
    if (arguments.explain) {
        if (const auto told = printReasons(**plan, {.stop = job.stop, .threads = job.threads}); !told) {
            return failWith(told.error());
        }
    }
    return (*plan)->drivable() ? kDrivable : kBlockingFinding;
}

}  // namespace

void addPlanCommand(CLI::App& app, std::function<int()>& run) {
    const auto arguments = std::make_shared<PlanArguments>();
    CLI::App* plan = app.add_subcommand("plan", "Plan a field and write the plan to a folder.");
    plan->add_option("FIELD", arguments->field,
                     "A boundary file (furrow-cli list formats shows what is read) or a project")
        ->required();
    plan->add_option("--field-id", arguments->fieldId,
                     "Which field of the file: its id, its name, or its number from 1");
    plan->add_option("--plan-name", arguments->planName,
                     "Which plan of the project's field: its name or id (default: the current one)");
    addPlanningOptions(*plan, arguments->planning);
    plan->add_option(
            "--terminal", arguments->terminal,
            "Write what this terminal takes, as it lies on its stick (see furrow-cli list terminals)")
        ->excludes("--format");
    plan->add_flag(
        "--best", arguments->best,
        "Try the alternatives of all choices that are not given, here or by a project's plan, take the quickest drivable "
        "plan, and tell what each choice is worth");
    plan->add_flag("--explain", arguments->explain,
                   "Tell why each step came out as it did, with what other headings and orders would take")
        ->excludes("--json");
    plan->add_flag(
        "--progress", arguments->progress,
        "Tell on standard error how far planning is, line by line, and what is there before the finished plan");
    addExportOptions(*plan, arguments->options, true);
    plan->footer(
        "Of a project (Farm.furrow) the field has its edge headlands, and the machine and settings of its plan;\n"
        "what is given here wins. A plan that was written to the folder before is replaced as a whole: files of\n"
        "it that the new one does not have are removed.\n"
        "\n"
        "Examples:\n"
        "  furrow-cli plan field.geojson --out plan\n"
        "  furrow-cli plan farm.gpkg --field-id 12 --machine trailed-sprayer --out plan\n"
        "  furrow-cli plan Farm.furrow --field-id 1 --plan-name 'Spring drilling' --out plan\n"
        "  furrow-cli plan field.geojson --best --machine cultivator --set swaths.ends=full --out plan\n"
        "  furrow-cli plan field.kml --set swaths.method=fixed --set swaths.angle_deg=30 --out plan --json\n"
        "\n"
        "Exit status: 0 a drivable plan, 1 a plan that cannot be driven as it is (written and marked),\n"
        "2 wrong usage, 3 input refused, 4 could not read or write, 130 cancelled.");
    plan->callback([&run, arguments] { run = [arguments] { return runPlan(*arguments); }; });
}

}  // namespace furrow::cli
