#include "planner/io/plan_files/written_path.h"

#include "planner/io/formats/csv/path_csv.h"
#include "planner/io/plan_files/plan_json.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace furrow {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Throws what nlohmann throws where members are missing or of another kind.
void addOutlines(const Json& geoJson, WrittenPath& plan) {
    for (const Json& feature : geoJson.at("features")) {
        const Json& kind = feature.at("properties").at("kind");
        if (kind == "field") {
            std::ranges::move(polygonsOf(feature.at("geometry"), plan.frame), std::back_inserter(plan.field));
        } else if (kind == "obstacle") {
            std::ranges::move(polygonsOf(feature.at("geometry"), plan.frame),
                              std::back_inserter(plan.obstacles));
        }
    }
}

}  // namespace

Result<WrittenPath> readWrittenPath(const fs::path& folder) {
    const fs::path summaryFile = folder / "summary.json";
    const auto summary = planJson(summaryFile);
    if (!summary) {
        return std::unexpected(summary.error());
    }
    const auto frame = planFrame(*summary, summaryFile);
    if (!frame) {
        return std::unexpected(frame.error());
    }
    const fs::path pathFile = folder / "path.csv";
    const auto csv = planFileBytes(pathFile);
    auto path = csv ? readPathCsv(*csv, pathFile.string()) : std::unexpected(csv.error());
    if (!path) {
        return std::unexpected(path.error());
    }
    std::string place = summaryFile.string();
    try {
        WrittenPath plan{
            .name = summary->at("field").value("name", ""),
            .frame = *frame,
            .path = std::move(*path),
            .operatingWidth = metres(summary->at("machine").at("operating_width_m").get<double>())};
        if (!(plan.operatingWidth > metres(0.0))) {
            return std::unexpected(damagedPlan(place, "the machine's operating_width_m is not positive"));
        }
        const fs::path outlines = folder / "plan.geojson";
        if (fs::exists(outlines)) {
            place = outlines.string();
            const auto json = planJson(outlines);
            if (!json) {
                return std::unexpected(json.error());
            }
            addOutlines(*json, plan);
        }
        return plan;
    } catch (const Json::exception&) {
        return std::unexpected(
            damagedPlan(place, "a member that every plan has is missing or of another kind"));
    }
}

}  // namespace furrow
