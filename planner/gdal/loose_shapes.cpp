#include "planner/gdal/loose_shapes.h"

#include "planner/core/file_error.h"
#include "planner/core/text.h"
#include "planner/core/text_file.h"
#include "planner/gdal/feature_shapes.h"

#include <ogr_geometry.h>
#include <ogr_spatialref.h>
#include <pugixml.hpp>

#include <algorithm>
#include <charconv>
#include <memory>
#include <sstream>
#include <utility>

namespace furrow {

namespace {

/// Takes "SRID=25832;" from a place in a text; an empty system where there is none.
Result<OGRSpatialReference> takeSystem(const std::string& text, std::size_t& at, const Message& place) {
    OGRSpatialReference system;
    if (inSmallLetters(std::string_view{text}.substr(at, 5)) != "srid=") {
        return system;
    }
    int code = 0;
    const char* end = text.data() + text.size();
    const auto [next, error] = std::from_chars(text.data() + at + 5, end, code);
    if (error != std::errc{} || next == end || *next != ';' ||
        (code != 0 && system.importFromEPSG(code) != OGRERR_NONE)) {
        return std::unexpected(inputRefused(place,
                                            "the number after SRID= is no coordinate system that is known",
                                            "give an EPSG code, as in SRID=4326;POLYGON(...)"));
    }
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    at = static_cast<std::size_t>(next - text.data()) + 1;
    return system;
}

/// The name of what this element belongs to: a child `name` of one of its ancestors.
std::string nameAround(pugi::xml_node node) {
    for (pugi::xml_node around = node.parent(); around; around = around.parent()) {
        if (const pugi::xml_node name = around.child("name")) {
            return name.text().as_string();
        }
    }
    return {};
}

/// The coordinate system that an element names by itself, or by what it is part of; empty for none.
std::string systemNamed(pugi::xml_node node) {
    for (; node; node = node.parent()) {
        if (std::string name = node.attribute("srsName").as_string(); !name.empty()) {
            return name;
        }
    }
    return {};
}

}  // namespace

Result<void> readWktShapes(const std::string& text, const std::string& name, const VectorReading& reading) {
    std::size_t at = text.size() - withoutByteOrderMark(text).size();
    while (true) {
        at = text.find_first_not_of(" \t\r\n;,\"", at);
        if (at == std::string::npos) {
            return {};
        }
        if (reading.job.stopRequested()) {
            return std::unexpected(cancelled());
        }
        const Message place = message("{}, {}", name, lineAndColumn(text, at));
        const auto system = takeSystem(text, at, place);
        if (!system) {
            return std::unexpected(system.error());
        }
        const char* rest = text.c_str() + at;
        OGRGeometry* made = nullptr;
        const OGRErr error = OGRGeometryFactory::createFromWkt(&rest, nullptr, &made);
        const std::unique_ptr<OGRGeometry> geometry{made};
        if (error != OGRERR_NONE || !geometry) {
            return std::unexpected(
                inputRefused(place, "this is not well-known text from here on",
                             "write POLYGON((lon lat, lon lat, ...)), one polygon a line"));
        }
        const auto toWgs84 = ToWgs84::from(&*system, name);
        if (!toWgs84) {
            return std::unexpected(toWgs84.error());
        }
        VectorFeature feature;
        feature.attributes.resize(reading.attributes.size());
        if (auto added = addShapes(*geometry, *toWgs84, feature, place); !added) {
            return added;
        }
        reading.file.features.push_back(std::move(feature));
        at = static_cast<std::size_t>(rest - text.c_str());
    }
}

Result<void> readPolygonElements(const std::string& text, const std::string& name,
                                 const VectorReading& reading) {
    pugi::xml_document document;
    if (const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size()); !parsed) {
        return std::unexpected(readFailed(
            message("{}, {}", name, lineAndColumn(text, static_cast<std::size_t>(parsed.offset))),
            "this is not XML from here on", "the file may be cut off or damaged; export it again"));
    }
    const auto nameColumn = std::ranges::find(reading.attributes, "name") - reading.attributes.begin();
    for (const pugi::xpath_node& found : document.select_nodes("//*[local-name()='Polygon']")) {
        std::ostringstream gml;
        found.node().print(gml, "", pugi::format_raw);
        const std::unique_ptr<OGRGeometry> geometry{OGRGeometryFactory::createFromGML(gml.str().c_str())};
        if (!geometry) {
            return std::unexpected(inputRefused(
                message("{}, {}", name,
                        lineAndColumn(text, static_cast<std::size_t>(found.node().offset_debug()))),
                "this polygon cannot be read", "check its coordinates"));
        }
        // A polygon by itself is read without its system.
        OGRSpatialReference named;
        named.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        const std::string system =
            geometry->getSpatialReference() == nullptr ? systemNamed(found.node()) : std::string{};
        // Neither files nor other computers are asked for it.
        if (!system.empty() &&
            named.SetFromUserInput(
                system.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS_get()) != OGRERR_NONE) {
            return std::unexpected(inputRefused(name, "the coordinate system that it names is not known",
                                                "export the field again in WGS84 (longitude and latitude)"));
        }
        const Result<ToWgs84> toWgs84 =
            ToWgs84::from(system.empty() ? geometry->getSpatialReference() : &named, name);
        if (!toWgs84) {
            return std::unexpected(toWgs84.error());
        }
        VectorFeature feature;
        feature.attributes.resize(reading.attributes.size());
        if (std::cmp_less(nameColumn, reading.attributes.size())) {
            feature.attributes[static_cast<std::size_t>(nameColumn)] = nameAround(found.node());
        }
        if (auto added = addShapes(*geometry, *toWgs84, feature, name); !added) {
            return added;
        }
        reading.file.features.push_back(std::move(feature));
    }
    return {};
}

}  // namespace furrow
