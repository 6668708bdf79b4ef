#include "planner/core/separated_text.h"
#include "planner/io/content/export_job.h"
#include "planner/io/content/received_content.h"
#include "planner/io/gdal_writer.h"

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
    return {flat ? decimalIn(numbers[0]).value_or(kNan) : kNan, flat ? decimalIn(numbers[1]).value_or(kNan) : kNan};
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
    explicit KmlContent(FoundContent& found) : found_{found} {}

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
            FoundArea area{.kind = kind == "field"      ? FoundArea::Kind::Field
                                   : kind == "obstacle" ? FoundArea::Kind::Obstacle
                                                        : FoundArea::Kind::Other,
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

    FoundContent& found_;
    FoundPath path_;
};

GeoPoint gpxPoint(pugi::xml_node node) {
    return {decimalIn(node.attribute("lon").value()).value_or(kNan), decimalIn(node.attribute("lat").value()).value_or(kNan)};
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

void takeGpx(std::string_view bytes, bool ofPlan, FoundContent& found) {
    pugi::xml_document document;
    const pugi::xml_node gpx = document.load_buffer(bytes.data(), bytes.size()) ? document.child("gpx") : pugi::xml_node{};
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
    FoundPath path;
    for (const pugi::xml_node track : gpx.children("trk")) {
        for (const pugi::xml_node stretch : track.children("trkseg")) {
            GeoRing points;
            for (const pugi::xml_node point : stretch.children("trkpt")) {
                points.push_back(gpxPoint(point));
            }
            if (!ofPlan) {
                found.areas.push_back({.kind = FoundArea::Kind::Field,
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

/// Pairs of a group code and a value.
class DrawingPairs {
public:
    explicit DrawingPairs(std::string_view text) : text_{text} {}

    bool next() {
        if (text_.empty()) {
            return false;
        }
        code_ = decimalIn(nextLine(text_));
        value_ = nextLine(text_);
        number_ += 2;
        return code_.has_value();
    }
    bool is(double code) const { return code_ == code; }
    std::string_view value() const { return value_; }
    std::size_t number() const { return number_; }

private:
    std::string_view text_;
    std::optional<double> code_;
    std::string_view value_;
    std::size_t number_ = 0;
};

class DrawingContent {
public:
    explicit DrawingContent(FoundContent& found) : found_{found} {}

    void take(const ExportedFile& file) {
        constexpr std::string_view kCode = "_EPSG";
        const std::size_t at = file.path.rfind(kCode);
        const std::size_t end = file.path.rfind('.');
        const auto epsg = at == std::string::npos || end < at
                              ? std::nullopt
                              : decimalIn(std::string_view{file.path}.substr(at + kCode.size(), end - at - kCode.size()));
        found_.namesCrs = epsg.has_value();
        const UtmZone zone{.epsg = static_cast<int>(epsg.value_or(0.0))};
        DrawingPairs pairs{file.bytes};
        std::string layer;
        std::string entity;
        bool inside = false;
        bool ended = false;
        while (pairs.next()) {
            if (pairs.is(0)) {
                entity = pairs.value();
                ended = entity == "EOF";
                if (entity == "POLYLINE") {
                    inside = true;
                    layer.clear();
                    lines_.push_back({.layer = {}, .first = places_.size()});
                } else if (entity == "VERTEX") {
                    places_.emplace_back(kNan, kNan);
                } else if (entity == "SEQEND" && inside) {
                    inside = false;
                    lines_.back().layer = layer;
                }
            } else if (inside && pairs.is(8) && layer.empty()) {
                layer = pairs.value();
            } else if (entity == "VERTEX" && !places_.empty() && (pairs.is(10) || pairs.is(20))) {
                (pairs.is(10) ? places_.back().first : places_.back().second) = decimalIn(pairs.value()).value_or(kNan);
            }
        }
        if (!ended || inside) {
            found_.faults.push_back(badLine(pairs.number()));
        }
        const auto geo = zone.unproject(places_);
        if (!geo) {
            found_.namesCrs = false;
            return;
        }
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            const std::size_t behind = i + 1 < lines_.size() ? lines_[i + 1].first : geo->size();
            add(lines_[i].layer, {geo->begin() + static_cast<std::ptrdiff_t>(lines_[i].first),
                                  geo->begin() + static_cast<std::ptrdiff_t>(behind)});
        }
        if (!path_.samples.empty()) {
            found_.paths.push_back(std::move(path_));
        }
    }

private:
    struct Line {
        std::string layer;
        std::size_t first = 0;  ///< of its places
    };

    void add(const std::string& layer, GeoRing points) {
        if (layer == "PATH") {
            for (const GeoPoint& point : points) {
                path_.samples.push_back({.geo = point});
            }
        } else if (layer == "SWATH") {
            found_.lines.push_back({.name = layer, .points = std::move(points), .widthM = std::nullopt});
        } else {
            found_.areas.push_back({.kind = layer == "BOUNDARY" || layer == "HOLE" ? FoundArea::Kind::Field
                                            : layer == "OBSTACLE"                  ? FoundArea::Kind::Obstacle
                                                                                   : FoundArea::Kind::Other,
                                    .name = layer,
                                    .rings = {.outer = std::move(points), .holes = {}},
                                    .statedM2 = std::nullopt});
        }
    }

    FoundContent& found_;
    FoundPath path_;
    std::vector<Line> lines_;
    std::vector<std::pair<double, double>> places_;
};

}  // namespace

std::vector<FoundContent> findKml(std::span<const ExportedFile> files, const ExportJob&) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        FoundContent& found =
            all.emplace_back(FoundContent{.file = file.path, .winding = FoundContent::Winding::OuterLeft});
        if (!file.path.ends_with(".kmz")) {
            KmlContent{found}.take(file.bytes);
            continue;
        }
        const auto inside = filesInZip(file.bytes);
        if (inside.size() == 1 && inside.front().first == "doc.kml") {
            KmlContent{found}.take(inside.front().second);
        } else {
            found.faults.push_back(isMissing("doc.kml"));
        }
    }
    return all;
}

std::vector<FoundContent> findGpx(std::span<const ExportedFile> files, const ExportJob& job) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        takeGpx(file.bytes, job.plan != nullptr, all.emplace_back(FoundContent{.file = file.path}));
    }
    return all;
}

std::vector<FoundContent> findDxf(std::span<const ExportedFile> files, const ExportJob&) {
    std::vector<FoundContent> all;
    for (const ExportedFile& file : files) {
        FoundContent& found = all.emplace_back(FoundContent{.file = file.path, .repeatsFirst = false});
        DrawingContent{found}.take(file);
    }
    return all;
}

}  // namespace furrow
