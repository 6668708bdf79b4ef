#include "planner/io/formats/gpx/gpx.h"

#include "planner/io/content/map_layers.h"
#include "planner/io/files/file_names.h"
#include "planner/plan/plan.h"

#include <pugixml.hpp>

#include <format>
#include <sstream>
#include <utility>

namespace furrow {

namespace {

constexpr std::size_t kLongestName = 255;

void addName(pugi::xml_node parent, const std::string& name) {
    parent.append_child("name").text().set(cutText(name, kLongestName).c_str());
}

pugi::xml_node addPoint(pugi::xml_node parent, const char* element, GeoPoint point) {
    pugi::xml_node node = parent.append_child(element);
    node.append_attribute("lat") = std::format("{:.9f}", point.latDeg).c_str();
    node.append_attribute("lon") = std::format("{:.9f}", point.lonDeg).c_str();
    return node;
}

void addWaypoints(pugi::xml_node gpx, const FieldSource& field) {
    for (const Gate& gate : field.gates) {
        addName(addPoint(gpx, "wpt", gate.position), gate.name.empty() ? "Gate" : gate.name);
    }
}

void addRoute(pugi::xml_node gpx, const Plan& plan) {
    pugi::xml_node route = gpx.append_child("rte");
    addName(route, "Swaths");
    for (std::size_t order = 0; order < plan.route.steps.size(); ++order) {
        const GeoRing line = swathLine(plan, plan.route.steps[order]);
        addName(addPoint(route, "rtept", line.front()), std::format("{} A", order + 1));
        addName(addPoint(route, "rtept", line.back()), std::format("{} B", order + 1));
    }
}

void addTrack(pugi::xml_node gpx, const Plan& plan) {
    pugi::xml_node track = gpx.append_child("trk");
    addName(track, plan.field().name());
    pugi::xml_node stretch;
    for (std::size_t i = 0; i < plan.path.segments.size(); ++i) {
        const bool goesOn = i > 0 && plan.path.segments[i].gear == plan.path.segments[i - 1].gear;
        if (!goesOn) {
            stretch = track.append_child("trkseg");
        }
        const GeoRing line = pathLine(plan, i);
        // A segment begins where the one before ends.
        for (std::size_t point = goesOn ? 1 : 0; point < line.size(); ++point) {
            addPoint(stretch, "trkpt", line[point]);
        }
    }
}

void addBoundary(pugi::xml_node gpx, const FieldSource& field) {
    pugi::xml_node track = gpx.append_child("trk");
    addName(track, field.name);
    const auto addRing = [track](const GeoRing& ring) {
        pugi::xml_node stretch = pugi::xml_node{track}.append_child("trkseg");
        for (const GeoPoint& point : ring) {
            addPoint(stretch, "trkpt", point);
        }
        addPoint(stretch, "trkpt", ring.front());
    };
    for (const GeoPolygon& part : field.parts) {
        addRing(part.outer);
        for (const GeoRing& hole : part.holes) {
            addRing(hole);
        }
    }
}

}  // namespace

Result<FormatFiles> writeGpx(const ExportJob& job) {
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    declaration.append_attribute("version") = "1.0";
    declaration.append_attribute("encoding") = "UTF-8";
    pugi::xml_node gpx = document.append_child("gpx");
    gpx.append_attribute("version") = "1.1";
    gpx.append_attribute("creator") = "Furrow";
    gpx.append_attribute("xmlns") = "http://www.topografix.com/GPX/1/1";
    // The schema wants waypoints, routes and tracks in this order.
    FormatFiles made;
    for (const FieldContent& content : job.fields) {
        addWaypoints(gpx, content.field);
    }
    if (job.plan != nullptr) {
        addRoute(gpx, *job.plan);
        addTrack(gpx, *job.plan);
    } else {
        for (const FieldContent& content : job.fields) {
            addBoundary(gpx, content.field);
        }
        made.notes.emplace_back("GPX has no areas: boundaries and holes are closed tracks.");
    }
    std::ostringstream out;
    document.save(out, " ", pugi::format_default, pugi::encoding_utf8);
    made.files.push_back({"path.gpx", [text = std::move(out).str()] { return text; }});
    return made;
}

}  // namespace furrow
