#include "planner/io/formats/gpx/gpx.h"

#include "planner/core/text.h"

#include <pugixml.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace furrow {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

GeoPoint gpxPoint(pugi::xml_node node) {
    return {decimalIn(node.attribute("lon").value()).value_or(kNan),
            decimalIn(node.attribute("lat").value()).value_or(kNan)};
}

/// Waypoints, then routes, then tracks: the schema's order.
std::optional<Message> wrongOrder(pugi::xml_node gpx) {
    constexpr std::string_view kOrder[] = {"metadata", "wpt", "rte", "trk", "extensions"};
    auto last = std::begin(kOrder);
    for (const pugi::xml_node child : gpx.children()) {
        const auto* const place = std::ranges::find(kOrder, std::string_view{child.name()});
        if (place < last) {
            return message("{} comes where {} should", *place, *last);
        }
        last = place == std::end(kOrder) ? last : place;
    }
    return std::nullopt;
}

void takeGpx(std::string_view bytes, bool ofPlan, ReceivedContent& found) {
    pugi::xml_document document;
    const pugi::xml_node gpx =
        document.load_buffer(bytes.data(), bytes.size()) ? document.child("gpx") : pugi::xml_node{};
    if (!gpx || std::string_view{gpx.attribute("version").value()} != "1.1") {
        found.faults.push_back(isNot("GPX 1.1"));
        return;
    }
    if (const auto wrong = wrongOrder(gpx)) {
        found.faults.push_back(*wrong);
    }
    for (const pugi::xml_node point : gpx.children("wpt")) {
        found.points.push_back(gpxPoint(point));
    }
    for (const pugi::xml_node route : gpx.children("rte")) {
        for (const pugi::xml_node point : route.children("rtept")) {
            found.points.push_back(gpxPoint(point));
        }
    }
    ReceivedPath path;
    for (const pugi::xml_node track : gpx.children("trk")) {
        for (const pugi::xml_node stretch : track.children("trkseg")) {
            GeoRing points;
            for (const pugi::xml_node point : stretch.children("trkpt")) {
                points.push_back(gpxPoint(point));
            }
            if (!ofPlan) {
                found.areas.push_back({.kind = ReceivedArea::Kind::Field,
                                       .name = track.child("name").text().get(),
                                       .rings = {.outer = std::move(points), .holes = {}},
                                       .statedM2 = std::nullopt});
                continue;
            }
            for (const GeoPoint& point : points) {
                path.samples.push_back({.geo = point});
            }
        }
    }
    if (ofPlan) {
        found.paths.push_back(std::move(path));
    }
}

}  // namespace

std::vector<ReceivedContent> findGpx(std::span<const FileInMemory> files, const ExportJob& job) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        takeGpx(file.bytes, job.plan != nullptr, all.emplace_back(ReceivedContent{.file = file.path}));
    }
    return all;
}

}  // namespace furrow
