#include "planner/io/delivery/plan_folder.h"

#include "planner/core/json_text.h"
#include "planner/io/content/plan_content.h"
#include "planner/io/delivery/checked_files.h"
#include "planner/io/delivery/terminals.h"
#include "planner/io/files/file_folder.h"
#include "planner/io/formats/registry.h"
#include "planner/io/plan_files/plan_summary.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace furrow {

namespace fs = std::filesystem;

namespace {

constexpr const char* kSummary = "summary.json";

/// Below the folder, as it stands in summary.json.
bool isInside(const fs::path& file) {
    return !file.empty() && file.is_relative() && !std::ranges::contains(file, fs::path{".."});
}

/// The files of the plan that a folder holds; none where it holds no plan.
std::vector<fs::path> filesOfPlanIn(const fs::path& folder) {
    std::error_code failed;
    if (!fs::is_regular_file(folder / kSummary, failed)) {
        return {};
    }
    const nlohmann::json summary = jsonOrDiscarded<nlohmann::json>(fileBytes(folder / kSummary).value_or(""));
    const auto listed = summary.is_object() ? summary.find("files") : summary.end();
    std::vector<fs::path> files;
    if (listed != summary.end() && listed->is_array()) {
        for (const nlohmann::json& file : *listed) {
            if (file.is_string() && isInside(file.get<std::string>())) {
                files.emplace_back(file.get<std::string>());
            }
        }
    }
    return files;
}

/// With the folders that are empty then.
void removeOld(const fs::path& folder, const std::vector<fs::path>& old,
               const std::vector<FileToWrite>& written) {
    for (const fs::path& file : old) {
        std::error_code ignored;
        if (std::ranges::contains(written, file, &FileToWrite::path) ||
            !fs::is_regular_file(fs::symlink_status(folder / file, ignored))) {
            continue;
        }
        fs::remove(folder / file, ignored);
        for (fs::path around = file.parent_path(); !around.empty(); around = around.parent_path()) {
            fs::remove(folder / around, ignored);  // fails where something is left in it
        }
    }
}

/// Of a plan: summary.json first, then these.
Result<WrittenFiles> written(const Plan& plan, const fs::path& folder, std::vector<FileToWrite> files,
                             std::vector<Message> notes, ExportChecks checks, const JobContext& job) {
    std::vector<std::string> names{kSummary};
    for (const FileToWrite& file : files) {
        names.push_back(file.path.generic_string());
    }
    const std::string summary = planSummaryJson(plan, names);
    files.insert(files.begin(), {kSummary, [&summary] { return summary; }});
    const std::vector<fs::path> old = filesOfPlanIn(folder);
    return writeTogether(folder, files, job).transform([&](std::vector<fs::path> paths) {
        removeOld(folder, old, files);
        return WrittenFiles{std::move(paths), std::move(notes), std::move(checks), summary};
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
    std::vector<const Format*> wanted;
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
    std::vector<FileToWrite> files;
    std::vector<Message> notes;
    ExportChecks checks;
    for (const Format* format : wanted) {
        auto made =
            checkedFiles(*format, {.fields = {&content, 1}, .plan = &plan, .options = options, .job = job});
        if (!made) {
            return std::unexpected(made.error());
        }
        for (FileToWrite& file : made->files) {
            fs::path path = fs::path{format->writing.folder} / file.path;
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
    return written(plan, folder, std::move(files), std::move(notes), std::move(checks), job);
}

Result<WrittenFiles> writeForTerminal(const Plan& plan, const fs::path& folder, const Terminal& terminal,
                                      const JobContext& job) {
    auto made = terminalFiles(terminal, plan, job);
    if (!made) {
        return std::unexpected(made.error());
    }
    return written(plan, folder, std::move(made->files), std::move(made->notes), std::move(made->checks),
                   job);
}

}  // namespace furrow
