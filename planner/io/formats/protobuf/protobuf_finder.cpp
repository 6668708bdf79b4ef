#include "planner/io/formats/protobuf/protobuf.h"

#include "path_message.pb.h"

#include <optional>
#include <utility>

namespace furrow {

namespace {

GeoPoint geoOf(const v1::Place& place) {
    return {place.lon_deg(), place.lat_deg()};
}

ReceivedArea areaOf(const v1::Polygon& polygon, ReceivedArea::Kind kind) {
    ReceivedArea area{.kind = kind, .name = polygon.name(), .rings = {}, .statedM2 = std::nullopt};
    for (const v1::Place& place : polygon.outer()) {
        area.rings.outer.push_back(geoOf(place));
    }
    for (const v1::Ring& ring : polygon.holes()) {
        GeoRing& hole = area.rings.holes.emplace_back();
        for (const v1::Place& place : ring.places()) {
            hole.push_back(geoOf(place));
        }
    }
    return area;
}

}  // namespace

std::vector<ReceivedContent> findPathMessage(std::span<const FileInMemory> files, const ExportJob&) {
    std::vector<ReceivedContent> all;
    for (const FileInMemory& file : files) {
        ReceivedContent& found = all.emplace_back(ReceivedContent{.file = file.path, .repeatsFirst = false});
        v1::PathMessage message;
        if (!message.ParseFromString(file.bytes)) {
            found.faults.push_back(cannotBeRead());
            continue;
        }
        found.namesCrs = message.frame().proj().starts_with("+proj=");
        for (const v1::Polygon& polygon : message.fence()) {
            found.areas.push_back(areaOf(polygon, ReceivedArea::Kind::Field));
        }
        for (const v1::Polygon& polygon : message.keep_out()) {
            found.areas.push_back(areaOf(polygon, ReceivedArea::Kind::Obstacle));
        }
        ReceivedPath path{.samples = {}, .knowsGear = true};
        for (const v1::Segment& segment : message.segments()) {
            for (const v1::Sample& sample : segment.samples()) {
                path.samples.push_back({.geo = geoOf(sample.place()),
                                        .timeS = sample.time_s(),
                                        .headingRad = sample.heading_rad(),
                                        .speedMps = sample.speed_mps(),
                                        .reverse = segment.reverse()});
            }
        }
        found.paths.push_back(std::move(path));
    }
    return all;
}

}  // namespace furrow
