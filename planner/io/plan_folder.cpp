#include "planner/io/plan_folder.h"

#include "planner/io/export_check.h"
#include "planner/io/format_registry.h"
#include "planner/io/plan_summary.h"
#include "planner/io/terminals.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace fs = std::filesystem;

namespace {

Result<WrittenFiles> written(const fs::path& folder, const std::vector<FileToWrite>& files,
                             std::vector<Message> notes, ExportChecks checks, const JobContext& job) {
    return writeTogether(folder, files, job).transform([&](std::vector<fs::path> paths) {
        return WrittenFiles{std::move(paths), std::move(notes), std::move(checks)};
    });
}

}  // namespace

std::span<const std::string_view> standardPlanFormats() {
    static constexpr std::string_view kStandard[] = {"geojson", "csv", "isoxml"};
    return kStandard;
}

Result<WrittenFiles> writePlanFolder(const Plan& plan, const fs::path& folder,
                                     std::span<const std::string_view> formatIds, const JobContext& job,
                                     const ExportOptions& options) {
    std::vector<const FormatInfo*> wanted;
    for (const std::string_view id : formatIds) {
        const auto known = findPlanFormat(id);
        if (!known) {
            return std::unexpected(known.error());
        }
        if (!std::ranges::contains(wanted, *known)) {
            wanted.push_back(*known);
        }
    }
    const FieldContent content = contentOf(plan, options);
    std::vector<FileToWrite> files{{"summary.json", [&plan] { return planSummaryJson(plan); }}};
    std::vector<Message> notes;
    ExportChecks checks;
    for (const FormatInfo* format : wanted) {
        auto made = checkedFiles(*format, {.fields = {&content, 1}, .plan = &plan, .options = options, .job = job});
        if (!made) {
            return std::unexpected(made.error());
        }
        for (FileToWrite& file : made->files) {
            fs::path path = fs::path{format->folder} / file.path;
            // Formats that share a folder share what explains them.
            if (!std::ranges::contains(files, path, &FileToWrite::path)) {
                files.push_back({std::move(path), std::move(file.text)});
            }
        }
        for (Message& note : made->notes) {
            if (!std::ranges::contains(notes, note)) {
                notes.push_back(std::move(note));
            }
        }
        checks.add(made->checks);
    }
    return written(folder, files, std::move(notes), std::move(checks), job);
}

Result<WrittenFiles> writeForTerminal(const Plan& plan, const fs::path& folder, const Terminal& terminal,
                                      const JobContext& job) {
    auto made = terminalFiles(terminal, plan, job);
    if (!made) {
        return std::unexpected(made.error());
    }
    std::vector<FileToWrite> files{{"summary.json", [&plan] { return planSummaryJson(plan); }}};
    std::ranges::move(made->files, std::back_inserter(files));
    return written(folder, files, std::move(made->notes), std::move(made->checks), job);
}

}  // namespace furrow
