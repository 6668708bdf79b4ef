#include "planner/io/formats/kml/kml.h"

#include "planner/core/separated_text.h"
#include "planner/core/text.h"
#include "planner/gdal/zip.h"

#include <pugixml.hpp>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace furrow {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

GeoPoint tupleOf(std::string_view text) {
    const std::vector<std::string_view> numbers = cellsOf(text, ',');
    const bool flat = numbers.size() == 2 || (numbers.size() == 3 && decimalIn(numbers[2]) == 0.0);
    return {flat ? decimalIn(numbers[0]).value_or(kNan) : kNan,
            flat ? decimalIn(numbers[1]).value_or(kNan) : kNan};
}

GeoRing coordinatesOf(pugi::xml_node node) {
    GeoRing points;
    for (const std::string_view tuple : cellsOf(node.child("coordinates").text().get(), ' ')) {
        points.push_back(tupleOf(tuple));
    }
    return points;
}

class KmlContent {
public:
    explicit KmlContent(ReceivedContent& found) : found_{found} {}

    void take(std::string_view bytes) {
        pugi::xml_document document;
        if (!document.load_buffer(bytes.data(), bytes.size()) || !document.child("kml").child("Document")) {
            found_.faults.push_back(isNot("KML"));
            return;
        }
        for (const pugi::xpath_node& mark : document.select_nodes("//Placemark")) {
            addPlacemark(mark.node());
        }
        if (!path_.samples.empty()) {
            found_.paths.push_back(std::move(path_));
        }
    }

private:
    static std::string data(pugi::xml_node mark, const char* name) {
        for (const pugi::xml_node each : mark.child("ExtendedData").children("Data")) {
            if (std::string_view{each.attribute("name").value()} == name) {
                return each.child("value").text().get();
            }
        }
        return {};
    }

    void addPlacemark(pugi::xml_node mark) {
        const std::string kind = data(mark, "kind");
        const std::string name = mark.child("name").text().get();
        const pugi::xml_node several = mark.child("MultiGeometry");
        const pugi::xml_node shapes = several ? several : mark;
        const auto stated = decimalIn(data(mark, "area_m2"));
        for (const pugi::xml_node polygon : shapes.children("Polygon")) {
            ReceivedArea area{.kind = kind == "field"      ? ReceivedArea::Kind::Field
                                      : kind == "obstacle" ? ReceivedArea::Kind::Obstacle
                                                           : ReceivedArea::Kind::Other,
                              .name = name,
                              .rings = {},
                              .statedM2 = several ? std::nullopt : stated};
            area.rings.outer = coordinatesOf(polygon.child("outerBoundaryIs").child("LinearRing"));
            for (const pugi::xml_node hole : polygon.children("innerBoundaryIs")) {
                area.rings.holes.push_back(coordinatesOf(hole.child("LinearRing")));
            }
            found_.areas.push_back(std::move(area));
        }
        for (const pugi::xml_node line : shapes.children("LineString")) {
            GeoRing points = coordinatesOf(line);
            if (kind == "path") {
                for (const GeoPoint& point : points) {
                    path_.samples.push_back({.geo = point});
                }
            } else {
                const auto width = decimalIn(data(mark, "width_m"));
                found_.lines.push_back({.name = name, .points = std::move(points), .widthM = width});
            }
        }
        for (const pugi::xml_node point : shapes.children("Point")) {
            std::ranges::copy(coordinatesOf(point), std::back_inserter(found_.points));
        }
    }

    ReceivedContent& found_;
    ReceivedPath path_;
};

}  // namespace

std::vector<ReceivedContent> findKml(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        ReceivedContent& found = all.emplace_back(
            ReceivedContent{.file = file.path, .winding = ReceivedContent::Winding::OuterLeft});
        if (!file.path.ends_with(".kmz")) {
            KmlContent{found}.take(file.bytes);
            continue;
        }
        const auto inside = filesInZip(file.bytes);
        if (inside.size() == 1 && inside.front().path == "doc.kml") {
            KmlContent{found}.take(inside.front().bytes);
        } else {
            found.faults.push_back(isMissing("doc.kml"));
        }
    }
    return all;
}

}  // namespace furrow
