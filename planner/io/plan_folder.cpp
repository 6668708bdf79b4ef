#include "planner/io/plan_folder.h"

#include "planner/io/atomic_files.h"
#include "planner/io/format_registry.h"
#include "planner/io/isoxml.h"
#include "planner/io/path_csv.h"
#include "planner/io/plan_geojson.h"
#include "planner/io/plan_summary.h"

#include <algorithm>

namespace furrow {

namespace {

namespace fs = std::filesystem;

struct PlanFile {
    std::string_view format;
    std::string_view path;
    std::string (*write)(const Plan&);
};

constexpr PlanFile kFiles[] = {
    {"", "summary.json", planSummaryJson},
    {"geojson", "plan.geojson", planGeoJson},
    {"csv", "path.csv", pathCsv},
    {"isoxml", "TASKDATA/TASKDATA.XML", isoxmlTaskData},
};

}  // namespace

std::span<const std::string_view> standardPlanFormats() {
    static constexpr std::string_view kStandard[] = {"geojson", "csv", "isoxml"};
    return kStandard;
}

Result<std::vector<fs::path>> writePlanFolder(const Plan& plan, const fs::path& folder,
                                              std::span<const std::string_view> formatIds,
                                              const JobContext& job) {
    for (const std::string_view id : formatIds) {
        if (const auto known = findPlanFormat(id); !known) {
            return std::unexpected(known.error());
        }
    }
    std::vector<FileToWrite> files;
    for (const PlanFile& file : kFiles) {
        if (file.format.empty() || std::ranges::contains(formatIds, file.format)) {
            files.push_back({file.path, [&plan, &file] { return file.write(plan); }});
        }
    }
    return writeTogether(folder, files, job);
}

}  // namespace furrow
