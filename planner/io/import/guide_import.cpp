#include "planner/io/import/guide_import.h"

#include "planner/gdal/elevation.h"
#include "planner/io/formats/vector/vector_file.h"
#include "planner/plan/method_registry.h"
#include "planner/swaths/methods.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace furrow {

namespace {

bool isFinite(const GeoPoint& point) {
    return std::isfinite(point.lonDeg) && std::isfinite(point.latDeg);
}

/// Whether the chosen swath method reads this setting.
bool reads(const Settings& settings, const Parameter& parameter) {
    const StageInfo& stage = stageInfo("swaths");
    const auto method = std::ranges::find(stage.methods, settings.choice(*stage.method), &MethodInfo::id);
    return std::ranges::contains(method->parameters, &parameter);
}

}  // namespace

Result<std::vector<Polyline>> readRows(const std::filesystem::path& path, const Field& field,
                                       const JobContext& job) {
    constexpr std::array<std::string_view, 2> kAttributes{"kind", "tramline"};
    const auto file = readVectorFile(path, kAttributes, job);
    if (!file) {
        return std::unexpected(file.error());
    }
    const auto isSwath = [](const VectorFeature& feature) { return feature.attributes[0] == "swath"; };
    const auto isTramline = [](const VectorFeature& feature) {
        return feature.attributes[1] == "1" || feature.attributes[1] == "true";
    };
    const bool isPlan = std::ranges::any_of(file->features, isSwath);
    const bool hasTramlines =
        isPlan && std::ranges::any_of(file->features, [&](const VectorFeature& feature) {
            return isSwath(feature) && isTramline(feature);
        });
    std::vector<Polyline> rows;
    for (const VectorFeature& feature : file->features) {
        if (isPlan && (!isSwath(feature) || (hasTramlines && !isTramline(feature)))) {
            continue;
        }
        for (const GeoRing& line : feature.openLines) {
            if (line.size() > 1 && std::ranges::all_of(line, isFinite)) {
                rows.push_back(field.frame().toLocal(line));
            }
        }
        for (const GeoRing& ring : feature.closedLines) {
            if (std::ranges::all_of(ring, isFinite)) {
                rows.push_back(field.frame().toLocal(ring));
                rows.back().push_back(rows.back().front());
            }
        }
    }
    if (rows.empty()) {
        return std::unexpected(Error{.code = ErrorCode::InputRefused,
                                     .what = "there is no line in it",
                                     .where = path.string(),
                                     .remedy = "give a file with a line for each row"});
    }
    return rows;
}

Result<std::shared_ptr<const GuideData>> readGuides(const Settings& settings, const Field& field,
                                                    const JobContext& job) {
    GuideData guides;
    if (const std::string rows = settings.file(kRows); !rows.empty() && reads(settings, kRows)) {
        auto read = readRows(rows, field, job);
        if (!read) {
            return std::unexpected(read.error());
        }
        guides.rows = std::move(*read);
    }
    if (const std::string heights = settings.file(kElevation);
        !heights.empty() && reads(settings, kElevation)) {
        auto read = readElevation(heights, field.frame(), bounds(field.workable()), job);
        if (!read) {
            return std::unexpected(read.error());
        }
        guides.elevation = std::move(*read);
    }
    return std::make_shared<const GuideData>(std::move(guides));
}

}  // namespace furrow
