#include "planner/io/formats/csv/csv.h"

#include "planner/core/separated_text.h"
#include "planner/io/formats/csv/path_csv.h"

#include <algorithm>
#include <format>
#include <utility>

namespace furrow {

namespace {

std::string quoted(std::string text) {
    std::string quotedText = "\"";
    for (const char letter : text) {
        quotedText += letter == '"' ? std::string{"\"\""} : std::string{letter};
    }
    return quotedText + '"';
}

std::string ringText(const GeoRing& ring) {
    std::string text;
    const auto add = [&text](const GeoPoint& point) {
        text += std::format("{}{} {}", text.empty() ? "" : ", ", point.lonDeg, point.latDeg);
    };
    std::ranges::for_each(ring, add);
    add(ring.front());
    return "(" + text + ")";
}

std::string polygonText(const GeoPolygon& polygon) {
    std::string text = ringText(polygon.outer);
    for (const GeoRing& hole : polygon.holes) {
        text += ", " + ringText(hole);
    }
    return "(" + text + ")";
}

std::string fieldsCsv(const ExportJob& job) {
    std::string text = "id,name,WKT\n";
    for (const FieldContent& content : job.fields) {
        const auto& parts = content.field.parts;
        std::string wkt;
        for (const GeoPolygon& part : parts) {
            wkt += (wkt.empty() ? "" : ", ") + polygonText(part);
        }
        wkt = parts.size() == 1 ? "POLYGON " + wkt : "MULTIPOLYGON (" + wkt + ")";
        text += quoted(asPlainCell(content.field.id)) + "," + quoted(asPlainCell(content.field.name)) + "," +
                quoted(wkt) + "\n";
    }
    return text;
}

}  // namespace

Result<FormatFiles> writeCsv(const ExportJob& job) {
    FormatFiles made;
    if (job.plan != nullptr) {
        made.files.push_back({"path.csv", [&plan = *job.plan] { return pathCsv(plan); }});
        return made;
    }
    made.files.push_back({"fields.csv", [text = fieldsCsv(job)] { return text; }});
    const bool more = std::ranges::any_of(job.fields, [](const FieldContent& content) {
        return !content.field.obstacles.empty() || !content.field.gates.empty() || !content.lines.empty();
    });
    if (more) {
        made.notes.emplace_back("The table holds boundaries only: obstacles, gates and lines are left out.");
    }
    return made;
}

}  // namespace furrow
