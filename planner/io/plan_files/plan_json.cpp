#include "planner/io/plan_files/plan_json.h"

#include "planner/core/json_text.h"
#include "planner/io/files/file_folder.h"

#include <utility>

namespace furrow {

namespace {

using Json = nlohmann::json;

GeoPolygon polygonOf(const Json& rings) {
    GeoPolygon polygon;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        GeoRing ring = pointsOf(rings[i]);
        if (ring.size() > 1 && ring.front() == ring.back()) {
            ring.pop_back();
        }
        if (i == 0) {
            polygon.outer = std::move(ring);
        } else {
            polygon.holes.push_back(std::move(ring));
        }
    }
    return polygon;
}

}  // namespace

Result<std::string> planFileBytes(const std::filesystem::path& path) {
    auto bytes = fileBytes(path);
    if (!bytes && bytes.error().code == ErrorCode::ReadFailed) {
        Error error = bytes.error();
        error.remedy = "name the folder of a plan, as furrow-cli plan writes it";
        return std::unexpected(error);
    }
    return bytes;
}

Result<Json> planJson(const std::filesystem::path& path) {
    const auto text = planFileBytes(path);
    if (!text) {
        return std::unexpected(text.error());
    }
    auto json = readJson<Json>(*text);
    if (!json) {
        const JsonFault& fault = json.error();
        return std::unexpected(damagedPlan(
            fault.place.empty() ? Message{path.string()} : message("{}, {}", path.string(), fault.place),
            fault.what));
    }
    return *std::move(json);
}

Result<LocalFrame> planFrame(const Json& summary, const std::filesystem::path& path) {
    const bool named = summary.is_object() && summary.contains("crs") && summary["crs"].is_string();
    auto frame = named ? LocalFrame::fromProjString(summary["crs"].get<std::string>())
                       : Result<LocalFrame>{std::unexpected(Error{})};
    if (!frame) {
        return std::unexpected(damagedPlan(path.string() + ", crs", "it names no local frame"));
    }
    return frame;
}

GeoRing pointsOf(const Json& coordinates) {
    GeoRing points;
    for (const Json& position : coordinates) {
        points.push_back({position.at(0).get<double>(), position.at(1).get<double>()});
    }
    return points;
}

MultiPolygon polygonsOf(const Json& geometry, const LocalFrame& frame) {
    MultiPolygon polygons;
    const Json& coordinates = geometry.at("coordinates");
    if (geometry.at("type") == "Polygon") {
        polygons.push_back(frame.toLocal(polygonOf(coordinates)));
    } else {
        for (const Json& part : coordinates) {
            polygons.push_back(frame.toLocal(polygonOf(part)));
        }
    }
    return polygons;
}

}  // namespace furrow
