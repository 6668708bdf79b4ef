#include "planner/io/formats/kml/kml.h"

#include "planner/gdal/zip.h"
#include "planner/io/content/geo_ring.h"
#include "planner/io/content/map_layers.h"
#include "planner/io/files/file_names.h"
#include "planner/plan/plan.h"

#include <pugixml.hpp>

#include <algorithm>
#include <format>
#include <sstream>
#include <utility>

namespace furrow {

namespace {

/// Colours are alpha, blue, green, red.
struct Style {
    const char* id;
    const char* line;
    const char* width;
    const char* fill;
};
constexpr Style kStyles[] = {{"boundary", "ff00a5ff", "3", "1a00a5ff"},
                             {"obstacle", "ff2222cc", "2", "402222cc"},
                             {"mainland", "ff30c030", "2", "0030c030"},
                             {"line", "ffffffff", "2", "00ffffff"},
                             {"path", "ffd08000", "2", "00d08000"}};

std::string coordinates(const GeoRing& points, bool closed) {
    std::string text;
    const auto add = [&text](const GeoPoint& point) {
        text += std::format("{}{:.9f},{:.9f}", text.empty() ? "" : " ", point.lonDeg, point.latDeg);
    };
    std::ranges::for_each(points, add);
    if (closed && !points.empty()) {
        add(points.front());
    }
    return text;
}

class KmlText {
public:
    KmlText(const std::string& name) {
        pugi::xml_node declaration = file_.append_child(pugi::node_declaration);
        declaration.append_attribute("version") = "1.0";
        declaration.append_attribute("encoding") = "UTF-8";
        pugi::xml_node kml = file_.append_child("kml");
        kml.append_attribute("xmlns") = "http://www.opengis.net/kml/2.2";
        document_ = kml.append_child("Document");
        addText(document_, "name", name);
        for (const Style& style : kStyles) {
            pugi::xml_node node = document_.append_child("Style");
            node.append_attribute("id") = style.id;
            pugi::xml_node line = node.append_child("LineStyle");
            addText(line, "color", style.line);
            addText(line, "width", style.width);
            addText(node.append_child("PolyStyle"), "color", style.fill);
        }
    }

    void folder(const char* name) {
        folder_ = document_.append_child("Folder");
        addText(folder_, "name", name);
    }

    pugi::xml_node placemark(const std::string& name, const char* style, const char* kind) {
        pugi::xml_node mark = folder_.append_child("Placemark");
        addText(mark, "name", name);
        addText(mark, "styleUrl", std::string{"#"} + style);
        data_ = mark.append_child("ExtendedData");
        data("kind", kind);
        return mark;
    }
    void data(const char* name, const std::string& value) {
        pugi::xml_node data = data_.append_child("Data");
        data.append_attribute("name") = name;
        addText(data, "value", value);
    }

    static void polygons(pugi::xml_node mark, const std::vector<GeoPolygon>& polygons) {
        pugi::xml_node parent = polygons.size() == 1 ? mark : mark.append_child("MultiGeometry");
        for (const GeoPolygon& polygon : polygons) {
            pugi::xml_node node = parent.append_child("Polygon");
            addText(node, "tessellate", "1");
            ring(node.append_child("outerBoundaryIs"), polygon.outer, true);
            for (const GeoRing& hole : polygon.holes) {
                ring(node.append_child("innerBoundaryIs"), hole, false);
            }
        }
    }
    static void line(pugi::xml_node mark, const GeoRing& points) {
        pugi::xml_node node = mark.append_child("LineString");
        addText(node, "tessellate", "1");
        addText(node, "coordinates", coordinates(points, false));
    }
    static void point(pugi::xml_node mark, GeoPoint place) {
        addText(mark.append_child("Point"), "coordinates", coordinates({place}, false));
    }

    std::string text() const {
        std::ostringstream out;
        file_.save(out, " ", pugi::format_default, pugi::encoding_utf8);
        return std::move(out).str();
    }

private:
    static void addText(pugi::xml_node parent, const char* name, const std::string& text) {
        parent.append_child(name).text().set(cutText(text, text.size()).c_str());
    }
    static void ring(pugi::xml_node parent, GeoRing points, bool counterClockwise) {
        if (isCounterClockwise(points) != counterClockwise) {
            std::ranges::reverse(points);
        }
        addText(parent.append_child("LinearRing"), "coordinates", coordinates(points, true));
    }

