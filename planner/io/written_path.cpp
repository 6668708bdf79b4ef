#include "planner/io/written_path.h"

#include "planner/io/file_folder.h"
#include "planner/io/path_csv.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <format>
#include <optional>
#include <string_view>

namespace furrow {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

Error refused(const std::string& where, std::string what) {
    return {.code = ErrorCode::InputRefused,
            .what = std::move(what),
            .where = where,
            .remedy = "write the plan again with furrow-cli plan"};
}

Result<std::string> planFile(const fs::path& folder, const char* name) {
    auto text = fileBytes(folder / name);
    if (!text && text.error().code == ErrorCode::ReadFailed) {
        Error error = text.error();
        error.remedy = "name the folder of a plan, as furrow-cli plan writes it";
        return std::unexpected(error);
    }
    return text;
}

Result<Json> jsonOf(const std::string& text, const fs::path& file) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        return std::unexpected(refused(file.string(), std::format("it is not JSON (byte {})", error.byte)));
    }
}

/// "+proj=tmerc +lat_0=51.3 +lon_0=9.2 ..."
std::optional<LocalFrame> frameFrom(std::string_view proj) {
    const auto number = [proj](std::string_view key) -> std::optional<double> {
        const std::size_t at = proj.find(key);
        double value = 0.0;
        if (at == std::string_view::npos) {
            return std::nullopt;
        }
        const char* begin = proj.data() + at + key.size();
        return std::from_chars(begin, proj.data() + proj.size(), value).ec == std::errc{}
                   ? std::optional{value}
                   : std::nullopt;
    };
    const auto latitude = number("+lat_0=");
    const auto longitude = number("+lon_0=");
    if (!latitude || !longitude) {
        return std::nullopt;
    }
    const auto frame = LocalFrame::centredOn({.lonDeg = *longitude, .latDeg = *latitude});
    return frame ? std::optional{*frame} : std::nullopt;
}

GeoRing ringOf(const Json& coordinates) {
    GeoRing ring;
    for (const Json& position : coordinates) {
        ring.push_back({position.at(0).get<double>(), position.at(1).get<double>()});
    }
    if (ring.size() > 1 && ring.front() == ring.back()) {
        ring.pop_back();
    }
    return ring;
}

Polygon polygonOf(const Json& rings, const LocalFrame& frame) {
    GeoPolygon polygon;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        if (i == 0) {
            polygon.outer = ringOf(rings[i]);
        } else {
            polygon.holes.push_back(ringOf(rings[i]));
        }
    }
    return frame.toLocal(polygon);
}

void addPolygons(const Json& geometry, const LocalFrame& frame, MultiPolygon& polygons) {
    const Json& coordinates = geometry.at("coordinates");
    if (geometry.at("type") == "Polygon") {
        polygons.push_back(polygonOf(coordinates, frame));
        return;
    }
    for (const Json& part : coordinates) {
        polygons.push_back(polygonOf(part, frame));
    }
}

/// Throws what nlohmann throws where members are missing or of another kind.
void addOutlines(const Json& geoJson, WrittenPath& plan) {
    for (const Json& feature : geoJson.at("features")) {
        const Json& kind = feature.at("properties").at("kind");
        if (kind == "field") {
            addPolygons(feature.at("geometry"), plan.frame, plan.field);
        } else if (kind == "obstacle") {
            addPolygons(feature.at("geometry"), plan.frame, plan.obstacles);
        }
    }
}

}  // namespace

Result<WrittenPath> readWrittenPath(const fs::path& folder) {
    const fs::path summaryFile = folder / "summary.json";
    const auto summaryText = planFile(folder, "summary.json");
    if (!summaryText) {
        return std::unexpected(summaryText.error());
    }
    const auto summary = jsonOf(*summaryText, summaryFile);
    if (!summary) {
        return std::unexpected(summary.error());
    }
    const auto csv = planFile(folder, "path.csv");
    auto path = csv ? readPathCsv(*csv, (folder / "path.csv").string()) : std::unexpected(csv.error());
    if (!path) {
        return std::unexpected(path.error());
    }
    std::string place = summaryFile.string();
    try {
        const auto frame = frameFrom(summary->at("crs").get<std::string>());
        if (!frame) {
            return std::unexpected(refused(place, "its crs is no local frame of a plan"));
        }
        WrittenPath plan{
            .name = summary->at("field").value("name", ""),
            .frame = *frame,
            .path = std::move(*path),
            .operatingWidth = metres(summary->at("machine").at("operating_width_m").get<double>())};
        if (!(plan.operatingWidth > metres(0.0))) {
            return std::unexpected(refused(place, "the machine's operating_width_m is not positive"));
        }
        const fs::path outlines = folder / "plan.geojson";
        if (fs::exists(outlines)) {
            place = outlines.string();
            const auto text = fileBytes(outlines);
            const auto json = text ? jsonOf(*text, outlines) : std::unexpected(text.error());
            if (!json) {
                return std::unexpected(json.error());
            }
            addOutlines(*json, plan);
        }
        return plan;
    } catch (const Json::exception&) {
        return std::unexpected(refused(place, "a member that every plan has is missing or of another kind"));
    }
}

}  // namespace furrow
