#include "planner/io/formats/registry.h"

#include "planner/io/formats/agopengps/agopengps.h"
#include "planner/io/formats/csv/csv.h"
#include "planner/io/formats/dxf/dxf.h"
#include "planner/io/formats/geojson/geojson.h"
#include "planner/io/formats/geopackage/geopackage.h"
#include "planner/io/formats/gpx/gpx.h"
#include "planner/io/formats/isoxml/isoxml.h"
#include "planner/io/formats/kml/kml.h"
#include "planner/io/formats/logs/logs.h"
#include "planner/io/formats/mavlink/mavlink.h"
#include "planner/io/formats/protobuf/protobuf.h"
#include "planner/io/formats/raster/raster_mask.h"
#include "planner/io/formats/ros/ros.h"
#include "planner/io/formats/shapefile/shapefile.h"
#include "planner/io/formats/vector/vector_fields.h"

#include <algorithm>
#include <string>

namespace furrow {

namespace {

constexpr Format::Fields kByGdal{recogniseVector, readVectorFields};
constexpr Format::Fields kTaskData{recogniseIsoxml, readIsoxmlFields};
constexpr Format::Tracks kTimeLogs{recogniseTimeLogs, readTimeLogs};
constexpr Format::Tracks kRosbag{recogniseRosbag, readRosbag};

constexpr CarriedContent kMapContent{.fields = true, .holes = true, .swaths = true, .path = true};
constexpr CarriedContent kTerminalContent{.fields = true, .holes = true, .holesApart = true, .lines = true};

/// A row for each.
constexpr Format kFormats[] = {
    {"geojson",
     "GeoJSON",
     "geojson json",
     "Boundary, obstacles, gates, headland, swaths, path and findings; for maps and programs.",
     kByGdal,
     {.write = writeGeoJson, .fieldsAlone = true, .find = findGeoJson, .content = kMapContent}},
    {"csv",
     "CSV table",
     "csv",
     "Every sample of the path; without a plan boundaries as WKT, or as points.",
     kByGdal,
     {.write = writeCsv,
      .fieldsAlone = true,
      .find = findCsv,
      .content = {.fields = true, .holes = true, .path = true, .pathAlone = true}},
     {recogniseTrackTable, readTrackTable}},
    {"isoxml",
     "ISOXML 4.3",
     "xml zip",
     "Boundary, holes, obstacles, gates, headland and guidance lines for terminals; no driving order.",
     kTaskData,
     {.write = writeIsoxml4,
      .fieldsAlone = true,
      .fieldsTogether = true,
      .find = findIsoxml,
      .content = kTerminalContent},
     kTimeLogs},
    {"isoxml-v3",
     "ISOXML 3.3",
     "xml zip",
     "Boundary, holes, obstacles and guidance lines for older terminals; no headland, no driving order.",
     kTaskData,
     {.write = writeIsoxml3,
      .fieldsAlone = true,
      .fieldsTogether = true,
      .folder = "isoxml-v3",
      .find = findIsoxml,
      .content = kTerminalContent},
     kTimeLogs},
    {"agopengps",
     "AgOpenGPS field",
     "",
     "Boundary, holes, headland, guidance lines, and the whole driven path as a recorded path.",
     {recogniseAgOpenGps, readAgOpenGpsFields},
     {.write = writeAgOpenGps,
      .fieldsAlone = true,
      .folder = "agopengps",
      .find = findAgOpenGps,
      .content = {.fields = true, .holes = true, .obstaclesAsHoles = true, .path = true}}},
    {"shapefile",
     "Shapefile",
     "shp zip",
     "Boundary, obstacles, gates, inside of the headland, swaths and path, a shapefile of each.",
     kByGdal,
     {.write = writeShapefiles,
      .fieldsAlone = true,
      .folder = "shapefile",
      .find = findShapefiles,
      .content = kMapContent}},
    {"shapefile-zip",
     "Zipped boundary",
     "zip",
     "The boundary alone as a flat zipped shapefile, as operations centres take it.",
     kByGdal,
     {.write = writeBoundaryZip,
      .fieldsAlone = true,
      .find = findZippedShapefile,
      .content = {.fields = true, .holes = true}}},
    {"aggps",
     "AgGPS folder",
     "",
     "Boundary and guidance lines for Trimble and FM displays; no driving order.",
     {recogniseAgGps, readAgGpsFields},
     {.write = writeAgGps,
      .fieldsAlone = true,
      .fieldsTogether = true,
      .find = findShapefiles,
      .content = {.fields = true, .holes = true, .lines = true}}},
    {"kml",
     "KML",
     "kml",
     "Boundary, obstacles, gates, headland, swaths and path, to look at.",
     kByGdal,
     {.write = writeKml, .fieldsAlone = true, .find = findKml, .content = kMapContent}},
    {"kmz",
     "KMZ",
     "kmz",
     "The same as KML, zipped.",
     kByGdal,
     {.write = writeKmz, .fieldsAlone = true, .find = findKml, .content = kMapContent}},
    {"geopackage",
     "GeoPackage",
     "gpkg",
     "Boundary, obstacles, gates, inside of the headland, swaths and path as layers for a GIS.",
     kByGdal,
     {.write = writeGeoPackage, .fieldsAlone = true, .find = findGeoPackage, .content = kMapContent}},
    {"gpx",
     "GPX",
     "gpx",
     "The path as a track, swath ends as a route, gates as waypoints; for phones.",
     kByGdal,
     {.write = writeGpx,
      .fieldsAlone = true,
      .find = findGpx,
      .content = {.fields = true, .holesAsFields = true, .path = true, .pathAlone = true}},
     {recogniseGpxTracks, readGpxTracks}},
    {"dxf",
     "DXF drawing",
     "dxf",
     "Boundary, holes, obstacles, headland, swaths and path in metres of the UTM zone.",
     kByGdal,
     {.write = writeDxf,
      .fieldsAlone = true,
      .find = findDxf,
      .content = {.fields = true, .holesAsFields = true, .swaths = true, .path = true}}},
    {"waypoints",
     "MAVLink waypoints",
     "waypoints",
     "The path as a mission for ArduPilot Rover: waypoints, speeds, gear, implement.",
     {},
     {.write = writeWaypoints, .find = findWaypoints, .content = {.path = true}}},
    {"qgc-plan",
     "QGroundControl plan",
     "plan",
     "The same mission with the boundary and obstacles as fences.",
     {},
     {.write = writeGroundStationPlan,
      .find = findGroundStationPlan,
      .content = {.fields = true, .path = true}}},
    {"rosbag2",
     "rosbag2, sqlite3",
     "db3",
     "The path as nav_msgs/Path in a recording of ROS 2.",
     {},
     {.write = writeRosbagSqlite, .folder = "ros", .find = findRosbag, .content = {.path = true}},
     kRosbag},
    {"rosbag2-mcap",
     "rosbag2, MCAP",
     "mcap",
     "The path as nav_msgs/Path in a recording of ROS 2.",
     {},
     {.write = writeRosbagMcap, .folder = "ros", .find = findRosbag, .content = {.path = true}},
     kRosbag},
    {"nav-path",
     "nav_msgs/Path as YAML",
     "yaml",
     "The path as one message for ros2 topic pub.",
     {},
     {.write = writeNavPathYaml, .folder = "ros", .find = findNavPathYaml, .content = {.path = true}}},
    {"coverage-goal",
     "opennav_coverage goal",
     "yaml",
     "Boundary, headland, heading and order; the robot lays swaths and turns itself.",
     {},
     {.write = writeCoverageGoal, .folder = "ros", .find = findCoverageGoal}},
    {"protobuf",
     "Protobuf message",
     "pb",
     "The path with times, velocities and orientations, and the boundary as a fence; for own robots.",
     {},
     {.write = writeProtobuf,
      .find = findPathMessage,
      .content = {.fields = true, .holes = true, .path = true}}},
    {"gml", "GML", "gml xml", "Boundaries, also field files of Fields2Cover and GAOS.", kByGdal},
    {"flatgeobuf", "FlatGeobuf", "fgb", "Boundaries.", kByGdal},
    {"wkt", "Well-known text", "wkt txt", "Boundaries in longitude and latitude.", kByGdal},
    {"raster",
     "Raster mask",
     "tif png",
     "What is worked and what is not, as a field.",
     {recogniseRaster, readRasterMask}},
    {"logs",
     "NMEA or gpsd log",
     "log nmea txt json",
     "What a machine drove.",
     {},
     {},
     {recogniseLog, readLog}},
};

/// Of those that read this, by the recogniser of each.
template <class RecogniserOf>
RecognisedFormat surestOf(const ChosenFile& chosen, const RecogniserOf& recogniserOf) {
    RecognisedFormat surest;
    for (const Format& format : kFormats) {
        FormatRecogniser* const recognise = recogniserOf(format);
        const Recognition how = recognise == nullptr ? Recognition::No : recognise(chosen);
        if (how > surest.how) {
            surest = {&format, how};
        }
    }
    return surest;
}

}  // namespace

std::span<const Format> formats() {
    return kFormats;
}

const Format* formatCalled(std::string_view id) {
    const auto* const found = std::ranges::find(kFormats, id, &Format::id);
    return found == std::end(kFormats) ? nullptr : found;
}

RecognisedFormat recognisedAsFields(const ChosenFile& chosen) {
    return surestOf(chosen, [](const Format& format) { return format.fields.recognise; });
}

RecognisedFormat recognisedAsTracks(const ChosenFile& chosen) {
    return surestOf(chosen, [](const Format& format) { return format.tracks.recognise; });
}

Result<const Format*> findPlanFormat(std::string_view id) {
    std::string known;
    for (const Format& format : kFormats) {
        if (format.writes() && format.id == id) {
            return &format;
        }
        if (format.writes()) {
            known += (known.empty() ? "" : ", ") + std::string{format.id};
        }
    }
    return std::unexpected(Error{.code = ErrorCode::Usage,
                                 .what = message("plans cannot be written as '{}'", id),
                                 .where = "--format",
                                 .remedy = message("use one or more of: {}", known)});
}

}  // namespace furrow