    pugi::xml_document file_;
    pugi::xml_node document_;
    pugi::xml_node folder_;
    pugi::xml_node data_;
};

void addFields(KmlText& kml, const ExportJob& job) {
    kml.folder("Boundaries");
    for (const FieldContent& content : job.fields) {
        pugi::xml_node mark = kml.placemark(content.field.name, "boundary", "field");
        kml.data("id", content.field.id);
        kml.data("area_m2", std::format("{:.0f}", content.statedArea().si()));
        KmlText::polygons(mark, content.field.parts);
    }
    kml.folder("Obstacles");
    for (const FieldContent& content : job.fields) {
        for (const Obstacle& obstacle : content.field.obstacles) {
            pugi::xml_node mark = kml.placemark(obstacle.name, "obstacle", "obstacle");
            kml.data("passable", obstacle.passable ? "1" : "0");
            kml.data("buffer_m", std::format("{}", obstacle.buffer.si()));
            if (obstacle.overhang != Length{}) {
                kml.data("overhang_m", std::format("{}", obstacle.overhang.si()));
            }
            KmlText::polygons(mark, {obstacle.outline});
        }
    }
    kml.folder("Gates");
    for (const FieldContent& content : job.fields) {
        for (const Gate& gate : content.field.gates) {
            pugi::xml_node mark = kml.placemark(gate.name, "boundary", "gate");
            kml.data("width_m", std::format("{}", gate.width.si()));
            KmlText::point(mark, gate.position);
        }
    }
    kml.folder("Headland");
    for (const FieldContent& content : job.fields) {
        if (!content.mainland.empty()) {
            KmlText::polygons(kml.placemark("Mainland", "mainland", "mainland"), content.mainland);
        }
    }
}

void addLines(KmlText& kml, const ExportJob& job) {
    kml.folder("Lines");
    for (const FieldContent& content : job.fields) {
        for (const GuidanceLine& line : content.lines) {
            const GeoRing points = drawn(line, metres(100.0));
            if (points.size() >= 2) {
                pugi::xml_node mark = kml.placemark(line.name, "line", "guidance");
                kml.data("guidance", std::string{guidanceKindId(line.kind)});
                kml.data("width_m", std::format("{}", line.width.value_or(Length{}).si()));
                KmlText::line(mark, points);
            }
        }
    }
}

void addPlan(KmlText& kml, const Plan& plan) {
    kml.folder("Swaths");
    for (const RouteStep& step : plan.route.steps) {
        const int number = plan.swaths.swaths[step.swath].number;
        pugi::xml_node mark = kml.placemark(std::format("Swath {}", number), "line", "swath");
        kml.data("number", std::format("{}", number));
        kml.data("width_m", std::format("{}", plan.swaths.swaths[step.swath].width.si()));
        KmlText::line(mark, swathLine(plan, step));
    }
    kml.folder("Path");
    for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
        const std::string kind{segmentKindId(plan.path.segments[i].kind)};
        pugi::xml_node mark = kml.placemark(std::format("{} {}", i + 1, kind), "path", "path");
        kml.data("segment", kind);
        KmlText::line(mark, pathLine(plan, i));
    }
}

std::string kmlText(const ExportJob& job) {
    KmlText kml{job.fields.front().field.name};
    addFields(kml, job);
    if (job.plan != nullptr) {
        addPlan(kml, *job.plan);
    } else {
        addLines(kml, job);
    }
    return kml.text();
}

}  // namespace

Result<FormatFiles> writeKml(const ExportJob& job) {
    FormatFiles made;
    made.files.push_back({"plan.kml", [text = kmlText(job)] { return text; }});
    return made;
}

Result<FormatFiles> writeKmz(const ExportJob& job) {
    const FileInMemory document{"doc.kml", kmlText(job)};
    return zipOf({&document, 1}).transform([](std::string zip) {
        FormatFiles made;
        made.files.push_back(toWrite({"plan.kmz", std::move(zip)}));
        return made;
    });
}

}  // namespace furrow
