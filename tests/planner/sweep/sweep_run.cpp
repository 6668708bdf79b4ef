#include "tests/planner/sweep/sweep_run.h"

#include "planner/machine/machine_library.h"
#include "tests/planner/sweep/sweep_shapes.h"
#include "tests/planner/sweep/sweep_table.h"

#include <QCoreApplication>
#include <QProcess>
#include <QtEnvironmentVariables>

#include <algorithm>
#include <cstdio>
#include <format>
#include <fstream>
#include <random>
#include <ranges>

namespace furrow::test {

namespace {

constexpr const char* kPart = "FURROW_SWEEP_PART";
// What a worker says while it tries advice: it is not stuck.
constexpr char kAtWork = '.';

std::string environment(const char* name, const char* otherwise = "") {
    return qEnvironmentVariable(name, QString::fromUtf8(otherwise)).toStdString();
}

std::vector<std::string> divided(const std::string& text, char divider) {
    std::vector<std::string> parts;
    for (const auto part : std::views::split(text, divider)) {
        parts.emplace_back(part.begin(), part.end());
    }
    return parts;
}

/// Those of all names that the environment names; all where it names none.
std::vector<std::string> chosenOf(std::vector<std::string> all, const char* variable) {
    const std::string given = environment(variable);
    if (given.empty()) {
        return all;
    }
    std::vector<std::string> chosen = divided(given, ',');
    for (const std::string& name : chosen) {
        if (!std::ranges::contains(all, name)) {
            qFatal("%s: there is no '%s'", variable, name.c_str());
        }
    }
    return chosen;
}

std::vector<SweepChange> changesWanted(std::vector<SweepChange> changes) {
    const std::string wanted = environment("FURROW_SWEEP_SETTING");
    std::erase_if(changes, [&](const SweepChange& change) { return !change.name().contains(wanted); });
    return changes;
}

/// Each pair on one shape with one machine.
std::vector<SweepCase> pairCases(std::size_t count, std::uint64_t seed,
                                 const std::vector<std::string>& shapes,
                                 const std::vector<std::string>& machines) {
    std::mt19937_64 random{seed};
    std::vector<SweepCase> cases;
    for (const SweepChange& pair : changesWanted(drawnPairs(everyChange(), count, seed))) {
        const std::string& shape = shapes[random() % shapes.size()];
        cases.push_back({shape, machines[random() % machines.size()], pair});
    }
    std::ranges::stable_sort(cases, {},
                             [](const SweepCase& each) { return std::pair{each.shape, each.machine}; });
    return cases;
}

using Group = std::vector<SweepCase>;

/// Cases of one shape and machine together.
std::vector<Group> grouped(std::vector<SweepCase> cases) {
    std::vector<Group> groups;
    for (SweepCase& each : cases) {
        if (groups.empty() || groups.back().front().shape != each.shape ||
            groups.back().front().machine != each.machine) {
            groups.emplace_back();
        }
        groups.back().push_back(std::move(each));
    }
    return groups;
}

/// What the environment asks for; the same in every process.
std::vector<Group> groupsWanted() {
    std::vector<std::string> shapes = sweepShapes();
    // The small ones only where they are named.
    if (!environment("FURROW_SWEEP_SHAPE").empty()) {
        std::ranges::copy(smallSweepShapes(), std::back_inserter(shapes));
    }
    std::vector<std::string> machines;
    for (const Machine& machine : machineLibrary()) {
        machines.push_back(machine.spec().id);
    }
    shapes = chosenOf(std::move(shapes), "FURROW_SWEEP_SHAPE");
    machines = chosenOf(std::move(machines), "FURROW_SWEEP_MACHINE");
    const std::vector<std::string> mode = divided(environment("FURROW_SWEEP"), ':');
    const std::uint64_t count = mode.size() > 1 ? std::stoull(mode[1]) : 500;
    const std::uint64_t seed = mode.size() > 2 ? std::stoull(mode[2]) : 1;
    std::vector<SweepCase> cases;
    if (mode.front() == "pairs") {
        cases = pairCases(count, seed, shapes, machines);
    } else {
        cases = casesOf(changesWanted(everyChange()), shapes, machines);
        if (mode.front() == "sample") {
            cases = drawnCases(cases, std::max<std::uint64_t>(1, cases.size() / count), seed);
        } else if (mode.front() != "all") {
            qFatal("FURROW_SWEEP is all, sample:N:SEED or pairs:N:SEED");
        }
    }
    std::vector<Group> groups = grouped(std::move(cases));
    if (const std::vector<std::string> shard = divided(environment("FURROW_SWEEP_SHARD"), '/');
        shard.size() == 2) {
        const std::size_t number = std::stoull(shard[0]);
        const std::size_t of = std::stoull(shard[1]);
        std::vector<Group> mine;
        for (std::size_t i = number - 1; i < groups.size(); i += of) {
            mine.push_back(std::move(groups[i]));
        }
        return mine;
    }
    return groups;
}

std::filesystem::path outFolder() {
    const std::string given = environment("FURROW_SWEEP_OUT");
    return given.empty() ? std::filesystem::temp_directory_path() / "furrow_sweep"
                         : std::filesystem::absolute(given);
}

/// Where a group's field and files are.
std::filesystem::path folderOf(const Group& group) {
    return outFolder() / group.front().shape / group.front().machine;
}

/// The line with which a person plans a case again.
std::string commandOf(const Group& group, const SweepOutcome& outcome) {
    return std::format("furrow-cli plan {} --machine {} {}", (folderOf(group) / "field.geojson").string(),
                       group.front().machine, outcome.settings);
}

/// One process that plans a group's cases from one on, and says a line for each.
class Worker {
public:
    Worker(std::size_t group, std::size_t from) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(kPart, QStringLiteral("%1,%2").arg(group).arg(from));
        process_.setProcessEnvironment(environment);
        process_.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        process_.start(QCoreApplication::applicationFilePath(), QStringList{});
    }
    ~Worker() {
        process_.kill();
        process_.waitForFinished();
    }

