#include "planner/io/check/export_check.h"

#include "planner/io/check/check_run.h"
#include "planner/io/check/content_checks.h"
#include "planner/io/check/path_checks.h"
#include "planner/io/check/shape_checks.h"
#include "planner/io/formats/registry.h"
#include "planner/plan/plan.h"

#include <algorithm>
#include <vector>

namespace furrow {

namespace {

// Of what is shorter nothing can be recorded, and nobody drives it.
constexpr Length kShortestPath = metres(5.0);

template <PathCheck* kCheck>
void ofPaths(CheckRun& run) {
    if (run.job.plan == nullptr || !run.format.writing.content.path) {
        return;
    }
    for (const ReceivedContent& content : run.contents) {
        for (const ReceivedPath& path : content.paths) {
            run.applied = true;
            if (const auto problem = kCheck(path, *run.job.plan)) {
                run.report(content.file, *problem);
                break;
            }
        }
    }
}

void pathIsThere(CheckRun& run) {
    if (run.job.plan == nullptr || !run.format.writing.content.path ||
        run.job.plan->path.length() < kShortestPath) {
        return;
    }
    run.applied = true;
    const bool there = std::ranges::any_of(run.contents, [](const ReceivedContent& content) {
        return std::ranges::any_of(content.paths,
                                   [](const ReceivedPath& path) { return !path.samples.empty(); });
    });
    if (!there && !run.contents.empty()) {
        run.report(run.contents.front().file, "the path is not in it");
    }
}

struct CheckRow {
    std::string_view id;
    ExportCheck* check = nullptr;
};

/// A row for each, the gravest first.
constexpr CheckRow kChecks[] = {
    {"readable", readable},
    {"coordinates", coordinatesOnEarth},
    {"place", nearTheFields},
    {"rings-closed", ringsClosed},
    {"rings-simple", ringsSimple},
    {"counts", contentCounted},
    {"path-there", pathIsThere},
    {"path-followed", ofPaths<pathFollowed>},
    {"path-length", ofPaths<pathLength>},
    {"path-times", ofPaths<pathTimes>},
    {"path-headings", ofPaths<pathHeadings>},
    {"path-speeds", ofPaths<pathSpeeds>},
    {"lines", linesUsable},
    {"order", numbersInOrder},
    {"crs", systemNamed},
    {"winding", ringsWound},
    {"areas", areasAsStated},
    {"widths", widthsMeant},
    {"names", namesUsable},
    {"file-names", fileNamesAllowed},
};

}  // namespace

ExportChecks checkExport(const Format& format, const ExportJob& job, std::span<const FileToWrite> files) {
    ExportChecks result;
    if (!format.writes()) {
        return result;
    }
    std::vector<FileInMemory> written;
    for (const FileToWrite& file : files) {
        written.push_back({file.path.generic_string(), file.text()});
    }
    const std::vector<ReceivedContent> contents = format.writing.find(written, job);
    for (const CheckRow& row : kChecks) {
        CheckRun run{job, format, written, contents, result.problems};
        row.check(run);
        if (run.applied) {
            result.made.push_back(row.id);
        }
    }
    return result;
}

}  // namespace furrow