    /// The next line; nothing where the process ended or nothing came within the time, and then why.
    std::optional<std::string> line(int withinMs, std::string& why) {
        while (!process_.canReadLine()) {
            if (!process_.waitForReadyRead(withinMs)) {
                hasPlanned_ = hasPlanned_ || process_.bytesAvailable() > 0;
                const bool ended = process_.state() == QProcess::NotRunning;
                why = ended ? "the program crashed" : std::format("no plan within {} s", withinMs / 1000);
                return std::nullopt;
            }
        }
        QByteArray line = process_.readLine();
        while (line.startsWith(kAtWork)) {
            line.remove(0, 1);
        }
        hasPlanned_ = true;
        line.chop(line.endsWith('\n') ? 1 : 0);
        return line.toStdString();
    }

    /// Whether it got as far as a plan with default settings.
    bool hasPlanned() const { return hasPlanned_; }

private:
    QProcess process_;
    bool hasPlanned_ = false;
};

class Sweep {
public:
    Sweep() : withinMs_{1000 * std::stoi(environment("FURROW_SWEEP_SECONDS", "120"))} {
        std::filesystem::create_directories(outFolder());
        records_.open(outFolder() / ("cases" + suffix() + ".tsv"));
        records_ << recordHeader() << std::endl;
    }

    void run(const Group& group, std::size_t number) {
        std::size_t next = 0;
        while (next < group.size()) {
            Worker worker{number, next};
            std::string why;
            while (next < group.size()) {
                const auto line = worker.line(withinMs_, why);
                if (!line) {
                    break;
                }
                tell(group, group[next],
                     outcomeOf(*line).value_or(SweepOutcome{.reason = "unreadable: " + *line}));
                ++next;
            }
            // Where it is the plan with default settings that ends it, the other cases would fare no better.
            const std::size_t lost = next == group.size() ? 0 : worker.hasPlanned() ? 1 : group.size() - next;
            for (const SweepCase& each : std::span{group}.subspan(next, lost)) {
                tell(group, each, {.reason = why, .settings = "(" + each.change.name() + ")"});
            }
            next += lost;
        }
    }

    int end() {
        const std::string text = table_.text();
        std::printf("%s", text.c_str());
        std::ofstream{outFolder() / ("table" + suffix() + ".txt")} << text;
        std::ofstream{outFolder() / ("failures" + suffix() + ".txt")} << table_.failuresText();
        return table_.failures() == 0 ? 0 : 1;
    }

private:
    static std::string suffix() {
        std::string shard = environment("FURROW_SWEEP_SHARD");
        std::ranges::replace(shard, '/', '-');
        return shard.empty() ? "" : "-" + shard;
    }

    void tell(const Group& group, const SweepCase& each, const SweepOutcome& outcome) {
        const std::string command = commandOf(group, outcome);
        table_.add(each, outcome, command);
        records_ << recordOf(each, outcome) << std::endl;
        if (outcome.verdict == SweepVerdict::Failed) {
            std::printf("FAILED  %s\n        %s\n        %s\n", each.name().c_str(), outcome.reason.c_str(),
                        command.c_str());
            std::fflush(stdout);
        }
    }

    int withinMs_;
    std::ofstream records_;
    SweepTable table_;
};

}  // namespace

bool sweepIsWanted() {
    return !qEnvironmentVariableIsEmpty("FURROW_SWEEP");
}

bool isSweepWorker() {
    return !qEnvironmentVariableIsEmpty(kPart);
}

int runSweepWorker() {
    const std::vector<std::string> part = divided(environment(kPart), ',');
    const std::vector<Group> groups = groupsWanted();
    const Group& group = groups.at(std::stoull(part.at(0)));
    const std::filesystem::path folder = folderOf(group);
    std::filesystem::create_directories(folder);
    const auto atWork = [] {
        std::putchar(kAtWork);
        std::fflush(stdout);
    };
    const SweepBench bench{group.front().shape, group.front().machine, folder, atWork};
    std::ofstream{folder / "field.geojson"} << geoJsonOf(bench.site().field->source());
    for (std::size_t i = std::stoull(part.at(1)); i < group.size(); ++i) {
        std::printf("%s\n", recordOf(group[i], bench.run(group[i].change)).c_str());
        std::fflush(stdout);
    }
    return 0;
}

int runSweep() {
    const std::vector<Group> groups = groupsWanted();
    Sweep sweep;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        sweep.run(groups[i], i);
    }
    return sweep.end();
}

}  // namespace furrow::test
